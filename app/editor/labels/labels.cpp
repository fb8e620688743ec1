#include "app/editor/labels/labels.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "app/editor/session/session.h"
#include "app/editor/shown/gesturing.h"
#include "app/editor/shown/player.h"
#include "app/editor/views/mesh_view.h"
#include "ryosen/scene/pick/screen_segment.h"

namespace ryosen {

namespace {

bool is_step_shown(const Shown& shown) { return shown.shows(ShownBy::step); }

// From the middle of an arrow, across it, so that those of twins lie on different sides of their edge.
glm::dvec2 shift_of(const ScreenProjection& screen, const LinkArrow& arrow, const glm::dvec3& middle) {
  constexpr double beside_px = 13;
  if (arrow.from == arrow.to) return {0, -beside_px};
  const double length = glm::length(arrow.to - arrow.from);
  const auto a = screen.project(middle), b = screen.project(middle + 0.1 * length * arrow.inward);
  if (!a || !b) return {0, 0};
  const glm::dvec2 way = b->pixel - a->pixel;
  const double size = glm::length(way);
  // The text is wider than high.
  return size > 1e-6 ? glm::dvec2(1.8 * beside_px * way.x / size, beside_px * way.y / size) : glm::dvec2(0);
}

// Where a label goes if another has taken its place.
constexpr glm::dvec2 around_px[] = {{0, 19},   {0, -19}, {44, 0}, {-44, 0}, {44, 19},
                                    {-44, 19}, {0, 38},  {88, 0}, {-88, 0}};

// Adds what the arrows of the selected element's links are, beside them, away from their edges.
void add_links(Session& session, std::vector<Label>& labels) {
  const ScreenProjection screen(session.view.camera, session.view.size);
  for (const LinkArrow& arrow : session.view.links.of(session)) {
    const std::string& text = arrow.label.in(session.preferences.language);
    if (text.empty()) continue;
    // The label of a normal, and of a link to a face, stands at its head: others need the room along the way.
    const bool ends_free = arrow.role == LinkRole::normal || arrow.role == LinkRole::face;
    const glm::dvec3 at = ends_free ? arrow.to : 0.5 * (arrow.from + arrow.to);
    const glm::dvec2 shift = shift_of(screen, arrow, at);
    Label label{.at = at, .text = text, .priority = link_priority, .own = arrow.on, .shift_px = shift};
    for (const glm::dvec2 further : around_px) label.else_px.push_back(shift + further);
    labels.push_back(std::move(label));
  }
}

// Adds the name of what is snapped to, beside the place where that is.
void add_snap(const Gesturing& gesturing, std::vector<Label>& labels) {
  const SnapTarget& target = *gesturing.transform()->snapped_to();
  labels.push_back({.at = target.place,
                    .text = target.name,
                    .priority = snap_priority,
                    .shift_px = {0, -22},
                    .else_px = {{0, 22}, {36, 0}, {-36, 0}},
                    .through = true});
}

const LabelSource sources[] = {
    {"numbers", [](const ViewState& view) { return view.settings.numbers != Numbers::off; },
     [](Session& session, std::vector<Label>& labels) {
       const Selection& selection = session.selecting.selection;
       add_numbers(session.seen(), {selection.begin(), selection.end()}, labels);
     }},
    {"links",
     [](const Findings& findings, const ViewState& view, const Selecting& selecting, const Gesturing& gesturing) {
       return view.links.is_on(findings, selecting, gesturing);
     },
     add_links},
    {"measures", [](const Selecting& selecting) { return !selecting.measures.empty(); }, add_measures},
    {"step", is_step_shown, add_step},
    {"snap", [](const Gesturing& gesturing) { return gesturing.is_active() && gesturing.transform()->snapped_to(); },
     add_snap},
    {"faceless",
     [](const Document& document, const Shown& shown, const Frontend& frontend) {
       return !frontend.awaits_file && !shown.player() && is_faceless(document);
     },
     add_faceless},
    {"map", [](const ViewState& view) { return view.colouring.has_value(); }, add_map_legend},
};

// The cells of the view that labels cover, so that to ask for room costs the label and not all of the others.
class TakenCells {
 public:
  explicit TakenCells(Size view) : view_(view), columns_((view.width + cell_px - 1) / cell_px), taken_(cells(view)) {}

  // Whether all of it lies in the view and no label is there.
  bool has_room(const PixelRect& rect) const {
    if (rect.empty() || intersection(rect, PixelRect::all(view_)) != rect) return false;
    bool is_free = true;
    for_each_cell(rect, [&](std::size_t cell) { is_free = is_free && !taken_[cell]; });
    return is_free;
  }
  void take(const PixelRect& rect) {
    for_each_cell(intersection(rect, PixelRect::all(view_)), [&](std::size_t cell) { taken_[cell] = true; });
  }

 private:
  static constexpr int cell_px = 4;

  static std::size_t cells(Size view) {
    const auto along = [](int pixels) { return static_cast<std::size_t>((pixels + cell_px - 1) / cell_px); };
    return along(view.width) * along(view.height);
  }
  template <class Visit>
  void for_each_cell(const PixelRect& rect, Visit visit) const {
    for (int y = rect.y0 / cell_px; y * cell_px < rect.y1; ++y)
      for (int x = rect.x0 / cell_px; x * cell_px < rect.x1; ++x)
        visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x));
  }

  Size view_;
  int columns_;
  std::vector<bool> taken_;
};

// Where there is room for a rectangle, by whole steps from where it is; of several places the nearest. None where the
// view is full. O(view / step²) rectangles.
template <class HasRoom>
std::optional<PixelRect> nearest_room(const HasRoom& has_room, const PixelRect& rect, Size view, glm::ivec2 middle) {
  constexpr int step = 8;
  const int width = rect.x1 - rect.x0, height = rect.y1 - rect.y0;
  std::optional<PixelRect> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (int y = rect.y0 % step; y + height <= view.height; y += step) {
    for (int x = rect.x0 % step; x + width <= view.width; x += step) {
      const double distance = glm::length(glm::dvec2(x + width / 2 - middle.x, y + height / 2 - middle.y));
      const PixelRect place{x, y, x + width, y + height};
      if (distance >= least || !has_room(place)) continue;
      nearest = place;
      least = distance;
    }
  }
  return nearest;
}

// Below half a billion pixels either way, so that it can be counted in.
bool is_near(glm::dvec2 pixel) { return std::abs(pixel.x) < 5e8 && std::abs(pixel.y) < 5e8; }

// What the handles of the gizmo cover, with the room in which they are taken hold of.
void take_handles(const SeenMesh& seen, const std::optional<Gizmo>& gizmo, TakenCells& cells) {
  if (!gizmo) return;
  const ViewState& view = seen.view;
  const double around = 8 * seen.preferences.size_scale();
  const ScreenProjection screen(view.camera, view.size);
  const auto take = [&](const glm::dvec3& place) {
    const auto at = screen.project(place);
    if (!at || !is_near(at->pixel)) return;
    const glm::ivec2 low(glm::floor(at->pixel - around)), high(glm::ceil(at->pixel + around));
    cells.take({low.x, low.y, high.x, high.y});
  };
  // A stroke is hardly longer than a hundred pixels.
  constexpr int steps = 16;
  const auto take_along = [&](const std::vector<GizmoStroke>& strokes) {
    for (const GizmoStroke& stroke : strokes)
      for (int i = 0; i <= steps; ++i) take(glm::mix(stroke.a, stroke.b, double(i) / steps));
  };
  for (const GizmoHandle& handle : gizmo->handles) {
    take_along(handle.strokes);
    take_along(handle.letter);
  }
}

// Where labels lie, one after the other.
class LabelPlaces {
 public:
  // `margin`: the room around each.
  LabelPlaces(const SeenMesh& seen, const std::optional<Gizmo>& gizmo, double scale, int margin)
      : view_(seen.view.size), scale_(scale), margin_(margin), taken_(view_), handles_(view_) {
    take_handles(seen, gizmo, handles_);
  }

  // For one of this size at a pixel; none where it has no room.
  std::optional<PixelRect> room_of(const Label& label, Size size, glm::dvec2 pixel) const {
    const auto has_room = [&](const PixelRect& rect) {
      return taken_.has_room(rect) && (!label.moves_aside || handles_.has_room(rect));
    };
    PixelRect rect = shifted(label, size, pixel, label.shift_px);
    for (std::size_t i = 0; i < label.else_px.size() && !has_room(rect); ++i)
      rect = shifted(label, size, pixel, label.else_px[i]);
    if (has_room(rect)) return rect;
    if (!label.moves_aside || glm::clamp(pixel, glm::dvec2(0), glm::dvec2(view_.width, view_.height)) != pixel)
      return std::nullopt;
    if (const auto near = nearest_room(has_room, rect, view_, glm::ivec2(pixel))) return near;
    return nearest_room([&](const PixelRect& r) { return taken_.has_room(r); }, rect, view_, glm::ivec2(pixel));
  }
  // Those of a legend stand together.
  void take(const PixelRect& rect, const Label& label) {
    const int around = label.ground ? 0 : margin_;
    taken_.take({rect.x0 - around, rect.y0 - around, rect.x1 + around, rect.y1 + around});
  }

 private:
  PixelRect shifted(const Label& label, Size size, glm::dvec2 pixel, glm::dvec2 shift_px) const {
    const glm::dvec2 there = pixel + shift_px * scale_;
    const double before = label.begins_there ? 0 : 0.5 * size.width;
    const int x = static_cast<int>(std::lround(there.x - before)),
              y = static_cast<int>(std::lround(there.y - 0.5 * size.height));
    return {x, y, x + size.width, y + size.height};
  }

  Size view_;
  double scale_;
  int margin_;
  TakenCells taken_, handles_;
};

// `hides`: the surface hides those behind it.
std::vector<PlacedLabel> place(std::vector<Label> labels, const SeenMesh& seen, const std::optional<Gizmo>& gizmo,
                               bool hides, const TextSize& size_of, double scale) {
  std::stable_sort(labels.begin(), labels.end(),
                   [](const Label& a, const Label& b) { return a.priority > b.priority; });
  const ViewState& view = seen.view;
  const ScreenProjection screen(view.camera, view.size);
  const std::optional<ClipPlane> clip = view.clip_plane();
  // Room around each: more where there are many, so that the mesh stays visible between them.
  const int margin = static_cast<int>(std::lround((labels.size() > most_labels ? 10 : 2) * scale));
  LabelPlaces places(seen, gizmo, scale, margin);
  std::vector<PlacedLabel> placed;
  for (const Label& label : labels) {
    if (placed.size() == most_labels) break;
    const auto at = label.pixel ? ScreenPoint{*label.pixel, 0} : screen.project(label.at);
    if (!at || !is_near(at->pixel)) continue;
    if (clip && !label.pixel && clip->cuts(label.at)) continue;
    Size size = size_of(label.text);
    size.width = std::max(size.width, static_cast<int>(std::lround(label.least_width_px * scale)));
    const std::optional<PixelRect> rect = places.room_of(label, size, at->pixel);
    if (!rect) continue;
    if (hides && !label.pixel && !label.through &&
        !seen.findings.picker(view).is_seen(seen.findings.mesh(), view.camera, view.size, *at, label.at, label.own))
      continue;
    places.take(*rect, label);
    placed.push_back({{rect->x0, rect->y0}, size, label.text, label.ground});
  }
  return placed;
}

}  // namespace

std::span<const LabelSource> label_sources() { return sources; }

std::vector<PlacedLabel> placed_labels(Session& session, const TextSize& size_of, double scale) {
  std::vector<Label> labels;
  for (const LabelSource& source : label_sources())
    if (source.is_on(session)) source.add(session, labels);
  const bool hides = session.view.settings.xray == Xray::off && !session.gesturing.is_active();
  return place(std::move(labels), session.seen(), session.pointing.gizmo(), hides, size_of, scale);
}

bool has_labels(const SeenMesh& compared) {
  return compared.view.settings.numbers != Numbers::off || compared.view.colouring || is_faceless(compared.document);
}

std::vector<PlacedLabel> placed_labels(const SeenMesh& compared, const TextSize& size_of, double scale) {
  const auto& [document, findings, view, preferences, places] = compared;
  std::vector<Label> labels;
  add_numbers(compared, {}, labels);
  if (is_faceless(document)) add_faceless(document, view, preferences, labels);
  if (view.colouring) add_map_legend(findings, view, preferences, labels);
  return place(std::move(labels), compared, {}, view.settings.xray == Xray::off, size_of, scale);
}

}  // namespace ryosen
