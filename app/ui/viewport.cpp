#include "app/ui/viewport.h"

#include <algorithm>

#include "app/ui/overlays.h"

namespace ryosen {

namespace {

TriangleSource source_of(const Mesh& mesh, const SurfaceTriangles& triangles, std::span<const std::uint8_t> flags) {
  return {mesh.positions(), triangles.triangles(), triangles.faces(), triangles.edge_bits(), flags};
}

// The tint of a face, from the sets it is in.
std::uint8_t flags_of(const HighlightSets& sets, const std::set<std::string>& shown, std::uint32_t face) {
  std::uint8_t flags = 0;
  if (shown.contains("duplicate") && sets.of(ProblemKind::duplicate_face).contains(face)) flags |= FaceFlag::duplicate;
  if (shown.contains("degenerate") && sets.of(ProblemKind::degenerate_area).contains(face))
    flags |= FaceFlag::degenerate;
  return flags;
}

}  // namespace

Result<std::unique_ptr<Viewport>> Viewport::make() {
  auto view = View::make();
  if (!view) return view.failure();
  return std::unique_ptr<Viewport>(new Viewport(std::move(view).value()));
}

void Viewport::set_theme(Theme theme) {
  theme_ = theme;
  view_->set_theme(theme);
  highlights_stale_ = true;
}

void Viewport::set_supersample(int samples) {
  supersample_ = samples;
  size_ = {};
}

void Viewport::follow(Session& session) {
  if (session.view != size_) view_->resize(session.view, supersample_);
  size_ = session.view;
  view_->set_camera(session.camera);
  follow_mesh(session);
  follow_overlays(session);
}

void Viewport::follow_mesh(Session& session) {
  const Mesh& mesh = session.mesh();
  const SurfaceTriangles& triangles = session.picker().triangles();
  const HighlightSets& sets = session.highlights();
  Session::DrawnChanges changes = session.take_drawn_changes();
  const bool anew = mesh_of_ != &session.document() || changes.everything;
  if (!anew && mesh_revision_ == session.document().revision() && shown_ == session.shown) return;
  if (anew || shown_ != session.shown) {
    face_flags_.assign(mesh.face_slots(), 0);
    for (std::uint32_t f = 0; f < face_flags_.size(); ++f) face_flags_[f] = flags_of(sets, session.shown, f);
  }
  if (anew) {
    view_->set_mesh(source_of(mesh, triangles, face_flags_));
  } else {
    face_flags_.resize(mesh.face_slots());
    if (shown_ != session.shown)
      for (std::uint32_t f = 0; f < face_flags_.size(); ++f) changes.faces.push_back(f);
    std::erase_if(changes.faces, [&](std::uint32_t f) { return f >= face_flags_.size(); });
    std::erase_if(changes.vertices, [&](std::uint32_t v) { return v >= mesh.vertex_slots(); });
    for (std::uint32_t f : changes.faces) face_flags_[f] = flags_of(sets, session.shown, f);
    view_->update_mesh(source_of(mesh, triangles, face_flags_), changes.vertices, changes.triangles, changes.faces);
  }
  mesh_of_ = &session.document();
  mesh_revision_ = session.document().revision();
  shown_ = session.shown;
  highlights_stale_ = true;
}

void Viewport::follow_overlays(Session& session) {
  if (highlights_stale_) view_->set_overlay(Layer::highlights, highlight_overlay(session, theme_));
  if (highlights_stale_ || selection_ != session.selection)
    view_->set_overlay(Layer::selection, selection_overlay(session, theme_));
  highlights_stale_ = false;
  selection_ = session.selection;
  view_->set_overlay(Layer::hover, hover_overlay(session, theme_));
}

}  // namespace ryosen
