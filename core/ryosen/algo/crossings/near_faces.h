// Finds the faces of a changing mesh of triangles that may meet a triangle.
//
// By their boxes, but around a hub and at an edge between two, where the boxes of all overlap, by the directions in
// which they lie: those that lie in no direction in which the triangle lies do not meet it elsewhere than there.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "ryosen/algo/crossings/faces_at_hubs.h"
#include "ryosen/geometry/trees/bvh.h"
#include "ryosen/geometry/triangles_meet.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/triangle_corners.h"

namespace ryosen {

class NearFaces {
 public:
  // O(n log n). Faces with places that are not finite are found by none.
  explicit NearFaces(const Mesh& mesh);

  // Adds each face that meets one of these elsewhere than at points of the same number, and others near them, once.
  // Numbers are those of points of the mesh; others stand for new ones. Cost where they are few: O(log n) for each, and
  // what is found; and now and then what puts the trees in order, O(n log n) after n changes.
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
  static constexpr std::uint32_t none = no_index;

  struct Hub {
    std::uint32_t point;  // its number
    glm::dvec3 place{0};
    std::vector<std::uint32_t> groups{};
  };
  // Faces at one hub and no other, or at two.
  struct Group {
    std::array<std::uint32_t, 2> hubs;
    FacesAtHubs faces;
  };
  // Where a face belongs: hubs in ascending order, and its corners, those at the hubs first.
  struct Home {
    std::array<std::uint32_t, 2> hubs{none, none};
    TriangleCorners corners;
  };
  struct Spot {
    std::uint32_t group = none, slot = 0;
  };

  void follow(Vertex v, bool has_only_moved);
  std::uint32_t hub_of(Vertex v) const;
  void make_hub(Vertex v);
  void move_hub(std::uint32_t hub, const glm::dvec3& place);
  Home home_of(Face f) const;
  std::vector<glm::dvec3> places_of(const std::array<std::uint32_t, 2>& hubs) const;
  std::uint32_t group_of(const std::array<std::uint32_t, 2>& hubs);
  void put(Face f, bool has_only_moved = false);
  void put(Face f, std::uint32_t group, const TriangleCorners& corners);

  const Mesh& mesh_;
  Bvh tree_;  // of the faces of no hub, by face
  std::vector<Hub> hubs_;
  std::vector<std::uint32_t> hub_of_;  // by point, as far as there are hubs
  std::vector<Group> groups_;
  std::unordered_map<std::uint64_t, std::uint32_t> group_at_;  // by hubs
  std::vector<Spot> spots_;                                    // by face
  Bvh around_groups_;                                          // by group a segment across the box of its faces
  std::vector<glm::dvec3> ends_;                               // of those segments, two each
};

}  // namespace ryosen
