#include "ryosen/ops/rules/local_facts.h"

#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/faces_at.h"
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

namespace {

// Whether a third face may lie on the points of two: it is at one of them, has as many corners, and each of its own
// touches one of the two.
bool may_lie_on_both(const Mesh& m, Face third, Face f, Face g, std::uint32_t corners, LocalFacts& known,
                     std::uint64_t& looks) {
  if (third == f || third == g || known.corner_count(m, third) < corners) return false;
  for (const Vertex v : vertices_around(m, third))
    if (!known.touches(m, f, v, looks) && !known.touches(m, g, v, looks)) return false;
  return true;
}

}  // namespace

Union judge_union(const Mesh& m, std::span<const Halfedge> chain, LocalFacts& known, std::uint64_t* looks) {
  std::uint64_t looked = 0;
  std::uint64_t& look = looks ? *looks : looked;
  const Face f = m.face(chain.front()), g = m.face(twin(chain.front()));
  for (const Face face : {f, g})
    if (!known.is_one_simple_loop(m, face) || known.has_equal_face(m, face)) return Union::unsure;
  const auto taken = static_cast<std::uint32_t>(2 * chain.size());
  const std::uint32_t both = known.corner_count(m, f) + known.corner_count(m, g);
  if (both < taken + 3) return Union::touching;
  const bool left_is_larger = known.corner_count(m, f) > known.corner_count(m, g);
  // The way of the smaller face past the chain, whose ends both have.
  const Halfedge from = left_is_larger ? twin(chain.front()) : chain.back(),
                 to = left_is_larger ? twin(chain.back()) : chain.front();
  const Face larger = left_is_larger ? f : g;
  std::vector<std::uint32_t> united{m.to(from).index, m.from(to).index};
  for (Halfedge corner = m.next(m.next(from)); corner != to && m.prev(corner) != to; corner = m.next(corner)) {
    if (known.touches(m, larger, m.from(corner), look)) return Union::touching;
    united.push_back(m.from(corner).index);
  }
  const bool is_unsure = any_of_faces_at(m, loneliest_point(m, united), [&](Face third) {
    return may_lie_on_both(m, third, f, g, both - taken, known, look);
  });
  return is_unsure ? Union::unsure : Union::plain;
}

bool unite_plainly(const Mesh& m, Halfedge h, LocalFacts& known) {
  const Face f = m.face(h), g = m.face(twin(h));
  if (!f || !g || f == g || is_cut_on_points(m, h)) return false;
  return judge_union(m, {&h, 1}, known) == Union::plain;
}

namespace {

// Whether another face may get the points that this one will have: it has the first few of them.
bool may_equal(const Mesh& m, Face other, const CornerChange& change, LocalFacts& known) {
  constexpr int few = 8;
  if (known.corner_count(m, other) < known.corner_count(m, change.face) || !touches(m, other, change.gains))
    return false;
  int asked = 0;
  for (Vertex v : vertices_around(m, change.face)) {
    if (v != change.loses && !touches(m, other, v)) return false;
    if (++asked == few) break;
  }
  return true;
}

}  // namespace

bool changes_plainly(const Mesh& m, const CornerChange& change, LocalFacts& known) {
  const Face f = change.face;
  if (!known.is_one_simple_loop(m, f) || known.has_equal_face(m, f) || touches(m, f, change.gains)) return false;
  const std::uint32_t both[] = {change.stays.index, change.gains.index};
  return !any_of_faces_at(m, loneliest_point(m, both), [&](Face other) {
    return other != f && other != change.beside && may_equal(m, other, change, known);
  });
}

}  // namespace ryosen
