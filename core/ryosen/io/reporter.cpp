#include "ryosen/io/reporter.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

#include "ryosen/base/utf8.h"

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
    if (length == 0)
      out += '?';
    else
      out += token.substr(0, length);
    token.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out + (token.empty() ? "\"" : "...\"");
}

std::size_t Reporter::count(Code code) {
  for (auto& [known, number] : counts_)
    if (known == code) return ++number;
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

void Faults::count(FilePlace place) {
  const std::uint64_t at = place.byte_given ? place.byte : place.line;
  if (count_ != 0 && at == last_) return;
  last_ = at;
  if (count_ < most_named) named_[count_] = at;
  ++count_;
}

Failure Faults::take() {
  if (count_ > 1) {
    const std::size_t named = std::min<std::size_t>(count_, most_named);
    std::string list_en, list_ja;
    for (std::size_t i = 0; i < named; ++i) {
      list_en += (i == 0 ? "" : i + 1 == count_ ? " and " : ", ") + std::to_string(named_[i]);
      list_ja += (i == 0 ? "" : "、") + std::to_string(named_[i]);
    }
    const std::string all = std::to_string(count_), more = std::to_string(count_ - named);
    const bool are_lines = failure_->message.line.has_value();
    Text& text = failure_->message.text;
    text.en += " " + all + " such places: " + (are_lines ? "lines " : "bytes ") + list_en +
               (count_ == named ? "." : " and " + more + " more.");
    text.ja += "同様の箇所は全部で " + all + " か所あります: " + list_ja + (are_lines ? " 行目" : " バイト目") +
               (count_ == named ? "。" : "、ほか " + more + " か所。");
  }
  return std::move(*failure_);
}

std::optional<Failure> refuse_nul_bytes(std::string_view bytes) {
  const void* const first = bytes.empty() ? nullptr : std::memchr(bytes.data(), 0, bytes.size());
  if (!first) return std::nullopt;
  Faults faults;
  for (auto at = static_cast<std::size_t>(static_cast<const char*>(first) - bytes.data()); at != std::string_view::npos;
       at = bytes.find('\0', at + 1)) {
    faults.add("nul_byte", FilePlace::at_byte(at), [] {
      return Text{"The file holds a NUL byte; it is not a text file or it is damaged.",
                  "ファイルに NUL バイトがあります。テキストファイルでないか、壊れています。"};
    });
  }
  return faults.take();
}

Failure empty_file() {
  return malformed("empty_file", {"The file is empty, it has no vertices.", "ファイルが空です。頂点がありません。"},
                   FilePlace::at_byte(0));
}

Failure too_many_corners(FilePlace place) {
  return malformed(
      "too_many_elements",
      {"The file has more corners than fit in 32-bit numbers.", "面の頂点の総数が 32 ビットの番号に収まりません。"},
      place);
}

Text sentence_of(const WordFault& fault) {
  const std::string word = shown(fault.word);
  return Text{word, word} + fault.rest + Text{".", "。"};
}

Text not_a_number(std::string_view word) {
  return {shown(word) + " is not a number.", shown(word) + " は数として読めません。"};
}

Text not_a_whole_number(std::string_view word) {
  return {shown(word) + " is not a whole number.", shown(word) + " は整数として読めません。"};
}

Text not_a_finite_number(std::string_view word) {
  return {shown(word) + " is not a finite number.", shown(word) + " は有限の数ではありません。"};
}

void warn_of_non_finite_vertex(Reporter& reporter, FilePlace place) {
  reporter.warn("nonfinite_number", place, [] {
    return Text{"A number of a vertex is not finite.", "頂点に有限でない数があります。"};
  });
}

void warn_of_extra_values(Reporter& reporter, FilePlace place) {
  reporter.leave_out(&LeftOut::values);
  reporter.warn("extra_values", place, [] {
    return Text{"The line has more numbers than have a meaning; those too many are left out.",
                "この行には意味のある個数より多くの数があるため、余分な数を無視しました。"};
  });
}

void warn_of_missing_elements(Reporter& reporter, std::size_t vertices, std::size_t faces) {
  if (vertices == 0)
    reporter.warn("no_vertices", {}, [] { return Text{"The file has no vertices.", "ファイルに頂点がありません。"}; });
  if (faces == 0)
    reporter.warn("no_faces", {}, [] { return Text{"The file has no faces.", "ファイルに面がありません。"}; });
}

}  // namespace ryosen
