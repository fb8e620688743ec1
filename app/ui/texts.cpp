#include "app/ui/texts.h"

#include "ryosen/base/enum_table.h"

namespace ryosen {

namespace {

struct TextRow {
  UiText id;
  const char *en, *ja;
};
constexpr TextRow text_rows[] = {
    {UiText::nothing_found, "Nothing is found by these words.", "この言葉では見つかりません。"},
    {UiText::search_hint, "search by any word", "言葉で探す"},
    {UiText::command_hint, "an operator or a command; Enter carries it out", "操作またはコマンド（Enter で実行）"},
    {UiText::press_takes_tool, "A click here takes the tool; a click in the view then applies it.",
     "ここをクリックするとツールになり、画面の要素をクリックすると実行します。"},
    {UiText::press_acts, "A click here acts at once.", "ここをクリックするとすぐに実行します。"},
    {UiText::press_asks, "A click here asks for the rest in the command line.",
     "ここをクリックすると、残りの指定をコマンド欄で尋ねます。"},
    {UiText::or_drop, "or drop a file here", "またはここにファイルをドロップ"},
    {UiText::save, "Save", "保存"},
    {UiText::quit, "Quit", "終了"},
    {UiText::undo, "Undo", "元に戻す"},
    {UiText::redo, "Redo", "やり直す"},
    {UiText::keep_selection, "Keep the selection under a name", "選択に名前を付けて取っておく"},
    {UiText::frame_all, "Show all", "全体を表示"},
    {UiText::frame_selected, "Show the selection", "選択を表示"},
    {UiText::hide_selected, "Hide the selection", "選択を非表示にする"},
    {UiText::isolate_selected, "Hide everything else", "選択以外を非表示にする"},
    {UiText::unhide, "Show what is hidden", "すべて表示"},
    {UiText::select_tool, "Select", "選択"},
    {UiText::pick, "What a click selects.", "クリックで選ぶ要素の種類です。"},
    {UiText::vertex, "Vertex", "頂点"},
    {UiText::edge, "Edge", "稜線"},
    {UiText::face, "Face", "面"},
    {UiText::halfedge, "Halfedge", "半稜線"},
    {UiText::halfedges, "halfedges", "半稜線"},
    {UiText::vertices, "vertices", "頂点"},
    {UiText::faces, "faces", "面"},
    {UiText::no_genus, "No G", "種数なし"},
    {UiText::kind, "kind", "種類"},
    {UiText::kind_anew, "check again", "再判定"},
    {UiText::kind_is_stale, "This was so before the last edit. Checking a mesh of this size takes a moment.",
     "最後の編集より前の判定です。この大きさのメッシュでは再判定に少し時間がかかります。"},
    {UiText::as_read, "as read", "読み込み直後"},
    {UiText::nothing_picked, "Point at an element or click one.", "要素を指すかクリックしてください。"},
    {UiText::legal, "possible", "可能"},
    {UiText::refused, "refused", "不可"},
    {UiText::warning, "Warning", "警告"},
    {UiText::remedy, "What would help", "対処"},
    {UiText::clears, "removes", "削除"},
    {UiText::adds, "adds", "追加"},
    {UiText::no_problems, "No problems found.", "問題はありません。"},
    {UiText::position, "position", "座標"},
    {UiText::degree, "degree", "次数"},
    {UiText::neighbours, "neighbours", "隣接"},
    {UiText::length, "length", "長さ"},
    {UiText::angle, "dihedral angle", "二面角"},
    {UiText::area, "area", "面積"},
    {UiText::corners, "corners", "角"},
    {UiText::normal, "normal", "法線"},
    {UiText::from, "from", "始点"},
    {UiText::to, "to", "終点"},
    {UiText::next, "next", "次"},
    {UiText::prev, "prev", "前"},
    {UiText::twin, "twin", "対"},
    {UiText::boundary, "on the boundary", "境界上"},
    {UiText::nonmanifold, "not manifold", "非多様体"},
    {UiText::misoriented, "misoriented", "向きの不一致"},
    {UiText::outside, "outside", "外側"},
    {UiText::isolated, "isolated", "孤立"},
    {UiText::copies, "copies", "複製"},
    {UiText::line_in_file, "line", "行"},
    {UiText::mouse, "Mouse", "マウス"},
    {UiText::key, "Keys", "キー"},
    {UiText::wheel, "Wheel", "ホイール"},
    {UiText::does_pick, "select", "選択"},
    {UiText::folder_up, "Folder above", "上のフォルダ"},
    {UiText::file_name, "File name", "ファイル名"},
    {UiText::replace_question, "This file exists; save again to replace it.",
     "同じ名前のファイルがあります。もう一度保存すると置き換えます。"},
    {UiText::loss_question, "Save again to write it all the same.", "それでも書き出すにはもう一度保存してください。"},
    {UiText::cancel, "Cancel", "取り消し"},
    {UiText::discard, "Discard", "破棄"},
    {UiText::unsaved_question, "There are changes that are not saved.", "保存していない変更があります。"},
    {UiText::recover_question, "Ryosen ended before these edits were saved.",
     "次の編集を保存しないまま Ryosen が終了しました。"},
    {UiText::recover, "Recover", "復元"},
    {UiText::panel_menu, "Fold, move or hide this panel", "折り畳む・移す・隠す"},
    {UiText::panel_fold, "Fold", "折り畳む"},
    {UiText::panel_unfold, "Unfold", "開く"},
    {UiText::panel_to_left, "Put on the left", "左に移す"},
    {UiText::panel_to_right, "Put on the right", "右に移す"},
    {UiText::panel_hide, "Hide", "隠す"},
    {UiText::panel_hide_help, "The View menu shows it again.", "「表示」メニューで再び表示できます。"},
    {UiText::later, "Later", "後で"},
    {UiText::done, "done", "実行しました"},
    {UiText::language_other, "日本語", "English"},
};
static_assert(rows_are_in_order(text_rows, &TextRow::id));

}  // namespace

const char* text(UiText id, Language language) {
  const TextRow& row = text_rows[static_cast<std::size_t>(id)];
  return language == Language::japanese ? row.ja : row.en;
}

}  // namespace ryosen
