#include "app/editor/input/corner_axes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/editor/session/session.h"
#include "ryosen/scene/view/named_views.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class CornerAxesTest : public testing::Test {
 protected:
  CornerAxesTest() : session_(Document::open(test::asset("cube.obj")).value()) {
    session_.framing.frame_all();
    run("axes on");
    run("view iso");
  }
  void run(const std::string& line) {
    const Outcome outcome = session_.run(line);
    EXPECT_TRUE(outcome.done()) << line << ": " << outcome.sentence.en;
  }
  // In the picture.
  glm::dvec2 pixel_of(std::string_view name) const {
    const auto axes = session_.pointing.axes_in_corner();
    for (const PlacedAxisEnd& placed : axes->ends)
      if (placed.end->name == name) return placed.pixel + session_.view.origin;
    ADD_FAILURE() << name;
    return {};
  }
  void click(std::string_view name) {
    const glm::dvec2 at = pixel_of(name);
    run("click " + std::to_string(at.x) + "," + std::to_string(at.y));
  }

  Session session_;
};

TEST_F(CornerAxesTest, lie_as_the_axes_of_the_mesh_do_in_the_view) {
  const CornerAxes corner = *session_.pointing.axes_in_corner();
  const glm::dvec3 middle = session_.view.camera.target;
  const double unit = 1e-3 * glm::length(session_.view.camera.target - session_.view.camera.eye);
  for (const PlacedAxisEnd& placed : corner.ends) {
    glm::dvec3 along(0);
    along[placed.end->axis] = placed.end->is_negative ? -unit : unit;
    const glm::dvec2 seen = project(session_.view.camera, session_.view.size, middle + along)->pixel -
                            project(session_.view.camera, session_.view.size, middle)->pixel;
    const glm::dvec2 drawn = placed.pixel - corner.middle;
    EXPECT_GT(glm::dot(glm::normalize(seen), glm::normalize(drawn)), 0.999) << placed.end->name;
  }
}

TEST_F(CornerAxesTest, a_click_on_an_end_looks_from_there_and_keeps_centre_and_distance) {
  run("wheel 3 640,360");
  const glm::dvec3 target = session_.view.camera.target;
  const double distance = glm::length(target - session_.view.camera.eye);
  for (const auto& [name, from] : {std::pair("+X", glm::dvec3(1, 0, 0)), std::pair("+Y", glm::dvec3(0, 1, 0)),
                                   std::pair("-Z", glm::dvec3(0, 0, -1))}) {
    run("drag 300,600 340,640");  // so that every end can be clicked
    click(name);
    EXPECT_LT(glm::length(glm::normalize(session_.view.camera.eye - session_.view.camera.target) - from), 1e-9) << name;
    EXPECT_NEAR(glm::length(session_.view.camera.eye - session_.view.camera.target), distance, 1e-9 * distance);
  }
  EXPECT_LT(glm::length(session_.view.camera.target - target), 1e-9 * distance);
}

TEST_F(CornerAxesTest, a_second_click_looks_from_the_opposite_side) {
  click("+X");
  click("+X");
  EXPECT_GT(glm::dot(axes(session_.view.camera).forward, glm::dvec3(1, 0, 0)), 1 - 1e-9);
}

TEST_F(CornerAxesTest, take_the_click_and_the_pointer_from_tools_and_mesh) {
  run("tool collapse");
  const std::uint64_t revision = session_.document().revision();
  const glm::dvec2 at = pixel_of("+Z");
  session_.pointing.point_at(at);
  ASSERT_TRUE(session_.pointing.pointed_axis_end());
  EXPECT_EQ(session_.pointing.pointed_axis_end()->name, "+Z");
  EXPECT_FALSE(session_.selecting.hover());
  click("+Z");
  EXPECT_EQ(session_.document().revision(), revision);
  run("axes off");
  session_.pointing.point_at(at);
  EXPECT_FALSE(session_.pointing.pointed_axis_end());
}

TEST_F(CornerAxesTest, are_sized_by_the_display_and_absent_where_there_is_no_room) {
  const CornerAxes usual = *session_.pointing.axes_in_corner();
  session_.preferences.display_scale = 2;
  const CornerAxes large = *session_.pointing.axes_in_corner();
  EXPECT_DOUBLE_EQ(large.ends[0].radius_px, 2 * usual.ends[0].radius_px);
  EXPECT_NEAR(glm::length(large.ends[0].pixel - large.middle), 2 * glm::length(usual.ends[0].pixel - usual.middle),
              1e-9);
  session_.view.size = {400, 300};
  EXPECT_FALSE(session_.pointing.axes_in_corner());
}

}  // namespace
}  // namespace ryosen
