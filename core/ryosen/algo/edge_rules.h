// The rules under which an edge can stand when an algorithm with a goal has ended: why it was left.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "ryosen/algo/algorithm.h"
#include "ryosen/base/enum_table.h"

namespace ryosen {

// In the order in which they are asked: an edge stands under the first that holds it.
enum class EdgeRule : std::uint8_t {
  structure,
  seam,
  boundary,
  normal,
  angle,
  error,
  selection,
  self_intersection,
  distance,
  free
};

// In the place of a rule: there is no such edge.
inline constexpr std::uint8_t no_rule = 255;

struct EdgeRuleRow {
  EdgeRule rule;
  std::string_view id;
  std::string_view name_en, name_ja;  // of a row in a list
  std::string_view en, ja;            // in a sentence
};

// In the order of EdgeRule.
std::span<const EdgeRuleRow> edge_rule_table();

struct StopRow {
  Stop stop;
  std::string_view id;
};

inline constexpr std::array stops{StopRow{Stop::goal, "goal"},         StopRow{Stop::error, "error"},
                                  StopRow{Stop::distance, "distance"}, StopRow{Stop::blocked, "blocked"},
                                  StopRow{Stop::shape, "shape"},       StopRow{Stop::cancelled, "cancelled"}};

static_assert(rows_are_in_order(stops, &StopRow::stop));

constexpr std::string_view id_of(Stop stop) { return stops[static_cast<std::size_t>(stop)].id; }

}  // namespace ryosen
