// The panels of the window and what they share. A new panel is one file in panels/ and one line in the list.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editor/session.h"
#include "app/ui/fonts.h"
#include "app/ui/style.h"
#include "app/ui/texts.h"
#include "core/analysis/problems.h"
#include "core/forms/comparison.h"

namespace ryosen {

// What waits for the answer to "there are changes that are not saved".
struct PendingLeave {
  bool quits = false;
  std::filesystem::path opens;  // empty: an empty mesh
  std::string command{};        // where not empty, the one that does it, in place of the above
};

// The file browser: a folder, what is in it, and the name in the field.
struct FileBrowser {
  struct Entry {
    std::string name;
    bool is_folder = false;
  };
  std::filesystem::path folder;
  std::vector<Entry> entries;  // folders first, by name
  std::string name;
  bool is_open = false;
  // What the next press of the button does all the same: replace this existing file, lose this in this file.
  std::filesystem::path replaces, loses;
  std::vector<Message> losses;
};

// What the forms panel measured when it was last asked, and of which state of which document.
struct MeasuredForms {
  forms::Comparison comparison;
  std::uint64_t document = 0;  // its serial number
  std::uint64_t revision = 0;
};

// What the window remembers between frames beside the session.
struct GuiState {
  Text last_outcome;  // of the last command that was sent from here
  Outcome::Kind last_kind = Outcome::Kind::done;
  bool wants_quit = false;  // confirmed
  bool is_laying_out = false;
  std::vector<std::string> waiting;  // lines of long work, which begins when the frame is laid out
  PendingLeave pending;
  FileBrowser browser;
  std::string command;                // what stands in the field of the command window
  bool command_was_begun = false;     // the field has just appeared
  std::size_t scrolled_position = 0;  // the place of the history that the list was scrolled to

  std::optional<MeasuredForms> measured_forms;
  forms::Relation shown_relation = forms::Relation::vertex_vertices;  // whose query times the forms panel shows

  // What was found of a kind, without a list of it: how many, and which is the nth. Cheap after an edit; only the list
  // of boundary loops is made anew for finding() when the edit has changed loops.
  std::size_t findings(Session& session, const ProblemRow& row);
  Element finding(Session& session, const ProblemRow& row, std::size_t n);

 private:
  void know(const Session& session);

  std::uint64_t known_document_ = 0;  // its serial number
  std::size_t known_set_aside_ = 0;   // how many faces; a repair may drop them
  std::array<std::vector<Element>, problem_kinds> quarantined_;
  std::vector<Element> loops_;  // by their lowest edges, as of this revision of the count
  std::optional<std::uint64_t> known_loops_;
};

// One frame of one panel.
struct PanelContext {
  Session& session;
  GuiState& state;
  Fonts fonts;
  Theme theme;
  float scale;

  Language language() const { return session.language; }
  const char* text(UiText id) const { return ryosen::text(id, session.language); }
  const char* text(std::string_view en, std::string_view ja) const {
    return session.language == Language::japanese ? ja.data() : en.data();
  }
  const UiColours& colours() const { return ui_colours(theme); }

  // Sends a command line and keeps its outcome for the status line. Long work waits until the frame is laid out.
  Outcome run(const std::string& line);
  // A click of the current tool, or a selection, at a pixel of the window.
  Outcome click(glm::dvec2 pixel);
  // Keeps an outcome for the status line: the sentence of one, or that what it performed is done, or nothing.
  Outcome keep(Outcome outcome);
  // Opens a file or ends the program, after a question where changes would be lost.
  void leave(PendingLeave where);
  // Without a question.
  void go(const PendingLeave& where);
};

enum class Side { left, right };

struct Panel {
  UiText title;
  Side side;
  void (*draw)(PanelContext& context);  // the content, within the column
};
std::span<const Panel> panels();

// The parts around the columns.
void draw_menu(PanelContext& context);
void draw_status(PanelContext& context);
// What lies over the view: the tip beside the pointer, and the panel that session.open_panel names.
void draw_pointer_tip(PanelContext& context);
void draw_keys_window(PanelContext& context);
void draw_file_window(PanelContext& context);
void draw_command_window(PanelContext& context);
void draw_unsaved_window(PanelContext& context);
void draw_recover_window(PanelContext& context);
// Over everything while long work goes on; true when it is to be cancelled. The session is not looked at.
bool draw_progress_window(Language language, float scale, double share);

}  // namespace ryosen
