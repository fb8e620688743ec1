// The element under the pointer, what a tool would make of it, and what a gesture spoils.
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "app/editor/camera/view_state.h"
#include "app/editor/session/selecting.h"
#include "app/editor/shown/gesturing.h"
#include "app/editor/views/mesh_view.h"
#include "app/ui/overlay_painter.h"
#include "app/ui/overlays.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

// The ghost of what an operator would do, whole in front of the old surface: what stays thin, what goes thinly dashed,
// what comes thick, and new vertices and those that move as points.
class Ghost {
 public:
  Ghost(const Mesh& mesh, const ViewState& view, const Gesturing& gesturing, Theme theme, Overlay& overlay)
      : view_(view),
        gesturing_(gesturing),
        m_(mesh),
        overlay_(overlay),
        stays_(style(Role::ghost, theme)),
        comes_(style(Role::legal, theme)),
        goes_(style(Role::goes, theme)) {}

  void draw(const Preview& preview, const Element& pointed) {
    thin_out(preview);
    const bool is_edge = pointed.kind == Element::Kind::edge || pointed.kind == Element::Kind::halfedge;
    if (is_edge) pointed_ = pointed.kind == Element::Kind::edge ? pointed.edge() : edge(pointed.halfedge());
    for (const GhostFace& face : preview.faces) draw(face);
    Painter old(m_, gesturing_.drawn_positions(), overlay_, goes_, 1);
    for (const Element& e : preview.deleted)
      if (e.kind == Element::Kind::edge || e.kind == Element::Kind::vertex) old.draw(e);
    if (pointed_ && !pointed_stays_) old.draw(pointed_);
    Painter fresh(m_, gesturing_.drawn_positions(), overlay_, comes_, 1);
    const auto is_before = [](const glm::dvec3& a, const glm::dvec3& b) {
      return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
    };
    std::sort(new_places_.begin(), new_places_.end(), is_before);
    new_places_.erase(std::unique(new_places_.begin(), new_places_.end()), new_places_.end());
    for (const glm::dvec3& place : new_places_) fresh.point(place);
    if (pointed_stays_ || (!is_edge && preview.deleted.empty())) fresh.draw(pointed);
  }

 private:
  // Where the faces are small on the screen, so are the strokes.
  void thin_out(const Preview& preview) {
    constexpr double large_px = 90;
    double longest_px = 0;
    for (const GhostFace& face : preview.faces) {
      const std::vector<glm::dvec3>& places = face.polygon.places();
      for (std::uint32_t i = 0; i < places.size() && longest_px < large_px; ++i) {
        const auto a = project(view_.camera, view_.size, places[i]);
        const auto b = project(view_.camera, view_.size, places[face.polygon.next(i)]);
        if (a && b) longest_px = std::max(longest_px, glm::length(a->pixel - b->pixel));
      }
    }
    if (longest_px <= 0) return;
    const auto share = static_cast<float>(std::clamp(longest_px / large_px, 0.4, 1.0));
    for (Style* each : {&comes_, &goes_, &stays_}) {
      each->width_px = std::max(each->width_px * share, 1.f);
      each->radius_px *= share;
    }
  }

  bool stays_at(Vertex v, const glm::dvec3& place) const {
    return m_.exists(v) && m_.is_alive(v) && m_.position(v) == place;
  }
  // Whether the side is an edge of the mesh as it is.
  bool stays(Halfedge h, const glm::dvec3& from, const glm::dvec3& to) const {
    return m_.exists(h) && m_.is_alive(h) && m_.position(m_.from(h)) == from && m_.position(m_.to(h)) == to;
  }

  void draw(const GhostFace& face) {
    const std::vector<glm::dvec3>& places = face.polygon.places();
    std::vector<CornerTriangle> triangles;
    face.polygon.triangulate(triangles);
    for (const CornerTriangle& t : triangles)
      overlay_.ghosts.push_back({{places[t[0]], places[t[1]], places[t[2]]}, stays_.colour, 1});
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      const glm::dvec3 &from = places[i], &to = places[face.polygon.next(i)];
      const Halfedge h = face.polygon.corners()[i];
      const bool is_old = stays(h, from, to);
      pointed_stays_ = pointed_stays_ || (is_old && edge(h) == pointed_);
      const Style& side = is_old ? stays_ : comes_;
      overlay_.lines.push_back({from, to, with_alpha(side.colour, 255), side.line, side.width_px, 1, false});
      if (!stays_at(face.vertices[i], from)) new_places_.push_back(from);
    }
  }

  const ViewState& view_;
  const Gesturing& gesturing_;
  const Mesh& m_;
  Overlay& overlay_;
  Style stays_, comes_, goes_;
  std::vector<glm::dvec3> new_places_;
  Edge pointed_;  // if it is an edge
  bool pointed_stays_ = false;
};

// Whether more of the faces are in view than can be told apart by thick lines.
bool are_many_in_view(const Mesh& mesh, const ViewState& view, const Gesturing& gesturing,
                      std::span<const Face> faces) {
  constexpr std::size_t most = 200;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < faces.size() && seen <= most; ++i) {
    const Vertex v = mesh.from(mesh.halfedge(faces[i]));
    const auto at = project(view.camera, view.size, gesturing.drawn_positions()[v.index]);
    seen +=
        at && at->pixel.x >= 0 && at->pixel.y >= 0 && at->pixel.x < view.size.width && at->pixel.y < view.size.height;
  }
  return seen > most;
}

// Many are drawn thin and where they are seen, so that what is moved stays to be seen among them.
void draw_spoilt(const Mesh& mesh, const ViewState& view, const Gesturing& gesturing, Theme theme, Overlay& overlay) {
  const std::span<const Face> faces = gesturing.spoilt();
  const bool are_many = are_many_in_view(mesh, view, gesturing, faces);
  Style looks = style(Role::refused, theme);
  if (are_many) {
    looks.line = LineStyle::solid;
    looks.width_px = 1;
  }
  Painter painter(mesh, gesturing.drawn_positions(), overlay, looks, are_many ? 0.f : 1.f, 0, are_many);
  for (const Face f : faces) painter.draw(f, false);
}

}  // namespace

Overlay hover_overlay(const Mesh& mesh, const ViewState& view, const Selecting& selecting, const Gesturing& gesturing,
                      Theme theme) {
  Overlay overlay;
  draw_spoilt(mesh, view, gesturing, theme, overlay);
  const SnapTarget* const target = gesturing.transform() ? gesturing.transform()->snapped_to() : nullptr;
  if (target && target->element.kind != Element::Kind::vertex)
    Painter(mesh, gesturing.drawn_positions(), overlay, style(Role::hover, theme), 1).draw(target->element);
  if (!selecting.hover()) return overlay;
  const Hover& hover = *selecting.hover();
  if (!hover.op) {
    Painter(mesh, gesturing.drawn_positions(), overlay, style(Role::hover, theme), 1).draw(hover.picked.element);
    return overlay;
  }
  if (hover.preview.verdict.legal()) {
    Ghost(mesh, view, gesturing, theme, overlay).draw(hover.preview, hover.picked.element);
    return overlay;
  }
  Painter witness(mesh, gesturing.drawn_positions(), overlay, style(Role::witness, theme), 0.6f);
  for (const Reason& reason : hover.preview.verdict.reasons)
    for (const Element& e : reason.witnesses) witness.draw(e);
  Painter(mesh, gesturing.drawn_positions(), overlay, style(Role::refused, theme), 1).draw(hover.picked.element);
  return overlay;
}

Overlay pointed_overlay(const SeenMesh& compared, const Element& element) {
  Overlay overlay;
  const Style looks = style(Role::hover, compared.view.settings.theme);
  Painter(compared.document.mesh(), compared.places, overlay, looks, 1).draw(element);
  return overlay;
}

}  // namespace ryosen
