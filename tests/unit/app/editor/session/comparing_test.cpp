// Another mesh beside the open one: the picture is shared, the camera is one, and distances follow edits.
#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/camera/navigation.h"
#include "app/editor/session/session.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

std::unique_ptr<Document> opened(const char* name) { return std::move(Document::open(test::asset(name))).value(); }

TEST(comparing, shares_the_picture_and_looks_the_same_way) {
  Session session(opened("cube.obj"));
  session.place_view({800, 600}, {100, 20});
  ASSERT_TRUE(session.run("compare " + test::asset("torus.off")).done());
  Session* const other = session.beside();
  ASSERT_NE(other, nullptr);
  EXPECT_EQ(session.view.size.width + other->view.size.width, 798) << "with a line between them";
  EXPECT_EQ(session.view.origin, glm::dvec2(100, 20));
  EXPECT_EQ(other->view.origin, glm::dvec2(100 + session.view.size.width + 2, 20));
  session.run("view top");
  session.run("wire off");
  EXPECT_EQ(session.beside()->view.camera.eye, session.view.camera.eye);
  EXPECT_EQ(session.beside()->view.settings.wire, session.view.settings.wire);
  EXPECT_EQ(session.document().history().size(), 0u) << "it is no edit";
  EXPECT_TRUE(session.run("compare off").done());
  EXPECT_FALSE(session.has_beside());
  EXPECT_EQ(session.view.size.width, 800);
  session.run("compare " + test::asset("torus.off"));
  session.run("new");
  EXPECT_FALSE(session.has_beside());
}

TEST(comparing, refuses_what_is_no_mesh_and_keeps_what_was_there) {
  Session session(opened("cube.obj"));
  session.run("compare " + test::asset("torus.off"));
  EXPECT_EQ(session.run("compare nosuch.obj").exit_code, ExitCode::input_missing);
  EXPECT_TRUE(session.has_beside());
  EXPECT_EQ(session.run("compare").exit_code, ExitCode::usage);
}

TEST(comparing, colours_both_by_the_distance_from_the_other_and_follows_edits) {
  Session session(opened("cube.obj"));
  EXPECT_EQ(session.run("colours distance").exit_code, ExitCode::refused) << "from nothing";
  session.run("compare " + test::asset("cube.obj"));
  ASSERT_TRUE(session.run("colours distance").done());
  EXPECT_EQ(figures_of(session.findings().map_values().all()).highest, 0);
  ASSERT_TRUE(session.run("translate by=0,0,3").done());
  EXPECT_EQ(figures_of(session.findings().map_values().all()).highest, 3);
  EXPECT_EQ(figures_of(session.findings().map_values().all()).lowest, 2);
  EXPECT_EQ(figures_of(session.beside()->findings().map_values().all()).highest, 3) << "the other one from this";
  session.run("undo");
  EXPECT_EQ(figures_of(session.findings().map_values().all()).highest, 0);
  EXPECT_EQ(figures_of(session.beside()->findings().map_values().all()).highest, 0);
  session.run("compare off");
  EXPECT_FALSE(session.view.colouring);
}

TEST(comparing, points_at_either_mesh_and_works_on_the_open_one_alone) {
  Session session(opened("cube.obj"));
  session.place_view({800, 600}, {100, 20});
  ASSERT_TRUE(session.run("compare " + test::asset("torus.off")).done());
  session.run("mode face");
  session.beside();
  const auto middle = [](const Session& one) {
    return one.view.origin + 0.5 * glm::dvec2(one.view.size.width, one.view.size.height);
  };
  session.framing.frame_all();
  // The torus has a hole in the middle; beside it there is a face.
  glm::dvec2 over_other = middle(*session.beside());
  while (!session.part_at(over_other).pointing.pick(over_other, PickMode::face) && over_other.x < 890) over_other.x += 5;
  ASSERT_LT(over_other.x, 890);
  session.pointing.point_at(over_other);
  EXPECT_FALSE(session.selecting.hover());
  ASSERT_TRUE(session.beside()->selecting.hover());
  EXPECT_EQ(session.beside()->selecting.hover()->picked.element.kind, Element::Kind::face) << "in the mode of the open mesh";
  const Outcome clicked = session.pointing.click(over_other, session.selecting.tool);
  EXPECT_EQ(clicked.exit_code, ExitCode::refused);
  EXPECT_NE(clicked.sentence.en.find("torus.off"), std::string::npos);
  EXPECT_TRUE(session.selecting.selection.empty());
  EXPECT_TRUE(session.beside()->selecting.selection.empty());
  session.run("tool collapse");
  session.pointing.point_at(over_other);
  EXPECT_FALSE(session.beside()->selecting.hover() && session.beside()->selecting.hover()->op) << "nothing of it is edited";
  session.run("tool none");
  session.pointing.point_at(middle(session));
  EXPECT_TRUE(session.selecting.hover());
  EXPECT_FALSE(session.beside()->selecting.hover()) << "the pointer has left it";
  session.pointing.point_away();
  EXPECT_FALSE(session.selecting.hover());
}

TEST(comparing, both_halves_speak_one_language) {
  Session session(opened("cube.obj"));
  session.place_view({800, 600}, {0, 0});
  ASSERT_TRUE(session.run("compare " + test::asset("torus.off")).done());
  ASSERT_TRUE(session.run("language ja").done());
  EXPECT_EQ(session.beside()->preferences.language, Language::japanese);
}

TEST(comparing, the_wheel_goes_to_what_is_under_the_pointer_in_either_half) {
  Session session(opened("cube.obj"));
  session.place_view({800, 600}, {0, 0});
  ASSERT_TRUE(session.run("compare " + test::asset("cube.obj")).done());
  const Camera before = session.view.camera;
  const glm::dvec2 here = 0.5 * glm::dvec2(session.view.size.width, session.view.size.height) + glm::dvec2(20, 30);
  Navigation navigation;
  navigation.wheel(session, here, 2);
  const Camera left = session.view.camera;
  session.view.camera = before;
  navigation.wheel(session, here + session.beside()->view.origin, 2);
  EXPECT_NE(session.view.camera, before);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(session.view.camera.eye[k], left.eye[k], 1e-9) << "the same mesh, the same camera";
}

}  // namespace
}  // namespace ryosen
