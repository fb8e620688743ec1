// Another mesh beside the open one: the picture is shared, the camera is one, and distances follow edits.
#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/session.h"
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
  EXPECT_EQ(session.view.width + other->view.width, 798) << "with a line between them";
  EXPECT_EQ(session.view_origin, glm::dvec2(100, 20));
  EXPECT_EQ(other->view_origin, glm::dvec2(100 + session.view.width + 2, 20));
  session.run("view top");
  session.run("wire off");
  EXPECT_EQ(session.beside()->camera.eye, session.camera.eye);
  EXPECT_EQ(session.beside()->settings.wire, session.settings.wire);
  EXPECT_EQ(session.document().history().size(), 0u) << "it is no edit";
  EXPECT_TRUE(session.run("compare off").done());
  EXPECT_FALSE(session.has_beside());
  EXPECT_EQ(session.view.width, 800);
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
  EXPECT_EQ(figures_of(session.map_values().all()).highest, 0);
  ASSERT_TRUE(session.run("translate by=0,0,3").done());
  EXPECT_EQ(figures_of(session.map_values().all()).highest, 3);
  EXPECT_EQ(figures_of(session.map_values().all()).lowest, 2);
  EXPECT_EQ(figures_of(session.beside()->map_values().all()).highest, 3) << "the other one from this";
  session.run("undo");
  EXPECT_EQ(figures_of(session.map_values().all()).highest, 0);
  EXPECT_EQ(figures_of(session.beside()->map_values().all()).highest, 0);
  session.run("compare off");
  EXPECT_FALSE(session.colouring);
}

}  // namespace
}  // namespace ryosen
