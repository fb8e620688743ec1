// How many values an enumeration names, and whether a table has one row for each, known when it is compiled.
#pragma once

#include <cstddef>
#include <iterator>
#include <string_view>

namespace ryosen {

namespace detail {

// How the compiler spells the value: by its name, or as a number in brackets behind the type where it has none.
template <auto value>
consteval bool has_name() {
  std::string_view spelled = __PRETTY_FUNCTION__;
  spelled = spelled.substr(0, spelled.find_first_of(";]", spelled.find("value = ")));
  const std::size_t digits = spelled.find_last_not_of("0123456789");
  return spelled[digits] != ')' || digits + 1 == spelled.size();
}

template <class Enum, std::size_t count>
consteval std::size_t count_from() {
  if constexpr (has_name<static_cast<Enum>(count)>())
    return count_from<Enum, count + 1>();
  else
    return count;
}

}  // namespace detail

// How many values the enumeration names from 0 on without a gap.
template <class Enum>
inline constexpr std::size_t enum_count = detail::count_from<Enum, 0>();

// Whether a table that is indexed by an enumeration has one row per value, in the order of the enumeration: so that a
// row that is missing, or stands elsewhere, does not compile.
//   static_assert(rows_are_in_order(rows, &Row::kind));
template <class Rows, class Row, class Enum>
consteval bool rows_are_in_order(const Rows& rows, Enum Row::*key) {
  if (std::size(rows) != enum_count<Enum>) return false;
  for (std::size_t i = 0; i < std::size(rows); ++i)
    if (static_cast<std::size_t>(rows[i].*key) != i) return false;
  return true;
}

}  // namespace ryosen
