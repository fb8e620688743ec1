#include "app/editor/texts/remedy_text.h"

#include <set>
#include <string>

namespace ryosen {

namespace {

// Refused because there is nothing to do or no operator can help; the table's remedy says so.
bool is_final(Rule rule) {
  return rule == Rule::oriented || rule == Rule::triangulated || rule == Rule::detached ||
         text_of(rule).remedy_en.starts_with("never");
}

}  // namespace

Text without_remedy(const Verdict& verdict) {
  if (verdict.has(Rule::deleted)) return {"never: it is not in the mesh", "なし：メッシュに含まれていません"};
  Text general;
  std::set<std::string_view> said;
  for (const Reason& reason : verdict.reasons) {
    const RuleText& row = text_of(reason.rule);
    if (is_final(reason.rule)) return {std::string(row.remedy_en), std::string(row.remedy_ja)};
    // Each remedy once; orienting has already been tried.
    if (reason.rule == Rule::copies || !said.insert(row.remedy_en).second) continue;
    general.en += (general.en.empty() ? "" : "; ") + std::string(row.remedy_en);
    general.ja += (general.ja.empty() ? "" : "；") + std::string(row.remedy_ja);
  }
  Text text{"none was found nearby", "近くの操作では見つかりませんでした"};
  if (general.en.empty()) return text;
  return {text.en + "; worth a try: " + general.en, text.ja + "。試せること：" + general.ja};
}

}  // namespace ryosen
