#include "ryosen/document/outcome.h"

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "ryosen/base/count_text.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

namespace {

// A sentence stands alone without its full stop.
void end_sentence(std::string& text, std::string_view full_stop, std::initializer_list<std::string_view> ends) {
  const bool is_ended =
      std::any_of(ends.begin(), ends.end(), [&](std::string_view end) { return text.ends_with(end); });
  if (!text.empty() && !is_ended) text += full_stop;
}

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

void Outcome::say(const Text& more) {
  end_sentence(sentence.en, ".", {".", "!", "?", ":"});
  end_sentence(sentence.ja, "。", {"。", "！", "？", "：", "."});
  sentence.en += (sentence.en.empty() ? "" : " ") + more.en;
  sentence.ja += more.ja;
}

Code code_of(const Outcome& outcome) {
  if (outcome.exit_code == ExitCode::refused) return "refused";
  return outcome.exit_code == ExitCode::out_of_memory ? Code("out_of_memory") : Code("command_failed");
}

Outcome failed(ExitCode exit_code, Text sentence) {
  Outcome outcome;
  outcome.kind = Outcome::Kind::failed;
  outcome.exit_code = exit_code;
  outcome.sentence = std::move(sentence);
  return outcome;
}

std::vector<std::string> names_of(const Mesh& mesh, const std::vector<Element>& elements) {
  std::vector<std::string> names;
  names.reserve(elements.size());
  for (const Element& element : elements) names.push_back(name_of(mesh, element));
  return names;
}

Outcome no_attribute(std::string_view name) {
  const std::string id(name);
  return failed(ExitCode::refused, {"there is no attribute " + id + "; attribute list shows all",
                                    "属性 " + id + " はありません。attribute list で一覧を表示できます"});
}

Text describe(const Mesh& mesh, const Reason& reason) {
  const RuleText& rule = text_of(reason.rule);
  Text text{std::string(rule.en), std::string(rule.ja)};
  std::string witnesses;
  for (const std::string& name : names_of(mesh, reason.witnesses)) witnesses += (witnesses.empty() ? "" : ", ") + name;
  if (witnesses.empty()) return text;
  text.en += " (" + witnesses + ")";
  text.ja += "（" + witnesses + "）";
  return text;
}

std::vector<Text> describe_first(const Mesh& mesh, const std::vector<Reason>& reasons) {
  constexpr std::size_t most = 8;
  std::vector<Text> sentences;
  for (std::size_t i = 0; i < reasons.size() && i < most; ++i) sentences.push_back(describe(mesh, reasons[i]));
  if (reasons.size() <= most) return sentences;
  sentences.push_back(count_text(reasons.size() - most, "There is one more reason.", "There are # more reasons.",
                                 "理由はほかに # 件あります。"));
  return sentences;
}

Text join(const std::vector<Text>& texts) {
  Text all;
  for (const Text& text : texts) {
    all.en += (all.en.empty() ? "" : " ") + text.en;
    all.ja += text.ja;
  }
  return all;
}

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
