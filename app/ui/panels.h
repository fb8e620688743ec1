// What a panel is, and what panels share. A new one is one file in panels/, with the state it keeps, and one line in
// app/editor/preferences/panels.def. It draws itself with Dear ImGui and widgets.h (a curve with log_plot.h, a
// histogram as ColoursPanel in colours.cpp); what it computes it keeps for a serial number and revision of the
// document, as that does. While a gesture goes on the mesh has no new revision: what is to follow it compares
// Gesturing::step(), too, and reads drawn_positions(). Golden pictures show the panels that are shown at first.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/editor/commands/text/command.h"
#include "app/editor/input/view/navigation.h"
#include "app/editor/preferences/panel_list.h"
#include "app/editor/session/owners.h"
#include "app/ui/fonts.h"
#include "app/ui/style.h"
#include "app/ui/texts.h"
#include "ryosen/document/outcome.h"
#include "ryosen/scene/view/size.h"
#include "ryosen/scene/view/view_settings.h"

namespace ryosen {

class RecordBook;

// What waits for the answer to "there are changes that are not saved".
struct PendingLeave {
  bool quits = false;
  std::filesystem::path opens{};  // empty: an empty mesh
  std::string command{};          // where not empty, the one that does it, in place of the above
  std::string asks_again{};       // the id of the panel that opens again where that fails; empty for none
  bool awaits_name = false;       // of the file to save to: it goes on once that is saved
  bool reads_again() const;       // what is in the file of the mesh
};

// A command that was sent while a frame is laid out, and how many further frames come before it is carried out.
struct WaitingCommand {
  Command command;
  int frames;
  std::string asks_again;  // the id of the panel that opens again where it fails; empty for none
};

// The answer to the last command that was sent from the window.
struct LastOutcome {
  Text sentence;
  std::vector<Text> shorter;  // the same in fewer words, for where there is no room, the longest first
  Outcome::Kind kind = Outcome::Kind::done;
};

struct MenuState {
  bool had_keys = false;  // one was open when the frame began
  bool closes = false;    // all of them, in the next frame
  bool opens = false;     // that of what is selected, in the next frame
  float room_px = 1;      // the height of that at most
};

// What the panels share beside the session. What one of them alone remembers are members of its own.
struct GuiState {
  LastOutcome last;
  MenuState menus;
  bool wants_quit = false;  // confirmed
  bool is_laying_out = false;
  std::vector<WaitingCommand> waiting;
  std::vector<PixelRect> notes;  // of what lies over the view and takes the pointer
  int unsettled_frames = 0;      // how many more are to be laid out although nothing comes in
  std::optional<PendingLeave> pending;
  bool is_tight = false;  // the column that is drawn is too long for its window: what says nothing may be left out
  float saved_px = 0;     // that its panels have saved by that
  bool asks_to_be_seen = false;         // the panel that is drawn: its column is to scroll to it
  bool asks_for_key = false;            // a panel waits for the next key
  std::string asked_key;                // the chord that came
  bool shows_japanese = false;          // a panel has Japanese words to show, whatever the language
  bool waits_for_work = false;          // a panel draws what is found in the background, when it is there
  std::shared_ptr<RecordBook> records;  // of all forms; null until a panel shows them
  bool wants_records = false;           // one of those is drawn in this frame
  std::string begun_command;            // what the command window takes into its field when it is open
  std::map<std::string_view, std::string> selector_values;  // what stands in the fields of the menu, by id

  // A panel may need this many frames to open, to settle its size, or to close.
  void unsettle() { unsettled_frames = 3; }
};

// One frame of one panel.
struct PanelContext {
  Session& session;
  GuiState& state;
  Fonts fonts;
  Theme theme;
  float scale;
  float column_scale;  // of the width of columns and panels, which grow with the letters
  ViewState& view = owner_of<ViewState>(session);
  Framing& framing = owner_of<Framing>(session);
  Selecting& selecting = owner_of<Selecting>(session);
  Pointing& pointing = owner_of<Pointing>(session);
  Gesturing& gesturing = owner_of<Gesturing>(session);
  Shown& shown = owner_of<Shown>(session);
  Preferences& preferences = owner_of<Preferences>(session);
  Layout& layout = owner_of<Layout>(session);
  RepairTrials& trials = owner_of<RepairTrials>(session);

  // The document that is open just now: a line that runs may put another in its place.
  Document& document() const;
  const Mesh& mesh() const;
  Findings& findings() const;

  Language language() const;
  const char* text(UiText id) const { return ryosen::text(id, language()); }
  const char* text(std::string_view en, std::string_view ja) const {
    return language() == Language::japanese ? ja.data() : en.data();
  }
  const char* title(const PanelRow& row) const { return text(row.title_en, row.title_ja); }
  const char* short_title(const PanelRow& row) const {
    return row.short_en.empty() ? title(row) : text(row.short_en, row.short_ja);
  }
  const UiColours& colours() const { return ui_colours(theme); }

  // Sends a command and keeps its outcome for the status line. Long work waits until the frame is laid out, and
  // what looks at the window until a later one has been drawn. Where edits that are not saved would be lost, or no file
  // to save to is known, it asks first. A panel that names itself is closed, and opens again where the line fails.
  Outcome run(const Command& command, const std::string& panel_id = {});
  // Without that question.
  Outcome run_from(const Command& command, const std::string& panel_id);
  // A click of the current tool, or a selection, at a pixel of the window.
  Outcome click(const Navigation::Click& click);
  // Keeps an outcome for the status line: the sentence of one, or that what it performed is done, or nothing.
  Outcome keep(Outcome outcome);
  // Opens the panel that this opens.
  Outcome open(PanelOpener opener);
  // Lets the user go on with a line in the command window.
  void begin_command(std::string line);
  // Opens a file or ends the program, after a question where changes would be lost.
  void leave(PendingLeave where);
  // Without a question.
  void go(PendingLeave where);
};

// What it keeps between frames are its members.
class Panel {
 public:
  virtual ~Panel() = default;
  // The content, within the column or window that it has.
  virtual void draw(PanelContext& context) = 0;
  // It was drawn in the last frame and is not any more.
  virtual void closed(PanelContext& context) { static_cast<void>(context); }
  // Over the view: at its right end, and the view is not dimmed, so that what it does can be seen there.
  virtual bool leaves_view() const { return false; }
  // At scale 1, over the view; a column gives as much as is needed.
  virtual ImVec2 size() const { return {560, 360}; }
  // In a column: how many lines it always takes, so that what is below stays where it is when the content follows the
  // pointer. 0: as many as it needs.
  virtual float lines() const { return 0; }
};

// A panel that keeps nothing.
std::unique_ptr<Panel> panel_of(void (*draw)(PanelContext& context), ImVec2 size = {});
std::unique_ptr<Panel> panel_of_lines(void (*draw)(PanelContext& context), float lines);
// One of each, in the order of panel_list() as it stands in panels.def.
std::vector<std::unique_ptr<Panel>> make_panels();

// Gives back the forms of the source texts that no panel of the frame has drawn. Call it again in the next frame while
// it returns false.
bool rest_records(GuiState& state);

// The parts around the columns.
void draw_menu(PanelContext& context);
void draw_status(PanelContext& context);
// Beside the pointer: why a click would be refused.
void draw_pointer_tip(PanelContext& context);
// In place of a panel that waits for findings.
void draw_preparing(PanelContext& context, double share);
// Over the view: that something is hidden, that the file has changed on disk, and what can be done about it.
void draw_notes(PanelContext& context);
// The menu of what is selected, where the right button was clicked.
void draw_element_menu(PanelContext& context);
// What a drag that selects has drawn so far.
void draw_band(PanelContext& context);
// How far work has come, or what it is where that is not known.
struct WorkShown {
  std::optional<double> share;  // none: nobody knows
  Text says = {};               // what is done
};
// Over everything while long work goes on; true when it is to be cancelled. The session is not looked at.
bool draw_progress_window(Language language, float scale, const WorkShown& work);

}  // namespace ryosen
