// The verdicts of one operator on all edges of a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "core/ops/all.h"

namespace ryosen {

enum class EdgeVerdict : std::uint8_t { none, legal, refused };

// One entry per edge slot: whether a click on the middle of the edge is legal; `none` for dead edges, and for all of them
// where the operator is not for edges (OpTargetKind::edge). Cost: that of the checks, each subject (op.h) once; on a mesh of
// triangles 0.2 to 0.5 microseconds an edge.
std::vector<EdgeVerdict> edge_verdicts(const Mesh& mesh, const OpInfo& op);

}  // namespace ryosen
