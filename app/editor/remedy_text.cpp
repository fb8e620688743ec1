#include "app/editor/remedy_text.h"

#include <algorithm>
#include <string>

namespace ryosen {

namespace {

// Rules against which no operator helps: the table says never, or what there is instead.
bool is_final(Rule rule) {
  return rule == Rule::inner_edge || rule == Rule::oriented || text_of(rule).remedy_en.starts_with("never");
}

Text final_text(Rule rule) {
  const RuleText& row = text_of(rule);
  const std::string en(row.remedy_en), ja(row.remedy_ja);
  if (rule == Rule::inner_edge)
    return {"never on this edge; instead: " + en, "この稜線では不可能です。代わりに：" + ja};
  return {en, ja};
}

}  // namespace

Text without_remedy(const Verdict& verdict) {
  if (verdict.has(Rule::deleted)) return {"never: it is not in the mesh", "なし：メッシュに含まれていません"};
  // Copies may go when faces are turned, and their boundaries with them.
  const auto final_reason =
      std::find_if(verdict.reasons.begin(), verdict.reasons.end(), [](const Reason& r) { return is_final(r.rule); });
  if (final_reason != verdict.reasons.end() && !verdict.has(Rule::copies)) return final_text(final_reason->rule);
  Text general;
  for (const Reason& reason : verdict.reasons) {
    if (reason.rule == Rule::copies || is_final(reason.rule)) continue;  // turning the faces has been tried
    general.en += (general.en.empty() ? "" : "; ") + std::string(text_of(reason.rule).remedy_en);
    general.ja += (general.ja.empty() ? "" : "；") + std::string(text_of(reason.rule).remedy_ja);
  }
  Text text{"none was found nearby", "近くの操作では見つかりませんでした"};
  if (general.en.empty()) return text;
  return {text.en + "; worth a try: " + general.en, text.ja + "。試せること：" + general.ja};
}

}  // namespace ryosen
