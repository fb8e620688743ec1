#include "render/mesh_buffers.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "render/hilbert_order.h"
#include "ryosen/base/parallel.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/prefetch.h"

namespace ryosen {

namespace {

constexpr glm::uvec4 not_drawn(0);

// Reading triangles from the mesh costs more than all else here, so of a mesh of moderate size they are read once; of a
// larger one the copy would raise the peak of memory.
constexpr std::uint32_t most_copied = 1u << 21;

// Reads triangles of these numbers, those past the end as not drawn, and fetches the places of their corners.
void read_with_places(const TriangleSource& source, std::span<const std::uint32_t> numbers, DrawnTriangle* to) {
  const auto is_past = [&](std::uint32_t number) { return number >= source.triangles; };
  if (std::none_of(numbers.begin(), numbers.end(), is_past))
    source.read(numbers, to);
  else
    for (std::size_t i = 0; i < numbers.size(); ++i)
      to[i] = is_past(numbers[i]) ? DrawnTriangle() : source.triangle(numbers[i]);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (const std::uint32_t corner : to[i].corners) prefetch_cell(source.positions.data(), corner);
}

// All triangles of the source, in its order.
UnwrittenVector<DrawnTriangle> read_all(const TriangleSource& source) {
  constexpr std::uint32_t at_once = 128;
  UnwrittenVector<DrawnTriangle> all(source.triangles);
  for_each_part(source.triangles, threads_for(source.triangles), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    std::array<std::uint32_t, at_once> numbers;
    for (std::uint32_t first = begin; first < end; first += at_once) {
      const std::uint32_t count = std::min(at_once, end - first);
      std::iota(numbers.begin(), numbers.begin() + count, first);
      source.read(std::span(numbers).first(count), all.data() + first);
    }
  });
  return all;
}

// The same source, read from a copy of its triangles.
TriangleSource read_from(TriangleSource source, const UnwrittenVector<DrawnTriangle>& all) {
  source.read = [&all](std::span<const std::uint32_t> numbers, DrawnTriangle* to) {
    for (const std::uint32_t number : numbers) prefetch_cell(all.data(), number);
    for (const std::uint32_t number : numbers) *to++ = all[number];
  };
  return source;
}

// The root of twice the area that half of the triangles are below, of the squares of those; in steps of an eighth of an
// octave. Orders them anew.
float size_in_the_middle(std::span<float> squared_areas) {
  if (squared_areas.empty()) return 0;
  const auto middle = squared_areas.begin() + static_cast<std::ptrdiff_t>(squared_areas.size() / 2);
  std::nth_element(squared_areas.begin(), middle, squared_areas.end());
  constexpr float steps = 8;
  return *middle > 0 ? std::exp2(std::round(steps * 0.25f * std::log2(*middle)) / steps) : 0;
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
      gpu_colours_("corner colours", GL_RGBA32UI),
      gpu_tints_("face tints", GL_R8UI),
      gpu_sizes_("sizes of clusters", GL_R32F) {
  const glm::uvec4 none(0);
  gpu_normals_.write(0, {&none, 1});  // so that there is something to bind
  gpu_colours_.write(0, {&none, 1});
}

void MeshBuffers::set(const TriangleSource& given, const glm::dvec3& low, const glm::dvec3& high) {
  UnwrittenVector<DrawnTriangle> copies;
  TriangleSource source = given;
  if (given.triangles <= most_copied) {
    copies = read_all(given);
    source = read_from(given, copies);
  }
  space_ = buffer_space(low, high);
  tints_.clear();
  slot_of_source_.clear();
  source_of_slot_.clear();
  clusters_.clear();
  source_positions_ = source_triangles_ = source_tints_ = 0;
  paint_ = given.paint;
  write_positions(source, {});
  source_of_slot_ =
      hilbert_order(source.triangles, DrawBox{space_.from_mesh(low), space_.from_mesh(high)},
                    [&](std::uint32_t first, std::span<glm::vec3> middles) { read_middles(source, first, middles); });
  slot_of_source_.resize(source_of_slot_.size());
  for_each_part(source.triangles, threads_for(source.triangles), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t slot = begin; slot < end; ++slot) slot_of_source_[source_of_slot_[slot]] = slot;
  });
  source_triangles_ = source.triangles;
  write_tints(source, {});
  write_all(source);
}

void MeshBuffers::write_all(const TriangleSource& source) {
  const std::uint32_t slots = source.triangles, threads = threads_for(slots);
  clusters_.resize((slots + cluster_size - 1) / cluster_size);
  std::vector<std::uint32_t> faces(threads, 0);
  const auto fill = [&](glm::uvec4* triangles, glm::uvec4* normals, glm::uvec4* colours) {
    for_each_part(static_cast<std::uint32_t>(clusters_.size()), threads,
                  [&](unsigned t, std::uint32_t begin, std::uint32_t end) {
                    std::uint32_t used = 0;
                    for (std::uint32_t i = begin; i < end; ++i) {
                      const std::size_t first = std::size_t{i} * cluster_size;
                      used = std::max(used, convert(source, i, triangles + first, normals ? normals + first : nullptr,
                                                    colours ? colours + first : nullptr));
                    }
                    faces[t] = used;
                  });
  };
  gpu_triangles_.fill(0, slots, [&](glm::uvec4* triangles) {
    const auto fill_colours = [&](glm::uvec4* normals) {
      if (paint_ == Paint::none) return fill(triangles, normals, nullptr);
      gpu_colours_.fill(0, slots, [&](glm::uvec4* colours) { fill(triangles, normals, colours); });
    };
    if (source.corner_normals.empty()) return fill_colours(nullptr);
    gpu_normals_.fill(0, slots, fill_colours);
  });
  gpu_sizes_.fill(0, clusters_.size(), [&](float* to) {
    for (const Cluster& cluster : clusters_) *to++ = cluster.size;
  });
  make_room_for_tints(*std::max_element(faces.begin(), faces.end()));
}

void MeshBuffers::bind() const {
  gpu_positions_.bind(0);
  gpu_triangles_.bind(1);
  gpu_tints_.bind(2);
  gpu_normals_.bind(3);
  gpu_colours_.bind(4);
  gpu_sizes_.bind(5);
}

void MeshBuffers::set_units(const Program& program) {
  program.use();
  program.set("positions", 0);
  program.set("triangles", 1);
  program.set("face_tints", 2);
  program.set("corner_normals", 3);
  program.set("corner_colours", 4);
  program.set("cluster_sizes", 5);
  program.set("cluster_numbers", 6);
}

void MeshBuffers::bind_clusters(std::span<const std::uint32_t> numbers) const { drawn_clusters_.bind(numbers, 6); }

DrawBox MeshBuffers::bounds() const {
  DrawBox box;
  for (const Cluster& cluster : clusters_) box.add(cluster.box);
  return box;
}

DrawBox MeshBuffers::Slot::box() const {
  DrawBox box;
  if (!is_drawn()) return box;
  for (const glm::vec3& place : places) box.add(place);
  return box;
}

float MeshBuffers::Slot::squared_area() const {
  const glm::vec3 across = glm::cross(places[1] - places[0], places[2] - places[0]);
  return glm::dot(across, across);
}

MeshBuffers::Slot MeshBuffers::converted(const TriangleSource& source, const DrawnTriangle& triangle) const {
  const Slot nothing{not_drawn, {}};
  const auto& corner = triangle.corners;
  if (corner[0] == corner[1] && corner[1] == corner[2]) return nothing;
  if (triangle.face < tints_.size() && tints_[triangle.face] == hidden_face) return nothing;
  Slot slot{{corner[0], corner[1], corner[2], triangle.face * 8 + triangle.edge_bits}, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    if (corner[k] >= source.positions.size()) return nothing;
    slot.places[k] = space_.from_mesh(source.positions[corner[k]]);
    if (!is_finite(slot.places[k])) return nothing;
  }
  return slot;
}

void MeshBuffers::read_middles(const TriangleSource& source, std::uint32_t first, std::span<glm::vec3> middles) const {
  std::array<std::uint32_t, cluster_size> numbers;
  std::array<DrawnTriangle, cluster_size> triangles;
  for (std::size_t begin = 0; begin < middles.size(); begin += cluster_size) {
    const std::size_t count = std::min<std::size_t>(cluster_size, middles.size() - begin);
    std::iota(numbers.begin(), numbers.end(), first + static_cast<std::uint32_t>(begin));
    read_with_places(source, std::span(numbers).first(count), triangles.data());
    for (std::size_t i = 0; i < count; ++i) {
      const Slot slot = converted(source, triangles[i]);
      middles[begin + i] = (slot.places[0] + slot.places[1] + slot.places[2]) / 3.0f;
    }
  }
}

std::uint32_t MeshBuffers::convert(const TriangleSource& source, std::uint32_t number, glm::uvec4* to,
                                   glm::uvec4* normals, glm::uvec4* colours) {
  std::uint32_t faces = 0;
  Cluster& cluster = clusters_[number];
  cluster.first = number * cluster_size;
  cluster.count = std::min(cluster_size, static_cast<std::uint32_t>(source_of_slot_.size()) - cluster.first);
  cluster.box = {};
  cluster.tinted = false;
  const auto sources = std::span(source_of_slot_).subspan(cluster.first, cluster.count);
  std::array<DrawnTriangle, cluster_size> triangles;
  std::array<float, cluster_size> areas;
  std::size_t drawn = 0;
  read_with_places(source, sources, triangles.data());
  for (std::uint32_t i = 0; i < cluster.count; ++i) {
    const Slot slot = converted(source, triangles[i]);
    to[i] = slot.triangle;
    if (normals && sources[i] < source.corner_normals.size()) {
      const auto& [a, b, c] = source.corner_normals[sources[i]];
      normals[i] = {a, b, c, 0};
    }
    if (colours) colours[i] = glm::uvec4(0);
    if (!slot.is_drawn()) continue;
    if (colours) {
      const auto [a, b, c] = source.colours(triangles[i]);
      colours[i] = {a, b, c, 0};
    }
    cluster.box.add(slot.box());
    areas[drawn++] = slot.squared_area();
    const std::uint32_t face = slot.triangle.w >> 3;
    faces = std::max(faces, face + 1);
    if (face < tints_.size() && tints_[face] != 0) cluster.tinted = true;
  }
  cluster.size = size_in_the_middle(std::span(areas).first(drawn));
  return faces;
}

std::vector<std::uint32_t> MeshBuffers::faces_of_slots() const {
  std::vector<glm::uvec4> triangles(source_of_slot_.size());
  gpu_triangles_.read(0, triangles);
  std::vector<std::uint32_t> faces;
  for (const glm::uvec4& triangle : triangles) faces.push_back(triangle.w >> 3);
  return faces;
}

}  // namespace ryosen
