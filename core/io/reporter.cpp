#include "core/io/reporter.h"

#include <algorithm>
#include <limits>

#include "core/base/utf8.h"

namespace ryosen {
namespace {

// Length of the UTF-8 character at the start, 0 if invalid or a control character.
std::size_t character_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  return first < 0x20 || first == 0x7f ? 0 : utf8_length(text);
}

std::uint64_t order_of(const Message& message) {
  constexpr std::uint64_t last = std::numeric_limits<std::uint64_t>::max();
  return message.line.value_or(message.byte.value_or(last));
}

}  // namespace

Message make_message(Severity severity, Code code, Text text, FilePlace place) {
  Message message;
  message.severity = severity;
  message.code = code;
  message.text = std::move(text);
  if (place.line != 0) message.line = place.line;
  if (place.column != 0) message.column = place.column;
  if (place.byte_given) message.byte = place.byte;
  if (place.face_given) message.face = place.face;
  return message;
}

Failure malformed(Code code, Text text, FilePlace place) {
  return {ExitCode::input_malformed, make_message(Severity::error, code, std::move(text), place)};
}

std::string shown(std::string_view token) {
  constexpr std::size_t limit = 40;
  std::string out = "\"";
  while (!token.empty() && out.size() <= limit) {
    const std::size_t length = character_length(token);
    if (length == 0) {
      out += '?';
    } else {
      out += token.substr(0, length);
    }
    token.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out + (token.empty() ? "\"" : "...\"");
}

std::size_t Reporter::count(Code code) {
  for (auto& [known, number] : counts_) {
    if (known == code) return ++number;
  }
  counts_.emplace_back(code, 1);
  return 1;
}

std::vector<Message> Reporter::take() {
  std::stable_sort(messages_.begin(), messages_.end(),
                   [](const Message& a, const Message& b) { return order_of(a) < order_of(b); });
  for (const auto& [code, number] : counts_) {
    if (number <= listed_per_code) continue;
    const std::string rest = std::to_string(number - listed_per_code);
    messages_.push_back(make_message(Severity::warning, code,
                                     {rest + " more warnings of the kind " + std::string(code) + " are not listed.",
                                      "同じ種類(" + std::string(code) + ")の警告がほかに " + rest + " 件あります。"}));
  }
  counts_.clear();
  return std::move(messages_);
}

}  // namespace ryosen
