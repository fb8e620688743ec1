#include "ryosen/scene/pick/hidden_elements.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

using Parts = HiddenElements::Parts;

bool is_live_wire(const Mesh& mesh, Edge e) { return mesh.exists(e) && mesh.is_alive(e) && mesh.is_wire(e); }
bool is_live_isolated(const Mesh& mesh, Vertex v) { return mesh.exists(v) && mesh.is_alive(v) && mesh.is_isolated(v); }

// Faces, wires and isolated vertices at an element.
void add_at(const Mesh& mesh, Edge e, Parts& parts) {
  if (mesh.is_wire(e)) return parts.wires.push_back(e);
  for (const Halfedge h : {halfedge(e), twin(halfedge(e))})
    if (mesh.face(h)) parts.faces.push_back(mesh.face(h));
}
void add_at(const Mesh& mesh, Vertex v, Parts& parts) {
  for_each_copy(mesh, v, [&](Vertex copy) {
    if (mesh.is_isolated(copy)) return parts.isolated.push_back(copy);
    for (const Halfedge h : outgoing(mesh, copy)) add_at(mesh, edge(h), parts);
  });
}
Parts parts_at(const Mesh& mesh, std::span<const Element> elements) {
  Parts parts;
  for (const Element& e : elements) {
    if (e.kind == Element::Kind::face) parts.faces.push_back(e.face());
    if (e.kind == Element::Kind::vertex) add_at(mesh, e.vertex(), parts);
    if (e.kind != Element::Kind::edge && e.kind != Element::Kind::halfedge) continue;
    const auto [a, b] = ends(mesh, e.kind == Element::Kind::edge ? e.edge() : edge(e.halfedge()));
    for (const Halfedge sheet : sheets_between(mesh, a, b)) add_at(mesh, edge(sheet), parts);
  }
  return parts;
}

// Makes `now` the members, and returns those that came or went.
template <class Handle>
std::vector<Handle> exchange(IndexSet& members, IndexSet now) {
  std::vector<Handle> changed;
  now.for_each([&](std::uint32_t i) {
    if (!members.contains(i)) changed.emplace_back(i);
  });
  members.for_each([&](std::uint32_t i) {
    if (!now.contains(i)) changed.emplace_back(i);
  });
  members = std::move(now);
  return changed;
}

template <class Handle>
void insert_all(IndexSet& members, std::vector<Handle>& handles) {
  std::erase_if(handles, [&](Handle each) { return !members.insert(each.index); });
}

// All that are so, but for some.
template <class Handle, class Is>
IndexSet all_but(const std::vector<Handle>& some, std::uint32_t slots, Is is) {
  IndexSet all;
  for (std::uint32_t i = 0; i < slots; ++i)
    if (is(Handle(i))) all.insert(i);
  for (const Handle each : some) all.erase(each.index);
  return all;
}

std::uint64_t next_revision() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

}  // namespace

Parts HiddenElements::noted(Parts changed) {
  if (!changed.empty()) revision_ = next_revision();
  return changed;
}

Parts HiddenElements::hide(const Mesh& mesh, std::span<const Element> elements) {
  Parts parts = parts_at(mesh, elements);
  insert_all(faces_, parts.faces);
  insert_all(wires_, parts.wires);
  insert_all(isolated_, parts.isolated);
  return noted(std::move(parts));
}

Parts HiddenElements::isolate(const Mesh& mesh, std::span<const Element> elements) {
  const Parts kept = parts_at(mesh, elements);
  return noted(
      {exchange<Face>(faces_, all_but(kept.faces, mesh.face_slots(), [&](Face f) { return mesh.is_alive(f); })),
       exchange<Edge>(wires_, all_but(kept.wires, mesh.edge_slots(), [&](Edge e) { return is_live_wire(mesh, e); })),
       exchange<Vertex>(isolated_, all_but(kept.isolated, mesh.vertex_slots(),
                                           [&](Vertex v) { return is_live_isolated(mesh, v); }))});
}

Parts HiddenElements::show_all() {
  return noted({exchange<Face>(faces_, {}), exchange<Edge>(wires_, {}), exchange<Vertex>(isolated_, {})});
}

void HiddenElements::follow(const Mesh& mesh, const TouchedElements& touched) {
  if (empty()) return;
  revision_ = next_revision();
  if (touched.everything) {
    *this = HiddenElements();
    return;
  }
  for (const Face f : touched.faces)
    if (!mesh.exists(f) || !mesh.is_alive(f)) faces_.erase(f.index);
  for (const Halfedge h : touched.halfedges)
    if (!is_live_wire(mesh, edge(h))) wires_.erase(edge(h).index);
  for (const Vertex v : touched.vertices)
    if (!is_live_isolated(mesh, v)) isolated_.erase(v.index);
}

bool HiddenElements::hides_sheet(const Mesh& mesh, Edge e) const {
  if (mesh.is_wire(e)) return wires_.contains(e.index);
  const Face left = mesh.face(halfedge(e)), right = mesh.face(twin(halfedge(e)));
  return (!left || hides(mesh, left)) && (!right || hides(mesh, right));
}

bool HiddenElements::hides_copy(const Mesh& mesh, Vertex v) const {
  if (mesh.is_isolated(v)) return isolated_.contains(v.index);
  for (const Halfedge h : outgoing(mesh, v))
    if (!hides_sheet(mesh, edge(h))) return false;
  return true;
}

bool HiddenElements::hides(const Mesh& mesh, Vertex v) const {
  return !empty() && !any_of_copies(mesh, v, [&](Vertex copy) { return !hides_copy(mesh, copy); });
}

bool HiddenElements::hides(const Mesh& mesh, Edge e) const {
  if (empty()) return false;
  const auto [a, b] = ends(mesh, e);
  if (!has_copies(mesh, a) && !has_copies(mesh, b)) return hides_sheet(mesh, e);
  const std::vector<Halfedge> sheets = sheets_between(mesh, a, b);
  return std::all_of(sheets.begin(), sheets.end(), [&](Halfedge h) { return hides_sheet(mesh, edge(h)); });
}

std::vector<Element> HiddenElements::elements() const {
  std::vector<Element> all;
  faces_.for_each([&](std::uint32_t i) { all.emplace_back(Face(i)); });
  wires_.for_each([&](std::uint32_t i) { all.emplace_back(Edge(i)); });
  isolated_.for_each([&](std::uint32_t i) { all.emplace_back(Vertex(i)); });
  return all;
}

}  // namespace ryosen
