// Reader for ascii PLY: one row per line, or number by number.
#include <algorithm>
#include <cmath>
#include <limits>

#include "ryosen/io/numbers.h"
#include "ryosen/io/ply_builder.h"
#include "ryosen/io/reporter.h"
#include "ryosen/io/text_lines.h"

namespace ryosen {
namespace {

enum class PlyLayout { lines, words };

// Every step returns false where nothing more can be read; what reads a row or less, where that has a fault.
class PlyTextReader {
 public:
  PlyTextReader(std::string_view bytes, const PlyHeader& header, PlyBuilder& builder, PlyLayout layout)
      : bytes_(bytes),
        header_(header),
        builder_(builder),
        lines_(bytes, false),
        are_words_(layout == PlyLayout::words) {}

  std::optional<Failure> read() {
    read_tables();
    if (faults_.any()) return faults_.take();
    warn_of_lines_left(lines_, builder_.reporter(), {"row", "行"}, [this] { return next_line(); });
    return std::nullopt;
  }

  // Whether the numbers come out exactly.
  bool read_exactly() {
    read_tables();
    if (faults_.any() || has_number()) return false;
    if (first_spread_ != 0) warn_of_spread_rows();
    return true;
  }

 private:
  void read_tables() {
    TextLine line;
    for (std::uint64_t i = 0; i < header_.lines; ++i) lines_.next(line);
    for (std::size_t t = 0; t < builder_.tables().size(); ++t) {
      if (!read_table(t)) break;
    }
  }

  void warn_of_spread_rows() {
    builder_.reporter().warn("read_by_words", FilePlace::at_line(first_spread_), [] {
      return Text{
          "Rows do not stand on a line each; the file was read number by number, and all its counts come out at its "
          "end.",
          "1 行に 1 "
          "要素ずつ並んでいないため、数の並びとして読みました。個数はファイルの終わりでちょうど合っています。"};
    });
  }

  bool fail(Code code, Text text, FilePlace place) { return faults_.stop(malformed(code, std::move(text), place)); }

  bool next_line() { return lines_.next_filled(rest_); }

  // Goes on to the next line that has a number if the current one has no more.
  bool has_number() { return !is_blank(rest_) || next_line(); }

  // Where a row begins and its numbers are not laid out by lines.
  bool begin_row_anywhere() {
    const bool is_amid_line = !is_blank(rest_);
    if (!has_number()) return false;
    if (is_amid_line) note_spread();
    return true;
  }
  void note_spread() {
    if (first_spread_ == 0) first_spread_ = row_line_;
  }
  bool begin_row() {
    const bool begins = are_words_ ? begin_row_anywhere() : next_line();
    row_line_ = lines_.count();
    return begins;
  }

  bool read_table(std::size_t number) {
    PropertyTable& table = builder_.tables()[number];
    const std::size_t amid_line = are_words_ ? rest_.size() + 1 : 0;  // what the last table has left of its line
    const std::size_t least_bytes = 2 * table.properties.size(),
                      left = bytes_.size() - lines_.next_byte() + 1 + amid_line;
    if (is_absurd(table.rows, least_bytes, left)) {
      return faults_.stop(ply_count_too_large(header_, number));
    }
    if (table.properties.empty()) return true;
    const std::size_t rows = table.rows;
    table.rows = std::min(rows, left / least_bytes + 1);  // at most what fits, plus one incomplete row
    const bool has_first = rows != 0 && begin_row();
    targets_ = builder_.begin_table(number, FilePlace::at_line(lines_.count()));
    table.rows = rows;
    for (std::size_t row = 0; row < rows; ++row) {
      if (row == 1 && !faults_.any() && !are_words_) row += read_plain(table, rows - 1);
      if (row == rows) break;
      if (row == 0 ? !has_first : !begin_row())
        return faults_.stop(ply_early_end(table, row, FilePlace::at_line(lines_.count() + 1)));
      if (!read_row(table, row) && (are_words_ || faults_.is_stopped())) return false;
    }
    return true;
  }

  // Returns the number of rows read behind the first one.
  std::size_t read_plain(PropertyTable& table, std::size_t most) {
    const std::string_view text = bytes_.substr(lines_.next_byte());
    const PlainRows read = read_plain_rows(text, table, targets_, 1, most, lines_.count(), builder_);
    lines_.skip(read.bytes, read.rows);
    return read.rows;
  }

  bool read_row(PropertyTable& table, std::size_t row) {
    is_finite_ = true;
    for (std::size_t p = 0; p < table.properties.size(); ++p) {
      Property& property = table.properties[p];
      if (property.is_list ? !read_list(property) : !read_scalar(property, targets_[p], row)) return false;
    }
    if (faults_.any()) return false;
    if (strip_corners(table)) builder_.note_strip(row_line_);
    if (table.kind == TableKind::vertices) builder_.mesh().vertex_lines.add(row_line_);
    if (!is_finite_) builder_.warn_non_finite(FilePlace::at_line(row_line_));
    if (are_words_ && lines_.count() != row_line_) note_spread();
    if (!are_words_ && !is_blank(rest_)) warn_of_extra_values(builder_.reporter(), FilePlace::at_line(row_line_));
    return true;
  }

  bool read_scalar(Property& property, const PlyTarget& target, std::size_t row) {
    if (!target.first) return read_kept(property);
    if (are_words_) has_number();
    const std::string_view before = rest_;
    double value = 0;
    if (!read_number(value)) return false;
    is_finite_ = is_finite_ && std::isfinite(value);
    if (!is_floating(property.type) && bytes_of(property.type) == 8 && !is_read_exactly(before))
      builder_.warn_rounded(lines_.place(before.data()));
    if (!faults_.any()) target.put(row, value);  // rows with faults may be more than there is room for
    return true;
  }

  // Whether a leading integer is exactly representable as a double; true for anything else.
  static bool is_read_exactly(std::string_view text) {
    std::int64_t value = 0;
    std::uint64_t large = 0;
    if (take_number(text, value)) return is_exact_double(value);
    return !take_number(text, large) || is_exact_double(large);
  }

  bool missing() {
    return faults_.add("missing_number", lines_.place(rest_.data()), [] {
      return Text{"The line has too few numbers.", "この行の数が足りません。"};
    });
  }
  bool unreadable(std::string_view word) {
    return faults_.add("unreadable_number", lines_.place(word.data()), [&] { return not_a_number(word); });
  }

  bool read_number(double& value) {
    if (take_number(rest_, value)) return true;
    const std::string_view word = take_word(rest_);
    if (word.empty()) return missing();
    return read_real(word, value) != NumberRead::unreadable || unreadable(word);
  }

  bool read_whole(std::int64_t& value) {
    if (take_number(rest_, value)) return true;
    const std::string_view word = take_word(rest_);
    if (word.empty()) return missing();
    if (read_integer(word, value)) return true;
    return faults_.add("unreadable_index", lines_.place(word.data()), [&] { return not_a_whole_number(word); });
  }

  // Reads a value into Property::data. Integers must fit their type and may be written with a zero fraction.
  bool read_kept(Property& property) {
    if (are_words_) has_number();
    if (is_floating(property.type)) {
      double value = 0;
      if (!read_number(value)) return false;
      property.append(value);
      return true;
    }
    if (property.type == Scalar::uint64) {
      std::uint64_t large = 0;
      if (take_number(rest_, large)) return property.append(static_cast<std::int64_t>(large)), true;
    }
    const std::string_view before = rest_;
    std::int64_t value = 0;
    double real = 0;
    if (!take_number(rest_, value)) {
      if (!read_number(real)) return false;
      constexpr double limit = 9e18;
      if (!(real > -limit && real < limit) || std::trunc(real) != real) return out_of_type(before, property);
      value = static_cast<std::int64_t>(real);
    }
    const std::size_t at = property.data.size() / bytes_of(property.type);
    property.append(value);
    return property.integer(at) == value || out_of_type(before, property);
  }

  bool out_of_type(std::string_view rest, const Property& property) {
    const std::string_view word = take_word(rest);
    return faults_.add("number_out_of_type", lines_.place(word.data()), [&] {
      const std::string type(name_of(property.type));
      return Text{shown(word) + " does not fit the type " + type + " of " + shown(property.name) + ".",
                  shown(word) + " は " + shown(property.name) + " の型 " + type + " に収まりません。"};
    });
  }

  bool read_list(Property& property) {
    if (are_words_) has_number();
    const std::string_view before = rest_;
    std::int64_t count = 0;
    if (!read_whole(count)) return false;
    if (count < 0) {
      std::string_view rest = before;
      return faults_.add("negative_count", lines_.place(take_word(rest).data()), [] {
        return Text{"The length of a list is negative.", "リストの長さが負です。"};
      });
    }
    const bool are_corners = property.role == PropertyRole::corners;
    if (faults_.any()) property.data.clear();  // nothing is kept any more
    if (are_corners && builder_.faces().is_full(rest_.size()))
      return faults_.stop(too_many_corners(FilePlace::at_line(row_line_)));
    for (std::int64_t i = 0; i < count; ++i) {
      if (is_blank(rest_) && !(are_words_ && next_line())) return short_list(count, i);
      std::int64_t vertex = 0;
      if (!are_corners) {
        if (!read_kept(property)) return false;
      } else {
        if (!read_whole(vertex)) return false;
        if (!faults_.any()) builder_.faces().add_corner(vertex);
      }
    }
    if (faults_.any()) return true;
    if (are_corners)
      builder_.faces().end_face(row_line_);
    else
      property.ends.push_back(static_cast<std::uint32_t>(property.data.size() / bytes_of(property.type)));
    return true;
  }

  bool short_list(std::int64_t count, std::int64_t there) {
    return faults_.add("short_face", lines_.place(rest_.data()), [&] {
      const std::string found = std::to_string(there), all = std::to_string(count);
      return Text{"The list announces " + all + " values and has " + found + ".",
                  "リストの値は " + all + " 個のはずですが " + found + " 個しかありません。"};
    });
  }

  std::string_view bytes_;
  const PlyHeader& header_;
  PlyBuilder& builder_;
  TextLines lines_;
  Faults faults_;
  std::string_view rest_;  // the rest of the current line
  std::vector<PlyTarget> targets_;
  bool is_finite_ = true;
  const bool are_words_;
  std::uint64_t row_line_ = 0;      // where the current row begins
  std::uint64_t first_spread_ = 0;  // the line of the first row that does not have one for itself
};

// In what is not laid out by lines damage would show by numbers that cannot be.
bool has_sound_faces(const IndexedMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    if (mesh.face(f).size() < 3) return false;
  const std::size_t vertices = mesh.positions.size();
  return std::all_of(mesh.corners.begin(), mesh.corners.end(), [&](std::uint32_t c) { return c < vertices; });
}

}  // namespace

std::optional<Failure> read_ply_text(std::string_view bytes, const PlyHeader& header, PlyBuilder& builder) {
  return PlyTextReader(bytes, header, builder, PlyLayout::lines).read();
}

bool read_ply_words(std::string_view bytes, const PlyHeader& header, PlyBuilder& builder) {
  // So many corners, of two bytes at least, fit the 32 bits of their numbering whatever comes.
  if (bytes.size() / 2 >= no_index) return false;
  return PlyTextReader(bytes, header, builder, PlyLayout::words).read_exactly() && has_sound_faces(builder.mesh());
}

}  // namespace ryosen
