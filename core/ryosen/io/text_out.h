// Builds the text of a file in memory: words, integers, and decimals that round-trip exactly.
#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace ryosen {

class TextOut {
 public:
  explicit TextOut(std::size_t expected_bytes = 0) { text_.resize(expected_bytes + most_per_number); }

  TextOut& operator<<(std::string_view text) {
    make_room(text.size());
    if (!text.empty()) std::memcpy(text_.data() + size_, text.data(), text.size());
    size_ += text.size();
    return *this;
  }
  TextOut& operator<<(char c) {
    make_room(1);
    text_[size_++] = c;
    return *this;
  }
  // An integer, or the shortest decimal that std::from_chars reads as the same double or float; nan, -nan, inf, -inf.
  template <class Number>
  requires std::integral<Number> || std::floating_point<Number> TextOut& operator<<(Number value) {
    make_room(most_per_number);
    char* const begin = text_.data() + size_;
    size_ += static_cast<std::size_t>(std::to_chars(begin, begin + most_per_number, value).ptr - begin);
    return *this;
  }
  // The shortest decimal, with a decimal point if it would look like an integer.
  TextOut& put_real(double value) {
    const std::size_t begin = size_;
    *this << value;
    const bool is_whole = std::string_view(text_.data() + begin, size_ - begin).find_first_not_of("-0123456789") ==
                          std::string_view::npos;
    return is_whole ? *this << ".0" : *this;
  }

  bool is_empty() const { return size_ == 0; }
  std::string take() {
    text_.resize(size_);
    return std::move(text_);
  }

 private:
  static constexpr std::size_t most_per_number = 32;

  void make_room(std::size_t bytes) {
    if (text_.size() - size_ < bytes) text_.resize(2 * text_.size() + bytes);
  }

  std::string text_;
  std::size_t size_ = 0;
};

// `text` with line ends and NUL replaced by spaces, so that it stays on one line.
inline std::string on_one_line(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c == '\n' || c == '\r' || c == '\0') c = ' ';
  return out;
}

}  // namespace ryosen
