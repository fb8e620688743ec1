#include "ryosen/mesh/mesh.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

int Mesh::find_attribute(std::string_view name) const {
  for (std::size_t k = 0; k < columns_.attributes.size(); ++k)
    if (columns_.attributes[k].name == name && columns_.attributes[k].is_removed == 0) return static_cast<int>(k);
  return -1;
}

ColumnLengths Mesh::lengths() const {
  ColumnLengths lengths{vertex_slots(),
                        halfedge_slots(),
                        face_slots(),
                        static_cast<std::uint32_t>(columns_.next_copy.size()),
                        static_cast<std::uint32_t>(columns_.first_ring.size()),
                        static_cast<std::uint32_t>(columns_.rings.size()),
                        {}};
  std::size_t pool = 0;
  for (const AttributeColumn& attribute : columns_.attributes)
    if (attribute.element == ElementKind::pool)
      lengths.pools[pool++] = static_cast<std::uint32_t>(attribute.data.size() / attribute.words());
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
    case Column::copy_point:
      return bytes(c.copy_point[index]);
    case Column::first_ring:
      return bytes(c.first_ring[index]);
    case Column::ring:
      return bytes(c.rings[index]);
    case Column::attribute_removed:
      return bytes(c.attributes[index].is_removed);
    case Column::first_attribute:
      break;
  }
  AttributeColumn& attribute = c.attributes[attribute_of_column(column)];
  return {reinterpret_cast<std::byte*>(attribute.data.data() + std::size_t{index} * attribute.words()),
          attribute.words() * sizeof(std::uint32_t)};
}

namespace {

struct Digest {
  std::uint64_t state = 0x243f6a8885a308d3ull;
  void add(std::uint64_t word) { state = std::rotl((state ^ word) * 0x9e3779b97f4a7c15ull, 29); }
};

// The rings of a face in canonical order: each starts at its smallest vertex, and they are sorted by it.
void add_rings(Digest& digest, const Mesh& mesh, Face f) {
  std::vector<Halfedge> starts;
  for (std::uint32_t r = mesh.first_ring(f); r != no_index; r = mesh.ring(r).next) {
    Halfedge start = mesh.ring(r).halfedge;
    for (Halfedge h : loop(mesh, start))
      if (mesh.from(h) < mesh.from(start)) start = h;
    starts.push_back(start);
  }
  std::sort(starts.begin(), starts.end(), [&](Halfedge a, Halfedge b) { return mesh.from(a) < mesh.from(b); });
  for (Halfedge start : starts) {
    digest.add(0x52494e47u);
    for (Halfedge h : loop(mesh, start)) digest.add(mesh.from(h).index);
  }
}

void add_wires(Digest& digest, const Mesh& mesh) {
  std::vector<std::pair<Vertex, Vertex>> wires;
  for (const Edge e : live_edges(mesh)) {
    if (!mesh.is_wire(e)) continue;
    wires.push_back(std::minmax(mesh.from(halfedge(e, 0)), mesh.from(halfedge(e, 1))));
  }
  std::sort(wires.begin(), wires.end());
  for (const auto& [a, b] : wires) {
    digest.add(~std::uint64_t{a.index});
    digest.add(b.index);
  }
}

}  // namespace

std::uint64_t Mesh::hash() const {
  Digest digest;
  for (const Vertex v : live_vertices(*this)) {
    const glm::dvec3& p = position(v);
    digest.add(v.index);
    digest.add(std::bit_cast<std::uint64_t>(p.x));
    digest.add(std::bit_cast<std::uint64_t>(p.y));
    digest.add(std::bit_cast<std::uint64_t>(p.z));
    if (next_copy(v) != v) digest.add(~std::uint64_t{next_copy(v).index});
  }
  for (const Face f : live_faces(*this)) {
    digest.add(~std::uint64_t{f.index});
    for (Halfedge h : loop(*this, halfedge(f))) digest.add(from(h).index);
    if (has_rings(f)) add_rings(digest, *this, f);
  }
  add_wires(digest, *this);
  return digest.state;
}

}  // namespace ryosen
