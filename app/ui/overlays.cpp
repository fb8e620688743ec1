#include "app/ui/overlays.h"

#include "core/mesh/circulate.h"

namespace ryosen {

namespace {

// Adds elements to an overlay in one style.
class Painter {
 public:
  Painter(const Mesh& mesh, Overlay& overlay, const Style& style, float hidden = faintly)
      : m_(mesh), overlay_(overlay), style_(style), hidden_(hidden) {}

  void line(const glm::dvec3& a, const glm::dvec3& b, bool arrow = false) {
    overlay_.lines.push_back({a, b, style_.colour, style_.line, style_.width_px, hidden_, arrow});
  }
  void point(const glm::dvec3& at) {
    overlay_.points.push_back({at, style_.colour, style_.point, style_.radius_px, hidden_});
  }
  void draw(Vertex v) { point(m_.position(v)); }
  void draw(Edge e) { line(m_.position(ends(m_, e).first), m_.position(ends(m_, e).second)); }
  void draw(Halfedge h) { line(m_.position(m_.from(h)), m_.position(m_.to(h)), true); }
  // The outline of a face and a mark in its middle, so that degenerate faces are visible too.
  void draw(Face f, bool mark = true) {
    glm::dvec3 sum{};
    double corners = 0;
    for (Halfedge h : halfedges_around(m_, f)) {
      draw(edge(h));
      sum += m_.position(m_.from(h));
      ++corners;
    }
    if (mark) point(sum / corners);
  }
  void draw(const Element& e) {
    switch (e.kind) {
      case Element::Kind::vertex:
        return draw(e.vertex());
      case Element::Kind::halfedge:
        return draw(e.halfedge());
      case Element::Kind::edge:
        return draw(e.edge());
      case Element::Kind::face:
        return draw(e.face(), false);
    }
  }

 private:
  const Mesh& m_;
  Overlay& overlay_;
  Style style_;
  float hidden_;
};

void add_ghost(const Preview& preview, Theme theme, Overlay& overlay) {
  const Style ghost = style(Role::ghost, theme);
  std::vector<CornerTriangle> triangles;
  for (const GhostFace& face : preview.faces) {
    const std::vector<glm::dvec3>& places = face.polygon.places();
    face.polygon.triangulate(triangles);
    for (const CornerTriangle& t : triangles)
      overlay.ghosts.push_back({{places[t[0]], places[t[1]], places[t[2]]}, ghost.colour, 0});
    for (std::uint32_t i = 0; i < places.size(); ++i)
      overlay.lines.push_back({places[i], places[face.polygon.next(i)], with_alpha(ghost.colour, 255), LineStyle::solid,
                               ghost.width_px, faintly, false});
  }
}

}  // namespace

Overlay highlight_overlay(Session& session, const HighlightRow& row, Mark mark, std::uint32_t first, std::uint32_t end,
                          Theme theme) {
  Overlay overlay;
  Painter painter(session.mesh(), overlay, style(row.looks, theme));
  session.highlights().of(mark).for_each_in(first, end, [&](std::uint32_t i) {
    if (mark.sort == Element::Kind::vertex) painter.draw(Vertex(i));
    if (mark.sort == Element::Kind::edge) painter.draw(Edge(i));
    if (mark.sort == Element::Kind::face) painter.draw(Face(i));
  });
  return overlay;
}

Overlay selection_overlay(const Session& session, Theme theme) {
  Overlay overlay;
  Painter painter(session.mesh(), overlay, style(Role::selected, theme));
  for (const Element& e : session.selection) painter.draw(e);
  return overlay;
}

Overlay hover_overlay(const Session& session, Theme theme) {
  Overlay overlay;
  if (!session.hover()) return overlay;
  const Hover& hover = *session.hover();
  const Mesh& m = session.mesh();
  if (!hover.op) {
    Painter(m, overlay, style(Role::hover, theme), 1).draw(hover.picked.element);
    return overlay;
  }
  const bool legal = hover.preview.verdict.legal();
  if (legal) add_ghost(hover.preview, theme, overlay);
  Painter witness(m, overlay, style(Role::witness, theme), 0.6f);
  for (const Reason& reason : hover.preview.verdict.reasons)
    for (const Element& e : reason.witnesses) witness.draw(e);
  Painter(m, overlay, style(legal ? Role::legal : Role::refused, theme), 1).draw(hover.picked.element);
  return overlay;
}

}  // namespace ryosen
