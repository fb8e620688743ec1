// Following changes of the mesh, at the cost of what has changed: the old state is read back from the GPU. Positions
// and tints are written as runs, at first too.
#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "render/mesh_buffers.h"
#include "ryosen/base/parallel.h"
#include "ryosen/base/sort_unique.h"

namespace ryosen {

namespace {

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

// Calls visit(number, value) for each of the numbers, as often as it is there, reading few parts of the array.
template <class T, class Visit>
void read_runs(const TexelArray<T>& from, std::vector<std::uint32_t> numbers, const Visit& visit) {
  std::sort(numbers.begin(), numbers.end());
  std::vector<T> values;
  auto next = numbers.cbegin();
  for_runs(numbers, [&](std::uint32_t first, std::uint32_t count) {
    values.resize(count);
    from.read(first, values);
    for (; next != numbers.cend() && *next - first < count; ++next) visit(*next, values[*next - first]);
  });
}

}  // namespace

MeshChange MeshBuffers::update(const TriangleSource& source, std::span<const std::uint32_t> vertices,
                               std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> faces) {
  MeshChange change;
  const auto note = [&](const Slot& slot) {
    if (const DrawBox box = slot.box(); !box.empty()) change.boxes.push_back(box);
  };
  std::vector<std::uint32_t> changed = changed_triangles(source, triangles);
  add_triangles_of(source, write_tints(source, faces), changed);
  for (const Slot& slot : read_back(changed)) note(slot);
  for (auto i = static_cast<std::uint32_t>(slot_of_source_.size()); i < source.triangles; ++i) {
    slot_of_source_.push_back(i);
    source_of_slot_.push_back(i);
  }
  write_positions(source, vertices);
  write_triangles(source, changed, change);
  source_triangles_ = source.triangles;
  for (const std::uint32_t triangle : changed)
    if (triangle < source.triangles) note(converted(source, source.triangle(triangle)));
  return change;
}

std::vector<MeshBuffers::Slot> MeshBuffers::read_back(std::span<const std::uint32_t> triangles) const {
  std::vector<std::uint32_t> slots, vertices;
  for (const std::uint32_t triangle : triangles)
    if (triangle < slot_of_source_.size()) slots.push_back(slot_of_source_[triangle]);
  std::vector<Slot> read;
  read_runs(gpu_triangles_, slots, [&](std::uint32_t, const glm::uvec4& triangle) {
    read.push_back({triangle, {}});
    if (read.back().is_drawn()) vertices.insert(vertices.end(), {triangle.x, triangle.y, triangle.z});
  });
  std::unordered_map<std::uint32_t, glm::vec3> places;
  read_runs(gpu_positions_, vertices, [&](std::uint32_t v, const glm::vec4& place) { places[v] = glm::vec3(place); });
  for (Slot& slot : read)
    for (int k = 0; k < 3 && slot.is_drawn(); ++k) slot.places[static_cast<std::size_t>(k)] = places[slot.triangle[k]];
  return read;
}

std::vector<std::uint32_t> MeshBuffers::changed_triangles(const TriangleSource& source,
                                                          std::span<const std::uint32_t> named) const {
  const std::size_t now = source.triangles;
  std::vector<std::uint32_t> changed;
  for (const std::uint32_t triangle : named)
    if (triangle < std::min(now, source_triangles_)) changed.push_back(triangle);
  for (std::size_t i = std::min(now, source_triangles_); i < std::max(now, source_triangles_); ++i)
    changed.push_back(static_cast<std::uint32_t>(i));
  return changed;
}

void MeshBuffers::write_triangles(const TriangleSource& source, std::span<const std::uint32_t> triangles,
                                  MeshChange& change) {
  std::vector<std::uint32_t>& touched = change.clusters;
  for (const std::uint32_t triangle : triangles) touched.push_back(slot_of_source_[triangle] / cluster_size);
  sort_unique(touched);
  while (clusters_.size() * cluster_size < source_of_slot_.size()) clusters_.emplace_back();
  const bool has_normals = !source.corner_normals.empty();
  std::array<glm::uvec4, cluster_size> slots, normals{}, colours;
  for (const std::uint32_t cluster : touched) {
    const Cluster before = clusters_[cluster];
    make_room_for_tints(convert(source, cluster, slots.data(), has_normals ? normals.data() : nullptr,
                                paint_ != Paint::none ? colours.data() : nullptr));
    const std::uint32_t first = clusters_[cluster].first, count = clusters_[cluster].count;
    gpu_triangles_.write(first, std::span(slots).first(count));
    if (has_normals) gpu_normals_.write(first, std::span(normals).first(count));
    if (paint_ != Paint::none) gpu_colours_.write(first, std::span(colours).first(count));
    const Cluster& now = clusters_[cluster];
    gpu_sizes_.write(cluster, {&now.size, 1});
    if (now.size == before.size) continue;
    for (const DrawBox& box : {before.box, now.box})
      if (!box.empty()) change.boxes.push_back(box);
  }
}

void MeshBuffers::add_triangles_of(const TriangleSource& source, std::vector<std::uint32_t> faces,
                                   std::vector<std::uint32_t>& triangles) const {
  if (faces.empty()) return;
  std::vector<std::uint32_t> named;
  for (const Slot& slot : read_back(triangles))
    if (slot.is_drawn()) named.push_back(slot.triangle.w >> 3);
  for (const std::uint32_t triangle : triangles)
    if (triangle < source.triangles) named.push_back(source.triangle(triangle).face);
  sort_unique(named);
  std::erase_if(faces, [&](std::uint32_t f) { return std::binary_search(named.begin(), named.end(), f); });
  if (faces.empty()) return;
  std::vector<bool> wanted(tints_.size(), false);
  for (const std::uint32_t face : faces) wanted[face] = true;
  const auto drawn = static_cast<std::uint32_t>(std::min<std::size_t>(source_triangles_, source.triangles));
  for (std::uint32_t i = 0; i < drawn; ++i) {
    const std::uint32_t face = source.triangle(i).face;
    if (face < wanted.size() && wanted[face]) triangles.push_back(i);
  }
}

void MeshBuffers::write_positions(const TriangleSource& source, std::span<const std::uint32_t> vertices) {
  const std::size_t now = source.positions.size();
  const std::size_t before = std::min(source_positions_, now);
  const auto write = [&](std::size_t first, std::size_t count) {
    gpu_positions_.fill(first, count, [&](glm::vec4* to) {
      for_each_part(static_cast<std::uint32_t>(count), threads_for(count),
                    [&](unsigned, std::uint32_t begin, std::uint32_t end) {
                      for (std::uint32_t i = begin; i < end; ++i)
                        to[i] = glm::vec4(space_.from_mesh(source.positions[first + i]), 0.0f);
                    });
    });
  };
  std::vector<std::uint32_t> moved;
  for (const std::uint32_t vertex : vertices)
    if (vertex < before) moved.push_back(vertex);
  for_runs(std::move(moved), [&](std::uint32_t first, std::uint32_t count) { write(first, count); });
  write(before, now - before);
  source_positions_ = now;
}

void MeshBuffers::make_room_for_tints(std::size_t faces) {
  if (faces <= tints_.size()) return;
  const std::size_t before = tints_.size();
  tints_.resize(faces, 0);
  gpu_tints_.write(before, {tints_.data() + before, tints_.size() - before});
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
  for (const std::uint32_t face : faces)
    if (face < before) write(face, source.face_tints[face]);
  for_runs(written, [&](std::uint32_t first, std::uint32_t count) {
    gpu_tints_.write(first, {tints_.data() + first, count});
  });
  for (std::size_t face = before; face < end; ++face)
    write(static_cast<std::uint32_t>(face), face < now ? source.face_tints[face] : std::uint8_t{0});
  gpu_tints_.write(before, {tints_.data() + before, end - before});
  source_tints_ = now;
  return written;
}

}  // namespace ryosen
