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

using Place = std::array<double, 3>;

// Where the least rotation of a cycle begins: the same place wherever the list begins. O(n).
std::size_t least_rotation(const std::vector<Place>& cycle) {
  const std::size_t n = cycle.size();
  std::size_t i = 0, j = 1, same = 0;
  while (i < n && j < n && same < n) {
    const Place &a = cycle[(i + same) % n], &b = cycle[(j + same) % n];
    if (a == b) {
      ++same;
      continue;
    }
    (b < a ? i : j) += same + 1;
    if (i == j) ++j;
    same = 0;
  }
  return std::min(i, j);
}

// The parts that are cut off one after another; what is left at the end is a part too. None where the loop stays whole.
std::vector<Part> parts_of(const Mesh& m, std::vector<Halfedge> sides) {
  constexpr std::size_t fewest_sides = 3;
  std::vector<Place> places;
  for (const Halfedge h : sides) {
    const glm::dvec3 place = m.position(m.from(h)) + 0.0;  // one zero
    places.push_back({place.x, place.y, place.z});
  }
  // The parts may depend on where the walk begins, and numbers of sides on how a file is written.
  const auto begin = static_cast<std::ptrdiff_t>(least_rotation(places));
  std::rotate(sides.begin(), sides.begin() + begin, sides.end());
  std::rotate(places.begin(), places.begin() + begin, places.end());
  const auto are_one = [&](Vertex v, Vertex w) {
    return point(m, v) == point(m, w) || (!has_copies(m, v) && !has_copies(m, w));
  };
  std::vector<Part> parts;
  std::vector<std::size_t> open;
  std::map<Place, std::size_t> index_in_open;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (const auto at = index_in_open.find(places[i]); at != index_in_open.end()) {
      const std::size_t first = at->second;
      if (open.size() - first < fewest_sides || !are_one(m.from(sides[open[first]]), m.from(sides[i]))) return {};
      parts.push_back({sides[open.back()], sides[open[first]]});
      for (std::size_t k = first; k < open.size(); ++k) index_in_open.erase(places[open[k]]);
      open.resize(first);
    }
    index_in_open[places[i]] = open.size();
    open.push_back(i);
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
