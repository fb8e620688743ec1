#include "ryosen/ops/rules/local_facts.h"

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/face_lists.h"

namespace ryosen {

bool LocalFacts::has_several_fans(const Mesh& mesh, Vertex v) {
  const auto [known, is_new] = several_fans_.try_emplace(v);
  if (is_new) known->second = ryosen::has_several_fans(mesh, v);
  return known->second;
}

bool LocalFacts::is_one_simple_loop(const Mesh& mesh, Face f) {
  const auto [known, is_new] = one_simple_loop_.try_emplace(f);
  if (is_new) known->second = ryosen::is_one_simple_loop(mesh, f);
  return known->second;
}

bool LocalFacts::has_equal_face(const Mesh& mesh, Face f) {
  const auto [known, is_new] = equal_face_.try_emplace(f);
  if (is_new) known->second = bool(equal_face(mesh, f));
  return known->second;
}

std::uint32_t LocalFacts::corner_count(const Mesh& mesh, Face f, bool* is_new_too) {
  const auto [known, is_new] = corner_count_.try_emplace(f);
  if (is_new_too) *is_new_too = is_new;
  if (is_new) known->second = ryosen::corner_count(mesh, f);
  return known->second;
}

void LocalFacts::forget(Face f) {
  one_simple_loop_.erase(f);
  equal_face_.erase(f);
  corner_count_.erase(f);
}

void LocalFacts::lost_corner(Face f) {
  equal_face_[f] = false;
  --corner_count_[f];
}

void LocalFacts::united(Face stays, Face goes, std::uint32_t corners) {
  forget(goes);
  one_simple_loop_[stays] = true;
  equal_face_[stays] = false;
  corner_count_[stays] = corners;
}

}  // namespace ryosen
