// The editor state without window and rendering: document, selection, visibility, camera, hover. The window, the
// command line, scripts and tests all change it through the same command lines.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "app/editor/camera/view_state.h"
#include "app/editor/document/repair_trials.h"
#include "app/editor/document/run_files.h"
#include "app/editor/input/corner_axes.h"
#include "app/editor/input/gizmo.h"
#include "app/editor/preferences/layout.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/recovery/recovery.h"
#include "app/editor/session/findings.h"
#include "app/editor/session/frontend.h"
#include "app/editor/session/selection.h"
#include "app/editor/session/selection_memory.h"
#include "app/editor/shown/shown.h"
#include "app/editor/shown/transform_gesture.h"
#include "app/editor/textbook/asked_question.h"
#include "ryosen/document/document.h"
#include "ryosen/ops/outlook/tool_verdicts.h"
#include "ryosen/pick/picker.h"

namespace ryosen {

class Autosave;

// The element under the pointer, and what a click would do.
struct Hover {
  glm::dvec2 pixel{0};
  Modifiers modifiers;
  Picked picked;
  std::optional<AnyOp> op;  // if the tool applies to what was picked
  Preview preview;          // of that operator
};

class Session {
 public:
  explicit Session(std::unique_ptr<Document> document);

  Document& document() { return *document_; }
  const Document& document() const { return *document_; }
  const Mesh& mesh() const { return document_->mesh(); }
  // What follows from the mesh. Of another document they are others.
  Findings& findings() { return *findings_; }
  const Findings& findings() const { return *findings_; }
  // What repairs would do.
  RepairTrials trials;

  // Executes a command line (see commands.h) and logs it if done. Never throws on user input.
  Outcome run(const std::string& line);
  // What is carried out at the moment, by its name.
  Text at_work() const;
  // The command lines executed so far: a script that reproduces the state.
  const std::vector<std::string>& log() const { return log_; }

  // Which mesh the view shows.
  Shown shown{*this};

  // State changed by commands.
  // How the mesh is looked at.
  ViewState view;
  // Gives the view all of the picture that is not covered by panels: the left half where a mesh stands beside it.
  void place_view(Size whole, glm::dvec2 origin);
  std::string tool;  // id of an operator, or empty: select
  PickMode mode = PickMode::edge;
  std::string asked_line;  // of an operator: each click adds an element to it (asking.h); empty for none
  // Each entry of the history remembers what was selected around it, and brings it back.
  Selection selection;
  SelectionMemory selections;
  std::vector<Elements> measures;       // what was asked for, in that order; read anew when it is shown
  std::optional<AskedQuestion> asked_question;
  // User interface state changed by commands; stored without effect if there is no UI.
  Preferences preferences;
  Layout layout;
  bool begins_empty = false;            // somebody wants an empty mesh, not the start page
  bool awaits_file = false;             // that is read just now: nothing is offered meanwhile
  std::vector<LostSession> lost;        // as last listed

  // What the pointer picks with these keys held: what the tool applies to, the edge whose loop is asked for, else what
  // `mode` says.
  PickMode pointed_sort(Modifiers modifiers = {}) const;

  // The axes in the corner of the view, where a switch shows them and there is room; the end that is at a pixel of the
  // picture or window, and the one that the pointer is on. A click on one looks from there.
  std::optional<CornerAxes> axes_in_corner() const;
  const AxisEnd* axis_end_at(glm::dvec2 pixel) const;
  const AxisEnd* pointed_axis_end() const { return pointed_axis_end_; }

  // Another mesh beside this one in the picture, to be compared with: seen by the same camera in the same way, never
  // edited. Null ends that. Both are framed anew.
  void put_beside(std::unique_ptr<Session> other);
  bool has_beside() const { return beside_ != nullptr; }
  // Null where there is none; up to date with what is looked at and how.
  Session* beside();
  // This, or the mesh beside it where a pixel of the picture or window lies in its part.
  Session& part_at(glm::dvec2 pixel);
  // The handles that move the selection, where the switch shows them: with Select in hand, at the middle of what is
  // selected. None while it is moved.
  std::optional<Gizmo> gizmo() const;
  // The one at a pixel of the picture or window; none where Shift or Alt ask for something else. And the one that the
  // pointer is on.
  const HandleRow* handle_at(glm::dvec2 pixel, Modifiers modifiers) const;
  const HandleRow* pointed_handle() const { return pointed_handle_; }

  // There is nothing yet, and nobody has said that this is wanted.
  bool is_at_start() const;
  // There is no mesh, and none is shown or read.
  bool is_empty() const;
  bool strict = false;           // warnings refuse too
  RunFiles files{
      RunFiles::Policy::by_kind};  // asked before a command writes; another policy is set by whoever runs scripts
  Frontend frontend;
  // Where the events of scripts go.
  Input& input();

  // Hovering, at pixels from the upper left corner of the picture or window. The picker is updated after every edit.
  void point_at(glm::dvec2 pixel, Modifiers modifiers = {});
  void point_away();
  const std::optional<Hover>& hover() const { return hover_; }
  // A click that is refused holds what it pointed at: until the next click, `cancel`, or another tool or mode the hover
  // stays as it is, so that the pointer can go to its reasons and remedies. An edit asks its operator anew, and ends it
  // where that has become legal or its element is gone.
  bool is_verdict_held() const { return is_verdict_held_; }
  void release_verdict() { is_verdict_held_ = false; }
  // The remedy for the operator under the pointer; empty if none was found. Computed on demand, because candidates are
  // tried out, and cached while operator and mesh are unchanged.
  const std::vector<std::string>& hover_remedy();
  // Of the tool in hand on all elements that it acts on; null where they are not to be shown. Kept up with edits. Complete,
  // but for a window, which asks a slice of them in prepare().
  ToolVerdicts* tool_verdicts();
  // The share that is asked while that goes on.
  std::optional<double> asking_verdicts() const {
    return tool_verdicts_ && !tool_verdicts_->is_complete() ? std::optional(tool_verdicts_->share()) : std::nullopt;
  }
  // A click: applies the tool to what is under the pixel, or selects it. With Shift a tool puts things exactly where the
  // pointer is.
  Outcome click(glm::dvec2 pixel, const std::string& with_tool, Modifiers modifiers = {});

  // Moving, turning or scaling the selection by hand. While that lasts only the view changes; its end is one command.
  // Commands that edit end it without one.
  Outcome begin_gesture(PointTransform::Kind kind);
  // Extrudes the selected faces and moves them: one command in the end, and nothing where it is given up.
  Outcome begin_pull();
  // Splits an edge and moves its new vertex, in the same way: that under the tool in hand, else the one that is selected.
  Outcome begin_split();
  // Duplicates the selection and moves the copy, in the same way.
  Outcome begin_copy();
  const TransformGesture* gesture() const;  // null: none goes on
  void follow_gesture(glm::dvec2 pixel, Modifiers modifiers);
  std::optional<Outcome> gesture_key(const std::string& chord);  // none: there is no gesture
  bool widen_gesture(double steps);
  Outcome end_gesture();
  Outcome give_up_gesture();  // says what it leaves
  void cancel_gesture();

  // The places of vertices as they are drawn, those of the mesh but for a gesture; the step goes up with it.
  std::span<const glm::dvec3> drawn_positions() const;
  std::uint64_t gesture_step() const { return gesture_step_; }
  // Faces that it would turn over or leave without area.
  std::span<const Face> spoilt_by_gesture() const;

  // What a menu at a pixel is about is selected, if it is not so already.
  void select_for_menu(glm::dvec2 pixel);

  // The selected elements as command lines name them, in order; distinguishes copies of a point.
  std::vector<std::string> selected_names() const { return names_of(selection); }
  std::vector<std::string> names_of(const Elements& elements) const;
  // The line that selects them: by names where they are few, else by numbers, several in a row as v3..v9.
  std::string select_line() const;

  // As those of the findings; what gets hidden is no longer selected.
  void hide(std::span<const Element> elements);
  void isolate(std::span<const Element> elements);
  void unhide();

  // The element of the document under a pixel; none outside the view, and none while another mesh is on trial.
  std::optional<Picked> pick(glm::dvec2 pixel, PickMode what);
  // What a click there would select: as that edits nothing, it reaches farther on the surface.
  std::optional<Picked> pick_to_select(glm::dvec2 pixel, PickMode what);
  // What is drawn under a pixel, for who needs its place alone.
  std::optional<Picked> pick_drawn(glm::dvec2 pixel, PickMode what, double radius_px = pick_radius_px);
  Picker::Depth pick_depth() const;

  // For windows, before each frame: goes on with what is found in the background.
  void prepare();

  // Whether the document's file has changed on disk, as it was last looked at: for windows, now and then, and before a
  // save. True where that is news.
  bool look_at_disk();
  FileState::Change change_on_disk() const { return change_on_disk_; }

  // Replaces the document; resets selection, hover and log.
  // `read_from` is the file that it was read from, where that is not its own: no output of the run takes its place.
  void set_document(std::unique_ptr<Document> document, std::optional<std::filesystem::path> read_from = {});
  void frame_all();
  // Whether the camera is where frame_all() has put it last.
  bool is_framed() const { return framed_ == view.camera; }
  // For titles: the name of the file, or that there is none; empty at the start.
  std::string document_name() const;

 private:
  friend class Shown;  // keeps what is found while another mesh is shown, and forgets it where memory runs out

  Outcome run_line(const std::string& line);
  // The log has room for it.
  void log_line(Outcome& outcome, std::string line);
  // Updates what is derived from the mesh; forgets that where there is no memory for it.
  void follow(const Journal& journal, std::size_t transaction, Document::Change change);
  void update_derived(const Journal& journal, std::size_t transaction, Document::Change change);
  void forget_derived();
  void ask_slice_of_verdicts();
  void follow_hiding();
  Outcome select_along(glm::dvec2 pixel, Modifiers modifiers);
  Outcome apply_at(const OpTarget& target, const std::string& id);
  void look_at(glm::dvec2 pixel, Modifiers modifiers);
  const LinkArrow* arrow_at(glm::dvec2 pixel, const OpInfo* info, Modifiers modifiers);
  OpTarget target_of(const Picked& picked, Modifiers modifiers) const;
  void ask_held_verdict_again();

  struct Gesturing;
  struct GesturingDeleter {
    void operator()(Gesturing* gesturing) const;
  };
  void begin_gesture_with(PointTransform::Kind kind, Elements elements);
  void forget_gesture();
  void follow_what_moves();
  void show_gesture();
  void note_gesture();
  // Problems that depend on places, of the faces that a gesture changes: as they are drawn, or as they are.
  void judge_as_drawn();
  void list_coincident(bool are_listed);  // of points that lie on others by what is on trial
  void judge_as_is();

  std::unique_ptr<Session> beside_;
  std::unique_ptr<Document> document_;
  std::unique_ptr<Findings> findings_;
  std::unique_ptr<Gesturing, GesturingDeleter> gesturing_;
  std::uint64_t gesture_step_ = 0;
  FileState::Change change_on_disk_ = FileState::Change::none;
  Camera framed_;
  std::optional<Hover> hover_;
  const HandleRow* pointed_handle_ = nullptr;
  const AxisEnd* pointed_axis_end_ = nullptr;
  std::unique_ptr<ToolVerdicts> tool_verdicts_;
  struct Middle {
    std::uint64_t selection = 0;  // by its stamp
    std::uint64_t document = 0, revision = 0;
    glm::dvec3 place{0};
  };
  mutable Middle middle_;  // of the selection, as it was last asked for
  bool is_verdict_held_ = false;
  std::vector<std::string> log_;
  std::string running_;              // the first word of the line that is carried out
  std::size_t lines_logged_ = 0;     // in logs of earlier documents too
  std::vector<std::string> remedy_;  // for remedy_line_ at remedy_revision_
  std::string remedy_line_;
  std::uint64_t remedy_revision_ = 0;
  std::unique_ptr<Input> view_input_;         // made when it is asked for
};

}  // namespace ryosen
