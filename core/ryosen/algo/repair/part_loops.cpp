#include "ryosen/algo/repair/part_loops.h"

#include <algorithm>
#include <array>
#include <map>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

namespace {

struct Part {
  Halfedge last, first;  // sides of a part: its twofold place is between them
};

// The parts that are cut off one after another; what is left at the end is a part too. None where the loop stays whole.
std::vector<Part> parts_of(const Mesh& m, const std::vector<Halfedge>& sides) {
  constexpr std::size_t fewest_sides = 3;
  std::vector<Part> parts;
  std::vector<Halfedge> open;
  std::map<std::array<double, 3>, std::size_t> index_in_open;  // by place
  const auto place_of = [&](Halfedge h) {
    const glm::dvec3 place = m.position(m.from(h)) + 0.0;  // one zero
    return std::array{place.x, place.y, place.z};
  };
  const auto are_one = [&](Vertex v, Vertex w) {
    return point(m, v) == point(m, w) || (!has_copies(m, v) && !has_copies(m, w));
  };
  for (const Halfedge h : sides) {
    if (const auto at = index_in_open.find(place_of(h)); at != index_in_open.end()) {
      const std::size_t first = at->second;
      if (open.size() - first < fewest_sides || !are_one(m.from(open[first]), m.from(h))) return {};
      parts.push_back({open.back(), open[first]});
      for (std::size_t i = first; i < open.size(); ++i) index_in_open.erase(place_of(open[i]));
      open.resize(first);
    }
    index_in_open[place_of(h)] = open.size();
    open.push_back(h);
  }
  return open.size() < fewest_sides ? std::vector<Part>() : parts;
}

// Whether one vertex may take the place of two points without copies: no face has both, and no edge becomes another.
bool may_become_one(const Mesh& m, Vertex v, Vertex w) {
  std::vector<Face> faces;
  std::vector<Vertex> neighbours{v, w};
  for (const Halfedge h : outgoing(m, v)) {
    faces.push_back(m.face(h));
    neighbours.push_back(point(m, m.to(h)));
  }
  const auto has = [](const auto& list, auto element) {
    return std::find(list.begin(), list.end(), element) != list.end();
  };
  for (const Halfedge h : outgoing(m, w))
    if ((m.face(h) && has(faces, m.face(h))) || has(neighbours, point(m, m.to(h)))) return false;
  return true;
}

bool is_plain(const Mesh& m, Halfedge h) { return is_finite(m.position(m.from(h))) && point_edge(m, h).faces() == 1; }

}  // namespace

std::vector<Vertex> part_loops(Edit& edit) {
  const Mesh& m = edit.mesh();
  std::vector<bool> seen(m.halfedge_slots(), false);
  std::vector<Part> parts;
  for (std::uint32_t i = 0; i < m.halfedge_slots(); ++i) {
    const Halfedge start(i);
    if (seen[i] || !m.is_alive(start) || !m.is_outside(start)) continue;
    std::vector<Halfedge> sides;
    for (const Halfedge h : loop(m, start)) {
      seen[h.index] = true;
      sides.push_back(h);
    }
    if (!std::all_of(sides.begin(), sides.end(), [&](Halfedge h) { return is_plain(m, h); })) continue;
    const std::vector<Part> found = parts_of(m, sides);
    parts.insert(parts.end(), found.begin(), found.end());
  }
  Sheets sheets(edit);
  std::vector<Vertex> joined;
  for (const auto& [last, first] : parts) {
    const Vertex v = m.to(last), w = m.from(first);
    if (point(m, v) != point(m, w)) {
      if (has_copies(m, v) || has_copies(m, w) || !may_become_one(m, v, w)) continue;
      sheets.join_points(v, w);
      joined.push_back(std::min(v, w));
    }
    sheets.join_corner(last, first);
  }
  return joined;
}

void join_loops(Edit& edit, const std::vector<Vertex>& joined) {
  const Mesh& m = edit.mesh();
  Sheets sheets(edit);
  for (std::uint32_t i = 0; i < m.vertex_slots(); ++i)
    if (m.is_alive(Vertex(i)) && count_fans(m, Vertex(i)) > 1) sheets.separate(Vertex(i));
  for (const Vertex v : joined) {
    if (!m.is_alive(v) || !has_copies(m, v)) continue;
    for (const Vertex copy : live_copies(m, {&v, 1})) link_copies(edit, {&copy, 1});
  }
}

}  // namespace ryosen
