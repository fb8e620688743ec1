// Another mesh beside the open one: the picture is shared, the camera is one, and distances follow edits.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "app/editor/input/view/navigation.h"
#include "app/editor/labels/labels.h"
#include "app/editor/session/session.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

std::unique_ptr<Document> opened(const char* name) { return std::move(Document::open(test::asset(name))).value(); }

TEST(comparing, shares_the_picture_and_looks_the_same_way) {
  Session session(opened("cube.obj"));
  session.place_view({800, 600}, {100, 20});
  ASSERT_TRUE(session.run("compare " + test::asset("torus.off")).done());
  const Compared* const other = session.compared();
  ASSERT_NE(other, nullptr);
  EXPECT_EQ(session.view.size.width + other->state().size.width, 798) << "with a line between them";
  EXPECT_EQ(session.view.origin, glm::dvec2(100, 20));
  EXPECT_EQ(other->state().origin, glm::dvec2(100 + session.view.size.width + 2, 20));
  session.run("view top");
  session.run("wire off");
  EXPECT_EQ(session.compared()->state().camera.eye, session.view.camera.eye);
  EXPECT_EQ(session.compared()->state().settings.wire, session.view.settings.wire);
  EXPECT_EQ(session.document().history().size(), 0u) << "it is no edit";
  EXPECT_TRUE(session.run("compare off").done());
  EXPECT_FALSE(session.is_comparing());
  EXPECT_EQ(session.view.size.width, 800);
  session.run("compare " + test::asset("torus.off"));
  session.run("new");
  EXPECT_FALSE(session.is_comparing());
}

TEST(comparing, refuses_what_is_no_mesh_and_keeps_what_was_there) {
  Session session(opened("cube.obj"));
  session.run("compare " + test::asset("torus.off"));
  EXPECT_EQ(session.run("compare nosuch.obj").exit_code, ExitCode::input_missing);
  EXPECT_TRUE(session.is_comparing());
  EXPECT_EQ(session.run("compare").exit_code, ExitCode::usage);
}

TEST(comparing, colours_both_by_the_distance_from_the_other_and_follows_edits) {
  Session session(opened("cube.obj"));
  EXPECT_EQ(session.run("colours distance").exit_code, ExitCode::refused) << "from nothing";
  session.run("compare " + test::asset("cube.obj"));
  ASSERT_TRUE(session.run("colours distance").done());
  EXPECT_EQ(figures_of(session.findings().map_values(*session.view.colouring).all()).highest, 0);
  ASSERT_TRUE(session.run("translate by=0,0,3").done());
  EXPECT_EQ(figures_of(session.findings().map_values(*session.view.colouring).all()).highest, 3);
  EXPECT_EQ(figures_of(session.findings().map_values(*session.view.colouring).all()).lowest, 2);
  EXPECT_EQ(figures_of(session.compared()->findings().map_values(*session.view.colouring).all()).highest, 3)
      << "the other one from this";
  session.run("undo");
  EXPECT_EQ(figures_of(session.findings().map_values(*session.view.colouring).all()).highest, 0);
  EXPECT_EQ(figures_of(session.compared()->findings().map_values(*session.view.colouring).all()).highest, 0);
  session.run("compare off");
  EXPECT_FALSE(session.view.colouring);
}

TEST(comparing, points_at_either_mesh_and_works_on_the_open_one_alone) {
  Session session(opened("cube.obj"));
  session.place_view({800, 600}, {100, 20});
  ASSERT_TRUE(session.run("compare " + test::asset("torus.off")).done());
  session.run("mode face");
  const auto middle = [](const ViewState& view) {
    return view.origin + 0.5 * glm::dvec2(view.size.width, view.size.height);
  };
  session.framing.frame_all();
  // The torus has a hole in the middle; beside it there is a face.
  glm::dvec2 over_other = middle(session.compared()->state());
  while (!session.pointing.pick_drawn(over_other, PickMode::face) && over_other.x < 890) over_other.x += 5;
  ASSERT_LT(over_other.x, 890);
  session.pointing.point_at(over_other);
  EXPECT_FALSE(session.selecting.hover());
  const Pointed* const pointed = session.pointing.pointed();
  ASSERT_TRUE(pointed);
  EXPECT_EQ(pointed->document, &session.compared()->document());
  EXPECT_EQ(pointed->view, &session.compared()->view());
  EXPECT_EQ(pointed->picked.element.kind, Element::Kind::face) << "in the mode of the open mesh";
  EXPECT_FALSE(session.pointing.pick(over_other, PickMode::face)) << "it is not of the open mesh";
  const Outcome clicked = session.pointing.click(over_other, session.selecting.tool);
  EXPECT_EQ(clicked.exit_code, ExitCode::refused);
  EXPECT_NE(clicked.sentence.en.find("torus.off"), std::string::npos);
  EXPECT_TRUE(session.selecting.selection.empty());
  session.run("tool collapse");
  session.pointing.point_at(over_other);
  EXPECT_FALSE(session.selecting.hover()) << "nothing of it is edited";
  session.run("tool none");
  session.pointing.point_at(middle(session.view));
  ASSERT_TRUE(session.selecting.hover());
  EXPECT_EQ(session.pointing.pointed(), &*session.selecting.hover()) << "the pointer has left the other";
  EXPECT_EQ(session.pointing.pointed()->document, &session.document());
  session.pointing.point_at(over_other);
  session.run("compare off");
  EXPECT_EQ(session.pointing.pointed(), nullptr) << "what it was of has gone";
}

TEST(comparing, the_wheel_goes_to_what_is_under_the_pointer_in_either_half) {
  Session session(opened("cube.obj"));
  session.place_view({800, 600}, {0, 0});
  ASSERT_TRUE(session.run("compare " + test::asset("cube.obj")).done());
  const glm::dvec2 other = session.compared()->state().origin;
  session.run("view top");  // and nothing is drawn between that and the wheel
  const Camera before = session.view.camera;
  const glm::dvec2 here = 0.5 * glm::dvec2(session.view.size.width, session.view.size.height) + glm::dvec2(20, 30);
  Navigation navigation;
  navigation.wheel(session, here, 2);
  const Camera left = session.view.camera;
  session.view.camera = before;
  navigation.wheel(session, here + other, 2);
  EXPECT_NE(session.view.camera, before);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(session.view.camera.eye[k], left.eye[k], 1e-9) << "the same mesh, the same camera";
}

TEST(comparing, points_with_the_camera_as_it_is) {
  Session session(opened("cube.obj"));
  session.place_view({800, 600}, {0, 0});
  ASSERT_TRUE(session.run("compare " + test::asset("cube.obj")).done());
  const glm::dvec2 other = session.compared()->state().origin;
  session.run("mode face");
  for (const char* const line : {"view top", "view left", "view front"}) {
    session.run(line);
    const glm::dvec2 here = 0.5 * glm::dvec2(session.view.size.width, session.view.size.height) + glm::dvec2(5, 9);
    session.pointing.point_at(here);
    ASSERT_TRUE(session.pointing.pointed());
    const Element in_open = session.pointing.pointed()->picked.element;
    session.pointing.point_at(here + other);
    ASSERT_TRUE(session.pointing.pointed());
    EXPECT_EQ(session.pointing.pointed()->picked.element, in_open) << line;
    EXPECT_EQ(session.pointing.pointed()->document, &session.compared()->document());
  }
}

TEST(comparing, labels_of_the_other_are_in_the_language_and_of_its_own_elements) {
  Session session(opened("cube.obj"));
  session.place_view({800, 600}, {0, 0});
  ASSERT_TRUE(session.run("compare " + test::asset("tetrahedron.off")).done());
  const auto size_of = [](const std::string& text) { return Size{static_cast<int>(7 * text.size()), 12}; };
  const auto texts = [&] {
    std::set<std::string> found;
    for (const PlacedLabel& label : placed_labels(session.compared()->seen(), size_of, 1)) found.insert(label.text);
    return found;
  };
  EXPECT_FALSE(has_labels(session.compared()->seen()));
  session.run("numbers vertices");
  EXPECT_TRUE(has_labels(session.compared()->seen()));
  EXPECT_TRUE(texts().contains("v3"));
  EXPECT_FALSE(texts().contains("v7")) << "which the open one has";
  session.run("numbers off");
  session.run("colours area");
  const std::set<std::string> english = texts();
  EXPECT_FALSE(english.empty());
  session.run("language ja");
  EXPECT_NE(texts(), english);
}

}  // namespace
}  // namespace ryosen
