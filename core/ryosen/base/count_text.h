// Sentences with a number in them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "ryosen/base/message.h"

namespace ryosen {

// A sentence with a number in the place of its first #.
inline std::string with_number(std::string_view sentence, std::uint64_t number) {
  std::string text(sentence);
  if (const std::size_t place = text.find('#'); place != text.npos) text.replace(place, 1, std::to_string(number));
  return text;
}

// What is said of `count` things: in English the first sentence of one and the second of any other number.
inline Text count_text(std::uint64_t count, std::string_view en_one, std::string_view en_many, std::string_view ja) {
  return {with_number(count == 1 ? en_one : en_many, count), with_number(ja, count)};
}

}  // namespace ryosen
