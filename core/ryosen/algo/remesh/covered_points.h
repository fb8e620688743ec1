// The points of the surface as it was, each with the face of the surface as it becomes that lies where it was.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ryosen/algo/remesh/features.h"
#include "ryosen/algo/remesh/triangle_shape.h"

namespace ryosen::remesh {

// So no thin part can be eaten step by step, and no sheet taken for another: whatever becomes of the faces, each point
// stays near one of them that faces its way. CoveredStep judges by it.
class CoveredPoints {
 public:
  // Covers a mesh of triangles: the vertices that may move, and points on edges that are no features or weighed, each
  // at most `spacing` from the next. O(n).
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

// Whether a step keeps each point of a surface near a face that faces its way.
class CoveredStep {
 public:
  // A face of a step.
  struct Change {
    enum class Kind { goes, becomes, comes_or_stays };
    Face face;
    Kind kind;
    Corners corners;   // as it becomes
    double moved = 0;  // how far a corner of one that becomes moves at most: from its points it comes no farther away
  };

  explicit CoveredStep(CoveredPoints& covered) : covered_(covered) {}

  // Whether each point of the faces that go or become lies within reach of one of the step, or no farther than it lay.
  // No more than most_faces are judged: so a step costs what it costs, and a hub stays where it is. Of those within
  // reach one that is near enough is as good as the nearest. Within an infinite reach is each face, whichever way it
  // faces. Many points times faces.
  bool would_stay(std::span<const Change> changes, double reach, double near_enough);
  // The same of the faces around a vertex that moves so far, one after the other, by bounds alone: false says nothing.
  void begin_move(double moved);
  bool keeps_points(Face f, const glm::dvec3& area_normal, double reach);
  // What was judged last comes to be.
  void hand_over();

  static constexpr std::size_t most_faces = 64;

 private:
  using Point = CoveredPoints::Point;
  struct Answer {
    std::uint32_t point;
    Face face;
    double distance;
  };
  static bool are_at_one(const glm::dvec3& area_normal, const Point& point);
  bool faces(const Point& point, std::size_t change) const;
  double distance(const Point& point, std::size_t change) const;
  bool find_answer(std::uint32_t point, std::size_t change, double reach, double near_enough);

  CoveredPoints& covered_;
  // Of the step that was judged.
  std::span<const Change> changes_;
  std::vector<Answer> answers_;
  std::vector<Face> old_;
  std::vector<glm::dvec3> normals_;  // per change, by area
  bool is_any_way_ = false;
  bool is_move_ = false;  // each face keeps its points
  double moved_ = 0;
};

}  // namespace ryosen::remesh
