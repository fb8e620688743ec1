#include "app/ui/overlays.h"

#include <algorithm>

#include "app/editor/camera/view_state.h"
#include "app/editor/document/findings.h"
#include "app/editor/preferences/layout.h"
#include "app/editor/session/selecting.h"
#include "app/editor/shown/gesturing.h"
#include "app/editor/shown/levels.h"
#include "app/ui/end_dots.h"
#include "app/ui/overlay_painter.h"
#include "ryosen/analysis/measures.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

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
  const auto add = [&](Vertex v) {
    sum += gesturing.drawn_positions()[v.index];
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

}  // namespace ryosen
