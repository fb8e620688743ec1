#include "ryosen/indexed/link_regular.h"

#include "ryosen/base/parallel.h"

namespace ryosen {

namespace {

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

}  // namespace

void link_outside_half(MeshColumns& c, Halfedge h) {
  const Halfedge next = next_outside(c.halfedges, h);
  c.halfedges[h.index].next = next;
  c.halfedges[next.index].prev = h;
  c.vertex_halfedge[c.halfedges[h.index].from.index] = h;
}

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

}  // namespace ryosen
