#include "render/pass/ui_damage.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>

namespace ryosen {
namespace {

constexpr Size size{200, 100};

class UiDamageTest : public testing::Test {
 protected:
  UiDamageTest() { ImGui::CreateContext(); }
  ~UiDamageTest() override { ImGui::DestroyContext(); }
};

// A list of draw commands that is filled by hand.
class Drawing {
 public:
  Drawing() {
    list_._ResetForNewFrame();
    list_.PushClipRect({0, 0}, {static_cast<float>(size.width), static_cast<float>(size.height)});
  }
  Drawing& triangle(float x, float y, ImU32 colour = IM_COL32_WHITE) {
    list_.PrimReserve(3, 3);
    list_.PrimVtx({x, y}, {0, 0}, colour);
    list_.PrimVtx({x + 10, y}, {0, 0}, colour);
    list_.PrimVtx({x, y + 10}, {0, 0}, colour);
    return *this;
  }
  const ImDrawData& data() {
    lists_[0] = &list_;
    data_.CmdLists = lists_;
    data_.CmdListsCount = 1;
    return data_;
  }

 private:
  ImDrawList list_{ImGui::GetDrawListSharedData()};
  ImDrawList* lists_[1] = {};
  ImDrawData data_;
};

PixelRect hull(const std::vector<PixelRect>& rects) {
  PixelRect all;
  for (const PixelRect& rect : rects) {
    if (rect.empty()) continue;
    all = all.empty() ? rect
                      : PixelRect{std::min(all.x0, rect.x0), std::min(all.y0, rect.y0), std::max(all.x1, rect.x1),
                                  std::max(all.y1, rect.y1)};
  }
  return all;
}

TEST_F(UiDamageTest, the_first_drawing_is_all_new_and_the_same_again_is_nothing) {
  UiDamage damage;
  EXPECT_EQ(hull(damage.update(Drawing().triangle(5, 5).data(), size)), PixelRect::all(size));
  EXPECT_TRUE(hull(damage.update(Drawing().triangle(5, 5).data(), size)).empty());
  damage.forget();
  EXPECT_EQ(hull(damage.update(Drawing().triangle(5, 5).data(), size)), PixelRect::all(size));
}

TEST_F(UiDamageTest, a_changed_triangle_costs_its_own_rectangle) {
  UiDamage damage;
  damage.update(Drawing().triangle(5, 5).triangle(50, 50).triangle(150, 5).data(), size);
  const PixelRect coloured =
      hull(damage.update(Drawing().triangle(5, 5).triangle(50, 50, 0xFF0000FFu).triangle(150, 5).data(), size));
  EXPECT_EQ(coloured, (PixelRect{49, 49, 61, 61}));
  const PixelRect moved =
      hull(damage.update(Drawing().triangle(5, 5).triangle(70, 50, 0xFF0000FFu).triangle(150, 5).data(), size));
  EXPECT_EQ(moved, (PixelRect{49, 49, 81, 61})) << "the old place and the new";
}

TEST_F(UiDamageTest, a_triangle_that_comes_or_goes_leaves_those_behind_it_alone) {
  UiDamage damage;
  damage.update(Drawing().triangle(5, 5).triangle(150, 5).data(), size);
  const PixelRect place{49, 49, 61, 61};
  EXPECT_EQ(hull(damage.update(Drawing().triangle(5, 5).triangle(50, 50).triangle(150, 5).data(), size)), place);
  EXPECT_EQ(hull(damage.update(Drawing().triangle(5, 5).triangle(150, 5).data(), size)), place);
}

TEST_F(UiDamageTest, rectangles_end_with_the_window) {
  UiDamage damage;
  damage.update(Drawing().data(), size);
  EXPECT_EQ(hull(damage.update(Drawing().triangle(195, 95).data(), size)), (PixelRect{194, 94, 200, 100}));
}

}  // namespace
}  // namespace ryosen
