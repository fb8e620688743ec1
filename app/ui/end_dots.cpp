#include "app/ui/end_dots.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

void EndDots::add(Edge e) {
  const auto [a, b] = ends(m_, e);
  const double length = glm::length(places_[a.index] - places_[b.index]);
  for (const Vertex v : {a, b}) {
    const auto [at, is_new] = room_.try_emplace(point(m_, v), length);
    if (!is_new) at->second = std::min(at->second, length);
  }
}

void EndDots::draw(Theme theme, Overlay& overlay) const {
  constexpr float radius_px = 2.2f;  // with the outline of points as wide as the dots of the surface
  const Rgba colour = with_alpha(palette(theme).wire, 255);
  for (const auto& [v, room] : room_)
    overlay.points.push_back({places_[v.index], colour, PointShape::disc, radius_px, 0, room, true});
}

}  // namespace ryosen
