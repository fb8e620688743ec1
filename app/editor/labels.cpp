#include "app/editor/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/editor/playing.h"
#include "core/pick/screen_segment.h"

namespace ryosen {

namespace {

bool is_step_shown(const Session& session) { return session.player && session.player->is_shown(session.document()); }

constexpr LabelSource sources[] = {
    {"numbers", [](const Session& session) { return session.settings.numbers != Numbers::off; }, add_numbers},
    {"links", [](const Session& session) { return session.links.is_on(session); }, add_links},
    {"measures", [](const Session& session) { return !session.measures.empty(); }, add_measures},
    {"step", is_step_shown, add_step},
    {"snap", [](const Session& session) { return session.gesture() && session.gesture()->snapped_to(); }, add_snap},
    {"map", [](const Session& session) { return session.colouring.has_value(); }, add_map_legend},
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
std::optional<PixelRect> nearest_room(const TakenCells& taken, const PixelRect& rect, Size view, glm::ivec2 middle) {
  constexpr int step = 8;
  const int width = rect.x1 - rect.x0, height = rect.y1 - rect.y0;
  std::optional<PixelRect> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (int y = rect.y0 % step; y + height <= view.height; y += step) {
    for (int x = rect.x0 % step; x + width <= view.width; x += step) {
      const double distance = glm::length(glm::dvec2(x + width / 2 - middle.x, y + height / 2 - middle.y));
      const PixelRect place{x, y, x + width, y + height};
      if (distance >= least || !taken.has_room(place)) continue;
      nearest = place;
      least = distance;
    }
  }
  return nearest;
}

// Below half a billion pixels either way, so that it can be counted in.
bool is_near(glm::dvec2 pixel) { return std::abs(pixel.x) < 5e8 && std::abs(pixel.y) < 5e8; }

}  // namespace

std::span<const LabelSource> label_sources() { return sources; }

std::vector<PlacedLabel> placed_labels(Session& session, const std::function<Size(const std::string& text)>& size_of,
                                       double scale) {
  std::vector<Label> labels;
  for (const LabelSource& source : label_sources())
    if (source.is_on(session)) source.add(session, labels);
  std::stable_sort(labels.begin(), labels.end(),
                   [](const Label& a, const Label& b) { return a.priority > b.priority; });
  const ScreenProjection screen(session.camera, session.view);
  const std::optional<ClipPlane> clip = session.clip_plane();
  const bool hides = session.settings.xray == Xray::off && !session.gesture();
  // Room around each: more where there are many, so that the mesh stays visible between them.
  const int margin = static_cast<int>(std::lround((labels.size() > most_labels ? 10 : 2) * scale));
  TakenCells taken(session.view);
  std::vector<PlacedLabel> placed;
  for (const Label& label : labels) {
    if (placed.size() == most_labels) break;
    const auto at = label.pixel ? ScreenPoint{*label.pixel, 0} : screen.project(label.at);
    if (!at || !is_near(at->pixel)) continue;
    if (clip && !label.pixel && clip->cuts(label.at)) continue;
    Size size = size_of(label.text);
    size.width = std::max(size.width, static_cast<int>(std::lround(label.least_width_px * scale)));
    const auto rect_at = [&](glm::dvec2 shift_px) {
      const glm::dvec2 there = at->pixel + shift_px * scale;
      const double before = label.begins_there ? 0 : 0.5 * size.width;
      const int x = static_cast<int>(std::lround(there.x - before)),
                y = static_cast<int>(std::lround(there.y - 0.5 * size.height));
      return PixelRect{x, y, x + size.width, y + size.height};
    };
    PixelRect rect = rect_at(label.shift_px);
    for (std::size_t i = 0; i < label.else_px.size() && !taken.has_room(rect); ++i) rect = rect_at(label.else_px[i]);
    const glm::dvec2 end(session.view.width, session.view.height);
    const bool is_in_view = glm::clamp(at->pixel, glm::dvec2(0), end) == at->pixel;
    if (label.moves_aside && is_in_view && !taken.has_room(rect))
      rect = nearest_room(taken, rect, session.view, glm::ivec2(at->pixel)).value_or(rect);
    if (!taken.has_room(rect)) continue;
    if (hides && !label.pixel && !label.through &&
        !session.picker().is_seen(session.mesh(), session.camera, session.view, *at, label.at, label.own))
      continue;
    const int around = label.ground ? 0 : margin;  // those of a legend stand together
    taken.take({rect.x0 - around, rect.y0 - around, rect.x1 + around, rect.y1 + around});
    placed.push_back({{rect.x0, rect.y0}, size, label.text, label.ground});
  }
  return placed;
}

}  // namespace ryosen
