// Names of elements as files, commands and reports write them, and back.
//
//   v7  f3  12-88 (halfedge or edge)  12-88@f5 (the half of face 5)  ~12-88@f5 (its twin)  v7@f5 (the copy of face 5)
//   h12 e6 (by slot)
#pragma once

#include <string>
#include <string_view>

#include "core/base/element.h"
#include "core/base/message.h"
#include "core/mesh/mesh.h"

namespace ryosen {

// The shortest name that is unique. Edges are named from their smaller point, halfedges from their origin; the face is
// added where several sheets join the two points.
std::string name_of(const Mesh& mesh, Element element);
// A vertex by a name that tells it from the other copies of its point: v7@f5 where it has any and a face, its own number
// where it has no face.
std::string name_of_copy(const Mesh& mesh, Vertex v);
// An edge that is cut on points, named for one of its face sides: always with @f.
std::string name_with_face(const Mesh& mesh, Halfedge h);
// The plainest name that find_edge reads as this halfedge: by its points, the first before the second, and where several
// sheets join them by the face on either side, without `~`.
std::string name_to_choose(const Mesh& mesh, Halfedge h);

enum class NameError { none, malformed, never_existed, ambiguous, deleted };

template <class Handle>
struct Named {
  Handle element;
  NameError error = NameError::none;
  Text sentence;  // names the element and, where it is ambiguous, the candidates

  bool ok() const { return error == NameError::none; }
};

// The vertex (v7, 7, v7@f5), face (f3) or edge (12-88, 12-88@f5, ~12-88@f5, h12, e6) that a text names. An edge comes
// as the halfedge from the first point to the second. `12-88@f5` may name the points in either order: the halfedge then
// still runs from the first to the second, as the side of face 5 or as its twin. An edge whose points live but are not
// joined gives never_existed; the history knows whether it did (app/editor).
Named<Vertex> find_vertex(const Mesh& mesh, std::string_view name);
Named<Face> find_face(const Mesh& mesh, std::string_view name);
Named<Halfedge> find_edge(const Mesh& mesh, std::string_view name);

}  // namespace ryosen
