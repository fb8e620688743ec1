#include "ryosen/ops/euler/make_ring.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "ryosen/geometry/locate.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter make_ring_parameters[] = {
    with_words({"edge", "Edge", "稜線", "the bridge that is taken away", "取り除く橋の稜線"},
               required(edge<&MakeRing::halfedge>("A-B")))};

}  // namespace

constinit const OpInfo MakeRing::info{.id = "make_ring",
                                      .name_en = "Make ring",
                                      .name_ja = "リング生成",
                                      .line = {.lists = {make_ring_parameters}},
                                      .help_en = "takes a bridge away and makes the inner loop a ring of the face",
                                      .help_ja = "橋の稜線を取り除き、内側のループを面のリングにする",
                                      .target = OpTargetKind::edge,
                                      .group = OpGroup::euler,
                                      .aliases = "kemr",
                                      .topology = Topology::kept};

namespace {

Vertex smallest_vertex(const Mesh& mesh, Halfedge start) {
  Vertex smallest = mesh.from(start);
  for (Halfedge h : loop(mesh, start)) smallest = std::min(smallest, mesh.from(h));
  return smallest;
}

// Whether the first of two loops is the outer one, for a face with this normal.
bool is_outer(const Mesh& mesh, Halfedge first, Halfedge second, const glm::dvec3& normal) {
  const double a = std::abs(projected_area(places_along(mesh, first), normal));
  const double b = std::abs(projected_area(places_along(mesh, second), normal));
  return a != b ? a > b : smallest_vertex(mesh, first) < smallest_vertex(mesh, second);
}

}  // namespace

Verdict MakeRing::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, halfedge, verdict)) return verdict;
  // By the invariants every bridge splits a loop in two, so nothing else needs checking.
  if (!is_bridge(mesh, halfedge)) verdict.refuse(Rule::no_bridge, {edge(halfedge)});
  return verdict;
}

OpEffect MakeRing::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  const Face f = m.face(halfedge);
  const glm::dvec3 normal = polygon_normal(FacePolygon(m, f).keyhole_walk());
  const std::uint32_t ring = ring_of(m, halfedge);
  const Halfedge start = ring == no_index ? m.halfedge(f) : m.ring(ring).halfedge;
  const Halfedge first = m.next(halfedge), second = m.next(twin(halfedge));
  const Vertex a = m.from(halfedge), b = m.to(halfedge);
  unlink_edge(edit, halfedge);
  hold_outside(edit, a);
  hold_outside(edit, b);
  const bool first_is_outer = ring == no_index && is_outer(m, first, second, normal);
  const Halfedge known = first_is_outer ? first : second, inner = first_is_outer ? second : first;
  // Keep the stored start of the loop if possible: the first corner in the file is part of the data.
  Halfedge keeps = known;
  for (Halfedge h : loop(m, known))
    if (h == start) keeps = start;
  if (ring == no_index)
    edit.set_halfedge(f, keeps);
  else
    edit.set_ring_halfedge(ring, keeps);
  edit.add_ring(f, inner);
  return {.deleted = {edge(halfedge)}, .changed = {f}};
}

}  // namespace ryosen
