#include "ryosen/ops/euler/unite_ring.h"

#include <cassert>

#include "ryosen/mesh/copies.h"
#include "ryosen/ops/lines/arguments.h"
#include "ryosen/ops/rules/face_corners.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

Parsed<UniteRing> UniteRing::parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
  ArgumentReader in(mesh, arguments, info.syntax);
  const FaceCorners corners = read_face_corners(mesh, in);
  return in.result(UniteRing{corners.into_a, corners.into_b});
}

std::string UniteRing::command(const Mesh& mesh) const {
  return "unite_ring " + face_corners_text(mesh, {into_a, into_b});
}

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
  OpEffect effect;
  effect.created.push_back(edge(h));
  effect.changed.push_back(f);
  return effect;
}

}  // namespace ryosen
