#include "core/ops/reverse.h"

#include <cassert>
#include <utility>

#include "core/analysis/components.h"
#include "core/ops/rules/turn_faces.h"

namespace ryosen {

Verdict Reverse::check(const Mesh& mesh) const {
  Verdict verdict;
  is_gone(mesh, face, verdict);
  return verdict;
}

OpEffect Reverse::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  Neighbourhood around(m, Neighbourhood::Reach::whole);
  const FaceComponents components = find_face_components(around);
  std::vector<bool> turned(m.face_slots(), false);
  for (std::uint32_t i = 0; i < m.face_slots(); ++i) {
    turned[i] = m.is_alive(Face(i)) && components.of_face[i] == components.of_face[face.index];
  }
  TurnedMesh result = turn_faces(m, turned);
  edit.replace(std::move(result.columns));
  return result.effect;
}

}  // namespace ryosen
