// The panel of growth: it measures beside the frames when its button is pressed, and can be cancelled.
#include <gtest/gtest.h>

#include <imgui.h>

#include <chrono>
#include <set>
#include <thread>

#include "app/editor/session/session.h"
#include "app/editor/textbook/growth_work.h"
#include "app/ui/log_plot.h"
#include "ryosen/textbook/forms/pairing.h"
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
    session.trials.in_background = true;  // as in a window
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

// The places of what is drawn of a plot with so many curves, of which this one alone has a point.
std::vector<std::pair<float, float>> drawn_with_point_of(std::size_t k, std::size_t curves) {
  LogPlot plot{"", "", "", "", std::vector<LogCurve>(curves)};
  plot.curves[k].points = {{10, 10}};
  ImDrawList list(ImGui::GetDrawListSharedData());
  list._ResetForNewFrame();
  list.PushTextureID(ImGui::GetIO().Fonts->TexID);
  list.PushClipRectFullScreen();
  draw_log_plot(list, {0, 0}, 600, plot, Theme::dark);
  std::vector<std::pair<float, float>> places;
  for (const ImDrawVert& vertex : list.VtxBuffer) places.emplace_back(vertex.pos.x, vertex.pos.y);
  return places;
}

TEST_F(GrowthPanelTest, each_curve_has_a_mark_of_its_own_without_its_colour) {
  gui.prepare(session);
  ImGui::NewFrame();                  // there is a font
  constexpr std::size_t curves = 14;  // as many as a plot of queries has
  std::set<std::vector<std::pair<float, float>>> marks;
  for (std::size_t k = 0; k < curves; ++k) marks.insert(drawn_with_point_of(k, curves));
  ImGui::EndFrame();
  EXPECT_EQ(marks.size(), curves);
}

}  // namespace
}  // namespace ryosen
