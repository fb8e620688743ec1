#include "ryosen/io/text_lines.h"

#include <algorithm>
#include <cstring>

#include "ryosen/base/interruption.h"

namespace ryosen {
namespace {

const char* find(const char* begin, const char* end, char wanted) {
  const void* found = begin == end ? nullptr : std::memchr(begin, wanted, static_cast<std::size_t>(end - begin));
  return found ? static_cast<const char*>(found) : end;
}

bool is_comment(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first != std::string_view::npos && text[first] == '#';
}

// The length of a line without the backslash that joins it with the next one, and blanks behind that; all of it if it
// has none.
std::size_t length_before_joint(std::string_view text, bool allows_blanks) {
  const std::size_t last = allows_blanks ? text.find_last_not_of(" \t") : text.size() - 1;
  return last < text.size() && text[last] == '\\' ? last : text.size();
}

// Nearly no line ends so, and most in neither of these characters.
bool goes_on_behind(std::string_view text) {
  if (text.empty() || (text.back() != '\\' && text.back() != ' ' && text.back() != '\t')) return false;
  const std::size_t last = text.find_last_not_of(" \t");
  if (last == std::string_view::npos || text[last] != '\\') return false;
  return last + 1 == text.size() ? !is_comment(text) : announces_numbers(take_word(text));
}

}  // namespace

TextLines::TextLines(std::string_view bytes, bool join_continuations, std::uint64_t lines_before)
    : begin_(bytes.data()),
      end_(bytes.data() + bytes.size()),
      at_(begin_),
      line_begin_(begin_),
      next_cr_(find(begin_, end_, '\r')),
      next_lf_(find(begin_, end_, '\n')),
      join_continuations_(join_continuations),
      count_(lines_before) {
  if (lines_before == 0 && bytes.starts_with(byte_order_mark)) at_ += byte_order_mark.size();
}

// The next physical line.
std::string_view TextLines::take() {
  const char* const begin = at_;
  if (next_lf_ < begin) next_lf_ = find(begin, end_, '\n');
  const char* stop = next_lf_;
  if (next_cr_ < begin) next_cr_ = find(begin, end_, '\r');
  if (next_cr_ < stop && next_cr_ + 1 != stop) {  // ended by CR alone
    stop = next_cr_;
    at_ = stop + 1;
    has_plain_end_ = false;
  } else {
    at_ = stop == end_ ? end_ : stop + 1;
    has_plain_end_ = stop != end_;
    if (next_cr_ < stop) --stop;
  }
  ++count_;
  return {begin, static_cast<std::size_t>(stop - begin)};
}

// Joins a line and its continuations in joined_.
void TextLines::join(std::string_view first) {
  joined_.clear();
  pieces_.clear();
  std::string_view words = first;
  const bool allows_blanks = announces_numbers(take_word(words));
  std::string_view text = first;
  while (true) {
    pieces_.push_back({joined_.size(), count_});
    const std::size_t length = length_before_joint(text, allows_blanks);
    joined_ += text.substr(0, length);
    if (length == text.size() || at_ == end_) break;
    joined_ += ' ';
    text = take();
  }
  joined_ += '\n';
}

bool TextLines::next_filled(std::string_view& text) {
  for (TextLine line; next(line);) {
    if (is_blank(line.text)) continue;
    text = line.text;
    return true;
  }
  return false;
}

bool TextLines::next(TextLine& line) {
  if (at_ == end_) return false;
  line_begin_ = at_;
  const std::string_view text = take();
  stop_if_interrupted(static_cast<std::uint32_t>(count_));
  line.number = count_;
  const bool goes_on = join_continuations_ && goes_on_behind(text);
  is_joined_ = goes_on || !has_plain_end_;
  if (!is_joined_) {
    line.text = text;
    return true;
  }
  if (goes_on) {
    join(text);
  } else {
    joined_.assign(text);
    joined_ += '\n';
    pieces_.assign(1, Piece{0, count_});
  }
  line.text = std::string_view(joined_).substr(0, joined_.size() - 1);
  return true;
}

FilePlace TextLines::place(const char* at) const {
  if (!is_joined_) return FilePlace::at_line(count_, static_cast<std::uint64_t>(at - line_begin_) + 1);
  const auto offset = static_cast<std::size_t>(at - joined_.data());
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), offset,
                                      [](std::size_t wanted, const Piece& piece) { return wanted < piece.offset; });
  const Piece& piece = *(after - 1);
  return FilePlace::at_line(piece.number, offset - piece.offset + 1);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace ryosen
