#include "core/ops/outlook/known_sheets.h"

#include <unordered_set>
#include <vector>

#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/ops/rules/sheets.h"

namespace ryosen {

namespace {

constexpr std::size_t largest_sheet = 1000;

bool touches_others(const Mesh& m, const std::vector<Face>& sheet) {
  const std::unordered_set<Face> own(sheet.begin(), sheet.end());
  bool touches = false;
  for (Face f : sheet) {
    for (Vertex v : vertices_around(m, f))
      for_each_copy(m, v, [&](Vertex copy) {
        for (Face other : faces_around(m, copy)) touches = touches || (other && !own.contains(other));
      });
    if (touches) return true;
  }
  return false;
}

}  // namespace

std::uint32_t KnownSheets::key(const Mesh& mesh, Face f) {
  if (const auto known = keys_.find(f); known != keys_.end()) return known->second;
  const auto is_on_large = [&](Face other) {
    const auto known = keys_.find(other);
    return known != keys_.end() && known->second == large;
  };
  const std::vector<Face> sheet = faces_of_sheet(mesh, f, largest_sheet, is_on_large);
  if (sheet.size() >= largest_sheet || is_on_large(sheet.back())) {
    for (Face other : sheet) keys_[other] = large;
  } else {
    const bool touches = touches_others(mesh, sheet);
    for (Face other : sheet) keys_[other] = touches ? f.index : other.index;
  }
  return keys_[f];
}

}  // namespace ryosen
