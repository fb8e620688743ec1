#include "render/refinement.h"

#include <gtest/gtest.h>

#include <set>

namespace ryosen {
namespace {

std::vector<PixelRect> taken(Refinement& refinement) {
  std::vector<PixelRect> rects;
  while (const auto part = refinement.take()) rects.push_back(part->rect);
  EXPECT_TRUE(refinement.is_done());
  return rects;
}

std::int64_t pixels(const std::vector<PixelRect>& rects) {
  std::int64_t sum = 0;
  for (const PixelRect& rect : rects) sum += std::int64_t{rect.width()} * rect.height();
  return sum;
}

TEST(refinement, takes_every_pixel_once) {
  for (const Size size : {Size{1, 1}, Size{128, 128}, Size{129, 127}, Size{640, 480}}) {
    Refinement refinement;
    EXPECT_TRUE(refinement.is_done());
    refinement.begin(size);
    EXPECT_FALSE(refinement.is_done());
    const std::vector<PixelRect> rects = taken(refinement);
    EXPECT_EQ(pixels(rects), std::int64_t{size.width} * size.height);
    for (std::size_t i = 0; i < rects.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(rects[i], rects[k]));
  }
}

TEST(refinement, takes_again_the_tiles_that_were_drawn_over) {
  Refinement refinement;
  refinement.begin({640, 480});
  taken(refinement);
  refinement.spoil({130, 130, 131, 131});
  EXPECT_EQ(taken(refinement), (std::vector{PixelRect{128, 128, 256, 256}}));
  refinement.spoil({250, 0, 260, 10});
  EXPECT_EQ(pixels(taken(refinement)), 2 * 128 * 128);
  refinement.spoil({700, 0, 800, 10});
  EXPECT_TRUE(refinement.is_done()) << "outside";
}

TEST(refinement, halves_what_is_too_much_within_its_tile) {
  Refinement refinement;
  refinement.begin({128, 256});
  const auto first = refinement.take();
  ASSERT_TRUE(first);
  refinement.halve(*first);
  const auto half = refinement.take();
  ASSERT_TRUE(half);
  EXPECT_EQ(half->tile, first->tile);
  EXPECT_EQ(pixels({half->rect}), 128 * 64);
  refinement.spoil({0, 0, 5, 5});  // the other half is of a tile that is coarse again
  EXPECT_EQ(pixels(taken(refinement)), 128 * 256);
}

}  // namespace
}  // namespace ryosen
