// The collapse and the swap of the source texts, executed step by step on the records of table 5.
//
// Their code assumes closed triangle models. Here every link is checked before it is followed, to report what would
// happen at a missing one.
#pragma once

#include <string_view>
#include <vector>

#include "ryosen/base/message.h"
#include "ryosen/textbook/forms/halfedge_table.h"

namespace ryosen::forms {

struct SourceOutcome {
  bool completed = false;
  bool pair_of_edge_missing = false;  // the edge itself is a boundary; otherwise an adjacent pair is missing
  bool changed_before = false;        // something had been written before the missing link was reached
  std::size_t links_followed = 0;     // how often a record of a halfedge was read or written
  Text sentence;                      // what the original code does there
};

// The start of the halfedge is removed, its end moves to the midpoint, the triangles on both sides go. For a table of
// inner halfedges of triangles. If it fails, the table is left as the original code would leave it. Removed vertices
// and faces have no halfedge; removed halfedges have no vertex.
SourceOutcome source_collapse(HalfedgeTable& table, std::uint32_t halfedge);
// The edge becomes the other diagonal of its two triangles.
SourceOutcome source_swap(HalfedgeTable& table, std::uint32_t halfedge);

// The behaviour of both at the boundary of an open model, found by running them on two triangles with a common edge.
struct SourceReport {
  std::string_view operation;  // collapse, swap
  std::string_view place;      // boundary_edge, beside_boundary
  Text what;                   // both in words
  SourceOutcome outcome;
};
std::vector<SourceReport> sources_on_boundaries();

}  // namespace ryosen::forms
