// What an algorithm is told by the value of its first parameter.
#pragma once

#include <optional>

#include "ryosen/algo/algorithm.h"
#include "ryosen/base/number_text.h"

namespace ryosen::test {

inline AlgorithmInput input_of(const AlgorithmRow& row, std::optional<double> first) {
  AlgorithmInput input{ParameterValues(row.parameters), {}, 0};
  if (first) input.values.set(row.parameters[0].id, format_double(*first), {});
  return input;
}

}  // namespace ryosen::test
