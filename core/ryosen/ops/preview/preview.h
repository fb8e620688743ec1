// Preview of an operator: its verdict, and the resulting faces to draw as a ghost.
#pragma once

#include <vector>

#include "ryosen/ops/all.h"
#include "ryosen/ops/preview/shape_warnings.h"

namespace ryosen {

struct Preview {
  Verdict verdict;
  // Only if legal. Over the limit only those of the operator itself. Intersecting faces are searched up to the limit of
  // crossings_near.
  std::vector<Reason> warnings;
  std::vector<GhostFace> faces;  // empty if refused or over the limit
  std::vector<Element> created;
  std::vector<Element> deleted;
  bool outline_only = false;  // over the limit: `faces` was not filled
};

// Checks the operator and, if legal, runs it in an Edit that is rolled back: the mesh is byte-equal afterwards and the
// redo list untouched. What fills a cycle (Subject::cycle) is shown from its lowest halfedge, whichever was asked
// about, so that each of its edges shows the same. Cost: the operator and the faces it changes.
Preview preview(Mesh& mesh, Journal& journal, const AnyOp& op, std::size_t face_limit = 10000);

}  // namespace ryosen
