// Mouse and keyboard in scripts: on the view alone, and through panels as in a window.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/editor/camera/camera_text.h"
#include "app/editor/session/session.h"
#include "app/ui/headless.h"
#include "tests/support/app/laid.h"
#include "tests/support/app/program.h"
#include "tests/support/app/window_size.h"

namespace ryosen {
namespace {

std::unique_ptr<Session> torus() {
  auto document = Document::open(test::asset("torus.off"));
  EXPECT_TRUE(document);
  return std::make_unique<Session>(std::move(document).value());
}

Outcome run(Session& session, std::initializer_list<std::string> lines) {
  Outcome outcome;
  for (const std::string& line : lines) {
    outcome = session.run(line);
    EXPECT_TRUE(outcome.done()) << line << ": " << outcome.sentence.en;
  }
  return outcome;
}

constexpr const char* on_torus = "640,560";

TEST(script_events, on_the_view_are_drags_clicks_and_the_wheel) {
  const auto session = torus(), other = torus();
  session->framing.frame_all();
  other->framing.frame_all();
  run(*session, {"press left 640,560", "move 700,580", "release left 700,580"});
  run(*other, {"drag 640,560 700,580"});
  EXPECT_EQ(session->view.camera.eye, other->view.camera.eye);
  EXPECT_TRUE(session->selecting.selection.empty());

  const Camera turned = session->view.camera;
  run(*session, {"press left 640,560 Shift", "move left 660,560 Shift", "release left 660,560"});
  const glm::dvec3 turning = session->view.camera.eye - session->view.camera.target - (turned.eye - turned.target);
  EXPECT_LT(glm::length(turning), 1e-12) << "panned";
  EXPECT_NE(session->view.camera.eye, turned.eye);

  run(*session, {"frame all", "mode face", "press left 640,560", "release left 641,560"});
  EXPECT_EQ(session->selecting.selection.size(), 1u);
  EXPECT_EQ(session->log().size(), 0u) << "looking and selecting are no edits";
  const Camera before = session->view.camera;
  run(*session, {"press left 640,560", "release left 640,560"});
  EXPECT_NE(session->view.camera.target, before.target) << "time stands still: that was a double click";
  run(*session, {"frame all", "wheel 2 640,560"});
  EXPECT_EQ(session->view.camera.fov_y_deg, before.fov_y_deg);
  EXPECT_NE(session->view.camera.eye, before.eye);
  run(*session, {"frame all", std::string("move ") + on_torus});
  ASSERT_TRUE(session->selecting.hover());
}

TEST(script_events, a_click_with_a_tool_edits_and_a_refused_one_says_so) {
  const auto session = torus();
  session->framing.frame_all();
  run(*session, {"tool poke", "press left 640,560", "release left 640,560"});
  ASSERT_EQ(session->log().size(), 1u);
  EXPECT_EQ(session->log()[0].substr(0, 5), "poke ");
  run(*session, {"press left 3,3"});
  const Outcome told = session->run("release left 3,3");
  EXPECT_TRUE(told.done()) << "the script goes on, as a hand does";
  EXPECT_NE(told.sentence.en.find("nothing under the pointer"), std::string::npos) << told.sentence.en;
}

TEST(script_events, a_click_selects_with_shift_adds_with_ctrl_toggles) {
  const auto session = torus();
  session->framing.frame_all();
  const auto click = [&](const std::string& at, const std::string& with) {
    run(*session, {"press left " + at + with, "release left " + at + with});
  };
  run(*session, {"mode face"});
  click("640,560", "");
  click("500,480", " Shift");
  ASSERT_EQ(session->selecting.selection.size(), 2u);
  const Element second = session->selecting.selection[1];
  click("500,480", " Shift");
  EXPECT_EQ(session->selecting.selection.size(), 2u) << "once";
  click("640,560", " Ctrl");
  EXPECT_EQ(session->selecting.selection, std::vector<Element>{second});
  click("3,3", " Shift");
  EXPECT_EQ(session->selecting.selection, std::vector<Element>{second}) << "beside the mesh nothing is lost";
  click("3,3", "");
  EXPECT_TRUE(session->selecting.selection.empty());
  for (const char* line : {"select add", "select toggle", "select add none", "select duplicate_face none"})
    EXPECT_EQ(session->run(line).exit_code, ExitCode::usage) << line;
}

TEST(script_events, say_what_is_wrong_with_them) {
  const auto session = torus();
  for (const char* line :
       {"press", "press left", "press up 3,4", "press left 3", "press left 3,4 shift", "release 3,4", "move",
        "move 3,4 5", "move left", "wheel 3", "wheel a 3,4", "wheel 6000 3,4", "key Clrt+A", "type", "key Q"})
    EXPECT_EQ(session->run(line).exit_code, ExitCode::usage) << line;
  EXPECT_EQ(session->run("type abc").exit_code, ExitCode::refused);
  EXPECT_EQ(session->run("key Enter").exit_code, ExitCode::refused);
}

TEST(script_events, move_with_a_vertex_is_the_operator) {
  const auto session = torus();
  run(*session, {"move 3 9,8,7"});
  EXPECT_EQ(session->mesh().position(Vertex(3)), glm::dvec3(9, 8, 7));
  ASSERT_EQ(session->log().size(), 1u);
  EXPECT_EQ(session->log()[0].substr(0, 11), "move_vertex");
}

class PanelEvents : public testing::Test {
 protected:
  void SetUp() override {
    auto made = Headless::make({.backend = Backend::osmesa, .size = test::window, .panels = true});
    ASSERT_TRUE(made);
    headless_ = std::move(made).value();
    headless_->place_view(*session_);
  }
  std::unique_ptr<Session> session_ = torus();
  std::unique_ptr<Headless> headless_;
};

TEST_F(PanelEvents, reach_the_rows_of_panels_and_the_view_between_them) {
  const glm::dvec2 row = test::Laid("torus.off").place_of("Collapse edge");
  const std::string at = format_pixel(row), beside = format_pixel(row + glm::dvec2(20, 0));
  run(*session_, {"press left " + at, "release left " + at});
  EXPECT_EQ(session_->selecting.tool, "collapse");
  const Camera before = session_->view.camera;
  run(*session_, {"press left " + at, "move " + beside, "release left " + beside, "wheel 1 " + at});
  EXPECT_EQ(session_->view.camera.eye, before.eye) << "over a panel nothing navigates";
  run(*session_, {"press left 640,560", "move 700,580", "release left 700,580"});
  EXPECT_NE(session_->view.camera.eye, before.eye);
}

TEST_F(PanelEvents, a_refused_line_keeps_its_text_and_the_keyboard) {
  run(*session_, {"key F3", "type pokee f0", "key Enter"});
  EXPECT_EQ(session_->layout.open_panel, "command");
  for (int i = 0; i < 8; ++i) run(*session_, {"key Backspace"});
  run(*session_, {"type poke f0", "key Enter"});
  ASSERT_EQ(session_->log().size(), 1u);
  EXPECT_EQ(session_->log()[0].substr(0, 7), "poke f0");
}

// Also those that do nothing else.
TEST_F(PanelEvents, any_key_goes_to_a_gesture) {
  run(*session_, {"mode face", "select f0", "key G", "key N", "key 5", "key 0", "key Enter"});
  ASSERT_EQ(session_->log().size(), 1u);
  EXPECT_EQ(session_->log()[0].substr(0, 13), "translate by=") << session_->log()[0];
  EXPECT_EQ(session_->run("key N").exit_code, ExitCode::usage) << "without one it is no key";
}

TEST_F(PanelEvents, keys_and_text_go_to_a_field_that_is_open) {
  run(*session_, {"key F3", "type poke f0", "key Enter"});
  ASSERT_EQ(session_->log().size(), 1u);
  EXPECT_EQ(session_->log()[0].substr(0, 7), "poke f0");
  run(*session_, {"key F3", "type poke f1", "key Backspace", "type 2", "key Enter"});
  EXPECT_EQ(session_->log().back().substr(0, 7), "poke f2");
  run(*session_, {"key F3", "type C", "key C"});
  EXPECT_TRUE(session_->selecting.tool.empty()) << "the field has the keyboard";
  run(*session_, {"key Escape", "key C"});
  EXPECT_EQ(session_->selecting.tool, "collapse");
  EXPECT_EQ(session_->run("type abc").exit_code, ExitCode::refused);
}

}  // namespace
}  // namespace ryosen
