#include <algorithm>

#include "ryosen/io/numbers.h"
#include "ryosen/io/off.h"
#include "ryosen/io/off_builder.h"
#include "ryosen/io/reporter.h"
#include "ryosen/io/text_lines.h"

namespace ryosen {

std::optional<OffKind> OffKind::from_word(std::string_view word) {
  OffKind kind;
  bool has_fourth = false, has_dimension = false;
  struct Prefix {
    std::string_view letters;
    bool& is_there;
  };
  const Prefix prefixes[] = {{"ST", kind.has_texcoords},
                             {"C", kind.has_colours},
                             {"N", kind.has_normals},
                             {"4", has_fourth},
                             {"n", has_dimension}};
  // In any order, each once.
  const auto take_one = [&] {
    for (const Prefix& prefix : prefixes) {
      if (prefix.is_there || !word.starts_with(prefix.letters)) continue;
      word.remove_prefix(prefix.letters.size());
      return prefix.is_there = true;
    }
    return false;
  };
  while (take_one()) {
  }
  kind.is_three_dimensional = !has_fourth && !has_dimension;
  if (word != "OFF") return std::nullopt;
  return kind;
}

std::string_view off_count_behind(std::string_view word) {
  const std::size_t after = word.find_last_not_of("0123456789") + 1;
  return word.substr(0, after).ends_with("OFF") ? word.substr(after) : std::string_view();
}

Likeness looks_like_off(std::string_view head, std::uint64_t) {
  TextLines lines(head, false);
  TextLine line;
  while (lines.next(line)) {
    std::string_view rest = line.text;
    const std::string_view word = take_word(rest);
    if (word.empty() || word[0] == '#') continue;
    const std::string_view first = word.substr(0, word.find('#'));
    return OffKind::from_word(first.substr(0, first.size() - off_count_behind(first).size())) ? Likeness::sure
                                                                                              : Likeness::no;
  }
  return Likeness::no;
}
namespace {

// Reads the text form by lines. Every step returns false where nothing more can be read; what reads a line, where that
// has a fault.
class OffTextReader {
 public:
  OffTextReader(std::string_view bytes, TextLines& lines, OffKind kind)
      : bytes_(bytes), lines_(lines), builder_(kind) {}

  // Keeps the comments before the current line.
  void keep_comments(std::vector<std::string> comments) { builder_.file().head_comments = std::move(comments); }

  void warn_of_count_behind(std::string_view word) {
    builder_.reporter().warn("count_behind_word", lines_.place(word.data()), [&] {
      const std::string kind(word.substr(0, word.find_last_not_of("0123456789") + 1));
      return Text{shown(word) + " is read as the word " + kind + " and the count of vertices: a blank is missing.",
                  shown(word) + " を " + kind + " と頂点の個数として読みました(空白がありません)。"};
    });
  }

  // `head` is what follows the first word; the counts may stand there or on the next line.
  Result<MeshFile> read(std::string_view head) {
    rest_ = head;
    const bool done = read_counts() && read_vertices() && read_faces();
    if (!done || faults_.any()) return faults_.take();
    warn_of_lines_left(lines_, builder_.reporter(), {"face", "面"}, [this] { return next_line(); });
    return builder_.finish();
  }

 private:
  bool fail(Code code, Text text, FilePlace place) { return faults_.stop(malformed(code, std::move(text), place)); }

  // Advances to the next line that is not only a comment.
  bool next_line() {
    TextLine line;
    while (lines_.next(line)) {
      const std::size_t comment = std::min(line.text.find('#'), line.text.size());
      rest_ = line.text.substr(0, comment);
      if (in_head_ && comment != line.text.size())
        builder_.file().head_comments.emplace_back(line.text.substr(comment));
      if (!is_blank(rest_)) return true;
    }
    return false;
  }

  bool fail_at_end(const std::string& what_en, const std::string& what_ja) {
    return fail("unexpected_end",
                {"The file ends too early: " + what_en + ".", "ファイルが途中で終わっています: " + what_ja + "。"},
                FilePlace::at_line(lines_.count() + 1));
  }

  bool read_count(std::string_view word, std::size_t bytes_each, std::size_t& count) {
    std::int64_t value = 0;
    if (word.empty()) {
      return fail("missing_number",
                  {"The counts of vertices and faces are meant here.", "ここには頂点と面の個数が必要です。"},
                  lines_.place(word.data()));
    }
    if (!read_integer(word, value)) {
      return fail("unreadable_number", {shown(word) + " is not a count.", shown(word) + " は個数として読めません。"},
                  lines_.place(word.data()));
    }
    if (value < 0) {
      return fail("negative_count",
                  {"The count " + shown(word) + " is negative.", "個数 " + shown(word) + " が負です。"},
                  lines_.place(word.data()));
    }
    const std::size_t room = (bytes_.size() - lines_.next_byte() + 1) / bytes_each;
    if (static_cast<std::uint64_t>(value) > room || static_cast<std::uint64_t>(value) >= no_index) {
      return fail("count_too_large",
                  {"The count " + shown(word) + " is more than a file of this size can hold.",
                   "個数 " + shown(word) + " は、このファイルの大きさに収まりません。"},
                  lines_.place(word.data()));
    }
    count = static_cast<std::size_t>(value);
    return true;
  }

  bool read_counts() {
    if (is_blank(rest_) && !next_line())
      return fail_at_end("it has no counts of vertices and faces", "頂点と面の個数がありません");
    // The shortest vertex is "0 0 0" and a line end, the shortest face "0" and a line end. The third count, of edges,
    // is often wrong and never needed.
    constexpr std::size_t least_vertex_bytes = 6, least_face_bytes = 2;
    if (!read_count(take_word(rest_), least_vertex_bytes, vertex_count_)) return false;
    if (!read_count(take_word(rest_), least_face_bytes, face_count_)) return false;
    in_head_ = false;
    builder_.reserve(vertex_count_, face_count_);
    return true;
  }

  // Reads the numbers up to the end of the line into values_.
  bool read_reals() {
    values_.clear();
    for (std::string_view word = take_word(rest_); !word.empty(); word = take_word(rest_)) {
      double value = 0;
      const NumberRead read = read_real(word, value);
      if (read == NumberRead::unreadable)
        return faults_.add("unreadable_number", lines_.place(word.data()), [&] { return not_a_number(word); });
      if (read == NumberRead::non_finite) {
        builder_.reporter().warn("nonfinite_number", lines_.place(word.data()),
                                 [&] { return not_a_finite_number(word); });
      }
      values_.push_back(value);
    }
    return true;
  }

  void warn_extra_values() { warn_of_extra_values(builder_.reporter(), FilePlace::at_line(lines_.count())); }

  bool read_vertices() {
    const std::size_t wanted = builder_.numbers_before_colour() + builder_.numbers_after_colour();
    for (std::size_t v = 0; v < vertex_count_; ++v) {
      if (!next_line()) {
        const std::string there = std::to_string(v), claimed = std::to_string(vertex_count_);
        return fail_at_end("it has " + there + " of " + claimed + " vertices",
                           "頂点 " + claimed + " 個のうち " + there + " 個しかありません");
      }
      if (!read_reals() || !has_numbers(wanted) || faults_.any()) continue;
      if (!builder_.add_vertex(values_.data(), values_.size(), lines_.count())) warn_extra_values();
    }
    return true;
  }

  bool has_numbers(std::size_t wanted) {
    if (values_.size() >= wanted) return true;
    return faults_.add("missing_number", lines_.place(rest_.data()), [&] {
      const std::string there = std::to_string(values_.size()), all = std::to_string(wanted);
      return Text{"The vertex has " + there + " numbers where " + all + " are needed.",
                  "数が " + all + " 個必要な頂点に " + there + " 個しかありません。"};
    });
  }

  bool read_index(std::string_view word, std::int64_t& value) {
    if (read_integer(word, value)) return true;
    return faults_.add("unreadable_index", lines_.place(word.data()), [&] { return not_a_whole_number(word); });
  }

  bool read_face() {
    std::int64_t corners = 0;
    if (!read_index(take_word(rest_), corners)) return false;
    if (corners < 0) {
      return faults_.add("negative_count", FilePlace::at_line(lines_.count()), [] {
        return Text{"The number of corners is negative.", "面の頂点の個数が負です。"};
      });
    }
    for (std::int64_t i = 0; i < corners; ++i) {
      const std::string_view word = take_word(rest_);
      std::int64_t vertex = 0;
      if (word.empty()) {
        return faults_.add("short_face", lines_.place(word.data()), [&] {
          const std::string there = std::to_string(i), all = std::to_string(corners);
          return Text{"The face announces " + all + " corners and has " + there + ".",
                      "面の頂点は " + all + " 個のはずですが " + there + " 個しかありません。"};
        });
      }
      if (!read_index(word, vertex)) return false;
      if (!faults_.any()) builder_.add_corner(vertex);
    }
    const bool are_whole = rest_.find_first_not_of("+-0123456789 \t") == std::string_view::npos;
    if (!read_reals() || faults_.any()) return false;
    if (!builder_.end_face(lines_.count(), values_.data(), values_.size(), are_whole)) warn_extra_values();
    return true;
  }

  bool read_faces() {
    for (std::size_t f = 0; f < face_count_; ++f) {
      if (!next_line()) {
        const std::string there = std::to_string(f), claimed = std::to_string(face_count_);
        return fail_at_end("it has " + there + " of " + claimed + " faces",
                           "面 " + claimed + " 個のうち " + there + " 個しかありません");
      }
      if (builder_.is_full(rest_.size())) return faults_.stop(too_many_corners(FilePlace::at_line(lines_.count())));
      read_face();
    }
    return true;
  }

  std::string_view bytes_;
  TextLines& lines_;
  OffBuilder builder_;
  Faults faults_;
  std::string_view rest_;  // the rest of the current line, without its comment
  std::vector<double> values_;
  std::size_t vertex_count_ = 0, face_count_ = 0;
  bool in_head_ = true;  // the counts have not been read yet
};

Failure not_off(std::string_view word, FilePlace place) {
  return malformed("not_off",
                   {"The file begins with " + shown(word) + ", which is not OFF.",
                    "ファイルが " + shown(word) + " で始まっており、OFF ではありません。"},
                   place);
}

// By lines, as the format is meant.
Result<MeshFile> read_by_lines(std::string_view bytes) {
  TextLines lines(bytes, false);
  TextLine line;
  std::vector<std::string> comments;
  std::string_view rest, word;
  while (word.empty() && lines.next(line)) {
    const std::size_t comment = std::min(line.text.find('#'), line.text.size());
    if (comment != line.text.size()) comments.emplace_back(line.text.substr(comment));
    rest = line.text.substr(0, comment);
    word = take_word(rest);
  }
  if (word.empty()) return empty_file();
  const std::string_view behind = off_count_behind(word);
  std::optional<OffKind> kind = OffKind::from_word(word.substr(0, word.size() - behind.size()));
  if (kind && !behind.empty())
    rest = {behind.data(), static_cast<std::size_t>(rest.data() + rest.size() - behind.data())};
  // The keyword may be missing; then the file starts with the counts.
  std::int64_t count = 0;
  const bool begins_with_counts = !kind && read_integer(word, count);
  if (!kind && !begins_with_counts) return not_off(word, lines.place(word.data()));
  if (begins_with_counts) {
    kind = OffKind{};
    rest = {word.data(), static_cast<std::size_t>(rest.data() + rest.size() - word.data())};
  }
  if (!kind->is_three_dimensional) {
    return malformed("unsupported_dimension",
                     {"Only OFF with three coordinates is supported, not " + shown(word) + ".",
                      "3 次元の OFF だけに対応しています(" + shown(word) + " には未対応)。"},
                     lines.place(word.data()));
  }
  std::string_view after = rest;
  if (take_word(after) == "BINARY") return read_off_binary(bytes, lines.next_byte(), *kind);
  if (std::optional<Failure> refusal = refuse_nul_bytes(bytes)) return std::move(*refusal);
  OffTextReader reader(bytes, lines, *kind);
  reader.keep_comments(std::move(comments));
  if (!behind.empty()) reader.warn_of_count_behind(word);
  return reader.read(rest);
}

}  // namespace

Result<MeshFile> read_off(std::string_view bytes, const std::filesystem::path&) {
  Result<MeshFile> by_lines = read_by_lines(bytes);
  // What is no text has no lines.
  if (by_lines || !by_lines.failure().message.line) return by_lines;
  std::optional<MeshFile> by_words = read_off_words(bytes, *by_lines.failure().message.line);
  return by_words ? Result<MeshFile>(std::move(*by_words)) : std::move(by_lines);
}

}  // namespace ryosen
