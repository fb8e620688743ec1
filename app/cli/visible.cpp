#include "app/cli/visible.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "ryosen/base/utf8.h"

namespace ryosen::cli {

namespace {

std::uint32_t code_point(std::string_view character) {
  if (character.size() == 1) return static_cast<unsigned char>(character[0]);
  std::uint32_t code = static_cast<unsigned char>(character[0]) & (0x7fu >> character.size());
  for (const char c : character.substr(1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3fu);
  return code;
}

// A terminal would not show it at its place: a control character or one that changes the direction of writing.
bool is_control(std::uint32_t code) {
  const bool turns = code == 0x61c || code == 0x200e || code == 0x200f || (code >= 0x202a && code <= 0x202e) ||
                     (code >= 0x2066 && code <= 0x2069);
  const bool ends_line = code == 0x2028 || code == 0x2029;
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || turns || ends_line;
}

std::string escaped(std::string_view text, std::string_view kept) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    const std::uint32_t code = length == 0 ? static_cast<unsigned char>(text[0]) : code_point(character);
    if (length > 0 && (!is_control(code) || kept.find(character) != kept.npos)) {
      out += character;
    } else {
      char escape[8];
      std::snprintf(escape, sizeof escape, length > 1 ? "\\u%04x" : "\\x%02x", static_cast<unsigned>(code));
      out += escape;
    }
    text.remove_prefix(character.size());
  }
  return out;
}

}  // namespace

std::string visible(std::string_view text) { return escaped(text, "\n\t"); }

std::string visible_line(std::string_view text) { return escaped(text, {}); }

}  // namespace ryosen::cli
