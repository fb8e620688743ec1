// The points of the surface as it was, each with the face of the surface as it becomes that lies where it was.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/algo/remesh/features.h"
#include "ryosen/algo/remesh/triangle_shape.h"

namespace ryosen::remesh {

// So no thin part can be eaten step by step, and no sheet taken for another: whatever becomes of the faces, each point
// stays near one of them that faces its way. CoveredStep (covered_step.h) judges by it.
class CoveredPoints {
 public:
  // Of a mesh of triangles the vertices that may move, and points on edges that are no features, each at most `spacing`
  // from the next. O(n).
  CoveredPoints(const Mesh& mesh, const Features& features, double spacing);

  // As many faces as there are: then steps that make none, and that have no face in common, may be judged and done by
  // several threads.
  void make_room(std::uint32_t face_slots) {
    if (first_.size() < face_slots) first_.resize(face_slots, no_index);
  }

 private:
  friend class CoveredStep;
  struct Point {
    glm::dvec3 place, normal;  // the normal is 0 where the faces around go all ways
    double distance;           // from its face, or more
    std::uint32_t next;        // of the same face
  };
  using FaceNormals = std::vector<glm::dvec3>;
  void add_vertex(const Mesh& mesh, const FaceNormals& area_normals, Vertex v);
  void add_edge(const Mesh& mesh, const FaceNormals& area_normals, Edge e, double spacing);
  void give(std::uint32_t point, Face f);

  // Of the angle between the normals of a point and of its face: past a right angle, since on a narrow rim both sides
  // are at one to the normal.
  static constexpr double least_facing = -0.3;

  std::vector<Point> points_;
  std::vector<std::uint32_t> first_;  // per face slot
};

}  // namespace ryosen::remesh
