// A value that a parameter takes on a mesh that has a vertex.
#pragma once

#include <algorithm>
#include <string>

#include "ryosen/algo/parameters.h"
#include "ryosen/base/number_text.h"

namespace ryosen::test {

inline std::string sound_value(const ParameterRow& row) {
  if (!row.initial.empty()) return std::string(row.initial);
  switch (row.kind) {
    case ParameterKind::elements:
      return "v0";
    case ParameterKind::choice:
      return std::string(row.choices[0].id);
    case ParameterKind::flag:
      return "on";
    case ParameterKind::place:
      return "1,2,3";
    case ParameterKind::length:
      return row.excludes_smallest ? "20%" : "0.01";  // one that cannot be 0 is a size
    case ParameterKind::ratio:
      return "0.5";
    default:
      return format_double(std::max(row.smallest.value_or(0), 2.0));
  }
}

}  // namespace ryosen::test
