// Delete: removes faces, with the edges and vertices that nothing else uses.
//
//        o-----o-----o               o-----o
//        |  f  |     |               |     |        delete fN: the face; delete A-B: the faces at the edge, or
//        |     |     |      =>       |     |        the wire; delete vN: the vertex with all faces and wires there
//        o-----o-----o               o-----o
//
// polygon list: the faces are removed, and a wire that is named or has a named end. Vertices that thereby lose their
//               last face or wire are removed; vN in any case.
// needs: a live element. A point means all its copies, an edge all its sheets.
// changes: F - 1 for a face, - its faces for an edge or vertex; E - the edges without another face; V - the vertices
//          that lose their last edge (for a lone triangle 3, 3, 1). H - the rings of the faces. A vertex may be left
//          with several fans. If exactly two faces of opposite direction remain at an edge that had more, they are
//          joined.
// inverse: make_face or fill for one face; undo.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

class Sheets;
// Each costs what is near the faces that go, not all copies of their points.
std::unique_ptr<OpSeries> deletes_in_series(Edit& edit);

struct Delete {
  Element element;  // a vertex, edge or face

  static const OpInfo info;

  static Delete at(const Mesh& mesh, const OpTarget& target);

  Verdict check(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const Delete&) const = default;
};

// The elements to delete explicitly.
struct Deletion {
  std::vector<Face> faces;
  std::vector<Halfedge> wires;
  std::vector<Vertex> vertices;
};

// Deletes them, and edges and vertices that become unused. Cost: the one-rings of the faces' points.
void delete_elements(Edit& edit, Sheets& sheets, const Deletion& deletion);

}  // namespace ryosen
