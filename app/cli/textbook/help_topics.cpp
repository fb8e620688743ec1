// The tables of the source texts as topics of the help and as lists of ids.
#include "app/cli/help_topics.h"
#include "app/cli/columns.h"
#include "app/cli/contract/json.h"
#include "app/cli/contract/lists.h"
#include "app/cli/id_lists.h"
#include "app/editor/textbook/exercises.h"
#include "app/editor/textbook/practice.h"
#include "app/editor/textbook/text_places.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/pairing.h"
#include "ryosen/textbook/steps/all.h"

namespace ryosen::cli {

namespace {

// The rows of a table with an id and these two members.
template <class Rows, class Member>
std::vector<IdEntry> entries(const Rows& rows, Member en, Member ja) {
  std::vector<IdEntry> all;
  for (const auto& row : rows) {
    all.push_back({std::string(row.id), {std::string(row.*en), std::string(row.*ja)}, {}});
    if constexpr (requires { row.syntax; }) all.back().syntax = std::string(row.syntax);
  }
  return all;
}

}  // namespace

std::string forms_topic(Language language) {
  Columns rows;
  for (const forms::FormRow& row : forms::all_forms())
    rows.add(std::string(row.id), std::string(choose(language, row.en, row.ja)) + " (" +
                                      std::string(choose(language, row.source_en, row.source_ja)) + ")");
  return std::string(choose(language, "Forms:\n", "形状表現：\n")) + rows.text() +
         ids_below({"Ways to pair the halfedges:\n", "半稜線の対を見つける方法：\n"}, Ids::pairings, language);
}

std::string steps_topic(Language language) {
  Columns rows;
  for (const steps::StepsRow& row : steps::all_steps())
    rows.add(steps::call_of(row), choose(language, row.help_en, row.help_ja));
  return std::string(choose(language, "WHAT is one of these; S is one of ", "WHAT は次のどれか。S は ")) +
         built_in_script_ids() +
         std::string(choose(language, ",\nwhich need no FILE, or the name of a script:\n",
                            "（FILE は不要）、\nまたはスクリプトのファイル名：\n")) +
         rows.text();
}

std::string practice_topic(Language language) {
  Columns kinds, answers;
  for (const QuestionKindRow& row : question_kinds()) kinds.add(std::string(row.id), choose(language, row.en, row.ja));
  constexpr struct {
    const char *word, *en, *ja;
  } words[] = {{"h3, v4, f0, e2", "an element by its slot", "要素（スロット名）"},
               {"1-2", "a halfedge or an edge by its ends", "半稜線または稜線（両端の頂点）"},
               {"6", "a number", "数"},
               {"none", "for a link that leads nowhere", "行き先のないリンク"},
               {"yes", "where an operator may be done", "操作が可能なとき"},
               {"RULE", "one of the rules that forbid it, as `ryosen why` says them",
                "操作を禁じる規則（ryosen why が示すもの）のどれか"}};
  for (const auto& [word, en, ja] : words) answers.add(word, choose(language, en, ja));
  return std::string(choose(language, "Kinds of questions:\n", "問題の種類：\n")) + kinds.text() +
         std::string(choose(language, "WORD is one of these:\n", "WORD は次のどれか：\n")) + answers.text() +
         std::string(choose(language, "Exit code 1 where an answer is wrong. In the window: Help > Practice.\n",
                            "答えが違えば終了コード 1。画面では「ヘルプ」の「練習問題」です。\n"));
}

void show_text_places(const Console& console) {
  for (const TextPlace& place : text_places()) {
    if (console.json) {
      Record<text_place_shape> json;
      json["text"] = place.text;
      json["place"] = cli::to_json(Text{std::string(place.place_en), std::string(place.place_ja)});
      json["commands"] = place.lines.empty() ? Json() : Json(place.lines);
      json["where"] = cli::to_json(Text{std::string(place.where_en), std::string(place.where_ja)});
      console.print(line_of(json));
      continue;
    }
    std::string text =
        std::string(place.text) + "  " + std::string(console.text(place.place_en, place.place_ja)) + "\n";
    if (!place.lines.empty()) text.append("     ").append(place.lines) += "\n";
    console.print(text + "     " + std::string(console.text(place.where_en, place.where_ja)) + "\n");
  }
}

std::vector<IdEntry> form_entries() { return entries(forms::all_forms(), &forms::FormRow::en, &forms::FormRow::ja); }
std::vector<IdEntry> relation_entries() {
  return entries(forms::relations(), &forms::RelationRow::en, &forms::RelationRow::ja);
}
std::vector<IdEntry> pairing_entries() { return entries(pairing_methods(), &PairingMethod::en, &PairingMethod::ja); }
std::vector<IdEntry> steps_entries() {
  return entries(steps::all_steps(), &steps::StepsRow::help_en, &steps::StepsRow::help_ja);
}
std::vector<IdEntry> role_entries() { return entries(steps::roles(), &steps::RoleRow::en, &steps::RoleRow::ja); }

}  // namespace ryosen::cli
