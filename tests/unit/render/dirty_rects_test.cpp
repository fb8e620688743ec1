#include "render/dirty_rects.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace ryosen {
namespace {

TEST(dirty_rects, far_ones_stay_apart_and_near_ones_merge) {
  DirtyRects dirty;
  dirty.add({0, 0, 10, 10});
  dirty.add({900, 600, 920, 620});
  EXPECT_EQ(dirty.rects().size(), 2u);
  dirty.add({5, 5, 30, 30});
  EXPECT_EQ(dirty.rects().size(), 2u);
  EXPECT_EQ(dirty.bounds(), (PixelRect{0, 0, 920, 620}));
  dirty.remove_inside({0, 0, 40, 40});
  ASSERT_EQ(dirty.rects().size(), 1u);
  EXPECT_EQ(dirty.rects()[0], (PixelRect{900, 600, 920, 620}));
}

TEST(dirty_rects, empty_ones_add_nothing) {
  DirtyRects dirty;
  dirty.add({5, 5, 5, 9});
  dirty.add({7, 9, 6, 12});
  EXPECT_TRUE(dirty.empty());
  EXPECT_TRUE(dirty.bounds().empty());
}

TEST(dirty_rects, cover_what_was_added_without_overlap) {
  std::mt19937 random(11);
  for (int round = 0; round < 200; ++round) {
    DirtyRects dirty;
    std::vector<PixelRect> added;
    for (int i = 0; i < 12; ++i) {
      const int x = int(random() % 1200), y = int(random() % 700);
      added.push_back({x, y, x + 1 + int(random() % 90), y + 1 + int(random() % 90)});
      dirty.add(added.back());
    }
    for (const PixelRect& rect : added) {
      int covering = 0;
      for (const PixelRect& r : dirty.rects()) covering += intersection(r, rect) == rect;
      ASSERT_EQ(covering, 1);
    }
    for (const PixelRect& a : dirty.rects()) {
      for (const PixelRect& b : dirty.rects()) ASSERT_TRUE(&a == &b || !overlap(a, b));
    }
  }
}

}  // namespace
}  // namespace ryosen
