#include "core/ops/euler/delete_loop.h"

#include <cassert>

#include "core/ops/lines/arguments.h"
#include "core/ops/rules/pinch.h"
#include "core/ops/rules/surgery.h"

namespace ryosen {

Parsed<DeleteLoop> DeleteLoop::parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
  ArgumentReader in(mesh, arguments, info.syntax);
  const DeleteLoop op{in.face()};
  return in.result(op);
}

DeleteLoop DeleteLoop::at(const Mesh&, const OpTarget& target) { return {target.face}; }

std::string DeleteLoop::command(const Mesh& mesh) const { return "delete_loop " + name_of(mesh, face); }

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
