#include "core/algo/simplify/crossing_guard.h"

#include <algorithm>

#include "core/geometry/box.h"
#include "core/geometry/predicates.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/view/frustum.h"

namespace ryosen {

namespace {

Primitive primitive_of(const Mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  for (Vertex v : vertices_around(mesh, f))
    if (!is_finite(mesh.position(v))) return {};
  return Primitive::triangle(mesh.from(h).index, mesh.to(h).index, mesh.from(mesh.prev(h)).index, f.index);
}

bool is_flat(const NumberedTriangle& t) { return are_collinear(t.places[0], t.places[1], t.places[2]); }

// Its six sides as planes.
Frustum around(const NumberedTriangle& t) {
  Box box;
  for (const glm::dvec3& p : t.places) box.add(p);
  Frustum sides;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 along{0.0};
    along[axis] = 1;
    sides.add({along, -box.lowest[axis]});
    sides.add({-along, box.highest[axis]});
  }
  return sides;
}

}  // namespace

CrossingGuard::CrossingGuard(const Mesh& mesh) : mesh_(mesh) {
  std::vector<Primitive> primitives(mesh.face_slots());
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i)
    if (const Face f(i); mesh.is_alive(f)) primitives[i] = primitive_of(mesh, f);
  tree_.build(mesh.positions(), std::move(primitives));
}

NumberedTriangle CrossingGuard::triangle(Face f) const {
  NumberedTriangle t;
  std::size_t i = 0;
  for (Vertex v : vertices_around(mesh_, f)) {
    t.places[i] = mesh_.position(v);
    t.numbers[i++] = point(mesh_, v).index;
  }
  return t;
}

bool CrossingGuard::collect(Halfedge h, const glm::dvec3& position, std::vector<Changed>& changed) const {
  const Vertex gone = mesh_.from(h), kept = mesh_.to(h);
  for (Halfedge end : {h, twin(h)}) {
    if (end != h && mesh_.position(kept) == position) continue;
    for (Halfedge corner : outgoing(mesh_, mesh_.from(end))) {
      const Face f = mesh_.face(corner);
      if (!f || f == mesh_.face(h) || f == mesh_.face(twin(h))) continue;
      NumberedTriangle t = triangle(f);
      const bool was_flat = is_flat(t);
      for (std::size_t i = 0; i < 3; ++i) {
        if (t.numbers[i] != point(mesh_, gone).index && t.numbers[i] != point(mesh_, kept).index) continue;
        t.numbers[i] = point(mesh_, kept).index;
        t.places[i] = position;
      }
      if (!is_flat(t))
        changed.push_back({f, t});
      else if (!was_flat)
        return false;
    }
  }
  return true;
}

bool CrossingGuard::meets_another(const Changed& one, const std::vector<Changed>& changed, Halfedge h) const {
  bool meets = false;
  tree_.visit_frustum(mesh_.positions(), around(one.triangle), [&](std::uint32_t slot) {
    const Face f(slot);
    if (meets || f == mesh_.face(h) || f == mesh_.face(twin(h)) ||
        std::any_of(changed.begin(), changed.end(), [&](const Changed& c) { return c.face == f; }))
      return;
    const NumberedTriangle other = triangle(f);
    meets = !is_flat(other) && meet_elsewhere(one.triangle, other);
  });
  return meets;
}

bool CrossingGuard::would_meet(Halfedge h, const glm::dvec3& position) const {
  std::vector<Changed> changed;
  if (!collect(h, position, changed)) return true;
  for (std::size_t i = 0; i < changed.size(); ++i)
    for (std::size_t k = i + 1; k < changed.size(); ++k)
      if (meet_elsewhere(changed[i].triangle, changed[k].triangle)) return true;
  return std::any_of(changed.begin(), changed.end(),
                     [&](const Changed& one) { return meets_another(one, changed, h); });
}

void CrossingGuard::follow(Vertex kept) {
  for (Face f : faces_around(mesh_, kept))
    if (f) tree_.insert(mesh_.positions(), f.index, primitive_of(mesh_, f));
  if (tree_.is_worn()) tree_.rebuild(mesh_.positions());
}

}  // namespace ryosen
