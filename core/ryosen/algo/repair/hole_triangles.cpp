#include "ryosen/algo/repair/hole_triangles.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <queue>

namespace ryosen {

namespace {

// The cost of a triangulation: first its largest dihedral fold, then its area.
struct Weight {
  double fold = 0;  // 1 - cos of the angle between normals, 0 to 2
  double area = 0;

  Weight operator+(const Weight& w) const { return {std::max(fold, w.fold), area + w.area}; }
  bool operator<(const Weight& w) const { return fold != w.fold ? fold < w.fold : area < w.area; }
};

constexpr Weight impossible{std::numeric_limits<double>::infinity(), 0};

// Dynamic programming over the optimal triangulations of all sub-polygons from corner i to k, closed by the chord i-k.
class HoleWeights {
 public:
  HoleWeights(const HoleLoop& loop, bool joins_all, Progress& progress)
      : loop_(loop), joins_all_(joins_all), n_(loop.size()), parts_(std::size_t{n_} * n_) {
    for (std::uint32_t length = 2; length < n_; ++length)
      for (std::uint32_t i = 0; i + length < n_ && progress.go_on(); ++i) weigh(i, i + length);
    if (progress.is_cancelled()) parts_[n_ - 1].weight = impossible;
  }

  std::vector<CornerTriangle> best() const {
    if (!(part(0, n_ - 1).weight < impossible)) return {};
    std::vector<CornerTriangle> triangles;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{0, n_ - 1}};
    while (!open.empty()) {
      const auto [i, k] = open.back();
      open.pop_back();
      if (k - i < 2) continue;
      const std::uint32_t m = part(i, k).middle;
      triangles.push_back({i, m, k});
      open.push_back({i, m});
      open.push_back({m, k});
    }
    return triangles;
  }

 private:
  struct Part {
    Weight weight;
    glm::dvec3 normal{0.0};  // of the triangle adjacent to the chord
    std::uint32_t middle = 0;
  };

  const Part& part(std::uint32_t i, std::uint32_t k) const { return parts_[i * n_ + k]; }

  // The fold between a triangle and its neighbour across the side from i to k.
  double fold(const glm::dvec3& normal, std::uint32_t i, std::uint32_t k) const {
    const bool is_side = k == i + 1 || (i == 0 && k == n_ - 1);
    const glm::dvec3& beyond = k == i + 1 ? loop_.normals[i] : is_side ? loop_.normals[n_ - 1] : part(i, k).normal;
    // The face beyond the loop may be unknown.
    if (is_side && beyond == glm::dvec3(0.0)) return 0;
    return 1 - glm::dot(normal, beyond);
  }

  void weigh(std::uint32_t i, std::uint32_t k) {
    Part& result = parts_[i * n_ + k];
    result.weight = impossible;
    const bool is_whole = i == 0 && k == n_ - 1;
    if (!is_whole && !joins_all_ && !loop_.may_join(i, k)) return;
    for (std::uint32_t m = i + 1; m < k; ++m) {
      const Weight sides = part(i, m).weight + part(m, k).weight;
      if (!(sides < result.weight) || loop_.is_flat({i, m, k})) continue;
      const glm::dvec3& a = loop_.places[i];
      const glm::dvec3 across = glm::cross(loop_.places[m] - a, loop_.places[k] - a);
      const double length = glm::length(across);
      const glm::dvec3 normal = length > 0 ? across / length : glm::dvec3(0.0);
      Weight own{std::max(fold(normal, i, m), fold(normal, m, k)), length / 2};
      if (is_whole) own.fold = std::max(own.fold, fold(normal, i, k));
      const Weight sum = sides + own;
      if (sum < result.weight) result = {sum, normal, m};
    }
  }

  const HoleLoop& loop_;
  bool joins_all_;  // whatever edges there are
  std::uint32_t n_;
  std::vector<Part> parts_;
};

// Cuts a convex polygon in halves, and these again: no corner gets many triangles.
void halve_convex(std::uint32_t first, std::uint32_t last, std::vector<CornerTriangle>& out) {
  if (last - first < 2) return;
  const std::uint32_t middle = first + (last - first) / 2;
  out.push_back({first, middle, last});
  halve_convex(first, middle, out);
  halve_convex(middle, last, out);
}

// What triangulate() makes of a convex polygon.
bool is_fan(std::span<const CornerTriangle> triangles) {
  return std::all_of(triangles.begin(), triangles.end(), [](const CornerTriangle& t) { return t[0] == 0; });
}

class EarCutter {
 public:
  explicit EarCutter(const HoleLoop& loop) : loop_(loop), normals_(loop.normals), version_(loop.size(), 0) {
    const std::uint32_t n = loop.size();
    for (std::uint32_t i = 0; i < n; ++i) {
      next_.push_back((i + 1) % n);
      last_.push_back((i + n - 1) % n);
    }
    for (std::uint32_t i = 0; i < n; ++i) look_at(i);
  }

  HoleTriangles run(Progress& progress) {
    for (std::uint32_t left = loop_.size(); left > 3; --left) {
      while (!ears_.empty() && ears_.top().version != version_[ears_.top().corner]) ears_.pop();
      if (ears_.empty() || !progress.go_on()) return {{}, cause_};
      cut(ears_.top().corner);
    }
    if (loop_.is_flat({last_[at_], at_, next_[at_]})) return {{}, WhyOpen::without_area};
    triangles_.push_back({last_[at_], at_, next_[at_]});
    return {std::move(triangles_)};
  }

 private:
  struct Ear {
    double cost;
    std::uint32_t corner, version;
    bool operator<(const Ear& e) const { return cost != e.cost ? cost > e.cost : corner > e.corner; }
  };

  const glm::dvec3& place(std::uint32_t i) const { return loop_.places[i]; }

  glm::dvec3 normal_at(std::uint32_t i) const {
    const glm::dvec3 n = glm::cross(place(i) - place(last_[i]), place(next_[i]) - place(i));
    const double length = glm::length(n);
    return length > 0 ? n / length : glm::dvec3(0.0);
  }

  void look_at(std::uint32_t i) {
    const std::uint32_t before = last_[i], after = next_[i];
    ++version_[i];
    if (loop_.is_flat({before, i, after})) {
      cause_ = WhyOpen::without_area;
    } else if (!loop_.may_join(before, after)) {
      cause_ = WhyOpen::edge_exists;
    } else {
      const glm::dvec3 normal = normal_at(i);
      const double fold = 2 - glm::dot(normal, normals_[before]) - glm::dot(normal, normals_[i]);  // 0 to 4
      ears_.push({glm::distance(place(before), place(after)) * (1 + fold), i, version_[i]});
    }
  }

  void cut(std::uint32_t i) {
    const std::uint32_t before = last_[i], after = next_[i];
    triangles_.push_back({before, i, after});
    normals_[before] = normal_at(i);
    ++version_[i];
    next_[before] = after;
    last_[after] = before;
    at_ = after;
    look_at(before);
    look_at(after);
  }

  const HoleLoop& loop_;
  std::vector<glm::dvec3> normals_;         // beyond the side from each corner to the next
  std::vector<std::uint32_t> next_, last_;  // of the corners that are left
  std::vector<std::uint32_t> version_;      // of what was found at a corner
  std::priority_queue<Ear> ears_;
  std::vector<CornerTriangle> triangles_;
  std::uint32_t at_ = 0;  // a corner that is left
  WhyOpen cause_ = WhyOpen::without_area;
};

}  // namespace

HoleTriangles weigh_triangles(const HoleLoop& loop, Progress& progress) {
  HoleTriangles found{HoleWeights(loop, false, progress).best()};
  if (found.triangles.empty() && !HoleWeights(loop, true, progress).best().empty()) found.cause = WhyOpen::edge_exists;
  return found;
}

HoleTriangles project_triangles(const HoleLoop& loop) {
  const std::uint32_t n = loop.size();
  HoleTriangles found;
  triangulate(loop.places, found.triangles);
  if (n > 4 && is_fan(found.triangles)) {
    found.triangles.clear();
    halve_convex(0, n - 1, found.triangles);
  }
  for (const CornerTriangle& t : found.triangles) {
    if (loop.is_flat(t)) return {{}, WhyOpen::without_area};
    if (!loop.allows(t)) return {{}, WhyOpen::edge_exists};
  }
  return found;
}

HoleTriangles cut_ears(const HoleLoop& loop, Progress& progress) { return EarCutter(loop).run(progress); }

}  // namespace ryosen
