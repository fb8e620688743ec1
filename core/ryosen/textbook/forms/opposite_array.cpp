#include "ryosen/textbook/forms/opposite_array.h"

#include <utility>

#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

OppositeArray::OppositeArray(const Mesh& mesh) {
  Polygons polygons = polygons_of(mesh, Numbering(mesh));
  const std::vector<std::uint32_t> across = corners_across(mesh);
  opposites_.resize(across.size());
  for (std::uint32_t h = 0; h < across.size(); ++h)
    opposites_[h] = across[h] == no_index ? boundary_code(h) : static_cast<std::int32_t>(across[h]);
  positions_ = std::move(polygons.positions);
  corners_ = std::move(polygons.corners);
  vertex_halfedge_.assign(positions_.size(), no_index);
  for (std::uint32_t h = 0; h < corners_.size(); ++h) vertex_halfedge_[corners_[h]] = h;
}

std::size_t OppositeArray::bytes() const {
  return bytes_of(positions_) + bytes_of(vertex_halfedge_) + bytes_of(corners_) + bytes_of(opposites_);
}

Mesh OppositeArray::to_mesh() const {
  Polygons polygons;
  polygons.positions = positions_;
  polygons.corners = corners_;
  for (std::uint32_t f = 0; f < face_count(); ++f) polygons.offsets.push_back(3 * f + 3);
  std::vector<std::uint32_t> across(opposites_.size());
  for (std::uint32_t h = 0; h < across.size(); ++h) across[h] = opposite(h);
  return mesh_from_sides(polygons, across);
}

std::uint32_t OppositeArray::add_vertex(const glm::dvec3& position) {
  positions_.push_back(position);
  vertex_halfedge_.push_back(no_index);
  return static_cast<std::uint32_t>(positions_.size()) - 1;
}

std::uint32_t OppositeArray::add_face() {
  for (int j = 0; j < 3; ++j) {
    opposites_.push_back(boundary_code(static_cast<std::uint32_t>(corners_.size())));
    corners_.push_back(no_index);
  }
  return face_count() - 1;
}

void OppositeArray::set_face(std::uint32_t f, const std::array<std::uint32_t, 3>& corners) {
  for (std::uint32_t j = 0; j < 3; ++j) {
    corners_[3 * f + j] = corners[j];
    vertex_halfedge_[corners[j]] = 3 * f + j;
  }
}

void OppositeArray::join(std::uint32_t h, std::uint32_t g) {
  opposites_[h] = static_cast<std::int32_t>(g);
  opposites_[g] = static_cast<std::int32_t>(h);
}

Fields OppositeArray::record(Element own) const {
  const std::uint32_t i = own.index;
  if (own.kind == Element::Kind::vertex)
    return {place("x, y, z", positions_[i]), link("halfedge", "vertex_halfedge", Halfedge(vertex_halfedge_[i]))};
  if (own.kind == Element::Kind::face)
    return {links("vertices", "corners",
                  std::vector{Vertex(corners_[3 * i]), Vertex(corners_[3 * i + 1]), Vertex(corners_[3 * i + 2])})};
  if (own.kind != Element::Kind::halfedge) return {};
  Field opposite_link = link("twin", "opposites", Halfedge(opposite(i)));
  opposite_link.stored = {opposites_[i]};
  return {link("from", "corners", Vertex(corners_[i])), std::move(opposite_link)};
}

}  // namespace ryosen::forms
