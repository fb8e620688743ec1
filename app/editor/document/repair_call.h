// Lists of repairs as they are written: `default,weld_close=0.001,fill_holes`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ryosen/algo/repair/report.h"

namespace ryosen {

// The word that stands for all repairs that keep all geometry.
inline constexpr std::string_view default_repairs = "default";
// The command that does all of them.
inline constexpr std::string_view repair_all_line = "repair default";
static_assert(repair_all_line.ends_with(default_repairs));

struct ReadRepairs {
  RepairCall call;
  // Why there are none, a clause; and what it is about: a word that is no repair, or a repair with values that are not
  // its.
  std::optional<Text> fault;
  std::string unknown;
  const AlgorithmRow* misused = nullptr;
};

// Each repair once, in the order of the table, to be run in rounds; of two calls the later counts.
ReadRepairs read_repairs(std::string_view list);
// Whether the word behind `repair` is such a list, not the id of one repair.
bool is_list_of_repairs(std::string_view word);
// What there is to be named in a list.
std::vector<std::string> ids_of_repairs();

}  // namespace ryosen
