#include "core/mesh/mesh.h"

#include <bit>

#include "core/mesh/circulate.h"

namespace ryosen {

int Mesh::find_attribute(std::string_view name) const {
  for (std::size_t k = 0; k < columns_.attributes.size(); ++k)
    if (columns_.attributes[k].name == name) return static_cast<int>(k);
  return -1;
}

ColumnLengths Mesh::lengths() const {
  ColumnLengths lengths{
      vertex_slots(), halfedge_slots(), face_slots(), static_cast<std::uint32_t>(columns_.next_copy.size()), {}};
  std::size_t pool = 0;
  for (const AttributeColumn& attribute : columns_.attributes)
    if (attribute.element == ElementKind::pool)
      lengths.pools[pool++] = static_cast<std::uint32_t>(attribute.data.size() / attribute.words);
  return lengths;
}

std::size_t Mesh::core_bytes() const {
  return columns_.vertex_halfedge.capacity() * sizeof(Halfedge) +
         columns_.halfedges.capacity() * sizeof(HalfedgeLinks) + columns_.face_halfedge.capacity() * sizeof(Halfedge) +
         columns_.positions.capacity() * sizeof(glm::dvec3);
}

std::pair<std::byte*, std::size_t> Mesh::cell(Column column, std::uint32_t index) {
  const auto bytes = [](auto& value) { return std::pair(reinterpret_cast<std::byte*>(&value), sizeof value); };
  MeshColumns& c = columns_;
  switch (column) {
    case Column::vertex_halfedge:
      return bytes(c.vertex_halfedge[index]);
    case Column::from:
      return bytes(c.halfedges[index].from);
    case Column::next:
      return bytes(c.halfedges[index].next);
    case Column::prev:
      return bytes(c.halfedges[index].prev);
    case Column::face:
      return bytes(c.halfedges[index].face);
    case Column::face_halfedge:
      return bytes(c.face_halfedge[index]);
    case Column::position:
      return bytes(c.positions[index]);
    case Column::next_copy:
      return bytes(c.next_copy[index]);
    case Column::first_attribute:
      break;
  }
  AttributeColumn& attribute =
      c.attributes[static_cast<std::size_t>(column) - static_cast<std::size_t>(Column::first_attribute)];
  return {reinterpret_cast<std::byte*>(attribute.data.data() + std::size_t{index} * attribute.words),
          attribute.words * sizeof(std::uint32_t)};
}

namespace {

struct Digest {
  std::uint64_t state = 0x243f6a8885a308d3ull;
  void add(std::uint64_t word) { state = std::rotl((state ^ word) * 0x9e3779b97f4a7c15ull, 29); }
};

}  // namespace

std::uint64_t Mesh::hash() const {
  Digest digest;
  for (std::uint32_t i = 0; i < vertex_slots(); ++i) {
    const Vertex v(i);
    if (!is_alive(v)) continue;
    const glm::dvec3& p = position(v);
    digest.add(i);
    digest.add(std::bit_cast<std::uint64_t>(p.x));
    digest.add(std::bit_cast<std::uint64_t>(p.y));
    digest.add(std::bit_cast<std::uint64_t>(p.z));
    if (next_copy(v) != v) digest.add(~std::uint64_t{next_copy(v).index});
  }
  for (std::uint32_t i = 0; i < face_slots(); ++i) {
    const Face f(i);
    if (!is_alive(f)) continue;
    digest.add(~std::uint64_t{i});
    for (Halfedge h : halfedges_around(*this, f)) digest.add(from(h).index);
  }
  return digest.state;
}

}  // namespace ryosen
