#include "ryosen/scene/view/corner_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/scene/view/packed_normal.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/random_edits.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// Calls visit(slot, k, normal) for each corner of each triangle that is used.
template <class Visit>
void for_corners(const Mesh& mesh, const SurfaceTriangles& triangles, const CornerNormals& normals, Visit visit) {
  for (std::uint32_t slot = 0; slot < triangles.slots(); ++slot)
    for (std::uint32_t k = 0; triangles.at(mesh, slot).face != no_index && k < 3; ++k)
      visit(slot, k, unpacked_normal(normals.packed()[slot][k]));
}

TEST(corner_normals, of_a_ball_point_away_from_its_middle) {
  const Mesh mesh = asset_mesh("ball.off");
  const SurfaceTriangles triangles(mesh);
  int corners = 0;
  for_corners(mesh, triangles, CornerNormals(mesh, triangles),
              [&](std::uint32_t slot, std::uint32_t k, glm::dvec3 normal) {
                const glm::dvec3 outward = glm::normalize(mesh.position(Vertex(triangles.at(mesh, slot).corners[k])));
                EXPECT_GT(glm::dot(normal, outward), 0.999);
                ++corners;
              });
  EXPECT_EQ(corners, 3 * (16 * 2 + 2 * 96));
}

TEST(corner_normals, stay_on_their_side_of_creases_boundaries_and_copies) {
  for (const char* name : {"cube.obj", "fin.obj", "misoriented.obj", "seam.obj", "duplicate_face.obj"}) {
    const Mesh mesh = asset_mesh(name);
    const SurfaceTriangles triangles(mesh);
    Neighbourhood around(mesh);
    int corners = 0;
    for_corners(mesh, triangles, CornerNormals(mesh, triangles),
                [&](std::uint32_t slot, std::uint32_t, glm::dvec3 normal) {
                  EXPECT_GT(glm::dot(normal, around.normal(Face(triangles.at(mesh, slot).face))), 1 - 1e-7) << name;
                  ++corners;
                });
    EXPECT_GE(corners, 6) << name;
  }
}

TEST(corner_normals, weigh_faces_by_their_angles) {
  // A roof of 20 degrees, one side of which is cut into three triangles at the end of the ridge.
  const double slope = std::tan(10 * std::numbers::pi / 180);
  IndexedMesh roof;
  roof.positions = {{0, 0, 0},      {1, 0, 0},       {1, 1, -slope}, {0.5, 1, -slope},
                    {0, 1, -slope}, {1, -1, -slope}, {0, -1, -slope}};
  roof.corners = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 6, 5, 1};
  roof.face_offsets = {0, 3, 6, 9, 13};
  const Mesh mesh = from_indexed(std::move(roof));
  const SurfaceTriangles triangles(mesh);
  int corners = 0;
  for_corners(mesh, triangles, CornerNormals(mesh, triangles),
              [&](std::uint32_t slot, std::uint32_t k, glm::dvec3 normal) {
                if (triangles.at(mesh, slot).corners[k] > 1) return;
                EXPECT_LT(glm::length(normal - glm::dvec3(0, 0, 1)), 2e-4);
                ++corners;
              });
  EXPECT_EQ(corners, 7);
}

TEST(corner_normals, have_no_direction_where_no_face_has_one) {
  IndexedMesh line;
  line.positions = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}};
  line.corners = {0, 1, 2};
  line.face_offsets = {0, 3};
  const Mesh mesh = from_indexed(std::move(line));
  const SurfaceTriangles triangles(mesh);
  const CornerNormals normals(mesh, triangles);
  int flat = 0;
  for_corners(mesh, triangles, normals,
              [&](std::uint32_t slot, std::uint32_t k, glm::dvec3) { flat += normals.packed()[slot][k] == no_normal; });
  EXPECT_EQ(flat, 3);
}

TEST(corner_normals, follow_edits_as_if_found_anew) {
  int edits = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Mesh mesh = test::random_kernel_mesh(seed);
    Journal journal;
    Dice dice(seed);
    SurfaceTriangles triangles(mesh);
    CornerNormals followed(mesh, triangles);
    for (int step = 0; step < 12; ++step) {
      const std::size_t before = journal.size();
      if (!test::edit_at_random(mesh, journal, dice)) continue;
      for (std::size_t i = before; i < journal.size(); ++i) {
        const TouchedElements touched = touched_elements(mesh, journal, i);
        const std::vector<std::array<std::uint32_t, 3>> old(followed.packed().begin(), followed.packed().end());
        triangles.update(mesh, touched);
        if (touched.everything) {
          followed = CornerNormals(mesh, triangles);
          continue;
        }
        const std::vector<std::uint32_t> told = followed.update(mesh, triangles, touched);
        const CornerNormals anew(mesh, triangles);
        for_corners(mesh, triangles, followed, [&](std::uint32_t slot, std::uint32_t k, glm::dvec3 normal) {
          EXPECT_LT(glm::length(normal - unpacked_normal(anew.packed()[slot][k])), 1e-3) << seed << " " << step;
          const bool is_other = slot >= old.size() || old[slot][k] != followed.packed()[slot][k];
          EXPECT_TRUE(!is_other || std::count(told.begin(), told.end(), slot) == 1) << seed << " " << step;
        });
        ++edits;
      }
    }
  }
  EXPECT_GT(edits, 200);
}

}  // namespace
}  // namespace ryosen
