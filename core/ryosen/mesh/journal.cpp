#include "ryosen/mesh/journal.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>
#include <span>
#include <type_traits>
#include <utility>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

namespace {

// Calls visit(vector, first element, words per element) for the part of every column past `lengths`, with this many
// attributes.
template <class Visit>
void for_each_column_tail(MeshColumns& c, const ColumnLengths& lengths, std::size_t attributes, Visit visit) {
  visit(c.vertex_halfedge, lengths.vertices, 1);
  visit(c.positions, lengths.vertices, 1);
  visit(c.halfedges, lengths.halfedges, 1);
  visit(c.face_halfedge, lengths.faces, 1);
  visit(c.next_copy, lengths.copies, 1);
  visit(c.copy_point, lengths.copies, 1);
  visit(c.first_ring, lengths.ringed_faces, 1);
  visit(c.rings, lengths.rings, 1);
  std::size_t pool = 0;
  for (AttributeColumn& a : std::span(c.attributes).first(attributes))
    visit(a.data,
          a.element == ElementKind::pool ? lengths.pools[pool++]
                                         : length_of(a.element, lengths.vertices, lengths.halfedges, lengths.faces),
          a.words());
}

std::vector<std::byte> copy_tail(MeshColumns& columns, const ColumnLengths& before, std::size_t attributes) {
  std::vector<std::byte> tail;
  for_each_column_tail(columns, before, attributes, [&](auto& column, std::size_t first, std::size_t words) {
    const auto* begin = reinterpret_cast<const std::byte*>(column.data() + first * words);
    const auto* end = reinterpret_cast<const std::byte*>(column.data() + column.size());
    tail.insert(tail.end(), begin, end);
  });
  return tail;
}

// Allocates nothing.
void cut_tail(MeshColumns& columns, const ColumnLengths& before) {
  for_each_column_tail(columns, before, columns.attributes.size(),
                       [](auto& column, std::size_t first, std::size_t words) { column.resize(first * words); });
}

// So that restore_tail allocates nothing.
void make_room_for_tail(MeshColumns& columns, const ColumnLengths& after) {
  for_each_column_tail(columns, after, columns.attributes.size(),
                       [](auto& column, std::size_t length, std::size_t words) { column.reserve(length * words); });
}

void restore_tail(MeshColumns& columns, const ColumnLengths& after, const std::vector<std::byte>& tail) {
  const std::byte* source = tail.data();
  for_each_column_tail(columns, after, columns.attributes.size(),
                       [&](auto& column, std::size_t length, std::size_t words) {
                         using Value = typename std::remove_reference_t<decltype(column)>::value_type;
                         const std::size_t first = column.size();
                         column.resize(length * words);
                         const std::size_t bytes = (column.size() - first) * sizeof(Value);
                         if (bytes != 0) std::memcpy(static_cast<void*>(column.data() + first), source, bytes);
                         source += bytes;
                       });
}

// Lengths are stored as a bit mask of the nonzero ones, followed by their values.
constexpr std::size_t length_count = sizeof(ColumnLengths) / sizeof(std::uint32_t);
static_assert(length_count <= 32 && std::has_unique_object_representations_v<ColumnLengths>);
constexpr std::size_t count_words = sizeof(ElementCounts) / sizeof(std::uint32_t);

void append_lengths(const ColumnLengths& lengths, std::vector<std::uint32_t>& words) {
  const auto values = std::bit_cast<std::array<std::uint32_t, length_count>>(lengths);
  const std::size_t place = words.size();
  words.push_back(0);
  for (std::size_t i = 0; i < length_count; ++i) {
    if (values[i] == 0) continue;
    words[place] |= 1u << i;
    words.push_back(values[i]);
  }
}

ColumnLengths read_lengths(const std::uint32_t* words) {
  std::array<std::uint32_t, length_count> values{};
  const std::uint32_t* next = words + 1;
  for (std::size_t i = 0; i < length_count; ++i)
    if (*words >> i & 1u) values[i] = *next++;
  return std::bit_cast<ColumnLengths>(values);
}

std::size_t words_of_lengths(std::uint32_t mask) { return 1 + static_cast<std::size_t>(std::popcount(mask)); }

// Makes room for `count` more, as much at once as push_back would.
template <class Value>
void make_room(std::vector<Value>& values, std::size_t count) {
  if (values.capacity() - values.size() < count) values.reserve(std::max(2 * values.capacity(), values.size() + count));
}

template <class Handle>
void add_range(std::vector<Handle>& handles, std::uint32_t begin, std::uint32_t end) {
  for (std::uint32_t i = begin; i < end; ++i) handles.push_back(Handle(i));
}

}  // namespace

void CellMarks::grow() {
  constexpr std::size_t smallest = 128;
  std::vector<std::uint64_t> old(std::max(smallest, 2 * slots_.size()), 0);
  std::swap(old, slots_);
  for (std::uint64_t key : old) {
    if (key >> key_bits != generation_) continue;
    std::size_t slot = first_slot(key);
    while (slots_[slot] != 0) slot = (slot + 1) & (slots_.size() - 1);
    slots_[slot] = key;
  }
}

void Journal::record_value(std::size_t attribute, std::uint32_t index, const std::uint32_t* value, std::size_t words) {
  const Column column = column_of_attribute(attribute);
  if (!is_far(column)) return record(column, index, value, words * sizeof *value);
  make_room_for_record(words);
  if (!marks_.insert(column, index)) return;
  add_cell(far_column, static_cast<std::uint32_t>(attribute));
  add_cell(far_column, index);
  words_.insert(words_.end(), value, value + words);
}

void Journal::make_room_for_record(std::size_t words) {
  make_room(cells_, 2);
  make_room(words_, words);
}

void Journal::begin(const Mesh& mesh) {
  make_room(words_, 1 + length_count + count_words);
  open_ = {cells_.size(), words_.size()};
  marks_.clear();
  append_lengths(mesh.lengths(), words_);
  const auto counts = std::bit_cast<std::array<std::uint32_t, count_words>>(mesh.live());
  words_.insert(words_.end(), counts.begin(), counts.end());
}

void Journal::record_replaced(MeshColumns columns) { open_replaced_ = std::move(columns); }

// What may find no memory comes first.
void Journal::commit() {
  make_room(transactions_, 1);
  std::map<std::size_t, MeshColumns> replaced;
  if (open_replaced_) replaced.emplace(position_, MeshColumns());
  std::map<std::size_t, Added> added;
  if (open_added_) added.emplace(position_, Added{*open_added_, {}});
  if (can_redo()) drop_undone();
  added_.merge(added);
  open_added_.reset();
  if (open_replaced_) {
    replaced.begin()->second = std::move(*open_replaced_);
    replaced_.merge(replaced);
  }
  open_replaced_.reset();
  redone_.clear();
  transactions_.push_back(open_);
  ++position_;
}

// Erases the undone transactions from the streams; the open one moves into their place.
void Journal::drop_undone() {
  const Transaction dropped = transactions_[position_];
  const auto erase = [](auto& stream, std::size_t begin, std::size_t end) {
    stream.erase(stream.begin() + static_cast<std::ptrdiff_t>(begin),
                 stream.begin() + static_cast<std::ptrdiff_t>(end));
  };
  erase(cells_, dropped.first_cell, open_.first_cell);
  erase(words_, dropped.first_word, open_.first_word);
  open_ = dropped;
  transactions_.resize(position_);
  undone_.clear();
  replaced_.erase(replaced_.lower_bound(position_), replaced_.end());
  added_.erase(added_.lower_bound(position_), added_.end());
}

void Journal::rollback(Mesh& mesh) {
  if (open_added_) mesh.columns_.attributes.resize(*open_added_);
  open_added_.reset();
  if (open_replaced_) {
    mesh.columns_ = std::move(*open_replaced_);
    open_replaced_.reset();
  } else {
    exchange(mesh, open_, cells_.size());
    cut_tail(mesh.columns_, read_lengths(words_.data() + open_.first_word));
  }
  cells_.resize(open_.first_cell);
  words_.resize(open_.first_word);
}

std::size_t Journal::cell_end(std::size_t i) const {
  return i + 1 < transactions_.size() ? transactions_[i + 1].first_cell : cells_.size();
}

void Journal::exchange(Mesh& mesh, const Transaction& t, std::size_t cell_end) {
  using Counts = std::array<std::uint32_t, count_words>;
  std::uint32_t* value = words_.data() + t.first_word + words_of_lengths(words_[t.first_word]);
  Counts counts;
  std::copy_n(value, count_words, counts.begin());
  const auto now = std::bit_cast<Counts>(std::exchange(mesh.columns_.live, std::bit_cast<ElementCounts>(counts)));
  value = std::copy(now.begin(), now.end(), value);
  for_each_cell(t.first_cell, cell_end, [&](Column column, std::uint32_t index) {
    const auto [cell, bytes] = mesh.cell(column, index);
    for (std::size_t k = 0; k < bytes; k += sizeof(std::uint32_t), ++value) {
      std::uint32_t word;
      std::memcpy(&word, cell + k, sizeof word);
      std::memcpy(cell + k, value, sizeof word);
      *value = word;
    }
  });
}

void Journal::undo(Mesh& mesh) {
  const std::size_t i = position_ - 1;
  const auto replaced = replaced_.find(i);
  const auto added = added_.find(i);
  if (redone_.empty()) {
    make_room(undone_, 1);
    make_room(redone_, undone_.size() + 1);
    const std::size_t kept = added == added_.end() ? mesh.attributes().size() : added->second.first;
    if (added != added_.end()) added->second.columns.reserve(mesh.attributes().size() - kept);
    Undone undone{mesh.lengths(), {}};
    if (replaced == replaced_.end()) undone.tail = copy_tail(mesh.columns_, lengths_before(i), kept);
    undone_.push_back(std::move(undone));
  } else {
    undone_.push_back(std::move(redone_.back()));
    redone_.pop_back();
  }
  --position_;
  if (replaced != replaced_.end()) {
    std::swap(mesh.columns_, replaced->second);
    return;
  }
  if (added != added_.end()) {
    const auto first = mesh.columns_.attributes.begin() + static_cast<std::ptrdiff_t>(added->second.first);
    added->second.columns.assign(std::make_move_iterator(first),
                                 std::make_move_iterator(mesh.columns_.attributes.end()));
    mesh.columns_.attributes.erase(first, mesh.columns_.attributes.end());
  }
  exchange(mesh, transactions_[i], cell_end(i));
  cut_tail(mesh.columns_, lengths_before(i));
}

void Journal::redo(Mesh& mesh) {
  const std::size_t i = position_;
  const auto replaced = replaced_.find(i);
  const auto added = added_.find(i);
  if (replaced == replaced_.end()) make_room_for_tail(mesh.columns_, undone_.back().after);
  if (added != added_.end()) make_room(mesh.columns_.attributes, added->second.columns.size());
  redone_.push_back(std::move(undone_.back()));
  undone_.pop_back();
  const Undone& undone = redone_.back();
  ++position_;
  if (replaced != replaced_.end()) {
    std::swap(mesh.columns_, replaced->second);
    return;
  }
  restore_tail(mesh.columns_, undone.after, undone.tail);
  exchange(mesh, transactions_[i], cell_end(i));
  if (added == added_.end()) return;
  for (AttributeColumn& column : added->second.columns) mesh.columns_.attributes.push_back(std::move(column));
  added->second.columns.clear();
}

void Journal::withdraw(Mesh& mesh) noexcept {
  redone_.clear();
  const auto replaced = replaced_.find(--position_);
  if (replaced != replaced_.end()) open_replaced_ = std::move(replaced->second);
  replaced_.erase(replaced_.lower_bound(position_), replaced_.end());
  const auto added = added_.find(position_);
  if (added != added_.end()) open_added_ = added->second.first;
  added_.erase(added_.lower_bound(position_), added_.end());
  open_ = transactions_[position_];
  if (const std::size_t next = position_ + 1; next < transactions_.size()) {
    cells_.resize(transactions_[next].first_cell);
    words_.resize(transactions_[next].first_word);
  }
  transactions_.resize(position_);
  undone_.clear();
  rollback(mesh);
}

void Journal::clear() { *this = Journal(); }

std::vector<TouchedCell> Journal::touched(std::size_t i) const {
  std::vector<TouchedCell> cells;
  cells.reserve(cell_end(i) - transactions_[i].first_cell);
  for_each_cell(transactions_[i].first_cell, cell_end(i), [&](Column column, std::uint32_t index) {
    cells.push_back({column, index});
  });
  return cells;
}

ColumnLengths Journal::lengths_before(std::size_t i) const {
  return read_lengths(words_.data() + transactions_[i].first_word);
}

std::size_t Journal::bytes() const {
  return cells_.size() * sizeof(PackedCell) + words_.size() * sizeof(std::uint32_t) +
         transactions_.size() * sizeof(Transaction);
}

namespace {

constexpr std::size_t most_listed_values = 10000;

void add_new_values(const Mesh& mesh, const ColumnLengths& before, const ColumnLengths& after,
                    TouchedElements& touched) {
  const std::span<const AttributeColumn> attributes = mesh.attributes();
  for (std::uint32_t a = 0; a < attributes.size(); ++a) {
    const AttributeColumn& column = attributes[a];
    if (column.element == ElementKind::pool || column.is_removed != 0) continue;
    const auto length = [&](const ColumnLengths& of) {
      return length_of(column.element, of.vertices, of.halfedges, of.faces);
    };
    const auto [least, most] = std::minmax({length(before), length(after)});
    touched.all_values = touched.all_values || touched.values.size() + (most - least) > most_listed_values;
    for (std::uint32_t index = least; index < most && !touched.all_values; ++index)
      touched.values.push_back({a, index});
  }
  if (touched.all_values) touched.values.clear();
}

}  // namespace

TouchedElements touched_elements(const Mesh& mesh, const Journal& journal, std::size_t i) {
  TouchedElements touched;
  const std::vector<TouchedCell> cells = journal.touched(i);
  if (journal.replaces_everything(i) || journal.adds_attributes(i) ||
      std::any_of(cells.begin(), cells.end(),
                  [](const TouchedCell& cell) { return cell.column == Column::attribute_removed; })) {
    touched.everything = true;
    return touched;
  }
  for (const TouchedCell& cell : cells) {
    switch (cell.column) {
      case Column::position:
        touched.moved.push_back(Vertex(cell.index));
        [[fallthrough]];
      case Column::vertex_halfedge:
      case Column::next_copy:
      case Column::copy_point:
        touched.vertices.push_back(Vertex(cell.index));
        break;
      case Column::from:
      case Column::next:
      case Column::prev:
      case Column::face:
        touched.halfedges.push_back(Halfedge(cell.index));
        break;
      case Column::first_ring:
      case Column::face_halfedge:
        touched.faces.push_back(Face(cell.index));
        break;
      default:
        if (cell.column >= Column::first_attribute)
          touched.values.push_back({static_cast<std::uint32_t>(attribute_of_column(cell.column)), cell.index});
        break;
    }
  }
  const ColumnLengths before = journal.lengths_before(i), after = journal.lengths_after(mesh, i);
  add_range(touched.vertices, before.vertices, after.vertices);
  add_range(touched.moved, before.vertices, after.vertices);
  add_range(touched.halfedges, before.halfedges, after.halfedges);
  add_range(touched.faces, before.faces, after.faces);
  add_new_values(mesh, before, after, touched);
  sort_unique(touched.values);
  sort_unique(touched.halfedges);
  for (Halfedge h : touched.halfedges) {
    if (!mesh.exists(h) || !mesh.is_alive(h)) continue;
    touched.vertices.push_back(mesh.from(h));
    if (!mesh.is_outside(h)) touched.faces.push_back(mesh.face(h));
  }
  sort_unique(touched.moved);
  for (Vertex v : touched.moved) {
    if (!mesh.exists(v) || !mesh.is_alive(v)) continue;
    for (Halfedge h : outgoing(mesh, v))
      if (!mesh.is_outside(h)) touched.faces.push_back(mesh.face(h));
  }
  sort_unique(touched.vertices);
  sort_unique(touched.faces);
  return touched;
}

}  // namespace ryosen
