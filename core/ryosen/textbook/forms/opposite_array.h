// The 3i+j form as plain arrays (a corner table): corners, opposite halfedges, and one halfedge per vertex.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "ryosen/textbook/forms/walk.h"

namespace ryosen::forms {

// Halfedge 3i+j is side j of face i. Where h has no opposite, the array holds -(h + 1), as the text's map does; so
// there are fewer than 2^31 halfedges. The halfedge per vertex is an addition to the text; with it the vertex relations
// can be answered. The handle of an edge is one of its halfedges.
class OppositeArray : public TriangleForm<OppositeArray> {
 public:
  explicit OppositeArray(const Mesh& mesh);

  std::size_t bytes() const override;
  Mesh to_mesh() const override;
  Fields record(Element own) const override;

  // The interface of split_3ij.h.
  std::uint32_t corner(std::uint32_t h) const { return corners_[h]; }
  std::uint32_t opposite(std::uint32_t h) const {
    return opposites_[h] < 0 ? no_index : static_cast<std::uint32_t>(opposites_[h]);
  }
  const glm::dvec3& position(std::uint32_t v) const { return positions_[v]; }
  std::uint32_t face_count() const { return static_cast<std::uint32_t>(corners_.size() / 3); }
  std::uint32_t add_vertex(const glm::dvec3& position);
  std::uint32_t add_face();
  void set_face(std::uint32_t f, const std::array<std::uint32_t, 3>& corners);
  void join(std::uint32_t h, std::uint32_t g);
  void set_boundary(std::uint32_t h) { opposites_[h] = boundary_code(h); }

  std::uint32_t at_vertex(std::uint32_t v) const { return vertex_halfedge_[v]; }  // of walk.h

 private:
  static std::int32_t boundary_code(std::uint32_t h) { return -static_cast<std::int32_t>(h) - 1; }

  std::vector<glm::dvec3> positions_;
  std::vector<std::uint32_t> vertex_halfedge_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::int32_t> opposites_;
};

}  // namespace ryosen::forms
