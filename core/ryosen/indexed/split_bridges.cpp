#include "ryosen/indexed/split_bridges.h"

#include <cmath>
#include <utility>

#include "ryosen/geometry/locate.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/bridges.h"

namespace ryosen {

namespace {

using Loops = std::vector<std::vector<std::uint32_t>>;  // indices into the corner list

std::vector<glm::dvec3> places_of(const IndexedMesh& source, const std::vector<std::uint32_t>& corners) {
  std::vector<glm::dvec3> places;
  places.reserve(corners.size());
  for (std::uint32_t corner : corners) places.push_back(source.positions[source.corners[corner]]);
  return places;
}

// The loops of a face, the outer one first.
Loops loops_of_face(const IndexedMesh& source, std::uint32_t f) {
  CornerLoops list;
  list.add(source.face(f));
  Loops loops = *take_out_bridges(list);
  std::vector<glm::dvec3> all;
  for (std::uint32_t corner : source.face(f)) all.push_back(source.positions[corner]);
  const glm::dvec3 normal = polygon_normal(all);
  std::size_t outer = 0;
  double largest = -1;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (std::uint32_t& place : loops[i]) place += source.face_offsets[f];
    const double area = std::abs(projected_area(places_of(source, loops[i]), normal));
    if (!(area > largest)) continue;
    largest = area;
    outer = i;
  }
  std::swap(loops[0], loops[outer]);
  return loops;
}

// Permutes the values of a list.
void reorder(std::vector<std::uint32_t>& values, const std::vector<std::uint32_t>& order) {
  if (values.empty()) return;
  std::vector<std::uint32_t> sorted;
  sorted.reserve(order.size());
  for (std::uint32_t place : order) sorted.push_back(values[place]);
  values = std::move(sorted);
}

}  // namespace

std::vector<std::uint32_t> split_bridges(IndexedMesh& source) {
  std::vector<std::uint32_t> face_of_ring, order, offsets{0};
  if (source.bridged.empty()) return face_of_ring;
  Loops rings;
  auto bridged = source.bridged.begin();
  for (std::uint32_t f = 0; f < source.face_count(); ++f) {
    if (bridged != source.bridged.end() && *bridged == f) {
      ++bridged;
      Loops loops = loops_of_face(source, f);
      order.insert(order.end(), loops[0].begin(), loops[0].end());
      for (std::size_t i = 1; i < loops.size(); ++i) {
        rings.push_back(std::move(loops[i]));
        face_of_ring.push_back(f);
      }
    } else {
      for (std::uint32_t c = source.face_offsets[f]; c < source.face_offsets[f + 1]; ++c) order.push_back(c);
    }
    offsets.push_back(static_cast<std::uint32_t>(order.size()));
  }
  for (const auto& ring : rings) {
    order.insert(order.end(), ring.begin(), ring.end());
    offsets.push_back(static_cast<std::uint32_t>(order.size()));
  }
  reorder(source.corners, order);
  reorder(source.texcoords.index, order);
  reorder(source.normals.index, order);
  source.face_offsets = std::move(offsets);
  return face_of_ring;
}

void fold_rings(const std::vector<std::uint32_t>& face_of_ring, std::uint32_t faces, MeshColumns& c) {
  if (face_of_ring.empty()) return;
  c.first_ring.assign(faces, no_index);
  // In reverse, so that the chain of a face starts with its first ring.
  for (std::size_t i = face_of_ring.size(); i-- > 0;) {
    const Halfedge start = c.face_halfedge[faces + i];
    const Face f(face_of_ring[i]);
    Halfedge h = start;
    do {
      c.halfedges[h.index].face = f;
      h = c.halfedges[h.index].next;
    } while (h != start);
    c.rings.push_back({start, c.first_ring[f.index]});
    c.first_ring[f.index] = static_cast<std::uint32_t>(c.rings.size() - 1);
  }
  c.face_halfedge.resize(faces);
  c.live.rings = static_cast<std::uint32_t>(c.rings.size());
}

}  // namespace ryosen
