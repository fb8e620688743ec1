#include "ryosen/io/off_words.h"

#include <algorithm>
#include <string>
#include <vector>

#include "ryosen/io/numbers.h"
#include "ryosen/io/off_builder.h"
#include "ryosen/io/text_lines.h"

namespace ryosen {
namespace {

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
