#include "ryosen/indexed/from_indexed.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "ryosen/base/parallel.h"
#include "ryosen/geometry/locate.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/indexed/fans.h"
#include "ryosen/indexed/indexed.h"
#include "ryosen/indexed/list_attributes.h"
#include "ryosen/indexed/pair_corners.h"
#include "ryosen/indexed/pair_regular.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/bridges.h"
#include "ryosen/mesh/columns.h"

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

// Replaces each face in source.bridged by its outer loop (the one with the largest area projected along the face's
// normal) and appends its other loops as further faces; returns the owning face of each of these. Corner values move
// along. O(corners) if there is such a face.
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
  for (AttributeColumn& column : source.attributes)
    if (column.element == ElementKind::corner) column = with_rows(column, order);
  source.face_offsets = std::move(offsets);
  return face_of_ring;
}

// Turns the faces from number `faces` on into rings of the faces they were split from.
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

// The boundary halfedge that leaves to(outside) at the other end of the same fan.
Halfedge next_outside(const UnwrittenVector<HalfedgeLinks>& halfedges, Halfedge outside) {
  Halfedge h = twin(outside);
  while (halfedges[h.index].face) h = twin(halfedges[h.index].prev);
  return h;
}

// The links of a triangle's side, derived from its corner number.
HalfedgeLinks triangle_links(const Halfedge* halfedge, std::uint32_t corner, Vertex from) {
  const std::uint32_t f = corner / 3, first = 3 * f, place = corner - first;
  return {from, halfedge[first + (place == 2 ? 0 : place + 1)], halfedge[first + (place == 0 ? 2 : place - 1)],
          Face(f)};
}

void link_triangles(const RegularPairing& p, unsigned threads, MeshColumns& c) {
  const Halfedge* halfedge = p.halfedge.data();
  constexpr std::uint32_t ahead = 24;
  for_each_part(static_cast<std::uint32_t>(p.points.size()), threads,
                [&](unsigned, std::uint32_t begin, std::uint32_t end) {
                  std::uint32_t e = begin == 0 ? 0 : p.points[begin - 1].edge_end;
                  for (std::uint32_t v = begin; v < end; ++v) {
                    for (; e < p.points[v].edge_end; ++e) {
                      if (e + ahead < p.up_edges)
                        for (std::uint32_t corner : {p.sides[e + ahead].up, p.sides[e + ahead].down})
                          __builtin_prefetch(halfedge + corner);
                      const RegularPairing::Sides& sides = p.sides[e];
                      const Vertex larger(sides.larger);
                      c.halfedges[2 * e] = triangle_links(halfedge, sides.up, Vertex(v));
                      c.halfedges[2 * e + 1] = sides.down == no_index ? HalfedgeLinks{larger, {}, {}, {}}
                                                                      : triangle_links(halfedge, sides.down, larger);
                    }
                  }
                });
}

// General polygons: first initialise all halves as boundary, then each face links its own.
void link_polygons(const IndexedMesh& source, const RegularPairing& p, unsigned threads, MeshColumns& c) {
  for (std::uint32_t v = 0, e = 0; v < p.points.size(); ++v) {
    for (; e < p.points[v].edge_end; ++e) {
      c.halfedges[2 * e] = {Vertex(v), {}, {}, {}};
      c.halfedges[2 * e + 1] = {Vertex(p.sides[e].larger), {}, {}, {}};
    }
  }
  for_each_part(
      static_cast<std::uint32_t>(source.face_count()), threads, [&](unsigned, std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t f = begin; f < end; ++f) {
          const std::uint32_t first = source.face_offsets[f], last = source.face_offsets[f + 1];
          for (std::uint32_t k = first; k < last; ++k)
            c.halfedges[p.halfedge[k].index] = {Vertex(source.corners[k]), p.halfedge[k + 1 < last ? k + 1 : first],
                                                p.halfedge[k > first ? k - 1 : last - 1], Face(f)};
        }
      });
}

// Both halves of edges that have only a down side.
void link_down_only(const IndexedMesh& source, const RegularPairing& p, bool triangles, MeshColumns& c) {
  if (triangles)
    for (std::uint32_t corner : p.down_only)
      c.halfedges[p.halfedge[corner].index] = triangle_links(p.halfedge.data(), corner, Vertex(source.corners[corner]));
  for (std::uint32_t corner : p.down_only) {
    const Halfedge inside = p.halfedge[corner], next = c.halfedges[inside.index].next;
    c.halfedges[twin(inside).index] = {c.halfedges[next.index].from, {}, {}, {}};
  }
}

// Links a boundary halfedge whose fan is otherwise linked, and stores it at its origin.
void link_outside_half(MeshColumns& c, Halfedge h) {
  const Halfedge next = next_outside(c.halfedges, h);
  c.halfedges[h.index].next = next;
  c.halfedges[next.index].prev = h;
  c.vertex_halfedge[c.halfedges[h.index].from.index] = h;
}

// Fills halfedges, vertex_halfedge and face_halfedge. The latter two must have their final lengths; faces without
// corners are not written. Triangles are linked edge by edge, in memory order. O(corners).
void link_regular(const IndexedMesh& source, const RegularPairing& p, unsigned threads, MeshColumns& c) {
  const bool triangles = is_all_triangles(source);
  c.halfedges.resize(2 * std::size_t{p.edges()});
  if (triangles)
    link_triangles(p, threads, c);
  else
    link_polygons(source, p, threads, c);
  link_down_only(source, p, triangles, c);
  for_each_part(static_cast<std::uint32_t>(source.face_count()), threads,
                [&](unsigned, std::uint32_t begin, std::uint32_t end) {
                  for (std::uint32_t f = begin; f < end; ++f)
                    if (source.face_offsets[f] < source.face_offsets[f + 1])
                      c.face_halfedge[f] = p.halfedge[source.face_offsets[f]];
                });
  for_each_part(static_cast<std::uint32_t>(p.points.size()), threads,
                [&](unsigned, std::uint32_t begin, std::uint32_t end) {
                  for (std::uint32_t v = begin; v < end; ++v)
                    if (p.points[v].last_corner != no_index) c.vertex_halfedge[v] = p.halfedge[p.points[v].last_corner];
                });
  const std::size_t inside = source.corners.size();
  if (c.halfedges.size() == inside) return;
  for (std::uint32_t e = 0; e < p.up_edges; ++e)
    if (p.sides[e].down == no_index) link_outside_half(c, halfedge(Edge(e), 1));
  for (std::uint32_t corner : p.down_only) link_outside_half(c, twin(p.halfedge[corner]));
}

void link_faces(const IndexedMesh& source, const CornerPairing& pairing, MeshColumns& c) {
  c.halfedges.assign(std::size_t{2} * pairing.edges, HalfedgeLinks());
  for (std::uint32_t f = 0; f < source.face_count(); ++f) {
    const std::uint32_t begin = source.face_offsets[f], end = source.face_offsets[f + 1];
    if (begin == end) continue;
    Halfedge before = pairing.halfedge[end - 1];
    Halfedge current = pairing.halfedge[begin];
    c.face_halfedge[f] = current;
    for (std::uint32_t corner = begin; corner < end; ++corner) {
      const Halfedge after = pairing.halfedge[corner + 1 < end ? corner + 1 : begin];
      const Vertex from(source.corners[corner]);
      c.halfedges[current.index] = {from, after, before, Face(f)};
      c.vertex_halfedge[from.index] = current;
      before = current;
      current = after;
    }
  }
}

void link_outside(MeshColumns& c) {
  UnwrittenVector<HalfedgeLinks>& halfedges = c.halfedges;
  for (std::size_t i = 0; i < halfedges.size(); ++i)
    if (!halfedges[i].face) halfedges[i].from = halfedges[halfedges[i ^ 1u].next.index].from;
  for (std::size_t i = 0; i < halfedges.size(); ++i)
    if (!halfedges[i].face) link_outside_half(c, Halfedge(i));
}

// Joins the two faces at each boundary loop of exactly two halfedges; returns whether there was one. Edges are
// renumbered without gaps, keeping their order.
bool close_two_loops(const MeshColumns& c, CornerPairing& pairing) {
  std::vector<Halfedge> renamed(c.halfedges.size());
  for (std::uint32_t i = 0; i < renamed.size(); ++i) renamed[i] = Halfedge(i);
  std::vector<bool> dropped(c.halfedges.size() / 2, false);
  bool any = false;
  for (std::uint32_t i = 0; i < c.halfedges.size(); ++i) {
    const Halfedge h(i), other = c.halfedges[i].next;
    if (c.halfedges[i].face || c.halfedges[other.index].face || c.halfedges[other.index].next != h) continue;
    if (other.index < i) continue;
    renamed[twin(other).index] = h;
    dropped[edge(other).index] = true;
    any = true;
  }
  if (!any) return false;
  std::vector<std::uint32_t> number(dropped.size());
  pairing.edges = 0;
  for (std::size_t e = 0; e < dropped.size(); ++e) number[e] = dropped[e] ? no_index : pairing.edges++;
  for (Halfedge& h : pairing.halfedge) {
    const Halfedge target = renamed[h.index];
    h = halfedge(Edge(number[edge(target).index]), target.index & 1u);
  }
  return true;
}

std::uint32_t count_empty_faces(const IndexedMesh& source) {
  std::uint32_t count = 0;
  for (std::size_t f = 0; f < source.face_count(); ++f)
    count += source.face_offsets[f] == source.face_offsets[f + 1] ? 1u : 0u;
  return count;
}

}  // namespace

Mesh from_indexed(IndexedMesh source) {
  MeshColumns c;
  CornerPairing pairing;
  const auto faces = static_cast<std::uint32_t>(source.face_count());
  const std::uint32_t empty_faces = count_empty_faces(source);
  const std::vector<std::uint32_t> face_of_ring = split_bridges(source);
  c.vertex_halfedge.assign(source.positions.size(), Halfedge());
  c.face_halfedge.assign(source.face_count(), dead_halfedge);
  c.file_vertices = static_cast<std::uint32_t>(source.positions.size());
  const unsigned threads = threads_for(source.corners.size());
  if (auto regular = pair_regular(source, threads)) {
    link_regular(source, *regular, threads, c);
    pairing = {std::move(regular->halfedge), regular->edges(), false};
  } else {
    pairing = pair_with_cuts(source);
    link_faces(source, pairing, c);
    link_outside(c);
    if (pairing.has_cuts && close_two_loops(c, pairing)) {
      link_faces(source, pairing, c);
      link_outside(c);
    }
  }
  c.positions = std::move(source.positions);
  c.live = {static_cast<std::uint32_t>(c.positions.size()), pairing.edges, faces - empty_faces};
  fold_rings(face_of_ring, faces, c);
  separate_fans(c);
  add_attributes(source, pairing, c);
  return Mesh(std::move(c));
}

}  // namespace ryosen
