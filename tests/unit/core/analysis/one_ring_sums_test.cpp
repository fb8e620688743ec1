#include "ryosen/analysis/one_ring_sums.h"

#include <gtest/gtest.h>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "tests/support/core/random_ops.h"

namespace ryosen {
namespace {

using namespace test;

// Whole numbers, so that no order of adding them matters.
std::vector<glm::dvec3> values_of(const Mesh& mesh, Dice& dice) {
  std::vector<glm::dvec3> values(mesh.vertex_slots());
  for (glm::dvec3& value : values) value = {dice.below(1000), dice.below(1000), dice.below(1000)};
  return values;
}

TEST(one_ring_sums, are_what_walking_around_each_vertex_gives) {
  std::size_t isolated = 0, dead = 0, several_fans = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Mesh mesh = random_complex(seed);
    Dice dice(seed);
    const std::vector<glm::dvec3> values = values_of(mesh, dice);
    std::vector<glm::dvec3> sums(values.size(), glm::dvec3(7));
    one_ring_sums(mesh, values, sums);
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
      const Vertex v(i);
      glm::dvec3 sum(0);
      if (mesh.is_alive(v)) {
        for (Vertex w : neighbours(mesh, v)) sum += values[w.index];
        several_fans += count_fans(mesh, v) > 1;
        isolated += mesh.is_isolated(v);
      } else {
        ++dead;
      }
      ASSERT_EQ(sums[i], sum) << "seed " << seed << " vertex " << i;
    }
  }
  EXPECT_GT(isolated, 0u);
  EXPECT_GT(dead, 0u);
  EXPECT_GT(several_fans, 0u);
}

}  // namespace
}  // namespace ryosen
