#include "app/ui/overlays.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "app/editor/camera/view_state.h"
#include "app/editor/document/findings.h"
#include "app/editor/labels/drawn_links.h"
#include "app/editor/preferences/layout.h"
#include "app/editor/session/selecting.h"
#include "app/editor/shown/gesturing.h"
#include "app/editor/shown/levels.h"
#include "app/ui/overlay_painter.h"
#include "ryosen/analysis/measures.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

// The vertices at the ends of edges whose lines would hide the dots that the surface has there.
class EndDots {
 public:
  EndDots(const Mesh& mesh, std::span<const glm::dvec3> places) : m_(mesh), places_(places) {}

  void add(Edge e) {
    const auto [a, b] = ends(m_, e);
    const double length = glm::length(places_[a.index] - places_[b.index]);
    for (const Vertex v : {a, b}) {
      const auto [at, is_new] = room_.try_emplace(point(m_, v), length);
      if (!is_new) at->second = std::min(at->second, length);
    }
  }

  void draw(Theme theme, Overlay& overlay) const {
    constexpr float radius_px = 2.2f;  // with the outline of points as wide as the dots of the surface
    const Rgba colour = with_alpha(palette(theme).wire, 255);
    for (const auto& [v, room] : room_)
      overlay.points.push_back({places_[v.index], colour, PointShape::disc, radius_px, 0, room, true});
  }

 private:
  const Mesh& m_;
  std::span<const glm::dvec3> places_;
  std::map<Vertex, double> room_;  // the length of the shortest of its edges
};

}  // namespace

Overlay highlight_overlay(Findings& findings, std::span<const glm::dvec3> places, const HighlightRow& row, Mark mark,
                          std::uint32_t first, std::uint32_t end, const ViewSettings& settings, double room) {
  Overlay overlay;
  Painter painter(findings.mesh(), places, overlay, style(row.looks, settings.theme), faintly, room);
  EndDots dots(findings.mesh(), places);
  findings.highlights().of(mark).for_each_in(first, end, [&](std::uint32_t i) {
    Element e;
    e.kind = mark.sort;
    e.index = i;
    if (findings.hidden().hides(findings.mesh(), e)) return;
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
static void draw_last(const Findings& findings, const Selecting& selecting, const Gesturing& gesturing, Theme theme,
                      Overlay& overlay) {
  if (selecting.selection.size() < 2 || selecting.selection.size() > most_ringed) return;
  const Mesh& mesh = findings.mesh();
  const Element& last = selecting.selection.back();
  if (findings.hidden().hides(mesh, last)) return;
  glm::dvec3 sum(0);
  double n = 0;
  for_each_vertex(mesh, last, [&](Vertex v) {
    sum += gesturing.drawn_positions()[v.index];
    ++n;
  });
  overlay.points.push_back({sum / n, style(Role::witness, theme).colour, PointShape::ring, 11, faintly});
}

Overlay selection_overlay(const Findings& findings, const ViewState& view, const Selecting& selecting,
                          const Gesturing& gesturing, Theme theme) {
  Overlay overlay;
  // Of very many those behind are hidden by those before, and dense ones need not be wide to be seen.
  constexpr std::size_t many = 1000, very_many = 20000;
  const std::size_t n = selecting.selection.size();
  Painter painter(findings.mesh(), gesturing.drawn_positions(), overlay, style(Role::selected, theme),
                  n > very_many ? 0 : faintly, 0, n > many);
  constexpr std::size_t most_outlines = 60;  // the surface fills them
  const auto is_face = [](const Element& e) { return e.kind == Element::Kind::face; };
  const bool has_outlines = selecting.selection.count(Element::Kind::face) <= most_outlines;
  const bool has_arrow = view.links.is_on(findings, selecting,
                                          gesturing);  // of the selected halfedge, in its face
  const auto is_drawn = [&](const Element& e) {
    return (has_outlines || !is_face(e)) &&
           !(has_arrow && e.kind == Element::Kind::halfedge && e == selecting.selection.back()) &&
           !findings.hidden().hides(findings.mesh(), e);
  };
  for (const Element& e : selecting.selection)
    if (is_drawn(e)) painter.draw(e);
  draw_last(findings, selecting, gesturing, theme, overlay);
  return overlay;
}

Overlay verdicts_overlay(const Findings& findings, std::span<const glm::dvec3> places, const ToolVerdicts& verdicts,
                         ElementVerdict which, std::uint32_t first, std::uint32_t end, Theme theme, double room) {
  constexpr std::size_t many = 1000;
  Overlay overlay;
  Style looks = style(which == ElementVerdict::legal ? Role::legal : Role::refused, theme);
  looks.width_px = 2;
  Painter painter(findings.mesh(), places, overlay, looks, 0, room, verdicts.all().size() > many);
  const auto draw = [&](const auto element) {
    if (!findings.hidden().hides(findings.mesh(), element)) painter.draw_mark(element);
  };
  for (std::uint32_t i = first; i < end; ++i) {
    if (verdicts.all()[i] != which) continue;
    if (verdicts.sort() == Element::Kind::edge) draw(Edge(i));
    if (verdicts.sort() == Element::Kind::vertex) draw(Vertex(i));
    if (verdicts.sort() == Element::Kind::face) draw(Face(i));
  }
  return overlay;
}

Overlay measures_overlay(const Mesh& mesh, const Selecting& selecting, Theme theme) {
  Overlay overlay;
  const Style looks = style(Role::witness, theme);
  const auto lives = [&](const Element& e) { return is_alive(mesh, e); };
  for (const Elements& measured : selecting.measures) {
    if (!std::all_of(measured.begin(), measured.end(), lives)) continue;
    const std::vector<glm::dvec3> path = measure(mesh, measured).path;
    for (std::size_t i = 0; i < path.size(); ++i) {
      overlay.points.push_back({path[i], looks.colour, PointShape::disc, 3.5f});
      if (i > 0) overlay.lines.push_back({path[i - 1], path[i], looks.colour, looks.line, 2.5f});
    }
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
    {EdgeRule::seam, 0xC9A227, 0x6B5200, LineStyle::dash_dot, 2.4f},
    {EdgeRule::boundary, 0x6CC2FF, 0x1F5FA8, LineStyle::dashed, 2.4f},
    {EdgeRule::normal, 0xE58CC0, 0x9E3D78, LineStyle::solid, 2.4f},
    {EdgeRule::angle, 0xF0E442, 0x8A7A00, LineStyle::dash_dot, 2.4f},
    {EdgeRule::error, 0xFF6F61, 0xB3261E, LineStyle::solid, 2.4f},
    {EdgeRule::selection, 0xB59CFF, 0x5B3FA8, LineStyle::dashed, 2.4f},
    {EdgeRule::self_intersection, 0xFFFFFF, 0x202020, LineStyle::dotted, 2.4f},
    {EdgeRule::distance, 0xA6761D, 0x7A4B12, LineStyle::dotted, 2.4f},
    {EdgeRule::free, 0x2BD9A0, 0x007A58, LineStyle::solid, 0},
};
static_assert(rows_are_in_order(rule_looks, &RuleLooks::rule));

}  // namespace

std::uint32_t colour_of(EdgeRule rule, Theme theme) {
  const RuleLooks& looks = rule_looks[static_cast<std::size_t>(rule)];
  return theme == Theme::dark ? looks.dark : looks.light;
}

Overlay left_edges_overlay(const Findings& findings, const Layout& layout, Theme theme) {
  Overlay overlay;
  const LeftEdges* const left_edges = findings.left_edges();
  if (!left_edges || !layout.is_shown(panel_opened_by(PanelOpener::levelled))) return overlay;
  for (std::uint32_t i = 0; i < left_edges->rules.size(); ++i) {
    const Edge e(i);
    if (left_edges->rules[i] == no_rule || rule_looks[left_edges->rules[i]].width_px == 0) continue;
    if (findings.hidden().hides(findings.mesh(), Element(e))) continue;
    const auto rule = static_cast<EdgeRule>(left_edges->rules[i]);
    const RuleLooks& looks = rule_looks[left_edges->rules[i]];
    const auto [a, b] = ends(findings.mesh(), e);
    overlay.lines.push_back({findings.mesh().position(a), findings.mesh().position(b), rgb(colour_of(rule, theme)),
                             looks.line, looks.width_px, 0, false});
  }
  return overlay;
}

namespace {

// The looks of an arrow by its role; line style and label tell apart what colours may not.
struct LinkLooks {
  LinkRole role;
  std::uint32_t dark, light;  // 0xRRGGBB
  LineStyle line;
  float width_px;
};
constexpr LinkLooks link_looks[] = {
    {LinkRole::all, 0x8FC7FF, 0x1F5FA8, LineStyle::solid, 1.6f},
    {LinkRole::trail, 0xF0E442, 0x8A7A00, LineStyle::dotted, 2.2f},
    {LinkRole::itself, 0xE69F00, 0xB36B00, LineStyle::solid, 3.4f},
    {LinkRole::next, 0x2BD9A0, 0x007A58, LineStyle::solid, 2.6f},
    {LinkRole::prev, 0x56B4E9, 0x0062A3, LineStyle::dashed, 2.6f},
    {LinkRole::twin, 0xE58CC0, 0x9E3D78, LineStyle::dash_dot, 2.6f},
    {LinkRole::vertex, 0xFFFFFF, 0x202020, LineStyle::solid, 2.2f},
    {LinkRole::face, 0xFFFFFF, 0x202020, LineStyle::dotted, 2.0f},
    {LinkRole::around, 0x56B4E9, 0x0062A3, LineStyle::solid, 2.2f},
    {LinkRole::wing, 0x56B4E9, 0x0062A3, LineStyle::solid, 2.4f},
    {LinkRole::ring, 0xE58CC0, 0x9E3D78, LineStyle::dashed, 2.4f},
    {LinkRole::normal, 0xFFFFFF, 0x202020, LineStyle::solid, 2.2f},
};
static_assert(rows_are_in_order(link_looks, &LinkLooks::role));

// Text 003 draws what has no opposite in another colour.
constexpr std::uint32_t boundary_dark = 0x2BD9A0, boundary_light = 0x00785A;

}  // namespace

Overlay links_overlay(std::span<const LinkArrow> arrows, Theme theme) {
  Overlay overlay;
  const bool is_dark = theme == Theme::dark;
  for (const LinkArrow& arrow : arrows) {
    const LinkLooks& looks = link_looks[static_cast<std::size_t>(arrow.role)];
    std::uint32_t colour = is_dark ? looks.dark : looks.light;
    if (arrow.role == LinkRole::all && arrow.is_boundary) colour = is_dark ? boundary_dark : boundary_light;
    const float hidden = arrow.role == LinkRole::all ? 0 : faintly;
    // The shaft of a thin one has an edge that sets it off from a surface of any brightness.
    if (arrow.role == LinkRole::all)
      overlay.lines.push_back(
          {arrow.from, arrow.to, palette(theme).outline, looks.line, looks.width_px + 1.8f, hidden, false});
    if (arrow.from == arrow.to)
      overlay.points.push_back({arrow.from, rgb(colour), PointShape::ring, 8, hidden});
    else
      overlay.lines.push_back({arrow.from, arrow.to, rgb(colour), looks.line, looks.width_px, hidden, true});
  }
  return overlay;
}

double room_of_points(const Box& bounds, std::size_t count) {
  constexpr std::size_t few = 100;
  if (count < few || bounds.is_empty()) return 0;
  const glm::dvec3 size = bounds.highest - bounds.lowest;
  const double smallest = std::min({size.x, size.y, size.z}), largest = std::max({size.x, size.y, size.z});
  const double middle = size.x + size.y + size.z - smallest - largest, each = 1 / static_cast<double>(count);
  const double room = std::max(std::sqrt(largest * middle * each), largest * each);
  return room > 0 && std::isfinite(room) ? std::exp2(std::round(std::log2(room))) : 0;
}

}  // namespace ryosen
