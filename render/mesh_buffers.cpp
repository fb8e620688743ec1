#include "render/mesh_buffers.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>

#include "core/geometry/is_finite.h"
#include "render/hilbert_order.h"

namespace ryosen {
namespace {

constexpr glm::uvec4 not_drawn(0);

bool is_drawn(const glm::uvec4& triangle) { return triangle.x != triangle.y || triangle.y != triangle.z; }

// Calls write(first, count) for runs that cover the numbers; small gaps are included.
template <class Write>
void for_runs(std::vector<std::uint32_t> numbers, const Write& write) {
  constexpr std::uint32_t small_gap = 64;
  if (!std::is_sorted(numbers.begin(), numbers.end())) std::sort(numbers.begin(), numbers.end());
  for (std::size_t i = 0; i < numbers.size();) {
    const std::uint32_t first = numbers[i];
    std::uint32_t last = first;
    while (i < numbers.size() && numbers[i] - last <= small_gap) last = numbers[i++];
    write(first, last - first + 1);
  }
}

}  // namespace

BufferSpace buffer_space(const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 half_size = 0.5 * high - 0.5 * low;
  const double largest = std::max({half_size.x, half_size.y, half_size.z});
  BufferSpace space;
  space.origin = 0.5 * low + 0.5 * high;
  if (largest > 0 && std::isfinite(largest)) {
    int exponent = 0;
    std::frexp(largest, &exponent);
    space.scale = std::ldexp(1.0, std::clamp(-exponent - 1, -1022, 1022));
  }
  return space;
}

MeshBuffers::MeshBuffers()
    : gpu_positions_("mesh positions", GL_RGBA32F),
      gpu_triangles_("mesh triangles", GL_RGBA32UI),
      gpu_normals_("corner normals", GL_RGBA32UI),
      gpu_tints_("face tints", GL_R8UI) {
  const glm::uvec4 none(0);
  gpu_normals_.write(0, {&none, 1});  // so that there is something to bind
}

void MeshBuffers::set(const TriangleSource& source, const BufferSpace& space) {
  space_ = space;
  positions_.clear();
  triangles_.clear();
  normals_.clear();
  tints_.clear();
  slot_of_source_.clear();
  source_of_slot_.clear();
  clusters_.clear();
  source_positions_ = source_triangles_ = source_tints_ = 0;
  write_positions(source, {});

  std::vector<glm::vec3> middles(source.triangles.size(), glm::vec3(0));
  for (std::size_t i = 0; i < middles.size(); ++i) {
    const auto& corner = source.triangles[i];
    if (!drawable(corner[0]) || !drawable(corner[1]) || !drawable(corner[2])) continue;
    middles[i] = glm::vec3(positions_[corner[0]] + positions_[corner[1]] + positions_[corner[2]]) / 3.0f;
  }
  source_of_slot_ = hilbert_order(middles);
  slot_of_source_.resize(source_of_slot_.size());
  for (std::uint32_t slot = 0; slot < source_of_slot_.size(); ++slot) slot_of_source_[source_of_slot_[slot]] = slot;
  triangles_.assign(source_of_slot_.size(), not_drawn);
  source_triangles_ = source.triangles.size();
  write_tints(source, {});
  write_triangles(source, source_of_slot_);
}

MeshChange MeshBuffers::update(const TriangleSource& source, std::span<const std::uint32_t> vertices,
                               std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> faces) {
  MeshChange change;
  std::vector<std::uint32_t> changed = changed_triangles(source, triangles);
  add_triangles_of(source, write_tints(source, faces), changed);
  const auto note_boxes = [&] {
    for (const std::uint32_t triangle : changed) {
      if (triangle >= slot_of_source_.size()) continue;
      const DrawBox box = box_of_slot(slot_of_source_[triangle]);
      if (!box.empty()) change.boxes.push_back(box);
    }
  };
  note_boxes();
  for (auto i = static_cast<std::uint32_t>(slot_of_source_.size()); i < source.triangles.size(); ++i) {
    slot_of_source_.push_back(i);
    source_of_slot_.push_back(i);
    triangles_.push_back(not_drawn);
  }
  write_positions(source, vertices);
  change.clusters = write_triangles(source, changed);
  source_triangles_ = source.triangles.size();
  note_boxes();
  return change;
}

void MeshBuffers::bind() const {
  gpu_positions_.bind(0);
  gpu_triangles_.bind(1);
  gpu_tints_.bind(2);
  gpu_normals_.bind(3);
}

void MeshBuffers::set_units(const Program& program) {
  program.use();
  program.set("positions", 0);
  program.set("triangles", 1);
  program.set("face_tints", 2);
  program.set("corner_normals", 3);
}

DrawBox MeshBuffers::bounds() const {
  DrawBox box;
  for (const Cluster& cluster : clusters_) box.add(cluster.box);
  return box;
}

bool MeshBuffers::drawable(std::uint32_t vertex) const {
  if (vertex >= source_positions_) return false;
  return is_finite(glm::vec3(positions_[vertex]));
}

glm::uvec4 MeshBuffers::converted(const TriangleSource& source, std::uint32_t triangle) const {
  if (triangle >= source.triangles.size()) return not_drawn;
  const auto& corner = source.triangles[triangle];
  if (corner[0] == corner[1] && corner[1] == corner[2]) return not_drawn;
  for (const std::uint32_t vertex : corner) {
    if (!drawable(vertex)) return not_drawn;
  }
  return {corner[0], corner[1], corner[2], source.triangle_face[triangle] * 8 + source.triangle_edge_bits[triangle]};
}

DrawBox MeshBuffers::box_of_slot(std::uint32_t slot) const {
  const glm::uvec4& triangle = triangles_[slot];
  DrawBox box;
  if (!is_drawn(triangle)) return box;
  for (int k = 0; k < 3; ++k) box.add(glm::vec3(positions_[triangle[k]]));
  return box;
}

std::vector<std::uint32_t> MeshBuffers::changed_triangles(const TriangleSource& source,
                                                          std::span<const std::uint32_t> named) const {
  const std::size_t now = source.triangles.size();
  std::vector<std::uint32_t> changed;
  for (const std::uint32_t triangle : named) {
    if (triangle < std::min(now, source_triangles_)) changed.push_back(triangle);
  }
  for (std::size_t i = std::min(now, source_triangles_); i < std::max(now, source_triangles_); ++i) {
    changed.push_back(static_cast<std::uint32_t>(i));
  }
  return changed;
}

void MeshBuffers::write_positions(const TriangleSource& source, std::span<const std::uint32_t> vertices) {
  const auto convert = [&](std::size_t vertex) {
    positions_[vertex] = glm::vec4(space_.from_mesh(source.positions[vertex]), 0.0f);
  };
  const std::size_t now = source.positions.size();
  const std::size_t before = std::min(source_positions_, now);
  std::vector<std::uint32_t> moved;
  for (const std::uint32_t vertex : vertices) {
    if (vertex < before) moved.push_back(vertex);
  }
  for (const std::uint32_t vertex : moved) convert(vertex);
  for_runs(std::move(moved), [&](std::uint32_t first, std::uint32_t count) {
    gpu_positions_.write(first, {positions_.data() + first, count});
  });
  if (positions_.size() < now) positions_.resize(now);
  for (std::size_t vertex = before; vertex < now; ++vertex) convert(vertex);
  gpu_positions_.write(before, {positions_.data() + before, now - before});
  source_positions_ = now;
}

std::vector<std::uint32_t> MeshBuffers::write_triangles(const TriangleSource& source,
                                                        std::span<const std::uint32_t> triangles) {
  std::vector<std::uint32_t> slots;
  slots.reserve(triangles.size());
  if (!source.corner_normals.empty()) normals_.resize(triangles_.size());
  std::uint32_t faces = static_cast<std::uint32_t>(tints_.size());
  for (const std::uint32_t triangle : triangles) {
    const std::uint32_t slot = slot_of_source_[triangle];
    triangles_[slot] = converted(source, triangle);
    if (triangle < source.corner_normals.size()) {
      const auto& [a, b, c] = source.corner_normals[triangle];
      normals_[slot] = {a, b, c, 0};
    }
    slots.push_back(slot);
    faces = std::max(faces, (triangles_[slot].w >> 3) + 1);
  }
  if (faces > tints_.size()) {
    const std::size_t before = tints_.size();
    tints_.resize(faces, 0);
    gpu_tints_.write(before, {tints_.data() + before, tints_.size() - before});
  }
  while (clusters_.size() * cluster_size < triangles_.size()) clusters_.emplace_back();
  std::vector<std::uint32_t> touched_clusters;
  for (const std::uint32_t slot : slots) touched_clusters.push_back(slot / cluster_size);
  for_runs(std::move(slots), [&](std::uint32_t first, std::uint32_t count) {
    gpu_triangles_.write(first, {triangles_.data() + first, count});
    if (!normals_.empty()) gpu_normals_.write(first, {normals_.data() + first, count});
  });
  std::sort(touched_clusters.begin(), touched_clusters.end());
  touched_clusters.erase(std::unique(touched_clusters.begin(), touched_clusters.end()), touched_clusters.end());
  for (const std::uint32_t cluster : touched_clusters) refresh(cluster);
  return touched_clusters;
}

void MeshBuffers::refresh(std::uint32_t number) {
  Cluster& cluster = clusters_[number];
  cluster.first = number * cluster_size;
  cluster.count = std::min(cluster_size, static_cast<std::uint32_t>(triangles_.size()) - cluster.first);
  cluster.box = {};
  cluster.tinted = false;
  for (std::uint32_t i = 0; i < cluster.count; ++i) {
    const glm::uvec4& triangle = triangles_[cluster.first + i];
    if (!is_drawn(triangle)) continue;
    for (int k = 0; k < 3; ++k) cluster.box.add(glm::vec3(positions_[triangle[k]]));
    if (tints_[triangle.w >> 3] != 0) cluster.tinted = true;
  }
}

std::vector<std::uint32_t> MeshBuffers::write_tints(const TriangleSource& source,
                                                    std::span<const std::uint32_t> faces) {
  const std::size_t now = source.face_tints.size();
  const std::size_t before = std::min(source_tints_, now), end = std::max(source_tints_, now);
  if (tints_.size() < end) tints_.resize(end, 0);
  std::vector<std::uint32_t> written;
  const auto write = [&](std::uint32_t face, std::uint8_t tint) {
    if (tints_[face] == tint) return;
    tints_[face] = tint;
    written.push_back(face);
  };
  for (const std::uint32_t face : faces) {
    if (face < before) write(face, source.face_tints[face]);
  }
  for_runs(written, [&](std::uint32_t first, std::uint32_t count) {
    gpu_tints_.write(first, {tints_.data() + first, count});
  });
  for (std::size_t face = before; face < end; ++face) {
    write(static_cast<std::uint32_t>(face), face < now ? source.face_tints[face] : std::uint8_t{0});
  }
  gpu_tints_.write(before, {tints_.data() + before, end - before});
  source_tints_ = now;
  return written;
}

void MeshBuffers::add_triangles_of(const TriangleSource& source, std::vector<std::uint32_t> faces,
                                   std::vector<std::uint32_t>& triangles) const {
  if (faces.empty()) return;
  std::vector<std::uint32_t> named;
  for (const std::uint32_t triangle : triangles) {
    if (triangle < source.triangles.size()) named.push_back(source.triangle_face[triangle]);
    if (triangle < slot_of_source_.size()) named.push_back(face_of_slot(slot_of_source_[triangle]));
  }
  std::sort(named.begin(), named.end());
  std::erase_if(faces, [&](std::uint32_t f) { return std::binary_search(named.begin(), named.end(), f); });
  if (faces.empty()) return;
  std::vector<std::uint8_t> wanted(tints_.size(), 0);
  for (const std::uint32_t face : faces) wanted[face] = 1;
  for (std::uint32_t slot = 0; slot < triangles_.size(); ++slot) {
    if (is_drawn(triangles_[slot]) && wanted[face_of_slot(slot)] != 0) triangles.push_back(source_of_slot_[slot]);
  }
}

}  // namespace ryosen
