#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "ryosen/base/enum_table.h"
#include "ryosen/geometry/single_precision.h"
#include "ryosen/io/ply.h"
#include "ryosen/io/ply_attributes.h"
#include "ryosen/io/ply_columns.h"
#include "ryosen/io/text_lines.h"
#include "ryosen/io/text_out.h"

namespace ryosen {
namespace {

// Writes numbers as words of a line. Integral values are written as integers, whatever the type.
class PlyTextSink {
 public:
  explicit PlyTextSink(TextOut& out) : out_(out) {}

  // A float has the shortest digits of one; a decimal of a text in its place keeps its own.
  void real(Scalar type, double value) {
    blank();
    if (!is_floating(type))
      out_ << static_cast<std::int64_t>(value);
    else if (type == Scalar::float32 && to_single(value) == value)
      out_ << static_cast<float>(value);
    else
      out_ << value;
  }
  // A number as it lies in memory.
  void stored(Scalar type, const std::byte* at) {
    with_scalar(type, [&](auto number) {
      std::memcpy(&number, at, sizeof number);
      if constexpr (std::is_same_v<decltype(number), double>) {
        real(Scalar::float64, number);
      } else if constexpr (std::is_same_v<decltype(number), float>) {
        blank();
        out_ << number;
      } else if constexpr (std::is_same_v<decltype(number), std::uint64_t>) {
        blank();
        out_ << number;
      } else {
        whole(type, number);
      }
    });
  }
  void whole(Scalar, std::int64_t value) {
    blank();
    out_ << value;
  }
  void end_row() {
    out_ << '\n';
    is_first_ = true;
  }

 private:
  void blank() {
    if (!is_first_) out_ << ' ';
    is_first_ = false;
  }

  TextOut& out_;
  bool is_first_ = true;
};

class PlyBinarySink {
 public:
  PlyBinarySink(TextOut& out, bool swaps) : out_(out), swaps_(swaps) {}

  void real(Scalar type, double value) {
    with_scalar(type, [&](auto zero) { return put(static_cast<decltype(zero)>(value)); });
  }
  void stored(Scalar type, const std::byte* at) {
    with_scalar(type, [&](auto number) {
      std::memcpy(&number, at, sizeof number);
      return put(number);
    });
  }
  void whole(Scalar type, std::int64_t value) {
    with_scalar(type, [&](auto zero) {
      using Number = decltype(zero);
      if constexpr (std::is_floating_point_v<Number>) {
        return put(static_cast<Number>(value));
      } else {
        using Limits = std::numeric_limits<Number>;
        if (value < 0 && value < static_cast<std::int64_t>(Limits::lowest())) return put(Limits::lowest());
        if (value > 0 && static_cast<std::uint64_t>(value) > static_cast<std::uint64_t>(Limits::max()))
          return put(Limits::max());
        return put(static_cast<Number>(value));
      }
    });
  }
  void end_row() {}

 private:
  template <class Number>
  int put(Number number) {
    char bytes[sizeof number];
    std::memcpy(bytes, &number, sizeof number);
    if (swaps_) std::reverse(bytes, bytes + sizeof number);
    out_ << std::string_view(bytes, sizeof number);
    return 0;
  }

  TextOut& out_;
  bool swaps_;
};

class PlyWriter {
 public:
  PlyWriter(const MeshFile& file, Encoding encoding)
      : file_(file),
        encoding_(encoding == Encoding::automatic ? Encoding::binary_little : encoding),
        columns_(file, encoding_),
        out_(64 * file.mesh.positions.size() + 8 * file.mesh.corners.size()) {}

  std::string write() {
    header();
    if (encoding_ == Encoding::ascii) {
      PlyTextSink sink(out_);
      data(sink);
    } else {
      const bool is_big = encoding_ == Encoding::binary_big;
      PlyBinarySink sink(out_, is_big != (std::endian::native == std::endian::big));
      data(sink);
    }
    return out_.take();
  }

 private:
  void header() {
    struct Row {
      Encoding encoding;
      std::string_view name;
    };
    static constexpr Row rows[] = {{Encoding::automatic, ""},
                                   {Encoding::ascii, "ascii"},
                                   {Encoding::binary_little, "binary_little_endian"},
                                   {Encoding::binary_big, "binary_big_endian"}};
    static_assert(rows_are_in_order(rows, &Row::encoding));
    out_ << "ply\nformat " << rows[static_cast<std::size_t>(encoding_)].name << " 1.0\n";
    // Comments from another format include that format's comment marker.
    const bool came_from_ply = file_.properties.has_layout();
    for (const std::string& comment : file_.head_comments) {
      std::string_view text = comment;
      if (describes_an_attribute(text)) continue;  // as another one: that of now stands below
      if (!came_from_ply && text.starts_with('#')) text.remove_prefix(text.starts_with("# ") ? 2 : 1);
      out_ << "comment " << on_one_line(text) << '\n';
    }
    for (const PlyTable& table : columns_.tables())
      for (const PlyColumn& column : table.columns)
        if (column.attribute && !is_plain_in_ply(*column.attribute))
          out_ << "comment attribute " << words_of(*column.attribute) << '\n';
    for (const std::string& info : file_.properties.obj_info) out_ << "obj_info " << on_one_line(info) << '\n';
    unknown_lines(0, 0);
    std::uint32_t tables = 0;
    for (const PlyTable& table : columns_.tables()) {
      out_ << "element " << table.name << ' ' << table.rows << '\n';
      unknown_lines(++tables, 0);
      std::uint32_t properties = 0;
      for (const PlyColumn& column : table.columns) {
        out_ << "property ";
        if (column.is_list) out_ << "list " << name_of(column.count_type) << ' ';
        out_ << name_of(column.type) << ' ' << column.name << '\n';
        unknown_lines(tables, ++properties);
      }
      unknown_lines(tables, no_index);
    }
    out_ << "end_header\n";
  }

  // Whether a comment of the file is about an attribute of this name.
  bool describes_an_attribute(std::string_view text) const {
    if (take_word(text) != "attribute") return false;
    const std::string_view name = take_word(text);
    const std::vector<AttributeColumn>& all = file_.mesh.attributes;
    return std::any_of(all.begin(), all.end(), [&](const AttributeColumn& column) { return column.name == name; });
  }

  // Those that stood before this place, as far as they have not been written.
  void unknown_lines(std::uint32_t tables, std::uint32_t properties) {
    const std::vector<UnknownLines>& all = file_.properties.unknown_lines;
    for (; unknown_written_ < all.size(); ++unknown_written_) {
      const UnknownLines& lines = all[unknown_written_];
      if (std::pair(lines.tables, lines.properties) > std::pair(tables, properties)) break;
      out_ << lines.text;
    }
  }

  template <class Sink>
  void data(Sink& sink) {
    for (const PlyTable& table : columns_.tables()) {
      if (table.columns.empty()) continue;
      for (std::size_t row = 0; row < table.rows; ++row) {
        for (const PlyColumn& column : table.columns) {
          if (table.kind == TableKind::edges)
            edge_value(sink, column, table.edges[row]);
          else if (column.attribute)
            attribute_value(sink, column, row);
          else
            value(sink, column, row);
        }
        sink.end_row();
      }
    }
  }

  // The numbers of one value of an attribute.
  template <class Sink>
  void numbers(Sink& sink, const PlyColumn& column, const std::uint32_t* value) const {
    const auto* at = reinterpret_cast<const std::byte*>(value);
    for (std::uint32_t i = 0; i < column.attribute->type.count; ++i, at += bytes_of(column.type))
      sink.stored(column.type, at);
  }
  template <class Sink>
  void whole_value(Sink& sink, const PlyColumn& column, const std::uint32_t* value) const {
    if (column.is_list) sink.whole(column.count_type, column.attribute->type.count);
    numbers(sink, column, value);
  }

  template <class Sink>
  void attribute_value(Sink& sink, const PlyColumn& column, std::size_t row) const {
    const AttributeColumn& attribute = *column.attribute;
    if (attribute.element != ElementKind::corner)
      return whole_value(sink, column, attribute.data.data() + row * attribute.words());
    const std::size_t corners = columns_.corner_count(row);
    sink.whole(column.count_type, static_cast<std::int64_t>(corners * attribute.type.count));
    for (std::size_t i = 0; i < corners; ++i) numbers(sink, column, columns_.corner_value(column, row, i));
  }

  template <class Sink>
  void edge_value(Sink& sink, const PlyColumn& column, PlyEdgeRow row) const {
    const ListedEdge* const e = row.is_kept ? nullptr : &file_.mesh.edges[row.index];
    const AttributeColumn* const attribute = column.attribute;
    if (e && column.role == PropertyRole::vertex_number)
      return sink.whole(column.type, column.component == 0 ? e->from : e->to);
    if (e && attribute)
      return whole_value(sink, column, attribute->data.data() + std::size_t{row.index} * attribute->words());
    const bool has_kept = column.kept && row.is_kept &&
                          (!attribute || (column.kept->type == column.type && column.kept->is_list == column.is_list &&
                                          column.kept->value_count(row.index) == attribute->type.count));
    if (has_kept) return kept_values(sink, column, row.index);
    whole_value(sink, column, attribute->fill.data());
  }

  template <class Sink>
  void kept_values(Sink& sink, const PlyColumn& column, std::size_t row) const {
    const Property& kept = *column.kept;
    const std::size_t first = kept.first_value(row), count = kept.value_count(row);
    if (column.is_list) sink.whole(column.count_type, static_cast<std::int64_t>(count));
    for (std::size_t i = first; i < first + count; ++i) {
      if (column.type == kept.type)
        sink.stored(kept.type, kept.data.data() + i * bytes_of(kept.type));
      else if (is_floating(column.type))
        sink.real(column.type, kept.real(i));
      else
        sink.whole(column.type, kept.integer(i));
    }
  }

  template <class Sink>
  void value(Sink& sink, const PlyColumn& column, std::size_t row) const {
    if (column.kept) {
      kept_values(sink, column, row);
    } else if (column.role == PropertyRole::corners) {
      sink.whole(column.count_type, static_cast<std::int64_t>(columns_.corner_count(row)));
      columns_.for_each_corner(row, [&](std::int64_t corner) { sink.whole(column.type, corner); });
    } else if (column.role == PropertyRole::corner_texcoord) {
      const std::vector<glm::dvec3>& texcoords = columns_.corner_texcoords(row);
      sink.whole(column.count_type, static_cast<std::int64_t>(2 * texcoords.size()));
      const bool are_singles = column.type == Scalar::float32;  // reading makes them floats
      for (const glm::dvec3& texcoord : texcoords)
        for (const double number : {texcoord.x, texcoord.y})
          sink.real(column.type, are_singles ? to_single(number) : number);
    } else {
      sink.real(column.type, columns_.value(column, row));
    }
  }

  const MeshFile& file_;
  Encoding encoding_;
  PlyColumns columns_;
  TextOut out_;
  std::size_t unknown_written_ = 0;
};

}  // namespace

std::string write_ply(const MeshFile& file, Encoding encoding) { return PlyWriter(file, encoding).write(); }

}  // namespace ryosen
