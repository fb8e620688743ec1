#include "app/ui/viewport.h"

#include <numeric>

#include "app/ui/overlays.h"
#include "core/base/sort_unique.h"

namespace ryosen {

namespace {

TriangleSource source_of(const Mesh& mesh, const SurfaceTriangles& triangles, std::span<const std::uint8_t> flags) {
  return {mesh.positions(), triangles.triangles(), triangles.faces(), triangles.edge_bits(), flags};
}

// The tints of faces, from the highlights that are shown and the sets the faces are in.
class FaceTints {
 public:
  explicit FaceTints(Session& session) {
    const auto add = [&](const char* highlight, ProblemKind kind, std::uint8_t flag) {
      if (session.shown.contains(highlight)) shown_.push_back({&session.highlights().of(kind), flag});
    };
    add("duplicate", ProblemKind::duplicate_face, FaceFlag::duplicate);
    add("degenerate", ProblemKind::degenerate_area, FaceFlag::degenerate);
  }
  std::uint8_t of(std::uint32_t face) const {
    std::uint8_t flags = 0;
    for (const auto& [set, flag] : shown_)
      if (set->contains(face)) flags |= flag;
    return flags;
  }

 private:
  std::vector<std::pair<const IndexSet*, std::uint8_t>> shown_;
};

}  // namespace

Result<std::unique_ptr<Viewport>> Viewport::make() {
  auto view = View::make();
  if (!view) return view.failure();
  return std::unique_ptr<Viewport>(new Viewport(std::move(view).value()));
}

void Viewport::set_supersample(int samples) {
  supersample_ = samples;
  size_ = {};
}

void Viewport::follow(Session& session) {
  if (session.view != size_) view_->resize(session.view, supersample_);
  size_ = session.view;
  const Theme theme = session.light_theme ? Theme::light : Theme::dark;
  if (theme != theme_) highlights_stale_ = true;
  theme_ = theme;
  view_->set_theme(theme);
  view_->set_camera(session.camera);
  follow_mesh(session);
  follow_overlays(session);
}

void Viewport::follow_mesh(Session& session) {
  const Mesh& mesh = session.mesh();
  const SurfaceTriangles& triangles = session.picker().triangles();
  const FaceTints tints(session);
  Session::DrawnChanges changes = session.take_drawn_changes();
  const bool anew = mesh_of_ != &session.document() || changes.everything;
  const bool other_highlights = shown_ != session.shown;
  if (!anew && !other_highlights && mesh_revision_ == session.document().revision()) return;
  face_flags_.resize(mesh.face_slots());
  if (anew || other_highlights)
    for (std::uint32_t f = 0; f < face_flags_.size(); ++f) face_flags_[f] = tints.of(f);
  if (anew) {
    view_->set_mesh(source_of(mesh, triangles, face_flags_));
  } else {
    std::erase_if(changes.faces, [&](std::uint32_t f) { return f >= face_flags_.size(); });
    std::erase_if(changes.vertices, [&](std::uint32_t v) { return v >= mesh.vertex_slots(); });
    for (std::uint32_t f : changes.faces) face_flags_[f] = tints.of(f);
    if (other_highlights) {
      changes.faces.resize(face_flags_.size());
      std::iota(changes.faces.begin(), changes.faces.end(), 0u);
    }
    view_->update_mesh(source_of(mesh, triangles, face_flags_), changes.vertices, changes.triangles, changes.faces);
  }
  mesh_of_ = &session.document();
  mesh_revision_ = session.document().revision();
  shown_ = session.shown;
  marks_ = std::move(changes.marks);
  highlights_stale_ |= anew;
  selection_stale_ = true;
}

void Viewport::draw_highlights(Session& session, const ProblemRow& row, std::uint32_t block) {
  const auto kind = static_cast<std::uint32_t>(row.kind);
  DrawnKind& drawn = drawn_kinds_[kind];
  const std::uint32_t first = block * block_slots;
  Overlay overlay;
  if (drawn.is_shown) overlay = highlight_overlay(session, row, first, first + block_slots, theme_);
  if (overlay.empty())
    drawn.blocks.erase(block);
  else
    drawn.blocks.insert(block);
  constexpr std::uint32_t most_blocks = (no_index / block_slots) + 1;
  static_assert(problem_kinds * std::uint64_t{most_blocks} <= no_index, "kind and block make one part number");
  view_->set_overlay_part(Layer::highlights, kind * most_blocks + block, overlay);
}

void Viewport::follow_highlights(Session& session) {
  if (highlights_stale_) {
    view_->set_overlay(Layer::highlights, {});
    drawn_kinds_ = {};
  }
  for (const ProblemRow& row : problem_table()) {
    DrawnKind& drawn = drawn_kinds_[static_cast<std::size_t>(row.kind)];
    const bool is_shown = row.is_local() && session.shown.contains(std::string(row.highlight));
    std::vector<std::uint32_t> blocks;
    if (is_shown != drawn.is_shown) {
      blocks = drawn.blocks.to_vector();
      if (is_shown)
        session.highlights().of(row.kind).for_each([&](std::uint32_t i) {
          if (blocks.empty() || blocks.back() != i / block_slots) blocks.push_back(i / block_slots);
        });
    } else if (is_shown) {
      for (const Session::Mark& mark : marks_)
        if (mark.kind == row.kind) blocks.push_back(mark.index / block_slots);
      sort_unique(blocks);
    }
    drawn.is_shown = is_shown;
    for (std::uint32_t block : blocks) draw_highlights(session, row, block);
  }
  highlights_stale_ = false;
  marks_.clear();
}

void Viewport::follow_overlays(Session& session) {
  selection_stale_ |= highlights_stale_ || selection_ != session.selection;
  follow_highlights(session);
  if (selection_stale_) view_->set_overlay(Layer::selection, selection_overlay(session, theme_));
  selection_stale_ = false;
  selection_ = session.selection;
  view_->set_overlay(Layer::hover, hover_overlay(session, theme_));
}

}  // namespace ryosen
