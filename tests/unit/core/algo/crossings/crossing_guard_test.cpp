// What a guard of a surface tells of a step, against a comparison of all faces with each other.
#include "ryosen/algo/crossings/crossing_guard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ryosen/geometry/predicates.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/core/pairs_by_asking_all.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {
namespace {

// Two cones on one rough circle of n places.
IndexedMesh two_cones(std::uint32_t n) {
  IndexedMesh source;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n, radius = 1 + 0.05 * ((i * 7) % 5);
    source.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.02 * ((i * 3) % 7));
    const std::uint32_t k = (i + 1) % n;
    for (const std::uint32_t corner : {n, i, k, n + 1, k, i}) source.corners.push_back(corner);
    source.face_offsets.push_back(6 * i + 3);
    source.face_offsets.push_back(6 * i + 6);
  }
  source.positions.insert(source.positions.end(), {{0, 0, 1}, {0, 0, -1}});
  return source;
}

bool is_flat(const IndexedMesh& mesh, std::size_t face) {
  const auto at = [&](std::size_t k) { return mesh.positions[mesh.face(face)[k]]; };
  return are_collinear(at(0), at(1), at(2));
}

// Whether faces meet, or one has lost its area, when a vertex has become another one there.
bool meets_by_asking_all(const IndexedMesh& before, std::uint32_t gone, std::uint32_t kept,
                         const glm::dvec3& position) {
  IndexedMesh after;
  after.positions = before.positions;
  after.positions[kept] = position;
  for (std::size_t f = 0; f < before.face_count(); ++f) {
    const auto corners = before.face(f);
    if (std::count(corners.begin(), corners.end(), gone) + std::count(corners.begin(), corners.end(), kept) == 2)
      continue;
    for (const std::uint32_t corner : corners) after.corners.push_back(corner == gone ? kept : corner);
    after.face_offsets.push_back(static_cast<std::uint32_t>(after.corners.size()));
    if (is_flat(after, after.face_count() - 1) && !is_flat(before, f)) return true;
  }
  return !pairs_by_asking_all(after).empty();
}

TEST(crossing_guard, tells_of_a_hub_what_all_faces_tell) {
  const IndexedMesh source = two_cones(150);
  ASSERT_TRUE(pairs_by_asking_all(source).empty());
  const Mesh mesh = from_indexed(source);
  const CrossingGuard guard(mesh);
  Dice dice(11);
  constexpr int steps = 150;
  int refused = 0;
  for (int step = 0; step < steps; ++step) {
    const Halfedge h(static_cast<std::uint32_t>(dice.below(static_cast<int>(mesh.halfedge_slots()))));
    const Vertex gone = mesh.from(h), kept = mesh.to(h);
    const double along = dice.below(5) / 4.0;
    const glm::dvec3 beside = dice.one_in(2) ? 0.1 * glm::dvec3(dice.unit(), dice.unit(), dice.unit()) : glm::dvec3(0);
    const glm::dvec3 position = (1 - along) * mesh.position(gone) + along * mesh.position(kept) + beside;
    const bool expected = meets_by_asking_all(source, gone.index, kept.index, position);
    EXPECT_EQ(guard.would_meet(h, position), expected) << step << ": " << gone.index << " into " << kept.index;
    refused += expected ? 1 : 0;
  }
  EXPECT_GT(refused, steps / 10);
  EXPECT_LT(refused, steps * 9 / 10);
}

}  // namespace
}  // namespace ryosen::test
