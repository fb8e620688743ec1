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

bool LocalFacts::touches(const Mesh& mesh, Face f, Vertex v, std::uint64_t& looks) {
  constexpr std::uint32_t large = 32;
  ++looks;
  const std::uint32_t corners = corner_count(mesh, f);
  if (corners < large) return ryosen::touches(mesh, f, v);
  const auto [points, is_new] = points_.try_emplace(f);
  if (is_new) {
    looks += corners;
    for (const Vertex corner : vertices_around(mesh, f)) points->second.insert(point(mesh, corner));
  }
  return points->second.contains(point(mesh, v));
}

void LocalFacts::forget(Face f) {
  one_simple_loop_.erase(f);
  equal_face_.erase(f);
  corner_count_.erase(f);
  points_.erase(f);
}

void LocalFacts::collapses(const Mesh& mesh, Halfedge h) {
  equal_face_.clear();
  points_.clear();
  for (const Face f : {mesh.face(h), mesh.face(twin(h))}) {
    if (!f) continue;
    corner_count_.erase(f);
    if (const auto simple = one_simple_loop_.find(f); simple != one_simple_loop_.end() && !simple->second)
      one_simple_loop_.erase(simple);
  }
}

void LocalFacts::lost_corner(Face f) {
  points_.erase(f);
  equal_face_[f] = false;
  --corner_count_[f];
}

void LocalFacts::unites(const Mesh& mesh, Face stays, Face goes) {
  const auto points = points_.find(stays);
  if (points == points_.end()) return;
  for (const Vertex corner : vertices_around(mesh, goes)) points->second.insert(point(mesh, corner));
}

void LocalFacts::united(Face stays, Face goes, std::uint32_t corners, std::span<const Vertex> left_out) {
  forget(goes);
  one_simple_loop_[stays] = true;
  equal_face_[stays] = false;
  corner_count_[stays] = corners;
  const auto points = points_.find(stays);
  if (points == points_.end()) return;
  for (const Vertex v : left_out) points->second.erase(v);
}

}  // namespace ryosen
