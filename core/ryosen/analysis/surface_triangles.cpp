#include "ryosen/analysis/surface_triangles.h"

#include <algorithm>
#include <atomic>

#include "ryosen/base/parallel.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/prefetch.h"

namespace ryosen {

namespace {

constexpr std::uint8_t all_sides = 7;

bool is_triangle(const Mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return mesh.next(mesh.next(mesh.next(h))) == h && !mesh.has_rings(f);
}

// Whether every live face is a triangle with finite corners. O(faces), on several threads.
bool has_finite_triangles_alone(const Mesh& mesh) {
  std::atomic<bool> has_other = false;
  const unsigned threads = threads_for(mesh.halfedge_slots()), parts = 8 * threads;
  for_each_task(parts, threads, [&](unsigned part) {
    const std::uint32_t faces = mesh.face_slots(), vertices = mesh.vertex_slots();
    for (std::uint32_t f = part_begin(faces, part, parts); f < part_begin(faces, part + 1, parts) && !has_other; ++f)
      if (mesh.is_alive(Face(f)) && !is_triangle(mesh, Face(f))) has_other = true;
    double nothing = 0;  // stays zero while all are finite
    for (std::uint32_t v = part_begin(vertices, part, parts); v < part_begin(vertices, part + 1, parts); ++v) {
      const glm::dvec3& p = mesh.position(Vertex(v));
      nothing += p.x * 0.0 + p.y * 0.0 + p.z * 0.0;
    }
    if (nothing != 0.0) has_other = true;
  });
  return !has_other;
}

}  // namespace

SurfaceTriangles::SurfaceTriangles(const Mesh& mesh) { rebuild(mesh); }

void SurfaceTriangles::rebuild(const Mesh& mesh) {
  stored_.clear();
  next_.clear();
  free_.clear();
  moved_out_.clear();
  homes_ = has_finite_triangles_alone(mesh) ? mesh.face_slots() : 0;
  first_.assign(mesh.face_slots() - homes_, no_index);
  if (homes_ != 0) return;
  const std::size_t expected = mesh.live().faces;
  stored_.reserve(expected);
  next_.reserve(expected);
  std::vector<std::uint32_t> ignored;
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_alive(Face(f))) fill(mesh, Face(f), ignored);
    ignored.clear();
  }
}

bool SurfaceTriangles::is_home(const Mesh& mesh, Face f) const {
  return f.index < homes_ && mesh.exists(f) && mesh.is_alive(f) &&
         (moved_out_.empty() || !moved_out_.contains(f.index));
}

SurfaceTriangle SurfaceTriangles::at(const Mesh& mesh, std::uint32_t slot) const {
  if (slot >= homes_) return stored_[slot - homes_];
  const Face f(slot);
  if (!is_home(mesh, f)) return {};
  const Halfedge h = mesh.halfedge(f);
  return {{mesh.from(h).index, mesh.to(h).index, mesh.from(mesh.prev(h)).index}, slot, all_sides};
}

void SurfaceTriangles::read(const Mesh& mesh, std::span<const std::uint32_t> slots, SurfaceTriangle* to) const {
  constexpr std::size_t most = 128;  // as many as a cache holds
  for (; !slots.empty(); to += std::min(most, slots.size()), slots = slots.subspan(std::min(most, slots.size()))) {
    const std::span<const std::uint32_t> part = slots.first(std::min(most, slots.size()));
    const auto for_homes = [&](const auto& visit) {
      for (const std::uint32_t slot : part)
        if (slot < homes_ && mesh.exists(Face(slot))) visit(Face(slot));
    };
    for_homes([&](Face f) { prefetch(mesh, f); });
    for_homes([&](Face f) { prefetch(mesh, mesh.halfedge(f)); });
    for_homes([&](Face f) {
      if (mesh.is_alive(f)) prefetch(mesh, mesh.prev(mesh.halfedge(f)));
    });
    for (std::size_t i = 0; i < part.size(); ++i) to[i] = at(mesh, part[i]);
  }
}

std::uint32_t SurfaceTriangles::first_stored(Face f) const {
  if (f.index >= homes_) return f.index - homes_ < first_.size() ? first_[f.index - homes_] : no_index;
  const auto found = moved_out_.find(f.index);
  return found == moved_out_.end() ? no_index : found->second;
}

void SurfaceTriangles::set_first_stored(Face f, std::uint32_t slot) {
  (f.index >= homes_ ? first_[f.index - homes_] : moved_out_[f.index]) = slot;
}

std::uint32_t SurfaceTriangles::take_slot() {
  if (!free_.empty()) {
    const std::uint32_t slot = free_.back();
    free_.pop_back();
    return slot;
  }
  stored_.emplace_back();
  next_.push_back(no_index);
  return slots() - 1;
}

void SurfaceTriangles::release(Face f, std::vector<std::uint32_t>& changed) {
  if (f.index < homes_) changed.push_back(f.index);
  std::uint32_t slot = first_stored(f);
  if (f.index < homes_)
    moved_out_.erase(f.index);
  else if (slot != no_index)
    set_first_stored(f, no_index);
  while (slot != no_index) {
    const std::uint32_t next = next_[slot - homes_];
    stored_[slot - homes_] = {};
    next_[slot - homes_] = no_index;
    free_.push_back(slot);
    changed.push_back(slot);
    slot = next;
  }
}

void SurfaceTriangles::fill(const Mesh& mesh, Face f, std::vector<std::uint32_t>& changed) {
  polygon_.read(mesh, f);
  const bool is_finite = polygon_.is_finite();
  if (f.index < homes_) {
    if (is_finite && is_triangle(mesh, f)) return;
    moved_out_[f.index] = no_index;
  }
  if (!is_finite) return;
  polygon_.triangulate(local_);
  const auto vertex = [&](std::uint32_t corner) { return mesh.from(polygon_.corners()[corner]).index; };
  for (const auto& t : local_) {
    const std::uint32_t slot = take_slot();
    SurfaceTriangle& triangle = stored_[slot - homes_];
    triangle = {{vertex(t[0]), vertex(t[1]), vertex(t[2])}, f.index, 0};
    for (unsigned k = 0; k < 3; ++k)
      if (polygon_.is_side(t[k], t[(k + 1) % 3]))
        triangle.edge_bits = static_cast<std::uint8_t>(triangle.edge_bits | (1u << k));
    next_[slot - homes_] = first_stored(f);
    set_first_stored(f, slot);
    changed.push_back(slot);
  }
}

std::vector<std::uint32_t> SurfaceTriangles::update(const Mesh& mesh, const TouchedElements& touched) {
  std::vector<std::uint32_t> changed;
  if (touched.everything) {
    rebuild(mesh);
    for (std::uint32_t i = 0; i < slots(); ++i) changed.push_back(i);
    return changed;
  }
  if (mesh.face_slots() > homes_ + first_.size()) first_.resize(mesh.face_slots() - homes_, no_index);
  for (Face f : touched.faces) release(f, changed);
  for (Face f : touched.faces)
    if (mesh.exists(f) && mesh.is_alive(f)) fill(mesh, f, changed);
  sort_unique(changed);
  return changed;
}

std::vector<std::uint32_t> SurfaceTriangles::slots_of(const Mesh& mesh, Face f) const {
  if (is_home(mesh, f)) return {f.index};
  std::vector<std::uint32_t> slots;
  for (std::uint32_t slot = first_stored(f); slot != no_index; slot = next_[slot - homes_]) slots.push_back(slot);
  return slots;
}

std::uint32_t SurfaceTriangles::only_slot_of(const Mesh& mesh, Face f) const {
  if (is_home(mesh, f)) return f.index;
  const std::uint32_t slot = first_stored(f);
  return slot == no_index || next_[slot - homes_] != no_index ? no_index : slot;
}

}  // namespace ryosen
