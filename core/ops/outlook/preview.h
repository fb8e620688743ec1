// What an operator would do, without doing it: the verdict before the click and the ghost of the result.
#pragma once

#include <vector>

#include "core/ops/all.h"
#include "core/ops/outlook/ghost_face.h"

namespace ryosen {

struct Preview {
  Verdict verdict;
  std::vector<Reason> warnings;  // only for a legal one
  std::vector<GhostFace> faces;  // empty when refused, or beyond the limit
  std::vector<Element> created;
  std::vector<Element> deleted;
  bool outline_only = false;  // more than the limit changes; faces was not filled
};

// Checks the operator and, where it is legal, runs it in an Edit that rolls back: the mesh is byte-equal afterwards and
// the redo list untouched. Cost: that of the operator and of the faces it changes.
Preview preview(Mesh& mesh, Journal& journal, const AnyOp& op, std::size_t face_limit = 10000);

}  // namespace ryosen
