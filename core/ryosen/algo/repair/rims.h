// The rims of holes, and the kinds of patches that they get.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ryosen/algo/repair/equal_rims.h"
#include "ryosen/algo/repair/find_holes.h"
#include "ryosen/algo/repair/plan_patch.h"

namespace ryosen {

// Places and planes of the rims to be tried, by hole.
struct Rims {
  std::vector<std::vector<glm::dvec3>> places;
  std::vector<std::optional<RimPlane>> planes;  // in which the rims lie, whatever the shape
  std::vector<PatchStyle> styles;
  std::vector<std::optional<EqualRim>> equal;
  std::vector<bool> is_like;  // whether other rims equal it
};

// `shape` is one of auto, flat, fair. `holds_floats` says whether the file has coordinates of type float
// (AlgorithmInput); where nothing is known the numbers are judged.
Rims read_rims(const Mesh& mesh, std::span<const Hole> holes, std::string_view shape, std::optional<bool> holds_floats);

}  // namespace ryosen
