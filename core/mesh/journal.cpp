#include "core/mesh/journal.h"

#include <cstring>
#include <utility>

namespace ryosen {

namespace {

// Calls visit(vector, first element, words per element) for the part of every column behind `lengths`.
template <class Visit>
void for_each_column_tail(MeshColumns& c, const ColumnLengths& lengths, Visit visit) {
  visit(c.vertex_halfedge, lengths.vertices, 1);
  visit(c.positions, lengths.vertices, 1);
  visit(c.halfedges, lengths.halfedges, 1);
  visit(c.face_halfedge, lengths.faces, 1);
  visit(c.next_copy, lengths.copies, 1);
  std::size_t pool = 0;
  for (AttributeColumn& a : c.attributes) {
    std::uint32_t first = 0;
    switch (a.element) {
      case ElementKind::vertex:
        first = lengths.vertices;
        break;
      case ElementKind::corner:
        first = lengths.halfedges;
        break;
      case ElementKind::face:
        first = lengths.faces;
        break;
      case ElementKind::pool:
        first = lengths.pools[pool++];
        break;
    }
    visit(a.data, first, a.words);
  }
}

void cut_tail(MeshColumns& columns, const ColumnLengths& before, std::vector<std::byte>* tail) {
  for_each_column_tail(columns, before, [&](auto& column, std::size_t first, std::size_t words) {
    if (tail) {
      const auto* begin = reinterpret_cast<const std::byte*>(column.data() + first * words);
      const auto* end = reinterpret_cast<const std::byte*>(column.data() + column.size());
      tail->insert(tail->end(), begin, end);
    }
    column.resize(first * words);
  });
}

void restore_tail(MeshColumns& columns, const ColumnLengths& after, const std::vector<std::byte>& tail) {
  const std::byte* source = tail.data();
  for_each_column_tail(columns, after, [&](auto& column, std::size_t length, std::size_t words) {
    using Value = typename std::remove_reference_t<decltype(column)>::value_type;
    const std::size_t first = column.size();
    column.resize(length * words);
    const std::size_t bytes = (column.size() - first) * sizeof(Value);
    if (bytes != 0) std::memcpy(static_cast<void*>(column.data() + first), source, bytes);
    source += bytes;
  });
}

void exchange(std::byte* a, std::byte* b, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; i += sizeof(std::uint32_t)) {
    std::uint32_t x, y;
    std::memcpy(&x, a + i, sizeof x);
    std::memcpy(&y, b + i, sizeof y);
    std::memcpy(a + i, &y, sizeof y);
    std::memcpy(b + i, &x, sizeof x);
  }
}

}  // namespace

void Journal::begin(const Mesh& mesh) {
  open_ = Transaction();
  open_.first_cell = cells_.size();
  open_.first_value = values_.size();
  open_.before = mesh.lengths();
  open_.counts = mesh.live();
}

void Journal::record_replaced(MeshColumns columns) {
  open_.replaced = std::make_unique<MeshColumns>(std::move(columns));
}

void Journal::commit() {
  if (can_redo()) {
    // What had been undone is dropped; the new transaction moves into its place.
    const Transaction& dropped = transactions_[position_];
    cells_.erase(cells_.begin() + dropped.first_cell, cells_.begin() + open_.first_cell);
    values_.erase(values_.begin() + dropped.first_value, values_.begin() + open_.first_value);
    open_.first_cell = dropped.first_cell;
    open_.first_value = dropped.first_value;
    transactions_.resize(position_);
  }
  transactions_.push_back(std::move(open_));
  ++position_;
}

void Journal::rollback(Mesh& mesh) {
  if (open_.replaced) {
    mesh.columns_ = std::move(*open_.replaced);
  } else {
    exchange_backward(mesh, open_, cells_.size(), values_.size());
    cut_tail(mesh.columns_, open_.before, nullptr);
    mesh.columns_.live = open_.counts;
  }
  cells_.resize(open_.first_cell);
  values_.resize(open_.first_value);
  open_ = Transaction();
}

std::size_t Journal::cell_end(std::size_t i) const {
  return i + 1 < transactions_.size() ? transactions_[i + 1].first_cell : cells_.size();
}

void Journal::exchange_backward(Mesh& mesh, const Transaction& t, std::size_t cell_end, std::size_t value_end) {
  std::size_t value = value_end;
  for (std::size_t i = cell_end; i-- > t.first_cell;) {
    const auto [cell, bytes] = mesh.cell(cells_[i].column, cells_[i].index);
    value -= bytes;
    exchange(cell, values_.data() + value, bytes);
  }
}

void Journal::exchange_forward(Mesh& mesh, const Transaction& t, std::size_t cell_end) {
  std::size_t value = t.first_value;
  for (std::size_t i = t.first_cell; i < cell_end; ++i) {
    const auto [cell, bytes] = mesh.cell(cells_[i].column, cells_[i].index);
    exchange(cell, values_.data() + value, bytes);
    value += bytes;
  }
}

void Journal::undo(Mesh& mesh) {
  const std::size_t i = --position_;
  Transaction& t = transactions_[i];
  if (t.replaced) {
    std::swap(mesh.columns_, *t.replaced);
    return;
  }
  const std::size_t value_end = i + 1 < transactions_.size() ? transactions_[i + 1].first_value : values_.size();
  exchange_backward(mesh, t, cell_end(i), value_end);
  t.after = mesh.lengths();
  cut_tail(mesh.columns_, t.before, &t.tail);
  std::swap(mesh.columns_.live, t.counts);
}

void Journal::redo(Mesh& mesh) {
  const std::size_t i = position_++;
  Transaction& t = transactions_[i];
  if (t.replaced) {
    std::swap(mesh.columns_, *t.replaced);
    return;
  }
  restore_tail(mesh.columns_, t.after, t.tail);
  t.tail = {};
  exchange_forward(mesh, t, cell_end(i));
  std::swap(mesh.columns_.live, t.counts);
}

void Journal::clear() { *this = Journal(); }

std::vector<TouchedCell> Journal::touched(std::size_t i) const {
  return {cells_.begin() + static_cast<std::ptrdiff_t>(transactions_[i].first_cell),
          cells_.begin() + static_cast<std::ptrdiff_t>(cell_end(i))};
}

std::size_t Journal::bytes() const {
  return cells_.size() * sizeof(TouchedCell) + values_.size() + transactions_.size() * sizeof(Transaction);
}

}  // namespace ryosen
