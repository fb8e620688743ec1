// The GPU copy of a mesh: positions, triangles in small clusters, normals where there are any, and a byte of flags per
// face.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/colour.h"
#include "render/gl/buffer.h"
#include "render/gl/program.h"
#include "render/screen.h"
#include "ryosen/analysis/surface_triangles.h"
#include "ryosen/scene/highlights/looks.h"

namespace ryosen {

// A face carries one byte: 0, or the number of its tint from 1 on, or that it is not drawn at all.
inline constexpr std::uint8_t hidden_face = 255;
inline constexpr std::size_t most_tints = 32;

struct DrawnTint {
  Rgba colour{};
  FaceTint tint{};
  friend bool operator==(const DrawnTint&, const DrawnTint&) = default;
};

// One with three equal corners is not drawn, and its face is not read; that of others is below 2^29.
using DrawnTriangle = SurfaceTriangle;

// own: lit as the surface's own colour is; else little, so that the colours stay those of a legend. sides: each part of
// a triangle takes the colour of the edge of its face that is nearest.
enum class Paint : std::uint8_t { none, own, corners, sides };

// A triangle mesh owned by the caller.
struct TriangleSource {
  std::span<const glm::dvec3> positions;
  std::uint32_t triangles = 0;
  // Writes the triangles of these numbers, in their order; asked from several threads.
  std::function<void(std::span<const std::uint32_t> numbers, DrawnTriangle* to)> read;
  std::span<const std::uint8_t> face_tints;  // see hidden_face; faces past the end have none
  // Of the corners of each triangle, see ryosen/scene/view/packed_normal.h. Empty: the surface is not drawn smooth.
  std::span<const std::array<std::uint32_t, 3>> corner_normals = {};
  // What the surface is painted with in place of its own colour: 0xAABBGGRR, 0 for none, of the corners of a triangle,
  // or of its sides from each corner to the next; asked from several threads. Changes are named with the triangles.
  Paint paint = Paint::none;
  std::function<std::array<std::uint32_t, 3>(const DrawnTriangle&)> colours = {};

  DrawnTriangle triangle(std::uint32_t number) const {
    DrawnTriangle one;
    read({&number, 1}, &one);
    return one;
  }
};

// Spatially close triangles in consecutive slots, with their bounding box.
struct Cluster {
  DrawBox box;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool tinted = false;  // some face of it has a tint
  float size = 0;       // that of its triangles in the middle, rounded, so that an edit seldom changes it
};

// What an update changed: the bounding boxes of the triangles before and after, of all of a cluster where its size is
// another, and the numbers of their clusters.
struct MeshChange {
  std::vector<DrawBox> boxes;
  std::vector<std::uint32_t> clusters;
};

// The transform from mesh space to buffer space: translation by an origin near the mesh, then scaling by a power of two
// to about unit size.
struct BufferSpace {
  glm::dvec3 origin{0};
  double scale = 1;

  glm::vec3 from_mesh(const glm::dvec3& p) const { return glm::vec3(place_from_mesh(p)); }
  // Halves first: the difference of two large numbers may be too large.
  glm::dvec3 place_from_mesh(const glm::dvec3& p) const { return (0.5 * p - 0.5 * origin) * (2 * scale); }
};
// The buffer space for a mesh with these bounds.
BufferSpace buffer_space(const glm::dvec3& low, const glm::dvec3& high);

// Positions are stored in single precision in the buffer space of the bounds given to set(). Triangles are ordered
// along a space-filling curve, so that clusters are compact and a part of the view needs few of them. Triangles with an
// out-of-range vertex or a non-finite position are not drawn. set() is linear; update() costs the listed changes. What
// is on the GPU is not kept beside it: 8 bytes per triangle, their order, and a byte per face are.
class MeshBuffers {
 public:
  static constexpr std::uint32_t cluster_size = 128;

  MeshBuffers();

  // `low` and `high` bound the positions that are finite.
  void set(const TriangleSource& given, const glm::dvec3& low, const glm::dvec3& high);

  // Updates the copy after a change. `vertices` lists the vertices with a new position, `triangles` those with changed
  // corners, normals, face or edge bits or with a moved corner, `faces` those with changed tints. Elements appended or
  // removed at the ends of the arrays need not be listed. Finding the triangles of faces with changed tints takes a
  // pass over all triangles, unless for each such face some triangle is listed; then all its triangles must be.
  MeshChange update(const TriangleSource& source, std::span<const std::uint32_t> vertices,
                    std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> faces);

  // Binds the textures read by mesh.glsl to the units that set_units() assigns to a program.
  void bind() const;
  // The clusters that the next draw goes through.
  void bind_clusters(std::span<const std::uint32_t> numbers) const;
  // Those that have been written.
  std::uint32_t slots() const { return static_cast<std::uint32_t>(source_of_slot_.size()); }
  static void set_units(const Program& program);

  Paint paint() const { return paint_; }
  const BufferSpace& space() const { return space_; }
  std::span<const Cluster> clusters() const { return clusters_; }
  DrawBox bounds() const;
  // The source triangle number of a slot.
  std::uint32_t source_of_slot(std::uint32_t slot) const { return source_of_slot_[slot]; }
  // Reads the faces of all slots back. Linear.
  std::vector<std::uint32_t> faces_of_slots() const;

 private:
  // As it is on the GPU, and the places of its corners.
  struct Slot {
    glm::uvec4 triangle;
    std::array<glm::vec3, 3> places;
    bool is_drawn() const { return triangle.x != triangle.y || triangle.y != triangle.z; }
    DrawBox box() const;
    float squared_area() const;  // times four
  };

  // Where triangles are on the space-filling curve; any place for one that is not drawn.
  void read_middles(const TriangleSource& source, std::uint32_t first, std::span<glm::vec3> middles) const;
  Slot converted(const TriangleSource& source, const DrawnTriangle& triangle) const;
  // Writes the slots of a cluster, with their normals and colours unless null, and makes its record. One more than the
  // largest face.
  std::uint32_t convert(const TriangleSource& source, std::uint32_t cluster, glm::uvec4* triangles, glm::uvec4* normals,
                        glm::uvec4* colours);
  void write_all(const TriangleSource& source);
  // The slots of triangles as they are on the GPU.
  std::vector<Slot> read_back(std::span<const std::uint32_t> triangles) const;
  std::vector<std::uint32_t> changed_triangles(const TriangleSource& source,
                                               std::span<const std::uint32_t> named) const;
  void write_positions(const TriangleSource& source, std::span<const std::uint32_t> vertices);
  // Adds the clusters written to, and the boxes of those with another size.
  void write_triangles(const TriangleSource& source, std::span<const std::uint32_t> triangles, MeshChange& change);
  // Returns the faces whose tints are different now.
  std::vector<std::uint32_t> write_tints(const TriangleSource& source, std::span<const std::uint32_t> faces);
  void add_triangles_of(const TriangleSource& source, std::vector<std::uint32_t> faces,
                        std::vector<std::uint32_t>& triangles) const;
  void make_room_for_tints(std::size_t faces);

  BufferSpace space_;
  std::vector<std::uint8_t> tints_;  // as uploaded; at least one per face used by a triangle
  UnwrittenVector<std::uint32_t> slot_of_source_;
  UnwrittenVector<std::uint32_t> source_of_slot_;
  std::vector<Cluster> clusters_;
  std::size_t source_positions_ = 0;
  std::size_t source_triangles_ = 0;
  std::size_t source_tints_ = 0;
  TexelArray<glm::vec4> gpu_positions_;   // w is 0
  TexelArray<glm::uvec4> gpu_triangles_;  // by slot: corners, then face * 8 + edge bits
  TexelArray<glm::uvec4> gpu_normals_;    // by slot: of the corners; one that means nothing where the source has none
  TexelArray<glm::uvec4> gpu_colours_;    // by slot, likewise
  TexelArray<std::uint8_t> gpu_tints_;
  TexelArray<float> gpu_sizes_;  // of the triangles of each cluster
  mutable NumberLists drawn_clusters_;
  Paint paint_ = Paint::none;
};

}  // namespace ryosen
