// Rows of a table by their ids: any range whose elements have an `id`.
#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace ryosen {

// The row with this id, or null.
template <class Rows>
auto find_row(const Rows& rows, std::string_view id) {
  const auto row = std::find_if(std::begin(rows), std::end(rows), [&](const auto& each) { return each.id == id; });
  return row == std::end(rows) ? nullptr : &*row;
}

// The ids of the rows, and the same in one text, by default as a syntax has them: "a|b|c".
template <class Rows>
std::vector<std::string> ids_of_rows(const Rows& rows) {
  std::vector<std::string> ids;
  for (const auto& row : rows) ids.emplace_back(row.id);
  return ids;
}
template <class Rows>
std::string joined_ids(const Rows& rows, std::string_view between = "|") {
  std::string ids;
  for (const auto& row : rows) ids.append(ids.empty() ? "" : between).append(row.id);
  return ids;
}

}  // namespace ryosen
