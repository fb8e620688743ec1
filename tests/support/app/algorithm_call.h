// The subcommand of an algorithm, with a value for each parameter that must be given.
#pragma once

#include "app/cli/algorithm_flags.h"
#include "tests/support/app/program.h"

namespace ryosen::test {

// One that the parameter takes on a mesh that has a vertex.
inline std::string value_for(const ParameterRow& row) {
  if (!row.initial.empty()) return std::string(row.initial);
  if (row.kind == ParameterKind::elements) return "v0";
  if (row.kind == ParameterKind::choice) return std::string(row.choices[0].id);
  if (row.kind == ParameterKind::flag) return "on";
  return row.kind == ParameterKind::length ? "0.01" : "1";
}

inline std::vector<std::string> words_for(const AlgorithmRow& row, const std::string& file) {
  std::vector<std::string> words{std::string(row.id), file};
  for (const ParameterRow& parameter : row.parameters)
    if (parameter.is_required) words.insert(words.end(), {cli::flag_of(parameter), value_for(parameter)});
  return words;
}

}  // namespace ryosen::test
