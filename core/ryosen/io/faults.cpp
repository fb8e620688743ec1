#include "ryosen/io/faults.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace ryosen {

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

}  // namespace ryosen
