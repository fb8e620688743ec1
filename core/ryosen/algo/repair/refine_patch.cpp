#include "ryosen/algo/repair/refine_patch.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_set>

#include "ryosen/geometry/predicates.h"

namespace ryosen {

namespace {

// A patch with the neighbours of its triangles. Side 3 t + k runs from corner k of triangle t to its next corner.
class PatchRefiner {
 public:
  PatchRefiner(HolePatch& patch, const HoleLoop& loop, double most_growth, Progress& progress)
      : patch_(patch),
        loop_(loop),
        progress_(progress),
        // Small holes are as fine as what surrounds them.
        growth_(std::min(most_growth, loop.size() / 1000.0)),
        spacing_(patch.spacing),
        across_(3 * patch.triangles.size(), no_index) {
    if (spacing_.empty()) spacing_ = loop.around.spacing;
    spacing_.resize(patch.places.size(), mean_spacing());
    std::vector<std::pair<std::uint64_t, std::uint32_t>> sides;
    for (std::uint32_t s = 0; s < across_.size(); ++s) sides.emplace_back(edge_of(from(s), to(s)), s);
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i < sides.size(); ++i) {
      edges_.insert(sides[i].first);
      if (i > 0 && sides[i - 1].first == sides[i].first) connect(sides[i - 1].second, sides[i].second);
    }
  }

  void divide_all() {
    constexpr int most_rounds = 50;
    relax_all();
    for (int round = 0; round < most_rounds && divide() > 0; ++round) relax();
  }

  void even_out_all() {
    constexpr int last_rounds = 6;
    for (int round = 0; round < last_rounds && progress_.go_on(); ++round) {
      relax();
      move_to_middles();
      relax_all();
    }
  }

  void relax_all() {
    for (std::uint32_t s = 0; s < across_.size(); ++s) doubtful_.push_back(s);
    relax();
  }

 private:
  static std::uint64_t edge_of(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32u | std::max(a, b);
  }
  static std::uint32_t next(std::uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static std::uint32_t last(std::uint32_t side) { return side % 3 == 0 ? side + 2 : side - 1; }
  std::uint32_t from(std::uint32_t side) const { return patch_.triangles[side / 3][side % 3]; }
  std::uint32_t to(std::uint32_t side) const { return from(next(side)); }
  std::uint32_t apex(std::uint32_t side) const { return from(last(side)); }
  const glm::dvec3& place(std::uint32_t v) const { return patch_.places[v]; }
  bool are_flat(std::uint32_t a, std::uint32_t b, std::uint32_t c) const { return patch_.is_flat({a, b, c}); }

  double mean_spacing() const {
    double sum = 0;
    for (double length : loop_.around.spacing) sum += length;
    return sum / loop_.size();
  }

  void connect(std::uint32_t side, std::uint32_t other) {
    across_[side] = other;
    if (other != no_index) across_[other] = side;
  }

  std::size_t divide() {
    std::size_t divided = 0;
    const auto count = static_cast<std::uint32_t>(patch_.triangles.size());
    for (std::uint32_t t = 0; t < count && progress_.go_on(); ++t) divided += divide(t);
    return divided;
  }

  bool divide(std::uint32_t t) {
    const CornerTriangle old = patch_.triangles[t];
    const glm::dvec3 middle = place(old[0]) / 3.0 + place(old[1]) / 3.0 + place(old[2]) / 3.0;
    double spacing = 0;
    for (std::uint32_t v : old) spacing += (spacing_[v] + growth_ * glm::distance(middle, place(v))) / 3;
    for (std::uint32_t v : old) {
      const double reach = std::sqrt(2.0) * glm::distance(middle, place(v));
      if (!(reach > spacing) || !(reach > spacing_[v])) return false;
    }
    for (std::size_t k = 0; k < 3; ++k)
      if (are_collinear(place(old[k]), place(old[(k + 1) % 3]), middle)) return false;
    add_vertex(t, middle, spacing);
    return true;
  }

  void add_vertex(std::uint32_t t, const glm::dvec3& middle, double spacing) {
    const CornerTriangle old = patch_.triangles[t];
    const auto v = static_cast<std::uint32_t>(patch_.places.size());
    const std::uint32_t behind = across_[3 * t + 1], before = across_[3 * t + 2];
    const auto second = 3 * static_cast<std::uint32_t>(patch_.triangles.size()), third = second + 3;
    patch_.places.push_back(middle);
    patch_.parents.push_back(old);
    spacing_.push_back(spacing);
    patch_.triangles[t] = {old[0], old[1], v};
    patch_.triangles.push_back({old[1], old[2], v});
    patch_.triangles.push_back({old[2], old[0], v});
    across_.resize(across_.size() + 6, no_index);
    connect(second, behind);
    connect(third, before);
    connect(3 * t + 1, second + 2);
    connect(second + 1, third + 2);
    connect(third + 1, 3 * t + 2);
    for (std::uint32_t corner : old) edges_.insert(edge_of(corner, v));
    for (std::uint32_t side : {3 * t, second, third}) doubtful_.push_back(side);
  }

  // Cotangent of the angle opposite a side, without trigonometry.
  double cotangent_across(std::uint32_t side) const {
    const glm::dvec3 u = place(from(side)) - place(apex(side)), v = place(to(side)) - place(apex(side));
    const double area = glm::length(glm::cross(u, v));
    return area > 0 ? glm::dot(u, v) / area : glm::dot(u, v) < 0 ? -1e9 : 1e9;
  }

  bool may_have_edge(std::uint32_t a, std::uint32_t b) const {
    if (edges_.contains(edge_of(a, b))) return false;
    return a >= patch_.corners || b >= patch_.corners || loop_.may_join(a, b);
  }

  //       a                a
  //     / | \            /   \         side: from a to b, with p on its left; other: from b to a, with q on its left
  //    p  |  q    =>    p --- q
  //     \ | /            \   /
  //       b                b
  //
  // Delaunay criterion: swap if the opposite angles sum to more than 180 degrees (cotangent sum negative).
  bool swap_if_better(std::uint32_t side) {
    const std::uint32_t other = across_[side];
    if (other == no_index || !(cotangent_across(side) + cotangent_across(other) < -1e-9)) return false;
    const std::uint32_t a = from(side), b = to(side), p = apex(side), q = apex(other);
    if (p == q || !may_have_edge(p, q) || are_flat(a, q, p) || are_flat(b, p, q)) return false;
    const std::uint32_t b_to_p = across_[next(side)], p_to_a = across_[last(side)];
    const std::uint32_t a_to_q = across_[next(other)], q_to_b = across_[last(other)];
    const std::uint32_t t = 3 * (side / 3), u = 3 * (other / 3);
    patch_.triangles[side / 3] = {a, q, p};
    patch_.triangles[other / 3] = {b, p, q};
    connect(t, a_to_q);
    connect(t + 2, p_to_a);
    connect(u, b_to_p);
    connect(u + 2, q_to_b);
    connect(t + 1, u + 1);
    edges_.erase(edge_of(a, b));
    edges_.insert(edge_of(p, q));
    for (std::uint32_t s : {t, t + 2, u, u + 2}) doubtful_.push_back(s);
    return true;
  }

  // Moves each new vertex along the patch to the middle of its neighbours, but for those whose triangles this would
  // turn.
  void move_to_middles() {
    const std::size_t n = patch_.places.size();
    std::vector<glm::dvec3> sum(n, glm::dvec3(0.0)), normal(n, glm::dvec3(0.0)), moved = patch_.places;
    std::vector<std::uint32_t> count(n, 0);
    for (std::uint32_t s = 0; s < across_.size(); ++s) {
      sum[from(s)] += place(to(s));
      ++count[from(s)];
      normal[from(s)] += normal_of(s / 3, patch_.places);
    }
    for (std::uint32_t v = patch_.corners; v < n; ++v) {
      const double square = glm::dot(normal[v], normal[v]);
      if (!(square > 0)) continue;
      const glm::dvec3 way = sum[v] / static_cast<double>(count[v]) - place(v);
      moved[v] += way - glm::dot(normal[v], way) / square * normal[v];
    }
    constexpr int most_tries = 10;
    for (int i = 0; i < most_tries; ++i)
      if (!take_back_where_turned(moved)) {
        patch_.places = std::move(moved);
        return;
      }
  }

  glm::dvec3 normal_of(std::uint32_t t, const std::vector<glm::dvec3>& places) const {
    const auto& [a, b, c] = patch_.triangles[t];
    return glm::cross(places[b] - places[a], places[c] - places[a]);
  }

  // Whether there were such triangles.
  bool take_back_where_turned(std::vector<glm::dvec3>& moved) const {
    bool any = false;
    for (std::uint32_t t = 0; t < patch_.triangles.size(); ++t) {
      const glm::dvec3 before = normal_of(t, patch_.places), after = normal_of(t, moved);
      if (glm::dot(before, after) > 0.1 * glm::dot(before, before) || before == after) continue;
      any = true;
      for (const std::uint32_t v : patch_.triangles[t]) moved[v] = place(v);
    }
    return any;
  }

  // Out of a plane the swaps need not come to an end.
  void relax() {
    std::size_t swaps_left = 20 * patch_.triangles.size();
    for (std::size_t step = 0; !doubtful_.empty(); ++step) {
      if (step % 1024 == 0 && !progress_.go_on()) return;
      const std::uint32_t side = doubtful_.back();
      doubtful_.pop_back();
      if (swap_if_better(side) && --swaps_left == 0) doubtful_.clear();
    }
  }

  HolePatch& patch_;
  const HoleLoop& loop_;
  Progress& progress_;
  double growth_;
  std::vector<double>& spacing_;
  std::vector<std::uint32_t> across_;        // by side: the same edge in the other triangle; none along the loop
  std::unordered_set<std::uint64_t> edges_;  // of the patch
  std::vector<std::uint32_t> doubtful_;      // sides that are perhaps to be swapped
};

}  // namespace

void refine(HolePatch& patch, const HoleLoop& loop, double most_growth, Progress& progress) {
  PatchRefiner refiner(patch, loop, most_growth, progress);
  refiner.divide_all();
  refiner.even_out_all();
}

void swap_edges(HolePatch& patch, const HoleLoop& loop, Progress& progress) {
  PatchRefiner(patch, loop, 0, progress).relax_all();
}

}  // namespace ryosen
