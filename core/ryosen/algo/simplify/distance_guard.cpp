#include "ryosen/algo/simplify/distance_guard.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <utility>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

constexpr std::size_t most_pieces = 256;

bool are_finite(const TriangleCorners& corners) {
  return is_finite(corners[0]) && is_finite(corners[1]) && is_finite(corners[2]);
}

// The bound of surface_distance() is up to a millionth more than the distance, or 2e-10 of the largest coordinate,
// whichever is more.
double provable(double most, double reach) { return std::min(most / (1 + 1.1e-6), most - 2.5e-10 * (reach + most)); }

double reach_of(const Mesh& mesh) {
  double reach = 0;
  for (const Vertex v : live_vertices(mesh))
    if (const glm::dvec3& p = mesh.position(v); is_finite(p))
      reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return reach;
}

}  // namespace

DistanceGuard::DistanceGuard(const Mesh& mesh, const ScaledPlaces& scale, double most)
    : mesh_(mesh),
      scale_(scale),
      most_(provable(scale.scaled_length(most), scale.scaled_length(reach_of(mesh)))),
      places_(mesh.vertex_slots()),
      first_of_face_(mesh.face_slots(), no_index),
      bounds_(mesh.face_slots()),
      marks_(mesh.face_slots()) {
  for (const Vertex v : live_vertices(mesh)) places_[v.index] = scale.scaled(mesh.position(v));
  for (const Face f : live_faces(mesh)) {
    const bool is_plain = is_triangle(mesh, mesh.halfedge(f)) && !mesh.has_rings(f);
    assert(is_plain);
    if (!is_plain || !are_finite(ryosen::corners_of(mesh, mesh.halfedge(f)))) continue;
    std::array<std::uint32_t, 3>& triangle = triangles_.emplace_back();
    std::size_t i = 0;
    for (const Vertex v : vertices_around(mesh, f)) triangle[i++] = v.index;
    first_of_triangle_.push_back(no_index);
    list_at(f, static_cast<std::uint32_t>(triangles_.size() - 1));
  }
  input_marks_.resize(triangles_.size());
  point_marks_.resize(places_.size());
  inner_marks_.resize(places_.size());
  refused_.resize(std::bit_ceil(std::size_t{mesh.edge_slots()} + 1));
}

TriangleCorners DistanceGuard::corners_of(Face f) const {
  TriangleCorners corners = ryosen::corners_of(mesh_, mesh_.halfedge(f));
  for (glm::dvec3& corner : corners) corner = scale_.scaled(corner);
  return corners;
}

TriangleCorners DistanceGuard::corners_of_input(std::uint32_t triangle) const {
  const auto& [a, b, c] = triangles_[triangle];
  return {places_[a], places_[b], places_[c]};
}

void DistanceGuard::mark_changing(Face f) {
  marks_[f.index] = step_;
  ++marked_;
  old_.push_back(f);
  const TriangleCorners corners = corners_of(f);
  if (are_finite(corners)) old_targets_.push_back(target_of(corners, bounds_[f.index]));
}

void DistanceGuard::add_target(Face f, const TriangleCorners& corners) {
  if (!are_finite(corners)) return;
  targets_.push_back(target_of(corners, 0));
  owners_.push_back(f);
}

void DistanceGuard::add_changed(Face f, const TriangleCorners& corners) {
  if (!are_finite(corners)) return;
  changed_.push_back({f, corners});
  add_target(f, corners);
}

void DistanceGuard::begin_question() {
  if (++step_ == 0) {
    std::fill(marks_.begin(), marks_.end(), 0);
    std::fill(input_marks_.begin(), input_marks_.end(), 0);
    std::fill(point_marks_.begin(), point_marks_.end(), 0);
    std::fill(inner_marks_.begin(), inner_marks_.end(), 0);
    step_ = 1;
  }
  old_.clear(), changed_.clear(), targets_.clear(), owners_.clear();
  old_targets_.clear(), listed_targets_.clear(), both_targets_.clear();
  new_inner_.clear(), old_inner_.clear();
  listed_.clear(), near_faces_.clear();
}

void DistanceGuard::find_listed() {
  for (const Face f : old_)
    for (std::uint32_t e = first_of_face_[f.index]; e != no_index; e = entries_[e].next_of_face) {
      const std::uint32_t triangle = entries_[e].triangle;
      if (std::exchange(input_marks_[triangle], step_) == step_) continue;
      listed_.push_back({triangle});
      if (triangle == last_far_) std::swap(listed_.front(), listed_.back());
    }
}

std::span<const NearTarget> DistanceGuard::listed_targets() {
  if (listed_targets_.empty())
    for (const Listed& listed : listed_) listed_targets_.push_back(target_of(corners_of_input(listed.triangle), 0));
  return listed_targets_;
}

bool DistanceGuard::are_faces_plainly_far() {
  const auto is_far = [&](const glm::dvec3& p) {
    return proof_.distance(p, old_targets_, most_) > most_ && proof_.distance(p, listed_targets(), most_) > most_;
  };
  if (changed_.empty()) return false;
  if (is_far(changed_.front().corners[0])) return true;
  return std::any_of(changed_.begin(), changed_.end(), [&](const Changed& changed) {
    const auto& [a, b, c] = changed.corners;
    return is_far(0.5 * a + 0.5 * b) || is_far((a + b + c) / 3.0);
  });
}

bool DistanceGuard::is_input_plainly_far() {
  const std::size_t common = targets_.size();
  for (const Listed& listed : listed_) {
    bool is_far = false;
    for (const std::uint32_t v : triangles_[listed.triangle]) {
      if (point_marks_[v] == step_) continue;
      point_marks_[v] = step_;
      if (proof_.distance(places_[v], targets_, most_) <= most_) continue;
      if (targets_.size() == common) add_others(listed.triangle);
      is_far = is_far || proof_.distance(places_[v], std::span(targets_).subspan(common), most_) > most_;
    }
    targets_.resize(common), owners_.resize(common);
    if (is_far) last_far_ = listed.triangle;
    if (is_far) return true;
  }
  return false;
}

// Adds the faces at which a triangle of the input is listed and that stay.
void DistanceGuard::add_others(std::uint32_t triangle) {
  for (std::uint32_t e = first_of_triangle_[triangle]; e != no_index; e = entries_[e].next_of_triangle)
    if (const Face f(entries_[e].face);
        !is_marked(f.index) && std::find(owners_.begin(), owners_.end(), f) == owners_.end())
      add_target(f, corners_of(f));
}

bool DistanceGuard::prove_input() {
  const std::size_t common = targets_.size();
  for (Listed& listed : listed_) {
    add_others(listed.triangle);
    const bool is_near =
        proof_.prove(corners_of_input(listed.triangle), targets_, new_inner_, {most_, most_pieces, most_});
    listed.begin = near_faces_.size();
    for (const std::uint32_t target : proof_.used()) near_faces_.push_back(owners_[target]);
    listed.end = near_faces_.size();
    targets_.resize(common), owners_.resize(common);
    if (is_near) continue;
    last_far_ = listed.triangle;
    return false;
  }
  return true;
}

bool DistanceGuard::prove_faces() {
  return std::all_of(changed_.begin(), changed_.end(), [&](Changed& changed) { return prove_face(changed); });
}

// Tries the faces before first, which are few, and all that is known last.
bool DistanceGuard::prove_face(Changed& changed) {
  changed.bound = overlay_.bound(changed.corners, old_targets_, most_);
  if (changed.bound <= most_) return true;
  changed.bound = overlay_.bound(changed.corners, listed_targets(), most_);
  if (changed.bound <= most_) return true;
  if (both_targets_.empty()) {
    both_targets_ = old_targets_;
    both_targets_.insert(both_targets_.end(), listed_targets().begin(), listed_targets().end());
    listed_inner_.assign(old_inner_.begin(), old_inner_.end());
    for (const Listed& listed : listed_)
      for (const std::uint32_t v : triangles_[listed.triangle])
        if (std::exchange(inner_marks_[v], step_) != step_) listed_inner_.push_back(places_[v]);
  }
  const bool is_near =
      proof_.prove(changed.corners, both_targets_, listed_inner_, {most_, most_pieces + 8 * listed_.size()});
  changed.bound = proof_.bound();
  return is_near;
}

bool DistanceGuard::may_exceed() {
  if (!(most_ > 0) || old_.size() > most_changed) return true;
  find_listed();
  return are_faces_plainly_far() || is_input_plainly_far() || !prove_faces() || !prove_input();
}

void DistanceGuard::follow() {
  for (const Listed& listed : listed_) take_out_of_lists(listed);
  for (const Listed& listed : listed_)
    for (std::size_t i = listed.begin; i < listed.end; ++i)
      if (near_faces_[i]) list_at(near_faces_[i], listed.triangle);
  for (const Changed& changed : changed_) bounds_[changed.face.index] = changed.bound;
}

void DistanceGuard::take_out_of_lists(const Listed& listed) {
  const auto begin = near_faces_.begin() + static_cast<std::ptrdiff_t>(listed.begin),
             end = near_faces_.begin() + static_cast<std::ptrdiff_t>(listed.end);
  for (std::uint32_t e = std::exchange(first_of_triangle_[listed.triangle], no_index); e != no_index;) {
    Entry& entry = entries_[e];
    const std::uint32_t next = entry.next_of_triangle;
    const auto again = is_marked(entry.face) ? end : std::find(begin, end, Face(entry.face));
    if (again != end) {
      *again = Face();
      entry.next_of_triangle = std::exchange(first_of_triangle_[listed.triangle], e);
    } else {
      drop(e);
    }
    e = next;
  }
}

void DistanceGuard::drop(std::uint32_t entry) {
  const std::uint32_t face = entries_[entry].face, next = entries_[entry].next_of_face,
                      previous = entries_[entry].previous_of_face;
  (previous == no_index ? first_of_face_[face] : entries_[previous].next_of_face) = next;
  if (next != no_index) entries_[next].previous_of_face = previous;
  entries_[entry].next_of_face = std::exchange(free_entry_, entry);
  --used_entries_;
}

void DistanceGuard::list_at(Face face, std::uint32_t triangle) {
  std::uint32_t e = free_entry_;
  if (e == no_index) {
    e = static_cast<std::uint32_t>(entries_.size());
    entries_.emplace_back();
  } else {
    free_entry_ = entries_[e].next_of_face;
  }
  const std::uint32_t next = std::exchange(first_of_face_[face.index], e);
  if (next != no_index) entries_[next].previous_of_face = e;
  entries_[e] = {triangle, face.index, next, no_index, std::exchange(first_of_triangle_[triangle], e)};
  ++used_entries_;
}

}  // namespace ryosen
