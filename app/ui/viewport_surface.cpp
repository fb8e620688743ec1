// The surface of the view is drawn anew where the mesh, its colours and its tints have changed.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "app/editor/camera/view_state.h"
#include "app/editor/document/findings.h"
#include "app/editor/session/selecting.h"
#include "app/editor/views/mesh_view.h"
#include "app/ui/viewport.h"
#include "render/colour.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

// The colours of the values that the surface is coloured by.
void paint_values(Findings& findings, const ViewState& view, TriangleSource& source) {
  const Colouring& colouring = *view.colouring;
  const MapValues& values = findings.map_values(colouring);
  const Mesh& mesh = findings.mesh();
  constexpr std::size_t steps = 1024;
  std::vector<std::uint32_t> scale(steps);
  for (std::size_t i = 0; i < steps; ++i) {
    const auto [r, g, b, a] = rgb(colour_at(colouring.map->scale, double(i) / (steps - 1)));
    scale[i] = std::uint32_t{r} | std::uint32_t{g} << 8 | std::uint32_t{b} << 16 | std::uint32_t{a} << 24;
  }
  const auto of = [&values, colouring, scale = std::move(scale)](std::uint32_t slot) -> std::uint32_t {
    const double value = values.of(slot);
    if (std::isnan(value)) return 0;
    return scale[static_cast<std::size_t>(place_on_scale(*colouring.map, colouring.range, value) * (steps - 1) + 0.5)];
  };
  const Element::Kind sort = colouring.map->sort();
  source.paint = sort == Element::Kind::edge ? Paint::sides : Paint::corners;
  source.colours = [&mesh, sort, of](const DrawnTriangle& triangle) {
    std::array<std::uint32_t, 3> colours{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex v(triangle.corners[k]);
      if (sort == Element::Kind::face) colours[k] = of(triangle.face);
      if (sort == Element::Kind::vertex) colours[k] = of(point(mesh, v).index);
      if (sort != Element::Kind::edge || !(triangle.edge_bits >> k & 1)) continue;
      if (const Halfedge h = find_halfedge(mesh, v, Vertex(triangle.corners[(k + 1) % 3])))
        colours[k] = of(edge(h).index);
    }
    return colours;
  };
}

// As of TriangleSource::colours; none where one of the three is not finite.
std::uint32_t packed_colour(const glm::dvec4& colour) {
  std::uint32_t bytes = 0xff000000u;
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(colour[i])) return 0;
    bytes |= static_cast<std::uint32_t>(std::lround(255 * std::clamp(colour[i], 0.0, 1.0))) << (8 * i);
  }
  return bytes;
}

// The colours of the file that are to be seen; null where there are none.
struct ShownFileColours {
  const AttributeColumn* of_vertices = nullptr;
  const AttributeColumn *of_faces = nullptr, *components = nullptr;

  explicit ShownFileColours(const Document& document, const ViewState& view) {
    const FileColours which = view.settings.file_colours;
    const Mesh& mesh = document.mesh();
    if (which == FileColours::off) return;
    if (which != FileColours::faces) of_vertices = find_column(mesh, attribute_names::colour);
    if (which == FileColours::vertices) return;
    components = find_column(mesh, attribute_names::face_colour_components);
    of_faces = components ? find_column(mesh, attribute_names::face_colour) : nullptr;
  }
  bool are_none() const { return !of_vertices && !of_faces; }
};

// The colours of a file, of faces where they have one.
void paint_file(const Document& document, const ViewState& view, TriangleSource& source) {
  const ShownFileColours shown(document, view);
  if (shown.are_none()) return;
  source.paint = Paint::own;
  source.colours = [shown](const DrawnTriangle& triangle) -> std::array<std::uint32_t, 3> {
    const std::uint32_t f = triangle.face;
    const bool has_colour = shown.of_faces && attribute_value<std::uint8_t>(*shown.components, f) >= 3;
    const std::uint32_t of_face = has_colour ? packed_colour(attribute_value<glm::dvec4>(*shown.of_faces, f)) : 0;
    if (of_face != 0 || !shown.of_vertices) return {of_face, of_face, of_face};
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = packed_colour(attribute_value<glm::dvec4>(*shown.of_vertices, triangle.corners[k]));
    return corners;
  };
}

// Whether the surface has colours beside its own.
bool is_painted(const Document& document, const ViewState& view) {
  return view.colouring || !ShownFileColours(document, view).are_none();
}

// Sets paint and colours of the source, where there are any. It reads the session for as long as it is used.
void paint_surface(const Document& document, Findings& findings, const ViewState& view, TriangleSource& source) {
  if (view.colouring)
    paint_values(findings, view, source);
  else
    paint_file(document, view, source);
}

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
  const Look look{view.settings.shading, view.colouring, view.settings.file_colours, preferences.crease_deg};
  const bool anew = mesh_of_ != &document || changes.everything || drawn_look_ != look;
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
  drawn_look_ = look;
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

}  // namespace ryosen
