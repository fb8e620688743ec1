#include "app/ui/viewport.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "app/editor/session/session.h"
#include "app/editor/shown/levels.h"
#include "app/editor/textbook/playing.h"
#include "app/ui/axes_overlay.h"
#include "app/ui/gizmo_overlay.h"
#include "app/ui/overlays.h"
#include "app/ui/point_room.h"
#include "app/ui/surface_paint.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/box.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"

namespace ryosen {

namespace {

TriangleSource source_of(const Document& document, Findings& findings, const ViewState& view,
                         const Gesturing& gesturing, std::span<const std::uint8_t> tints) {
  const SurfaceTriangles& triangles = findings.picker().triangles();
  const Mesh& mesh = document.mesh();
  TriangleSource source{
      gesturing.drawn_positions(), triangles.slots(),
      [&mesh, &triangles](std::span<const std::uint32_t> slots, DrawnTriangle* to) { triangles.read(mesh, slots, to); },
      tints};
  if (view.settings.shading == Shading::smooth) source.corner_normals = findings.corner_normals().packed();
  paint_surface(document, findings, view, source);
  return source;
}

static_assert(most_highlights < most_tints);

// The tints of highlights, in the order of the table, and at last that of selected faces.
std::vector<DrawnTint> tints_of(const Document& document, const ViewState& view) {
  const Theme theme = view.settings.theme;
  std::vector<DrawnTint> tints;
  for (const HighlightRow& row : highlight_table())
    if (row.tint) tints.push_back({style(row.looks, theme).colour, *row.tint});
  // Stripes where the surface has colours of its own, any of which may be alike.
  const FaceTint selected =
      is_painted(document, view) ? FaceTint{FacePattern::bars, 0.9f} : FaceTint{FacePattern::plain, 0.6f};
  tints.push_back({style(Role::selected, theme).colour, selected});
  return tints;
}

// The numbers of the faces' tints, from the highlights that are shown and the sets the faces are in. Of several the
// first highlight of the table tints; being selected goes before them, and being hidden before that.
class FaceTints {
 public:
  FaceTints(Findings& findings, const ViewState& view, const IndexSet& selected) {
    const auto tinted =
        std::count_if(highlight_table().begin(), highlight_table().end(), [](const auto& row) { return row.tint; });
    shown_.push_back({&findings.hidden().faces(), hidden_face});
    shown_.push_back({&selected, static_cast<std::uint8_t>(tinted + 1)});
    if (findings.preparing()) return;
    const HighlightSets& sets = findings.highlights();
    std::uint8_t number = 0;
    for (const HighlightRow& row : highlight_table()) {
      if (!row.tint) continue;
      ++number;
      if (!view.highlights.contains(std::string(row.id))) continue;
      for_each_mark(row, [&](Mark mark) {
        if (mark.sort == Element::Kind::face) shown_.push_back({&sets.of(mark), number});
      });
    }
  }
  std::uint8_t of(std::uint32_t face) const {
    for (const auto& [set, number] : shown_)
      if (set->contains(face)) return number;
    return 0;
  }
  // As of(), of all faces; at the cost of those that have a tint.
  void write(std::vector<std::uint8_t>& tints) const {
    std::fill(tints.begin(), tints.end(), std::uint8_t{0});
    for (auto shown = shown_.rbegin(); shown != shown_.rend(); ++shown)
      shown->first->for_each([&](std::uint32_t face) {
        if (face < tints.size()) tints[face] = shown->second;
      });
  }

 private:
  std::vector<std::pair<const IndexSet*, std::uint8_t>> shown_;
};

// The place of a mark of a highlight in the order of drawing.
constexpr std::size_t drawing_places = most_highlights * (most_problem_kinds + enum_count<Element::Kind>);
std::uint32_t drawing_place(const HighlightRow& row, Mark mark) {
  const bool is_own = mark.number < own_marks;
  const std::size_t within =
      is_own ? static_cast<std::size_t>(mark.sort) + most_problem_kinds : mark.number - own_marks;
  return static_cast<std::uint32_t>(drawing_rank(row) * (drawing_places / most_highlights) + within);
}

// Of points at the members of a mark; none for other members. Linear.
double room_of(Findings& findings, const Gesturing& gesturing, Mark mark) {
  if (mark.sort != Element::Kind::vertex) return 0;
  const IndexSet& members = findings.highlights().of(mark);
  Box bounds;
  members.for_each([&](std::uint32_t i) {
    if (is_finite(gesturing.drawn_positions()[i])) bounds.add(gesturing.drawn_positions()[i]);
  });
  return room_of_points(bounds, members.size());
}

}  // namespace

Result<std::unique_ptr<Viewport>> Viewport::make() {
  auto view = View::make();
  if (!view) return view.failure();
  return std::unique_ptr<Viewport>(new Viewport(std::move(view).value()));
}

void Viewport::set_supersample(int samples) { supersample_ = samples; }

void Viewport::set_transparent(bool transparent) {
  is_transparent_ = transparent;
  view_->set_transparent(transparent);
}

void Viewport::forget() {
  mesh_of_ = nullptr;
  beside_.reset();
}

void Viewport::draw() {
  view_->draw();
  if (beside_) beside_->draw();
}

bool Viewport::goes_on_refining() const {
  return (view_->refining_effort() > 0 && !view_->is_refined()) || (beside_ && beside_->goes_on_refining());
}

bool Viewport::is_finished() const {
  return view_->is_whole() && view_->is_refined() && (!beside_ || beside_->is_finished());
}

std::vector<Canvas::Placed> Viewport::placed() const {
  std::vector<Canvas::Placed> all{{view_.get(), origin_.x, origin_.y}};
  if (beside_) all.push_back(beside_->placed()[0]);
  return all;
}

void Viewport::follow_beside(Session& session) {
  Session* const other = session.beside();
  if (!other) return beside_.reset();
  if (!beside_) {
    auto made = make();
    if (!made) return;
    beside_ = std::move(made).value();
    beside_->set_supersample(supersample_);
    beside_->set_transparent(is_transparent_);
  }
  beside_->follow(*other);
}

void Viewport::follow(Session& session) {
  const int samples = std::max(supersample_, session.preferences.samples);
  if (session.view.size != size_ || samples != samples_) view_->resize(session.view.size, samples);
  size_ = session.view.size;
  origin_ = glm::ivec2(session.view.origin);
  samples_ = samples;
  const ViewSettings before = std::exchange(settings_, session.view.settings);
  if (settings_.dots == Dots::picked)
    settings_.dots = session.selecting.pointed_sort() == PickMode::vertex ? Dots::always : Dots::never;
  highlights_stale_ |= settings_.theme != before.theme || settings_.dots != before.dots;
  view_->set_settings(settings_);
  const auto scale = static_cast<float>(session.preferences.size_scale());
  view_->set_display_scale(scale);
  labels_.set_scale(static_cast<float>(session.preferences.label_scale()));
  view_->set_clip(session.view.clip_plane());
  view_->set_tints(tints_of(session.document(), session.view));
  view_->set_camera(session.view.camera);
  follow_mesh(session);
  follow_overlays(session);
  labels_.follow(session, *view_);
  follow_beside(session);
}

void Viewport::keep_pace(const ViewState& view, FramePace::Clock::time_point now) {
  pace_.see(view.camera, now);
  const bool is_moving = pace_.time_to_rest(now).has_value();
  view_->set_thinning(is_moving ? pace_.thinning(view_->triangles_in_view()) : 1);
  view_->set_most_triangles(is_moving ? 0 : pace_.triangles_of_slice());
  view_->set_most_refining(pace_.effort_of_refining());
  if (!view_->is_drawn()) changed_at_ = now;
  view_->set_refining(now - changed_at_ >= FramePace::rest_after);
  if (beside_) beside_->keep_pace(view, now);
}

void Viewport::took(FramePace::Clock::duration time) {
  pace_.took(view_->thinning(), view_->triangles_drawn(), time);
  pace_.took_refining(view_->refining_effort(), time);
  if (beside_) beside_->took(time);
}

std::optional<FramePace::Clock::duration> Viewport::time_to_next_frame(FramePace::Clock::time_point now) const {
  const auto own = time_to_own_frame(now), other = beside_ ? beside_->time_to_next_frame(now) : std::nullopt;
  return own && other ? std::min(*own, *other) : own ? own : other;
}

std::optional<FramePace::Clock::duration> Viewport::time_to_own_frame(FramePace::Clock::time_point now) const {
  if (!view_->is_drawn() || verdict_layer_.is_waiting()) return FramePace::Clock::duration(0);
  if (view_->thinning() != 1) return pace_.time_to_rest(now).value_or(FramePace::Clock::duration(0));
  if (view_->is_refined()) return std::nullopt;
  return std::max(FramePace::Clock::duration(0), changed_at_ + FramePace::rest_after - now);
}

void Viewport::prepare_refining(Session& session) {
  follow(session);
  view_->draw();
  view_->prepare_refining();
}

void Viewport::hurry() {
  view_->set_thinning(1);
  view_->set_most_triangles(0);
  view_->set_most_refining(0);
  view_->set_refining(true);
  if (beside_) beside_->hurry();
}

void Viewport::follow_mesh(Session& session) {
  const Mesh& mesh = session.mesh();
  const RecentCells<std::uint32_t>& slots = session.findings().picker().changed_slots();
  ChangeFeed::Changes changes = session.findings().changes().since(seen_);
  seen_ = changes.now;
  changes.everything |= !slots.has_all_since(seen_slots_);
  std::vector<std::uint32_t> triangles;
  if (!changes.everything) slots.for_each_since(seen_slots_, [&](std::uint32_t slot) { triangles.push_back(slot); });
  seen_slots_ = slots.clock();
  const bool other_selection = selection_ != session.selecting.selection.stamp();
  if (other_selection) follow_selected_faces(session.findings(), session.selecting, changes.faces, triangles);
  const FaceTints tints(session.findings(), session.view, selected_faces_);
  const bool anew = mesh_of_ != &session.document() || changes.everything ||
                    drawn_shading_ != session.view.settings.shading || drawn_colouring_ != session.view.colouring ||
                    drawn_file_colours_ != session.view.settings.file_colours ||
                    drawn_crease_deg_ != session.preferences.crease_deg;
  const bool other_highlights = shown_ != session.view.highlights || changes.searched;
  if (!anew && !other_highlights && !other_selection && !changes.hiding && gesture_step_ == session.gesturing.step() &&
      mesh_revision_ == session.document().revision())
    return;
  face_tints_.resize(mesh.face_slots());
  if (anew || other_highlights) tints.write(face_tints_);
  if (anew) {
    ++rebuilds_;
    view_->set_mesh(source_of(session.document(), session.findings(), session.view, session.gesturing, face_tints_));
  } else {
    std::erase_if(changes.faces, [&](std::uint32_t f) { return f >= face_tints_.size(); });
    std::erase_if(changes.vertices, [&](std::uint32_t v) { return v >= mesh.vertex_slots(); });
    for (std::uint32_t f : changes.faces) face_tints_[f] = tints.of(f);
    if (other_highlights) {
      changes.faces.resize(face_tints_.size());
      std::iota(changes.faces.begin(), changes.faces.end(), 0u);
    }
    view_->update_mesh(source_of(session.document(), session.findings(), session.view, session.gesturing, face_tints_),
                       changes.vertices, triangles, changes.faces);
  }
  mesh_of_ = &session.document();
  mesh_revision_ = session.document().revision();
  gesture_step_ = session.gesturing.step();
  drawn_shading_ = session.view.settings.shading;
  drawn_colouring_ = session.view.colouring;
  drawn_file_colours_ = session.view.settings.file_colours;
  drawn_crease_deg_ = session.preferences.crease_deg;
  shown_ = session.view.highlights;
  normal_lines_.note(session, changes, triangles, anew);
  if (anew || changes.hiding) verdict_layer_.forget();
  marked_ = std::move(changes.marks);
  highlights_stale_ |= anew || changes.searched;
  selection_stale_ = true;
}

void Viewport::follow_selected_faces(Findings& findings, const Selecting& selecting, std::vector<std::uint32_t>& faces,
                                     std::vector<std::uint32_t>& triangles) {
  constexpr std::size_t few = 10000;  // more are found in one pass over all triangles
  IndexSet selected;
  for (const Element& e : selecting.selection)
    if (e.kind == Element::Kind::face) selected.insert(e.index);
  std::vector<std::uint32_t> others;
  selected.for_each([&](std::uint32_t f) {
    if (!selected_faces_.contains(f)) others.push_back(f);
  });
  selected_faces_.for_each([&](std::uint32_t f) {
    if (!selected.contains(f)) others.push_back(f);
  });
  if (others.size() <= few)
    for (const std::uint32_t f : others)
      if (is_alive(findings.mesh(), Face(f)))
        for (const std::uint32_t slot : findings.picker().triangles().slots_of(findings.mesh(), Face(f)))
          triangles.push_back(slot);
  faces.insert(faces.end(), others.begin(), others.end());
  selected_faces_ = std::move(selected);
}

void Viewport::draw_mark(Findings& findings, Gesturing& gesturing, const HighlightRow& row, Mark mark,
                         std::uint32_t block) {
  const std::uint32_t place = drawing_place(row, mark);
  DrawnMark& drawn = drawn_marks_[place];
  const std::uint32_t first = block * block_slots;
  Overlay overlay;
  if (drawn.is_shown)
    overlay = highlight_overlay(findings, gesturing, row, mark, first, first + block_slots, settings_, drawn.room);
  if (overlay.empty())
    drawn.blocks.erase(block);
  else
    drawn.blocks.insert(block);
  constexpr std::uint32_t most_blocks = (no_index / block_slots) + 1;
  static_assert(drawing_places * std::uint64_t{most_blocks} <= no_index, "place and block make one part number");
  view_->set_overlay_part(Layer::highlights, place * most_blocks + block, overlay);
}

void Viewport::follow_mark(Findings& findings, const ViewState& view, Gesturing& gesturing, const HighlightRow& row,
                           Mark mark) {
  DrawnMark& drawn = drawn_marks_[drawing_place(row, mark)];
  const bool is_shown = view.highlights.contains(std::string(row.id));
  std::vector<std::uint32_t> blocks;
  const bool is_marked = std::any_of(marked_.begin(), marked_.end(), [&](const auto& m) { return m.mark == mark; });
  const double room = !is_shown                                 ? 0
                      : is_shown != drawn.is_shown || is_marked ? room_of(findings, gesturing, mark)
                                                                : drawn.room;
  if (is_shown != drawn.is_shown || room != drawn.room) {
    blocks = drawn.blocks.to_vector();
    if (is_shown)
      findings.highlights().of(mark).for_each([&](std::uint32_t i) {
        if (blocks.empty() || blocks.back() != i / block_slots) blocks.push_back(i / block_slots);
      });
  } else if (is_shown) {
    for (const ChangeFeed::Marked& marked : marked_)
      if (marked.mark == mark) blocks.push_back(marked.index / block_slots);
    sort_unique(blocks);
  }
  drawn.is_shown = is_shown;
  drawn.room = room;
  for (std::uint32_t block : blocks) draw_mark(findings, gesturing, row, mark, block);
}

void Viewport::follow_highlights(Findings& findings, const ViewState& view, Gesturing& gesturing) {
  if (highlights_stale_) {
    view_->set_overlay(Layer::highlights, {});
    drawn_marks_.clear();
  }
  for (const HighlightRow& row : highlight_table())
    for_each_mark(row, [&](Mark mark) { follow_mark(findings, view, gesturing, row, mark); });
  highlights_stale_ = false;
  marked_.clear();
}

void Viewport::follow_overlays(Session& session) {
  selection_stale_ |=
      highlights_stale_ || selection_ != session.selecting.selection.stamp() ||
      draws_links_ != session.view.links.is_on(session.findings(), session.selecting, session.gesturing);
  draws_links_ = session.view.links.is_on(session.findings(), session.selecting, session.gesturing);
  verdict_layer_.follow(session, *view_);
  if (!session.findings().preparing()) follow_highlights(session.findings(), session.view, session.gesturing);
  normal_lines_.follow(session, *view_);
  if (selection_stale_)
    view_->set_overlay(Layer::selection, selection_overlay(session.findings(), session.view, session.selecting,
                                                           session.gesturing, settings_.theme));
  if (selection_stale_ || measures_ != session.selecting.measures)
    view_->set_overlay(Layer::measures, measures_overlay(session.mesh(), session.selecting, settings_.theme));
  measures_ = session.selecting.measures;
  const Player* const player = session.shown.player().get();
  const std::pair<std::uint64_t, std::size_t> step(player ? player->serial() : 0, player ? player->position() : 0);
  if (selection_stale_ || step_ != step)
    view_->set_overlay(Layer::steps,
                       step_overlay(session.mesh(), session.view, session.gesturing, session.shown, settings_.theme));
  step_ = step;
  const std::optional<Element> asked = asked_element(session.document(), session.layout, session.asked_question);
  if (selection_stale_ || asked_ != asked)
    view_->set_overlay(Layer::question, question_overlay(session, settings_.theme));
  asked_ = asked;
  const EdgeAccount* const account =
      session.layout.is_shown(panel_opened_by(PanelOpener::levelled)) ? session.findings().account() : nullptr;
  const std::pair<std::uint64_t, std::uint64_t> drawn(account ? account->serial : 0, account ? account->revision : 0);
  if (selection_stale_ || account_ != drawn)
    view_->set_overlay(Layer::account, account_overlay(session.findings(), session.layout, settings_.theme));
  account_ = drawn;
  selection_stale_ = false;
  selection_ = session.selecting.selection.stamp();
  view_->set_overlay(Layer::links, links_overlay(session, settings_.theme));
  view_->set_overlay(
      Layer::hover, hover_overlay(session.mesh(), session.view, session.selecting, session.gesturing, settings_.theme));
  view_->set_overlay(Layer::handles, gizmo_overlay(session.view, session.pointing, session.gesturing, settings_.theme));
  view_->set_overlay(Layer::axes, axes_overlay(session.view, session.pointing, session.preferences, settings_.theme));
}

}  // namespace ryosen
