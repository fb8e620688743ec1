// The steps of the hull in space: faces are triangles.
#pragma once

#include <optional>

#include "ryosen/hull/fan_sectors.h"
#include "ryosen/textbook/steps/hull/step_builder.h"

namespace ryosen::hull {

class SolidSteps : public StepBuilder {
 public:
  using StepBuilder::StepBuilder;
  std::unique_ptr<StepBuilder> copy() const override;

 private:
  void begin() override;
  void extend(Index p, Index seen) override;
  Index new_element_of(Index p) const override;
  void tell_why_not(Index p) override;
  bool sees(Index p, Index face) const override { return side(face, p) > 0; }
  double distance(Index face, Index p) const override;
  FacetList facets() const override;

  // Half-edges from a, b, c in turn; their twins are left to the caller. The half-edge from a.
  Index add_face(Index a, Index b, Index c);
  bool is_there(Index face) const { return records().faces[face].outer_component != no_index; }
  std::array<Index, 3> corners_of(Index face) const;
  int side(Index face, Index p) const;
  void find_horizon(Index p, Index seen);
  void remove_seen();
  void make_faces(Index p);

  std::optional<InsidePoint> inside_;
  std::vector<Index> mark_;             // of each face the round in which it was seen
  std::vector<Index> horizon_corners_;  // of the last step, as the made faces have them
  Index round_ = 0;
};

}  // namespace ryosen::hull
