// Draws elements of a mesh into an overlay.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "render/overlay.h"
#include "render/palette.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Adds elements to an overlay in one style.
class Painter {
 public:
  // `places`: where its vertices are drawn.
  Painter(const Mesh& mesh, std::span<const glm::dvec3> places, Overlay& overlay, const Style& style,
          float hidden = faintly, double room = 0, bool thins_out = false)
      : m_(mesh),
        places_(places),
        overlay_(overlay),
        style_(style),
        hidden_(hidden),
        room_(room),
        thins_out_(thins_out) {}

  void line(const glm::dvec3& a, const glm::dvec3& b, bool arrow = false) {
    overlay_.lines.push_back({a, b, style_.colour, style_.line, style_.width_px, hidden_, arrow, thins_out_});
  }
  void point(const glm::dvec3& at) {
    overlay_.points.push_back({at, style_.colour, style_.point, style_.radius_px, hidden_, room_});
  }
  void draw(Vertex v) { point(place(v)); }
  void draw(Edge e) { line(place(ends(m_, e).first), place(ends(m_, e).second)); }
  void draw(Halfedge h) { line(place(m_.from(h)), place(m_.to(h)), true); }
  // The outline of a face and a mark in its middle, so that degenerate faces are visible too.
  void draw(Face f, bool mark = true) {
    for (Halfedge h : halfedges_around(m_, f)) draw(edge(h));
    if (mark) draw_mark(f);
  }
  void draw_mark(Vertex v) { draw(v); }
  void draw_mark(Edge e) { draw(e); }
  // In its middle.
  void draw_mark(Face f) {
    glm::dvec3 sum{};
    double corners = 0;
    for (Vertex v : vertices_around(m_, f)) sum += place(v), ++corners;
    point(sum / corners);
  }
  void draw(const Element& e) {
    if (e.kind == Element::Kind::vertex) return draw(e.vertex());
    if (e.kind == Element::Kind::halfedge) return draw(e.halfedge());
    if (e.kind == Element::Kind::edge) return draw(e.edge());
    draw(e.face(), false);
  }

 private:
  const glm::dvec3& place(Vertex v) const { return places_[v.index]; }

  const Mesh& m_;
  std::span<const glm::dvec3> places_;
  Overlay& overlay_;
  Style style_;
  float hidden_;
  double room_;
  bool thins_out_;
};

}  // namespace ryosen
