#include "ryosen/algo/repair/cut_ears.h"

#include <glm/geometric.hpp>
#include <queue>

#include "ryosen/geometry/predicates.h"

namespace ryosen {

namespace {

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
    if (is_flat(last_[at_], at_, next_[at_])) return {{}, NoTriangles::without_area};
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
  bool is_flat(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return are_collinear(place(a), place(b), place(c));
  }

  glm::dvec3 normal_at(std::uint32_t i) const {
    const glm::dvec3 n = glm::cross(place(i) - place(last_[i]), place(next_[i]) - place(i));
    const double length = glm::length(n);
    return length > 0 ? n / length : glm::dvec3(0.0);
  }

  void look_at(std::uint32_t i) {
    const std::uint32_t before = last_[i], after = next_[i];
    ++version_[i];
    if (is_flat(before, i, after)) {
      cause_ = NoTriangles::without_area;
    } else if (!loop_.may_join(before, after)) {
      cause_ = NoTriangles::edge_exists;
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
  NoTriangles cause_ = NoTriangles::without_area;
};

}  // namespace

HoleTriangles cut_ears(const HoleLoop& loop, Progress& progress) { return EarCutter(loop).run(progress); }

}  // namespace ryosen
