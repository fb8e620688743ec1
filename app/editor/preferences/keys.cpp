#include "app/editor/preferences/keys.h"

#include <algorithm>

#include "app/editor/commands/text/command.h"
#include "app/editor/preferences/view_switches.h"
#include "ryosen/ops/all.h"
#include "ryosen/scene/view/named_views.h"

namespace ryosen {

namespace {

const KeyRow first_keys[] = {
    {"Escape", "cancel", "close, put the tool away, select nothing, leave an exercise",
     "閉じる・ツールを置く・選択解除・演習を終える", true},
    {"Enter", "either remedy | ask", "do the first remedy of a refused click, or what was asked for elements",
     "拒否されたクリックへの最初の対処、または要素を待っている操作を実行"},
    {"1", "mode vertex", "pick vertices", "頂点モード"},
    {"2", "mode edge", "pick edges", "稜線モード"},
    {"3", "mode face", "pick faces", "面モード"},
    {"4", "mode halfedge", "pick halfedges", "半稜線モード"},
    {"Right", "walk next", "from the selected halfedge to the next", "選択した半稜線の次へ", false, true},
    {"Left", "walk prev", "from the selected halfedge to the previous", "選択した半稜線の前へ", false, true},
    {"Up", "walk twin", "from the selected halfedge to its twin", "選択した半稜線の対へ", false, true},
    {"Down", "walk around", "to the next halfedge from the same vertex", "同じ始点の隣の半稜線へ", false, true},
    {"Alt+Right", "steps forward", "one step forward in what is played", "再生を一手進める", false, true},
    {"Alt+Left", "steps back", "one step back in what is played", "再生を一手戻す", false, true},
    {"Alt+Home", "steps first", "to the beginning of what is played", "再生の始めへ"},
    {"Alt+End", "steps last", "to the end of what is played", "再生の終わりへ"},
    {"Alt+P", "steps play", "play step by step, or stop", "一手ずつ再生、または停止"},
    {"X", "delete selected", "delete the selection", "選択を削除", false, false, KeyMenu::edit, "Delete", "削除"},
    {"Delete", "delete selected", "delete the selection", "選択を削除"},
    {"Shift+X", "dissolve selected", "dissolve the selection; of faces the edges between them",
     "選択を溶解（面はその間の稜線）", false, false, KeyMenu::edit, "Dissolve", "溶解"},
    {"M", "weld selected", "weld the selected vertices, or those of faces, into the last one",
     "選択した頂点（面ではその頂点）を最後の頂点に縫合", false, false, KeyMenu::edit, "Weld into the last one",
     "最後の頂点に縫合"},
    {"Shift+M", "weld selected mid", "weld the selected vertices in their middle", "選択した頂点を中央で縫合", false,
     false, KeyMenu::edit, "Weld in the middle", "中央で縫合"},
    {"J", "either separate_loop selected | unite_ring selected | make_edge selected",
     "divide a face from vertex to vertex, or join them by an edge", "面を二頂点間で分割、または稜線で結ぶ", false,
     false, KeyMenu::edit, "Join or divide", "結ぶ・分割"},
    {"F", "either make_face selected | fill selected", "make a face on the vertices, or fill holes at the edges",
     "選択した頂点に面を張る、または稜線の穴を埋める", false, false, KeyMenu::edit, "Fill or make a face",
     "面を張る・穴を埋める"},
    {"E", "gesture extrude", "extrude the selected faces or edges and move them",
     "選択した面または稜線を押し出して動かす", false, false, KeyMenu::edit, "Extrude and move", "押し出して移動"},
    {"Shift+E", "gesture split", "split the edge under the tool, or the selected one, and move the vertex",
     "ツールの下または選択した稜線を分け、その頂点を動かす", false, false, KeyMenu::edit, "Split and move",
     "分けて移動"},
    {"G", "gesture move", "move the selection: then X Y Z N, digits, O, Ctrl, Enter or a click, Escape",
     "選択を移動（X Y Z N、数字、O、Ctrl。Enter かクリックで確定、Escape で中止）", false, false, KeyMenu::edit, "Move",
     "移動"},
    {"R", "gesture turn", "turn the selection", "選択を回転", false, false, KeyMenu::edit, "Turn", "回転"},
    {"Shift+S", "gesture scale", "scale the selection", "選択を拡大縮小", false, false, KeyMenu::edit, "Scale",
     "拡大縮小"},
    {"B", "band box", "select by a box: drag it, Shift adds, Ctrl adds or takes out, Alt goes through",
     "ボックス選択（ドラッグ。Shift で追加、Ctrl で反転、Alt で裏側も）", false, false, KeyMenu::select,
     "Select by a box", "ボックス選択"},
    {"Shift+B", "band lasso", "select by a lasso in the same way", "投げ縄選択（修飾キーは同じ）", false, false,
     KeyMenu::select, "Select by a lasso", "投げ縄選択"},
    {"Shift+D", "gesture duplicate", "duplicate the selection and move the copy", "選択を複製して動かす", false, false,
     KeyMenu::edit, "Duplicate and move", "複製して移動"},
    {"H", "hide selected", "hide the selection", "選択を非表示にする"},
    {"Shift+H", "isolate selected", "hide everything else", "選択以外を非表示にする"},
    {"Ctrl+H", "unhide", "show what is hidden", "非表示の要素を表示する"},
    {"Ctrl+Z", "undo", "undo", "元に戻す", false, true},
    {"Ctrl+Shift+Z", "redo", "redo", "やり直す", false, true},
    {"Ctrl+Y", "redo", "redo", "やり直す", false, true},
    {"Ctrl+N", "new", "begin with an empty mesh", "空のメッシュから始める"},
    {"Ctrl+O", "panel open", "open a file", "ファイルを開く"},
    {"Ctrl+S", "save", "save", "保存"},
    {"Ctrl+Shift+S", "panel save", "save under another name", "名前を付けて保存"},
    {"Home", "frame all", "frame all", "全体を表示"},
    {".", "frame selected", "frame the selection", "選択を表示"},
    {"PageUp", "clip_at +0.02", "keep more behind the clipping plane", "断面を進める", false, true},
    {"PageDown", "clip_at -0.02", "keep less behind the clipping plane", "断面を戻す", false, true},
};
const KeyRow last_keys[] = {
    {"F1", "panel keys", "keys", "キー一覧", true},
    {"F3", "panel command", "say a command", "コマンド入力"},
    {"F10", "menu", "open the menus: arrows, Enter, Escape", "メニューを開く（矢印、Enter、Escape）"},
    {std::string(lone_key), "menu", "alone: open the menus", "単独で押すとメニューを開く"},
    {"F12", "shot", "screenshot", "画面の保存"},
    {"Ctrl+Q", "quit", "quit", "終了"},
};

// A key bound anew tells what the command's other key did, else the help of the command; it repeats as that did.
void take_over(std::vector<KeyRow>& table, std::span<const KeyBinding> own) {
  const std::vector<KeyRow> before = table;
  for (const KeyBinding& binding : own) {
    std::erase_if(table, [&](const KeyRow& row) { return row.chord == binding.chord; });
    if (binding.command.empty()) continue;
    const auto same =
        std::find_if(before.begin(), before.end(), [&](const KeyRow& row) { return row.command == binding.command; });
    KeyRow made = same == before.end() ? KeyRow{{}, binding.command, "", ""} : *same;
    made.chord = binding.chord;
    table.push_back(std::move(made));
  }
}

}  // namespace

std::vector<KeyRow> key_table(const InputPreset& preset, std::span<const KeyBinding> own) {
  std::vector<KeyRow> keys;
  for (const OpInfo& op : all_ops()) {
    if (op.key == '\0') continue;
    keys.push_back({std::string(1, op.key), line_of_key(op), op.name_en, op.name_ja});
  }
  keys.insert(keys.end(), std::begin(first_keys), std::end(first_keys));
  for (const Selector& row : selectors())
    if (!row.chord.empty())
      keys.push_back({std::string(row.chord), select_line(row), row.name_en, row.name_ja, false, row.repeats});
  for (const NamedView& view : named_views())
    if (!view.chord.empty())
      keys.push_back({std::string(view.chord), "view " + std::string(view.id), view.key_en, view.key_ja});
  for (const ViewSwitch& row : view_switches())
    if (row.toggles()) keys.push_back({std::string(row.chord), toggle_line(row), row.key_en, row.key_ja});
  keys.insert(keys.end(), std::begin(last_keys), std::end(last_keys));
  for (const KeyChange& change : preset.keys) {
    std::erase_if(keys, [&](const KeyRow& row) { return row.chord == change.chord; });
    keys.push_back({std::string(change.chord), std::string(change.command), change.help_en, change.help_ja});
  }
  if (!own.empty()) take_over(keys, own);
  return keys;
}

std::optional<KeyRow> find_key(std::string_view chord, const InputPreset& preset, std::span<const KeyBinding> own) {
  std::vector<KeyRow> keys = key_table(preset, own);
  for (KeyRow& row : keys)
    if (row.chord == chord) return std::move(row);
  return std::nullopt;
}

std::vector<KeyRow> rows_without_key(const InputPreset& preset, std::span<const KeyBinding> own) {
  const std::vector<KeyRow> left = key_table(preset, own);
  std::vector<KeyRow> lost;
  const auto has = [](const std::vector<KeyRow>& keys, const KeyRow& row) {
    return std::any_of(keys.begin(), keys.end(), [&](const KeyRow& key) { return key.command == row.command; });
  };
  for (KeyRow& row : key_table(preset))
    if (!has(left, row) && !has(lost, row)) {
      row.chord.clear();
      lost.push_back(std::move(row));
    }
  return lost;
}

std::string line_of_key(const OpInfo& op) { return (is_tool(op) ? "tool " : "") + std::string(op.id); }

Text help_of_key(const KeyRow& row) {
  if (!row.help_en.empty()) return {std::string(row.help_en), std::string(row.help_ja)};
  return {row.command, row.command};
}

}  // namespace ryosen
