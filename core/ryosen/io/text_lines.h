// Splits the bytes of a text file into lines, ended by LF, CRLF or CR.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/io/reporter.h"

namespace ryosen {

// The UTF-8 byte order mark that some programs write first.
inline constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

// One line without its line end. `text` is valid until the next line is read, and is followed by a line end: LF, or CR
// LF.
struct TextLine {
  std::string_view text;
  std::uint64_t number = 0;  // from 1; of the first one if joined
};

// A single pass over a text. With `join_continuations` a line that ends in a backslash is joined with the next one by a
// space, unless its first character is #. A line of numbers (v, vt, vn, f, l, p) may have blanks behind its backslash;
// in a name they end it. Cost: O(bytes), no allocation for ordinary lines.
class TextLines {
 public:
  // `lines_before`: number of lines of the file before these bytes; a byte order mark is only allowed at the start of
  // the file.
  TextLines(std::string_view bytes, bool join_continuations, std::uint64_t lines_before = 0);

  bool next(TextLine& line);
  // The text of the next non-blank line.
  bool next_filled(std::string_view& text);

  // Passes over so many bytes, which are so many whole lines.
  void skip(std::size_t bytes, std::uint64_t lines) {
    at_ += bytes;
    count_ += lines;
  }

  // The place in the file of a character of the current line; `at` may be one past its end.
  FilePlace place(const char* at) const;

  // Calls visit(text, line number) for each line that was joined to the first one of the current line.
  template <class Visit>
  void for_each_continuation(Visit visit) const {
    for (std::size_t i = 1; is_joined_ && i < pieces_.size(); ++i) {
      const std::size_t end = i + 1 < pieces_.size() ? pieces_[i + 1].offset : joined_.size();
      visit(std::string_view(joined_).substr(pieces_[i].offset, end - pieces_[i].offset - 1), pieces_[i].number);
    }
  }

  // The number of the current line; of the first one if joined.
  std::uint64_t first_line() const { return is_joined_ ? pieces_.front().number : count_; }
  // The number of lines read so far.
  std::uint64_t count() const { return count_; }
  // Where the next line begins, in bytes of the file.
  std::uint64_t next_byte() const { return static_cast<std::uint64_t>(at_ - begin_); }

 private:
  struct Piece {
    std::size_t offset = 0;  // in joined_
    std::uint64_t number = 0;
  };

  std::string_view take();
  void join(std::string_view first);

  const char* begin_;
  const char* end_;
  const char* at_;
  const char* line_begin_;
  // The first CR and LF at or after at_, end_ if there is none; cached, so that a file without one is searched only
  // once.
  const char* next_cr_;
  const char* next_lf_;
  bool join_continuations_;
  bool is_joined_ = false;
  bool has_plain_end_ = false;  // the current line ends in LF or CRLF
  std::uint64_t count_ = 0;
  std::string joined_;
  std::vector<Piece> pieces_;
};

// Removes and returns the next word of `text`, up to a space or tab. Empty at the end.
inline std::string_view take_word(std::string_view& text) {
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end && (*at == ' ' || *at == '\t')) ++at;
  const char* const begin = at;
  while (at != end && *at != ' ' && *at != '\t') ++at;
  text = {at, static_cast<std::size_t>(end - at)};
  return {begin, static_cast<std::size_t>(at - begin)};
}

// Parses and removes the next word of `text` if std::from_chars accepts all of it; else leaves `text` unchanged. The
// fast path for ordinary numbers.
template <class Number>
bool take_number(std::string_view& text, Number& value) {
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end && (*at == ' ' || *at == '\t')) ++at;
  const auto [stop, error] = std::from_chars(at, end, value);
  if (error != std::errc() || (stop != end && *stop != ' ' && *stop != '\t')) return false;
  text = {stop, static_cast<std::size_t>(end - stop)};
  return true;
}

// Whether a word begins a line of OBJ with numbers alone behind it.
inline bool announces_numbers(std::string_view word) {
  return word == "v" || word == "vt" || word == "vn" || word == "f" || word == "l" || word == "p";
}

// Whether it contains only spaces and tabs.
inline bool is_blank(std::string_view text) { return text.find_first_not_of(" \t") == std::string_view::npos; }

// Warns about the lines after the last declared `what` (extra_data).
template <class NextLine>
void warn_of_lines_left(const TextLines& lines, Reporter& reporter, const Text& what, NextLine next_line) {
  if (!next_line()) return;
  const FilePlace first = FilePlace::at_line(lines.count());
  std::uint64_t count = 1;
  while (next_line()) ++count;
  reporter.leave_out(&LeftOut::rest, count);
  reporter.warn("extra_data", first, [&] {
    const std::string number = std::to_string(count);
    return Text{number + (count == 1 ? " line" : " lines") + " after the last announced " + what.en + " left out.",
                "宣言された最後の" + what.ja + "より後の " + number + " 行を無視しました。"};
  });
}

// `text` without leading and trailing spaces and tabs.
std::string_view trimmed(std::string_view text);

}  // namespace ryosen
