#include "ryosen/hull/solid_hull.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>

#include "ryosen/base/handle.h"
#include "ryosen/hull/face_plane.h"
#include "ryosen/hull/fan_sectors.h"
#include "ryosen/hull/insertion_order.h"

namespace ryosen::hull {

namespace {

using Index = std::uint32_t;

struct Face {
  FacePlane plane;
  std::array<Index, 3> corners;
  std::array<Index, 3> beside;
  Index first_outside;  // the list of points that are assigned to it, all of which see it
  Index farthest;
  double farthest_height;
  Index mark;  // the round in which it was seen, or dead_mark
};

constexpr Index dead_mark = no_index;

// An edge between a seen face and one that is not.
struct HorizonEdge {
  Index from, to;  // as the seen face has them
  Index face;      // the other one
  Index side;      // its place there
};

class Builder {
 public:
  Builder(std::span<const glm::dvec3> points, Progress& progress)
      : points_(points), progress_(progress), next_(points.size(), no_index) {
    reach_ = reach_of(points);
    most_work_ = points.size() * (8 + 4 * static_cast<std::size_t>(std::bit_width(points.size())));
  }

  std::vector<HullTriangle> build(const std::array<Index, 4>& basis) {
    make_tetrahedron(basis);
    while (!waiting_.empty() && work_ < most_work_) {
      const Index f = waiting_.back();
      waiting_.pop_back();
      if (faces_[f].mark == dead_mark || faces_[f].first_outside == no_index) continue;
      if (!insert(faces_[f].farthest, f)) return {};
    }
    if (!insert_by_chance()) return {};
    return triangles();
  }

 private:
  Index add_face(Index a, Index b, Index c) {
    Index f = static_cast<Index>(faces_.size());
    if (free_.empty()) {
      faces_.emplace_back();
    } else {
      f = free_.back();
      free_.pop_back();
    }
    faces_[f] = {face_plane(points_[a], points_[b], points_[c], reach_),
                 {a, b, c},
                 {},
                 no_index,
                 no_index,
                 -std::numeric_limits<double>::infinity(),
                 0};
    return f;
  }

  bool sees(const glm::dvec3& p, const Face& face, double height) const {
    return side(face.plane, height, points_[face.corners[0]], points_[face.corners[1]], points_[face.corners[2]], p) >
           0;
  }
  bool sees(const glm::dvec3& p, const Face& face) const { return sees(p, face, face.plane.height(p)); }

  void make_tetrahedron(std::array<Index, 4> b) {
    if (orient3d(points_[b[0]], points_[b[1]], points_[b[2]], points_[b[3]]) > 0) std::swap(b[1], b[2]);
    new_faces_ = {add_face(b[0], b[1], b[2]), add_face(b[1], b[0], b[3]), add_face(b[2], b[1], b[3]),
                  add_face(b[0], b[2], b[3])};
    faces_[new_faces_[0]].beside = {new_faces_[1], new_faces_[2], new_faces_[3]};
    faces_[new_faces_[1]].beside = {new_faces_[0], new_faces_[3], new_faces_[2]};
    faces_[new_faces_[2]].beside = {new_faces_[0], new_faces_[1], new_faces_[3]};
    faces_[new_faces_[3]].beside = {new_faces_[0], new_faces_[2], new_faces_[1]};
    inside_.emplace(std::array{points_[b[0]], points_[b[1]], points_[b[2]], points_[b[3]]});
    for (Index i = 0; i < points_.size(); ++i) {
      if (i == b[0] || i == b[1] || i == b[2] || i == b[3]) continue;
      ++outside_;
      assign_to_any(i);
    }
    for (const Index f : new_faces_) wait_for(f);
  }

  // What is left, in random order: so that a point is handed on O(log n) times, which the farthest first does not
  // promise.
  bool insert_by_chance() {
    face_of_.assign(points_.size(), no_index);
    std::vector<Index> left;
    for (Index f = 0; f < faces_.size(); ++f)
      for (Index i = faces_[f].mark == dead_mark ? no_index : faces_[f].first_outside; i != no_index; i = next_[i]) {
        face_of_[i] = f;
        left.push_back(i);
      }
    std::sort(left.begin(), left.end());
    for (const Index k : shuffled_numbers(static_cast<Index>(left.size()), 1))
      if (face_of_[left[k]] != no_index && !insert(left[k], face_of_[left[k]])) return false;
    return true;
  }

  void wait_for(Index f) {
    if (faces_[f].first_outside != no_index) waiting_.push_back(f);
  }

  bool assign(Index i, Index f) {
    Face& face = faces_[f];
    const double height = face.plane.height(points_[i]);
    if (!sees(points_[i], face, height)) return false;
    next_[i] = face.first_outside;
    face.first_outside = i;
    if (!face_of_.empty()) face_of_[i] = f;
    if (face.farthest == no_index || height > face.farthest_height) {
      face.farthest = i;
      face.farthest_height = height;
    }
    return true;
  }

  // To the face that took the last one, or the next that it sees; what sees none lies inside and is done with.
  void assign_to_any(Index i) {
    const std::size_t count = new_faces_.size();
    std::size_t k = last_hit_ < count ? last_hit_ : 0;
    for (std::size_t tried = 0; tried < count; ++tried, k = k + 1 < count ? k + 1 : 0)
      if (assign(i, new_faces_[k])) {
        last_hit_ = k;
        return;
      }
    --outside_;
  }

  // The faces that p sees from `start` on, which is one of them, and the edges around them, counter-clockwise: a walk
  // into depth that goes around each face from the edge through which it came.
  void find_horizon(Index p, Index start) {
    ++round_;
    seen_.clear();
    horizon_.clear();
    walk_.clear();
    see(start);
    walk_.push_back({start, 0, 3});
    while (!walk_.empty()) {
      Step& step = walk_.back();
      if (step.left == 0) {
        walk_.pop_back();
        continue;
      }
      const Index f = step.face, k = step.side;
      step.side = (k + 1) % 3;
      --step.left;
      const Index g = faces_[f].beside[k];
      if (faces_[g].mark == round_) continue;
      const Index from = faces_[f].corners[k], to = faces_[f].corners[(k + 1) % 3];
      const Index back = side_from(faces_[g], to);
      if (!sees(points_[p], faces_[g])) {
        horizon_.push_back({from, to, g, back});
        continue;
      }
      see(g);
      walk_.push_back({g, (back + 1) % 3, 2});
    }
  }

  void see(Index f) {
    faces_[f].mark = round_;
    seen_.push_back(f);
  }

  static Index side_from(const Face& face, Index corner) {
    return face.corners[0] == corner ? 0 : face.corners[1] == corner ? 1 : 2;
  }

  // False where it was cancelled.
  bool insert(Index p, Index start) {
    if (++steps_ % 256 == 0 && !progress_.go_on(points_.size() - outside_, points_.size())) return false;
    find_horizon(p, start);
    work_ += horizon_.size();
    new_faces_.clear();
    for (const HorizonEdge& edge : horizon_) {
      const Index f = add_face(edge.from, edge.to, p);
      faces_[f].beside[0] = edge.face;
      faces_[edge.face].beside[edge.side] = f;
      new_faces_.push_back(f);
    }
    for (std::size_t k = 0, count = new_faces_.size(); k < count; ++k) {
      const std::size_t after = k + 1 < count ? k + 1 : 0;
      faces_[new_faces_[k]].beside[1] = new_faces_[after];
      faces_[new_faces_[after]].beside[2] = new_faces_[k];
    }
    hand_on(p);
    for (const Index f : seen_) {
      faces_[f].mark = dead_mark;
      free_.push_back(f);
    }
    for (const Index f : new_faces_) wait_for(f);
    return true;
  }

  // A point that saw a face which is gone, and is not inside now, sees a new one.
  void hand_on(Index p) {
    constexpr std::size_t few_faces = 24;
    std::optional<FanSectors> sectors;
    if (new_faces_.size() > few_faces || !face_of_.empty()) {
      horizon_corners_.clear();
      for (const HorizonEdge& edge : horizon_) horizon_corners_.push_back(edge.from);
      sectors.emplace(points_, *inside_, points_[p], horizon_corners_);
    }
    last_hit_ = 0;
    for (const Index f : seen_)
      for (Index i = faces_[f].first_outside, after = no_index; i != no_index; i = after) {
        after = next_[i];
        ++work_;
        if (!face_of_.empty()) face_of_[i] = no_index;
        if (i == p)
          --outside_;
        else if (!sectors)
          assign_to_any(i);
        else if (!assign(i, new_faces_[sectors->sector_of(points_[i])]))
          --outside_;
      }
  }

  std::vector<HullTriangle> triangles() const {
    std::vector<Index> number(faces_.size(), no_index);
    std::vector<HullTriangle> all;
    all.reserve(faces_.size() - free_.size());
    for (Index f = 0; f < faces_.size(); ++f) {
      if (faces_[f].mark == dead_mark) continue;
      number[f] = static_cast<Index>(all.size());
      all.push_back({faces_[f].corners, faces_[f].beside});
    }
    for (HullTriangle& triangle : all)
      for (Index& f : triangle.beside) f = number[f];
    return all;
  }

  struct Step {
    Index face, side, left;  // the edge that is next, and how many are left
  };

  std::span<const glm::dvec3> points_;
  Progress& progress_;
  std::vector<Index> next_;  // in the list of each point
  glm::dvec3 reach_{0.0};
  std::optional<InsidePoint> inside_;
  std::vector<Face> faces_;
  std::vector<Index> free_, waiting_, seen_, new_faces_, horizon_corners_;
  std::vector<HorizonEdge> horizon_;
  std::vector<Step> walk_;
  std::size_t last_hit_ = 0, outside_ = 0, steps_ = 0;
  // Points handed on and faces made; so many where the farthest first is no good order, twice what usual points take.
  std::size_t work_ = 0, most_work_;
  std::vector<Index> face_of_;  // of each point outside, once what is left goes in by chance
  Index round_ = 0;
};

}  // namespace

std::vector<HullTriangle> solid_hull(std::span<const glm::dvec3> points, const std::array<std::uint32_t, 4>& basis,
                                     Progress& progress) {
  return Builder(points, progress).build(basis);
}

}  // namespace ryosen::hull
