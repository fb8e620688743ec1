// The local operators that build up, done on lists of copies.
#pragma once

#include <vector>

#include "tests/support/core/oracle/operators.h"

namespace ryosen::oracle {

// What an operator makes of a list, and by how much it says that the counts change.
struct LocalOutcome {
  CopyList list;
  int vertices = 0, edges = 0, faces = 0;
};
// Empty: the operator has no meaning there. Several: any of them will do.
using LocalOutcomes = std::vector<LocalOutcome>;

LocalOutcomes poke(CopyList copies, int f);
LocalOutcomes extrude(CopyList copies, int f);
LocalOutcomes triangulate(const CopyList& copies, int f);
LocalOutcomes dissolve_edge(const CopyList& copies, int a, int b);
LocalOutcomes dissolve_vertex(const CopyList& copies, int v, const Facts& before);
// m takes the faces at v from the pair v-left counter-clockwise to v-right; -1 means the gap.
LocalOutcomes vertex_split(CopyList copies, int v, int left, int right);

// The rules of a verdict: no new violation, counts as stated, everything else as it was, and the points read back.
bool is_legal(const Facts& before, const LocalOutcome& outcome);

}  // namespace ryosen::oracle
