// Weld: merges two vertices, or two boundary edges.
//
//      o--a   b--o          o----a----o
//      |   ' '   |    =>    |    |    |        a - x - b is a gap of two edges: they become one edge
//      o----x----o          o----x----o
//
// polygon list: b is replaced by a. For edges A-B and C-D: the ends are replaced so that the two faces traverse the
//               edge in opposite directions. The lower number stays; the position is that of A, or of A-B, with `mid`
//               halfway to what is merged into it, or the one that is given. Attributes are united there.
// needs: no face contains both vertices; edges from both to the same point have one face in each direction. Edges: one
//        face each. No duplicate faces result. Two copies of one point: both have a gap, and no common neighbour.
// changes: V - 1 (2 for edges without a common end), E - the pairs of edges that are merged, on points; F stays.
// inverse: separate_fans and detach.
#pragma once

#include <memory>

#include "ryosen/ops/op.h"

namespace ryosen {

// The vertices of the selected elements, in their order, each once.
std::vector<Element> vertices_of_elements(const Mesh& mesh, std::span<const Element> selected);
inline constexpr InPlaceOf all_their_vertices{vertices_of_elements, "faces, for all of their vertices",
                                              "面（その頂点すべて）"};

struct ManifoldPoint;
// Each costs what is near the vertex that is welded into the last, not what has come together there.
std::unique_ptr<OpSeries> welds_in_series(Edit& edit);

struct Weld {
  enum class Place { first, middle, point };

  Vertex a, b;             // two vertices
  Halfedge first, second;  // or two edges
  Place place = Place::first;
  glm::dvec3 target{};  // for Place::point, which edges do not know: there it is as `first`

  static const OpInfo info;

  static Weld at(const Mesh&, const OpTarget&) { return {}; }

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const Weld&) const = default;
  // The same where the point of `a` may be known from the call before (rules/sheets.h), and is known for the next one.
  OpEffect apply(Edit& edit, ManifoldPoint& known) const;
};

}  // namespace ryosen
