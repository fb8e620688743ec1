#include "app/editor/keys.h"

#include <array>
#include <deque>
#include <string>
#include <vector>

#include "core/ops/all.h"

namespace ryosen {

namespace {

constexpr std::array fixed_keys{
    KeyRow{"Escape", "cancel", "close, put the tool away, select nothing", "閉じる・ツールを置く・選択解除"},
    KeyRow{"1", "mode vertex", "pick vertices", "頂点モード"},
    KeyRow{"2", "mode edge", "pick edges", "稜線モード"},
    KeyRow{"3", "mode face", "pick faces", "面モード"},
    KeyRow{"4", "mode halfedge", "pick halfedges", "半稜線モード"},
    KeyRow{"Right", "walk next", "from the selected halfedge to the next", "選択した半稜線の次へ"},
    KeyRow{"Left", "walk prev", "from the selected halfedge to the previous", "選択した半稜線の前へ"},
    KeyRow{"Up", "walk twin", "from the selected halfedge to its twin", "選択した半稜線の対へ"},
    KeyRow{"Down", "walk around", "to the next halfedge from the same vertex", "同じ始点の隣の半稜線へ"},
    KeyRow{"Ctrl+Z", "undo", "undo", "元に戻す"},
    KeyRow{"Ctrl+Shift+Z", "redo", "redo", "やり直す"},
    KeyRow{"Ctrl+Y", "redo", "redo", "やり直す"},
    KeyRow{"Ctrl+O", "panel open", "open a file", "ファイルを開く"},
    KeyRow{"Ctrl+S", "save", "save", "保存"},
    KeyRow{"Ctrl+Shift+S", "panel save", "save under another name", "名前を付けて保存"},
    KeyRow{"Home", "frame all", "frame all", "全体を表示"},
    KeyRow{".", "frame selected", "frame the selection", "選択を表示"},
    KeyRow{"Numpad1", "view front", "front view", "正面図"},
    KeyRow{"Numpad3", "view right", "right view", "右側面図"},
    KeyRow{"Numpad7", "view top", "top view", "上面図"},
    KeyRow{"Numpad5", "projection toggle", "perspective or orthographic", "透視投影と平行投影"},
    KeyRow{"F1", "panel keys", "keys", "キー一覧"},
    KeyRow{"F3", "panel command", "say a command", "コマンド入力"},
    KeyRow{"F12", "shot", "screenshot", "画面の保存"},
    KeyRow{"Ctrl+Q", "quit", "quit", "終了"},
};

}  // namespace

namespace {

// Keys of operators come from their rows; an operator without a target runs immediately.
std::vector<KeyRow> all_keys() {
  static std::deque<std::string> texts;
  const auto keep = [](std::string text) -> std::string_view { return texts.emplace_back(std::move(text)); };
  std::vector<KeyRow> rows;
  for (const OpInfo& op : all_ops()) {
    const std::string id(op.id);
    if (op.key == '\0') continue;
    rows.push_back({keep(std::string(1, op.key)), is_tool(op) ? keep("tool " + id) : op.id, op.name_en, op.name_ja});
  }
  rows.insert(rows.end(), fixed_keys.begin(), fixed_keys.end());
  return rows;
}

}  // namespace

std::span<const KeyRow> key_table() {
  static const std::vector<KeyRow> keys = all_keys();
  return keys;
}

const KeyRow* find_key(std::string_view chord) {
  for (const KeyRow& row : key_table())
    if (row.chord == chord) return &row;
  return nullptr;
}

}  // namespace ryosen
