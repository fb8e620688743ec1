#include "core/ops/weld.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>
#include <utility>

#include "core/analysis/index_set.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/ops/lines/arguments.h"
#include "core/ops/rules/corner_values.h"
#include "core/ops/rules/face_geometry.h"
#include "core/ops/rules/face_lists.h"
#include "core/ops/rules/pinch.h"
#include "core/ops/rules/sheets.h"
#include "core/ops/rules/surgery.h"

namespace ryosen {

namespace {

// Removed points, each with the one it is merged into.
using Pairs = std::vector<std::pair<Vertex, Vertex>>;

// The boundary halfedge, over all sheets, of an edge with one face.
Halfedge boundary_half(const Mesh& m, Halfedge h) {
  for (Halfedge sheet : sheets_between(m, m.from(h), m.to(h)))
    if (m.is_outside(sheet) != m.is_outside(twin(sheet))) return outside_half(m, sheet);
  return Halfedge();
}

// Checks the polygon list after the weld, around the welded points.
class WeldJudge {
 public:
  WeldJudge(const Mesh& m, const Pairs& pairs, Verdict& verdict) : m_(m), verdict_(verdict) {
    for (const auto& [goes, stays] : pairs) {
      becomes_[goes] = stays;
      welded_.insert({goes, stays});
    }
  }

  void judge() {
    gather_faces();
    for (Face f : faces_) check_corners(f);
    check_edges();
    if (verdict_.legal()) check_duplicates();
  }

 private:
  Vertex after(Vertex p) const {
    const auto found = becomes_.find(p);
    return found == becomes_.end() ? p : found->second;
  }

  std::vector<std::uint32_t> points_before(Face f) const { return point_set(loops_of(m_, f).corners); }
  std::vector<std::uint32_t> points_after(Face f) const {
    std::vector<std::uint32_t> points;
    for (std::uint32_t p : points_before(f)) points.push_back(after(Vertex(p)).index);
    return point_set(points);
  }

  void gather_faces() {
    for (Vertex p : welded_)
      for_each_copy(m_, p, [&](Vertex copy) {
        for (Face f : faces_around(m_, copy))
          if (f) faces_.insert(f);
      });
  }

  void check_corners(Face f) {
    if (points_after(f).size() == points_before(f).size()) return;
    for (const auto& [goes, stays] : becomes_) verdict_.refuse(Rule::common_face, {f, goes, stays});
  }

  // Edges that become coincident must be the two sides of a gap.
  void check_edges() {
    struct Joined {
      std::set<std::pair<Vertex, Vertex>> pairs;
      std::vector<Edge> edges;
      std::uint32_t forward = 0, backward = 0;
      bool wire = false;
    };
    std::map<std::pair<Vertex, Vertex>, Joined> joined;
    for (Vertex p : welded_)
      for_each_copy(m_, p, [&](Vertex copy) {
        for (Halfedge h : outgoing(m_, copy)) {
          const Vertex q = point(m_, m_.to(h));
          Joined& at = joined[{after(p), after(q)}];
          at.pairs.insert({p, q});
          at.edges.push_back(edge(h));
          at.forward += !m_.is_outside(h);
          at.backward += !m_.is_outside(twin(h));
          at.wire |= m_.is_wire(edge(h));
        }
      });
    for (auto& [ends, at] : joined) {
      const bool seen_from_other_end = ends.first > ends.second && joined.contains({ends.second, ends.first});
      if (ends.first == ends.second) {
        if (m_.is_wire(at.edges[0])) verdict_.refuse(Rule::edge_exists, {at.edges[0]});
      } else if (at.pairs.size() > 1 && !seen_from_other_end && (at.wire || at.forward != 1 || at.backward != 1)) {
        verdict_.reasons.push_back({Rule::common_neighbour, {ends.second}});
        std::sort(at.edges.begin(), at.edges.end());
        for (Edge e : at.edges) verdict_.reasons.back().witnesses.push_back(e);
      }
    }
  }

  void check_duplicates() {
    std::map<std::vector<std::uint32_t>, std::vector<Face>> on;
    for (Face f : faces_) on[points_after(f)].push_back(f);
    for (const auto& [points, faces] : on)
      for (std::size_t i = 1; i < faces.size(); ++i)
        if (points_before(faces[i]) != points_before(faces[0]))
          verdict_.refuse(Rule::duplicate_face, {faces[0], faces[i]});
  }

  const Mesh& m_;
  Verdict& verdict_;
  std::map<Vertex, Vertex> becomes_;
  std::set<Vertex> welded_;
  std::set<Face> faces_;
};

// Checks merging two copies of one point into one vertex.
void check_copies(const Mesh& m, Vertex a, Vertex b, Verdict& verdict) {
  for (Vertex v : {a, b})
    if (!m.is_isolated(v) && !m.is_boundary(v)) verdict.refuse(Rule::no_gap, {v, m.face(m.halfedge(v))});
  std::set<Vertex> at_a;
  for (Vertex v : neighbours(m, a)) at_a.insert(v);
  for (Halfedge h : outgoing(m, b))
    if (at_a.contains(m.to(h)))
      verdict.refuse(Rule::common_neighbour, {point(m, m.to(h)), edge(find_halfedge(m, a, m.to(h))), edge(h)});
}

// Whether both have a gap and no common neighbour.
bool can_be_one(const Mesh& m, Vertex a, Vertex b) {
  Verdict verdict;
  check_copies(m, a, b, verdict);
  return verdict.legal() && !m.is_isolated(a) && !m.is_isolated(b);
}

// The pairs of points merged by an edge weld; those of the first edge stay.
Pairs pairs_of_edges(const Mesh& m, Halfedge first, Halfedge second) {
  const Halfedge h = boundary_half(m, first), g = boundary_half(m, second);
  Pairs pairs;
  for (const auto& [goes, stays] : {std::pair(m.to(g), m.from(h)), std::pair(m.from(g), m.to(h))})
    if (!same_point(m, goes, stays)) pairs.emplace_back(point(m, goes), point(m, stays));
  return pairs;
}

void check_edges_to_weld(const Mesh& m, Halfedge first, Halfedge second, Verdict& verdict) {
  if (same_point(m, m.from(first), m.from(second)) && same_point(m, m.to(first), m.to(second)))
    return verdict.refuse(Rule::same_edge, {edge(first)});
  if (same_point(m, m.from(first), m.to(second)) && same_point(m, m.to(first), m.from(second)))
    return verdict.refuse(Rule::same_edge, {edge(first)});
  for (Halfedge h : {first, second}) {
    const PointEdge faces = point_edge(m, h);
    if (faces.faces() == 0) verdict.refuse(Rule::wire, {edge(h)});
    if (faces.faces() > 1) verdict.refuse(Rule::has_face, {edge(h), m.face(m.is_outside(h) ? twin(h) : h)});
  }
  if (!verdict.legal()) return;
  const Halfedge h = boundary_half(m, first), g = boundary_half(m, second);
  // If both start, or both end, at their common point, welding them in opposite directions would merge each edge's own
  // ends.
  for (const auto& [x, y] : {std::pair(m.from(h), m.from(g)), std::pair(m.to(h), m.to(g))})
    if (same_point(m, x, y)) return verdict.refuse(Rule::common_face, {m.face(twin(h)), point(m, x)});
  WeldJudge(m, pairs_of_edges(m, first, second), verdict).judge();
}

}  // namespace

std::vector<Element> vertices_of_elements(const Mesh& mesh, std::span<const Element> selected) {
  std::vector<Element> vertices;
  IndexSet seen;
  const auto add = [&](Vertex v) {
    if (seen.insert(v.index)) vertices.emplace_back(v);
  };
  for (const Element& e : selected) {
    if (e.kind == Element::Kind::vertex) add(e.vertex());
    if (e.kind == Element::Kind::edge || e.kind == Element::Kind::halfedge) {
      const Halfedge h = e.kind == Element::Kind::edge ? halfedge(e.edge()) : e.halfedge();
      add(mesh.from(h));
      add(mesh.to(h));
    }
    if (e.kind == Element::Kind::face)
      for (const Vertex v : vertices_around(mesh, e.face())) add(v);
  }
  return vertices;
}

Parsed<Weld> Weld::parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
  ArgumentReader in(mesh, arguments, info.syntax);
  Weld op;
  if (in.peek().find('-') != std::string_view::npos) {
    op.first = in.halfedge();
    op.second = in.halfedge();
  } else {
    op.a = in.vertex();
    op.b = in.vertex();
  }
  if (in.word("mid")) {
    op.place = Place::middle;
  } else if (!op.first && !in.failed() && !in.at_end()) {
    op.place = Place::point;
    op.target = in.place();
  }
  return in.result(op);
}

std::string Weld::command(const Mesh& mesh) const {
  const std::string where = place == Place::middle            ? " mid"
                            : place == Place::point && !first ? " " + format_place(target)
                                                              : "";
  if (first) return "weld " + name_of(mesh, first) + " " + name_of(mesh, second) + where;
  return "weld " + name_of_copy(mesh, a) + " " + name_of_copy(mesh, b) + where;
}

Verdict Weld::check(const Mesh& mesh) const {
  Verdict verdict;
  if (first) {
    if (is_gone(mesh, first, verdict) || is_gone(mesh, second, verdict)) return verdict;
    check_edges_to_weld(mesh, first, second, verdict);
    return verdict;
  }
  if (is_gone(mesh, a, verdict) || is_gone(mesh, b, verdict)) return verdict;
  if (a == b)
    verdict.refuse(Rule::same_vertex, {a});
  else if (same_point(mesh, a, b))
    check_copies(mesh, a, b, verdict);
  else
    WeldJudge(mesh, {{point(mesh, b), point(mesh, a)}}, verdict).judge();
  return verdict;
}

std::vector<Reason> Weld::warnings(const Mesh& mesh) const {
  Pairs pairs;
  if (first) pairs = pairs_of_edges(mesh, first, second);
  if (!first && !same_point(mesh, a, b)) pairs = {{point(mesh, b), point(mesh, a)}};
  std::vector<Reason> reasons;
  warn_of_pinch(pinched_by_weld(mesh, pairs), reasons);
  return reasons;
}

namespace {

glm::dvec3 place_of(const Mesh& m, const Weld& op, Vertex goes, Vertex stays) {
  if (op.place == Weld::Place::point && !op.first) return op.target;
  return op.place == Weld::Place::middle ? point_between(m.position(stays), m.position(goes), 0.5) : m.position(stays);
}

void move_whole(Edit& edit, Sheets& sheets, Vertex v, const glm::dvec3& to) {
  if (edit.mesh().position(v) == to) return;
  move_point(edit, v, to);
  for_each_copy(edit.mesh(), v, [&](Vertex copy) { sheets.changed_around(copy); });
}

// Makes all vertices of one point copies of the other, with its position and values.
void unite_points(Edit& edit, Sheets& sheets, Vertex goes, Vertex stays) {
  const Mesh& m = edit.mesh();
  move_point(edit, goes, m.position(stays));
  for_each_copy(m, goes, [&](Vertex copy) {
    blend_vertex_values(edit, stays, stays, 0, copy);
    sheets.changed_around(copy);
  });
  join_copies(edit, goes, stays);
}

void make_one(Edit& edit, Sheets& sheets, Vertex a, Vertex b) {
  const Mesh& m = edit.mesh();
  sheets.join_corner(m.prev(m.halfedge(a)), m.halfedge(b));
}

}  // namespace

OpEffect Weld::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  Sheets sheets(edit);
  const bool is_one_point = !first && same_point(m, a, b);
  Pairs pairs;
  if (first) pairs = pairs_of_edges(m, first, second);
  if (!first && !is_one_point) pairs = {{b, a}};
  for (const auto& [goes, stays] : pairs) {
    move_whole(edit, sheets, stays, place_of(m, *this, goes, stays));
    unite_points(edit, sheets, goes, stays);
  }
  if (is_one_point) move_whole(edit, sheets, a, place_of(m, *this, b, a));
  std::vector<Vertex> touched;
  for (const auto& [goes, stays] : pairs) {
    for (Vertex v : {goes, stays})
      if (m.is_isolated(v) && has_copies(m, v)) sheets.remove_vertex(v);
    touched.push_back(std::min(goes, stays));
  }
  if (is_one_point) {
    for (Vertex v : {a, b})
      if (m.is_isolated(v) && has_copies(m, v)) sheets.remove_vertex(v);
    touched.push_back(std::min(a, b));
  }
  sheets.settle(touched);
  if (!first && m.is_alive(a) && m.is_alive(b) && can_be_one(m, a, b)) make_one(edit, sheets, a, b);
  return sheets.finish();
}

}  // namespace ryosen
