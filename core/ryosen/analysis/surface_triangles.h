// The faces of a mesh as triangles with stable slots, updated incrementally through edits; used for drawing and
// picking.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/journal.h"

namespace ryosen {

// A triangle of a face. An unused slot has three equal corners, no face (no_index) and no edges.
struct SurfaceTriangle {
  std::array<std::uint32_t, 3> corners{};  // vertex numbers, in the direction of the face
  std::uint32_t face = no_index;
  std::uint8_t edge_bits = 0;  // bit k: the side from corner k is an edge of the face
};

// Every live face with n finite corners has n - 2 triangles of vertex numbers, plus two for each ring.
//
// Where all faces of the mesh are finite triangles, the slot of each is its number: its home, which is read from the
// mesh and costs no memory. Any other triangle is stored in a slot behind the homes.
class SurfaceTriangles {
 public:
  explicit SurfaceTriangles(const Mesh& mesh);

  // Updates the triangles of the touched faces and returns the slots whose corners or positions may have changed,
  // ascending. Cost: the touched faces. With `touched.everything` it rebuilds all and returns all slots.
  std::vector<std::uint32_t> update(const Mesh& mesh, const TouchedElements& touched);

  std::uint32_t slots() const { return homes_ + static_cast<std::uint32_t>(stored_.size()); }
  // What a slot holds. Pass the mesh of the last update. O(1).
  SurfaceTriangle at(const Mesh& mesh, std::uint32_t slot) const;
  // What these slots hold, in their order. Fetches for several at once, so that many in any order cost less than one by
  // one.
  void read(const Mesh& mesh, std::span<const std::uint32_t> slots, SurfaceTriangle* to) const;
  // The slots of a face.
  std::vector<std::uint32_t> slots_of(const Mesh& mesh, Face f) const;
  // That of a face which has one; no_index for others.
  std::uint32_t only_slot_of(const Mesh& mesh, Face f) const;

 private:
  void rebuild(const Mesh& mesh);
  bool is_home(const Mesh& mesh, Face f) const;
  // The first stored slot of a face that is not at home; no_index if it has none.
  std::uint32_t first_stored(Face f) const;
  void set_first_stored(Face f, std::uint32_t slot);
  void release(Face f, std::vector<std::uint32_t>& changed);
  void fill(const Mesh& mesh, Face f, std::vector<std::uint32_t>& changed);
  std::uint32_t take_slot();

  std::uint32_t homes_ = 0;              // faces below this number are at home unless they moved out
  std::vector<SurfaceTriangle> stored_;  // by slot behind the homes
  std::vector<std::uint32_t> next_;      // chain of the stored slots of a face
  std::vector<std::uint32_t> first_;     // per face behind the homes: its first stored slot
  std::unordered_map<std::uint32_t, std::uint32_t> moved_out_;  // the same of faces with an unused home
  std::vector<std::uint32_t> free_;                             // unused stored slots, a stack
  // Scratch of fill.
  FacePolygon polygon_;
  std::vector<std::array<std::uint32_t, 3>> local_;
};

}  // namespace ryosen
