#include "ryosen/ops/reverse.h"

#include <cassert>
#include <utility>

#include "ryosen/analysis/components.h"
#include "ryosen/base/index_set.h"
#include "ryosen/ops/lines/arguments.h"
#include "ryosen/ops/rules/turn_faces.h"

namespace ryosen {

Parsed<Reverse> Reverse::parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
  ArgumentReader in(mesh, arguments, info.syntax);
  Reverse op{{in.face()}};
  while (!in.at_end() && !in.failed()) op.faces.push_back(in.face());
  return in.result(op);
}

std::string Reverse::command(const Mesh& mesh) const {
  std::string text(info.id);
  for (const Face f : faces) text += " " + name_of(mesh, f);
  return text;
}

Verdict Reverse::check(const Mesh& mesh) const {
  Verdict verdict;
  if (faces.empty()) verdict.refuse(Rule::deleted, {Face()});
  for (const Face f : faces)
    if (is_gone(mesh, f, verdict)) break;
  return verdict;
}

OpEffect Reverse::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  Neighbourhood around(m, Neighbourhood::Reach::whole);
  const FaceComponents components = find_face_components(around);
  IndexSet turning;
  for (const Face f : faces) turning.insert(components.of_face[f.index]);
  std::vector<bool> turned(m.face_slots(), false);
  for (std::uint32_t i = 0; i < m.face_slots(); ++i)
    turned[i] = m.is_alive(Face(i)) && turning.contains(components.of_face[i]);
  TurnedMesh result = turn_faces(m, turned);
  edit.replace(std::move(result.columns));
  return result.effect;
}

}  // namespace ryosen
