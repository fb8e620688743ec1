#include "ryosen/scene/view/round_step.h"

#include <gtest/gtest.h>

namespace ryosen {
namespace {

TEST(RoundStep, is_the_largest_of_1_2_and_5_times_a_power_of_ten_that_is_no_larger) {
  EXPECT_EQ(round_step(0.7).size(), 0.5);
  EXPECT_EQ(round_step(0.49).size(), 0.2);
  EXPECT_EQ(round_step(1).size(), 1);
  EXPECT_EQ(round_step(1999).size(), 1000);
  EXPECT_EQ(round_step(2e-9).size(), 2e-9);
}

TEST(RoundStep, does_not_fall_to_the_next_by_what_rounding_to_single_precision_takes) {
  for (const double length : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 1e6})
    EXPECT_EQ(round_step(length * (1 - 1e-7)).size(), length);
}

TEST(RoundStep, multiples_are_the_decimal_numbers) {
  const RoundStep step = round_step(0.1);
  EXPECT_EQ(step.times(3), 0.3);
  EXPECT_EQ(step.nearest_to(0.7000001), 0.7);
  EXPECT_EQ(step.nearest_to(-1.13), -1.1);
  EXPECT_EQ(step.tenth().times(7), 0.07);
  EXPECT_EQ(round_step(50).nearest_to(149), 150);
}

}  // namespace
}  // namespace ryosen
