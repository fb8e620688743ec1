#include "ryosen/ops/preview/known_sheets.h"

#include <unordered_set>
#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

namespace {

constexpr std::size_t largest_sheet = 1000;

bool touches_others(const Mesh& m, const std::vector<Face>& sheet) {
  const std::unordered_set<Face> own(sheet.begin(), sheet.end());
  const auto touches = [&](Vertex copy) {
    for (Face other : faces_around(m, copy))
      if (other && !own.contains(other)) return true;
    return false;
  };
  for (Face f : sheet)
    for (Vertex v : vertices_around(m, f))
      if (any_of_copies(m, v, touches)) return true;
  return false;
}

}  // namespace

std::uint32_t KnownSheets::key(const Mesh& mesh, Face f) {
  const Sheet& sheet = find(mesh, f);
  return sheet.number == large || sheet.touches ? sheet.number : f.index;
}

const KnownSheets::Sheet& KnownSheets::find(const Mesh& mesh, Face f) {
  if (const auto known = sheets_.find(f); known != sheets_.end()) return known->second;
  const auto is_on_large = [&](Face other) {
    const auto known = sheets_.find(other);
    return known != sheets_.end() && known->second.number == large;
  };
  const std::vector<Face> sheet = faces_of_sheet(mesh, f, largest_sheet, is_on_large);
  if (sheet.size() >= largest_sheet || is_on_large(sheet.back())) {
    for (Face other : sheet) sheets_[other] = {large, true};
  } else {
    const bool touches = touches_others(mesh, sheet);
    for (Face other : sheet) sheets_[other] = {f.index, touches};
  }
  return sheets_[f];
}

}  // namespace ryosen
