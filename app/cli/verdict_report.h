// One answer of `why`: the verdict on an operator with reasons, warnings and remedy.
#pragma once

#include <optional>
#include <string>

#include "app/cli/console.h"
#include "core/ops/all.h"

namespace ryosen::cli {

struct VerdictReport {
  std::string_view op;
  std::string edge;       // empty where the operator has none
  std::string arguments;  // the words behind the operator; of an operator on an edge that edge alone
  Verdict verdict;
  std::vector<Reason> warnings;
  std::vector<std::string> remedy;  // for a refused one; empty where none was found
  std::optional<Text> set_aside;    // of a face that is not in the mesh: said in place of the rule's sentence
};

// One line of JSON. Its remedy is "never" where the search, which is bounded, has found nothing, whether or not anything
// could help; the text says which of the two.
std::string to_json_line(const Mesh& mesh, const VerdictReport& report);
std::string to_text(const Mesh& mesh, const VerdictReport& report, const Console& console);

}  // namespace ryosen::cli
