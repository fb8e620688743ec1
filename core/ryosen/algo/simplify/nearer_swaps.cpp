#include "ryosen/algo/simplify/nearer_swaps.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "ryosen/ops/swap_edge.h"

namespace ryosen {

namespace {

constexpr int most_rounds = 6;
// A swap gains at least such a share of the sum, so that rounding does not swap an edge to and fro.
constexpr double least_gain = 1e-6;

// How far both surfaces lie from each other about each edge, and what a swap would make of it. An integral over a face
// of the surface before is taken from its corners and its middle, one over a face of now from the middles of its sides;
// both are exact for polynomials of degree two.
class NearerSwaps {
 public:
  NearerSwaps(Edit& edit, const CollapseSurface& surface, NearSamples& samples, const TriangleTree& input,
              DistanceGuard* guard)
      : edit_(edit),
        mesh_(edit.mesh()),
        surface_(surface),
        samples_(samples),
        input_(input),
        guard_(guard),
        square_at_middle_(mesh_.edge_slots(), unknown) {}

  // Whether it was swapped.
  bool try_edge(Edge e) {
    const Halfedge h = halfedge(e), o = twin(h);
    if (!surface_.may_swap(h)) return false;
    const Quad quad{mesh_.from(h), mesh_.to(h), mesh_.from(mesh_.prev(h)), mesh_.from(mesh_.prev(o))};
    if (!comes_nearer(h, quad) || surface_.swap_spoils_face(h) || !SwapEdge{h}.is_legal(mesh_)) return false;
    if (guard_) {
      if (guard_->swap_may_exceed(h)) return false;
      guard_->follow();
    }
    swap(h, quad);
    return true;
  }
  // The sides of both faces of an edge.
  template <class Visit>
  void for_each_side(Edge e, Visit visit) const {
    for (unsigned side : {0u, 1u})
      for (Halfedge h : {mesh_.next(halfedge(e, side)), mesh_.prev(halfedge(e, side))}) visit(edge(h));
  }

 private:
  static constexpr double unknown = -1;
  // Two triangles about an edge, a b c and b a d, and those about the other diagonal.
  struct Quad {
    Vertex a, b, c, d;
  };

  using Triangle = std::array<glm::dvec3, 3>;
  Triangle triangle(Vertex a, Vertex b, Vertex c) const {
    return {surface_.place(a), surface_.place(b), surface_.place(c)};
  }
  double area(Vertex a, Vertex b, Vertex c) const {
    const glm::dvec3& p = surface_.place(a);
    return glm::length(glm::cross(surface_.place(b) - p, surface_.place(c) - p)) / 2;
  }
  // Of the place in the middle of two from the surface before.
  double square_between(Vertex a, Vertex b) const {
    const glm::dvec3 middle = (surface_.place(a) + surface_.place(b)) / 2.0;
    if (input_.is_empty() || !is_finite(middle)) return 0;
    const double distance = input_.nearest(middle).distance;
    return distance * distance;
  }
  double square_at_middle(Halfedge h) {
    double& square = square_at_middle_[edge(h).index];
    if (square == unknown) square = square_between(mesh_.from(h), mesh_.to(h));
    return square;
  }
  // Whether the edge of two faces, swapped, makes both surfaces come nearer to each other.
  bool comes_nearer(Halfedge h, const Quad& quad) {
    const auto [a, b, c, d] = quad;
    const Triangle was_left = triangle(a, b, c), was_right = triangle(b, a, d);
    const Triangle new_a = triangle(c, a, d), new_b = triangle(d, b, c);
    double was = 0, is = 0;
    for (Halfedge side : {h, twin(h)})
      samples_.for_each(mesh_.face(side), [&](std::uint32_t s) {
        const auto [place, share] = samples_.sample(s);
        was += share * std::min(square_from_triangle(was_left, place), square_from_triangle(was_right, place));
        is += share * std::min(square_from_triangle(new_a, place), square_from_triangle(new_b, place));
      });
    const double left = area(a, b, c) / 3, right = area(b, a, d) / 3, at_a = area(c, a, d) / 3,
                 at_b = area(d, b, c) / 3;
    const double bc = square_at_middle(mesh_.next(h)), ca = square_at_middle(mesh_.prev(h));
    const double ad = square_at_middle(mesh_.next(twin(h))), db = square_at_middle(mesh_.prev(twin(h)));
    was += left * (bc + ca) + right * (ad + db) + (left + right) * square_at_middle(h);
    is += at_a * (ca + ad) + at_b * (bc + db);
    const double wanted = was * (1 - least_gain);
    return is < wanted && is + (at_a + at_b) * square_between(c, d) < wanted;
  }
  void swap(Halfedge h, const Quad& quad) {
    const auto [a, b, c, d] = quad;
    std::vector<std::uint32_t> samples;
    for (Face f : {mesh_.face(h), mesh_.face(twin(h))}) samples_.take(f, samples);
    SwapEdge{h}.apply(edit_);
    square_at_middle_[edge(h).index] = unknown;
    const bool is_first = mesh_.from(mesh_.prev(h)) == a;
    const Face with_a = mesh_.face(is_first ? h : twin(h)), with_b = mesh_.face(is_first ? twin(h) : h);
    const Triangle new_a = triangle(c, a, d), new_b = triangle(d, b, c);
    for (const std::uint32_t s : samples) {
      const glm::dvec3 place = samples_.sample(s).place;
      samples_.give(square_from_triangle(new_a, place) <= square_from_triangle(new_b, place) ? with_a : with_b, s);
    }
  }

  Edit& edit_;
  const Mesh& mesh_;
  const CollapseSurface& surface_;
  NearSamples& samples_;
  const TriangleTree& input_;
  DistanceGuard* guard_;
  std::vector<double> square_at_middle_;  // by edge, or unknown
};

}  // namespace

std::size_t swap_nearer(Edit& edit, const CollapseSurface& surface, NearSamples& samples, const TriangleTree& input,
                        DistanceGuard* guard, Progress& progress) {
  NearerSwaps swaps(edit, surface, samples, input, guard);
  const Mesh& mesh = edit.mesh();
  std::vector<std::uint8_t> is_asked(mesh.edge_slots(), 1);
  std::size_t swapped = 0, swapped_before = 0;
  for (int round = 0; round < most_rounds; ++round) {
    swapped_before = swapped;
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
      if (i % 1024 == 0 && !progress.go_on()) return swapped;
      const Edge e(i);
      if (!mesh.is_alive(e) || !std::exchange(is_asked[i], std::uint8_t{0}) || !swaps.try_edge(e)) continue;
      swaps.for_each_side(e, [&](Edge side) { is_asked[side.index] = 1; });
      ++swapped;
    }
    if (swapped == swapped_before) break;
  }
  return swapped;
}

}  // namespace ryosen
