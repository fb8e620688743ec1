// Tables of rows with ids; to some of them programs and tests may add rows for a while.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

namespace ryosen {

// The row with this id, or null.
template <class Rows>
auto find_row(const Rows& rows, std::string_view id) {
  const auto row = std::find_if(std::begin(rows), std::end(rows), [&](const auto& each) { return each.id == id; });
  return row == std::end(rows) ? nullptr : &*row;
}

// "a|b|c" of the ids of the rows.
template <class Rows>
std::string joined_ids(const Rows& rows) {
  std::string ids;
  for (const auto& row : rows) ids.append(ids.empty() ? "" : "|").append(row.id);
  return ids;
}

// Rows stay where they are. At most `most` of them.
template <class Row, std::size_t most>
class OpenTable {
 public:
  template <std::size_t count>
  constexpr explicit OpenTable(const std::array<Row, count>& built_in) : count_(count) {
    static_assert(count < most);
    std::copy(built_in.begin(), built_in.end(), rows_.begin());
  }

  std::span<const Row> rows() const { return {rows_.data(), count_}; }
  // By id; null when there is none.
  const Row* find(std::string_view id) const { return find_row(rows(), id); }

  // Ends the program where there is no room, rather than write beside the table.
  void add(const Row& row) {
    assert(!find(row.id));
    rows_.at(count_++) = row;
  }
  void remove_last() { --count_; }

 private:
  std::array<Row, most> rows_{};
  std::size_t count_;
};

}  // namespace ryosen
