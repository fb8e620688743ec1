// What the pointer does to a session: hovering, held verdicts, clicks; and what is picked and selected by it.
#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>

#include "app/editor/commands/commands.h"
#include "app/editor/input/pick_modes.h"
#include "app/editor/session/asking.h"
#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"
#include "ryosen/selection/slot_ranges.h"

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

// A click on a mesh that stands beside the open one.
Outcome only_looked_at(const Session& beside) {
  const std::string name = beside.document().path().filename().string();
  return failed(
      ExitCode::refused,
      {name + " is shown here to be compared with: nothing of it is selected or changed. Open it to work on it.",
       name + " は比較のために表示しています。選択や編集をするには開いてください。"});
}

}  // namespace

// Only the picked element; the others are none.
OpTarget Session::target_of(const Picked& picked, Modifiers modifiers) const {
  if (picked.element.kind == Element::Kind::vertex) return {Halfedge(), 0.5, picked.element.vertex()};
  if (picked.element.kind == Element::Kind::face) return {Halfedge(), 0.5, Vertex(), picked.element.face()};
  const double small_px = 24 * preferences.size_scale();
  const auto a = project(view.camera, view.size, mesh().position(mesh().from(picked.halfedge)));
  const auto b = project(view.camera, view.size, mesh().position(mesh().to(picked.halfedge)));
  OpTarget target{picked.halfedge, picked.along};
  target.is_free = modifiers.shift;
  target.is_small = a && b && glm::length(a->pixel - b->pixel) < small_px;
  return target;
}

PickMode Session::pointed_sort(Modifiers modifiers) const {
  if (!asked_line.empty()) return asked_for(asked_line).value_or(mode);
  const OpInfo* const info = find_op(tool);
  return !info && click_selects(modifiers) != ClickSelects::element ? PickMode::edge : pick_mode(info, mode);
}

void Session::point_at(glm::dvec2 pixel, Modifiers modifiers) {
  if (!is_verdict_held_ && !gesturing_) look_at(pixel, modifiers);
}

void Session::point_away() {
  pointed_handle_ = nullptr;
  pointed_axis_end_ = nullptr;
  if (!is_verdict_held_) hover_.reset();
  if (beside_) beside_->point_away();
}

std::optional<Gizmo> Session::gizmo() const {
  if (view.gizmo_kind == GizmoKind::none || !tool.empty() || selection.empty() || gesturing_ || view.band ||
      shown.is_replaced())
    return std::nullopt;
  if (middle_.document != document_->serial() || middle_.revision != document_->revision() ||
      middle_.selection != selection.stamp())
    middle_ = {selection.stamp(), document_->serial(), document_->revision(),
               middle_of(mesh(), points_of(mesh(), selection))};
  return gizmo_at(view.gizmo_kind, view.camera, view.size, middle_.place, preferences.size_scale());
}

std::optional<CornerAxes> Session::axes_in_corner() const {
  return view.shows_axes ? corner_axes(view.camera, view.size, preferences.size_scale()) : std::nullopt;
}

const AxisEnd* Session::axis_end_at(glm::dvec2 pixel) const {
  const auto axes = axes_in_corner();
  return axes ? end_at(*axes, pixel - view.origin) : nullptr;
}

const HandleRow* Session::handle_at(glm::dvec2 pixel, Modifiers modifiers) const {
  if (modifiers.shift || modifiers.alt) return nullptr;
  const auto handles = gizmo();
  const GizmoHandle* const found =
      handles ? ryosen::handle_at(*handles, view.camera, view.size, pixel - view.origin, preferences.size_scale())
              : nullptr;
  return found ? found->row : nullptr;
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

// The arrow that a click would select, whatever the mode; null where it would not select one.
const LinkArrow* Session::arrow_at(glm::dvec2 pixel, const OpInfo* info, Modifiers modifiers) {
  const bool selects = !info && asked_line.empty() && !modifiers.shift && !modifiers.ctrl && !modifiers.alt;
  if (!selects || findings_->preparing() || shown.by() != ShownBy::document) return nullptr;
  return view.links.at(*this, pixel - view.origin);
}

void Session::look_at(glm::dvec2 pixel, Modifiers modifiers) {
  hover_.reset();
  if (beside_) beside_->point_away();
  if (Session& part = part_at(pixel); &part != this) return part.point_at(pixel);
  pointed_axis_end_ = axis_end_at(pixel);
  pointed_handle_ = pointed_axis_end_ ? nullptr : handle_at(pixel, modifiers);
  if (pointed_handle_ || pointed_axis_end_) return;
  const OpInfo* info = find_op(tool);
  Hover hover;
  hover.pixel = pixel;
  hover.modifiers = modifiers;
  if (const LinkArrow* const arrow = arrow_at(pixel, info, modifiers)) {
    hover.picked = {.element = arrow->halfedge,
                    .halfedge = arrow->halfedge,
                    .face = arrow->on,
                    .place = 0.5 * (arrow->from + arrow->to)};
  } else if (const PickMode sort = pointed_sort(modifiers);
             const auto picked = info ? pick(pixel, sort) : pick_to_select(pixel, sort)) {
    hover.picked = *picked;
  } else {
    return;
  }
  if (info && is_tool(*info)) {
    hover.op = op_at(mesh(), tool, target_of(hover.picked, modifiers));
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

// While another mesh is on trial, or the selection is moved, they are kept for what comes back.
ToolVerdicts* Session::tool_verdicts() {
  const OpInfo* const info = find_op(tool);
  if (!view.shows_verdicts || !info || !is_tool(*info) || findings_->preparing()) {
    tool_verdicts_.reset();
    return nullptr;
  }
  if (gesturing_ || shown.by() != ShownBy::document) return nullptr;
  const PickMode pointed = pick_mode(info, mode);
  const Element::Kind sort = pointed == PickMode::vertex ? Element::Kind::vertex
                             : pointed == PickMode::face ? Element::Kind::face
                                                         : Element::Kind::edge;
  if (!tool_verdicts_ || &tool_verdicts_->op() != info || tool_verdicts_->sort() != sort)
    tool_verdicts_ = std::make_unique<ToolVerdicts>(mesh(), *info, sort);
  if (!frontend.asks_in_slices) tool_verdicts_->ask(mesh());
  return tool_verdicts_.get();
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

// The loop or the ring of that edge, whatever the mode.
Outcome Session::select_along(glm::dvec2 pixel, Modifiers modifiers) {
  const auto picked = pick_to_select(pixel, PickMode::edge);
  if (!picked) {
    if (!modifiers.shift) selection.clear();
    return {};
  }
  const Element first = picked->element;
  Elements found = click_selects(modifiers) == ClickSelects::ring ? edge_rings(mesh(), {&first, 1})
                                                                  : edge_loops(mesh(), {&first, 1});
  findings_->drop_hidden(found);
  return run((modifiers.shift ? "select add" : "select") + slot_ranges(found));
}

Outcome Session::click(glm::dvec2 pixel, const std::string& with_tool, Modifiers modifiers) {
  cancel_gesture();  // what is pointed at is the mesh as it is
  release_verdict();
  if (const AxisEnd* const end = axis_end_at(pixel)) return run(line_of(*end, view.camera));
  if (Session& part = part_at(pixel); &part != this) return only_looked_at(part);
  if (shown.is_replaced()) return shown.refusal();
  if (!asked_line.empty() && with_tool.empty()) return answer(*this, pixel);
  const OpInfo* info = find_op(with_tool);
  if (!info && click_selects(modifiers) != ClickSelects::element) return select_along(pixel, modifiers);
  if (const LinkArrow* const arrow = arrow_at(pixel, info, modifiers))
    return run("select " + slot_name(arrow->halfedge));
  const auto picked = info ? pick(pixel, pick_mode(info, mode)) : pick_to_select(pixel, mode);
  const bool extends = !info && (modifiers.shift || modifiers.ctrl);
  if (!picked) {
    if (!extends && !info) selection.clear();
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
  auto picked = pick_to_select(pixel, mode);
  if (!picked) picked = pick(pixel, PickMode::face);
  if (!picked || std::find(selection.begin(), selection.end(), picked->element) != selection.end()) return;
  run("select " + name_to_select(mesh(), picked->element));
}

std::optional<Picked> Session::pick(glm::dvec2 pixel, PickMode what) {
  return shown.by() == ShownBy::document ? pick_drawn(pixel, what) : std::nullopt;
}

std::optional<Picked> Session::pick_to_select(glm::dvec2 pixel, PickMode what) {
  constexpr double reach_px = 4 * pick_radius_px;
  auto picked = pick(pixel, what);
  if (!picked && what != PickMode::face && pick(pixel, PickMode::face)) picked = pick_drawn(pixel, what, reach_px);
  return picked;
}

std::optional<Picked> Session::pick_drawn(glm::dvec2 pixel, PickMode what, double radius_px) {
  const glm::dvec2 inside = pixel - view.origin;
  if (inside.x < 0 || inside.y < 0 || inside.x >= view.size.width || inside.y >= view.size.height) return std::nullopt;
  if (findings_->preparing()) return std::nullopt;
  return findings_->picker().pick(mesh(), view.camera, view.size, inside, what, pick_depth(),
                       radius_px * preferences.size_scale());
}

void Session::hide(std::span<const Element> elements) {
  if (findings_->hide(elements)) follow_hiding();
}

void Session::isolate(std::span<const Element> elements) {
  if (findings_->isolate(elements)) follow_hiding();
}

void Session::unhide() {
  if (findings_->unhide()) follow_hiding();
}

void Session::follow_hiding() {
  findings_->drop_hidden(selection.changed());
  if (!hover_) return;
  if (is_verdict_held_ && findings_->hidden().hides(mesh(), hover_->picked.element)) release_verdict();
  point_at(hover_->pixel, hover_->modifiers);
}

void Session::prepare() {
  trials.follow(*document_);
  if (beside_) beside_->prepare();
  ask_slice_of_verdicts();
  findings_->prepare();
}

void Session::ask_slice_of_verdicts() {
  if (!frontend.asks_in_slices || !tool_verdicts()) return;
  constexpr std::chrono::milliseconds slice{4};
  const auto end = std::chrono::steady_clock::now() + slice;
  tool_verdicts_->ask(mesh(), [&] { return std::chrono::steady_clock::now() < end; });
}

Picker::Depth Session::pick_depth() const {
  return view.settings.xray == Xray::on ? Picker::Depth::through : Picker::Depth::seen;
}

}  // namespace ryosen
