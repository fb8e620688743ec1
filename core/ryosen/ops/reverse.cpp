#include "ryosen/ops/reverse.h"

#include <cassert>
#include <utility>

#include "ryosen/analysis/components.h"
#include "ryosen/base/index_set.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/turn_faces.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter reverse_parameters[] = {
    with_words({"faces", "Faces", "面", "the faces whose components are flipped", "裏返す連結成分の面"},
               list(face<&Reverse::faces>("fN"), "fM"))};

}  // namespace

constinit const OpInfo Reverse::info{.id = "reverse",
                                     .name_en = "Reverse component",
                                     .name_ja = "成分の反転",
                                     .line = {.lists = {reverse_parameters}},
                                     .help_en = "flips all faces of the components of the named faces",
                                     .help_ja = "指定した面の連結成分の面をすべて裏返す",
                                     .target = OpTargetKind::face,
                                     .group = OpGroup::orient,
                                     .on_selection = OnSelection::all};

Verdict Reverse::check(const Mesh& mesh) const {
  Verdict verdict;
  any_is_gone(mesh, faces, verdict);
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
  Descent descent = edit.new_descent();
  TurnedMesh result = turn_faces(m, turned, &descent);
  edit.replace(std::move(result.columns), descent);
  return result.effect;
}

}  // namespace ryosen
