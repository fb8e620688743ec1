#include "app/ui/viewport.h"

#include <algorithm>
#include <utility>

#include "app/editor/document/findings.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/player.h"
#include "app/editor/views/mesh_view.h"
#include "app/ui/overlays.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/find_element.h"

namespace ryosen {

namespace {

// The place of a mark of a highlight in the order of drawing.
constexpr std::size_t drawing_places = most_highlights * (most_problem_kinds + enum_count<Element::Kind>);
std::uint32_t drawing_place(const HighlightRow& row, Mark mark) {
  const bool is_own = mark.number < own_marks;
  const std::size_t within =
      is_own ? static_cast<std::size_t>(mark.sort) + most_problem_kinds : mark.number - own_marks;
  return static_cast<std::uint32_t>(drawing_rank(row) * (drawing_places / most_highlights) + within);
}

// The room that points at the members of a mark have; none for other members. O(members).
double room_of(const SeenMesh& seen, Mark mark) {
  if (mark.sort != Element::Kind::vertex) return 0;
  const IndexSet& members = seen.findings.highlights().of(mark);
  Box bounds;
  members.for_each([&](std::uint32_t i) {
    if (is_finite(seen.places[i])) bounds.add(seen.places[i]);
  });
  return room_of_points(bounds, members.size());
}

}  // namespace

Result<std::unique_ptr<Viewport>> Viewport::make() {
  auto renderer = Renderer::make();
  if (!renderer) return renderer.failure();
  return std::unique_ptr<Viewport>(new Viewport(std::move(renderer).value()));
}

void Viewport::set_supersample(int samples) { supersample_ = samples; }

void Viewport::set_transparent(bool transparent) {
  is_transparent_ = transparent;
  renderer_->set_transparent(transparent);
}

void Viewport::forget() {
  mesh_of_ = nullptr;
  compared_.reset();
}

void Viewport::draw() {
  renderer_->draw();
  if (compared_) compared_->draw();
}

bool Viewport::goes_on_refining() const {
  return (renderer_->refining_effort() > 0 && !renderer_->is_refined()) || (compared_ && compared_->goes_on_refining());
}

bool Viewport::is_finished() const {
  return renderer_->is_whole() && renderer_->is_refined() && (!compared_ || compared_->is_finished());
}

std::vector<Canvas::Placed> Viewport::placed() const {
  std::vector<Canvas::Placed> all{{renderer_.get(), origin_.x, origin_.y}};
  if (compared_) all.push_back(compared_->placed()[0]);
  return all;
}

void Viewport::follow_compared(Session& session) {
  Compared* const other = session.compared();
  if (!other) return compared_.reset();
  if (!compared_) {
    auto made = make();
    if (!made) return;
    compared_ = std::move(made).value();
    compared_->set_supersample(supersample_);
    compared_->set_transparent(is_transparent_);
  }
  compared_->sort_ = sort_;
  compared_->follow(*other, session.pointing);
}

void Viewport::follow(Session& session) {
  const SeenMesh seen = session.seen();
  sort_ = session.selecting.pointed_sort();
  follow_look(seen);
  follow_mesh(seen, &session.selecting, session.gesturing.step());
  follow_overlays(session);
  labels_.follow(session, *renderer_);
  follow_compared(session);
}

void Viewport::follow(Compared& compared, const Pointing& pointing) {
  const SeenMesh seen = compared.seen();
  follow_look(seen);
  follow_mesh(seen, nullptr, 0);
  if (!seen.findings.preparing()) follow_highlights(seen);
  normal_lines_.follow(seen, *renderer_);
  const Pointed* const pointed = pointing.pointed();
  const bool is_here = pointed && pointed->view == &compared.view();
  renderer_->set_overlay(Layer::hover, is_here ? pointed_overlay(seen, pointed->picked.element) : Overlay());
  labels_.follow(seen, *renderer_);
}

void Viewport::keep_pace(const ViewState& view, FramePace::Clock::time_point now) {
  pace_.see(view.camera, now);
  const bool is_moving = pace_.time_to_rest(now).has_value();
  renderer_->set_thinning(is_moving ? pace_.thinning(renderer_->triangles_in_view()) : 1);
  renderer_->set_most_triangles(is_moving ? 0 : pace_.triangles_of_slice());
  renderer_->set_most_refining(pace_.effort_of_refining());
  if (!renderer_->is_drawn()) changed_at_ = now;
  renderer_->set_refining(now - changed_at_ >= FramePace::rest_after);
  if (compared_) compared_->keep_pace(view, now);
}

void Viewport::took(FramePace::Clock::duration time) {
  pace_.took(renderer_->thinning(), renderer_->triangles_drawn(), time);
  pace_.took_refining(renderer_->refining_effort(), time);
  if (compared_) compared_->took(time);
}

std::optional<FramePace::Clock::duration> Viewport::time_to_next_frame(FramePace::Clock::time_point now) const {
  const auto own = time_to_own_frame(now), other = compared_ ? compared_->time_to_next_frame(now) : std::nullopt;
  return own && other ? std::min(*own, *other) : own ? own : other;
}

std::optional<FramePace::Clock::duration> Viewport::time_to_own_frame(FramePace::Clock::time_point now) const {
  if (!renderer_->is_drawn() || verdict_layer_.is_waiting()) return FramePace::Clock::duration(0);
  if (renderer_->thinning() != 1) return pace_.time_to_rest(now).value_or(FramePace::Clock::duration(0));
  if (renderer_->is_refined()) return std::nullopt;
  return std::max(FramePace::Clock::duration(0), changed_at_ + FramePace::rest_after - now);
}

void Viewport::prepare_refining(Session& session) {
  follow(session);
  renderer_->draw();
  renderer_->prepare_refining();
}

void Viewport::hurry() {
  renderer_->set_thinning(1);
  renderer_->set_most_triangles(0);
  renderer_->set_most_refining(0);
  renderer_->set_refining(true);
  if (compared_) compared_->hurry();
}

void Viewport::draw_mark(const SeenMesh& seen, const HighlightRow& row, Mark mark, std::uint32_t block) {
  const std::uint32_t place = drawing_place(row, mark);
  DrawnMark& drawn = drawn_marks_[place];
  const std::uint32_t first = block * block_slots;
  Overlay overlay;
  if (drawn.is_shown)
    overlay =
        highlight_overlay(seen.findings, seen.places, row, mark, first, first + block_slots, settings_, drawn.room);
  if (overlay.empty())
    drawn.blocks.erase(block);
  else
    drawn.blocks.insert(block);
  constexpr std::uint32_t most_blocks = (no_index / block_slots) + 1;
  static_assert(drawing_places * std::uint64_t{most_blocks} <= no_index, "place and block make one part number");
  renderer_->set_overlay_part(Layer::highlights, place * most_blocks + block, overlay);
}

void Viewport::follow_mark(const SeenMesh& seen, const HighlightRow& row, Mark mark) {
  DrawnMark& drawn = drawn_marks_[drawing_place(row, mark)];
  const bool is_shown = seen.view.highlights.contains(std::string(row.id));
  std::vector<std::uint32_t> blocks;
  const bool is_marked = std::any_of(marked_.begin(), marked_.end(), [&](const auto& m) { return m.mark == mark; });
  const double room = !is_shown ? 0 : is_shown != drawn.is_shown || is_marked ? room_of(seen, mark) : drawn.room;
  if (is_shown != drawn.is_shown || room != drawn.room) {
    blocks = drawn.blocks.to_vector();
    if (is_shown)
      seen.findings.highlights().of(mark).for_each([&](std::uint32_t i) {
        if (blocks.empty() || blocks.back() != i / block_slots) blocks.push_back(i / block_slots);
      });
  } else if (is_shown) {
    for (const ChangeFeed::Marked& marked : marked_)
      if (marked.mark == mark) blocks.push_back(marked.index / block_slots);
    sort_unique(blocks);
  }
  drawn.is_shown = is_shown;
  drawn.room = room;
  for (std::uint32_t block : blocks) draw_mark(seen, row, mark, block);
}

void Viewport::follow_highlights(const SeenMesh& seen) {
  if (highlights_stale_) {
    renderer_->set_overlay(Layer::highlights, {});
    drawn_marks_.clear();
  }
  for (const HighlightRow& row : highlight_table())
    for_each_mark(row, [&](Mark mark) { follow_mark(seen, row, mark); });
  highlights_stale_ = false;
  marked_.clear();
}

void Viewport::follow_overlays(Session& session) {
  selection_stale_ |=
      highlights_stale_ || selection_ != session.selecting.selection.stamp() ||
      draws_links_ != session.view.links.is_on(session.findings(), session.selecting, session.gesturing);
  draws_links_ = session.view.links.is_on(session.findings(), session.selecting, session.gesturing);
  verdict_layer_.follow(session, *renderer_);
  if (!session.findings().preparing()) follow_highlights(session.seen());
  normal_lines_.follow(session.seen(), *renderer_);
  if (selection_stale_)
    renderer_->set_overlay(Layer::selection, selection_overlay(session.findings(), session.view, session.selecting,
                                                               session.gesturing, settings_.theme));
  if (selection_stale_ || measures_ != session.selecting.measures)
    renderer_->set_overlay(Layer::measures, measures_overlay(session.mesh(), session.selecting, settings_.theme));
  measures_ = session.selecting.measures;
  const Player* const player = session.shown.player().get();
  const std::pair<std::uint64_t, std::size_t> step(player ? player->serial() : 0, player ? player->position() : 0);
  if (selection_stale_ || step_ != step)
    renderer_->set_overlay(
        Layer::steps, step_overlay(session.mesh(), session.view, session.gesturing, session.shown, settings_.theme));
  step_ = step;
  const std::optional<Element> asked = asked_element(session.document(), session.layout, session.asked_question);
  if (selection_stale_ || asked_ != asked)
    renderer_->set_overlay(Layer::question, question_overlay(session, settings_.theme));
  asked_ = asked;
  const LeftEdges* const left_edges =
      session.layout.is_shown(panel_opened_by(PanelOpener::levelled)) ? session.findings().left_edges() : nullptr;
  const std::pair<std::uint64_t, std::uint64_t> drawn(left_edges ? left_edges->serial : 0,
                                                      left_edges ? left_edges->revision : 0);
  if (selection_stale_ || left_edges_ != drawn)
    renderer_->set_overlay(Layer::left_edges, left_edges_overlay(session.findings(), session.layout, settings_.theme));
  left_edges_ = drawn;
  selection_stale_ = false;
  selection_ = session.selecting.selection.stamp();
  renderer_->set_overlay(Layer::links, links_overlay(session.view.links.of(session), settings_.theme));
  renderer_->set_overlay(
      Layer::hover, hover_overlay(session.mesh(), session.view, session.selecting, session.gesturing, settings_.theme));
  renderer_->set_overlay(Layer::handles,
                         gizmo_overlay(session.view, session.pointing, session.gesturing, settings_.theme));
  renderer_->set_overlay(Layer::axes,
                         axes_overlay(session.view, session.pointing, session.preferences, settings_.theme));
}

}  // namespace ryosen
