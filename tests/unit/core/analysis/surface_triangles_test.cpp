#include "ryosen/analysis/surface_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "ryosen/mesh/circulate.h"
#include "tests/support/core/random_edits.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

struct Held {
  std::array<std::uint32_t, 3> corners;
  std::uint32_t face;
  friend bool operator==(const Held&, const Held&) = default;
};

std::vector<Held> held_by(const SurfaceTriangles& triangles, const Mesh& mesh) {
  std::vector<Held> held;
  for (std::uint32_t slot = 0; slot < triangles.slots(); ++slot) {
    const SurfaceTriangle t = triangles.at(mesh, slot);
    held.push_back({t.corners, t.face});
  }
  return held;
}

// Every face has its triangles, each in a slot that names it back, with a bit for each of its sides; nothing else is
// held.
void expect_the_faces_of(const Mesh& mesh, const SurfaceTriangles& triangles) {
  std::size_t expected = 0;
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    const Face f(i);
    if (!mesh.is_alive(f)) continue;
    FacePolygon polygon(mesh, f);
    std::vector<CornerTriangle> local;
    if (polygon.is_finite()) polygon.triangulate(local);
    const std::vector<std::uint32_t> slots = triangles.slots_of(mesh, f);
    ASSERT_EQ(slots.size(), local.size()) << i;
    EXPECT_EQ(triangles.only_slot_of(mesh, f), slots.size() == 1 ? slots[0] : no_index);
    expected += slots.size();
    int sides = 0;
    for (const std::uint32_t slot : slots) {
      const SurfaceTriangle t = triangles.at(mesh, slot);
      EXPECT_EQ(t.face, i);
      sides += std::popcount(t.edge_bits);
      EXPECT_TRUE(std::any_of(local.begin(), local.end(), [&](const CornerTriangle& c) {
        const auto vertex = [&](std::size_t k) { return mesh.from(polygon.corners()[c[k]]).index; };
        return t.corners == std::array{vertex(0), vertex(1), vertex(2)};
      }));
    }
    EXPECT_TRUE(slots.empty() || sides == static_cast<int>(polygon.corners().size())) << i;
  }
  const std::vector<Held> held = held_by(triangles, mesh);
  const auto used = std::count_if(held.begin(), held.end(), [](const Held& h) { return h.face != no_index; });
  EXPECT_EQ(static_cast<std::size_t>(used), expected);
}

TEST(surface_triangles, hold_the_faces_through_edits_and_tell_which_slots_changed) {
  int at_home = 0;
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    Mesh mesh = test::random_kernel_mesh(seed);
    Journal journal;
    Dice dice(seed);
    SurfaceTriangles triangles(mesh);
    expect_the_faces_of(mesh, triangles);
    for (int step = 0; step < 12; ++step) {
      std::vector<Held> before = held_by(triangles, mesh);
      const std::size_t transactions = journal.size();
      if (!test::edit_at_random(mesh, journal, dice) || journal.size() != transactions + 1) {
        triangles = SurfaceTriangles(mesh);
        continue;
      }
      const std::vector<std::uint32_t> changed = triangles.update(mesh, touched_elements(mesh, journal, transactions));
      expect_the_faces_of(mesh, triangles);
      const std::vector<Held> after = held_by(triangles, mesh);
      before.resize(std::max(before.size(), after.size()), {{0, 0, 0}, no_index});
      for (std::uint32_t slot = 0; slot < after.size(); ++slot)
        EXPECT_TRUE(before[slot] == after[slot] || std::binary_search(changed.begin(), changed.end(), slot));
    }
    for (std::uint32_t f = 0; f < mesh.face_slots(); ++f)
      at_home += mesh.is_alive(Face(f)) && triangles.only_slot_of(mesh, Face(f)) == f;
  }
  EXPECT_GT(at_home, 100);
}

TEST(surface_triangles, of_triangles_alone_are_in_the_slots_of_their_faces) {
  const Mesh mesh = test::make_mesh(test::tetrahedron());
  const SurfaceTriangles triangles(mesh);
  EXPECT_EQ(triangles.slots(), 4u);
  for (std::uint32_t f = 0; f < 4; ++f) EXPECT_EQ(triangles.only_slot_of(mesh, Face(f)), f);
}

}  // namespace
}  // namespace ryosen
