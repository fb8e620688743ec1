// Features of a surface, which algorithms keep as they are: ends of wires and of several fans, lines between other
// values of faces, and edges on which several sheets lie.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Whether a wire ends at a vertex, or several fans do. Cost: its valence.
bool ends_a_wire_or_fan(const Mesh& mesh, Vertex v);

// Whether two faces differ in a name (material, group, object, smoothing group). Other attributes make no border.
inline bool face_values_differ(const Mesh& mesh, Face a, Face b) {
  using namespace attribute_names;
  for (const std::string_view name : {material, group, object, smoothing})
    if (const AttributeColumn* const column = find_column(mesh, name);
        column && column->data[a.index] != column->data[b.index])
      return true;
  return false;
}

// The edges that lie on one non-manifold or misoriented edge of points, group after group; `ends` holds one past the
// last of each. Empty on a mesh without copies. O(edges at copies), sorted.
struct SheetGroups {
  std::vector<Edge> edges;
  std::vector<std::uint32_t> ends;

  // Calls visit(its edges) for each.
  template <class Visit>
  void for_each(const Visit& visit) const {
    std::uint32_t begin = 0;
    for (const std::uint32_t end : ends) {
      visit(std::span(edges).subspan(begin, end - begin));
      begin = end;
    }
  }
};
SheetGroups sheet_groups(const Mesh& mesh);

}  // namespace ryosen
