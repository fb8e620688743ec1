// The table of rules: why an operator is refused or warned about, and the remedy, in both languages. To add one, write
// a value here and a row in reasons.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace ryosen {

// In the order of their reasons in a verdict.
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
  shape_unseen,
};

enum class RuleSeverity : std::uint8_t { refuse, warn };

struct RuleText {
  Rule rule;
  std::string_view id;  // as in JSON and scripts
  RuleSeverity severity;
  std::string_view operators;  // ids, separated by spaces; empty: all operators
  std::string_view en;         // one sentence; the witnesses are appended
  std::string_view ja;
  // What would make it legal, or why nothing would. A remedy that does not begin with "never", "nothing" or "choose
  // two" is looked for on the mesh (ryosen/ops/preview/remedy_candidates.cpp), and a test applies it to an example of
  // the rule.
  std::string_view remedy_en;
  std::string_view remedy_ja;
};

std::span<const RuleText> rule_table();
const RuleText& text_of(Rule rule);

}  // namespace ryosen
