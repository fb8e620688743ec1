#include "tests/support/core/oracle/figures.h"

#include <algorithm>

namespace ryosen::oracle {
namespace {

// The boundary pair that follows `pair` around the fan of faces at `vertex`, or -1 where the fan ends at a pair with
// three or more faces.
int next_boundary_pair(const PolygonList& list, const Sides& sides, int pair, int vertex) {
  Side side = sides.begin(pair)[0];
  for (;;) {
    const int corner = sides.corner_at(side, vertex);
    const int degree = static_cast<int>(list.faces[side.face].size());
    const int other = corner == side.corner ? (corner + degree - 1) % degree : corner;
    const int found = sides.pair_of(side.face, other);
    if (sides.count(found) == 1) return found;
    if (sides.count(found) > 2) return -1;
    const Side* two = sides.begin(found);
    side = two[0].face == side.face && two[0].corner == other ? two[1] : two[0];
  }
}

bool can_be_oriented(const PolygonList& list, const Sides& sides) {
  // Each face twice: as it is (f) and turned (f + n). Orientable: no face joined with its own turned self.
  const int n = static_cast<int>(list.faces.size());
  Groups groups(2 * n);
  for (int pair = 0; pair < sides.pairs(); ++pair) {
    if (sides.count(pair) != 2) continue;
    const int f = sides.begin(pair)[0].face, g = sides.begin(pair)[1].face;
    const int turn = is_misoriented(sides, pair) ? n : 0;
    groups.join(f, g + turn);
    groups.join(f + n, g + n - turn);
  }
  for (int f = 0; f < n; ++f)
    if (groups.root(f) == groups.root(f + n)) return false;
  return true;
}

int hanging_pairs(const PolygonList& list, const Sides& sides) {
  int count = 0;
  for (auto [f, g] : equal_faces(list)) {
    if (list.faces[f].size() != 3 || list.faces[g].size() != 3) continue;
    if (rotated(list.faces[f]) == rotated(list.faces[g])) continue;
    int without_third = 0;
    for (int i = 0; i < 3; ++i) without_third += sides.count(sides.pair_of(f, i)) == 2;
    count += without_third >= 2;
  }
  return count;
}

void count_edges(const Sides& sides, Figures& figures, std::vector<char>& nonmanifold_end) {
  figures.edges = sides.pairs();
  for (int pair = 0; pair < sides.pairs(); ++pair) {
    const int faces = sides.count(pair);
    figures.max_edge_faces = std::max(figures.max_edge_faces, faces);
    figures.boundary_edges += faces == 1;
    figures.misoriented_edges += is_misoriented(sides, pair);
    if (faces < 3) continue;
    ++figures.nonmanifold_edges;
    nonmanifold_end[sides.begin(pair)->lo] = nonmanifold_end[sides.begin(pair)->hi] = 1;
  }
}

}  // namespace

int boundary_loops(const PolygonList& list, const Sides& sides) {
  Groups chains(sides.pairs());
  std::vector<char> open(static_cast<std::size_t>(sides.pairs()), 0);
  for (int pair = 0; pair < sides.pairs(); ++pair) {
    if (sides.count(pair) != 1) continue;
    for (int end : {sides.begin(pair)->lo, sides.begin(pair)->hi}) {
      const int next = next_boundary_pair(list, sides, pair, end);
      if (next < 0)
        open[pair] = 1;
      else
        chains.join(pair, next);
    }
  }
  int loops = 0;
  for (int pair = 0; pair < sides.pairs(); ++pair)
    if (open[pair]) open[chains.root(pair)] = 1;
  for (int pair = 0; pair < sides.pairs(); ++pair)
    loops += sides.count(pair) == 1 && chains.root(pair) == pair && !open[pair];
  return loops;
}

int components(const PolygonList& list, const Sides& sides) {
  Groups groups(static_cast<int>(list.faces.size()));
  for (int pair = 0; pair < sides.pairs(); ++pair)
    for (const Side* s = sides.begin(pair); s != sides.end(pair); ++s) groups.join(s->face, sides.begin(pair)->face);
  int count = 0;
  for (int f = 0; f < static_cast<int>(list.faces.size()); ++f) count += !list.faces[f].empty() && groups.root(f) == f;
  return count;
}

std::vector<int> fans_per_vertex(const PolygonList& list, const Sides& sides) {
  Groups groups(sides.corners());
  for (int pair = 0; pair < sides.pairs(); ++pair) {
    const Side& first = *sides.begin(pair);
    for (const Side* s = sides.begin(pair); s != sides.end(pair); ++s)
      for (int end : {first.lo, first.hi}) groups.join(sides.corner_id_at(*s, end), sides.corner_id_at(first, end));
  }
  std::vector<int> fans(list.live.size(), 0);
  int corner = 0;
  for (const Corners& face : list.faces)
    for (int v : face) {
      fans[v] += groups.root(corner) == corner;
      ++corner;
    }
  return fans;
}

std::vector<std::pair<int, int>> equal_faces(const PolygonList& list) {
  std::vector<Corners> sets = list.faces;
  for (Corners& set : sets) {
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
  }
  std::vector<std::pair<int, int>> equal;
  for (int f = 0; f < static_cast<int>(sets.size()); ++f)
    for (int g = f + 1; g < static_cast<int>(sets.size()); ++g)
      if (!sets[f].empty() && sets[f] == sets[g]) equal.emplace_back(f, g);
  return equal;
}

Figures figures_of(const PolygonList& list) {
  const Sides sides(list);
  Figures figures;
  std::vector<char> nonmanifold_end(list.live.size(), 0), used(list.live.size(), 0), doubled(list.faces.size(), 0);
  count_edges(sides, figures, nonmanifold_end);
  for (const Corners& face : list.faces) {
    figures.faces += !face.empty();
    for (int v : face) used[v] = 1;
  }
  const std::vector<int> fans = fans_per_vertex(list, sides);
  for (int v = 0; v < list.size(); ++v) {
    figures.vertices += list.live[v];
    figures.isolated_vertices += list.live[v] && !used[v];
    figures.bowtie_vertices += fans[v] > 1;
    figures.nonmanifold_vertices += fans[v] > 1 || nonmanifold_end[v];
  }
  for (auto [f, g] : equal_faces(list)) doubled[g] = 1;
  figures.duplicate_faces = static_cast<int>(std::count(doubled.begin(), doubled.end(), char{1}));
  figures.hanging_pairs = hanging_pairs(list, sides);
  figures.boundary_loops = boundary_loops(list, sides);
  figures.components = components(list, sides);
  figures.euler_characteristic = figures.vertices - figures.isolated_vertices - figures.edges + figures.faces;
  figures.manifold = figures.nonmanifold_edges == 0 && figures.bowtie_vertices == 0;
  figures.closed = figures.faces > 0 && figures.boundary_edges == 0 && figures.nonmanifold_edges == 0;
  figures.orientable = can_be_oriented(list, sides);
  if (figures.manifold && figures.orientable && figures.faces > 0)
    figures.genus = (2 * figures.components - figures.euler_characteristic - figures.boundary_loops) / 2;
  return figures;
}

}  // namespace ryosen::oracle
