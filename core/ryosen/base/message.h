// User messages in both languages, with the place in a file that they refer to.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "ryosen/base/codes.h"

namespace ryosen {

enum class Language { english, japanese };

// One sentence in English and in Japanese; both are always present.
struct Text {
  std::string en;
  std::string ja;

  const std::string& in(Language language) const { return language == Language::japanese ? ja : en; }
};
inline Text operator+(const Text& a, const Text& b) { return {a.en + b.en, a.ja + b.ja}; }
inline Text& operator+=(Text& a, const Text& b) { return a = a + b; }

enum class Severity { info, warning, error };

// A message about an input or an output. At most one of line (from 1), byte (from 0) and face (number) is set; column
// (from 1) goes with line.
struct Message {
  Severity severity = Severity::error;
  Code code = "internal_error";
  Text text;
  std::optional<std::uint64_t> line;
  std::optional<std::uint64_t> column;
  std::optional<std::uint64_t> byte;
  std::optional<std::uint64_t> face;
};

}  // namespace ryosen
