// Tables of rows with ids; to some of them programs and tests may add rows for a while.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <span>
#include <string_view>

#include "ryosen/base/rows.h"

namespace ryosen {

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
