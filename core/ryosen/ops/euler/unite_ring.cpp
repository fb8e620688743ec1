#include "ryosen/ops/euler/unite_ring.h"

#include <cassert>

#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/face_corners.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

constinit const OpInfo UniteRing::info{.id = "unite_ring",
                                       .name_en = "Unite ring",
                                       .name_ja = "リング結合",
                                       .line = {.lists = {face_corner_parameters},
                                                .read_rest = read_corners_of<UniteRing>,
                                                .print_rest = print_corners_of<UniteRing>},
                                       .help_en = "joins two loops of a face by a bridge",
                                       .help_ja = "一つの面の二つのループを橋の稜線でつなぐ",
                                       .target = OpTargetKind::selection,
                                       .group = OpGroup::euler,
                                       .aliases = "mekr",
                                       .topology = Topology::kept,
                                       .on_selection = OnSelection::all};

Verdict UniteRing::check(const Mesh& mesh) const {
  Verdict verdict;
  if (!are_corners_of_one_face(mesh, {into_a, into_b}, verdict)) return verdict;
  if (ring_of(mesh, into_a) == ring_of(mesh, into_b))
    verdict.refuse(Rule::same_loop, {mesh.face(into_a), mesh.to(into_a), mesh.to(into_b)});
  const std::vector<Halfedge> existing = sheets_between(mesh, mesh.to(into_a), mesh.to(into_b));
  if (!existing.empty()) verdict.refuse(Rule::edge_exists, {edge(existing.front())});
  return verdict;
}

OpEffect UniteRing::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  const Face f = m.face(into_a);
  // The outer loop keeps its start; of two rings the one of the second corner is removed.
  std::uint32_t gone = ring_of(m, into_b);
  if (gone == no_index) gone = ring_of(m, into_a);
  const Halfedge h = link_inside(edit, into_a, into_b);
  edit.remove_ring(f, gone);
  return {.created = {edge(h)}, .changed = {f}};
}

}  // namespace ryosen
