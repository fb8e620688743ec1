#include "app/ui/viewport.h"

#include <algorithm>
#include <utility>

#include "app/editor/session/session.h"
#include "app/editor/views/compared.h"
#include "app/editor/views/seen_mesh.h"
#include "app/ui/overlays.h"

namespace ryosen {

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

}  // namespace ryosen
