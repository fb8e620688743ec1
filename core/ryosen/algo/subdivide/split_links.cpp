#include "ryosen/algo/subdivide/split_links.h"

#include "ryosen/algo/subdivide/ranks.h"

namespace ryosen::subdivide {

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

}  // namespace ryosen::subdivide
