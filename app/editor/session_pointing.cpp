// What the pointer does to a session: hovering, held verdicts, clicks; and what is picked and selected by it.
#include <algorithm>
#include <glm/geometric.hpp>

#include "app/editor/commands.h"
#include "app/editor/pick_modes.h"
#include "app/editor/session.h"
#include "core/mesh/copies.h"
#include "core/mesh/find_element.h"
#include "core/selection/slot_ranges.h"

namespace ryosen {

namespace {

// The kind of element the tool needs under the pointer; without a tool, the current mode.
PickMode pick_mode(const OpInfo* tool, PickMode mode) {
  if (!tool) return mode;
  switch (tool->target) {
    case OpTargetKind::vertex:
      return PickMode::vertex;
    case OpTargetKind::edge:
      return PickMode::edge;
    case OpTargetKind::face:
      return PickMode::face;
    default:
      return mode;
  }
}

}  // namespace

// Only the picked element; the others are none.
OpTarget Session::target_of(const Picked& picked, Modifiers modifiers) const {
  if (picked.element.kind == Element::Kind::vertex) return {Halfedge(), 0.5, picked.element.vertex()};
  if (picked.element.kind == Element::Kind::face) return {Halfedge(), 0.5, Vertex(), picked.element.face()};
  constexpr double small_px = 24;
  const auto a = project(camera, view, mesh().position(mesh().from(picked.halfedge)));
  const auto b = project(camera, view, mesh().position(mesh().to(picked.halfedge)));
  OpTarget target{picked.halfedge, picked.along};
  target.is_free = modifiers.shift;
  target.is_small = a && b && glm::length(a->pixel - b->pixel) < small_px;
  return target;
}

PickMode Session::pointed_sort() const { return pick_mode(find_op(tool), mode); }

void Session::point_at(glm::dvec2 pixel, Modifiers modifiers) {
  if (!is_verdict_held_ && !gesturing_) look_at(pixel, modifiers);
}

void Session::point_away() {
  if (!is_verdict_held_) hover_.reset();
}

// Of the same operator: the camera may have moved, so that another element is where the click was.
void Session::ask_held_verdict_again() {
  if (is_alive(mesh(), hover_->picked.element)) {
    hover_->preview = document_->preview(*hover_->op);
    is_verdict_held_ = !hover_->preview.verdict.legal() && !hover_->preview.verdict.has(Rule::deleted);
    if (is_verdict_held_) return;
  }
  release_verdict();
  hover_.reset();
}

void Session::look_at(glm::dvec2 pixel, Modifiers modifiers) {
  hover_.reset();
  const OpInfo* info = find_op(tool);
  const auto picked = pick(pixel, pointed_sort());
  if (!picked) return;
  Hover hover;
  hover.pixel = pixel;
  hover.modifiers = modifiers;
  hover.picked = *picked;
  if (info && is_tool(*info)) {
    hover.op = op_at(mesh(), tool, target_of(*picked, modifiers));
    hover.preview = document_->preview(*hover.op);
  }
  hover_ = std::move(hover);
}

const std::vector<std::string>& Session::hover_remedy() {
  static const std::vector<std::string> none;
  if (!hover_ || !hover_->op || hover_->preview.verdict.legal()) return none;
  std::string line = command_of(mesh(), *hover_->op);
  if (line != remedy_line_ || remedy_revision_ != document_->revision()) {
    remedy_ = document_->remedy(line);
    remedy_line_ = std::move(line);
    remedy_revision_ = document_->revision();
  }
  return remedy_;
}

std::vector<std::string> Session::names_of(const Elements& elements) const {
  std::vector<std::string> names;
  for (const Element& element : elements)
    names.push_back(element.kind == Element::Kind::vertex ? name_of_copy(mesh(), element.vertex())
                                                          : name_of(mesh(), element));
  return names;
}

std::string Session::select_line() const {
  constexpr std::size_t most_names = 20;
  if (selection.size() <= most_names) {
    std::string line = "select";
    for (const Element& e : selection)
      line += " " + (e.kind == Element::Kind::vertex ? name_of_copy(mesh(), e.vertex()) : name_to_select(mesh(), e));
    return line;
  }
  return "select" + slot_ranges(selection);
}

Outcome Session::apply_at(const OpTarget& target, const std::string& id) {
  return run(command_of(mesh(), op_at(mesh(), id, target)));
}

Outcome Session::click(glm::dvec2 pixel, const std::string& with_tool, Modifiers modifiers) {
  cancel_gesture();  // what is pointed at is the mesh as it is
  release_verdict();
  const OpInfo* info = find_op(with_tool);
  const auto picked = pick(pixel, pick_mode(info, mode));
  const bool extends = !info && (modifiers.shift || modifiers.ctrl);
  if (!picked) {
    if (!extends) selection.clear();
    if (!info) return {};
    const PickModeRow& sort = pick_modes[static_cast<std::size_t>(pick_mode(info, mode))];
    return failed(ExitCode::found_problems,
                  {"there is nothing under the pointer that it works on. " + std::string(sort.point_en),
                   "ポインタの下に対象がありません。" + std::string(sort.point_ja)});
  }
  if (info) {
    Outcome outcome = apply_at(target_of(*picked, modifiers), with_tool);
    if (outcome.kind != Outcome::Kind::refused || with_tool != tool) return outcome;
    look_at(pixel, modifiers);
    is_verdict_held_ = hover_ && hover_->op && !hover_->preview.verdict.legal();
    return outcome;
  }
  const std::string how = !extends ? "" : modifiers.ctrl ? "toggle " : "add ";
  return run("select " + how + name_to_select(mesh(), picked->element));
}

void Session::select_for_menu(glm::dvec2 pixel) {
  cancel_gesture();
  auto picked = pick(pixel, mode);
  if (!picked) picked = pick(pixel, PickMode::face);
  if (!picked || std::find(selection.begin(), selection.end(), picked->element) != selection.end()) return;
  run("select " + name_to_select(mesh(), picked->element));
}

std::optional<Picked> Session::pick(glm::dvec2 pixel, PickMode what) {
  const glm::dvec2 inside = pixel - view_origin;
  if (inside.x < 0 || inside.y < 0 || inside.x >= view.width || inside.y >= view.height) return std::nullopt;
  if (preparation_) return std::nullopt;
  return picker().pick(mesh(), camera, view, inside, what, pick_depth());
}

Picker::Depth Session::pick_depth() const {
  return settings.xray == Xray::on ? Picker::Depth::through : Picker::Depth::seen;
}

std::vector<Element> Session::about(const ProblemRow& row, Element element) {
  if (!row.is_local()) return {element};
  const IndexSet& members = highlights().of(row.kind);
  // Of what is several in the kernel one is a member.
  std::vector<Element> same{element};
  if (element.kind == Element::Kind::vertex) same = {point(mesh(), element.vertex())};
  if (element.kind == Element::Kind::edge)
    for (Halfedge h : sheets_between(mesh(), ends(mesh(), element.edge()).first, ends(mesh(), element.edge()).second))
      same.emplace_back(edge(h));
  const Element::Kind kind = row.vertex ? Element::Kind::vertex : row.edge ? Element::Kind::edge : Element::Kind::face;
  for (const Element& e : same) {
    if (e.kind != kind || !members.contains(e.index)) continue;
    Neighbourhood around(mesh());
    return ryosen::about(row, around, members, e);
  }
  return {element};
}

}  // namespace ryosen
