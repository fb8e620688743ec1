// Collapse: the two ends of an edge become one vertex.
//
//        x                     x
//       / \                    |
//      /   \                   |
//     a --> b       =>         b        the triangles at the edge vanish, other faces lose a corner
//      \   /                   |
//       \ /                    |
//        y                     y
//
// polygon list: a is replaced by b in every face; repeated consecutive corners and faces with fewer than three corners
//               are removed.
// needs: the only common neighbours of a and b are the apexes of the triangles at the edge (link condition), each of
//        which keeps a face; no other face contains both; not an interior edge between two boundary vertices; no
//        duplicate faces result; at most one of the two points has copies, and that point stays.
// changes: V - 1, E - 1 - k, F - k with k = triangles at the edge; H, S, G, B stay.
// inverse: vertex split. Source: [Hoppe96], [Dey99]; exact on polygons by the oracle of the test suite.
#pragma once

#include "ryosen/ops/op.h"

namespace ryosen {

class LocalFacts;

std::unique_ptr<OpSeries> collapses_in_series(Edit& edit);

struct CollapseEdge {
  enum class Place { automatic, start, end, middle, point };  // automatic: at the remaining point

  Halfedge halfedge;  // a -> b: a is removed, b keeps its number
  Place place = Place::automatic;
  glm::dvec3 target{};  // for Place::point

  static const OpInfo info;

  static CollapseEdge at(const Mesh& mesh, const OpTarget& target);

  Verdict check(const Mesh& mesh) const;
  // The same verdict without the fast path, rule by rule; check() falls back to it, and tests compare both.
  Verdict judge(const Mesh& mesh) const;
  // Both for many questions about one mesh.
  Verdict check(const Mesh& mesh, LocalFacts& known) const;
  Verdict judge(const Mesh& mesh, LocalFacts& known) const;
  // The rule of the first reason that check() gives.
  std::optional<Rule> broken_rule(const Mesh& mesh, LocalFacts& known) const;
  // check(mesh).legal() for batch work; the full check runs only if the fast path is undecided.
  bool is_legal(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;
  bool operator==(const CollapseEdge&) const = default;

  // The resulting position of the vertex. O(1).
  glm::dvec3 position(const Mesh& mesh) const;
  // The halfedge from the removed vertex to the remaining one: `halfedge`, or its twin if only a has copies.
  Halfedge directed(const Mesh& mesh) const;
  Halfedge directed(const Mesh& mesh, LocalFacts& known) const;
};

}  // namespace ryosen
