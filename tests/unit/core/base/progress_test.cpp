#include "ryosen/base/progress.h"

#include <gtest/gtest.h>

#include <vector>

namespace ryosen {
namespace {

TEST(progress, one_that_nobody_listens_to_never_stops) {
  Progress progress;
  for (std::size_t i = 0; i < 10; ++i) EXPECT_TRUE(progress.go_on(i, 10));
  EXPECT_FALSE(progress.is_cancelled());
}

TEST(progress, tells_the_share_and_stays_stopped) {
  std::vector<double> told;
  Progress progress(
      [&](double share) {
        told.push_back(share);
        return share < 0.5;
      },
      {});
  EXPECT_TRUE(progress.go_on(0, 4));
  EXPECT_TRUE(progress.go_on(1, 4));
  EXPECT_TRUE(progress.go_on()) << "within a step the share stays";
  EXPECT_FALSE(progress.go_on(2, 4));
  EXPECT_FALSE(progress.go_on(0, 4)) << "stopped once, stopped for good";
  EXPECT_TRUE(progress.is_cancelled());
  EXPECT_EQ(told, (std::vector<double>{0, 0.25, 0.25, 0.5}));
}

TEST(progress, steps_of_a_part_are_a_share_of_it) {
  std::vector<double> told;
  Progress progress([&](double share) { return told.push_back(share), true; }, {});
  for (std::size_t part = 0; part < 2; ++part) {
    progress.begin_part(part, 2);
    progress.go_on();
    progress.go_on(1, 2);
    progress.go_on(2, 2);
  }
  EXPECT_EQ(told, (std::vector<double>{0, 0.25, 0.5, 0.5, 0.75, 1}));
}

TEST(progress, is_told_at_first_and_then_seldom) {
  int told = 0;
  Progress progress([&](double) { return ++told > 0; }, std::chrono::hours(1));
  for (std::size_t i = 0; i < 1000; ++i) EXPECT_TRUE(progress.go_on(i, 1000));
  EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace ryosen
