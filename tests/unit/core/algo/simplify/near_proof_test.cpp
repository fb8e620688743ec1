// Proofs of nearness, judged by dense samples and slow distances.
#include "ryosen/algo/simplify/near_proof.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/core/farthest_sample.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {
namespace {

TriangleCorners triangle_at_random(Dice& dice, double height) {
  TriangleCorners corners;
  for (glm::dvec3& corner : corners) corner = {dice.unit(), dice.unit(), height * dice.unit()};
  return corners;
}

TEST(near_proof, says_nothing_that_samples_deny) {
  Dice dice(5);
  NearProof proof;
  std::size_t proved = 0, proved_by_bounds = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<NearTarget> targets;
    for (int k = dice.below(6) + 1; k > 0; --k)
      targets.push_back(target_of(triangle_at_random(dice, 0.2), dice.one_in(2) ? 0 : 0.2 * dice.unit()));
    const TriangleCorners triangle = triangle_at_random(dice, 0.2);
    std::vector<glm::dvec3> inner;
    for (const NearTarget& target : targets) inner.push_back(target.corners[0]);
    if (!proof.prove(triangle, targets, inner, {0.3, 64})) continue;
    ++proved;
    EXPECT_LE(proof.bound(), 0.3);
    EXPECT_LE(farthest_sample(triangle, targets, 12), proof.bound() + 1e-14) << i;
    for (const std::uint32_t target : proof.used()) {
      ASSERT_LT(target, targets.size());
      EXPECT_LE(targets[target].bound, proof.bound());
      proved_by_bounds += targets[target].bound > 0;
    }
  }
  EXPECT_GT(proved, 150u);
  EXPECT_LT(proved, 1950u);
  EXPECT_GT(proved_by_bounds, 100u);
}

// A triangle over a fan of triangles with a peak.
TEST(near_proof, finds_what_is_near_several_triangles_together) {
  const glm::dvec3 peak{0.1, 0.05, 0.01};
  std::vector<NearTarget> fan;
  std::vector<glm::dvec3> ring;
  for (int i = 0; i < 7; ++i) ring.emplace_back(2 * std::cos(0.8975979 * i), 2 * std::sin(0.8975979 * i), 0.0);
  for (std::size_t i = 0; i < 7; ++i) fan.push_back(target_of({peak, ring[i], ring[(i + 1) % 7]}, 0));
  const TriangleCorners triangle{glm::dvec3{-1, -0.6, 0}, {1, -0.6, 0}, {0, 1, 0}};
  NearProof proof;
  for (const double most : {0.011, 0.02, 0.1, 1.0, 10.0}) {
    EXPECT_TRUE(proof.prove(triangle, fan, {&peak, 1}, {most, 256})) << most;
    EXPECT_LE(proof.bound(), std::min(most, 0.02));
    EXPECT_GE(proof.bound(), 0.0099);
  }
  for (const double most : {0.0, 0.001, 0.005, 0.009, 0.00999})
    EXPECT_FALSE(proof.prove(triangle, fan, {&peak, 1}, {most, 256})) << most;
}

TEST(near_proof, adds_the_bounds_of_targets) {
  const TriangleCorners triangle{glm::dvec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<NearTarget> same{target_of(triangle, 0.25)};
  NearProof proof;
  EXPECT_TRUE(proof.prove(triangle, same, {}, {0.3, 8, 0.25}));
  EXPECT_NEAR(proof.bound(), 0.25, 1e-14);
  EXPECT_FALSE(proof.prove(triangle, same, {}, {0.2, 8, 0.1}));
}

// Two sheets with a gap between them that no corner lies in.
TEST(near_proof, sees_a_gap_between_corners) {
  const TriangleCorners triangle{glm::dvec3{0, 0, 0}, {4, 0, 0}, {0, 1, 0}};
  NearProof proof;
  for (const double gap : {0.0, 0.05, 0.19, 0.21, 0.5, 1.0}) {
    const double left = 2 - gap / 2, right = 2 + gap / 2;
    const std::vector<NearTarget> sheets{target_of({glm::dvec3{-1, -3, 0}, {left, -3, 0}, {-1, 3, 0}}, 0),
                                         target_of({glm::dvec3{left, -3, 0}, {left, 3, 0}, {-1, 3, 0}}, 0),
                                         target_of({glm::dvec3{right, -3, 0}, {6, -3, 0}, {right, 3, 0}}, 0),
                                         target_of({glm::dvec3{6, -3, 0}, {6, 3, 0}, {right, 3, 0}}, 0)};
    EXPECT_EQ(proof.prove(triangle, sheets, {}, {0.1, 256}), gap < 0.2) << gap;
  }
}

// Two sheets, each near one of two neighbouring numbers: nothing between them is left to part.
TEST(near_proof, is_no_deeper_than_its_limit_however_many_pieces_it_may_have) {
  const TriangleCorners triangle{glm::dvec3{0, 0, 0}, {4, 0, 0}, {0, 1, 0}};
  NearProof proof;
  for (const double middle : {2.0, 1.0, 1.5, 1.75, 3.0})
    for (const std::size_t pieces : {std::size_t{64}, std::size_t{4096}, std::size_t{1'000'000}}) {
      constexpr double most = 0.125;
      const double left = middle - most, right = std::nextafter(middle, 4.0) + most;
      const std::vector<NearTarget> sheets{target_of({glm::dvec3{-1, -3, 0}, {left, -3, 0}, {-1, 3, 0}}, 0),
                                           target_of({glm::dvec3{left, -3, 0}, {left, 3, 0}, {-1, 3, 0}}, 0),
                                           target_of({glm::dvec3{right, -3, 0}, {6, -3, 0}, {right, 3, 0}}, 0),
                                           target_of({glm::dvec3{6, -3, 0}, {6, 3, 0}, {right, 3, 0}}, 0)};
      EXPECT_FALSE(proof.prove(triangle, sheets, {}, {most, pieces})) << middle;
      EXPECT_LE(proof.deepest(), NearProof::most_depth);
      EXPECT_GT(proof.deepest(), 30u) << "else it gave up for another reason";
    }
}

}  // namespace
}  // namespace ryosen::test
