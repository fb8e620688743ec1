#include "ryosen/algo/subdivide/level_links.h"

#include <array>

#include "ryosen/base/parallel.h"

namespace ryosen::subdivide {

namespace {

// For each i below `count` how many chosen ones come before it; one more entry holds how many there are.
template <class IsChosen>
std::vector<std::uint32_t> ranks(std::uint32_t count, const IsChosen& is_chosen) {
  const unsigned parts = threads_for(count);
  std::vector<std::uint32_t> found(std::size_t{count} + 1), sums(parts + 1, 0);
  for_each_part(count, parts, [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
    std::uint32_t n = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
      found[i] = n;
      n += is_chosen(i) ? 1u : 0u;
    }
    sums[t + 1] = n;
  });
  for (unsigned t = 0; t < parts; ++t) sums[t + 1] += sums[t];
  for_each_part(count, parts, [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; t > 0 && i < end; ++i) found[i] += sums[t];
  });
  found[count] = sums[parts];
  return found;
}

}  // namespace

SplitNumbers::SplitNumbers(const Mesh& mesh, Split split)
    : split_(split),
      vertices_(mesh.vertex_slots()),
      edges_(mesh.edge_slots()),
      faces_(mesh.face_slots()),
      live_faces_(mesh.live().faces) {
  const std::uint32_t halfedges = mesh.halfedge_slots();
  rank_ = ranks(halfedges, [&](std::uint32_t i) { return !mesh.is_outside(Halfedge(i)); });
  inside_count_ = rank_.back();
  if (inside_count_ == halfedges) rank_ = {};
  if (split == Split::into_four) return;
  if (live_faces_ != faces_) centre_of_ = ranks(faces_, [&](std::uint32_t i) { return mesh.is_alive(Face(i)); });
  const auto is_first = [&](std::uint32_t i) { return mesh.halfedge(mesh.face(Halfedge(i))).index == i; };
  child_ = ranks(halfedges, [&](std::uint32_t i) { return !mesh.is_outside(Halfedge(i)) && !is_first(i); });
  for_each_part(halfedges, threads_for(halfedges), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      if (mesh.is_outside(Halfedge(i))) continue;
      child_[i] = is_first(i) ? mesh.face(Halfedge(i)).index : child_[i] + faces_;
    }
  });
}

std::size_t SplitNumbers::vertex_slots() const {
  return std::size_t{vertices_} + edges_ + (split_ == Split::into_quads ? live_faces_ : 0);
}

std::size_t SplitNumbers::face_slots() const {
  return std::size_t{faces_} + inside_count_ - (split_ == Split::into_quads ? live_faces_ : 0);
}

namespace {

// The four or two records that come of one halfedge with a face.
void link_corner_of_four(const SplitNumbers& n, Halfedge h, const HalfedgeLinks& l, HalfedgeLinks* out) {
  const Halfedge inner = n.inner(h), next_inner = n.inner(l.next), prev_inner = n.inner(l.prev);
  const Face own = n.at_corner(h);
  out[first_half(h).index] = {l.from, twin(inner), second_half(l.prev), own};
  out[second_half(h).index] = {n.on_edge(h), first_half(l.next), twin(next_inner), n.at_corner(l.next)};
  out[inner.index] = {n.on_edge(l.prev), next_inner, prev_inner, l.face};
  out[twin(inner).index] = {n.on_edge(h), second_half(l.prev), first_half(h), own};
}

void link_corner_of_quads(const SplitNumbers& n, Halfedge h, const HalfedgeLinks& l, HalfedgeLinks* out) {
  const Halfedge inner = n.inner(h), next_inner = n.inner(l.next), prev_inner = n.inner(l.prev);
  const Face own = n.at_corner(h), behind = n.at_corner(l.next);
  out[first_half(h).index] = {l.from, inner, second_half(l.prev), own};
  out[second_half(h).index] = {n.on_edge(h), first_half(l.next), twin(inner), behind};
  out[inner.index] = {n.on_edge(h), twin(prev_inner), first_half(h), own};
  out[twin(inner).index] = {n.centre(l.face), second_half(h), next_inner, behind};
}

template <class Corner>
void link_halfedges(const Mesh& mesh, const SplitNumbers& n, MeshColumns& out, const Corner& link_corner) {
  HalfedgeLinks* const to = out.halfedges.data();
  for_each_part(mesh.edge_slots(), threads_for(mesh.edge_slots()),
                [&](unsigned, std::uint32_t begin, std::uint32_t end) {
                  for (Halfedge h(2 * begin); h.index < 2 * end; ++h.index) {
                    const HalfedgeLinks& l = mesh.links(h);
                    if (l.face) {
                      link_corner(n, h, l, to);
                      out.face_halfedge[n.at_corner(h).index] = first_half(h);
                      continue;
                    }
                    to[first_half(h).index] = {l.from, second_half(h), second_half(l.prev), Face()};
                    to[second_half(h).index] = {n.on_edge(h), first_half(l.next), first_half(h), Face()};
                  }
                  for (std::uint32_t e = begin; e < end; ++e) {
                    const Halfedge h = halfedge(Edge(e));
                    out.vertex_halfedge[n.on_edge(h).index] = second_half(mesh.is_outside(twin(h)) ? twin(h) : h);
                    if (mesh.is_outside(h)) out.vertex_halfedge[n.on_edge(h).index] = second_half(h);
                  }
                });
}

}  // namespace

void link_split(const Mesh& mesh, const SplitNumbers& n, MeshColumns& out) {
  const bool into_quads = n.split() == Split::into_quads;
  out.halfedges.resize(2 * n.edge_slots());
  out.vertex_halfedge.resize(n.vertex_slots());
  out.face_halfedge.resize(n.face_slots());
  into_quads ? link_halfedges(mesh, n, out, link_corner_of_quads) : link_halfedges(mesh, n, out, link_corner_of_four);
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const Halfedge h = mesh.halfedge(Vertex(i));
    out.vertex_halfedge[i] = h && h != dead_halfedge ? first_half(h) : h;
  }
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    const Face f(i);
    if (!mesh.is_alive(f)) {
      out.face_halfedge[i] = dead_halfedge;
      continue;
    }
    if (into_quads)
      out.vertex_halfedge[n.centre(f).index] = twin(n.inner(mesh.halfedge(f)));
    else
      out.face_halfedge[i] = n.inner(mesh.halfedge(f));
  }
  const ElementCounts& live = mesh.live();
  out.live = {live.vertices + live.edges + (into_quads ? live.faces : 0), static_cast<std::uint32_t>(n.edge_slots()),
              into_quads ? n.inside_count() : live.faces + n.inside_count(), 0};
  out.file_vertices = mesh.file_vertices();
}

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
  return Vertex(mesh_.vertex_slots() + centre_.back() + 2 * cut_[edge(h).index] + ((h.index & 1u) ^ i));
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
