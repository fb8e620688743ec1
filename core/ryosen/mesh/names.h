// Formatting and parsing of element names as used in files, commands and reports.
//
//   v7  f3  12-88 (halfedge or edge)  12-88@f5 (the half of face 5)  ~12-88@f5 (its twin)  v7@f5 (the copy of face 5)
//   h12 e6 (by slot)  v3..v9 (several slots in a row)
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "ryosen/base/element.h"
#include "ryosen/base/message.h"
#include "ryosen/base/result.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The shortest unique name. Edges are named smaller point first, halfedges origin first; the face is added if several
// sheets join the two points.
std::string name_of(const Mesh& mesh, Element element);
// As name_of, but a halfedge by its slot (h12), where 3-7 would mean its edge.
std::string name_to_select(const Mesh& mesh, Element element);
// The name and behind it the slot, where that is another one: 12-88 (h12).
std::string name_and_slot(const Mesh& mesh, Element element);
// By its slot alone: v7 h12 e6 f3, also of a dead element.
std::string slot_name(Element element);
// A name that distinguishes a vertex from the other copies of its point: v7@f5 if it has copies and a face, its own
// number if it has no face.
std::string name_of_copy(const Mesh& mesh, Vertex v);
// An edge named by points and one of its faces: always with @f, except wires (h12).
std::string name_with_face(const Mesh& mesh, Halfedge h);
// The simplest name that find_edge resolves to this halfedge: its points in order, plus the face on either side if
// several sheets join them; never with `~`.
std::string name_to_choose(const Mesh& mesh, Halfedge h);

// The halfedge of a living edge that find_edge gives for the edge's name: from the smaller point.
Halfedge named_side(const Mesh& mesh, Edge e);

enum class NameError { none, malformed, never_existed, ambiguous, deleted };

template <class Handle>
struct Named {
  Handle element;
  NameError error = NameError::none;
  Text sentence;  // names the element and, if ambiguous, the candidates

  bool ok() const { return error == NameError::none; }
};

// The vertex (v7, 7, v7@f5), face (f3) or edge (12-88, 12-88@f5, ~12-88@f5, h12, e6) with this name. An edge is
// returned as the halfedge from the first point to the second. `12-88@f5` may give the points in either order: the
// halfedge then still goes from the first to the second, as the side of face 5 or as its twin. Two live points without
// an edge give never_existed; only the history knows whether there was one (app/editor).
Named<Vertex> find_vertex(const Mesh& mesh, std::string_view name);
Named<Face> find_face(const Mesh& mesh, std::string_view name);
Named<Halfedge> find_edge(const Mesh& mesh, std::string_view name);

// The failure about a name that means no one living element, the same for every command: usage with the code of what is
// wrong with the name, or `refused` where the element is gone.
Failure failure_of_name(NameError error, Text sentence);

// Many elements in few words: by their numbers, several in a row as v3..v9. A word for each, with a blank before it, in
// the order of the elements: vN, eN, fN, hN by slot, and A..B for ascending neighbours.
std::string slot_ranges(std::span<const Element> elements);

struct SlotRange {
  Element first;
  std::uint32_t last;  // not below first.index
};
// Of a word as slot_ranges() writes it for several; none for anything else.
std::optional<SlotRange> parse_slot_range(std::string_view word);
// Those of a range that are alive.
void add_living(const Mesh& mesh, const SlotRange& range, Elements& elements);

}  // namespace ryosen
