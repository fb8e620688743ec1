#include "ryosen/document/quarantine_text.h"

#include <algorithm>
#include <charconv>

namespace ryosen {

namespace {

std::optional<std::uint32_t> face_in(std::string_view name) {
  const std::size_t at = name.find('@');
  if (at != std::string_view::npos) name.remove_prefix(at + 1);
  if (!name.starts_with('f')) return std::nullopt;
  std::uint32_t face = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data() + 1, end, face);
  if (error != std::errc() || stop != end) return std::nullopt;
  return face;
}

}  // namespace

std::optional<Text> quarantine_text(std::span<const QuarantinedFace> quarantine, std::string_view name) {
  const auto number = face_in(name);
  if (!number) return std::nullopt;
  const auto face = std::lower_bound(quarantine.begin(), quarantine.end(), *number,
                                     [](const QuarantinedFace& a, std::uint32_t b) { return a.face < b; });
  if (face == quarantine.end() || face->face != *number) return std::nullopt;
  Text text = face->cause();
  const std::string line = std::to_string(face->line);
  text.en += " It has been since the file was read";
  text.ja += "ファイルを読み込んだときからです";
  text.en += face->line > 0 ? " (line " + line + ")." : ".";
  text.ja += face->line > 0 ? "（" + line + " 行目）。" : "。";
  return text;
}

std::optional<Text> quarantine_text(std::span<const QuarantinedFace> quarantine,
                                    std::span<const std::string_view> names) {
  for (std::string_view name : names)
    if (auto sentence = quarantine_text(quarantine, name)) return sentence;
  return std::nullopt;
}

}  // namespace ryosen
