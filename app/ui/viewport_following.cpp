// The view is drawn anew where the mesh and what is marked on it have changed.
#include <algorithm>
#include <numeric>
#include <utility>

#include "app/editor/document/left_edges.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/player.h"
#include "app/editor/views/seen_mesh.h"
#include "app/ui/overlays.h"
#include "app/ui/surface_paint.h"
#include "app/ui/viewport.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/find_element.h"

namespace ryosen {

namespace {

TriangleSource source_of(const SeenMesh& seen, std::span<const std::uint8_t> tints) {
  const auto& [document, findings, view, preferences, places] = seen;
  const SurfaceTriangles& triangles = findings.picker().triangles();
  const Mesh& mesh = document.mesh();
  TriangleSource source{
      places, triangles.slots(),
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

void Viewport::follow_look(const SeenMesh& seen) {
  const ViewState& view = seen.view;
  const int samples = std::max(supersample_, seen.preferences.samples);
  if (view.size != size_ || samples != samples_) renderer_->resize(view.size, samples);
  size_ = view.size;
  origin_ = glm::ivec2(view.origin);
  samples_ = samples;
  const ViewSettings before = std::exchange(settings_, view.settings);
  if (settings_.dots == Dots::picked) settings_.dots = sort_ == PickMode::vertex ? Dots::always : Dots::never;
  highlights_stale_ |= settings_.theme != before.theme || settings_.dots != before.dots;
  renderer_->set_settings(settings_);
  renderer_->set_display_scale(static_cast<float>(seen.preferences.size_scale()));
  labels_.set_scale(static_cast<float>(seen.preferences.label_scale()));
  renderer_->set_clip(view.clip_plane());
  renderer_->set_tints(tints_of(seen.document, view));
  renderer_->set_camera(view.camera);
}

void Viewport::follow_mesh(const SeenMesh& seen, const Selecting* selecting, std::uint64_t step) {
  const auto& [document, findings, view, preferences, places] = seen;
  const Mesh& mesh = document.mesh();
  const RecentCells<std::uint32_t>& slots = findings.picker().changed_slots();
  ChangeFeed::Changes changes = findings.changes().since(seen_);
  seen_ = changes.now;
  changes.everything |= !slots.has_all_since(seen_slots_);
  std::vector<std::uint32_t> triangles;
  if (!changes.everything) slots.for_each_since(seen_slots_, [&](std::uint32_t slot) { triangles.push_back(slot); });
  seen_slots_ = slots.clock();
  const bool other_selection = selecting && selection_ != selecting->selection.stamp();
  if (other_selection) follow_selected_faces(findings, *selecting, changes.faces, triangles);
  const FaceTints tints(findings, view, selected_faces_);
  const bool anew = mesh_of_ != &document || changes.everything || drawn_shading_ != view.settings.shading ||
                    drawn_colouring_ != view.colouring || drawn_file_colours_ != view.settings.file_colours ||
                    drawn_crease_deg_ != preferences.crease_deg;
  const bool other_highlights = shown_ != view.highlights || changes.searched;
  if (!anew && !other_highlights && !other_selection && !changes.hiding && gesture_step_ == step &&
      mesh_revision_ == document.revision())
    return;
  face_tints_.resize(mesh.face_slots());
  if (anew || other_highlights) tints.write(face_tints_);
  if (anew) {
    ++rebuilds_;
    renderer_->set_mesh(source_of(seen, face_tints_));
  } else {
    std::erase_if(changes.faces, [&](std::uint32_t f) { return f >= face_tints_.size(); });
    std::erase_if(changes.vertices, [&](std::uint32_t v) { return v >= mesh.vertex_slots(); });
    for (std::uint32_t f : changes.faces) face_tints_[f] = tints.of(f);
    if (other_highlights) {
      changes.faces.resize(face_tints_.size());
      std::iota(changes.faces.begin(), changes.faces.end(), 0u);
    }
    renderer_->update_mesh(source_of(seen, face_tints_), changes.vertices, triangles, changes.faces);
  }
  mesh_of_ = &document;
  mesh_revision_ = document.revision();
  gesture_step_ = step;
  drawn_shading_ = view.settings.shading;
  drawn_colouring_ = view.colouring;
  drawn_file_colours_ = view.settings.file_colours;
  drawn_crease_deg_ = preferences.crease_deg;
  shown_ = view.highlights;
  normal_lines_.note(seen, changes, triangles, anew);
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
