// How the command line spells the parameters of algorithms.
#pragma once

#include <algorithm>
#include <string>

#include "ryosen/algo/algorithm.h"

namespace ryosen::cli {

// --most-edges
inline std::string flag_of(const ParameterRow& row) {
  std::string flag = "--" + std::string(row.id);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

// LENGTH; of a flag [on|off], which its name alone turns on.
inline std::string flag_value(const ParameterRow& row) {
  return row.kind == ParameterKind::flag ? "[" + placeholder(row) + "]" : placeholder(row);
}

// MOST-EDGES, the value that stands behind a repair in --kinds; in brackets where it may be left out.
inline std::string kinds_syntax(const AlgorithmRow& row) {
  if (row.parameters.empty()) return {};
  std::string word = flag_of(row.parameters[0]).substr(2);
  std::transform(word.begin(), word.end(), word.begin(), [](char c) { return c >= 'a' && c <= 'z' ? c - 32 : c; });
  return "=" + (row.parameters[0].is_required ? word : "[" + word + "]");
}

}  // namespace ryosen::cli
