#include "tests/support/core/oracle/pairing_oracle.h"

#include <cmath>
#include <map>
#include <tuple>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen::test {

namespace {

struct EdgeSide {
  std::size_t face, corner;  // where it begins
  bool is_forward;           // from the lower to the higher point
  LatticePoint apex;
};

struct EdgeOfAll {
  LatticePoint low, high;
  std::vector<EdgeSide> sides;
};

std::vector<EdgeOfAll> edges_of(const TriangleList& list) {
  std::map<std::pair<std::size_t, std::size_t>, EdgeOfAll> edges;
  for (std::size_t f = 0; f < list.faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = list.faces[f][i], b = list.faces[f][(i + 1) % 3];
      EdgeOfAll& edge = edges[std::minmax(a, b)];
      edge.low = list.places[std::min(a, b)];
      edge.high = list.places[std::max(a, b)];
      edge.sides.push_back({f, i, a < b, list.places[list.faces[f][(i + 2) % 3]]});
    }
  std::vector<EdgeOfAll> found;
  for (auto& [ends, edge] : edges) found.push_back(std::move(edge));
  return found;
}

class Sets {
 public:
  explicit Sets(std::size_t n) : of_(n) {
    for (std::size_t i = 0; i < n; ++i) of_[i] = i;
  }
  std::size_t of(std::size_t i) const { return of_[i]; }
  void join(std::size_t a, std::size_t b) {
    const std::size_t from = std::max(of_[a], of_[b]), to = std::min(of_[a], of_[b]);
    for (std::size_t& i : of_)
      if (i == from) i = to;
  }

 private:
  std::vector<std::size_t> of_;
};

// The angle from one half-plane counter-clockwise around the edge to another, as something to compare: a whole turn
// where they are one. Of two in the same part of the turn the one comes first from which the other is
// counter-clockwise.
int part_of_turn(const EdgeOfAll& edge, const LatticePoint& from, const LatticePoint& to) {
  const LatticeVector u = difference(edge.high, edge.low), v = difference(from, edge.low), w = difference(to, edge.low);
  const std::int64_t turn = dot(u, cross(v, w));
  if (turn != 0) return turn > 0 ? 1 : 3;
  return dot(cross(u, v), cross(u, w)) > 0 ? 4 : 2;
}
bool comes_first(const EdgeOfAll& edge, const LatticePoint& from, const LatticePoint& a, const LatticePoint& b,
                 bool backwards) {
  const auto part = [&](const LatticePoint& p) {
    return backwards ? part_of_turn(edge, p, from) : part_of_turn(edge, from, p);
  };
  if (part(a) != part(b)) return part(a) < part(b);
  if (part(a) == 4 || part(a) == 2) return false;
  const LatticeVector u = difference(edge.high, edge.low);
  const std::int64_t turn = dot(u, cross(difference(a, edge.low), difference(b, edge.low)));
  return backwards ? turn < 0 : turn > 0;
}

// The first side of the other direction through the inside of a side. The inside lies clockwise of a forward side.
const EdgeSide* first_through_inside(const EdgeOfAll& edge, const std::vector<const EdgeSide*>& sides,
                                     const EdgeSide& of) {
  const EdgeSide* best = nullptr;
  for (const EdgeSide* side : sides) {
    if (side->is_forward == of.is_forward) continue;
    const bool is_nearer = best && comes_first(edge, of.apex, side->apex, best->apex, of.is_forward);
    const bool is_farther = best && comes_first(edge, of.apex, best->apex, side->apex, of.is_forward);
    if (!best || is_nearer || (!is_farther && side->face < best->face)) best = side;
  }
  return best;
}

void pair_around(const EdgeOfAll& edge, const std::vector<bool>& is_free, Sets& parts, std::vector<bool>& is_open) {
  std::vector<const EdgeSide*> left;
  for (const EdgeSide& side : edge.sides) (is_free[side.face] ? void() : left.push_back(&side));
  for (bool is_done = false; !is_done;) {
    is_done = true;
    for (std::size_t i = 0; i < left.size() && is_done; ++i) {
      const EdgeSide* const other = first_through_inside(edge, left, *left[i]);
      if (!other || first_through_inside(edge, left, *other) != left[i]) continue;
      const EdgeSide* const one = left[i];
      parts.join(one->face, other->face);
      std::erase_if(left, [&](const EdgeSide* s) { return s == one || s == other; });
      is_done = false;
    }
  }
  for (const EdgeSide& side : edge.sides)
    if (is_free[side.face]) is_open[side.face] = true;
  for (const EdgeSide* side : left) is_open[side->face] = true;
}

double area_of(const TriangleList& list, const std::array<std::size_t, 3>& face) {
  const LatticePoint &a = list.places[face[0]], &b = list.places[face[1]], &c = list.places[face[2]];
  const LatticeVector n = cross(difference(b, a), difference(c, a));
  return std::sqrt(static_cast<double>(dot(n, n))) / 2;
}

}  // namespace

TriangleList triangles_of(const Mesh& mesh) {
  TriangleList list;
  std::map<Vertex, std::size_t> number;  // by point
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    if (!mesh.is_alive(Vertex(i)) || point(mesh, Vertex(i)) != Vertex(i)) continue;
    number[Vertex(i)] = list.places.size();
    const glm::dvec3 p = mesh.position(Vertex(i));
    list.places.push_back({static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z)});
  }
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_alive(Face(f))) continue;
    std::array<std::size_t, 3> face{};
    std::size_t corner = 0;
    for (const Vertex v : vertices_around(mesh, Face(f))) face.at(corner++) = number.at(point(mesh, v));
    list.faces.push_back(face);
  }
  return list;
}

PairedList pair_by_asking_all(const TriangleList& list) {
  const std::vector<std::array<std::size_t, 3>>& faces = list.faces;
  PairedList out;
  out.is_free.resize(faces.size(), false);
  const std::vector<EdgeOfAll> edges = edges_of(list);
  Sets patches(faces.size());
  for (const EdgeOfAll& e : edges)
    if (e.sides.size() == 2 && e.sides[0].is_forward != e.sides[1].is_forward)
      patches.join(e.sides[0].face, e.sides[1].face);
  std::vector<double> area(faces.size(), 0);
  for (std::size_t f = 0; f < faces.size(); ++f) area[patches.of(f)] += area_of(list, faces[f]);
  std::vector<bool> has_boundary(faces.size(), false);
  for (const EdgeOfAll& e : edges)
    if (e.sides.size() == 1) has_boundary[patches.of(e.sides[0].face)] = true;
  for (;;) {
    std::vector<std::tuple<bool, double, std::size_t>> may_go;
    for (const EdgeOfAll& e : edges) {
      if (e.sides.size() < 3) continue;
      int surplus = 0;
      for (const EdgeSide& s : e.sides) surplus += out.is_free[s.face] ? 0 : s.is_forward ? 1 : -1;
      for (const EdgeSide& s : e.sides)
        if (!out.is_free[s.face] && surplus != 0 && s.is_forward == (surplus > 0))
          may_go.emplace_back(!has_boundary[patches.of(s.face)], area[patches.of(s.face)], patches.of(s.face));
    }
    if (may_go.empty()) break;
    const std::size_t goes = std::get<2>(*std::min_element(may_go.begin(), may_go.end()));
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (patches.of(f) == goes) out.is_free[f] = true;
  }
  Sets parts(faces.size());
  std::vector<bool> is_open(faces.size(), false);
  out.open_sides.resize(faces.size(), 0);
  for (const EdgeOfAll& e : edges) {
    if (e.sides.size() >= 3) {
      pair_around(e, out.is_free, parts, is_open);
      for (const EdgeSide& s : e.sides) out.open_sides[s.face] += out.is_free[s.face];
    } else if (e.sides.size() == 2 && e.sides[0].is_forward != e.sides[1].is_forward) {
      parts.join(e.sides[0].face, e.sides[1].face);
    } else {
      if (e.sides.size() == 1) ++out.open_sides[e.sides[0].face];
      for (const EdgeSide& s : e.sides) {
        is_open[s.face] = true;
        if (e.sides.size() == 2) out.sides_alike.emplace_back(s.face, s.corner);
      }
    }
  }
  std::vector<bool> part_is_open(faces.size(), false);
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (is_open[f]) part_is_open[parts.of(f)] = true;
  out.is_closed.resize(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) out.is_closed[f] = !part_is_open[parts.of(f)];
  return out;
}

}  // namespace ryosen::test
