#include "ryosen/base/interruption.h"

#include <gtest/gtest.h>

#include <vector>

#include "ryosen/base/parallel.h"

namespace ryosen {
namespace {

TEST(interruption, ends_only_what_lets_itself_be_ended) {
  std::atomic<bool> flag = false;
  stop_if_interrupted();
  const Interruptible interruptible(&flag);
  stop_if_interrupted();
  flag = true;
  EXPECT_THROW(stop_if_interrupted(), Interrupted);
  EXPECT_THROW(stop_if_interrupted(4096), Interrupted);
  stop_if_interrupted(4097);  // not each of the small steps asks
  {
    const Interruptible not_this(nullptr);
    stop_if_interrupted();
  }
  EXPECT_THROW(stop_if_interrupted(), Interrupted);
}

TEST(interruption, reaches_what_helps) {
  const std::atomic<bool> flag = true;
  for (int turn = 0; turn < 20; ++turn) {
    std::atomic<int> ended = 0;
    const auto work = [&](unsigned) {
      try {
        stop_if_interrupted();
      } catch (const Interrupted&) {
        ++ended;
      }
    };
    {
      const Interruptible interruptible(&flag);
      for_each_task(50, 2, work);
    }
    EXPECT_EQ(ended, 50);
    for_each_task(50, 2, work);
    EXPECT_EQ(ended, 50);  // the helpers have forgotten it
  }
}

TEST(interruption, growing_in_steps_is_growing) {
  std::vector<int> values{1, 2};
  resize_in_steps(values, 200000);
  EXPECT_EQ(values.size(), 200000u);
  EXPECT_EQ(values[1], 2);
  EXPECT_EQ(values.back(), 0);
  const std::atomic<bool> flag = true;
  const Interruptible interruptible(&flag);
  EXPECT_THROW(resize_in_steps(values, 300000), Interrupted);
}

}  // namespace
}  // namespace ryosen
