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
// on the list: a is replaced by b in every face; repeated neighbours and faces with fewer than three corners go.
// needs: the common neighbours of a and b are just the apexes of the triangles at the edge, each of which keeps a face;
//        no other face holds both; not an inside edge between two boundary vertices; no two faces on the same vertices
//        arise; at most one of the two points has copies, and then that point stays.
// changes: V - 1, E - 1 - k, F - k with k = triangles at the edge; H, S, G, B stay.
// inverse: vertex split. Source: [Hoppe96], [Dey99]; exact on polygons by the oracle of the test suite.
#pragma once

#include "core/ops/op.h"

namespace ryosen {

struct CollapseEdge {
  enum class Place { automatic, start, end, middle, point };  // automatic: where the staying point is

  Halfedge halfedge;  // a -> b: a goes, b stays with its number
  Place place = Place::automatic;
  glm::dvec3 target{};  // for Place::point

  static constexpr OpInfo info{"collapse",
                               "Collapse edge",
                               "稜線削除",
                               "A-B [start|end|mid|X,Y,Z]",
                               "A goes, B keeps its number and, without a word, its place",
                               "A が消え、B が番号と（指定がなければ）位置を保つ",
                               'C',
                               OpTargetKind::edge,
                               "",
                               Topology::kept};

  static Parsed<CollapseEdge> parse(const Mesh& mesh, std::span<const std::string_view> arguments);
  static CollapseEdge at(const Mesh& mesh, const OpTarget& target);
  std::string command(const Mesh& mesh) const;

  Verdict check(const Mesh& mesh) const;
  // The same verdict, always by judging rule for rule: what check() falls back to, and what tests hold it against.
  Verdict judge(const Mesh& mesh) const;
  // check(mesh).legal() for batch work: asks for reasons only where no quicker answer is certain.
  bool is_legal(const Mesh& mesh) const;
  std::vector<Reason> warnings(const Mesh& mesh) const;
  OpEffect apply(Edit& edit) const;

  // Where the vertex will lie. O(1).
  glm::dvec3 position(const Mesh& mesh) const;
  // The halfedge from the vertex that goes to the one that stays: this one, or its twin if only a has copies.
  Halfedge directed(const Mesh& mesh) const;
};

}  // namespace ryosen
