// A part of a mesh as a polygon list of its own: what is duplicated, mirrored, or saved alone.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

struct Part {
  IndexedMesh list;
  std::vector<Vertex> points;  // of the mesh, by number in the list
  // Edges without a face in the part, by numbers in the list.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wires;
  std::vector<Edge> wire_edges;  // of the mesh, by place in `wires`
};

// The faces among the elements and those all of whose corners or sides are, and what else is there: edges that none of
// these faces has, and vertices. The pools of the list are those of the mesh. Cost: O(mesh).
Part part_of(const Mesh& mesh, std::span<const Element> elements, const FileTables& tables = {});
// Everything that is alive.
std::vector<Element> all_elements(const Mesh& mesh);

// Of what was added, all are new.
struct AddedPart {
  Vertex first;  // of the points of the list, the others follow in its order
  ElementCounts counts;
  std::size_t left_wires = 0;  // that their ends have no gap for
};
// Adds a part as components of their own. Attributes of the same name and type come along; with `keeps_attributes` the
// part is of this mesh, and so do indices into pools and tables of names.
AddedPart add_part(Edit& edit, Part part, bool keeps_attributes);

}  // namespace ryosen
