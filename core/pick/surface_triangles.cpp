#include "core/pick/surface_triangles.h"

#include "core/base/sort_unique.h"

namespace ryosen {

SurfaceTriangles::SurfaceTriangles(const Mesh& mesh) { rebuild(mesh); }

void SurfaceTriangles::rebuild(const Mesh& mesh) {
  triangles_.clear();
  face_.clear();
  edge_bits_.clear();
  next_of_face_.clear();
  free_.clear();
  first_of_face_.assign(mesh.face_slots(), no_index);
  const std::size_t expected = mesh.live().faces;
  triangles_.reserve(expected);
  face_.reserve(expected);
  edge_bits_.reserve(expected);
  next_of_face_.reserve(expected);
  std::vector<std::uint32_t> ignored;
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_alive(Face(f))) fill(mesh, Face(f), ignored);
    ignored.clear();
  }
}

std::uint32_t SurfaceTriangles::take_slot() {
  if (!free_.empty()) {
    const std::uint32_t slot = free_.back();
    free_.pop_back();
    return slot;
  }
  triangles_.push_back({0, 0, 0});
  face_.push_back(no_index);
  edge_bits_.push_back(0);
  next_of_face_.push_back(no_index);
  return static_cast<std::uint32_t>(triangles_.size() - 1);
}

void SurfaceTriangles::release(Face f, std::vector<std::uint32_t>& changed) {
  if (f.index >= first_of_face_.size()) return;
  std::uint32_t slot = first_of_face_[f.index];
  first_of_face_[f.index] = no_index;
  while (slot != no_index) {
    const std::uint32_t next = next_of_face_[slot];
    triangles_[slot] = {0, 0, 0};
    face_[slot] = no_index;
    edge_bits_[slot] = 0;
    next_of_face_[slot] = no_index;
    free_.push_back(slot);
    changed.push_back(slot);
    slot = next;
  }
}

void SurfaceTriangles::fill(const Mesh& mesh, Face f, std::vector<std::uint32_t>& changed) {
  polygon_.read(mesh, f);
  if (!polygon_.is_finite()) return;
  polygon_.triangulate(local_);
  const auto vertex = [&](std::uint32_t corner) { return mesh.from(polygon_.corners()[corner]).index; };
  for (const auto& t : local_) {
    const std::uint32_t slot = take_slot();
    triangles_[slot] = {vertex(t[0]), vertex(t[1]), vertex(t[2])};
    face_[slot] = f.index;
    std::uint8_t bits = 0;
    for (unsigned k = 0; k < 3; ++k)
      if (polygon_.is_side(t[k], t[(k + 1) % 3])) bits = static_cast<std::uint8_t>(bits | (1u << k));
    edge_bits_[slot] = bits;
    next_of_face_[slot] = first_of_face_[f.index];
    first_of_face_[f.index] = slot;
    changed.push_back(slot);
  }
}

std::vector<std::uint32_t> SurfaceTriangles::update(const Mesh& mesh, const TouchedElements& touched) {
  std::vector<std::uint32_t> changed;
  if (touched.everything) {
    rebuild(mesh);
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) changed.push_back(i);
    return changed;
  }
  if (mesh.face_slots() > first_of_face_.size()) first_of_face_.resize(mesh.face_slots(), no_index);
  for (Face f : touched.faces) release(f, changed);
  for (Face f : touched.faces)
    if (mesh.exists(f) && mesh.is_alive(f)) fill(mesh, f, changed);
  sort_unique(changed);
  return changed;
}

std::vector<std::uint32_t> SurfaceTriangles::slots_of(Face f) const {
  std::vector<std::uint32_t> slots;
  for (std::uint32_t slot = first_of_face_[f.index]; slot != no_index; slot = next_of_face_[slot])
    slots.push_back(slot);
  return slots;
}

}  // namespace ryosen
