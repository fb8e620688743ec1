// Values that fields of the window begin with, as a mesh has it (ParameterRow::proposed). Empty where it has none.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

#include "ryosen/analysis/measures.h"
#include "ryosen/base/number_text.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// A length to three digits; empty if it is not positive and finite.
inline std::string to_three_digits(double length) {
  if (!std::isfinite(length) || length <= 0) return {};
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", length);
  const auto rounded = parse_double(text);
  return rounded && *rounded > 0 ? format_double(*rounded) : std::string();
}

inline std::string mean_edge_length_text(const Mesh& mesh) { return to_three_digits(mean_edge_length(mesh)); }
inline std::string hundredth_of_mean_edge_length_text(const Mesh& mesh) {
  return to_three_digits(mean_edge_length(mesh) / 100);
}

}  // namespace ryosen
