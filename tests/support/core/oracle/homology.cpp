#include "tests/support/core/oracle/homology.h"

#include <algorithm>
#include <cstdint>
#include <map>

#include "tests/support/core/oracle/figures.h"

namespace ryosen::oracle {
namespace {

using Row = std::vector<std::uint64_t>;

void flip(Row& row, int column) { row[static_cast<std::size_t>(column) / 64] ^= std::uint64_t{1} << (column % 64); }

int rank_of(std::vector<Row> rows) {
  int rank = 0;
  const std::size_t words = rows.empty() ? 0 : rows[0].size();
  for (std::size_t column = 0; column < 64 * words; ++column) {
    const auto has = [&](const Row& row) { return (row[column / 64] >> (column % 64) & 1u) != 0; };
    const auto pivot = std::find_if(rows.begin() + rank, rows.end(), has);
    if (pivot == rows.end()) continue;
    std::iter_swap(rows.begin() + rank, pivot);
    for (auto row = rows.begin() + rank + 1; row != rows.end(); ++row)
      if (has(*row))
        for (std::size_t w = 0; w < words; ++w) (*row)[w] ^= rows[static_cast<std::size_t>(rank)][w];
    ++rank;
  }
  return rank;
}

// The chains of a complex: an edge more from ring to ring makes a disc of every face.
struct Chains {
  std::vector<Pair> edges;  // of points
  std::vector<Row> of_edges, of_faces;
  int faces = 0;

  explicit Chains(const Complex& points) {
    std::map<Pair, int> number;
    const auto edge = [&](int a, int b) {
      const auto [found, is_new] = number.try_emplace(std::minmax(a, b), static_cast<int>(edges.size()));
      if (is_new) edges.push_back(found->first);
      return found->second;
    };
    std::vector<std::vector<int>> sides;
    for (const std::vector<Corners>& loops : points.faces) {
      if (loops.empty()) continue;
      sides.emplace_back();
      for (const Corners& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
          sides.back().push_back(edge(loop[i], loop[(i + 1) % loop.size()]));
    }
    for (const Pair& wire : points.wires) edge(wire.first, wire.second);
    // It is walked both ways, so it is in no face's boundary.
    for (const std::vector<Corners>& loops : points.faces)
      for (std::size_t l = 1; l < loops.size(); ++l) edges.emplace_back(loops[0][0], loops[l][0]);
    faces = static_cast<int>(sides.size());
    for (const Pair& e : edges) {
      of_edges.emplace_back(points.live.size() / 64 + 1, 0);
      flip(of_edges.back(), e.first);
      flip(of_edges.back(), e.second);
    }
    for (const std::vector<int>& face : sides) {
      of_faces.emplace_back(edges.size() / 64 + 1, 0);
      for (const int e : face) flip(of_faces.back(), e);
    }
  }
};

bool can_be_turned(const LoopList& loops, const Sides& sides, int faces) {
  Groups groups(2 * faces);
  for (int pair = 0; pair < sides.pairs(); ++pair) {
    if (sides.count(pair) != 2) continue;
    const Side *a = sides.begin(pair), *b = a + 1;
    const int f = loops.face_of[static_cast<std::size_t>(a->face)],
              g = loops.face_of[static_cast<std::size_t>(b->face)];
    const int turn = a->up == b->up ? faces : 0;
    groups.join(f, g + turn);
    groups.join(f + faces, g + faces - turn);
  }
  for (int f = 0; f < faces; ++f)
    if (groups.root(f) == groups.root(f + faces)) return false;
  return true;
}

}  // namespace

Homology homology_of(const Complex& points) {
  const LoopList loops = loops_of(points);
  const PolygonList& list = loops.copies.list;
  const Sides sides(list);
  const Chains chains(points);
  const int edges = static_cast<int>(chains.edges.size()),
            vertices = static_cast<int>(std::count(points.live.begin(), points.live.end(), char{1}));
  const int rank_1 = rank_of(chains.of_edges), rank_2 = rank_of(chains.of_faces);
  Homology homology;
  homology.parts = vertices - rank_1;
  homology.is_surface = can_be_turned(loops, sides, static_cast<int>(points.faces.size()));
  for (int pair = 0; pair < sides.pairs(); ++pair) homology.is_surface &= sides.count(pair) <= 2;
  for (const int fans : fans_per_vertex(list, sides)) homology.is_surface &= fans <= 1;
  if (!homology.is_surface || !points.wires.empty()) return homology;
  // A closed part of genus g has 2 g independent walks that bound nothing, one with b > 0 boundary loops b - 1 more.
  std::vector<char> used(points.live.size(), 0);
  for (const Corners& face : list.faces)
    for (const int v : face) used[static_cast<std::size_t>(v)] = 1;
  const int of_faces = homology.parts - (vertices - static_cast<int>(std::count(used.begin(), used.end(), char{1})));
  const int closed = chains.faces - rank_2, walks = edges - rank_1 - rank_2;
  homology.genus = (walks - boundary_loops(list, sides) + (of_faces - closed)) / 2;
  return homology;
}

}  // namespace ryosen::oracle
