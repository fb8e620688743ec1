// What is searched for only where somebody asks for it.
#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/document/findings.h"
#include "app/editor/session/frontend.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/base/count_text.h"

namespace ryosen {

std::optional<Text> fault_of_self_intersections(Words arguments, const std::string&) {
  const bool is_off = arguments.size() == 1 && arguments[0] == "off";
  return arguments.empty() || is_off ? std::nullopt : std::optional(wrong_arguments("self_intersections").sentence);
}

Outcome run_self_intersections(Findings& findings, const Frontend& frontend, Words arguments, std::string_view) {
  if (const auto fault = fault_of_self_intersections(arguments, {})) return usage_error(*fault);
  if (!arguments.empty()) {
    findings.forget(ProblemKind::self_intersection);
    return {};
  }
  Progress progress(frontend.on_progress);
  constexpr std::size_t most_pairs = 100000;  // of which it is known what a face meets; n copies of one make n^2 / 2
  auto found = find_self_intersections(findings.mesh(), most_pairs, 0, progress);
  if (!found) return cancelled();
  std::vector<std::uint32_t> faces;
  for (const Face f : found->faces) faces.push_back(f.index);
  const std::size_t pairs = found->count;
  findings.put(ProblemKind::self_intersection, faces, std::move(found->pairs));
  Outcome outcome;
  outcome.sentence = {"No face meets another elsewhere than in common vertices and edges.",
                      "共有する頂点・稜線以外で交わる面はありません。"};
  if (!faces.empty()) {
    outcome.sentence = row_of(ProblemKind::self_intersection).sentence(faces.size());
    outcome.say(count_text(pairs, "It is one pair.", "They are # pairs.", "組の数は # です。"));
  }
  return outcome;
}

}  // namespace ryosen
