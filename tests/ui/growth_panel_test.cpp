// The panel of growth: it measures beside the frames when its button is pressed, and can be cancelled.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/editor/growth_work.h"
#include "core/forms/pairing.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

class GrowthPanelTest : public testing::Test, protected test::Laid {
 protected:
  GrowthPanelTest() : Laid("torus.off", test::tall_window) {
    for (const PanelRow& row : panel_list())
      if (row.place == PanelPlace::right) session.run("panel " + std::string(row.id) + " off");
    session.run("panel growth");
    session.trials().in_background = true;  // as in a window
    frames(3);
  }
  bool has(std::string_view text) const { return test::DrawnText(gui).count(text) > 0; }
  void take(std::string_view text) {
    click(test::DrawnText(gui).place(text));
    frames(3);
  }
  // Until what is measured is there.
  void frames_until(std::string_view text) {
    for (int i = 0; i < 500 && !has(text); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      frames(1);
    }
    EXPECT_TRUE(has(text));
  }
};

TEST_F(GrowthPanelTest, draws_the_curves_with_their_slopes) {
  EXPECT_FALSE(has("slope"));
  take("Thismesh");
  frames_until("slope");
  EXPECT_TRUE(has("comparisons"));
  EXPECT_TRUE(has("2.00")) << "all pairs";
  EXPECT_TRUE(has("sortingallsides"));
  take("Time");
  EXPECT_TRUE(has("milliseconds"));
  ASSERT_TRUE(session.run("language ja").done());
  frames(3);
  EXPECT_FALSE(has("slope")) << "in Japanese";
}

TEST_F(GrowthPanelTest, can_be_cancelled) {
  take("Tori");
  frames_until("Cancel");
  take("Cancel");
  EXPECT_TRUE(has("Tori"));
  EXPECT_FALSE(has("slope"));
}

TEST(growth_work, runs_beside_and_keeps_what_it_found_before) {
  GrowthWork work;
  EXPECT_TRUE(work.curves().empty());
  work.begin(nullptr, {200, 1e6, 1e-6});
  work.wait();
  EXPECT_FALSE(work.is_running());
  const std::size_t found = work.curves().size();
  EXPECT_GT(found, pairing_methods().size());
  work.begin(nullptr);
  work.cancel();
  EXPECT_EQ(work.curves().size(), found);
}

}  // namespace
}  // namespace ryosen
