// A result of `why`: the verdict on an operator with reasons, warnings and remedy.
#pragma once

#include <optional>
#include <string>

#include "app/cli/console.h"
#include "ryosen/ops/all.h"

namespace ryosen::cli {

struct VerdictReport {
  std::string_view op;
  std::string edge;       // empty if the operator has none
  std::string arguments;  // of the operator; for an operator on an edge only that edge
  Verdict verdict;
  std::vector<Reason> warnings;
  std::vector<std::string> remedy;  // if refused; empty if none was found
  std::optional<Text> quarantined;  // for a quarantined face: replaces the rule's sentence
};

// One line of JSON. Its remedy is "never" if the bounded search found nothing, whether or not a remedy can exist; the
// text output distinguishes the two.
std::string to_json_line(const Mesh& mesh, const VerdictReport& report);
std::string to_text(const Mesh& mesh, const VerdictReport& report, const Console& console);

}  // namespace ryosen::cli
