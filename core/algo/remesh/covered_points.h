// The points of the surface as it was, each with the face of the surface as it becomes that lies where it was.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/algo/remesh/features.h"
#include "core/algo/remesh/triangle_shape.h"

namespace ryosen::remesh {

// So no thin part can be eaten step by step, and no sheet taken for another: whatever becomes of the faces, each point stays
// near one of them that faces its way.
class CoveredPoints {
 public:
  // A face of a step.
  struct Change {
    enum class Kind { goes, becomes, comes_or_stays };
    Face face;
    Kind kind;
    Corners corners;   // as it becomes
    double moved = 0;  // how far a corner of one that becomes moves at most: from its points it comes no farther away
  };

  // Of a mesh of triangles the vertices that may move, and points on edges that are no features, each at most `spacing` from
  // the next. O(n).
  CoveredPoints(const Mesh& mesh, const Features& features, double spacing);

  // Whether each point of the faces that go or become lies within reach of one of the step, or no farther than it lay. No
  // more than most_faces are judged: so a step costs what it costs, and a hub stays where it is. Of those within reach one
  // that is near enough is as good as the nearest. Many points times faces.
  bool would_stay(std::span<const Change> changes, double reach, double near_enough);
  // The same of the faces around a vertex that moves so far, one after the other, by bounds alone: false says nothing.
  void begin_move(double moved);
  bool keeps_points(Face f, const glm::dvec3& area_normal, double reach);
  // What was judged last comes to be.
  void hand_over();

  static constexpr std::size_t most_faces = 64;

 private:
  struct Point {
    glm::dvec3 place, normal;  // the normal is 0 where the faces around go all ways
    double distance;           // from its face, or more
    std::uint32_t next;        // of the same face
  };
  struct Answer {
    std::uint32_t point;
    Face face;
    double distance;
  };
  using FaceNormals = std::vector<glm::dvec3>;
  static bool are_at_one(const glm::dvec3& area_normal, const Point& point);
  bool faces(const Point& point, std::size_t change) const;
  double distance(const Point& point, std::size_t change) const;
  bool find_answer(std::uint32_t point, std::size_t change, double reach, double near_enough);
  void add_vertex(const Mesh& mesh, const FaceNormals& area_normals, Vertex v);
  void add_edge(const Mesh& mesh, const FaceNormals& area_normals, Edge e, double spacing);
  void give(std::uint32_t point, Face f);

  std::vector<Point> points_;
  std::vector<std::uint32_t> first_;  // per face slot
  // Of the step that was judged.
  std::span<const Change> changes_;
  std::vector<Answer> answers_;
  std::vector<Face> old_;
  std::vector<glm::dvec3> normals_;  // per change, by area
  bool is_move_ = false;             // each face keeps its points
  double moved_ = 0;
};

}  // namespace ryosen::remesh
