#include "app/editor/commands.h"

#include <algorithm>
#include <array>

#include "app/editor/command_functions.h"
#include "app/editor/expect.h"
#include "app/editor/panel_list.h"
#include "app/editor/script.h"
#include "app/editor/words.h"

namespace ryosen {

Outcome usage_error(std::string en, std::string ja) {
  Outcome outcome;
  outcome.kind = Outcome::Kind::failed;
  outcome.exit_code = ExitCode::usage;
  outcome.sentence = {std::move(en), std::move(ja)};
  return outcome;
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
    if (const auto aside = document.set_aside(arguments)) return refused_as_deleted(*aside);
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

Outcome wrong_arguments(std::string_view id) {
  const CommandRow* row = find_command_row(id);
  const std::string form = std::string(id) + " " + std::string(row->syntax);
  return usage_error("the command reads: " + form, "書式：" + form);
}

Outcome failed(const Failure& failure) {
  Outcome outcome;
  outcome.kind = Outcome::Kind::failed;
  outcome.exit_code = failure.exit_code;
  outcome.sentence = failure.message.text;
  return outcome;
}

namespace {

constexpr std::array command_rows{
    CommandRow{"open", "FILE", "opens a mesh in place of the current one", "メッシュを開く", true, run_open},
    CommandRow{"new", "", "begins with an empty mesh", "空のメッシュから始める", true, run_new},
    CommandRow{"save", "[FILE]", "writes the mesh", "メッシュを保存する", true, run_save},
    CommandRow{"select", "NAME...|none", "selects vertices, edges, faces by name", "名前で要素を選択する", false,
               run_select},
    CommandRow{"walk", "next|prev|twin|around",
               "goes on from the one selected halfedge; around: about its first vertex",
               "選択中の半稜線から次へ移る（around：始点のまわり）", false, run_walk},
    CommandRow{"undo", "[N]", "takes back the last N edits", "直前の N 回の編集を元に戻す", true, run_undo},
    CommandRow{"redo", "[N]", "does N undone edits again", "元に戻した N 回の編集をやり直す", true, run_redo},
    CommandRow{"repair", "KIND [NUMBER]", "takes a kind of problem away everywhere (see ryosen repair --help)",
               "一種類の問題をまとめて直す（ryosen repair --help を参照）", true, run_repair},
    CommandRow{"recover", "[list|N|discard N]",
               "brings back what a crash left unsaved: lists it, or does its edits again",
               "異常終了で保存されなかった編集を一覧表示、復元、破棄する", false, run_recover},
    CommandRow{"camera", "JSON", "sets eye, target, up, fov_y_deg, ortho_height", "カメラを設定する", false,
               run_camera},
    CommandRow{"view", "front|back|left|right|top|bottom|iso", "looks along an axis at all of the mesh",
               "軸方向から全体を見る", false, run_view},
    CommandRow{"frame", "[all|selected]", "fits the mesh or the selection into the view",
               "全体または選択を画面に収める", false, run_frame},
    CommandRow{"projection", "toggle|perspective|orthographic", "switches the projection", "投影法を切り替える", false,
               run_projection},
    CommandRow{"show", "ID|all [on|off]", "shows or hides a highlight", "強調表示を切り替える", false, run_show},
    CommandRow{"tool", "ID|none", "chooses what a click does", "クリックで使うツールを選ぶ", false, run_tool},
    CommandRow{"mode", "vertex|edge|face|halfedge", "chooses what the pointer picks", "ポインタで選ぶ要素を決める",
               false, run_mode},
    CommandRow{"click", "X,Y [TOOL]", "clicks at a pixel", "画素をクリックする", false, run_click},
    CommandRow{"drag", "X,Y X,Y", "orbits by a drag from pixel to pixel", "ドラッグで視点を回す", false, run_drag},
    CommandRow{"key", "CHORD", "presses a key", "キーを押す", false, run_key},
    CommandRow{"shot", "[FILE]", "writes a picture", "画像を書き出す", false, run_shot},
    CommandRow{"expect", "V N|E N|F N|legal COMMAND|refused COMMAND|hash H", "fails the script unless it holds",
               "成り立たなければスクリプトを失敗にする", false, run_expect},
    CommandRow{"panel", "ID|none [on|off]", "shows or hides a panel; none closes what lies over the view",
               "パネルを開閉する（none は画面に重なるものを閉じる）", false, run_panel, panel_ids},
    CommandRow{"language", "en|ja", "sets the language of the window", "画面の言語を選ぶ", false, run_language},
    CommandRow{"theme", "dark|light", "sets the colours of the window", "画面の配色を選ぶ", false, run_theme},
    CommandRow{"cancel", "", "closes the open panel, else puts the tool away, else selects nothing",
               "パネル、ツール、選択の順に取り消す", false, run_cancel},
    CommandRow{"quit", "", "ends the program", "終了する", false, run_quit},
};

}  // namespace

std::span<const CommandRow> command_table() { return command_rows; }

const CommandRow* find_command_row(std::string_view id) {
  const auto row =
      std::find_if(command_rows.begin(), command_rows.end(), [&](const CommandRow& r) { return r.id == id; });
  return row == command_rows.end() ? nullptr : &*row;
}

std::string help_of(const CommandRow& row, Language language) {
  std::string help(language == Language::japanese ? row.help_ja : row.help_en);
  if (row.ids && language == Language::japanese) help += "。ID：" + row.ids();
  if (row.ids && language == Language::english) help += "; ID: " + row.ids();
  return help;
}

std::vector<std::string> command_ids() {
  std::vector<std::string> ids;
  for (const OpInfo& op : all_ops()) add_ids(op, ids);
  for (const CommandRow& row : command_rows) ids.emplace_back(row.id);
  return ids;
}

Outcome unknown_command(std::string_view id) {
  const std::string wrong(id), close = closest_word(id, command_ids());
  return usage_error("there is no command '" + wrong + "'" + (close.empty() ? "" : "; did you mean " + close + "?"),
                     "コマンド「" + wrong + "」はありません" + (close.empty() ? "" : "。" + close + " ですか？"));
}

Text not_an_operator(std::string_view word) {
  std::vector<std::string> ids;
  for (const OpInfo& op : all_ops()) add_ids(op, ids);
  const std::string wrong(word), close = closest_word(word, ids);
  return {"'" + wrong + "' is not an operator" + (close.empty() ? "" : "; did you mean " + close + "?"),
          "「" + wrong + "」は演算子ではありません" + (close.empty() ? "" : "。" + close + " ですか？")};
}

}  // namespace ryosen
