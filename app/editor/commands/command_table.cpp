// The rows of the table of commands, and how they are found.
#include <list>
#include <map>
#include <mutex>

#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/expect.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/document/repair_call.h"
#include "app/editor/preferences/menu_bar.h"
#include "app/editor/preferences/panel_list.h"
#include "app/editor/textbook/exercises.h"
#include "app/editor/textbook/figures.h"
#include "app/editor/textbook/textbook_commands.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/scene/view/named_views.h"

namespace ryosen {

namespace {

std::optional<Text> no_fault(Words, const std::string&) { return std::nullopt; }

// Those before the switches of the view, and those behind them.
const std::vector<CommandRow>& first_rows() {
  static const std::vector<CommandRow> rows{
      {.id = "open",
       .syntax = "FILE",
       .help_en = "opens a mesh in place of the current one",
       .help_ja = "メッシュを開く",
       .effect = Effect::replaces,
       .run = run_open,
       .may_take_long = opening_takes_long,
       .file = FileAccess::reads,
       .fault = fault_of_open},
      {.id = "reload",
       .syntax = "",
       .help_en = "reads the file of the mesh again, as when another program has changed it",
       .help_ja = "メッシュのファイルを読み直す（他のプログラムが変更したときなど）",
       .effect = Effect::replaces,
       .run = run_reload,
       .is_long = true,
       .reads_again = true,
       .fault = no_fault},
      {"keep_mine", "", "lets the next save replace the file, though another program has changed it",
       "他のプログラムが変更したファイルでも、次の保存で上書きする", Effect::view, run_keep_mine},
      {"new", "", "begins with an empty mesh", "空のメッシュから始める", Effect::replaces, run_new},
      {"start", "", "closes the mesh and shows the start page", "メッシュを閉じて開始画面を表示する", Effect::replaces,
       run_start},
      {.id = "exercise",
       .syntax = exercise_ids(),
       .help_en = "builds a solid of the source texts from nothing, an entry of the history for each step",
       .help_ja = "テキストの立体を空のメッシュから一手ずつ組み立てる",
       .effect = Effect::begins,
       .run = run_exercise,
       .fault = fault_of_exercise},
      {.id = "figure",
       .syntax = figure_ids(),
       .help_en = "puts the mesh of a figure of the source texts into the empty one",
       .help_ja = "テキストの図のメッシュを空のメッシュに置く",
       .effect = Effect::edits,
       .run = run_figure,
       .fault = fault_of_figure},
      {.id = "save",
       .syntax = "[FILE]",
       .help_en = "writes the mesh",
       .help_ja = "メッシュを保存する",
       .effect = Effect::writes,
       .run = run_save,
       .file = FileAccess::writes,
       .fault = no_fault},
      {.id = "save_selected",
       .syntax = "FILE",
       .help_en = "writes what is selected alone: faces, also by all of their vertices or edges, lines and points",
       .help_ja = "選択した部分だけを別のファイルに書き出す（面、線、点。面は全頂点・全稜線の選択でも可）",
       .effect = Effect::reads,
       .run = run_save_selected,
       .file = FileAccess::writes_part,
       .fault = fault_of_save_selected},
      {.id = "append",
       .syntax = "FILE",
       .help_en = "adds the mesh of a file to the open one, as parts of their own, and selects it",
       .help_ja = "ファイルのメッシュを開いているものに追加し、選択する",
       .effect = Effect::edits,
       .run = run_append,
       .is_long = true,
       .file = FileAccess::reads,
       .fault = fault_of_append},
      {.id = "compare",
       .syntax = "FILE|off",
       .help_en = "shows the mesh of a file beside the open one, by the same camera; colours distance tells them apart",
       .help_ja = "ファイルのメッシュを同じ視点で隣に並べる（colours distance で違いを色分け）",
       .effect = Effect::reads,
       .run = run_compare,
       .is_long = true,
       .file = FileAccess::reads,
       .fault = fault_of_compare,
       .named = {{"compare off", "Stop comparing", "比較を終える"}}},
      {.id = "select",
       .syntax = select_syntax(),
       .help_en = "selects by name, all that a problem is about (its loop, fans or pair), all problems of a kind, what "
                  "grows from the selection, or what has a trait",
       .help_ja =
           "要素を選択する（名前、問題が関わるループ・扇・対の全体、同種の問題すべて、選択からの広がり、性質で）",
       .effect = Effect::reads,
       .run = run_select,
       .prepares_edits = true,
       .fault = fault_of_select},
      {"box", "X,Y X,Y [add|toggle] [through]", "selects what lies wholly in a box of the picture and is seen",
       "画面の矩形に収まる、見えている要素を選択する", Effect::view, run_box},
      {"lasso", "X,Y X,Y X,Y ... [add|toggle] [through]", "selects what lies wholly in a polygon of the picture",
       "画面の多角形に収まる要素を選択する", Effect::view, run_lasso},
      {"band", "box|lasso", "the next drag with the left button selects by a box or a lasso",
       "次の左ドラッグでボックスまたは投げ縄選択をする", Effect::view, run_band},
      {.id = "gesture",
       .syntax = "move|turn|scale [x|y|z|normal|yz|zx|xy] | extrude | split | duplicate",
       .help_en =
           "begins to move the selection with the pointer, or what is made of it: extruded faces or edges, the "
           "vertex that splits an edge, a copy; X Y Z N, digits, O, Ctrl, Enter or a click ends, Escape gives up",
       .help_ja =
           "選択の移動・回転・拡大縮小を始める。extrude は押し出した面または稜線、split は稜線を分ける頂点、duplicate "
           "は複製を動かす"
           "（X Y Z N、数字、O、Ctrl、Enter かクリックで確定、Escape で中止）",
       .effect = Effect::begins,
       .run = run_gesture},
      {.id = "keep",
       .syntax = "NAME",
       .help_en = "keeps the selection under a name; select kept NAME selects it again",
       .help_ja = "選択に名前を付けて取っておく（select kept NAME で再び選択）",
       .effect = Effect::reads,
       .run = run_keep,
       .fault = fault_of_keep},
      {.id = "forget",
       .syntax = "NAME",
       .help_en = "forgets what was kept under a name",
       .help_ja = "取っておいた選択を忘れる",
       .effect = Effect::reads,
       .run = run_forget,
       .fault = fault_of_keep},
      {.id = "hide",
       .syntax = "selected|NAME...|A..B",
       .help_en = "hides faces, those at an edge or vertex, wires and isolated vertices, until unhide",
       .help_ja = "要素を unhide まで非表示にする（面、面のない稜線、孤立頂点。稜線・頂点ではそこに接する面）",
       .effect = Effect::reads,
       .run = run_hide,
       .fault = fault_of_hide},
      {.id = "isolate",
       .syntax = "selected|NAME...|A..B",
       .help_en = "hides everything else",
       .help_ja = "それ以外をすべて非表示にする",
       .effect = Effect::reads,
       .run = run_isolate,
       .fault = fault_of_hide},
      {"unhide", "", "shows all that is hidden", "非表示の要素をすべて表示する", Effect::reads, run_unhide},
      {.id = "either",
       .syntax = "COMMAND | COMMAND ...",
       .help_en = "does the first of several commands that is possible",
       .help_ja = "並べたコマンドのうち最初に可能なものを実行する",
       .effect = Effect::view,
       .run = run_either,
       .fault = fault_of_either},
      {"walk", "next|prev|twin|around", "goes on from the one selected halfedge; around: about its first vertex",
       "選択中の半稜線から次へ移る（around：始点のまわり）", Effect::reads, run_walk},
      {.id = "undo",
       .syntax = "[N]",
       .help_en = "takes back the last N edits",
       .help_ja = "直前の N 回の編集を元に戻す",
       .effect = Effect::steps,
       .run = run_undo},
      {.id = "redo",
       .syntax = "[N]",
       .help_en = "does N undone edits again",
       .help_ja = "元に戻した N 回の編集をやり直す",
       .effect = Effect::steps,
       .run = run_redo},
      {.id = "repair",
       .syntax = "KIND [VALUE|NAME=VALUE ...] | KIND[=VALUE],...",
       .help_en =
           "takes a kind of problem away everywhere, or several in rounds; default: all that keep the geometry (see "
           "ryosen repair --help)",
       .help_ja = "問題をまとめて直す（default：形状を保つ修復すべて。ryosen repair --help を参照）",
       .effect = Effect::edits,
       .run = run_repair,
       .is_long = true,
       .fault = fault_of_repair,
       .named = {{repair_all_line, "Repair all", "まとめて修復"}}},
      {.id = "would",
       .syntax = "repair KIND ...",
       .help_en = "tells what a repair would change and leave, and changes nothing",
       .help_ja = "修復で何が変わり何が残るかを、変更せずに調べる",
       .effect = Effect::reads,
       .run = run_would,
       .is_long = true,
       .fault = fault_of_would},
      {.id = "recover",
       .syntax = "[list|N [as_was|as_is]|discard N]",
       .help_en = "brings back what a crash left unsaved: lists it, or does its edits again",
       .help_ja = "異常終了で保存されなかった編集を一覧表示、復元、破棄する",
       .effect = Effect::replaces,
       .run = run_recover,
       .is_long = true,
       .fault = fault_of_recover,
       .only_tells = recover_only_tells},
      {"camera", "JSON", "sets eye, target, up, fov_y_deg, ortho_height", "カメラを設定する", Effect::view, run_camera},
      {"view", named_view_ids() + " [here]", "looks along an axis at all of the mesh, or at what is in the middle now",
       "軸方向から全体を見る（here：今の中心と距離のまま）", Effect::view, run_view},
      {"frame", "[all|selected]", "fits the mesh or the selection into the view, that from a side where it is seen",
       "全体または選択を画面に収める（選択は見える側から）", Effect::view, run_frame},
  };
  return rows;
}

const std::vector<CommandRow>& last_rows() {
  static const std::vector<CommandRow> rows{
      {.id = "clip_at",
       .syntax = "SHARE|+STEP|-STEP",
       .help_en =
           "moves the clipping plane so that this share of the extent across it is kept, from 0 to 1, or on by a "
           "step",
       .help_ja = "断面を動かす：断面に垂直な方向の広がりのうち残す割合（0 から 1）、または増減",
       .effect = Effect::view,
       .run = run_clip_at,
       .fault = fault_of_clip_at},
      {"show", "ID|all [on|off]", "shows or hides a highlight", "強調表示を切り替える", Effect::view, run_show},
      {.id = "colours",
       .syntax = colours_syntax(),
       .help_en = "colours the surface by a number of its elements, from LOW to HIGH, over all of them or at first the "
                  "middle 90 %, and says what the numbers are",
       .help_ja = "要素ごとの値で面に色を付け、値の要約を示す（LOW から HIGH、all は全体、省くと中央の 90 %）",
       .effect = Effect::reads,
       .run = run_colours,
       .fault = fault_of_colours},
      {.id = "measure",
       .syntax = "selected|clear|NAME [NAME [NAME]]",
       .help_en = "measures an element, the distance and angle of two, or the angle at the second of three vertices",
       .help_ja = "要素の長さ・面積、二要素の距離と角度、三頂点の中央の角度を測る",
       .effect = Effect::reads,
       .run = run_measure,
       .fault = fault_of_measure,
       .most_elements = 3,
       .named = {{"measure selected", "Measure the selection", "選択を測る"},
                 {"measure clear", "Take all measures away", "測定をすべて消す"}}},
      {.id = "steps",
       .syntax = steps_syntax(),
       .help_en =
           "plays something step by step in the view, beside the history: an exercise, a pairing, a collapse ...",
       .help_ja = "演習、対の探索、稜線削除などを一手ずつビューで再生する（履歴は変わらない）",
       .effect = Effect::view,
       .run = run_steps,
       .fault = fault_of_steps},
      {.id = "levels",
       .syntax = levels_syntax(),
       .help_en = "shows all levels of detail, beside the history: builds them with values of simplify, goes to "
                  "one with at most so many faces, keeps that as an edit",
       .help_ja = "簡略化の全段階をビューに示す（simplify の値で作り、at で面の数を選び、keep で編集として残す）",
       .effect = Effect::view,
       .run = run_levels,
       .may_take_long = levels_take_long,
       .fault = fault_of_levels},
      {.id = "account",
       .syntax = account_syntax(),
       .help_en =
           "tells under which rule how many edges stand that the last simplification, or the level of detail that "
           "is shown, left, or selects those of one",
       .help_ja = "直前の簡略化、または表示中の詳細度で残った稜線を、残った理由ごとに数える（理由を付けるとその稜線を選"
                  "択する）",
       .effect = Effect::view,
       .run = run_account,
       .is_long = true,
       .fault = fault_of_account},
      {.id = "self_intersections",
       .syntax = "[off]",
       .help_en =
           "searches for faces that meet others elsewhere than in common vertices and edges, marks and lists them "
           "until the next edit; off forgets them",
       .help_ja = "自己交差する面を探して強調し、次の編集まで一覧に加える（off で消す）",
       .effect = Effect::reads,
       .run = run_self_intersections,
       .is_long = true,
       .fault = fault_of_self_intersections,
       .named = {{"self_intersections", "Search for self-intersections", "自己交差を探す"},
                 {"self_intersections off", "Forget self-intersections", "見つかった自己交差を消す"}}},
      {"tool", "ID|none", "chooses what a click does", "クリックで使うツールを選ぶ", Effect::view, run_tool},
      {.id = "ask",
       .syntax = "[OPERATOR [NAME...]]",
       .help_en = "the next clicks give the elements that an operator lacks; alone, carries it out where it lacks none",
       .help_ja = "操作に足りない要素を次のクリックで与える（引数なし：足りていれば実行する）",
       .effect = Effect::begins,
       .run = run_ask,
       .fault = fault_of_ask},
      {"mode", "vertex|edge|face|halfedge", "chooses what the pointer picks", "ポインタで選ぶ要素を決める",
       Effect::view, run_mode},
      {"click", "X,Y [TOOL]", "clicks at a pixel", "画素をクリックする", Effect::view, run_click},
      {.id = "remedy",
       .syntax = "[N]",
       .help_en = "carries out the first line of the remedy for the click that was refused, or the Nth",
       .help_ja = "拒否されたクリックへの対処の最初の行を実行する（N を付けると N 行目）",
       .effect = Effect::begins,
       .run = run_remedy,
       .fault = fault_of_remedy},
      {"drag", "X,Y X,Y", "orbits by a drag from pixel to pixel", "ドラッグで視点を回す", Effect::view, run_drag},
      {"press", "left|right|middle X,Y [Shift+Ctrl+Alt]", "presses a button of the mouse at a pixel",
       "マウスのボタンを押す", Effect::view, run_press},
      {.id = "move",
       .syntax = "[left|right|middle] X,Y [Shift+Ctrl+Alt]",
       .help_en = "moves the pointer to a pixel, whatever is pressed; with a vertex it is move_vertex",
       .help_ja = "ポインタを動かす（押しているボタンはそのまま）。頂点を付けると move_vertex",
       .effect = Effect::view,
       .run = run_move,
       .fault = fault_of_move,
       .sends = sent_by_move},
      {"release", "left|right|middle X,Y [Shift+Ctrl+Alt]",
       "lets a button go: a click where it was pressed near by, which the script survives if it is refused",
       "マウスのボタンを離す（押した場所の近くならクリックになり、拒否されてもスクリプトは続く）", Effect::view,
       run_release},
      {"wheel", "STEPS X,Y [Shift+Ctrl+Alt]", "turns the wheel over a pixel", "画素の上でホイールを回す", Effect::view,
       run_wheel},
      {.id = "type",
       .syntax = "TEXT",
       .help_en = "types into the field that has the keyboard",
       .help_ja = "入力欄に文字を入れる",
       .effect = Effect::view,
       .run = run_type,
       .fault = no_fault},
      {.id = "key",
       .syntax = "CHORD",
       .help_en = "presses a key",
       .help_ja = "キーを押す",
       .effect = Effect::view,
       .run = run_key,
       .fault = fault_of_key,
       .sends = sent_by_key},
      {.id = "shot",
       .syntax = "[FILE]",
       .help_en = "writes a picture",
       .help_ja = "画像を書き出す",
       .effect = Effect::view,
       .run = run_shot,
       .sees_window = true,
       .file = FileAccess::writes,
       .fault = no_fault},
      {.id = "expect",
       .syntax = expect_syntax(),
       .help_en = "fails the script unless it holds",
       .help_ja = "成り立たなければスクリプトを失敗にする",
       .effect = Effect::reads,
       .run = run_expect,
       .fault = fault_of_expect},
      {.id = "panel",
       .syntax = panel_syntax(),
       .help_en = "shows, hides or folds a panel, puts it into a column, or opens its tab; none closes what lies over "
                  "the view",
       .help_ja = "パネルを開閉する、折り畳む、左右の列に移す、タブから開く（none は画面に重なるものを閉じる）",
       .effect = Effect::view,
       .run = run_panel,
       .ids = panel_ids},
      {"menu", "[" + menu_ids() + "]", "opens a menu of the bar, for the arrow keys; alone the first one",
       "メニューを矢印キー用に開く（省くと最初のメニュー）", Effect::view, run_menu},
      {"columns", "left|right PIXELS", "sets the width of a column, in pixels of a display at scale 1",
       "列の幅を決める（等倍の画素数）", Effect::view, run_columns},
      {.id = "values",
       .syntax = "ALGORITHM",
       .help_en = "opens the fields of an algorithm's values",
       .help_ja = "アルゴリズムに与える値の入力欄を開く",
       .effect = Effect::begins,
       .run = run_values},
      {"language", "en|ja", "sets the language of the window", "画面の言語を選ぶ", Effect::view, run_language},
      {.id = "prefer",
       .syntax = prefer_syntax(),
       .help_en = "sets what the window keeps for the next time; initial is what it was at first",
       .help_ja = "次回の起動にも引き継ぐ設定を変える（initial で最初の値）",
       .effect = Effect::view,
       .run = run_prefer,
       .ids = preference_ids},
      {.id = "bind",
       .syntax = "CHORD COMMAND|none|initial, or all initial",
       .help_en = "gives a key to a command, takes its key away, or does as the preset again",
       .help_ja = "キーにコマンドを割り当てる、外す、最初に戻す",
       .effect = Effect::view,
       .run = run_bind,
       .fault = fault_of_bind},
      {"cancel", "",
       "closes the open panel, else lets a held verdict go, else puts the tool away, else selects nothing, else "
       "leaves what is played, a level of detail or a question",
       "パネル、保持中の判定、ツール、選択の順に取り消し、最後に再生・詳細度・問題を終える", Effect::view, run_cancel},
      {"quit", "", "ends the program", "終了する", Effect::view, run_quit},
  };
  return rows;
}

// The rows of ScopedCommand. A list, since calls point at them.
std::list<CommandRow>& scoped_rows() {
  static std::list<CommandRow> rows;
  return rows;
}

// The row that is made from one of another table, called by a word, when it is first asked for. An operator has one per
// id and alias, since its messages name the word used. The row of a ScopedAlgorithm or ScopedViewSwitch stays behind.
template <class Row>
const CommandRow* made_row(std::string_view word, const Row& of, auto make) {
  static std::map<std::pair<std::string, const Row*>, CommandRow> rows;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  std::pair<std::string, const Row*> key(word, &of);
  const auto found = rows.find(key);
  return &(found != rows.end() ? found : rows.emplace(std::move(key), make()).first)->second;
}

const CommandRow* made_row(const OpInfo& op, std::string_view word) {
  return made_row(word, op, [&] { return row_of(op, word); });
}
const CommandRow* made_row(const ViewSwitch& row) {
  return made_row(row.id, row, [&] { return row_of(row); });
}
const CommandRow* made_row(const AlgorithmRow& row) {
  return made_row(row.id, row, [&] { return row_of(row); });
}

}  // namespace

ScopedCommand::ScopedCommand(CommandRow row) { scoped_rows().push_back(std::move(row)); }
ScopedCommand::~ScopedCommand() { scoped_rows().pop_back(); }

std::vector<const CommandRow*> command_table() {
  std::vector<const CommandRow*> table;
  for (const OpInfo& op : all_ops()) table.push_back(made_row(op, op.id));
  for (const CommandRow& row : first_rows()) table.push_back(&row);
  for (const ViewSwitch& row : view_switches()) table.push_back(made_row(row));
  for (const CommandRow& row : last_rows()) table.push_back(&row);
  for (const AlgorithmRow& algorithm : algorithm_table())
    if (!find_op(algorithm.id)) table.push_back(made_row(algorithm));
  for (const CommandRow& row : scoped_rows()) table.push_back(&row);
  return table;
}

const CommandRow* find_command_row(std::string_view id) {
  for (const std::vector<CommandRow>* rows : {&first_rows(), &last_rows()})
    for (const CommandRow& row : *rows)
      if (row.id == id) return &row;
  if (const OpInfo* const op = find_op(id)) return made_row(*op, id);
  if (const ViewSwitch* const row = find_view_switch(id)) return made_row(*row);
  if (const AlgorithmRow* const algorithm = find_algorithm(id)) return made_row(*algorithm);
  for (const CommandRow& row : scoped_rows())
    if (row.id == id) return &row;
  return nullptr;
}

const CommandRow* row_of(const Command& command) {
  if (const AnyOp* const op = command.op()) return made_row(info_of(*op), info_of(*op).id);
  if (const AlgorithmCall* const call = command.algorithm())
    return call->is_called_repair || find_op(call->row->id) ? find_command_row("repair") : made_row(*call->row);
  const std::vector<std::string_view> words = split_words(*command.written());
  return words.empty() ? nullptr : find_command_row(words[0]);
}

Effect effect_of(const CommandRow& row, Words arguments) {
  return row.only_tells && row.only_tells(arguments) ? Effect::view : row.effect;
}

std::optional<CommandCall> call_of(std::string_view line) {
  const std::vector<std::string_view> words = split_words(line);
  const CommandRow* const row = words.empty() ? nullptr : find_command_row(words[0]);
  if (!row) return std::nullopt;
  const Words arguments = Words(words).subspan(1);
  if (const std::string sent = row->sends ? row->sends(arguments) : ""; !sent.empty()) return call_of(sent);
  const bool only_tells = row->only_tells && row->only_tells(arguments);
  const bool is_long = (row->is_long && !only_tells) || (row->may_take_long && row->may_take_long(arguments));
  return CommandCall{row, effect_of(*row, arguments), is_long, std::string(line)};
}

std::optional<CommandCall> call_of_command(const Command& command) {
  if (const std::string* const line = command.written()) return call_of(*line);
  const CommandRow& row = *row_of(command);
  return CommandCall{&row, row.effect, row.is_long, {}};
}

std::string file_of(const CommandCall& call) {
  if (call.row->file == FileAccess::none) return {};
  return file_name(behind_word(call.line));
}

}  // namespace ryosen
