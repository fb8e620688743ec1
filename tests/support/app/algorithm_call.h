// The subcommand of an algorithm, with a value for each parameter that must be given.
#pragma once

#include "app/cli/algorithm_flags.h"
#include "tests/support/app/program.h"
#include "tests/support/core/sound_value.h"

namespace ryosen::test {

inline std::vector<std::string> words_for(const AlgorithmRow& row, const std::string& file) {
  std::vector<std::string> words{std::string(row.id), file};
  for (const ParameterRow& parameter : row.parameters)
    if (must_be_given(row.parameters, parameter))
      words.insert(words.end(), {cli::flag_of(parameter), sound_value(parameter)});
  return words;
}

}  // namespace ryosen::test
