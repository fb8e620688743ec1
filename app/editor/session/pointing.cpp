#include "app/editor/session/pointing.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/editor/input/pick_modes.h"
#include "app/editor/session/asking.h"
#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"
#include "ryosen/scene/selection/derived_selections.h"

namespace ryosen {

namespace {

// A click on a mesh that stands beside the open one.
Outcome only_looked_at(const Document& document) {
  const std::string name = document.path().filename().string();
  return failed(
      ExitCode::refused,
      {name + " is shown here to be compared with: nothing of it is selected or changed. Open it to work on it.",
       name + " は比較のために表示しています。選択や編集をするには開いてください。"});
}

// As nothing is edited by it, it reaches farther on the surface.
std::optional<Picked> reached(View& view, glm::dvec2 pixel, PickMode what, const Preferences& preferences) {
  const double near_px = pick_radius_px * preferences.size_scale();
  auto picked = view.pick(pixel, what, near_px);
  if (!picked && what != PickMode::face && view.pick(pixel, PickMode::face, near_px))
    picked = view.pick(pixel, what, 4 * near_px);
  return picked;
}

}  // namespace

Pointing::Pointing(Session& session, const OpenDocument& open)
    : session_(session), view_(session.view), selecting_(session.selecting), in_space_(open, session.view) {}

const Mesh& Pointing::mesh() const { return session_.mesh(); }

void Pointing::remove(const View& view) {
  if (elsewhere_ && elsewhere_->view == &view) elsewhere_.reset();
  if (selecting_.hover() && selecting_.hover()->view == &view) {
    selecting_.release_verdict();
    selecting_.point_to({});
  }
  std::erase(further_, &view);
}

View& Pointing::view_at(glm::dvec2 pixel) {
  session_.compared();  // looks as the view does now
  const auto last = std::find_if(further_.rbegin(), further_.rend(), [&](View* view) { return view->contains(pixel); });
  return last == further_.rend() ? static_cast<View&>(in_space_) : **last;
}

bool Pointing::is_in_space(glm::dvec2 pixel) const {
  return std::none_of(further_.begin(), further_.end(), [&](const View* view) { return view->contains(pixel); });
}

bool Pointing::is_of_open_document(const View& view) const { return &view.document() == &session_.document(); }

const Pointed* Pointing::pointed() const {
  if (selecting_.hover()) return &*selecting_.hover();
  return elsewhere_ ? &*elsewhere_ : nullptr;
}

OpTarget Pointing::target_of(const Picked& picked, Modifiers modifiers) const {
  if (picked.element.kind == Element::Kind::vertex) return {Halfedge(), 0.5, picked.element.vertex()};
  if (picked.element.kind == Element::Kind::face) return {Halfedge(), 0.5, Vertex(), picked.element.face()};
  const double small_px = 24 * session_.preferences.size_scale();
  const auto a = project(view_.camera, view_.size, mesh().position(mesh().from(picked.halfedge)));
  const auto b = project(view_.camera, view_.size, mesh().position(mesh().to(picked.halfedge)));
  OpTarget target{picked.halfedge, picked.along};
  target.is_free = modifiers.shift;
  target.is_small = a && b && glm::length(a->pixel - b->pixel) < small_px;
  return target;
}

void Pointing::point_at(glm::dvec2 pixel, Modifiers modifiers) {
  if (!selecting_.is_verdict_held() && !session_.gesturing.is_active()) look_at(pixel, modifiers);
}

void Pointing::point_away() {
  leave_handles();
  if (!selecting_.is_verdict_held()) selecting_.point_to({});
  elsewhere_.reset();
}

std::optional<Gizmo> Pointing::gizmo() const {
  if (view_.gizmo_kind == GizmoKind::none || !selecting_.tool.empty() || selecting_.selection.empty() ||
      session_.gesturing.is_active() || view_.band || session_.shown.is_replaced())
    return std::nullopt;
  if (middle_.document != session_.document().serial() || middle_.revision != session_.document().revision() ||
      middle_.selection != selecting_.selection.stamp())
    middle_ = {selecting_.selection.stamp(), session_.document().serial(), session_.document().revision(),
               middle_of(mesh(), points_of(mesh(), selecting_.selection))};
  return gizmo_at(view_.gizmo_kind, view_.camera, view_.size, middle_.place, session_.preferences.size_scale());
}

std::optional<CornerAxes> Pointing::axes_in_corner() const {
  return view_.shows_axes ? corner_axes(view_.camera, view_.size, session_.preferences.size_scale()) : std::nullopt;
}

const AxisEnd* Pointing::axis_end_at(glm::dvec2 pixel) const {
  const auto axes = is_in_space(pixel) ? axes_in_corner() : std::nullopt;
  return axes ? end_at(*axes, pixel - view_.origin) : nullptr;
}

const HandleRow* Pointing::handle_at(glm::dvec2 pixel, Modifiers modifiers) const {
  if (modifiers.shift || modifiers.alt || !is_in_space(pixel)) return nullptr;
  const auto handles = gizmo();
  const GizmoHandle* const found = handles ? ryosen::handle_at(*handles, view_.camera, view_.size, pixel - view_.origin,
                                                               session_.preferences.size_scale())
                                           : nullptr;
  return found ? found->row : nullptr;
}

// The arrow that a click would select, whatever the mode; null where it would not select one.
const LinkArrow* Pointing::arrow_at(glm::dvec2 pixel, const OpInfo* info, Modifiers modifiers) {
  const bool selects = !info && selecting_.asked_line.empty() && !modifiers.shift && !modifiers.ctrl && !modifiers.alt;
  if (!selects || !is_in_space(pixel) || session_.findings().preparing() || session_.shown.by() != ShownBy::document)
    return nullptr;
  return view_.links.at(session_, pixel - view_.origin);
}

void Pointing::look_at(glm::dvec2 pixel, Modifiers modifiers) {
  selecting_.point_to({});
  elsewhere_.reset();
  leave_handles();
  Hover hover;
  View& view = view_at(pixel);
  hover.document = &view.document();
  hover.view = &view;
  hover.pixel = pixel;
  hover.modifiers = modifiers;
  if (!is_of_open_document(view)) {
    if (const auto picked = reached(view, pixel, selecting_.pointed_sort(), session_.preferences))
      elsewhere_ = Pointed{&view.document(), &view, pixel, *picked};
    return;
  }
  pointed_axis_end_ = axis_end_at(pixel);
  pointed_handle_ = pointed_axis_end_ ? nullptr : handle_at(pixel, modifiers);
  if (pointed_handle_ || pointed_axis_end_) return;
  const OpInfo* info = find_op(selecting_.tool);
  if (const LinkArrow* const arrow = arrow_at(pixel, info, modifiers)) {
    hover.picked = {.element = arrow->halfedge,
                    .halfedge = arrow->halfedge,
                    .face = arrow->on,
                    .place = 0.5 * (arrow->from + arrow->to)};
  } else if (const PickMode sort = selecting_.pointed_sort(modifiers);
             const auto picked = info ? pick(pixel, sort) : pick_to_select(pixel, sort)) {
    hover.picked = *picked;
  } else {
    return;
  }
  if (info && is_tool(*info)) {
    hover.op = op_at(mesh(), selecting_.tool, target_of(hover.picked, modifiers));
    hover.preview = session_.document().preview(*hover.op);
  }
  selecting_.point_to(std::move(hover));
}

// The loop or the ring of that edge, whatever the mode.
Outcome Pointing::select_along(glm::dvec2 pixel, Modifiers modifiers) {
  const auto picked = pick_to_select(pixel, PickMode::edge);
  if (!picked) {
    if (!modifiers.shift) selecting_.selection.clear();
    return {};
  }
  const Element first = picked->element;
  Elements found = click_selects(modifiers) == ClickSelects::ring ? edge_rings(mesh(), {&first, 1})
                                                                  : edge_loops(mesh(), {&first, 1});
  session_.findings().drop_hidden(found);
  return session_.run((modifiers.shift ? "select add" : "select") + slot_ranges(found));
}

Outcome Pointing::click(glm::dvec2 pixel, const std::string& with_tool, Modifiers modifiers) {
  session_.gesturing.cancel();  // what is pointed at is the mesh as it is
  selecting_.release_verdict();
  const View& view = view_at(pixel);
  if (!is_of_open_document(view)) return only_looked_at(view.document());
  if (const AxisEnd* const end = axis_end_at(pixel)) return session_.run(line_of(*end, view_.camera));
  if (session_.shown.is_replaced()) return session_.shown.refusal();
  if (!selecting_.asked_line.empty() && with_tool.empty()) return answer(session_, pixel);
  const OpInfo* info = find_op(with_tool);
  if (!info && click_selects(modifiers) != ClickSelects::element) return select_along(pixel, modifiers);
  if (const LinkArrow* const arrow = arrow_at(pixel, info, modifiers))
    return session_.run("select " + slot_name(arrow->halfedge));
  const auto picked = info ? pick(pixel, pick_mode(info, selecting_.mode)) : pick_to_select(pixel, selecting_.mode);
  const bool extends = !info && (modifiers.shift || modifiers.ctrl);
  if (!picked) {
    if (!extends && !info) selecting_.selection.clear();
    if (!info) return {};
    const PickModeRow& sort = pick_modes[static_cast<std::size_t>(pick_mode(info, selecting_.mode))];
    return failed(ExitCode::found_problems,
                  {"there is nothing under the pointer that it works on. " + std::string(sort.point_en),
                   "ポインタの下に対象がありません。" + std::string(sort.point_ja)});
  }
  if (info) return use_tool(pixel, *picked, with_tool, modifiers);
  const std::string how = !extends ? "" : modifiers.ctrl ? "toggle " : "add ";
  return session_.run("select " + how + name_to_select(mesh(), picked->element));
}

Outcome Pointing::use_tool(glm::dvec2 pixel, const Picked& picked, const std::string& tool, Modifiers modifiers) {
  Outcome outcome = session_.run(op_at(mesh(), tool, target_of(picked, modifiers)));
  if (outcome.kind != Outcome::Kind::refused || tool != selecting_.tool) return outcome;
  look_at(pixel, modifiers);
  selecting_.hold_verdict();
  return outcome;
}

void Pointing::select_for_menu(glm::dvec2 pixel) {
  session_.gesturing.cancel();
  auto picked = pick_to_select(pixel, selecting_.mode);
  if (!picked) picked = pick(pixel, PickMode::face);
  if (!picked || std::find(selecting_.selection.begin(), selecting_.selection.end(), picked->element) !=
                     selecting_.selection.end())
    return;
  session_.run("select " + name_to_select(mesh(), picked->element));
}

bool Pointing::can_pick_in(const View& view) const {
  return session_.shown.by() == ShownBy::document && is_of_open_document(view);
}

std::optional<Picked> Pointing::pick(glm::dvec2 pixel, PickMode what) {
  return can_pick_in(view_at(pixel)) ? pick_drawn(pixel, what) : std::nullopt;
}

std::optional<Picked> Pointing::pick_to_select(glm::dvec2 pixel, PickMode what) {
  View& view = view_at(pixel);
  return can_pick_in(view) ? reached(view, pixel, what, session_.preferences) : std::nullopt;
}

std::optional<Picked> Pointing::pick_drawn(glm::dvec2 pixel, PickMode what) {
  return view_at(pixel).pick(pixel, what, pick_radius_px * session_.preferences.size_scale());
}

}  // namespace ryosen
