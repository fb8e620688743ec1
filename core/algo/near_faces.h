// Finds the faces of a changing mesh of triangles that may meet a triangle.
//
// By their boxes, but around a hub, where the boxes of all overlap, by the directions in which they lie from it: those that
// lie in no direction in which the triangle lies do not meet it elsewhere than at the hub.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/box.h"
#include "core/geometry/triangles_meet.h"
#include "core/mesh/mesh.h"
#include "core/mesh/triangle_corners.h"
#include "core/pick/bvh.h"

namespace ryosen {

class NearFaces {
 public:
  // O(n log n). Faces with places that are not finite are found by none.
  explicit NearFaces(const Mesh& mesh);

  // Adds each face that meets one of these elsewhere than at points of the same number, and others near them, once. Numbers
  // are those of points of the mesh; others stand for new ones. Cost where they are few: O(log n) for each, and what is
  // found; and now and then what puts the trees in order, O(n log n) after n changes.
  void find(std::span<const NumberedTriangle> triangles, std::vector<Face>& found);

  // A vertex has moved, or has other faces: those around it are up to date. Cost: O(log n) for each of its faces.
  void follow(Vertex v) { follow(v, false); }
  // The same if it has moved, and that is all.
  void follow_move(Vertex v) { follow(v, true); }
  // A face that is new or has other corners.
  void follow(Face f) { put(f); }
  // A face that is gone.
  void forget(Face f);

 private:
  static constexpr std::uint32_t no_hub = no_index;

  // A vertex of many faces, of which it holds those that are in no other hub.
  struct Hub {
    Vertex vertex;
    glm::dvec3 place{0};
    // By slot two, in which the corners of a face lie from the place. The largest coordinate of each is 1, of either sign.
    std::vector<glm::dvec3> directions{};
    Bvh tree{};  // a segment between them; the owner is the face
    std::vector<std::uint32_t> free_slots{};
  };
  struct Spot {
    std::uint32_t hub = no_hub, slot = 0;
  };

  void follow(Vertex v, bool has_only_moved);
  std::uint32_t hub_of(Vertex v) const { return v.index < hub_of_.size() ? hub_of_[v.index] : no_hub; }
  // The hub that a face belongs to, with the corner that lies there.
  std::uint32_t hub_of(Face f, Halfedge& corner) const;
  void make_hub(Vertex v);
  void move_hub(std::uint32_t hub, const glm::dvec3& place);
  void put(Face f, bool has_only_moved = false);
  void put(Face f, std::uint32_t hub, Halfedge corner);
  void enlarge(std::uint32_t hub, const TriangleCorners& corners);

  const Mesh& mesh_;
  Bvh tree_;  // of the faces of no hub, by face
  std::vector<Hub> hubs_;
  std::vector<std::uint32_t> hub_of_;  // by vertex, as far as there are hubs
  std::vector<Spot> spots_;            // by face
  Bvh around_hubs_;                    // by hub a segment across the box of its faces
  std::vector<glm::dvec3> ends_;       // of those segments, two each
};

}  // namespace ryosen
