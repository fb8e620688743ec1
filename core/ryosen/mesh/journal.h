// The undo history of a mesh: the old value of every changed cell, one transaction per committed edit, exact undo and
// redo.
//
// Two packed streams hold all transactions in sequence: the addresses of the changed cells, 5 bytes each (10 for those
// of an attribute from number 243 on), and words: the lengths and counts before the edit, then the cell values. A cell
// is recorded once per transaction, with its value before it, so swapping the values with those in the mesh leads from
// either state to the other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <vector>

#include "ryosen/mesh/columns.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// A cell that a transaction changed.
struct TouchedCell {
  Column column;
  std::uint32_t index;
};

// The set of cells that an open transaction has recorded already: an open-addressing hash set that is cleared in O(1).
class CellMarks {
 public:
  // O(1), except for a full reset once per 2^16 calls.
  void clear() {
    count_ = 0;
    if (++generation_ == generation_end) forget();
  }

  // Inserts the cell; true if it was not in the set. O(1) expected.
  bool insert(Column column, std::uint32_t index) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    const std::uint64_t key = generation_ << key_bits | std::uint64_t{static_cast<std::uint16_t>(column)} << 32 | index;
    std::size_t slot = first_slot(key);
    while (slots_[slot] >> key_bits == generation_) {
      if (slots_[slot] == key) return false;
      slot = (slot + 1) & (slots_.size() - 1);
    }
    slots_[slot] = key;
    ++count_;
    return true;
  }

 private:
  static constexpr unsigned key_bits = 48;  // column and index; the generation is in the bits above
  static constexpr std::uint64_t generation_end = std::uint64_t{1} << (64 - key_bits);

  std::size_t first_slot(std::uint64_t key) const {
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15ull;
    return static_cast<std::size_t>((key * odd) >> 32) & (slots_.size() - 1);
  }
  void forget() {
    slots_.assign(slots_.size(), 0);
    generation_ = 1;
  }
  void grow();

  std::vector<std::uint64_t> slots_;  // size is a power of two; entries of an older generation are free
  std::uint64_t generation_ = 1;
  std::size_t count_ = 0;
};

class Journal {
 public:
  // Number of committed transactions, and how many of them are applied; the rest can be redone.
  std::size_t size() const { return transactions_.size(); }
  std::size_t position() const { return position_; }
  bool can_undo() const { return position_ > 0; }
  bool can_redo() const { return position_ < transactions_.size(); }

  // Swap the values of the last (next) transaction with those in the mesh; the columns are then byte-equal to what they
  // were. Cost: the cells the edit changed. The mesh must be the one that the transactions were recorded on. Where
  // there is no memory for it nothing changes; a way that was gone needs none to be gone back, until the next commit.
  void undo(Mesh& mesh);
  void redo(Mesh& mesh);
  // Undoes the last transaction and forgets it, with all that can be redone. Allocates nothing.
  void withdraw(Mesh& mesh) noexcept;
  // Whether the last transaction was redone, and nothing has been committed since.
  bool is_last_redone() const { return !redone_.empty(); }
  void clear();

  // What transaction i changed: the cells written, each once, and the lengths before it (elements from there on are
  // new). If it replaced the columns, everything may have changed.
  std::vector<TouchedCell> touched(std::size_t i) const;
  ColumnLengths lengths_before(std::size_t i) const;
  // The lengths after it; `mesh` must be in the state right before or right after transaction i.
  ColumnLengths lengths_after(const Mesh& mesh, std::size_t i) const {
    return i < position_ ? mesh.lengths() : undone_[transactions_.size() - 1 - i].after;
  }
  bool replaces_everything(std::size_t i) const { return replaced_.contains(i); }
  bool adds_attributes(std::size_t i) const { return added_.contains(i); }

  // Bytes held by the history, not counting replaced columns and attributes that are undone.
  std::size_t bytes() const;

 private:
  friend class Edit;

  // A cell of an attribute from number 243 on takes two of them, both with this column: the number of the attribute,
  // then the index.
  static constexpr std::uint8_t far_column = 0xff;
  struct PackedCell {
    std::uint8_t column;
    std::array<std::byte, 4> index;
  };
  static_assert(sizeof(PackedCell) == 5);
  static constexpr bool is_far(Column column) { return static_cast<std::uint16_t>(column) >= far_column; }

  // The first attribute that a transaction added, and the columns while it is undone.
  struct Added {
    std::size_t first = 0;
    std::vector<AttributeColumn> columns;
  };

  struct Transaction {
    std::size_t first_cell = 0;  // into cells_
    std::size_t first_word = 0;  // into words_: lengths before it, then counts (swapped with the mesh's), then values
  };
  // What only an undone transaction needs. Two stacks: the last undone is redone first; one that is redone keeps it for
  // the way back.
  struct Undone {
    ColumnLengths after;
    std::vector<std::byte> tail;  // column bytes of the new elements
  };

  void begin(const Mesh& mesh);
  void record(Column column, std::uint32_t index, const void* value, std::size_t bytes) {
    const std::size_t words = bytes / sizeof(std::uint32_t);
    // What may find no memory comes first, so that a rollback finds whole records.
    if (cells_.size() == cells_.capacity() || words_.capacity() - words_.size() < words) make_room_for_record(words);
    if (!marks_.insert(column, index)) return;
    add_cell(static_cast<std::uint8_t>(column), index);
    const std::size_t first = words_.size();
    words_.resize(first + words);
    std::memcpy(words_.data() + first, value, bytes);
  }
  // The same for the value of an attribute, whose column may be far.
  void record_value(std::size_t attribute, std::uint32_t index, const std::uint32_t* value, std::size_t words);
  void add_cell(std::uint8_t column, std::uint32_t index) {
    PackedCell& cell = cells_.emplace_back();
    cell.column = column;
    std::memcpy(cell.index.data(), &index, sizeof index);
  }
  // Calls visit(column, index) for the cells of a part of the stream.
  template <class Visit>
  void for_each_cell(std::size_t begin, std::size_t end, const Visit& visit) const {
    for (std::size_t i = begin; i < end; ++i) {
      auto column = static_cast<Column>(cells_[i].column);
      std::uint32_t index;
      std::memcpy(&index, cells_[i].index.data(), sizeof index);
      if (cells_[i].column == far_column) {
        column = column_of_attribute(index);
        std::memcpy(&index, cells_[++i].index.data(), sizeof index);
      }
      visit(column, index);
    }
  }
  void record_added(std::size_t attribute) {
    if (!open_added_) open_added_ = attribute;
  }
  void make_room_for_record(std::size_t words);
  void record_replaced(MeshColumns columns);
  void commit();
  void rollback(Mesh& mesh);

  std::size_t cell_end(std::size_t i) const;
  void drop_undone();
  // Swaps the counts and the values of the cells of a transaction with those of the mesh.
  void exchange(Mesh& mesh, const Transaction& transaction, std::size_t cell_end);

  std::vector<PackedCell> cells_;
  std::vector<std::uint32_t> words_;
  std::vector<Transaction> transactions_;
  std::vector<Undone> undone_, redone_;
  std::map<std::size_t, MeshColumns> replaced_;  // by transaction; swapped with the mesh's columns
  std::map<std::size_t, Added> added_;           // by transaction
  Transaction open_;
  std::optional<MeshColumns> open_replaced_;
  std::optional<std::size_t> open_added_;
  CellMarks marks_;  // the cells of open_
  std::size_t position_ = 0;
};

// The elements that a transaction changed, for everything that is updated incrementally through edits, undo and redo.
// Sorted, without duplicates. Slots may be dead or past the end of the columns (elements removed by an undo). Elements
// that the transaction creates, or its undo removes, are in all lists of their kind, with all attributes that they may
// have.
struct TouchedElements {
  // A value: an index in a column of Mesh::attributes().
  struct Value {
    std::uint32_t attribute, index;
    friend auto operator<=>(const Value&, const Value&) = default;
  };

  bool everything = false;          // columns were replaced whole, added or removed; the lists are empty then
  std::vector<Vertex> vertices;     // its link, its position, or a link of an outgoing halfedge was written
  std::vector<Vertex> moved;        // its position was written
  std::vector<Halfedge> halfedges;  // a link was written
  std::vector<Face> faces;          // its link or that of a side was written, or a corner moved
  std::vector<Value> values;        // written; a pool only grows, and is not among them
  bool all_values = false;          // more than are listed may be others now
};

// The elements that differ between the states before and after transaction i. Call it in either state, right after the
// commit, undo or redo of i. Cost: the cells written, and the one-rings of moved vertices.
TouchedElements touched_elements(const Mesh& mesh, const Journal& journal, std::size_t i);

}  // namespace ryosen
