#include "ryosen/ops/euler/unite_loop.h"

#include <algorithm>
#include <cassert>

#include "ryosen/mesh/copies.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/local_facts.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter unite_loop_parameters[] = {
    with_words({"edge", "Edge", "稜線", "the edge between the two faces", "二つの面の間の稜線"},
               required(edge<&UniteLoop::halfedge>("A-B")))};

}  // namespace

constinit const OpInfo UniteLoop::info{.id = "unite_loop",
                                       .name_en = "Unite loops",
                                       .name_ja = "ループ結合",
                                       .line = {.lists = {unite_loop_parameters}},
                                       .help_en = "unites the two faces at an edge into one",
                                       .help_ja = "稜線の両側の面を一つにまとめる",
                                       .target = OpTargetKind::edge,
                                       .group = OpGroup::euler,
                                       .aliases = "kef",
                                       .topology = Topology::kept,
                                       .in_series = unites_loops_in_series};

namespace {

// The loops of the united face: the two loops at the edge joined without it, and all other loops of both.
CornerLoops list_after(const Mesh& mesh, Halfedge h) {
  CornerLoops after;
  std::vector<std::uint32_t> joined;
  for (Halfedge side : {h, twin(h)})
    for (Halfedge g = mesh.next(side); g != side; g = mesh.next(g)) joined.push_back(point(mesh, mesh.from(g)).index);
  after.add(joined);
  for (Halfedge side : {h, twin(h)}) {
    const std::uint32_t own = ring_of(mesh, side);
    if (own != no_index) after.add(points_along(mesh, mesh.halfedge(mesh.face(side))));
    for (std::uint32_t r = mesh.first_ring(mesh.face(side)); r != no_index; r = mesh.ring(r).next)
      if (r != own) after.add(points_along(mesh, mesh.ring(r).halfedge));
  }
  return after;
}

}  // namespace

Verdict UniteLoop::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, halfedge, verdict)) return verdict;
  const Face f = mesh.face(halfedge), g = mesh.face(twin(halfedge));
  if (!f || !g) verdict.refuse(Rule::boundary, {edge(halfedge)});
  if (f && f == g) verdict.refuse(Rule::same_face, {edge(halfedge), f});
  if (is_cut_on_points(mesh, halfedge))
    verdict.refuse(Rule::copies, {point(mesh, mesh.from(halfedge)), point(mesh, mesh.to(halfedge))});
  if (!verdict.legal()) return verdict;
  const CornerLoops after = list_after(mesh, halfedge);
  const auto parts = take_out_bridges(after);
  // Existing bridges stay; a second shared edge would become a new bridge, which is not allowed.
  if (!parts || parts->size() - after.ends.size() != bridges_of(loops_of(mesh, f)) + bridges_of(loops_of(mesh, g)))
    return refused_by(Rule::loop, {f, g});
  for (Face face : {f, g})
    if (const Face other = equal_face(mesh, face); other && other != f && other != g)
      verdict.refuse(Rule::loses_duplicate, {face, other});
  const Face except[] = {f, g};
  if (const Face other = face_on(mesh, point_set(after.corners), except))
    verdict.refuse(Rule::duplicate_face, {std::min(f, g), other});
  return verdict;
}

Verdict UniteLoop::check(const Mesh& mesh, LocalFacts& known) const {
  if (is_there(mesh, halfedge) && unite_plainly(mesh, halfedge, known)) return {};
  return check(mesh);
}

std::vector<Reason> UniteLoop::warnings(const Mesh& mesh) const {
  if (!is_seam(mesh, halfedge)) return {};
  return {{Rule::seam, {edge(halfedge)}}};
}

OpEffect UniteLoop::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  const Edge united[] = {edge(halfedge)};
  merge_corner_values(edit, united);
  const Face stays = std::min(m.face(halfedge), m.face(twin(halfedge)));
  return {.deleted = {united[0], unite_faces(edit, {&halfedge, 1})}, .changed = {stays}};
}

}  // namespace ryosen
