// Readers of the forms of OFF that are not laid out line by line: binary, and text word by word.
#include "ryosen/io/off_builder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "ryosen/io/numbers.h"
#include "ryosen/io/text_lines.h"

namespace ryosen {
namespace {

struct Layout {
  bool is_big_endian;
  bool has_face_colours;
};

// First the specification, then what programs write.
constexpr Layout layouts[] = {{true, true}, {false, false}, {false, true}, {true, false}};

// Reads 32-bit words from a byte range.
class Words {
 public:
  Words(std::string_view bytes, bool is_big_endian) : bytes_(bytes), is_big_endian_(is_big_endian) {}

  std::size_t left() const { return bytes_.size() / 4; }
  std::size_t left_bytes() const { return bytes_.size(); }
  void skip(std::size_t words) { bytes_.remove_prefix(4 * words); }
  // Precondition: left() > 0.
  std::uint32_t take() {
    unsigned char b[4];
    std::memcpy(b, bytes_.data(), 4);
    skip(1);
    std::uint32_t word = 0;
    for (int i = 0; i < 4; ++i) word = word << 8 | b[is_big_endian_ ? i : 3 - i];
    return word;
  }
  double take_real() { return static_cast<double>(std::bit_cast<float>(take())); }

 private:
  std::string_view bytes_;
  bool is_big_endian_;
};

struct Counts {
  std::uint32_t vertices = 0, faces = 0;
};

std::size_t words_per_vertex(OffKind kind) {
  return 3u + (kind.has_normals ? 3u : 0u) + (kind.has_colours ? 4u : 0u) + (kind.has_texcoords ? 2u : 0u);
}

// The counts, if the file is large enough for them.
std::optional<Counts> plausible_counts(Words& words, OffKind kind) {
  if (words.left() < 3) return std::nullopt;
  Counts counts;
  counts.vertices = words.take();
  counts.faces = words.take();
  words.skip(1);  // the number of edges, unused
  if (counts.vertices > words.left() / words_per_vertex(kind)) return std::nullopt;
  if (counts.faces > words.left() - counts.vertices * words_per_vertex(kind)) return std::nullopt;
  return counts;
}

// The number of bytes left over if all faces fit in the file and reference existing vertices, else none.
std::optional<std::size_t> bytes_over(std::string_view data, OffKind kind, Layout layout) {
  Words words(data, layout.is_big_endian);
  const std::optional<Counts> counts = plausible_counts(words, kind);
  if (!counts) return std::nullopt;
  words.skip(counts->vertices * words_per_vertex(kind));
  for (std::uint32_t f = 0; f < counts->faces; ++f) {
    if (words.left() == 0) return std::nullopt;
    const std::uint32_t corners = words.take();
    if (corners > words.left()) return std::nullopt;
    for (std::uint32_t i = 0; i < corners; ++i)
      if (words.take() >= counts->vertices) return std::nullopt;
    if (!layout.has_face_colours) continue;
    if (words.left() == 0) return std::nullopt;
    const std::uint32_t colours = words.take();
    if (colours > 4 || colours > words.left()) return std::nullopt;
    words.skip(colours);
  }
  return words.left_bytes();
}

MeshFile read_as(std::string_view bytes, std::uint64_t start, OffKind kind, Layout layout) {
  const std::string_view data = bytes.substr(start);
  Words words(data, layout.is_big_endian);
  const Counts counts = *plausible_counts(words, kind);
  OffBuilder builder(kind);
  builder.reserve(counts.vertices, counts.faces);
  const auto here = [&] { return static_cast<std::uint64_t>(bytes.size() - words.left_bytes()); };
  double values[12];
  for (std::uint32_t v = 0; v < counts.vertices; ++v) {
    const std::uint64_t byte = here();
    bool is_finite = true;
    for (std::size_t i = 0; i < words_per_vertex(kind); ++i) {
      values[i] = words.take_real();
      is_finite = is_finite && std::isfinite(values[i]);
    }
    if (!is_finite) warn_of_non_finite_vertex(builder.reporter(), FilePlace::at_byte(byte));
    builder.add_vertex(values, words_per_vertex(kind));
  }
  for (std::uint32_t f = 0; f < counts.faces; ++f) {
    const std::uint32_t corners = words.take();
    for (std::uint32_t i = 0; i < corners; ++i) builder.add_corner(words.take());
    const std::uint32_t colours = layout.has_face_colours ? words.take() : 0;
    for (std::uint32_t i = 0; i < colours; ++i) values[i] = words.take_real();
    if (!builder.end_face(0, values, colours, false)) {
      builder.reporter().leave_out(&LeftOut::values);
      builder.reporter().warn("extra_values", FilePlace::at_byte(here()), [] {
        return Text{"The colour of a face has two numbers, which has no meaning.",
                    "面の色の数が 2 個で意味を持ちません。"};
      });
    }
  }
  if (words.left_bytes() != 0) {
    builder.reporter().leave_out(&LeftOut::rest, words.left_bytes());
    builder.reporter().warn("extra_data", FilePlace::at_byte(here()), [&] {
      const std::string count = std::to_string(words.left_bytes());
      return Text{count + " bytes after the last face are left out.",
                  "最後の面の後の " + count + " バイトを無視しました。"};
    });
  }
  return builder.finish();
}

// Hands out the words of a file without its comments.
class WordStream {
 public:
  explicit WordStream(std::string_view bytes) : lines_(bytes, false) {}

  // Empty at the end. It is valid until the next call.
  std::string_view next() {
    std::string_view word = take_word(rest_);
    TextLine line;
    while (word.empty() && lines_.next(line)) {
      const std::size_t comment = std::min(line.text.find('#'), line.text.size());
      if (comments_ && comment != line.text.size()) comments_->emplace_back(line.text.substr(comment));
      rest_ = line.text.substr(0, comment);
      word = take_word(rest_);
      filled_lines_ += !word.empty();
    }
    return word;
  }
  // Where comments go; null: nowhere.
  void keep_comments(std::vector<std::string>* comments) { comments_ = comments; }
  std::uint64_t line() const { return lines_.count(); }
  // How many lines with words there were so far.
  std::uint64_t filled_lines() const { return filled_lines_; }

 private:
  TextLines lines_;
  std::uint64_t filled_lines_ = 0;
  std::string_view rest_;
  std::vector<std::string>* comments_ = nullptr;
};

// Goes over the file once. Without a builder it only finds out whether all is right.
class OffWordReader {
 public:
  OffWordReader(std::string_view bytes, std::size_t colours, OffBuilder* builder)
      : words_(bytes), colours_(colours), builder_(builder) {}

  bool read() {
    return read_head() && read_vertices() && read_faces() && words_.next().empty() && !is_laid_out_by_lines();
  }
  OffKind kind() const { return kind_; }
  std::uint64_t line() const { return words_.line(); }

 private:
  bool read_count(std::string_view word, std::int64_t& count) {
    return read_integer(word, count) && count >= 0 && count < std::int64_t{no_index};
  }

  // One line of counts and one for each vertex and face: where that cannot be read by lines it is damaged.
  bool is_laid_out_by_lines() const {
    return has_line_of_counts_ &&
           words_.filled_lines() - lines_of_head_ == static_cast<std::uint64_t>(vertices_ + faces_);
  }

  bool read_head() {
    if (builder_) words_.keep_comments(&builder_->file().head_comments);
    std::string_view word = words_.next();
    const std::string_view count = off_count_behind(word);
    word.remove_suffix(count.size());
    if (const std::optional<OffKind> kind = OffKind::from_word(word)) {
      kind_ = *kind;
      word = count.empty() ? words_.next() : count;
    }
    const std::uint64_t line_of_counts = words_.line();
    std::int64_t edges = 0;  // often wrong and never needed
    const bool done = kind_.is_three_dimensional && kind_.has_colours == (colours_ != 0) &&
                      read_count(word, vertices_) && read_count(words_.next(), faces_) &&
                      read_integer(words_.next(), edges);
    words_.keep_comments(nullptr);
    has_line_of_counts_ = count.empty() && words_.line() == line_of_counts;
    lines_of_head_ = words_.filled_lines();
    if (done && builder_) builder_->reserve(static_cast<std::size_t>(vertices_), static_cast<std::size_t>(faces_));
    return done;
  }

  bool read_vertices() {
    double values[12];
    const std::size_t count = 3u + (kind_.has_normals ? 3u : 0u) + colours_ + (kind_.has_texcoords ? 2u : 0u);
    for (std::int64_t v = 0; v < vertices_; ++v) {
      std::uint64_t line = 0;
      for (std::size_t i = 0; i < count; ++i) {
        const std::string_view word = words_.next();
        if (i == 0) line = words_.line();
        const NumberRead read = read_real(word, values[i]);
        if (read == NumberRead::unreadable) return false;
        if (read == NumberRead::non_finite && builder_) warn_non_finite(word);
      }
      if (builder_) builder_->add_vertex(values, count, line);
    }
    return true;
  }

  bool read_faces() {
    for (std::int64_t f = 0; f < faces_; ++f) {
      std::int64_t corners = 0;
      if (!read_count(words_.next(), corners) || corners < 3) return false;
      const std::uint64_t line = words_.line();
      for (std::int64_t i = 0; i < corners; ++i) {
        std::int64_t vertex = 0;
        if (!read_count(words_.next(), vertex) || vertex >= vertices_) return false;
        if (builder_) builder_->add_corner(vertex);
      }
      if (builder_) builder_->end_face(line, nullptr, 0, false);
    }
    return true;
  }

  void warn_non_finite(std::string_view word) {
    builder_->reporter().warn("nonfinite_number", FilePlace::at_line(words_.line()),
                              [&] { return not_a_finite_number(word); });
  }

  WordStream words_;
  std::size_t colours_;
  OffBuilder* builder_;
  OffKind kind_;
  std::int64_t vertices_ = 0, faces_ = 0;
  bool has_line_of_counts_ = false;
  std::uint64_t lines_of_head_ = 0;
};

}  // namespace

Result<MeshFile> read_off_binary(std::string_view bytes, std::uint64_t start, OffKind kind) {
  const std::string_view data = bytes.substr(start);
  std::optional<std::size_t> least;
  Layout best{};
  for (const Layout layout : layouts) {
    const std::optional<std::size_t> over = bytes_over(data, kind, layout);
    if (!over || (least && *over >= *least)) continue;
    least = over;
    best = layout;
  }
  if (least) return read_as(bytes, start, kind, best);
  return malformed("count_too_large",
                   {"The file is shorter than its binary counts claim, or its indices make no sense.",
                    "バイナリーの個数に対してファイルが短すぎるか、番号が不正です。"},
                   FilePlace::at_byte(start));
}

std::optional<MeshFile> read_off_words(std::string_view bytes, std::uint64_t line) {
  // So many corners, of two bytes at least, fit the 32 bits of their numbering whatever comes.
  if (bytes.size() / 2 >= no_index) return std::nullopt;
  for (const std::size_t colours : {0u, 4u, 3u}) {
    OffWordReader trial(bytes, colours, nullptr);
    if (!trial.read()) continue;
    OffBuilder builder(trial.kind());
    OffWordReader(bytes, colours, &builder).read();
    builder.reporter().warn("read_by_words", FilePlace::at_line(std::min(line, trial.line())), [] {
      return Text{
          "Vertices and faces do not stand on a line each; the file was read word by word, and all its counts "
          "come out at its end.",
          "頂点と面が 1 行に 1 つずつ並んでいないため、語の並びとして読みました。個数はファイルの終わりで"
          "ちょうど合っています。"};
    });
    return builder.finish();
  }
  return std::nullopt;
}

}  // namespace ryosen
