#include "core/ops/orient.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/ops/turn_faces.h"

namespace ryosen {

namespace {

// The face beside f across one of its sides, and whether the two agree in direction; none unless the two are alone
// there.
struct Neighbour {
  Face face;
  bool agrees = true;
};

struct OrderedNeighbour {
  Face face;
  Vertex smaller, larger;  // the points of the shared edge
  bool agrees;
  friend auto operator<=>(const OrderedNeighbour&, const OrderedNeighbour&) = default;
};

Neighbour across(const Mesh& m, Halfedge side) {
  const Halfedge o = twin(side);
  if (!has_copies(m, m.from(side)) && !has_copies(m, m.to(side))) return {m.face(o), true};
  const PointEdge on_points = point_edge(m, side);
  if (on_points.faces() != 2) return {};
  if (!m.is_outside(o)) return {m.face(o), true};
  for (Halfedge sheet : sheets_between(m, m.from(side), m.to(side)))
    for (Halfedge h : {sheet, twin(sheet)})
      if (!m.is_outside(h) && h != side) return {m.face(h), !same_point(m, m.from(h), m.from(side))};
  return {};
}

// In an order that turning faces does not change, so that orienting twice is orienting once.
std::vector<OrderedNeighbour> neighbours_in_order(const Mesh& m, Face f) {
  std::vector<OrderedNeighbour> found;
  for (Halfedge side : halfedges_around(m, f)) {
    const Neighbour next = across(m, side);
    if (!next.face) continue;
    const auto [smaller, larger] = std::minmax({point(m, m.from(side)), point(m, m.to(side))});
    found.push_back({next.face, smaller, larger, next.agrees});
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Which faces turn. Flood fill over neighbours; each component keeps the orientation of its majority.
std::vector<bool> choose_turned(const Mesh& m) {
  std::vector<bool> seen(m.face_slots(), false), turned(m.face_slots(), false);
  std::vector<Face> component;
  for (std::uint32_t start = 0; start < m.face_slots(); ++start) {
    if (!m.is_alive(Face(start)) || seen[start]) continue;
    component.assign(1, Face(start));
    seen[start] = true;
    std::size_t turned_count = 0;
    for (std::size_t i = 0; i < component.size(); ++i) {
      const Face f = component[i];
      for (const OrderedNeighbour& next : neighbours_in_order(m, f)) {
        if (seen[next.face.index]) continue;
        seen[next.face.index] = true;
        turned[next.face.index] = turned[f.index] != !next.agrees;
        turned_count += turned[next.face.index];
        component.push_back(next.face);
      }
    }
    if (2 * turned_count <= component.size()) continue;
    for (Face f : component) turned[f.index] = !turned[f.index];
  }
  return turned;
}

std::vector<Face> faces_to_turn(const std::vector<bool>& turned) {
  std::vector<Face> faces;
  for (std::uint32_t f = 0; f < turned.size(); ++f)
    if (turned[f]) faces.push_back(Face(f));
  return faces;
}

}  // namespace

Parsed<Orient> Orient::parse(const Mesh&, std::span<const std::string_view> arguments) {
  if (!arguments.empty()) return malformed_argument<Orient>(arguments[0], "no argument");
  Parsed<Orient> out;
  out.op = Orient{};
  return out;
}

Verdict Orient::check(const Mesh& mesh) const {
  Verdict verdict;
  if (faces_to_turn(choose_turned(mesh)).empty()) verdict.refuse(Rule::oriented, {});
  return verdict;
}

OpEffect Orient::apply(Edit& edit) const {
  TurnedMesh turned = turn_faces(edit.mesh(), choose_turned(edit.mesh()));
  assert(!turned.effect.changed.empty());
  edit.replace(std::move(turned.columns));
  return turned.effect;
}

}  // namespace ryosen
