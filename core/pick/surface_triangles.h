// The faces of a mesh as triangles with stable slots, updated incrementally through edits; used for drawing and
// picking.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/mesh/face_polygon.h"
#include "core/mesh/touched.h"

namespace ryosen {

// Every live face with n finite corners has n - 2 triangles of vertex numbers, plus two for each ring. An unused slot
// holds three equal corners and no face. Returned spans are valid until the next update.
class SurfaceTriangles {
 public:
  explicit SurfaceTriangles(const Mesh& mesh);

  // Updates the triangles of the touched faces and returns the slots whose corners or positions changed, ascending.
  // Cost: the touched faces. With `touched.everything` it rebuilds all and returns all slots.
  std::vector<std::uint32_t> update(const Mesh& mesh, const TouchedElements& touched);

  std::span<const std::array<std::uint32_t, 3>> triangles() const { return triangles_; }
  std::span<const std::uint32_t> faces() const { return face_; }          // of each triangle; no_index if unused
  std::span<const std::uint8_t> edge_bits() const { return edge_bits_; }  // bit k: the side from corner k is an edge
  // The slots of a face.
  std::vector<std::uint32_t> slots_of(Face f) const;
  // That of a face which has one; no_index for others.
  std::uint32_t only_slot_of(Face f) const {
    const std::uint32_t slot = first_of_face_[f.index];
    return slot == no_index || next_of_face_[slot] != no_index ? no_index : slot;
  }

 private:
  void rebuild(const Mesh& mesh);
  void release(Face f, std::vector<std::uint32_t>& changed);
  void fill(const Mesh& mesh, Face f, std::vector<std::uint32_t>& changed);
  std::uint32_t take_slot();

  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::uint32_t> face_;
  std::vector<std::uint8_t> edge_bits_;
  std::vector<std::uint32_t> next_of_face_;   // chain of slots of a face
  std::vector<std::uint32_t> first_of_face_;  // per face slot
  std::vector<std::uint32_t> free_;           // unused slots, a stack
  // Scratch of fill.
  FacePolygon polygon_;
  std::vector<std::array<std::uint32_t, 3>> local_;
};

}  // namespace ryosen
