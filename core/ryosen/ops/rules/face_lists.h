// Faces as lists of points, for rules about the resulting corner list: does it split at its bridges, is there a
// duplicate face; and an index of equal faces.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <unordered_set>
#include <vector>

#include "ryosen/base/verdict.h"
#include "ryosen/mesh/bridges.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/rings.h"

namespace ryosen {

// The points along a cycle of `next` from `start`, by representative, and their positions.
std::vector<std::uint32_t> points_along(const Mesh& mesh, Halfedge start);
std::vector<glm::dvec3> places_along(const Mesh& mesh, Halfedge start);
// The loops of a face, the outer one first.
CornerLoops loops_of(const Mesh& mesh, Face f);

// The number of bridges; the lists must split at each.
std::size_t bridges_of(const CornerLoops& loops);

// Whether the halfedge is a side of a face with three corners and no rings.
inline bool is_triangle_side(const Mesh& mesh, Halfedge side) {
  return !mesh.is_outside(side) && is_triangle(mesh, side) && !mesh.has_rings(mesh.face(side));
}
// Whether a point is a corner of a face. Cost: the valence of the point or the corners, whichever is less.
bool touches(const Mesh& mesh, Face f, Vertex v);
// Whether a face has neither rings nor bridges. O(corners).
bool is_one_simple_loop(const Mesh& mesh, Face f);
// Refuses a face that is not one simple loop. Witnesses: the face, the sides of its rings, its bridges; their number
// measures how far it is from one.
void refuse_rings(const Mesh& mesh, Face f, Verdict& verdict);

// The distinct points, ascending; equal for duplicate faces.
std::vector<std::uint32_t> point_set(std::span<const std::uint32_t> corners);
// A face on exactly these points (ascending), or none, ignoring `except`. Cost: the smallest one-ring of the points,
// plus the corners of the faces there with as many points.
Face face_on(const Mesh& mesh, std::span<const std::uint32_t> points, std::span<const Face> except = {});
// The same: up to `most` of them.
std::vector<Face> faces_on(const Mesh& mesh, std::span<const std::uint32_t> points, std::span<const Face> except,
                           std::size_t most);
// The same: the first that is not left out.
Face face_on_unless(const Mesh& mesh, std::span<const std::uint32_t> points,
                    const std::function<bool(Face)>& is_left_out);
// Another face on the points of f, or none.
Face equal_face(const Mesh& mesh, Face f);

// Index of the faces that have another face on their points, for many questions: those at a point are read once.
// Meanwhile a face may change that has no equal one, if it has got points that no face asked about has.
class EqualFaceIndex {
 public:
  explicit EqualFaceIndex(const Mesh& mesh) : mesh_(mesh) {}

  // See equal_face(). Cost: the corners of the face, and where no point of it has been read yet those of the faces at
  // its point of lowest valence.
  bool has_equal(Face f);

 private:
  void read_faces_at(Vertex p);

  const Mesh& mesh_;
  std::unordered_set<Vertex> read_;  // points
  std::unordered_set<Face> known_;
  std::map<std::vector<std::uint32_t>, std::uint32_t> count_;  // of faces by their points
};

}  // namespace ryosen
