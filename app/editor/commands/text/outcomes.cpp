#include "app/editor/commands/text/outcomes.h"

#include <span>
#include <utility>
#include <vector>

#include "app/editor/commands/text/words.h"
#include "ryosen/base/reasons.h"
#include "ryosen/document/document.h"
#include "ryosen/ops/all.h"

namespace ryosen {

Outcome failed(const Failure& failure) { return failed(failure.exit_code, failure.message.text); }

Outcome usage_error(const Text& sentence) { return failed(ExitCode::usage, sentence); }
Outcome usage_error(std::string en, std::string ja) { return failed(ExitCode::usage, {std::move(en), std::move(ja)}); }
Outcome done_with(Text remark) {
  Outcome outcome;
  outcome.sentence = std::move(remark);
  return outcome;
}
Outcome cancelled() {
  return failed(ExitCode::cancelled, {"Cancelled; nothing has changed.", "中止しました。何も変わっていません。"});
}

Outcome no_element(Document& document, std::string_view line, NameError error, const Text& sentence) {
  const std::vector<std::string_view> words = split_words(line);
  if (words.empty()) return usage_error(sentence.en, sentence.ja);
  const std::span arguments = std::span(words).subspan(1);
  const std::string id(words[0]);
  const std::string command(without_blanks(line));
  const auto refused_as_deleted = [&](const Text& why) {
    Outcome outcome;
    outcome.kind = Outcome::Kind::refused;
    outcome.exit_code = ExitCode::refused;
    outcome.reasons.push_back({Rule::deleted, {}});
    outcome.sentence = {command + " is refused: " + why.en, command + " は実行できません：" + why.ja};
    return outcome;
  };
  if (error == NameError::deleted)
    if (const auto aside = document.quarantine_text(arguments)) return refused_as_deleted(*aside);
  const Document::Elsewhere place = document.exists_elsewhere(error, arguments);
  if (place == Document::Elsewhere::no) return usage_error(id + ": " + sentence.en, id + "：" + sentence.ja);
  const RuleText& rule = text_of(Rule::deleted);
  const Text gone = place == Document::Elsewhere::earlier
                        ? Text{std::string(rule.en) + " (" + sentence.en + "; " + std::string(rule.remedy_en) + ")",
                               std::string(rule.ja) + "（" + sentence.ja + "。" + std::string(rule.remedy_ja) + "）"}
                        : Text{"The edit that makes the element was undone. (" + sentence.en + "; redo brings it back)",
                               "要素を作る編集が取り消されています。（" + sentence.ja + "。やり直すと復活します）"};
  return refused_as_deleted(gone);
}

}  // namespace ryosen
