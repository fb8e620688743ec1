// A cache of what rules ask of whole stars and whole faces, for asking about many edges of one mesh, and quick answers
// from it about the two faces at an edge.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <unordered_set>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Valid while the mesh does not change, but for what is forgotten. The first question about a vertex or face costs its
// valence or its corners.
class LocalFacts {
 public:
  // See mesh/copies.h.
  bool has_several_fans(const Mesh& mesh, Vertex v);
  // See rules/face_lists.h.
  bool is_one_simple_loop(const Mesh& mesh, Face f);
  bool has_equal_face(const Mesh& mesh, Face f);
  // `is_new` tells whether they were counted for it.
  std::uint32_t corner_count(const Mesh& mesh, Face f, bool* is_new = nullptr);
  // See rules/face_lists.h. Of a large face the points are kept, so that it is read once; those that are looked at are
  // added to `looks`.
  bool touches(const Mesh& mesh, Face f, Vertex v, std::uint64_t& looks);
  void forget(Face f);
  // Call before a legal collapse: what is known of fans and of simple loops holds after it.
  void collapses(const Mesh& mesh, Halfedge h);
  // A simple loop whose corners are known has one less, and no other face is on its points.
  void lost_corner(Face f);
  // Call before one of two faces, without rings, takes the other in. Cost: the corners of that one.
  void unites(const Mesh& mesh, Face stays, Face goes);
  // Then it is a simple loop of so many corners, without the points left out, and no other face is on its points.
  void united(Face stays, Face goes, std::uint32_t corners, std::span<const Vertex> left_out);

 private:
  std::unordered_map<Vertex, bool> several_fans_;
  std::unordered_map<Face, bool> one_simple_loop_, equal_face_;
  std::unordered_map<Face, std::uint32_t> corner_count_;
  std::unordered_map<Face, std::unordered_set<Vertex>> points_;  // of large faces
};

// What is known of two different faces along a chain of edges that lie between them, through vertices with two edges.
enum class Union {
  plain,     // simple loops that touch at this chain alone, each the only one on its points, and no third face lies on
             // the points of both: they may be united
  touching,  // simple loops, each the only one on its points, that touch elsewhere too or would have too few corners
  unsure
};
// `looks` is added the corners that were looked at. Cost: those of the smaller face and the valence of one of its
// points, at most.
Union judge_union(const Mesh& mesh, std::span<const Halfedge> chain, LocalFacts& known, std::uint64_t* looks = nullptr);
// Whether the two faces at an edge may be united beyond doubt; a quick answer, as the one below: the corners of large
// faces are remembered between questions, so that one costs what is near the edge.
bool unite_plainly(const Mesh& mesh, Halfedge h, LocalFacts& known);

// One face of a swap: it loses one corner and gains another one.
struct CornerChange {
  Face face, beside;    // at the edge
  Vertex loses, stays;  // the ends of the edge
  Vertex gains;
};
// Whether the face is a simple loop and the only one on its points, does not touch the vertex that it gains, and no
// face but the one beside it can be on its points afterwards.
bool changes_plainly(const Mesh& mesh, const CornerChange& change, LocalFacts& known);

}  // namespace ryosen
