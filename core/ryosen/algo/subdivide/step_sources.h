// The elements that those of the next level of a subdivision come from.
#pragma once

#include "ryosen/algo/subdivide/creases.h"
#include "ryosen/algo/subdivide/level_links.h"
#include "ryosen/mesh/descent.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/source_list.h"

namespace ryosen::subdivide {

// A place within a face of the level before: at the corner where h begins, at the middle of h, at the first or second
// third of it, or at the centre of the face of h.
struct CornerPlace {
  enum class Kind { at, middle, first_third, second_third, centre };
  Kind kind;
  Halfedge h;
};

// Old vertices stay; others lie on edges and at centres.
SourceList vertex_sources(const Mesh& mesh, const SplitNumbers& numbers);
SourceList vertex_sources(const Mesh& mesh, const Sqrt3Numbers& numbers);
// The edges that an edge is divided into, in the direction of the halfedge; none of one that sqrt(3) swaps.
std::vector<Edge> parts_of_edge(const SplitNumbers& numbers, Halfedge h);
std::vector<Edge> parts_of_edge(const Sqrt3Numbers& numbers, Halfedge h);
// A face is divided by area, in `next` with its places, where `by_area`; else equally. A triangle of sqrt(3) that lies
// in two faces is a part of that of its number.
SourceList face_sources(const Mesh& mesh, const SplitNumbers& numbers, const MeshColumns& next, bool by_area);
SourceList face_sources(const Mesh& mesh, const Sqrt3Numbers& numbers, const MeshColumns& next, bool by_area);

// The place of each new corner that has a face: put(corner, place).
template <class Put>
void place_corners(const Mesh& mesh, const SplitNumbers& n, const Put& put) {
  using enum CornerPlace::Kind;
  const bool into_quads = n.split() == Split::into_quads;
  for (Halfedge h(0); h.index < mesh.halfedge_slots(); ++h.index) {
    if (mesh.is_outside(h)) continue;
    put(first_half(h), CornerPlace{at, h});
    put(second_half(h), CornerPlace{middle, h});
    put(n.inner(h), CornerPlace{middle, into_quads ? h : mesh.prev(h)});
    put(twin(n.inner(h)), CornerPlace{into_quads ? centre : middle, h});
  }
}

template <class Put>
void place_corners(const Mesh& mesh, const Sqrt3Numbers& n, const Put& put) {
  using enum CornerPlace::Kind;
  const auto apex = [&](Halfedge h) {
    const Halfedge side = n.cut_side(h);
    return side ? CornerPlace{h == mesh.next(side) ? second_third : first_third, side} : CornerPlace{centre, h};
  };
  for (Halfedge h(0); h.index < mesh.halfedge_slots(); ++h.index) {
    if (mesh.is_outside(h)) continue;
    if (n.is_cut(h)) {
      put(n.part(h, 0), CornerPlace{at, h});
      put(n.part(h, 1), CornerPlace{first_third, h});
      put(n.part(h, 2), CornerPlace{second_third, h});
      put(twin(n.spoke(h)), CornerPlace{second_third, h});
      put(n.spoke(mesh.prev(h)), CornerPlace{at, mesh.prev(h)});
      continue;
    }
    put(n.before(h), apex(h));
    if (n.is_kept(h)) {
      put(h, CornerPlace{at, h});
      put(n.after(h), CornerPlace{at, mesh.next(h)});
    } else {
      put(h, apex(twin(h)));
      put(n.after(twin(h)), CornerPlace{at, h});
    }
  }
}

// An edge is divided into equal parts. Edges within faces are new, and so is one that sqrt(3) swaps; test builds are
// told so.
template <class Numbers>
SourceList edge_sources(const Mesh& mesh, const Numbers& numbers) {
  SourceList list(numbers.edge_slots());
  for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
    const std::vector<Edge> parts = parts_of_edge(numbers, halfedge(Edge(e)));
    for (const Edge part : parts) list.part(part.index, e, 1);
    if (parts.empty()) list.drop(e);
  }
  if (Descent::is_checked)
    place_corners(mesh, numbers, [&](Halfedge corner, CornerPlace) {
      if (const std::uint32_t e = edge(corner).index; !list.is_told(e)) list.fresh(e);
    });
  return list;
}

// A corner has the corners of the face between which it lies.
template <class Numbers>
SourceList corner_sources(const Mesh& mesh, const Numbers& numbers, const MeshColumns& next) {
  SourceList list(next.halfedges.size());
  std::vector<std::uint32_t> all;
  place_corners(mesh, numbers, [&](Halfedge to, CornerPlace place) {
    using enum CornerPlace::Kind;
    const auto along = [&](double t) {
      const std::uint32_t both[] = {place.h.index, mesh.next(place.h).index};
      const double weights[] = {1 - t, t};
      list.between(to.index, both, weights);
    };
    switch (place.kind) {
      case at:
        return list.keep(to.index, place.h.index);
      case middle:
        return along(0.5);
      case first_third:
        return along(1 / 3.0);
      case second_third:
        return along(2 / 3.0);
      case centre:
        all.clear();
        for (const Halfedge h : loop(mesh, place.h)) all.push_back(h.index);
        list.between(to.index, all, std::vector<double>(all.size(), 1.0 / static_cast<double>(all.size())));
    }
  });
  return list;
}

}  // namespace ryosen::subdivide
