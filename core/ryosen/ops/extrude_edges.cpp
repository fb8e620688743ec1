#include "ryosen/ops/extrude_edges.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/bridges.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/faces_at.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/extrude.h"
#include "ryosen/ops/make_face.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/pinch.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

namespace {

using namespace parameters;

std::optional<Text> fault_of_edge_extrusion(const Mesh& mesh, const void* op) {
  const ExtrudeEdges& extrude = *static_cast<const ExtrudeEdges*>(op);
  if (!extrude.offset && !extrude.distance) return std::nullopt;
  const glm::dvec3 by = extrude.movement(mesh);
  for (const Halfedge h : extrude.edges)
    for (const Vertex v : {mesh.from(h), mesh.to(h)})
      if (is_finite(mesh.position(v)) && !is_finite(mesh.position(v) + by))
        return Text{"a movement that leaves the edge at a finite place", "稜線の座標が有限になる移動量を"};
  return std::nullopt;
}

// The edges at the far end of the new faces.
std::vector<Element> far_edges(const Mesh& mesh, const void*, const ColumnLengths& before) {
  std::vector<Element> found;
  for (const Edge e : live_edges(mesh, Edge(before.halfedges / 2))) {
    const auto [a, b] = ends(mesh, e);
    if (point(mesh, a).index >= before.vertices && point(mesh, b).index >= before.vertices) found.push_back(e);
  }
  return found;
}

constexpr OpDrag drag_of_edge_extrusion{.moved = far_edges,
                                        .begins_flat = true,
                                        .selects_moved = true,
                                        .unmoved_en = extruded_by_nothing_en,
                                        .unmoved_ja = extruded_by_nothing_ja};

constexpr OpParameter extrude_edges_parameters[] = {
    with_words({"edges", "Edges", "稜線", "the edges whose copies are moved together", "複製をまとめて動かす稜線"},
               list(edge<&ExtrudeEdges::edges>("A-B"), "C-D")),
    with_words(
        {"by", "Movement", "移動量",
         "how far the copies move away from their faces, or by X,Y,Z (by the mean length if it is left out)",
         "面から離れる方向の距離、または移動量 X,Y,Z（省くと長さの平均）"},
        dragged(drag_of_edge_extrusion, optional(named("Distance", "距離", number<&ExtrudeEdges::distance>("DISTANCE")),
                                                 named("Offset", "移動量", position<&ExtrudeEdges::offset>()))))};

}  // namespace

constinit const OpInfo ExtrudeEdges::info{
    .id = "extrude_edges",
    .name_en = "Extrude edges",
    .name_ja = "稜線の押し出し",
    .line = {.lists = {extrude_edges_parameters}, .fault = fault_of_edge_extrusion},
    .help_en =
        "moves copies of edges together, away from their faces or by X,Y,Z, and connects each to its edge by a face",
    .help_ja = "稜線の複製をまとめて面から離れる方向または X,Y,Z だけ動かし、元の稜線と面でつなぐ",
    .target = OpTargetKind::edge,
    .group = OpGroup::refine,
    .on_selection = OnSelection::all};

namespace {

// The side of a face along an edge between two points: that of the halfedge, of its twin, else of another sheet. The
// halfedge itself where there are but wires.
Halfedge side_of(const Mesh& m, Halfedge h) {
  if (!m.is_outside(h)) return h;
  if (!m.is_outside(twin(h))) return twin(h);
  for (Halfedge sheet : sheets_between(m, m.from(h), m.to(h)))
    for (Halfedge side : {sheet, twin(sheet)})
      if (!m.is_outside(side)) return side;
  return h;
}

class NamedSides {
 public:
  NamedSides(const Mesh& m, std::span<const Halfedge> edges) : m_(m) {
    std::set<std::pair<Vertex, Vertex>> met;
    for (Halfedge h : edges)
      if (met.insert(std::minmax(start(h), start(twin(h)))).second) sides_.push_back(side_of(m, h));
    for (std::size_t i = 0; i < sides_.size(); ++i)
      for (Halfedge h : {sides_[i], twin(sides_[i])}) at_[start(h)].push_back(i);
    is_directed_.resize(sides_.size());
    for (std::size_t i = 0; i < sides_.size(); ++i)
      if (m.is_outside(sides_[i]) != m.is_outside(twin(sides_[i]))) direct(i);
    follow();
    for (std::size_t i = 0; i < sides_.size(); ++i, follow())
      if (!is_directed_[i]) direct(i);
  }

  std::vector<Halfedge> take() { return std::move(sides_); }

 private:
  Vertex start(Halfedge h) const { return point(m_, m_.from(h)); }
  void direct(std::size_t i) {
    is_directed_[i] = true;
    waiting_.push_back(i);
  }
  void follow() {
    for (; !waiting_.empty();) {
      const std::size_t i = waiting_.back();
      waiting_.pop_back();
      lead(i, sides_[i]);
      lead(i, twin(sides_[i]));
    }
  }
  // To the other edge at the beginning of a halfedge of this one: it ends there, or begins where this one ends.
  void lead(std::size_t i, Halfedge from) {
    const std::vector<std::size_t>& here = at_.at(start(from));
    if (here.size() != 2) return;
    const std::size_t other = here[0] == i ? here[1] : here[0];
    if (is_directed_[other]) return;
    const bool is_to_end_here = from == sides_[i];
    const bool ends_here = start(twin(sides_[other])) == start(from);
    if (is_to_end_here != ends_here) sides_[other] = twin(sides_[other]);
    direct(other);
  }

  const Mesh& m_;
  std::vector<Halfedge> sides_;
  std::unordered_map<Vertex, std::vector<std::size_t>> at_;  // by point
  std::vector<bool> is_directed_;
  std::vector<std::size_t> waiting_;
};

// One side for each edge between two points, in the order in which they are named first: that of a face, the one on the
// left of the halfedge before others, or a halfedge of a wire. One that may run either way, a wire or an edge with a
// face on both sides, runs on from the other one where two alone meet. O(edges * log(edges)) and the sheets of the
// edges.
std::vector<Halfedge> sides_of(const Mesh& m, std::span<const Halfedge> edges) { return NamedSides(m, edges).take(); }

glm::dvec3 normal_of(const Mesh& m, Face f) {
  FacePolygon polygon;
  polygon.read(m, f);
  return polygon.is_finite() ? polygon_normal(polygon.keyhole_walk()) : glm::dvec3(0);
}

// The sum of the ways out of faces across their sides, each in the plane of its face and as long as the side.
glm::dvec3 way_out(const Mesh& m, std::span<const Halfedge> sides) {
  std::unordered_map<Face, glm::dvec3> normals;
  glm::dvec3 sum(0);
  for (Halfedge side : sides) {
    if (m.is_outside(side)) continue;
    const auto [normal, is_new] = normals.try_emplace(m.face(side));
    if (is_new) normal->second = normal_of(m, m.face(side));
    sum += glm::cross(m.position(m.to(side)) - m.position(m.from(side)), normal->second);
  }
  return sum;
}

// The vector area of the loop that edges make when they run like this; of an open chain, with its ends joined.
glm::dvec3 area_of_loop(const Mesh& m, std::span<const Halfedge> sides) {
  std::set<Vertex> ends;
  for (Halfedge h : sides) ends.insert(point(m, m.to(h)));
  const auto first =
      std::find_if(sides.begin(), sides.end(), [&](Halfedge h) { return !ends.contains(point(m, m.from(h))); });
  const glm::dvec3 about = m.position(m.from(first == sides.end() ? sides[0] : *first));
  glm::dvec3 sum(0);
  for (Halfedge h : sides) sum += glm::cross(m.position(m.from(h)) - about, m.position(m.to(h)) - about);
  return 0.5 * sum;
}

glm::dvec3 unit_or_zero(const glm::dvec3& vector, double least) {
  const double length = glm::length(vector);
  return length > least ? vector / length : glm::dvec3(0);
}

bool has_face(const Mesh& m, Vertex p) {
  return any_of_faces_at(m, p, [](Face) { return true; });
}

// Quads are put on the free sides of edges and of each other where there are any, else beside them on vertices of their
// own: which of these belong together is found when all are there.
class ExtrudedEdges {
 public:
  ExtrudedEdges(Edit& edit, std::span<const Halfedge> sides, const glm::dvec3& by)
      : edit_(edit), m_(edit.mesh()), by_(by), sheets_(edit) {
    for (Halfedge side : sides) named_.push_back({side, end_at(m_.from(side)), end_at(m_.to(side))});
  }

  OpEffect run() {
    for (const Named& named : named_) make_quad(named);
    std::vector<Vertex> points;
    for (auto& each : beside_) {
      std::vector<Vertex>& copies = each.second;
      for_each_copy(m_, each.first, [&](Vertex copy) { copies.push_back(copy); });
      link_copies(edit_, copies);
    }
    for (const auto& [p, top] : tops_) points.insert(points.end(), {p, top});
    std::sort(points.begin(), points.end());
    sheets_.make_manifold(points);
    return sheets_.finish();
  }

 private:
  struct End {
    Vertex point, top;
  };
  struct Named {
    Halfedge side;
    End from, to;
  };

  End end_at(Vertex v) {
    const Vertex p = point(m_, v);
    const auto [at, is_new] = tops_.try_emplace(p);
    if (is_new) {
      const glm::dvec3 moved = m_.position(v) + by_;
      at->second = edit_.add_vertex(is_finite(moved) ? moved : m_.position(v));
      edit_.derive(at->second, v, Derivation::copies);
    }
    return {p, at->second};
  }

  void make_quad(const Named& named) {
    const Face face = m_.face(named.side);
    const auto& [side, a, b] = named;
    std::array<Vertex, 4> corners{b.point, a.point, a.top, b.top};
    if (!face) corners = {a.point, b.point, b.top, a.top};
    const bool is_free = !is_shared(side) && !has_quad(corners[1], corners[2]) && !has_quad(corners[3], corners[0]);
    if (is_free) rises_.insert({{corners[1], corners[2]}, {corners[3], corners[0]}});
    const Face quad = is_free ? attach_face(edit_, sheets_, corners) : put_beside(side, corners);
    if (face) edit_.derive(quad, face, Derivation::copies);
    if (!face) return;
    // Corner values of the face at both ends of its side go up with them. Normals do not, they belong to the old
    // surface.
    std::size_t corner = 0;
    for (Halfedge h : halfedges_around(m_, quad)) {
      const bool is_at_b = corner == 0 || corner == 3;
      edit_.derive(h, is_at_b ? m_.next(side) : side, Derivation::copies);
      drop_normal(edit_, h);
      ++corner;
    }
  }
  // Whether several faces have an edge on points.
  bool is_shared(Halfedge side) const { return point_edge(m_, side).faces() > 1; }
  // Whether one of those on free sides runs up or down there.
  bool has_quad(Vertex from, Vertex to) const { return rises_.contains({from, to}); }

  Face put_beside(Halfedge side, std::array<Vertex, 4> corners) {
    const std::array<Vertex, 2> of_wire{m_.from(side), m_.to(side)};
    const bool is_wire = m_.is_wire(edge(side));
    if (is_wire) sheets_.remove_edge(side);
    for (std::size_t i = 0; i < 4; ++i)
      corners[i] = is_wire && i < 2 && m_.is_isolated(of_wire[i]) ? of_wire[i] : vertex_without_edges(corners[i]);
    std::array<Halfedge, 4> sides;
    for (std::size_t i = 0; i < 4; ++i) {
      sides[i] = edit_.add_edge(corners[i], corners[(i + 1) % 4]);
      edit_.fresh(edge(sides[i]));
    }
    const Face quad = edit_.add_face(sides[0]);
    edit_.derive(edge(sides[0]), edge(side), Derivation::copies);
    edit_.fresh(quad);
    for (std::size_t i = 0; i < 4; ++i) {
      const Halfedge h = sides[i], after = sides[(i + 1) % 4];
      edit_.connect(h, after);
      edit_.connect(twin(after), twin(h));
      edit_.set_face(h, quad);
      edit_.fresh(h);
      edit_.set_halfedge(corners[(i + 1) % 4], twin(h));
    }
    sheets_.changed(quad);
    return quad;
  }
  // To be a copy of the point, where it is another.
  Vertex vertex_without_edges(Vertex p) {
    if (m_.is_isolated(p)) return p;
    const Vertex copy = edit_.add_vertex(m_.position(p));
    edit_.derive(copy, p, Derivation::copies);
    beside_[p].push_back(copy);
    return copy;
  }

  Edit& edit_;
  const Mesh& m_;
  const glm::dvec3 by_;
  Sheets sheets_;
  std::unordered_map<Vertex, Vertex> tops_;  // by point
  std::vector<Named> named_;
  std::set<std::pair<Vertex, Vertex>> rises_;
  std::map<Vertex, std::vector<Vertex>> beside_;  // by point, to be its copies
};

}  // namespace

glm::dvec3 ExtrudeEdges::movement(const Mesh& mesh) const {
  if (offset) return *offset;
  if (distance == 0.0) return glm::dvec3(0);
  const std::vector<Halfedge> sides = sides_of(mesh, edges);
  // Places in files have few digits, so that ways that cancel out leave more than the rounding of doubles.
  constexpr double of_files = 1e-5, rounding = 1e-12;
  const glm::dvec3 out = way_out(mesh, sides);
  double length = 0;
  for (Halfedge side : sides) length += glm::distance(mesh.position(mesh.from(side)), mesh.position(mesh.to(side)));
  if (!is_finite(out) || !(length > 0) || !is_finite(glm::dvec3(length))) return glm::dvec3(0);
  glm::dvec3 direction = unit_or_zero(out, of_files * length);
  if (direction == glm::dvec3(0)) direction = unit_or_zero(area_of_loop(mesh, sides), rounding * length * length);
  const glm::dvec3 by = distance.value_or(length / static_cast<double>(sides.size())) * direction;
  return is_finite(by) ? by : glm::dvec3(0);
}

Verdict ExtrudeEdges::check(const Mesh& mesh) const {
  Verdict verdict;
  if (any_is_gone(mesh, edges, verdict)) return verdict;
  for (Halfedge side : sides_of(mesh, edges))
    for (Halfedge sheet : sheets_between(mesh, mesh.from(side), mesh.to(side)))
      if (is_bridge(mesh, sheet)) verdict.refuse(Rule::same_face, {edge(sheet), mesh.face(sheet)});
  return verdict;
}

std::vector<Reason> ExtrudeEdges::warnings(const Mesh& mesh) const {
  const glm::dvec3 by = movement(mesh);
  std::vector<Element> flat;
  std::map<Vertex, bool> is_beside_face;  // by point
  for (Halfedge side : sides_of(mesh, edges)) {
    const glm::dvec3 &a = mesh.position(mesh.from(side)), &b = mesh.position(mesh.to(side));
    if (FaceGeometry{{a, b, b + by, a + by}}.is_degenerate()) flat.push_back(edge(side));
    for (Vertex v : {mesh.from(side), mesh.to(side)}) is_beside_face[point(mesh, v)] |= !mesh.is_outside(side);
  }
  // Quads at wires alone are a fan of their own.
  std::vector<Vertex> pinched;
  for (const auto& [p, is_beside] : is_beside_face)
    if (!is_beside && has_face(mesh, p)) pinched.push_back(p);
  std::vector<Reason> reasons;
  if (!flat.empty()) reasons.push_back({Rule::degenerate, flat});
  warn_of_pinch(pinched, reasons);
  return reasons;
}

OpEffect ExtrudeEdges::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  return ExtrudedEdges(edit, sides_of(edit.mesh(), edges), movement(edit.mesh())).run();
}

}  // namespace ryosen
