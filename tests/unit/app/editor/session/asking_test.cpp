#include "app/editor/session/asking.h"

#include <gtest/gtest.h>

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "ryosen/scene/view/camera.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class AskingTest : public testing::Test {
 protected:
  void SetUp() override {
    auto document = Document::open(test::asset("cube.obj"));
    ASSERT_TRUE(document);
    session_ = std::make_unique<Session>(std::move(document).value());
  }
  Outcome click_on(std::uint32_t vertex) {
    const auto at = project(session_->view.camera, session_->view.size, session_->mesh().position(Vertex(vertex)));
    return session_->pointing.click(session_->view.origin + at->pixel, "");
  }
  // A vertex of a face that is seen, and the one across.
  std::pair<std::uint32_t, std::uint32_t> corners_across() {
    const auto picked = session_->pointing.pick({640, 360}, PickMode::face);
    EXPECT_TRUE(picked);
    std::vector<std::uint32_t> corners;
    Halfedge h = session_->mesh().halfedge(picked->element.face());
    for (int i = 0; i < 4; ++i, h = session_->mesh().next(h)) corners.push_back(session_->mesh().from(h).index);
    return {corners[0], corners[2]};
  }

  std::unique_ptr<Session> session_;
};

TEST(asking, goes_by_the_syntax_of_the_operator) {
  EXPECT_EQ(asked_for("make_edge"), PickMode::vertex);
  EXPECT_EQ(asked_for("make_edge v3"), PickMode::vertex);
  EXPECT_EQ(asked_for("make_edge v3 v4"), std::nullopt);
  EXPECT_TRUE(is_answered("make_edge v3 v4"));
  EXPECT_EQ(asked_for("poke"), PickMode::face);
  EXPECT_EQ(asked_for("split"), PickMode::edge);
  EXPECT_EQ(asked_for("make_vertex"), std::nullopt) << "a place is no element";
  EXPECT_EQ(asked_for("make_face v0 v1 v2"), PickMode::vertex) << "there may be more";
  EXPECT_FALSE(is_answered("make_face v0 v1 v2"));
  EXPECT_EQ(asked_for("undo"), std::nullopt);
  EXPECT_EQ(asked_for(""), std::nullopt);
}

TEST_F(AskingTest, each_click_adds_an_element_and_the_last_one_carries_it_out) {
  const auto [a, b] = corners_across();
  ASSERT_TRUE(session_->run("ask separate_loop").done());
  EXPECT_EQ(session_->selecting.pointed_sort(), PickMode::vertex) << "whatever the mode";
  ASSERT_TRUE(click_on(a).done());
  EXPECT_EQ(session_->selecting.asked_line, "separate_loop v" + std::to_string(a));
  EXPECT_TRUE(session_->selecting.selection.empty());
  const Outcome outcome = click_on(b);
  ASSERT_TRUE(outcome.done()) << outcome.sentence.en;
  EXPECT_TRUE(session_->selecting.asked_line.empty());
  EXPECT_EQ(session_->mesh().live().faces, 7u);
  ASSERT_EQ(session_->log().size(), 1u);
  EXPECT_TRUE(session_->log()[0].starts_with("separate_loop ")) << session_->log()[0];
}

TEST_F(AskingTest, a_command_about_elements_takes_some_of_any_kind) {
  const auto [a, b] = corners_across();
  EXPECT_TRUE(can_be_asked("measure v0 v1"));
  EXPECT_FALSE(can_be_asked("measure v0 v1 v2")) << "there are three at most";
  EXPECT_EQ(asked_text("measure").en, "measure: Point at an element.");
  ASSERT_TRUE(session_->run("mode vertex").done());
  ASSERT_TRUE(session_->run("ask measure").done());
  EXPECT_FALSE(session_->run("ask").done()) << "nothing yet";
  ASSERT_TRUE(click_on(a).done());
  ASSERT_TRUE(click_on(b).done());
  EXPECT_TRUE(session_->selecting.measures.empty());
  ASSERT_TRUE(session_->run("ask").done()) << "as Enter says";
  ASSERT_EQ(session_->selecting.measures.size(), 1u);
  EXPECT_EQ(session_->selecting.measures[0].size(), 2u);
}

TEST_F(AskingTest, begins_anew_after_a_refusal_and_ends_by_escape_or_a_tool) {
  const auto [a, b] = corners_across();
  session_->run("ask separate_loop");
  click_on(a);
  EXPECT_FALSE(click_on(a).done()) << "no face is divided at one corner";
  EXPECT_EQ(session_->selecting.asked_line, "separate_loop");
  session_->run("cancel");
  EXPECT_TRUE(session_->selecting.asked_line.empty());
  session_->run("ask separate_loop");
  session_->run("tool poke");
  EXPECT_TRUE(session_->selecting.asked_line.empty());
  EXPECT_EQ(session_->run("ask undo").exit_code, ExitCode::usage);
  EXPECT_EQ(session_->run("ask").exit_code, ExitCode::refused) << "nothing asks";
}

TEST_F(AskingTest, a_list_of_any_length_waits_for_enter) {
  session_->run("ask make_face v0 v1");
  EXPECT_EQ(session_->run("key Enter").exit_code, ExitCode::refused) << "two are too few";
  session_->run("ask reverse f0");
  ASSERT_TRUE(session_->run("key Enter").done());
  EXPECT_EQ(session_->document().history().size(), 1u);
  EXPECT_TRUE(session_->selecting.asked_line.empty());
}

}  // namespace
}  // namespace ryosen
