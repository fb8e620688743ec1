// Following changes of the mesh, at the cost of what has changed: the old state is read back from the GPU.
#include <algorithm>
#include <unordered_map>

#include "render/mesh_buffers.h"
#include "render/number_runs.h"
#include "ryosen/base/sort_unique.h"

namespace ryosen {
namespace {

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
  for (const std::uint32_t triangle : named) {
    if (triangle < std::min(now, source_triangles_)) changed.push_back(triangle);
  }
  for (std::size_t i = std::min(now, source_triangles_); i < std::max(now, source_triangles_); ++i) {
    changed.push_back(static_cast<std::uint32_t>(i));
  }
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

}  // namespace ryosen
