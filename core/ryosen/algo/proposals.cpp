#include "ryosen/algo/proposals.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "ryosen/analysis/measures.h"
#include "ryosen/base/number_text.h"

namespace ryosen {

namespace {

std::string to_three_digits(double length) {
  if (!std::isfinite(length) || length <= 0) return {};
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", length);
  const auto rounded = parse_double(text);
  return rounded && *rounded > 0 ? format_double(*rounded) : std::string();
}

}  // namespace

std::string mean_edge_length_text(const Mesh& mesh) { return to_three_digits(mean_edge_length(mesh)); }
std::string hundredth_of_mean_edge_length_text(const Mesh& mesh) {
  return to_three_digits(mean_edge_length(mesh) / 100);
}

}  // namespace ryosen
