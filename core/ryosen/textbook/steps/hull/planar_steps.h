// The steps of the hull in a plane: one face, whose half-edges are what points see.
#pragma once

#include "ryosen/hull/affine_basis.h"
#include "ryosen/textbook/steps/hull/step_builder.h"

namespace ryosen::hull {

class PlanarSteps : public StepBuilder {
 public:
  PlanarSteps(std::span<const glm::dvec3> points, HullOrder order, std::vector<Index> numbers,
              const FirstPoints& first);
  std::unique_ptr<StepBuilder> copy() const override;

 private:
  void begin() override;
  void extend(Index p, Index seen) override;
  Index new_element_of(Index p) const override;
  void tell_why_not(Index p) override;
  bool sees(Index p, Index half_edge) const override { return turn(half_edge, p) < 0; }
  double distance(Index half_edge, Index p) const override;
  FacetList facets() const override;

  // +1 where p is left of the half-edge, as the inside is, seen from where the facet is counter-clockwise.
  int turn(Index half_edge, Index p) const;
  // The half-edge from a to b within the face, and its twin, which has none.
  Index add_edge(Index a, Index b);
  // Within the face and, the other way round, outside of it.
  void join_both(Index h, Index k);
  // Whether this half-edge, which was made, and the one that stays lie on one line.
  void note_united(Index made, Index stays);

  SignedAxis up_;
  Index face_ = no_index;
};

}  // namespace ryosen::hull
