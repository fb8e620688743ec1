#include "ryosen/io/properties.h"

#include <algorithm>
#include <cstring>

#include "ryosen/indexed/indexed.h"

namespace ryosen {
namespace {

template <class Target>
Target load_as(const Property& property, std::size_t value) {
  return with_scalar(property.type, [&](auto number) {
    std::memcpy(&number, property.data.data() + value * sizeof number, sizeof number);
    return static_cast<Target>(number);
  });
}

template <class Source>
void append_as(Property& property, Source value) {
  with_scalar(property.type, [&](auto number) {
    number = static_cast<decltype(number)>(value);
    const auto* const bytes = reinterpret_cast<const std::byte*>(&number);
    property.data.insert(property.data.end(), bytes, bytes + sizeof number);
    return 0;
  });
}

void copy_row(const Property& from, std::size_t row, Property& to) {
  const std::size_t size = bytes_of(from.type);
  const auto begin = from.data.begin() + static_cast<std::ptrdiff_t>(from.first_value(row) * size);
  to.data.insert(to.data.end(), begin, begin + static_cast<std::ptrdiff_t>(from.value_count(row) * size));
  if (from.is_list) to.ends.push_back(static_cast<std::uint32_t>(to.data.size() / size));
}

void add_empty_row(Property& to) {
  if (to.is_list)
    to.ends.push_back(to.ends.empty() ? 0 : to.ends.back());
  else
    to.data.resize(to.data.size() + bytes_of(to.type));
}

PropertyTable without_rows(const PropertyTable& table) {
  PropertyTable out{table.name, table.kind, 0, {}};
  for (const PropertyHead& head : table.properties) out.properties.push_back({head, {}, {}});
  return out;
}

}  // namespace

PropertyTable rows_of(const PropertyTable& table, std::span<const std::uint32_t> source) {
  PropertyTable out = without_rows(table);
  out.rows = source.size();
  for (std::size_t p = 0; p < table.properties.size(); ++p) {
    if (!table.properties[p].is_kept()) continue;
    for (const std::uint32_t row : source) {
      if (row == no_index)
        add_empty_row(out.properties[p]);
      else
        copy_row(table.properties[p], row, out.properties[p]);
    }
  }
  return out;
}

namespace {

// Rows of vertices or faces in the order of their new numbers.
PropertyTable reordered(const PropertyTable& table, std::span<const std::uint32_t> number, std::size_t new_rows) {
  std::vector<std::uint32_t> source(new_rows, no_index);
  for (std::size_t old = std::min(table.rows, number.size()); old-- > 0;)
    if (number[old] < new_rows) source[number[old]] = static_cast<std::uint32_t>(old);
  return rows_of(table, source);
}

class VertexNumbers {
 public:
  VertexNumbers(std::span<const std::uint32_t> number, std::size_t old_end, std::size_t new_end)
      : number_(number), old_end_(static_cast<std::int64_t>(old_end)), new_end_(static_cast<std::int64_t>(new_end)) {}

  static constexpr std::int64_t gone = -1;
  std::int64_t of(std::int64_t old) const {
    if (old < 0) return old;
    if (old >= old_end_) return past_new_end(old, old_end_, new_end_);
    const std::uint32_t number = number_[static_cast<std::size_t>(old)];
    return number == no_index ? gone : number;
  }
  bool is_gone(std::int64_t old) const { return old >= 0 && of(old) == gone; }

 private:
  std::span<const std::uint32_t> number_;
  std::int64_t old_end_, new_end_;
};

// Rows of an extra element, such as edges.
PropertyTable with_new_numbers(const PropertyTable& table, const VertexNumbers& numbers) {
  PropertyTable out = without_rows(table);
  for (std::size_t row = 0; row < table.rows; ++row) {
    const bool is_gone = std::any_of(table.properties.begin(), table.properties.end(), [&](const Property& p) {
      return p.role == PropertyRole::vertex_number && !p.is_list && numbers.is_gone(p.integer(row));
    });
    if (is_gone) continue;
    ++out.rows;
    for (std::size_t p = 0; p < table.properties.size(); ++p) {
      const Property& from = table.properties[p];
      Property& to = out.properties[p];
      if (from.role != PropertyRole::vertex_number) {
        copy_row(from, row, to);
        continue;
      }
      const std::size_t first = from.first_value(row);
      for (std::size_t i = first; i < first + from.value_count(row); ++i) to.append(numbers.of(from.integer(i)));
      if (to.is_list) to.ends.push_back(static_cast<std::uint32_t>(to.data.size() / bytes_of(to.type)));
    }
  }
  return out;
}

}  // namespace

double colour_scale(Scalar type) {
  if (is_floating(type)) return 1.0;
  return type == Scalar::uint16 || type == Scalar::int16 ? 65535.0 : 255.0;
}

std::int64_t Property::integer(std::size_t value) const { return load_as<std::int64_t>(*this, value); }
double Property::real(std::size_t value) const { return load_as<double>(*this, value); }
void Property::append(std::int64_t value) { append_as(*this, value); }
void Property::append(double value) { append_as(*this, value); }

bool PropertyTables::has_layout() const {
  return std::any_of(tables.begin(), tables.end(),
                     [](const PropertyTable& table) { return table.kind == TableKind::vertices; });
}

std::vector<std::int64_t> vertices_named(const PropertyTables& tables) {
  std::vector<std::int64_t> named;
  for (const PropertyTable& table : tables.tables)
    for (const Property& property : table.properties) {
      if (!table.is_further() || property.role != PropertyRole::vertex_number) continue;
      const std::size_t values = property.is_list ? property.ends.empty() ? 0 : property.ends.back() : table.rows;
      for (std::size_t i = 0; i < values; ++i) named.push_back(property.integer(i));
    }
  return named;
}

PropertyTables renumbered(const PropertyTables& tables, std::span<const std::uint32_t> vertex_number,
                          std::span<const std::uint32_t> face_number, std::size_t old_vertices,
                          std::size_t new_vertices, std::size_t new_faces) {
  PropertyTables out;
  out.obj_info = tables.obj_info;
  out.unknown_lines = tables.unknown_lines;
  out.has_decimal_reals = tables.has_decimal_reals;
  const VertexNumbers numbers(vertex_number, std::min(old_vertices, vertex_number.size()), new_vertices);
  for (const PropertyTable& table : tables.tables) {
    if (table.kind == TableKind::vertices)
      out.tables.push_back(reordered(table, vertex_number, new_vertices));
    else if (table.kind == TableKind::faces)
      out.tables.push_back(reordered(table, face_number, new_faces));
    else
      out.tables.push_back(with_new_numbers(table, numbers));
  }
  return out;
}

PropertyTables with_faces_of(const PropertyTables& tables, std::span<const std::uint32_t> old_face) {
  PropertyTables out = tables;
  for (PropertyTable& table : out.tables)
    if (table.kind == TableKind::faces) table = rows_of(table, old_face);
  return out;
}

}  // namespace ryosen
