#include "tests/support/app/plane_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/find_element.h"

namespace ryosen::test {

namespace {

struct Nearest {
  double along, distance;
};

Nearest nearest_on(glm::dvec2 a, glm::dvec2 b, glm::dvec2 at) {
  const glm::dvec2 way = b - a;
  const double squared = glm::dot(way, way);
  const double along = squared > 0 ? std::clamp(glm::dot(at - a, way) / squared, 0.0, 1.0) : 0;
  return {along, glm::length(a + along * way - at)};
}

}  // namespace

PlaneView::PlaneView(Session& session, glm::dvec2 origin, Size size, glm::dvec2 low, double side)
    : session_(session), origin_(origin), size_(size), low_(low), side_(side) {
  session.pointing.add(*this);
  follow();
}

PlaneView::~PlaneView() { session_.pointing.remove(*this); }

const Document& PlaneView::document() const { return session_.document(); }

bool PlaneView::contains(glm::dvec2 pixel) const {
  const glm::dvec2 inside = pixel - origin_;
  return inside.x >= 0 && inside.y >= 0 && inside.x < size_.width && inside.y < size_.height;
}

glm::dvec2 PlaneView::pixel_of(glm::dvec2 place) const {
  const glm::dvec2 share = (place - low_) / side_;
  return origin_ + glm::dvec2(share.x, 1 - share.y) * glm::dvec2(size_.width - 1, size_.height - 1);
}

bool PlaneView::is_drawn(Edge e) const {
  return session_.mesh().is_alive(e) && !session_.findings().hidden().hides(session_.mesh(), e);
}

std::optional<Picked> PlaneView::pick(glm::dvec2 pixel, PickMode what, double radius_px) {
  follow();
  const Mesh& mesh = session_.mesh();
  std::optional<Picked> found;
  const auto offer = [&](const Picked& picked) {
    if (picked.distance_px <= radius_px && (!found || picked.distance_px < found->distance_px)) found = picked;
  };
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (!is_drawn(Edge(i))) continue;
    const Halfedge h = halfedge(Edge(i));
    const glm::dvec2 a = pixel_of(place(mesh.from(h))), b = pixel_of(place(mesh.to(h)));
    const Nearest near = nearest_on(a, b, pixel);
    const glm::dvec3 at = glm::mix(mesh.position(mesh.from(h)), mesh.position(mesh.to(h)), near.along);
    if (what == PickMode::edge)
      offer({.element = Edge(i), .halfedge = h, .along = near.along, .place = at, .distance_px = near.distance});
    if (what == PickMode::vertex)
      for (const Vertex v : {mesh.from(h), mesh.to(h)})
        offer({.element = v, .place = mesh.position(v), .distance_px = glm::length(pixel_of(place(v)) - pixel)});
  }
  return found;
}

void PlaneView::follow() {
  const Mesh& mesh = session_.mesh();
  const ChangeFeed::Changes changes = session_.findings().changes().since(seen_);
  seen_ = changes.now;
  rebuilds_ += changes.everything;
  places_.resize(mesh.vertex_slots());
  const auto take = [&](std::uint32_t i) {
    if (i < places_.size()) places_[i] = glm::dvec2(session_.gesturing.drawn_positions()[i]);
  };
  for (std::uint32_t i = 0; changes.everything && i < places_.size(); ++i) take(i);
  for (const std::uint32_t i : changes.vertices) take(i);
}

Image PlaneView::draw() const {
  Image image(size_, ground);
  const Mesh& mesh = session_.mesh();
  const auto draw = [&](Edge e, Rgba colour) {
    const auto [from, to] = ends(mesh, e);
    const glm::dvec2 a = pixel_of(place(from)) - origin_, b = pixel_of(place(to)) - origin_;
    const int steps = 1 + static_cast<int>(glm::length(b - a));
    for (int i = 0; i <= steps; ++i) {
      const glm::ivec2 at(glm::round(glm::mix(a, b, double(i) / steps)));
      if (at.x >= 0 && at.y >= 0 && at.x < size_.width && at.y < size_.height) image.at(at.x, at.y) = colour;
    }
  };
  const auto draw_element = [&](const Element& e, Rgba colour) {
    if (!is_alive(mesh, e)) return;
    if (e.kind == Element::Kind::edge) draw(e.edge(), colour);
    if (e.kind == Element::Kind::halfedge) draw(edge(e.halfedge()), colour);
    if (e.kind == Element::Kind::face)
      for (const Halfedge h : halfedges_around(mesh, e.face())) draw(edge(h), colour);
    if (e.kind == Element::Kind::vertex)
      for (const Edge around : edges_around(mesh, e.vertex())) draw(around, colour);
  };
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i)
    if (is_drawn(Edge(i))) draw(Edge(i), line);
  for (const Element& e : session_.selecting.selection) draw_element(e, selected);
  const Pointed* const pointed = session_.pointing.pointed();
  if (pointed && pointed->document == &document()) draw_element(pointed->picked.element, hovered);
  return image;
}

}  // namespace ryosen::test
