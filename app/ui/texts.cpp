#include "app/ui/texts.h"

#include <array>
#include <cstddef>

#include "core/base/enum_table.h"

namespace ryosen {

namespace {

struct Row {
  UiText id;
  const char* en;
  const char* ja;
};

using T = UiText;

constexpr std::array<Row, enum_count<UiText>> rows{{
    {T::command_hint, "an operator or a command; Enter carries it out", "操作またはコマンド（Enter で実行）"},
    {T::more_operators, "More", "その他の操作"},
    {T::menu_file, "File", "ファイル"},
    {T::menu_edit, "Edit", "編集"},
    {T::menu_view, "View", "表示"},
    {T::menu_help, "Help", "ヘルプ"},
    {T::open, "Open", "開く"},
    {T::save, "Save", "保存"},
    {T::quit, "Quit", "終了"},
    {T::undo, "Undo", "元に戻す"},
    {T::redo, "Redo", "やり直す"},
    {T::select_none, "Select nothing", "選択を解除"},
    {T::frame_all, "Show all", "全体を表示"},
    {T::frame_selected, "Show the selection", "選択を表示"},
    {T::projection, "Orthographic", "平行投影"},
    {T::theme_dark, "Dark", "暗い配色"},
    {T::theme_light, "Light", "明るい配色"},
    {T::front, "Front", "正面"},
    {T::back, "Back", "背面"},
    {T::left, "Left", "左"},
    {T::right, "Right", "右"},
    {T::top, "Top", "上"},
    {T::bottom, "Bottom", "下"},
    {T::isometric, "Diagonal", "斜め"},
    {T::select_tool, "Select", "選択"},
    {T::pick, "Pick", "対象"},
    {T::vertex, "Vertex", "頂点"},
    {T::edge, "Edge", "稜線"},
    {T::face, "Face", "面"},
    {T::halfedge, "Halfedge", "半稜線"},
    {T::halfedges, "halfedges", "半稜線"},
    {T::vertices, "vertices", "頂点"},
    {T::edges, "edges", "稜線"},
    {T::faces, "faces", "面"},
    {T::boundaries, "boundary loops", "境界ループ"},
    {T::rings, "rings of faces", "面の穴"},
    {T::wire_cycles, "cycles along wires", "稜線だけの輪"},
    {T::points_without_edge, "points without an edge", "稜線のない点"},
    {T::parts, "connected parts", "つながった部分"},
    {T::genus, "handles", "種数"},
    {T::no_genus, "No G", "種数なし"},
    {T::kind, "kind", "種類"},
    {T::kind_anew, "ask", "再判定"},
    {T::kind_is_stale, "This was so before the last edit. Asking a mesh of this size takes a moment.",
     "最後の編集より前の判定です。この大きさのメッシュでは再判定に少し時間がかかります。"},
    {T::as_read, "as read", "読み込み直後"},
    {T::nothing_under_pointer, "Point at the mesh.", "メッシュを指してください。"},
    {T::nothing_picked, "Point at an element or click one.", "要素を指すかクリックしてください。"},
    {T::legal, "possible", "可能"},
    {T::refused, "refused", "不可"},
    {T::warning, "Warning", "警告"},
    {T::remedy, "What would help", "対処"},
    {T::clears, "removes", "削除"},
    {T::adds, "adds", "追加"},
    {T::no_problems, "No problems found.", "問題はありません。"},
    {T::position, "position", "座標"},
    {T::degree, "degree", "次数"},
    {T::neighbours, "neighbours", "隣接"},
    {T::length, "length", "長さ"},
    {T::angle, "dihedral angle", "二面角"},
    {T::area, "area", "面積"},
    {T::corners, "corners", "角"},
    {T::normal, "normal", "法線"},
    {T::from, "from", "始点"},
    {T::to, "to", "終点"},
    {T::next, "next", "次"},
    {T::prev, "prev", "前"},
    {T::twin, "twin", "対"},
    {T::boundary, "on the boundary", "境界上"},
    {T::nonmanifold, "not manifold", "非多様体"},
    {T::outside, "outside", "外側"},
    {T::isolated, "isolated", "孤立"},
    {T::copies, "copies", "複製"},
    {T::line_in_file, "line", "行"},
    {T::mouse, "Mouse", "マウス"},
    {T::key, "Keys", "キー"},
    {T::left_button, "Left drag", "左ドラッグ"},
    {T::right_button, "Right drag, Shift + left drag", "右ドラッグ、Shift+左ドラッグ"},
    {T::middle_button, "Middle drag", "中ドラッグ"},
    {T::wheel, "Wheel", "ホイール"},
    {T::double_click, "Double click", "ダブルクリック"},
    {T::does_orbit, "orbit", "回転"},
    {T::does_pan, "pan", "移動"},
    {T::does_zoom, "zoom", "拡大"},
    {T::does_centre, "set the centre", "中心を決める"},
    {T::does_pick, "select", "選択"},
    {T::folder_up, "Folder above", "上のフォルダ"},
    {T::file_name, "File name", "ファイル名"},
    {T::replace_question, "This file exists; save again to replace it.",
     "同じ名前のファイルがあります。もう一度保存すると置き換えます。"},
    {T::loss_question, "Save again to write it all the same.", "それでも書き出すにはもう一度保存してください。"},
    {T::cancel, "Cancel", "取り消し"},
    {T::discard, "Discard", "破棄"},
    {T::unsaved_question, "There are changes that are not saved.", "保存していない変更があります。"},
    {T::recover_question, "Ryosen ended before these edits were saved.",
     "次の編集を保存しないまま Ryosen が終了しました。"},
    {T::nothing_to_recover, "There is nothing to recover.", "復元できるものはありません。"},
    {T::recover, "Recover", "復元"},
    {T::later, "Later", "後で"},
    {T::done, "done", "実行しました"},
    {T::language_other, "日本語", "English"},
}};

static_assert(rows_are_in_order(rows, &Row::id));
constexpr bool are_in_both_languages() {
  for (const Row& row : rows)
    if (!row.en || !row.ja) return false;
  return true;
}
static_assert(are_in_both_languages());

}  // namespace

const char* text(UiText id, Language language) {
  const Row& row = rows[static_cast<std::size_t>(id)];
  return language == Language::japanese ? row.ja : row.en;
}

}  // namespace ryosen
