// The history of a mesh: old values of every changed cell, one transaction per committed edit, undone and redone
// exactly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/mesh/mesh.h"

namespace ryosen {

// A cell that a transaction changed.
struct TouchedCell {
  Column column;
  std::uint32_t index;
};

class Journal {
 public:
  // Committed transactions, and how many of them are in effect; the rest can be redone.
  std::size_t size() const { return transactions_.size(); }
  std::size_t position() const { return position_; }
  bool can_undo() const { return position_ > 0; }
  bool can_redo() const { return position_ < transactions_.size(); }

  // Exchange the values of the last (next) transaction with those in the mesh; its columns are then byte-equal to what
  // they were. Cost: what the edit touched. The mesh must be the one that the transactions were recorded on.
  void undo(Mesh& mesh);
  void redo(Mesh& mesh);
  void clear();

  // What transaction i changed: the cells written, and the lengths before it (elements from there on are new).
  // Replaced columns mean that everything may have changed.
  std::vector<TouchedCell> touched(std::size_t i) const;
  const ColumnLengths& lengths_before(std::size_t i) const { return transactions_[i].before; }
  // The lengths after it; `mesh` must be in the state right before or right after transaction i.
  ColumnLengths lengths_after(const Mesh& mesh, std::size_t i) const {
    return i < position_ ? mesh.lengths() : transactions_[i].after;
  }
  bool replaces_everything(std::size_t i) const { return transactions_[i].replaced != nullptr; }

  // Bytes appended to the history so far, without columns replaced whole.
  std::size_t bytes() const;

 private:
  friend class Edit;

  struct Transaction {
    std::size_t first_cell = 0;   // into cells_
    std::size_t first_value = 0;  // into values_
    ColumnLengths before;
    ElementCounts counts;                   // exchanged with the mesh's own
    std::vector<std::byte> tail;            // the new elements' bytes, kept while undone
    ColumnLengths after;                    // set while undone
    std::unique_ptr<MeshColumns> replaced;  // exchanged with the mesh's own
  };

  void begin(const Mesh& mesh);
  void record(Column column, std::uint32_t index, const void* value, std::size_t bytes) {
    cells_.push_back({column, index});
    const auto* begin = static_cast<const std::byte*>(value);
    values_.insert(values_.end(), begin, begin + bytes);
  }
  void record_replaced(MeshColumns columns);
  void commit();
  void rollback(Mesh& mesh);

  std::size_t cell_end(std::size_t i) const;
  void exchange_backward(Mesh& mesh, const Transaction& t, std::size_t cell_end, std::size_t value_end);
  void exchange_forward(Mesh& mesh, const Transaction& t, std::size_t cell_end);

  std::vector<TouchedCell> cells_;
  std::vector<std::byte> values_;
  std::vector<Transaction> transactions_;
  Transaction open_;
  std::size_t position_ = 0;
};

}  // namespace ryosen
