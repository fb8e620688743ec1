#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/editor/commands/text/words.h"
#include "app/editor/document/element_values.h"
#include "app/editor/document/findings.h"
#include "app/editor/session/selecting.h"
#include "app/editor/shown/levels.h"
#include "app/ui/overlays.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "ryosen/algo/edge_rules.h"
#include "ryosen/document/document.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

std::string place_text(const glm::dvec3& p) {
  return short_number(p.x) + "  " + short_number(p.y) + "  " + short_number(p.z);
}

// Of a direction no more digits are told than are seen.
std::string direction_text(const glm::dvec3& d) { return place_text(glm::round(1e4 * d) / 1e4 + 0.0); }

// The vector area of the face.
glm::dvec3 area_vector(const Mesh& m, Face f) { return vector_area(FacePolygon(m, f).keyhole_walk()); }

class Inspector {
 public:
  explicit Inspector(PanelContext& context) : context_(context), m_(context.mesh()) {}

  // One of so many that are selected.
  void draw(const Element& element, std::size_t selected) {
    bold_text(context_, name_and_slot(m_, element).c_str());
    if (selected > 1) tell_of_others(selected - 1, element.kind == Element::Kind::vertex);
    element.visit([&](auto handle) { draw(handle); });
    draw_values(element);
  }

 private:
  void value(UiText label, const std::string& text) { labelled(context_, context_.text(label), text); }
  void note(UiText text) { coloured_text(context_.colours().warning, context_.text(text)); }

  void draw_values(const Element& element) {
    for (const ElementValue& each : values_of(m_, context_.document().tables(), element))
      labelled(context_, each.name.c_str(), each.is_number ? with_short_numbers(each.value) : each.value);
  }

  // Above what may take more lines than the panel has.
  void tell_of_others(std::size_t others, bool is_vertex) {
    const std::string n = grouped(static_cast<std::int64_t>(others));
    Text told{others == 1 ? "One more element is selected. " : n + " more elements are selected. ",
              "ほかに " + n + " 個を選択中です。"};
    told += (others < most_ringed
                 ? Text{"This one was selected last: it has the ring.", "最後に選んだのはこの要素で、輪で示します。"}
                 : Text{"This one was selected last.", "最後に選んだのはこの要素です。"});
    if (is_vertex)
      told += Text{" Welding joins the others into it.", "縫合すると、ほかの頂点はこの頂点にまとまります。"};
    dim_text(context_, told.in(context_.language()).c_str());
  }

  void links(UiText label, const std::vector<Element>& elements) {
    dim_text(context_, context_.text(label));
    if (elements.empty()) return;
    element_links(context_, elements);
  }
  void link_to(UiText label, Element element) {
    ImGui::TextColored(context_.colours().dim, "%s", context_.text(label));
    ImGui::SameLine(5 * ImGui::GetFontSize());
    if (element.index == no_index) return ImGui::TextUnformatted(context_.text(UiText::outside));
    ImGui::PushID(static_cast<int>(label));
    if (link(context_, link_name(m_, element).c_str())) context_.run("select " + name_to_select(m_, element));
    ImGui::PopID();
  }

  void draw(Vertex v) {
    value(UiText::position, place_text(m_.position(v)));
    if (has_copies(m_, v)) {
      std::vector<Element> copies;
      for_each_copy(m_, v, [&](Vertex copy) { copies.push_back(copy); });
      links(UiText::copies, copies);
    }
    if (m_.is_isolated(v)) {
      const IndexSet& isolated = context_.findings().highlights().of(ProblemKind::isolated_vertex);
      if (isolated.contains(point(m_, v).index)) note(UiText::isolated);
      return;
    }
    if (m_.is_boundary(v)) note(UiText::boundary);
    std::vector<Element> around, sides;
    for (Vertex w : neighbours(m_, v)) around.push_back(w);
    for (Face f : faces_around(m_, v))
      if (!f.is_none()) sides.push_back(f);
    value(UiText::degree, std::to_string(around.size()));
    links(UiText::neighbours, around);
    links(UiText::faces, sides);
  }

  void draw(Edge e) {
    const auto [a, b] = ends(m_, e);
    const auto [left, right] = faces(m_, e);
    tell_rule(e);
    value(UiText::length, short_number(glm::length(m_.position(b) - m_.position(a))));
    const PointEdge on_points = point_edge(m_, halfedge(e));
    if (on_points.is_boundary()) note(UiText::boundary);
    if (on_points.is_nonmanifold()) note(UiText::nonmanifold);
    if (on_points.is_misoriented()) note(UiText::misoriented);
    if (!left.is_none() && !right.is_none()) value(UiText::angle, angle_text(halfedge(e), left, right));
    links(UiText::vertices, {a, b});
    std::vector<Element> sides;
    for (Face f : {left, right})
      if (!f.is_none()) sides.push_back(f);
    links(UiText::faces, sides);
    links(UiText::halfedges, {halfedge(e, 0), halfedge(e, 1)});
  }

  // Why a simplification left it, where that is known.
  void tell_rule(Edge e) {
    const LeftEdges* const left_edges = context_.findings().left_edges();
    if (!left_edges || left_edges->rules[e.index] == no_rule) return;
    const EdgeRuleRow& rule = edge_rule_table()[left_edges->rules[e.index]];
    labelled(context_, context_.text("left by", "残る理由"), context_.text(rule.name_en.data(), rule.name_ja.data()));
    dim_text(context_, context_.text(rule.en.data(), rule.ja.data()));
  }

  // The dihedral angle: 180 degrees if coplanar, less at a ridge, more in a valley.
  std::string angle_text(Halfedge h, Face left, Face right) const {
    const glm::dvec3 n = area_vector(m_, left), o = area_vector(m_, right);
    const double size = glm::length(n) * glm::length(o);
    if (!(size > 0)) return "\u2013";
    const glm::dvec3 along = m_.position(m_.to(h)) - m_.position(m_.from(h));
    const double turn = std::atan2(glm::dot(glm::cross(n, o), along) / glm::length(along), glm::dot(n, o));
    return short_number(180 - turn * 180 / std::numbers::pi) + "°";
  }

  void draw(Halfedge h) {
    link_to(UiText::from, m_.from(h));
    link_to(UiText::to, m_.to(h));
    link_to(UiText::next, m_.next(h));
    link_to(UiText::prev, m_.prev(h));
    link_to(UiText::twin, twin(h));
    link_to(UiText::face, m_.face(h));
    link_to(UiText::edge, edge(h));
  }

  void draw(Face f) {
    const glm::dvec3 n = area_vector(m_, f);
    const double area = glm::length(n);
    value(UiText::area, short_number(area));
    if (area > 0) value(UiText::normal, direction_text(n / area));
    std::vector<Element> corners, around;
    for (Vertex v : vertices_around(m_, f)) corners.push_back(v);
    for (Face g : neighbour_faces(m_, f))
      if (!g.is_none()) around.push_back(g);
    const std::vector<std::uint32_t>& lines = context_.document().tables().face_lines;
    if (f.index < lines.size() && lines[f.index] > 0) value(UiText::line_in_file, std::to_string(lines[f.index]));
    links(UiText::corners, corners);
    links(UiText::neighbours, around);
  }

  PanelContext& context_;
  const Mesh& m_;
};

// The element that was selected last, or else the one under the pointer.
void draw_inspector(PanelContext& context) {
  if (context.selecting.selection.empty() && !context.selecting.hover())
    return dim_text(context, context.text(UiText::nothing_picked));
  const Element element = context.selecting.selection.empty() ? context.selecting.hover()->picked.element
                                                              : context.selecting.selection.back();
  Inspector(context).draw(element, context.selecting.selection.size());
}

}  // namespace

std::unique_ptr<Panel> make_inspector_panel() { return panel_of_lines(draw_inspector, 9); }

}  // namespace ryosen
