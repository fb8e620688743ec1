// The panels and menus of the window, as far as the editor knows them: their ids and titles, and where panels lie. The
// window owns their content.
#pragma once

#include <iterator>
#include <span>
#include <string>
#include <string_view>

#include "app/editor/commands/text/words.h"
#include "ryosen/base/rows.h"

namespace ryosen {

// In a column beside the view until it is hidden, or over the view, one at a time.
enum class PanelPlace { left, right, over };

// Where the menu bar has an entry for it; of the file menu with what reads, or with what writes and brings back.
enum class PanelMenu { none, view, file_read, file_write, edit, help };
// What opens it besides the menu and the command `panel`.
enum class PanelOpener {
  nothing,
  unnamed_save,   // a save where the document has no file yet
  begun_line,     // a command that was begun elsewhere and needs its arguments
  loss,           // something that would lose changes that are not saved
  lost_sessions,  // the start, where a crash left something unsaved
  asked_values,   // the command `values`
  coloured,       // the command `colours`, or `measure`
  played,         // the command `steps`
  levelled,       // the command `levels`, or `account`
  practised,      // nothing else: the one whose question is marked in the view
};

// Before anybody has said anything. Held: shown, and the first of its column stays in view where that is scrolled.
enum class PanelAtFirst { shown, hidden, held };

// What is in it while the findings of a large mesh are being searched for (Session::prepare): itself if it reads the
// mesh alone, else how far the search is.
enum class PanelReads { mesh, findings };

struct PanelRow {
  std::string_view id;
  PanelPlace place;
  std::string_view title_en, title_ja;
  PanelMenu menu = PanelMenu::view;
  PanelOpener opened_by = PanelOpener::nothing;
  PanelAtFirst at_first = PanelAtFirst::shown;
  PanelReads reads = PanelReads::mesh;
  std::string_view help_en = "", help_ja = "";    // what it is for, in a sentence
  std::string_view short_en = "", short_ja = "";  // for a tab, where the title is long

  bool shown_at_first() const { return at_first != PanelAtFirst::hidden; }
  // Shown again the next time: not what would ask of the next mesh at once, out of sight perhaps.
  bool is_shown_again() const { return opened_by != PanelOpener::practised; }
};

// The lines of panels.def in their order, behind them what was added. Valid until another is added or taken away.
std::span<const PanelRow> panel_list();
const PanelRow* find_panel(std::string_view id);
// The one that is opened by this, not by nothing.
const PanelRow& panel_opened_by(PanelOpener opener);
// "tools, highlights, ...": what the command `panel` may name.
std::string panel_ids();

// One panel more for as long as this lives: for programs with panels of their own. The row's texts must live as long.
class ScopedPanel {
 public:
  explicit ScopedPanel(const PanelRow& row);
  ~ScopedPanel();
  ScopedPanel(const ScopedPanel&) = delete;
  ScopedPanel& operator=(const ScopedPanel&) = delete;

 private:
  std::string_view id_;
};

// A menu of the bar; they stand in their order. What is in them is the window's.
struct MenuRow {
  std::string_view id;  // as the command `menu` says it
  std::string_view title_en, title_ja;
};

inline constexpr MenuRow menu_bar[] = {
    {"file", "File", "ファイル"}, {"edit", "Edit", "編集"}, {"select", "Select", "選択"},
    {"view", "View", "表示"},     {"add", "Add", "追加"},   {"help", "Help", "ヘルプ"},
};

// Null where there is none.
inline const MenuRow* find_menu(std::string_view id) { return find_row(menu_bar, id); }

// "file|edit|..."
inline std::string menu_ids() { return joined_ids(menu_bar); }

}  // namespace ryosen
