// What is in the way of merging points: the polygon list after a weld, around the points that are merged.
//
//      o--a   b--o         of each pair the point where less begins is walked around, and the other one is asked about
//      |   ' '   |         what is found there: welding many vertices into one, one after another, costs what is near
//      o----x----o         each of them, not what has come together at the one
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ryosen/base/verdict.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Points that are removed, each with the one it is merged into.
using WeldPairs = std::vector<std::pair<Vertex, Vertex>>;

// Refuses what breaks the list: a face with both points of a pair, edges that become one without being the two sides of
// a gap, and faces that come to be on the same points. At most two pairs, of four different points. `looks` is added
// the halfedges and corners that were looked at around the smaller points.
void judge_weld(const Mesh& mesh, const WeldPairs& pairs, Verdict& verdict, std::uint64_t* looks = nullptr);
// The first rule that it refuses by. Cost: no more than that, and where a face has both points of a pair, what is met
// around the smaller point before it.
std::optional<Rule> first_rule_of_weld(const Mesh& mesh, const WeldPairs& pairs);
// Whether a face has both points of a pair, which it refuses by before all else. Cost: what is around the smaller
// point.
bool have_common_face(const Mesh& mesh, const WeldPairs::value_type& pair);

}  // namespace ryosen
