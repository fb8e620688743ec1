#include "ryosen/ops/euler/delete_loop.h"

#include <cassert>

#include "ryosen/ops/rules/pinch.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

Verdict DeleteLoop::check(const Mesh& mesh) const {
  Verdict verdict;
  is_gone(mesh, face, verdict);
  return verdict;
}

std::vector<Reason> DeleteLoop::warnings(const Mesh& mesh) const {
  std::vector<Reason> reasons;
  const Face faces[] = {face};
  warn_of_pinch(pinched_without(mesh, faces), reasons);
  return reasons;
}

OpEffect DeleteLoop::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  take_face_away(edit, face);
  OpEffect effect;
  effect.deleted.push_back(face);
  return effect;
}

}  // namespace ryosen
