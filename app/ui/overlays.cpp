#include "app/ui/overlays.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "app/editor/levels.h"
#include "app/editor/playing.h"
#include "app/ui/end_dots.h"
#include "core/analysis/measuring.h"
#include "core/base/enum_table.h"
#include "core/mesh/circulate.h"
#include "core/mesh/find_element.h"

namespace ryosen {

namespace {

// Adds elements to an overlay in one style.
class Painter {
 public:
  Painter(const Session& session, Overlay& overlay, const Style& style, float hidden = faintly, double room = 0,
          bool thins_out = false)
      : m_(session.mesh()),
        places_(session.drawn_positions()),
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
  const glm::dvec3& place(Vertex v) const { return places_[v.index]; }

  const Mesh& m_;
  std::span<const glm::dvec3> places_;
  Overlay& overlay_;
  Style style_;
  float hidden_;
  double room_;
  bool thins_out_;
};

// The ghost of what an operator would do, whole in front of the old surface: what stays thin, what goes thinly dashed, what
// comes thick, and new vertices and those that move as points.
class Ghost {
 public:
  Ghost(const Session& session, Theme theme, Overlay& overlay)
      : session_(session),
        m_(session.mesh()),
        overlay_(overlay),
        stays_(style(Role::ghost, theme)),
        comes_(style(Role::legal, theme)),
        goes_(style(Role::goes, theme)) {}

  void draw(const Preview& preview, const Element& pointed) {
    thin_out(preview);
    const bool is_edge = pointed.kind == Element::Kind::edge || pointed.kind == Element::Kind::halfedge;
    if (is_edge) pointed_ = pointed.kind == Element::Kind::edge ? pointed.edge() : edge(pointed.halfedge());
    for (const GhostFace& face : preview.faces) draw(face);
    Painter old(session_, overlay_, goes_, 1);
    for (const Element& e : preview.deleted)
      if (e.kind == Element::Kind::edge || e.kind == Element::Kind::vertex) old.draw(e);
    if (pointed_ && !pointed_stays_) old.draw(pointed_);
    Painter fresh(session_, overlay_, comes_, 1);
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
        const auto a = project(session_.camera, session_.view, places[i]);
        const auto b = project(session_.camera, session_.view, places[face.polygon.next(i)]);
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

  const Session& session_;
  const Mesh& m_;
  Overlay& overlay_;
  Style stays_, comes_, goes_;
  std::vector<glm::dvec3> new_places_;
  Edge pointed_;  // if it is an edge
  bool pointed_stays_ = false;
};

}  // namespace

Overlay highlight_overlay(Session& session, const HighlightRow& row, Mark mark, std::uint32_t first, std::uint32_t end,
                          const ViewSettings& settings, double room) {
  Overlay overlay;
  Painter painter(session, overlay, style(row.looks, settings.theme), faintly, room);
  EndDots dots(session);
  session.highlights().of(mark).for_each_in(first, end, [&](std::uint32_t i) {
    Element e;
    e.kind = mark.sort;
    e.index = i;
    if (session.hidden().hides(session.mesh(), e)) return;
    if (mark.sort == Element::Kind::face)
      painter.draw(Face(i));
    else
      painter.draw(e);
    if (mark.sort == Element::Kind::edge && settings.dots == Dots::always) dots.add(Edge(i));
  });
  dots.draw(settings.theme, overlay);
  return overlay;
}

// Of several the last, in a ring at its middle: it is the one that others are welded into, and from which paths go.
// Of many, which nobody selects one by one, there is no such order.
static void draw_last(const Session& session, Theme theme, Overlay& overlay) {
  if (session.selection.size() < 2 || session.selection.size() > most_ringed) return;
  const Mesh& mesh = session.mesh();
  const Element& last = session.selection.back();
  if (session.hidden().hides(mesh, last)) return;
  glm::dvec3 sum(0);
  double n = 0;
  const auto add = [&](Vertex v) {
    sum += session.drawn_positions()[v.index];
    ++n;
  };
  if (last.kind == Element::Kind::vertex) add(last.vertex());
  if (last.kind == Element::Kind::face)
    for (const Vertex v : vertices_around(mesh, last.face())) add(v);
  if (last.kind == Element::Kind::edge || last.kind == Element::Kind::halfedge) {
    const auto [a, b] = ends(mesh, last.kind == Element::Kind::edge ? last.edge() : edge(last.halfedge()));
    add(a);
    add(b);
  }
  overlay.points.push_back({sum / n, style(Role::witness, theme).colour, PointShape::ring, 11, faintly});
}

Overlay selection_overlay(const Session& session, Theme theme) {
  Overlay overlay;
  // Of very many those behind are hidden by those before, and dense ones need not be wide to be seen.
  constexpr std::size_t many = 1000, very_many = 20000;
  const std::size_t n = session.selection.size();
  Painter painter(session, overlay, style(Role::selected, theme), n > very_many ? 0 : faintly, 0, n > many);
  constexpr std::size_t most_outlines = 60;  // the surface fills them
  const auto is_face = [](const Element& e) { return e.kind == Element::Kind::face; };
  const bool has_outlines = session.selection.count(Element::Kind::face) <= most_outlines;
  const bool has_arrow = session.links.is_on(session);  // of the selected halfedge, in its face
  const auto is_drawn = [&](const Element& e) {
    return (has_outlines || !is_face(e)) &&
           !(has_arrow && e.kind == Element::Kind::halfedge && e == session.selection.back()) &&
           !session.hidden().hides(session.mesh(), e);
  };
  for (const Element& e : session.selection)
    if (is_drawn(e)) painter.draw(e);
  draw_last(session, theme, overlay);
  return overlay;
}

Overlay verdicts_overlay(const Session& session, const ToolVerdicts& verdicts, ElementVerdict which,
                         std::uint32_t first, std::uint32_t end, Theme theme, double room) {
  constexpr std::size_t many = 1000;
  Overlay overlay;
  Style looks = style(which == ElementVerdict::legal ? Role::legal : Role::refused, theme);
  looks.width_px = 2;
  Painter painter(session, overlay, looks, 0, room, verdicts.all().size() > many);
  const auto draw = [&](const auto element) {
    if (!session.hidden().hides(session.mesh(), element)) painter.draw_mark(element);
  };
  for (std::uint32_t i = first; i < end; ++i) {
    if (verdicts.all()[i] != which) continue;
    if (verdicts.sort() == Element::Kind::edge) draw(Edge(i));
    if (verdicts.sort() == Element::Kind::vertex) draw(Vertex(i));
    if (verdicts.sort() == Element::Kind::face) draw(Face(i));
  }
  return overlay;
}

Overlay measures_overlay(const Session& session, Theme theme) {
  Overlay overlay;
  const Style looks = style(Role::witness, theme);
  const auto lives = [&](const Element& e) { return is_alive(session.mesh(), e); };
  for (const Elements& measured : session.measures) {
    if (!std::all_of(measured.begin(), measured.end(), lives)) continue;
    const std::vector<glm::dvec3> path = measure(session.mesh(), measured).path;
    for (std::size_t i = 0; i < path.size(); ++i) {
      overlay.points.push_back({path[i], looks.colour, PointShape::disc, 3.5f});
      if (i > 0) overlay.lines.push_back({path[i - 1], path[i], looks.colour, looks.line, 2.5f});
    }
  }
  return overlay;
}

static Style style(steps::RoleLook look, Theme theme) {
  switch (look) {
    case steps::RoleLook::main:
      return style(Role::selected, theme);
    case steps::RoleLook::good:
      return style(Role::legal, theme);
    case steps::RoleLook::bad:
      return style(Role::refused, theme);
    case steps::RoleLook::other:
      return style(Role::hover, theme);
    case steps::RoleLook::quiet:
      break;
  }
  return style(Role::witness, theme);
}

// A halfedge on its own side of the edge, so that it is told from its twin.
static void draw_beside_twin(Painter& painter, const Session& session, const Element& element) {
  if (element.kind != Element::Kind::halfedge) return painter.draw(element);
  for (const LinkArrow& arrow : arrows_of(session, {element.halfedge()})) painter.line(arrow.from, arrow.to, true);
}

Overlay question_overlay(const Session& session, Theme theme) {
  Overlay overlay;
  const std::optional<Element> about = asked_element(session);
  if (!about) return overlay;
  Painter painter(session, overlay, style(Role::witness, theme), 0.6f);
  draw_beside_twin(painter, session, *about);
  return overlay;
}

Overlay step_overlay(const Session& session, Theme theme) {
  Overlay overlay;
  if (!session.player || !session.player->is_shown(session.document()) || !session.player->step()) return overlay;
  // The first mark of an element is what it is above all: it is drawn last.
  const std::vector<steps::Mark>& marks = session.player->step()->marks;
  for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
    if (!has_slot(session.mesh().lengths(), mark->element) || !is_alive(session.mesh(), mark->element)) continue;
    Painter painter(session, overlay, style(steps::row_of(mark->role).look, theme), 0.6f);
    draw_beside_twin(painter, session, mark->element);
  }
  for (const steps::Gone& gone : session.player->step()->gone) {
    const Style looks = style(steps::row_of(gone.role).look, theme);
    for (std::size_t i = 1; i < gone.places.size(); ++i)
      overlay.lines.push_back({gone.places[i - 1], gone.places[i], looks.colour, LineStyle::dashed, 1.5f});
  }
  return overlay;
}

namespace {

// The looks of an edge by the rule that holds it.
struct RuleLooks {
  EdgeRule rule;
  std::uint32_t dark, light;  // 0xRRGGBB
  LineStyle line;
  float width_px;  // 0: not drawn, as held by nothing are mostly nearly all
};
constexpr RuleLooks rule_looks[] = {
    {EdgeRule::structure, 0xE69F00, 0xB36B00, LineStyle::solid, 2.4f},
    {EdgeRule::boundary, 0x6CC2FF, 0x1F5FA8, LineStyle::dashed, 2.4f},
    {EdgeRule::normal, 0xE58CC0, 0x9E3D78, LineStyle::solid, 2.4f},
    {EdgeRule::angle, 0xF0E442, 0x8A7A00, LineStyle::dash_dot, 2.4f},
    {EdgeRule::error, 0xFF6F61, 0xB3261E, LineStyle::solid, 2.4f},
    {EdgeRule::selection, 0xB59CFF, 0x5B3FA8, LineStyle::dashed, 2.4f},
    {EdgeRule::self_intersection, 0xFFFFFF, 0x202020, LineStyle::dotted, 2.4f},
    {EdgeRule::free, 0x2BD9A0, 0x007A58, LineStyle::solid, 0},
};
static_assert(rows_are_in_order(rule_looks, &RuleLooks::rule));

}  // namespace

std::uint32_t colour_of(EdgeRule rule, Theme theme) {
  const RuleLooks& looks = rule_looks[static_cast<std::size_t>(rule)];
  return theme == Theme::dark ? looks.dark : looks.light;
}

Overlay account_overlay(const Session& session, Theme theme) {
  Overlay overlay;
  const EdgeAccount* const account = session.account();
  if (!account || !session.is_shown(panel_opened_by(PanelOpener::levelled))) return overlay;
  for (std::uint32_t i = 0; i < account->rules.size(); ++i) {
    const Edge e(i);
    if (account->rules[i] == no_rule || rule_looks[account->rules[i]].width_px == 0) continue;
    if (session.hidden().hides(session.mesh(), Element(e))) continue;
    const auto rule = static_cast<EdgeRule>(account->rules[i]);
    const RuleLooks& looks = rule_looks[account->rules[i]];
    const auto [a, b] = ends(session.mesh(), e);
    overlay.lines.push_back({session.mesh().position(a), session.mesh().position(b), rgb(colour_of(rule, theme)),
                             looks.line, looks.width_px, 0, false});
  }
  return overlay;
}

// Whether more of the faces are in view than can be told apart by thick lines.
static bool are_many_in_view(const Session& session, std::span<const Face> faces) {
  constexpr std::size_t most = 200;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < faces.size() && seen <= most; ++i) {
    const Vertex v = session.mesh().from(session.mesh().halfedge(faces[i]));
    const auto at = project(session.camera, session.view, session.drawn_positions()[v.index]);
    seen += at && at->pixel.x >= 0 && at->pixel.y >= 0 && at->pixel.x < session.view.width &&
            at->pixel.y < session.view.height;
  }
  return seen > most;
}

// Many are drawn thin and where they are seen, so that what is moved stays to be seen among them.
static void draw_spoilt(const Session& session, Theme theme, Overlay& overlay) {
  const std::span<const Face> faces = session.spoilt_by_gesture();
  const bool are_many = are_many_in_view(session, faces);
  Style looks = style(Role::refused, theme);
  if (are_many) {
    looks.line = LineStyle::solid;
    looks.width_px = 1;
  }
  Painter painter(session, overlay, looks, are_many ? 0.f : 1.f, 0, are_many);
  for (const Face f : faces) painter.draw(f, false);
}

Overlay hover_overlay(const Session& session, Theme theme) {
  Overlay overlay;
  draw_spoilt(session, theme, overlay);
  const SnapTarget* const target = session.gesture() ? session.gesture()->snapped_to() : nullptr;
  if (target && target->element.kind != Element::Kind::vertex)
    Painter(session, overlay, style(Role::hover, theme), 1).draw(target->element);
  if (!session.hover()) return overlay;
  const Hover& hover = *session.hover();
  if (!hover.op) {
    Painter(session, overlay, style(Role::hover, theme), 1).draw(hover.picked.element);
    return overlay;
  }
  if (hover.preview.verdict.legal()) {
    Ghost(session, theme, overlay).draw(hover.preview, hover.picked.element);
    return overlay;
  }
  Painter witness(session, overlay, style(Role::witness, theme), 0.6f);
  for (const Reason& reason : hover.preview.verdict.reasons)
    for (const Element& e : reason.witnesses) witness.draw(e);
  Painter(session, overlay, style(Role::refused, theme), 1).draw(hover.picked.element);
  return overlay;
}

}  // namespace ryosen
