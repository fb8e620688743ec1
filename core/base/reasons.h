// The table of rules: why an operator is refused or warned about, and the remedy, in both languages.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace ryosen {

enum class Rule : std::uint8_t {
  deleted,
  copies,
  isolated_apex,
  vanishes,
  closes_hole,
  common_neighbour,
  common_face,
  inner_edge,
  duplicate_face,
  boundary,
  edge_exists,
  corner_twice,
  loses_duplicate,
  same_apex,
  oriented,
  has_edges,
  has_face,
  same_vertex,
  no_gap,
  loop,
  two_edges,
  no_bridge,
  same_loop,
  different_loops,
  different_faces,
  same_face,
  one_fan,
  detached,
  wire,
  same_edge,
  has_rings,
  triangulated,
  nothing_between,
  joins_fans,
  lone_edge,
  pinch,
  normal_turns,
  degenerate,
  seam,
  intersects,
  outside_edge,
  same_place,
  leaves_face,
};

enum class RuleSeverity : std::uint8_t { refuse, warn };

struct RuleText {
  Rule rule;
  std::string_view id;  // as in JSON and scripts
  RuleSeverity severity;
  std::string_view operators;  // ids, separated by spaces; empty: all operators
  std::string_view en;         // one sentence; the witnesses are appended
  std::string_view ja;
  std::string_view remedy_en;  // what would make it legal, or why nothing would
  std::string_view remedy_ja;
};

std::span<const RuleText> rule_table();
const RuleText& text_of(Rule rule);

}  // namespace ryosen
