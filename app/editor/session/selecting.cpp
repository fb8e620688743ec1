#include "app/editor/session/selecting.h"

#include <algorithm>
#include <chrono>

#include "app/editor/session/asking.h"
#include "app/editor/session/session.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/parameters/op_argument.h"

namespace ryosen {

PickMode pick_mode(const OpInfo* tool, PickMode mode) {
  if (tool && tool->target == OpTargetKind::vertex) return PickMode::vertex;
  if (tool && tool->target == OpTargetKind::edge) return PickMode::edge;
  if (tool && tool->target == OpTargetKind::face) return PickMode::face;
  return mode;
}

const Mesh& Selecting::mesh() const { return session_.mesh(); }

PickMode Selecting::pointed_sort(Modifiers modifiers) const {
  if (!asked_line.empty()) return asked_for(asked_line).value_or(mode);
  const OpInfo* const info = find_op(tool);
  return !info && click_selects(modifiers) != ClickSelects::element ? PickMode::edge : pick_mode(info, mode);
}

std::vector<std::string> Selecting::names_of(const Elements& elements) const {
  std::vector<std::string> names;
  for (const Element& element : elements) names.push_back(print_argument(mesh(), element));
  return names;
}

std::string Selecting::select_line() const {
  constexpr std::size_t most_names = 20;
  if (selection.size() <= most_names) {
    std::string line = "select";
    for (const Element& e : selection)
      line += " " + (e.kind == Element::Kind::vertex ? name_of_copy(mesh(), e.vertex()) : name_to_select(mesh(), e));
    return line;
  }
  return "select" + slot_ranges(selection);
}

void Selecting::hide(std::span<const Element> elements) {
  if (session_.findings().hide(elements)) follow_hiding();
}

void Selecting::isolate(std::span<const Element> elements) {
  if (session_.findings().isolate(elements)) follow_hiding();
}

void Selecting::unhide() {
  if (session_.findings().unhide()) follow_hiding();
}

void Selecting::follow_hiding() {
  session_.findings().drop_hidden(selection.changed());
  if (!hover_) return;
  if (is_verdict_held_ && session_.findings().hidden().hides(mesh(), hover_->picked.element)) release_verdict();
  session_.pointing.point_at(hover_->pixel, hover_->modifiers);
}

// Of the same operator: the camera may have moved, so that another element is where the click was.
void Selecting::ask_held_verdict_again() {
  if (is_alive(mesh(), hover_->picked.element)) {
    hover_->preview = session_.document().preview(*hover_->op);
    is_verdict_held_ = !hover_->preview.verdict.legal() && !hover_->preview.verdict.has(Rule::deleted);
    if (is_verdict_held_) return;
  }
  release_verdict();
  hover_.reset();
}

const std::vector<std::string>& Selecting::hover_remedy() {
  static const std::vector<std::string> none;
  if (!hover_ || !hover_->op || hover_->preview.verdict.legal()) return none;
  std::string line = command_of(mesh(), *hover_->op);
  if (line != remedy_line_ || remedy_revision_ != session_.document().revision()) {
    remedy_ = session_.document().remedy(line);
    remedy_line_ = std::move(line);
    remedy_revision_ = session_.document().revision();
  }
  return remedy_;
}

// While another mesh is on trial, or the selection is moved, they are kept for what comes back.
ToolVerdicts* Selecting::tool_verdicts() {
  const OpInfo* const info = find_op(tool);
  if (!session_.view.shows_verdicts || !info || !is_tool(*info) || session_.findings().preparing()) {
    tool_verdicts_.reset();
    return nullptr;
  }
  if (session_.gesturing.is_active() || session_.shown.by() != ShownBy::document) return nullptr;
  const PickMode pointed = pick_mode(info, mode);
  const Element::Kind sort = pointed == PickMode::vertex ? Element::Kind::vertex
                             : pointed == PickMode::face ? Element::Kind::face
                                                         : Element::Kind::edge;
  if (!tool_verdicts_ || &tool_verdicts_->op() != info || tool_verdicts_->sort() != sort)
    tool_verdicts_ = std::make_unique<ToolVerdicts>(mesh(), *info, sort);
  if (!session_.frontend.asks_in_slices) tool_verdicts_->ask(mesh());
  return tool_verdicts_.get();
}

void Selecting::ask_slice_of_verdicts() {
  if (!session_.frontend.asks_in_slices || !tool_verdicts()) return;
  constexpr std::chrono::milliseconds slice{4};
  const auto end = std::chrono::steady_clock::now() + slice;
  tool_verdicts_->ask(mesh(), [&] { return std::chrono::steady_clock::now() < end; });
}

void Selecting::hold_verdict() { is_verdict_held_ = hover_ && hover_->op && !hover_->preview.verdict.legal(); }

void Selecting::follow(const Journal& journal, std::size_t transaction, Document::Change change,
                       const TouchedElements& touched) {
  const Mesh& m = mesh();
  const bool is_trial = change == Document::Change::tried || change == Document::Change::trial_ended;
  if (tool_verdicts_ && touched.everything)
    tool_verdicts_.reset();
  else if (tool_verdicts_ && !is_trial)
    tool_verdicts_->follow(m, touched);
  if (change == Document::Change::made) {
    const HistoryEntry& entry = session_.document().history()[transaction];
    std::optional<SelectionMemory::Passage> passage;
    if (touched.everything) passage = {entry.lineage, entry.descent.get()};
    memory.made(transaction, selection.changed(), m, passage, journal.lengths_before(transaction));
  }
  if (change == Document::Change::undone) memory.undone(transaction, selection.changed(), m, touched.everything);
  if (change == Document::Change::redone) memory.redone(transaction, selection.changed(), m, touched.everything);
  if (change == Document::Change::tried && touched.everything) {
    selection.clear();
    measures.clear();
  }
  if (change == Document::Change::tried) drop_lost(selection.changed(), m, false);
}

void Selecting::refresh() {
  session_.findings().drop_hidden(selection.changed());
  if (is_verdict_held_)
    ask_held_verdict_again();
  else if (hover_)
    session_.pointing.point_at(hover_->pixel, hover_->modifiers);
}

void Selecting::forget_pointed() {
  hover_.reset();
  tool_verdicts_.reset();
  release_verdict();
}

void Selecting::begin_document() {
  forget_pointed();
  remedy_line_.clear();
  selection.clear();
  memory.clear();
  measures.clear();
}

}  // namespace ryosen
