// What the collapse and the swap of the source texts do, step by step, on the records of table 5.
//
// Their code is written for closed triangle models. On a boundary setHalfedgePair finds no partner and leaves `pair` as
// the constructor of Halfedge does: without a value, not null. Following it is undefined behaviour, and no test for null
// could have found it. Here the same steps are taken with every link looked at before it is followed, so that it can be
// told where they first go astray.
#pragma once

#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/forms/halfedge_table.h"

namespace ryosen::forms {

struct SourceOutcome {
  bool completed = false;
  bool pair_of_edge_missing = false;  // the edge itself is a boundary; otherwise a pair beside it is missing
  bool changed_before = false;        // something had been written when the missing link was met
  Text sentence;                      // what the code does there
};

// The start of the halfedge is removed, its end moves to the midpoint, the triangles on both sides go. Of a table of
// inner halfedges of triangles. Where it stops, the table is left as the code would leave it. Removed vertices and
// faces have no halfedge any more; removed halfedges have no vertex.
SourceOutcome source_collapse(HalfedgeTable& table, std::uint32_t halfedge);
// The edge becomes the other diagonal of its two triangles.
SourceOutcome source_swap(HalfedgeTable& table, std::uint32_t halfedge);

// What the two do at the border of an open model, found by letting them run on two triangles with a common edge.
struct SourceReport {
  std::string_view operation;  // collapse, swap
  std::string_view place;      // boundary_edge, beside_boundary
  SourceOutcome outcome;
};
std::vector<SourceReport> sources_on_boundaries();

}  // namespace ryosen::forms
