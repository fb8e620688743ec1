// What the arrows of links are, as labels.
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/labels/labels.h"
#include "app/editor/session/session.h"
#include "ryosen/scene/pick/screen_segment.h"

namespace ryosen {

namespace {

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

}  // namespace

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

}  // namespace ryosen
