#include "ryosen/algo/subdivide/sqrt3_links.h"

#include <array>

#include "ryosen/algo/subdivide/ranks.h"

namespace ryosen::subdivide {

Sqrt3Numbers::Sqrt3Numbers(const Mesh& mesh, const Creases& creases, bool cuts_creases)
    : mesh_(mesh), creases_(creases), cuts_creases_(cuts_creases) {
  const std::uint32_t halfedges = mesh.halfedge_slots();
  cut_ = ranks(mesh.edge_slots(), [&](std::uint32_t i) { return is_cut(halfedge(Edge(i))); });
  centre_ = ranks(mesh.face_slots(), [&](std::uint32_t i) { return has_centre(Face(i)); });
  spoke_ = ranks(halfedges, [&](std::uint32_t i) {
    const Halfedge h(i), side = mesh.is_outside(h) ? Halfedge() : cut_side(h);
    return !mesh.is_outside(h) && (!side || side != mesh.prev(h));
  });
  other_ = ranks(halfedges, [&](std::uint32_t i) {
    const Halfedge h(i);
    return !mesh.is_outside(h) && mesh.halfedge(mesh.face(h)) != h;
  });
}

Halfedge Sqrt3Numbers::cut_side(Halfedge h) const {
  if (!cuts_creases_) return {};
  for (const Halfedge side : {h, mesh_.next(h), mesh_.prev(h)})
    if (is_kept(side)) return side;
  return {};
}

Vertex Sqrt3Numbers::third(Halfedge h, unsigned i) const {
  return Vertex(first_third() + 2 * cut_[edge(h).index] + ((h.index & 1u) ^ i));
}

// The first part of an edge keeps its number.
Halfedge Sqrt3Numbers::part(Halfedge h, unsigned i) const {
  const unsigned side = h.index & 1u, place = side == 0 ? i : 2 - i;
  if (place == 0) return h;
  return Halfedge(2 * (mesh_.edge_slots() + spoke_.back() + 2 * cut_[edge(h).index] + place - 1) + side);
}

Vertex Sqrt3Numbers::apex(Halfedge h) const {
  const Halfedge side = cut_side(h);
  if (!side) return centre(mesh_.face(h));
  return third(side, h == mesh_.next(side) ? 1 : 0);
}

Halfedge Sqrt3Numbers::before(Halfedge h) const {
  const Halfedge side = cut_side(h);
  if (!side) return twin(spoke(h));
  return h == mesh_.next(side) ? part(side, 2) : twin(spoke(h));
}

Halfedge Sqrt3Numbers::after(Halfedge h) const {
  const Halfedge side = cut_side(h);
  if (!side) return spoke(mesh_.next(h));
  return h == mesh_.next(side) ? spoke(side) : part(side, 0);
}

Face Sqrt3Numbers::triangle(Halfedge h) const {
  const Face f = mesh_.face(h);
  return mesh_.halfedge(f) == h ? f : Face(mesh_.face_slots() + other_[h.index]);
}

namespace {

class Sqrt3Linker {
 public:
  Sqrt3Linker(const Mesh& mesh, const Sqrt3Numbers& numbers, MeshColumns& out) : mesh_(mesh), n_(numbers), out_(out) {}

  void link() {
    out_.halfedges.assign(2 * n_.edge_slots(), HalfedgeLinks());
    out_.vertex_halfedge.resize(n_.vertex_slots());
    out_.face_halfedge.assign(n_.face_slots(), dead_halfedge);
    for_each_part(mesh_.edge_slots(), threads_for(mesh_.edge_slots()),
                  [&](unsigned, std::uint32_t begin, std::uint32_t end) {
                    for (Halfedge h(2 * begin); h.index < 2 * end; ++h.index)
                      mesh_.is_outside(h) ? link_outside(h) : link_triangle(h);
                  });
    link_vertices();
    const ElementCounts& live = mesh_.live();
    const auto added = static_cast<std::uint32_t>(n_.vertex_slots() - mesh_.vertex_slots());
    out_.live = {live.vertices + added, static_cast<std::uint32_t>(n_.edge_slots()),
                 live.faces + static_cast<std::uint32_t>(n_.face_slots() - mesh_.face_slots()), 0};
    out_.file_vertices = mesh_.file_vertices();
  }

 private:
  void write(Halfedge h, Vertex from, Halfedge next, Halfedge prev, Face f) {
    out_.halfedges[h.index] = {from, next, prev, f};
  }

  void write_triangle(std::array<Halfedge, 3> sides, std::array<Vertex, 3> corners, Face f) {
    for (unsigned i = 0; i < 3; ++i) write(sides[i], corners[i], sides[(i + 1) % 3], sides[(i + 2) % 3], f);
    out_.face_halfedge[f.index] = sides[0];
  }

  void link_triangle(Halfedge h) {
    const Face f = n_.triangle(h);
    const Vertex from = mesh_.from(h), to = mesh_.to(h);
    if (n_.is_cut(h)) {
      const Halfedge prev = mesh_.prev(h);
      write_triangle({n_.part(h, 1), twin(n_.spoke(h)), n_.spoke(prev)},
                     {n_.third(h, 0), n_.third(h, 1), mesh_.from(prev)}, f);
    } else if (n_.is_kept(h)) {
      write_triangle({h, n_.after(h), n_.before(h)}, {from, to, n_.apex(h)}, f);
    } else {
      const Halfedge t = twin(h);
      write_triangle({n_.after(t), h, n_.before(h)}, {from, n_.apex(t), n_.apex(h)}, f);
    }
  }

  // The first and the last part of a halfedge outside.
  Halfedge first_part(Halfedge h) const { return n_.is_cut(h) ? n_.part(h, 0) : h; }
  Halfedge last_part(Halfedge h) const { return n_.is_cut(h) ? n_.part(h, 2) : h; }

  void link_outside(Halfedge h) {
    const Halfedge next = first_part(mesh_.next(h)), prev = last_part(mesh_.prev(h));
    if (!n_.is_cut(h)) return write(h, mesh_.from(h), next, prev, Face());
    const Halfedge a = n_.part(h, 0), b = n_.part(h, 1), c = n_.part(h, 2);
    write(a, mesh_.from(h), b, prev, Face());
    write(b, n_.third(h, 0), c, a, Face());
    write(c, n_.third(h, 1), next, b, Face());
  }

  void link_vertices() {
    for (std::uint32_t i = 0; i < mesh_.vertex_slots(); ++i) {
      const Halfedge h = mesh_.halfedge(Vertex(i));
      out_.vertex_halfedge[i] = h && h != dead_halfedge ? leaving(h) : h;
    }
    for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i)
      if (const Face f(i); n_.has_centre(f))
        out_.vertex_halfedge[n_.centre(f).index] = twin(n_.spoke(mesh_.halfedge(f)));
    for (std::uint32_t i = 0; i < mesh_.edge_slots(); ++i) {
      const Halfedge even = halfedge(Edge(i)), h = mesh_.is_outside(twin(even)) ? twin(even) : even;
      if (!n_.is_cut(h)) continue;
      out_.vertex_halfedge[n_.third(h, 0).index] = n_.part(h, 1);
      out_.vertex_halfedge[n_.third(h, 1).index] = n_.part(h, 2);
    }
  }

  // One that leaves the start of h, outside if h is.
  Halfedge leaving(Halfedge h) const {
    if (mesh_.is_outside(h) || n_.is_cut(h)) return first_part(h);
    const Halfedge side = n_.cut_side(h);
    return side && side == mesh_.prev(h) ? twin(n_.part(side, 2)) : n_.spoke(h);
  }

  const Mesh& mesh_;
  const Sqrt3Numbers& n_;
  MeshColumns& out_;
};

}  // namespace

void link_sqrt3(const Mesh& mesh, const Sqrt3Numbers& numbers, MeshColumns& out) {
  Sqrt3Linker(mesh, numbers, out).link();
}

}  // namespace ryosen::subdivide
