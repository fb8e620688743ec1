// Makes points one: PointMerger judges which may be, by what the list of polygons on points would be, with no mesh
// changed; join_points() does it, with the edges that this closes.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// The representative of every vertex by slot, none for dead ones. O(vertices).
std::vector<Vertex> points_by_slot(const Mesh& mesh);

// Classes of points that are to be one. A merge is refused where a face would visit a point twice, an edge would get a
// third face or a second in the same direction, or two faces would be on the same set of points, but for two that are
// told to be a pocket. All this stays so whatever is merged afterwards, so that a refused merge need not be tried
// again. Whether the faces at a class form one fan is the caller's affair. The mesh must outlive it and not change.
//
// Cost: O(k log n) for k merges with n sides of faces at the points, however many meet at one of them: the smaller of
// two classes is renamed.
class PointMerger {
 public:
  // `points`: those that may be merged; manifold or isolated ones.
  PointMerger(const Mesh& mesh, std::span<const Vertex> points);

  // Lets two faces be on the same set of points. Each is in one pocket at most.
  void let_be_pocket(Face f, Face g) {
    beyond_pocket_[f] = g;
    beyond_pocket_[g] = f;
  }

  // The point that stands for the class of one.
  Vertex root(Vertex point) const;
  // Makes the classes of two different roots one. False: refused, nothing has changed.
  bool merge(Vertex a, Vertex b);
  // Undoes the last merge.
  void undo();
  bool may_merge(Vertex point) const { return classes_.contains(point); }
  // The faces at the edge between two roots, at least one of which may be merged.
  PointEdge edge(Vertex a, Vertex b) const;

 private:
  using Key = std::uint64_t;

  // Faces and neighbours (points; several may be of one class) of a class.
  struct Class {
    std::vector<Face> faces;
    std::vector<Vertex> neighbours;
  };
  struct Undo {
    Vertex goes, stays;
    std::size_t faces, neighbours;  // that the one that stays had
    std::vector<std::pair<Key, PointEdge>> edges;
  };

  static Key key(std::uint32_t a, std::uint32_t b) { return Key{a} << 32u | b; }
  static Key key_of_pair(Vertex a, Vertex b) { return key(std::min(a, b).index, std::max(a, b).index); }
  void add_face(Face f, std::vector<Vertex>& corners);
  bool may_join(Vertex goes, Vertex stays) const;
  bool is_taken(Face f, Key shape) const;
  void rename_face(Face f, Vertex from, Vertex to);

  const Mesh& mesh_;
  std::unordered_map<Vertex, Vertex> parent_;  // only of points that are no roots
  std::unordered_map<Vertex, Class> classes_;
  std::unordered_map<Key, PointEdge> edges_;       // by roots; forward: from the lower number to the higher
  std::unordered_map<Face, Key> shape_of_;         // a sum over the face's points
  std::unordered_map<Key, std::uint32_t> shapes_;  // how many faces have it
  std::unordered_map<Face, Face> beyond_pocket_;
  std::unordered_set<Key> visits_;  // a face and the root of a class at it
  std::vector<Undo> undo_;
};

// A class of points that become one, ascending, and the place they take. The lowest keeps its number.
struct JoinedPoints {
  std::vector<Vertex> points;
  glm::dvec3 place;
};

// The result is what reading the merged list of polygons gives. No face may visit two points of a class, and every
// class is manifold afterwards (PointMerger); points that end wires stay alone. Cost: O(k log k) for k corners at the
// points and their copies, however many meet at one of them, beside a pass over the vertices.
void join_points(Edit& edit, const std::vector<JoinedPoints>& classes);

}  // namespace ryosen
