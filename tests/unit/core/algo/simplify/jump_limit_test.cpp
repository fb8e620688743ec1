// The limit of what a collapse may cost before the shape is lost, against all that was told of those before.
#include "ryosen/algo/simplify/jump_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "tests/support/core/random_meshes.h"

namespace ryosen::test {
namespace {

TEST(jump_limit, is_a_share_of_the_size_as_long_as_the_error_is_small) {
  JumpLimit limit(10, 1000);
  for (std::size_t faces = 998; faces > 200; faces -= 2) limit.follow(faces, 0.001);
  EXPECT_DOUBLE_EQ(limit.limit(), 0.5);
}

TEST(jump_limit, is_none_until_a_quarter_of_the_faces_is_left) {
  JumpLimit limit(10, 12);
  for (const std::size_t faces : {10u, 6u, 4u}) {
    limit.follow(faces, 3);
    EXPECT_EQ(limit.limit(), std::numeric_limits<double>::infinity()) << "little was told of twice as many faces";
  }
  limit.follow(3, 3);
  EXPECT_DOUBLE_EQ(limit.limit(), 9) << "three was lost at six";
}

// Five sequences of random errors, by asking all that was told.
TEST(jump_limit, is_three_times_the_largest_error_at_twice_as_many_faces) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Dice dice(seed);
    const std::size_t first = 500 + 100 * seed;
    JumpLimit limit(1, first);
    std::vector<std::pair<std::size_t, double>> told{{first, 0.0}};
    double error = 0;
    for (std::size_t faces = first; faces > 4;) {
      faces -= std::min<std::size_t>(faces, static_cast<std::size_t>(1 + dice.below(3)));
      if (dice.below(3) == 0) error += 0.001 * dice.below(10);
      limit.follow(faces, error);
      told.emplace_back(faces, error);
      if (first < 4 * faces) continue;
      double before = 0;
      for (const auto& [then, largest] : told)
        if (then >= 2 * faces) before = std::max(before, largest);
      ASSERT_DOUBLE_EQ(limit.limit(), std::max(0.05, 3 * before)) << "seed " << seed << ", " << faces << " faces";
    }
    EXPECT_GT(limit.limit(), 0.05) << "seed " << seed << " tells nothing";
  }
}

}  // namespace
}  // namespace ryosen::test
