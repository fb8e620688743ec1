// What is selected and pointed at in the document, and with which tool: the same in all views of it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editor/input/input.h"
#include "app/editor/session/selection.h"
#include "app/editor/views/view.h"
#include "ryosen/document/document.h"
#include "ryosen/ops/preview/tool_verdicts.h"
#include "ryosen/scene/pick/picker.h"

namespace ryosen {

class Session;

// The sort of element that a tool needs under the pointer; without a tool, the mode.
PickMode pick_mode(const OpInfo* tool, PickMode mode);

// The element of the open document under the pointer, and what a click would do.
struct Hover : Pointed {
  Modifiers modifiers;
  std::optional<AnyOp> op;  // if the tool applies to what was picked
  Preview preview;          // of that operator
};

class Selecting {
 public:
  explicit Selecting(Session& session) : session_(session) {}

  std::string tool;  // id of an operator, or empty: select
  PickMode mode = PickMode::edge;
  std::string asked_line;  // of an operator: each click adds an element to it (asking.h); empty for none
  // Each entry of the history remembers what was selected around it, and brings it back.
  Selection selection;
  SelectionMemory memory;
  std::vector<Elements> measures;  // what was asked for, in that order; read anew when it is shown

  // What the pointer picks with these keys held: what the tool applies to, the edge whose loop is asked for, else what
  // `mode` says.
  PickMode pointed_sort(Modifiers modifiers = {}) const;
  // The selected elements as command lines name them, in order; distinguishes copies of a point.
  std::vector<std::string> selected_names() const { return names_of(selection); }
  std::vector<std::string> names_of(const Elements& elements) const;
  // The line that selects them: by names where they are few, else by numbers, several in a row as v3..v9.
  std::string select_line() const;

  // As those of the findings; what gets hidden is no longer selected.
  void hide(std::span<const Element> elements);
  void isolate(std::span<const Element> elements);
  void unhide();

  const std::optional<Hover>& hover() const { return hover_; }
  void point_to(std::optional<Hover> hover) { hover_ = std::move(hover); }
  // A click that is refused holds what it pointed at: until the next click, `cancel`, or another tool or mode the hover
  // stays as it is, so that the pointer can go to its reasons and remedies. An edit asks its operator anew, and ends it
  // where that has become legal or its element is gone.
  bool is_verdict_held() const { return is_verdict_held_; }
  void hold_verdict();
  void release_verdict() { is_verdict_held_ = false; }
  // The remedy for the operator under the pointer; empty if none was found. Computed on demand, because candidates are
  // tried out, and cached while operator and mesh are unchanged.
  const std::vector<std::string>& hover_remedy();
  // Of the tool in hand on all elements that it acts on; null where they are not to be shown. Kept up with edits.
  // Complete, but for a window, which asks a slice of them before each frame.
  ToolVerdicts* tool_verdicts();
  void ask_slice_of_verdicts();
  // The share that is asked while that goes on.
  std::optional<double> asking_verdicts() const {
    return tool_verdicts_ && !tool_verdicts_->is_complete() ? std::optional(tool_verdicts_->share()) : std::nullopt;
  }

  // For the session: behind a change of the document; and once another mesh that was on trial has given its place back.
  void follow(const Journal& journal, std::size_t transaction, Document::Change change, const TouchedElements& touched);
  void refresh();
  // Nothing is pointed at any more.
  void forget_pointed();
  // Nothing is selected, measured or pointed at in another document.
  void begin_document();

 private:
  const Mesh& mesh() const;
  void follow_hiding();
  void ask_held_verdict_again();

  Session& session_;
  std::optional<Hover> hover_;
  bool is_verdict_held_ = false;
  std::unique_ptr<ToolVerdicts> tool_verdicts_;
  std::vector<std::string> remedy_;  // for remedy_line_ at remedy_revision_
  std::string remedy_line_;
  std::uint64_t remedy_revision_ = 0;
};

}  // namespace ryosen
