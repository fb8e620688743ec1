// The steps of the hull in a plane: one face, whose half-edges are what points see.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/geometry/predicates.h"
#include "ryosen/hull/affine_basis.h"
#include "ryosen/textbook/steps/hull/step_builder.h"

namespace ryosen::hull {

namespace {

using Index = std::uint32_t;
using Table = DcelChange::Table;
using Field = DcelChange::Field;

class PlanarSteps : public StepBuilder {
 public:
  PlanarSteps(std::span<const glm::dvec3> points, HullOrder order, std::vector<Index> numbers, const FirstPoints& first)
      : StepBuilder(points, order, std::move(numbers), first),
        up_(largest_normal_axis(points[first.numbers[0]], points[first.numbers[1]], points[first.numbers[2]])) {}
  std::unique_ptr<StepBuilder> copy() const override { return std::make_unique<PlanarSteps>(*this); }

 private:
  void begin() override {
    std::array<Index, 3> corner{first()[0], first()[1], first()[2]};
    if (cross_component_sign(place(corner[0]), place(corner[1]), place(corner[2]), up_.axis) < 0)
      std::swap(corner[1], corner[2]);
    face_ = new_face();
    std::array<Index, 3> h{};
    for (std::size_t k = 0; k < 3; ++k) h[k] = add_edge(corner[k], corner[(k + 1) % 3]);
    for (std::size_t k = 0; k < 3; ++k) join_both(h[k], h[(k + 1) % 3]);
    set(Table::face, face_, Field::outer_component, h[0]);
  }
  // What a point sees is a chain of edges: from the one that is known back to its begin, then to its end.
  void extend(Index p, Index seen) override {
    HullStep& step = this->step();
    Index first = seen;
    const auto prev = [&](Index h) { return records().half_edges[h].prev; };
    while (sees(p, prev(first))) first = prev(first);
    Index last = first;
    step.seen.assign(1, first);
    while (sees(p, next_of(last))) step.seen.push_back(last = next_of(last));
    const Index before = prev(first), behind = next_of(last);
    const Index a = origin(first), b = origin(behind);
    step.horizon = {before, behind};
    for (const Index h : step.seen) {
      const Index outside = twin(h);
      remove_half_edge(outside);
      remove_half_edge(h);
    }
    const Index to = add_edge(a, p), from = add_edge(p, b);
    join_both(before, to);
    join_both(to, from);
    join_both(from, behind);
    if (origin(records().faces[face_].outer_component) == no_index) set(Table::face, face_, Field::outer_component, to);
    note_united(to, before);
    note_united(from, behind);
  }
  // It saw an edge that is gone, so the begin or the end of the chain is on its side of the new corner.
  Index new_element_of(Index p) const override {
    for (const Index h : step().made)
      if (sees(p, h)) return h;
    return no_index;
  }
  void tell_why_not(Index p) override {
    HullStep& step = this->step();
    const Index first = records().faces[face_].outer_component;
    Index h = first;
    do {
      if (place(origin(h)) == place(p)) {
        step.kind = HullStep::Kind::equal;
        step.witness = origin(h);
        return;
      }
      if (step.kind == HullStep::Kind::inside && turn(h, p) == 0) {
        step.kind = HullStep::Kind::on_face;
        step.witness = h;
      }
      h = next_of(h);
    } while (h != first);
  }
  bool sees(Index p, Index half_edge) const override { return turn(half_edge, p) < 0; }
  double distance(Index half_edge, Index p) const override {
    const glm::dvec3 a = place(origin(half_edge)), along = place(origin(next_of(half_edge))) - a;
    const double height = glm::length(glm::cross(along, place(p) - a)) / glm::length(along);
    return std::isfinite(height) ? height : 0;
  }
  FacetList facets() const override {
    std::vector<Index> corners;
    const Index first = records().faces[face_].outer_component;
    Index h = first;
    do corners.push_back(origin(h));
    while ((h = next_of(h)) != first);
    FacetList list;
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i)
      if (!are_collinear(place(corners[(i + count - 1) % count]), place(corners[i]), place(corners[(i + 1) % count])))
        list.corners.push_back(corners[i]);
    list.offsets.push_back(static_cast<Index>(list.corners.size()));
    return list;
  }

  // +1 where p is left of the half-edge, as the inside is, seen from where the facet is counter-clockwise.
  int turn(Index half_edge, Index p) const {
    return cross_component_sign(place(origin(half_edge)), place(origin(next_of(half_edge))), place(p), up_.axis);
  }
  // The half-edge from a to b within the face, and its twin, which has none.
  Index add_edge(Index a, Index b) {
    const Index h = new_half_edge(), outside = new_half_edge();
    set_half_edge(h, Field::origin, a);
    set_half_edge(outside, Field::origin, b);
    pair(h, outside);
    set_half_edge(h, Field::face, face_);
    set(Table::vertex, b, Field::incident_edge, outside);  // as the kernel: a vertex at a gap leads into it
    note_made(h);
    return h;
  }
  // Within the face and, the other way round, outside of it.
  void join_both(Index h, Index k) {
    join(h, k);
    join(twin(k), twin(h));
  }
  // Whether this half-edge, which was made, and the one that stays lie on one line.
  void note_united(Index made, Index stays) {
    const Index far = origin(stays) == origin(made) || origin(stays) == origin(next_of(made)) ? origin(next_of(stays))
                                                                                              : origin(stays);
    if (turn(made, far) == 0) step().united.emplace_back(made, stays);
  }

  SignedAxis up_;
  Index face_ = no_index;
};

}  // namespace

std::unique_ptr<StepBuilder> planar_steps(std::span<const glm::dvec3> points, HullOrder order,
                                          std::vector<std::uint32_t> numbers, const FirstPoints& first) {
  return std::make_unique<PlanarSteps>(points, order, std::move(numbers), first);
}

}  // namespace ryosen::hull
