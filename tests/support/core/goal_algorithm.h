// An algorithm with a goal that the program does not have: what it says of its end is all that anybody needs.
#pragma once

#include "ryosen/algo/edge_rules.h"

namespace ryosen::test {

// Deletes nothing: adds free vertices, one for each face that is more than wanted, or none where it is told to be lazy.
inline AlgorithmResult run_wish(Edit& edit, const AlgorithmInput& input, Progress&) {
  AlgorithmResult result;
  const std::size_t faces = edit.mesh().live().faces;
  if (faces == 0) {
    result.refused = Text{"there are no faces", "面がありません"};
    return result;
  }
  const ParameterValues& values = input.values;
  const std::size_t wanted = values.has("faces")
                                 ? values.count("faces")
                                 : static_cast<std::size_t>(values.ratio("ratio") * static_cast<double>(faces));
  result.goal_report.emplace();
  result.goal_report->is_reached = wanted >= faces;
  result.goal_report->stopped = wanted >= faces ? Stop::goal : Stop::blocked;
  if (values.flag("measured")) result.goal_report->error_max = 0.25;
  if (input.wants.edge_rules && wanted < faces) {
    result.goal_report->remaining.assign(edge_rule_table().size(), 0);
    result.goal_report->remaining[static_cast<std::size_t>(EdgeRule::structure)] = edit.mesh().live().edges;
  }
  for (std::size_t i = wanted; i < faces; ++i) edit.fresh(edit.add_vertex({0, 0, static_cast<double>(i)}));
  result.changed = wanted < faces ? faces - wanted : 0;
  result.text = {"Wished.", "望みました。"};
  return result;
}

inline AlgorithmRow wish_row() {
  const auto row = [](std::string_view id, ParameterKind kind, std::string_view one_of, std::string_view initial) {
    return ParameterRow{.id = id,
                        .kind = kind,
                        .name_en = id,
                        .name_ja = "値",
                        .help_en = "a value to try",
                        .help_ja = "試すための値",
                        .initial = initial,
                        .one_of = one_of};
  };
  AlgorithmRow wish{"wish", "Wish", "望み", "wishes for faces", "面の数を望む", {}, false, {}, run_wish};
  wish.parameters = {row("faces", ParameterKind::count, "faces, ratio", ""),
                     row("ratio", ParameterKind::ratio, "faces, ratio", ""),
                     row("measured", ParameterKind::flag, "", "off")};
  wish.has_goal = true;
  return wish;
}

}  // namespace ryosen::test
