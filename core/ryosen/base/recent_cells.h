// The last cells of a stream, for readers that each remember how far they have read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

namespace ryosen {

// A cursor is the number of cells that a reader has seen; 0 at first. Who is behind the oldest cell that is kept, or
// behind a call of forget(), has missed something and reads everything anew. Not for two threads at a time.
template <class Cell>
class RecentCells {
 public:
  static constexpr std::size_t most_cells = 100000;

  // O(1), amortised.
  void add(const Cell& cell) {
    if (cells_.size() == most_cells) {
      cells_.pop_front();
      ++first_;
    }
    cells_.push_back(cell);
  }
  // All readers read everything anew.
  void forget() {
    first_ = clock() + 1;
    cells_.clear();
  }
  // The cursor of who has read all.
  std::uint64_t clock() const { return first_ + cells_.size(); }
  bool has_all_since(std::uint64_t cursor) const { return cursor >= first_ && cursor <= clock(); }
  // Oldest first. There must be all of them.
  template <class Visit>
  void for_each_since(std::uint64_t cursor, Visit visit) const {
    for (std::size_t i = static_cast<std::size_t>(cursor - first_); i < cells_.size(); ++i) visit(cells_[i]);
  }

 private:
  std::deque<Cell> cells_;
  std::uint64_t first_ = 1;  // the number of the first cell
};

}  // namespace ryosen
