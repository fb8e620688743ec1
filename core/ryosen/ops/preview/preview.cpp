#include "ryosen/ops/preview/preview.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/locate.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/rules/crossings.h"
#include "ryosen/ops/rules/face_geometry.h"

namespace ryosen {

namespace {

constexpr std::uint32_t most_vertices_searched = 10000;
constexpr std::size_t most_sides_compared = 400;

// A side of a face in the view along an axis.
struct FlatSide {
  glm::dvec2 from, to;
  std::uint32_t corner;
};

bool lies_within(const glm::dvec2& p, const FlatSide& side) {
  const glm::dvec2 low = glm::min(side.from, side.to), high = glm::max(side.from, side.to);
  return p != side.from && p != side.to && low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y &&
         orient2d(side.from, side.to, p) == 0;
}

// Whether two sides that share no end cross, or one comes upon the other with an end.
bool cross(const FlatSide& a, const FlatSide& b) {
  if (a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to) return false;
  const glm::dvec2 low_a = glm::min(a.from, a.to), high_a = glm::max(a.from, a.to);
  const glm::dvec2 low_b = glm::min(b.from, b.to), high_b = glm::max(b.from, b.to);
  if (high_a.x < low_b.x || high_b.x < low_a.x || high_a.y < low_b.y || high_b.y < low_a.y) return false;
  if (orient2d(a.from, a.to, b.from) * orient2d(a.from, a.to, b.to) < 0 &&
      orient2d(b.from, b.to, a.from) * orient2d(b.from, b.to, a.to) < 0)
    return true;
  return lies_within(a.from, b) || lies_within(a.to, b) || lies_within(b.from, a) || lies_within(b.to, a);
}

// The corners at which two sides that cross begin.
std::optional<std::array<std::uint32_t, 2>> find_crossing(const FacePolygon& polygon) {
  const std::vector<glm::dvec3>& places = polygon.places();
  if (places.size() < 4 || places.size() > most_sides_compared || !polygon.is_finite()) return std::nullopt;
  const int axis = view_axis(polygon_normal(polygon.keyhole_walk()));
  const auto flat = [&](std::uint32_t corner) { return seen_along(places[corner], axis); };
  std::vector<FlatSide> sides;
  for (std::uint32_t i = 0; i < places.size(); ++i) sides.push_back({flat(i), flat(polygon.next(i)), i});
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (cross(sides[k], sides[i])) return std::array{sides[k].corner, sides[i].corner};
  return std::nullopt;
}

// Whether two faces have the same corners: one that only runs the other way round is turned over on purpose.
bool have_same_corners(const FacePolygon& a, const FacePolygon& b) {
  const auto in_order = [](std::vector<glm::dvec3> places) {
    std::sort(places.begin(), places.end(), [](const glm::dvec3& p, const glm::dvec3& q) {
      return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
    });
    return places;
  };
  return a.places().size() == b.places().size() && in_order(a.places()) == in_order(b.places());
}

bool is_known(const std::vector<Reason>& known, Rule rule) {
  return std::any_of(known.begin(), known.end(), [&](const Reason& reason) { return reason.rule == rule; });
}

}  // namespace

VertexPairs points_at_one_place(const Mesh& mesh, const std::vector<Face>& faces, const std::vector<Vertex>& vertices) {
  VertexPairs pairs;
  const auto add = [&](Vertex v, Vertex w) {
    if (mesh.position(v) != mesh.position(w) || same_point(mesh, v, w)) return;
    pairs.push_back(std::minmax(point(mesh, v), point(mesh, w)));
  };
  std::vector<Vertex> corners;
  for (const Face f : faces) {
    if (!mesh.exists(f) || !mesh.is_alive(f)) continue;
    corners.clear();
    for (Vertex v : vertices_around(mesh, f)) corners.push_back(v);
    std::sort(corners.begin(), corners.end(), [&](Vertex v, Vertex w) {
      const glm::dvec3 &p = mesh.position(v), &q = mesh.position(w);
      return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
    });
    for (std::size_t i = 1; i < corners.size(); ++i) add(corners[i - 1], corners[i]);
  }
  for (const Vertex v : vertices) {
    if (!mesh.exists(v) || !mesh.is_alive(v)) continue;
    for (Vertex w : neighbours(mesh, v)) add(v, w);
    if (mesh.is_isolated(v) && mesh.vertex_slots() <= most_vertices_searched)
      for (const Vertex w : live_vertices(mesh)) add(v, w);
  }
  sort_unique(pairs);
  return pairs;
}

std::vector<Reason> shape_warnings(const Mesh& before, const std::vector<GhostFace>& after,
                                   const std::vector<Reason>& known) {
  ShapeDoubts shapes;
  std::vector<Element> crossed;
  const bool says_turned = is_known(known, Rule::normal_turns), says_degenerate = is_known(known, Rule::degenerate);
  // A point outside of its edge lies on other sides as a matter of course.
  const bool says_outside = is_known(known, Rule::outside_edge);
  bool crossed_before = false;
  const auto was_crossed = [&](Face f) { return find_crossing(FacePolygon(before, f)).has_value(); };
  const auto name = [&](Vertex v, std::vector<Element>& witnesses) {
    if (before.exists(v) && before.is_alive(v)) witnesses.emplace_back(v);
  };
  for (const GhostFace& ghost : after) {
    const Face f = ghost.face;
    const bool is_old = before.exists(f) && before.is_alive(f);
    if (!ghost.polygon.is_finite()) continue;
    const FaceGeometry shape(ghost.polygon.keyhole_walk());
    if (is_old && (!says_turned || !says_degenerate)) {
      const FacePolygon old(before, f);
      const FaceGeometry shape_before(old.is_finite() ? old.keyhole_walk() : std::vector<glm::dvec3>());
      if (shape.is_degenerate()) {
        if (!says_degenerate && !shape_before.is_degenerate()) shapes.degenerate.emplace_back(f);
      } else if (!says_turned && shape_before.turns_against(shape) && !have_same_corners(old, ghost.polygon)) {
        shapes.turned.emplace_back(f);
      }
    }
    if (says_outside || shape.is_degenerate()) continue;
    const auto crossing = find_crossing(ghost.polygon);
    if (!crossing) continue;
    if (is_old && was_crossed(f)) {
      crossed_before = true;
    } else if (is_old) {
      crossed.emplace_back(f);
    } else {
      // A face that would be new has no name yet: the ends of the two sides.
      for (const std::uint32_t corner : *crossing)
        for (const std::uint32_t end : {corner, ghost.polygon.next(corner)}) name(ghost.vertices[end], crossed);
    }
  }
  std::vector<Reason> found;
  shapes.add_to(found);
  sort_unique(crossed);
  if (!crossed.empty() && !crossed_before) found.push_back({Rule::leaves_face, crossed});
  return found;
}

namespace {

// What is looked at while the operator is done, and compared with what was there before.
struct Seen {
  std::vector<Face> faces;
  std::vector<Vertex> vertices;
  std::vector<Crossing> crossings;
  VertexPairs at_one_place;
};

// The same operator at the lowest halfedge of the cycle, where it is about one.
AnyOp at_start_of_cycle(const Mesh& mesh, AnyOp op) {
  if (info_of(op).subject != Subject::cycle) return op;
  std::visit(
      [&](auto& o) {
        if constexpr (requires { Halfedge(o.halfedge); })
          for (Halfedge h : loop(mesh, o.halfedge)) o.halfedge = std::min(o.halfedge, h);
      },
      op);
  return op;
}

void run_and_roll_back(Mesh& mesh, Journal& journal, const AnyOp& op, std::size_t face_limit, Preview& result,
                       Seen& seen) {
  Edit edit(mesh, &journal);
  OpEffect effect = apply(edit, op);
  result.created = std::move(effect.created);
  result.deleted = std::move(effect.deleted);
  result.outline_only = effect.changed.size() > face_limit;
  if (result.outline_only) return;
  result.faces.reserve(effect.changed.size());
  for (Face f : effect.changed) {
    result.faces.push_back({f, FacePolygon(mesh, f)});
    GhostFace& ghost = result.faces.back();
    for (Halfedge h : ghost.polygon.corners()) ghost.vertices.push_back(mesh.from(h));
  }
  seen.faces = std::move(effect.changed);
  for (const Element& element : result.created)
    if (element.kind == Element::Kind::vertex) seen.vertices.push_back(element.vertex());
  if (const auto* move = std::get_if<MoveVertex>(&op)) seen.vertices.push_back(move->vertex);
  seen.crossings = crossings_near(mesh, seen.faces);
  seen.at_one_place = points_at_one_place(mesh, seen.faces, seen.vertices);
}

// Warns of the pairs that were not so before, by those of the two that have a name already.
template <class Pair, class WasSo>
void warn_of_news(const Mesh& mesh, Rule rule, const std::vector<Pair>& pairs, const WasSo& was_so, Preview& result) {
  std::vector<Element> witnesses;
  for (const Pair& pair : pairs) {
    if (was_so(pair)) continue;
    for (const auto element : {pair.first, pair.second})
      if (mesh.exists(element) && mesh.is_alive(element) &&
          std::find(witnesses.begin(), witnesses.end(), Element(element)) == witnesses.end())
        witnesses.push_back(element);
  }
  if (!witnesses.empty()) result.warnings.push_back({rule, witnesses});
}

}  // namespace

Preview preview(Mesh& mesh, Journal& journal, const AnyOp& asked, std::size_t face_limit) {
  Preview result;
  result.verdict = check(mesh, asked);
  if (!result.verdict.legal()) return result;
  const AnyOp op = at_start_of_cycle(mesh, asked);
  result.warnings = warnings(mesh, op);
  Seen seen;
  run_and_roll_back(mesh, journal, op, face_limit, result, seen);
  if (result.outline_only) return result;
  for (Reason& reason : shape_warnings(mesh, result.faces, result.warnings))
    result.warnings.push_back(std::move(reason));
  const auto is_known = [&](Vertex v) { return mesh.exists(v) && mesh.is_alive(v); };
  const auto were_at_one_place = [&](const std::pair<Vertex, Vertex>& pair) {
    return is_known(pair.first) && is_known(pair.second) && mesh.position(pair.first) == mesh.position(pair.second);
  };
  warn_of_news(mesh, Rule::same_place, seen.at_one_place, were_at_one_place, result);
  if (seen.crossings.empty()) return result;
  const std::vector<Crossing> before = crossings_near(mesh, seen.faces);
  const auto crossed = [&](const Crossing& pair) { return std::binary_search(before.begin(), before.end(), pair); };
  warn_of_news(mesh, Rule::intersects, seen.crossings, crossed, result);
  return result;
}

}  // namespace ryosen
