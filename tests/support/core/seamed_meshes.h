// Meshes with seams of texture or normals between their faces.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/triangle_corners.h"

namespace ryosen::test {

// The mesh of triangles with a normal for each of its faces.
inline Mesh with_flat_normals(const Mesh& mesh, double rounding = 0) {
  IndexedMesh source = to_indexed(mesh).mesh;
  source.normals = {};
  source.normals.components = 3;
  for (std::size_t f = 0; f < source.face_count(); ++f) {
    const auto corners = source.face(f);
    const glm::dvec3 &a = source.positions[corners[0]], &b = source.positions[corners[1]],
                     &c = source.positions[corners[2]];
    glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    if (rounding > 0) normal = rounding * glm::round(normal / rounding);
    for (std::size_t i = 0; i < corners.size(); ++i) source.normals.index.push_back(static_cast<std::uint32_t>(f));
    source.normals.pool.push_back(normal);
  }
  return from_indexed(std::move(source));
}

// All corners of each triangle have its own normal.
inline void expect_flat_normals(const Mesh& mesh, double least_cosine = 1 - 1e-12) {
  const AttributeColumn* const index = find_column(mesh, attribute_names::normal);
  const AttributeColumn* const pool = find_column(mesh, attribute_names::normal_pool);
  ASSERT_TRUE(index && pool);
  for (const Face f : live_faces(mesh)) {
    const glm::dvec3 own = glm::normalize(area_normal(corners_of(mesh, mesh.halfedge(f))));
    for (const Halfedge h : halfedges_around(mesh, f)) {
      ASSERT_NE(index->data[h.index], no_index);
      const auto value = attribute_value<glm::dvec3>(*pool, index->data[h.index]);
      EXPECT_GT(glm::dot(own, glm::normalize(value)), least_cosine);
    }
  }
}

// A value for each corner of each triangle: every edge is a seam of texture. That of a face lies between its number and
// the next.
inline Mesh with_islands(const Mesh& mesh) {
  IndexedMesh source = to_indexed(mesh).mesh;
  source.texcoords.components = 2;
  for (std::size_t i = 0; i < source.corners.size(); ++i) {
    source.texcoords.pool.emplace_back(double(i / 3) + (i % 3 == 1 ? 0.5 : 0), i % 3 == 2 ? 0.5 : 0, 0);
    source.texcoords.index.push_back(static_cast<std::uint32_t>(i));
  }
  return from_indexed(std::move(source));
}

// Where an island of island_box() begins.
inline double island_of(int axis, double level) { return 10 * (2 * axis + level); }

// A box from 0 to 1 of n x n squares a side, cut in two. Each side is an island, whose texture is the place on it
// behind the beginning of the island.
inline Mesh island_box(std::uint32_t n) {
  IndexedMesh source;
  std::map<std::array<double, 3>, std::uint32_t> known;
  const auto vertex = [&](const glm::dvec3& p) {
    const auto [found, is_new] =
        known.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(source.positions.size()));
    if (is_new) source.positions.push_back(p);
    return found->second;
  };
  source.texcoords.components = 2;
  for (int axis = 0; axis < 3; ++axis)
    for (const double level : {0.0, 1.0})
      for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x) {
          const auto corner = [&](std::uint32_t i, std::uint32_t j) {
            const double u = double(i) / n, v = double(j) / n;
            glm::dvec3 p(0);
            p[axis] = level;
            p[(axis + 1) % 3] = level > 0 ? u : v;
            p[(axis + 2) % 3] = level > 0 ? v : u;
            source.corners.push_back(vertex(p));
            source.texcoords.index.push_back(static_cast<std::uint32_t>(source.texcoords.pool.size()));
            source.texcoords.pool.emplace_back(island_of(axis, level) + u, v, 0);
          };
          corner(x, y), corner(x + 1, y), corner(x + 1, y + 1);
          source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
          corner(x, y), corner(x + 1, y + 1), corner(x, y + 1);
          source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
        }
  return from_indexed(std::move(source));
}

// A sphere of radius 1 of so many meridians and half as many rows. Texture is longitude and latitude, from 0 to 1 each,
// in the middle at the poles, and one seam runs from pole to pole.
inline Mesh seamed_sphere(std::uint32_t meridians) {
  const std::uint32_t rows = meridians / 2;
  IndexedMesh source;
  source.texcoords.components = 2;
  const auto vertex = [&](std::uint32_t x, std::uint32_t y) {
    return y == 0 ? 0 : y == rows ? 1 : 2 + (y - 1) * meridians + x % meridians;
  };
  source.positions = {{0, 0, -1}, {0, 0, 1}};
  for (std::uint32_t y = 1; y < rows; ++y)
    for (std::uint32_t x = 0; x < meridians; ++x) {
      const double longitude = 2 * std::numbers::pi * x / meridians, latitude = std::numbers::pi * y / rows;
      source.positions.emplace_back(std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude),
                                    -std::cos(latitude));
    }
  const auto corner = [&](std::uint32_t x, std::uint32_t y) {
    source.corners.push_back(vertex(x, y));
    source.texcoords.index.push_back(static_cast<std::uint32_t>(source.texcoords.pool.size()));
    const bool is_pole = y == 0 || y == rows;
    source.texcoords.pool.emplace_back(is_pole ? 0.5 : double(x) / meridians, double(y) / rows, 0);
  };
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < meridians; ++x) {
      if (y > 0) {
        corner(x, y), corner(x + 1, y), corner(x + 1, y + 1);
        source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
      }
      if (y + 1 < rows) {
        corner(x, y), corner(x + 1, y + 1), corner(x, y + 1);
        source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
      }
    }
  return from_indexed(std::move(source));
}

}  // namespace ryosen::test
