// The ways in which an edge collapses here: what one collapse costs.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "ryosen/mesh/mesh.h"

namespace ryosen::forms {

struct CollapseFigures {
  double count = 0;    // of links followed, list entries compared, or cells written; the mean
  double seconds = 0;  // the least: other load only makes it slower
};

struct CollapseWay {
  std::string_view id, en, ja;
  // Over several edges that may collapse; none where the mesh has none, or the form cannot hold it.
  std::optional<CollapseFigures> (*measure)(const Mesh& mesh);
};
// Text 000's listing with its lists of vertices and faces, the same with arrays in their place, and the kernel.
std::span<const CollapseWay> collapse_ways();

}  // namespace ryosen::forms
