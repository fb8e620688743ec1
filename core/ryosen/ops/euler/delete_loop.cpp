#include "ryosen/ops/euler/delete_loop.h"

#include <cassert>

#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/pinch.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter delete_loop_parameters[] = {with_words(
    {"face", "Face", "面", "the face that is deleted", "取り除く面"}, required(face<&DeleteLoop::face>("fN")))};

}  // namespace

constinit const OpInfo DeleteLoop::info{.id = "delete_loop",
                                        .name_en = "Delete loop",
                                        .name_ja = "ループ消去",
                                        .line = {.lists = {delete_loop_parameters}},
                                        .help_en = "deletes a face but keeps its edges",
                                        .help_ja = "面だけを取り除き、稜線は残す",
                                        .target = OpTargetKind::face,
                                        .group = OpGroup::euler,
                                        .aliases = "kf"};

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
  return {.deleted = {face}};
}

}  // namespace ryosen
