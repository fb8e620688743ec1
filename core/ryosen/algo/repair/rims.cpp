#include "ryosen/algo/repair/rims.h"

#include <algorithm>
#include <cmath>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

namespace {

double largest_coordinate(std::span<const glm::dvec3> places) {
  double largest = 0;
  for (const glm::dvec3& p : places)
    if (is_finite(p)) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest;
}

}  // namespace

Rims read_rims(const Mesh& mesh, std::span<const Hole> holes, std::string_view shape,
               std::optional<bool> holds_floats) {
  const double largest = largest_coordinate(mesh.positions());
  const bool has_floats = holds_floats.value_or(true) && are_all_floats(mesh.positions());
  Rims rims{std::vector<std::vector<glm::dvec3>>(holes.size()),
            std::vector<std::optional<RimPlane>>(holes.size()),
            std::vector<PatchStyle>(holes.size()),
            {},
            std::vector<bool>(holes.size(), false)};
  for (std::uint32_t i = 0; i < holes.size(); ++i) {
    if (holes[i].cause != WhyOpen::untried) continue;
    for (Halfedge h : loop(mesh, holes[i].start)) rims.places[i].push_back(mesh.position(mesh.from(h)));
    rims.planes[i] = RimPlane::of(rims.places[i], largest, holds_floats);
    PatchStyle& style = rims.styles[i];
    style.snaps_to_floats = has_floats;
    if (shape != "fair") style.plane = rims.planes[i];
    style.fairs = shape == "fair" || (shape == "auto" && !style.plane);
  }
  rims.equal = find_equal_rims(rims.places, largest * (holds_floats.value_or(has_floats) ? 0x1p-21 : 0x1p-50));
  for (const auto& equal : rims.equal)
    if (equal) rims.is_like[equal->as] = true;
  return rims;
}

}  // namespace ryosen
