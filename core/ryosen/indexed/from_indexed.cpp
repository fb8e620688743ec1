#include "ryosen/indexed/from_indexed.h"

#include <utility>

#include "ryosen/base/parallel.h"
#include "ryosen/indexed/attributes_from_indexed.h"
#include "ryosen/indexed/fans.h"
#include "ryosen/indexed/link_regular.h"
#include "ryosen/indexed/pair_corners.h"
#include "ryosen/indexed/split_bridges.h"

namespace ryosen {

namespace {

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
  for (std::size_t i = 0; i < halfedges.size(); ++i) {
    if (!halfedges[i].face) link_outside_half(c, Halfedge(i));
  }
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
