#include "core/ops/reverse.h"

#include <cassert>
#include <utility>

#include "core/analysis/components.h"
#include "core/ops/lines/arguments.h"
#include "core/ops/rules/turn_faces.h"

namespace ryosen {

Parsed<Reverse> Reverse::parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
  ArgumentReader in(mesh, arguments, info.syntax);
  const Reverse op{in.face()};
  return in.result(op);
}

Reverse Reverse::at(const Mesh&, const OpTarget& target) { return {target.face}; }

std::string Reverse::command(const Mesh& mesh) const { return "reverse " + name_of(mesh, face); }

Verdict Reverse::check(const Mesh& mesh) const {
  Verdict verdict;
  is_gone(mesh, face, verdict);
  return verdict;
}

std::vector<Reason> Reverse::warnings(const Mesh&) const { return {}; }

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
