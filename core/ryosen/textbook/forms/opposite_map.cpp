#include "ryosen/textbook/forms/opposite_map.h"

#include <utility>

#include "ryosen/textbook/forms/form.h"
#include "ryosen/textbook/forms/polygons.h"

namespace ryosen::forms {

OppositeMap::OppositeMap(const Mesh& mesh) {
  const Polygons polygons = polygons_of(mesh, Numbering(mesh));
  positions_ = polygons.positions;
  for (std::uint32_t f = 0; f < polygons.face_count(); ++f) {
    const std::uint32_t* corner = polygons.corners.data() + polygons.offsets[f];
    faces_.push_back({corner[0], corner[1], corner[2]});
  }
  // A side is entered as boundary until its opposite is seen.
  for (std::uint32_t h = 0; h < 3 * faces_.size(); ++h) {
    const auto [from, to] = key(h);
    if (const auto other = opposites_.find(Side(to, from)); other != opposites_.end())
      join(h, static_cast<std::uint32_t>(-(other->second + 1)));
    else
      set_boundary(h);
  }
}

std::size_t OppositeMap::bytes() const {
  return bytes_of(positions_) + bytes_of(faces_) + *opposites_.get_allocator().bytes;
}

Mesh OppositeMap::to_mesh() const {
  Polygons polygons;
  polygons.positions = positions_;
  std::vector<std::uint32_t> across;
  for (std::uint32_t h = 0; h < 3 * faces_.size(); ++h) {
    polygons.corners.push_back(corner(h));
    across.push_back(opposite(h));
    if (h % 3 == 2) polygons.offsets.push_back(h + 1);
  }
  return mesh_from_sides(polygons, across);
}

std::uint32_t OppositeMap::find_edge(std::uint32_t a, std::uint32_t b) const {
  for (const Side& side : {Side(a, b), Side(b, a)})
    if (const auto found = opposites_.find(side); found != opposites_.end())
      return static_cast<std::uint32_t>(found->second < 0 ? -(found->second + 1) : found->second);
  return no_index;
}

bool OppositeMap::answer(Relation relation, std::uint32_t element, Answer& out) const {
  if (relations()[static_cast<std::size_t>(relation)].asks != ElementOf::vertex)
    return answer_by_walk(*this, relation, element, out);
  out.clear();
  const auto all_sides = [&](auto visit) {
    for (std::uint32_t h = 0; h < 3 * faces_.size(); ++h) visit(h / 3, edge_ends(corner(h), corner(next(h))));
  };
  answer_by_all_sides(relation, element, all_sides, out);
  return true;
}

std::uint32_t OppositeMap::add_vertex(const glm::dvec3& position) {
  positions_.push_back(position);
  return static_cast<std::uint32_t>(positions_.size()) - 1;
}

std::uint32_t OppositeMap::add_face() {
  faces_.push_back({no_index, no_index, no_index});
  return face_count() - 1;
}

// Erases the face's old sides, so that the map contains only existing ones.
void OppositeMap::set_face(std::uint32_t f, const std::array<std::uint32_t, 3>& corners) {
  for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) opposites_.erase(key(h));
  faces_[f] = corners;
}

void OppositeMap::join(std::uint32_t h, std::uint32_t g) {
  opposites_[key(h)] = static_cast<std::int32_t>(g);
  opposites_[key(g)] = static_cast<std::int32_t>(h);
}

Fields OppositeMap::record(Element own) const {
  if (own.kind == Element::Kind::vertex) return {place("x, y, z", positions_[own.index])};
  if (own.kind == Element::Kind::face) {
    const auto& [a, b, c] = faces_[own.index];
    return {links("vertices", "faces", std::vector{Vertex(a), Vertex(b), Vertex(c)})};
  }
  if (own.kind != Element::Kind::halfedge) return {};
  Field opposite_link = link("twin", "opps", Halfedge(opposite(own.index)));
  opposite_link.stored = {coded_opposite(own.index)};
  return {link("from", "first", Vertex(key(own.index).first)), link("to", "second", Vertex(key(own.index).second)),
          std::move(opposite_link)};
}

}  // namespace ryosen::forms
