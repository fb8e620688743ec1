// A string that lives as long as the program, in one pointer.
#pragma once

#include <string_view>

namespace ryosen {

// Compares by its characters. Make it of literals alone.
class StaticName {
 public:
  constexpr StaticName(const char* text = "") : text_(text) {}

  constexpr operator std::string_view() const { return text_; }
  friend constexpr bool operator==(StaticName a, StaticName b) {
    return std::string_view(a.text_) == std::string_view(b.text_);
  }

 private:
  const char* text_;
};

}  // namespace ryosen
