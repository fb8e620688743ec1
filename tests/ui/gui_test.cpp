// The panels, laid out and clicked without a window.
#include "app/ui/gui.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>  // the border of a window

#include "app/editor/commands/text/words.h"
#include "app/editor/preferences/keys.h"
#include "app/editor/session/session.h"
#include "ryosen/base/enum_table.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

using test::Laid;
using test::window;

// Save of the panel that writes files, which its Cancel follows: the word alone is drawn elsewhere too.
constexpr const char *save_in_dialog = "Save Cancel", *save_in_dialog_ja = "保存取り消し";

TEST(texts, are_there_in_both_languages) {
  for (std::size_t i = 0; i < enum_count<UiText>; ++i) {
    const auto id = static_cast<UiText>(i);
    EXPECT_STRNE(text(id, Language::english), "");
    EXPECT_STRNE(text(id, Language::japanese), "");
    EXPECT_STRNE(text(id, Language::english), text(id, Language::japanese)) << text(id, Language::english);
  }
  for (const KeyRow& key : key_table()) {
    EXPECT_FALSE(key.help_en.empty()) << key.chord;
    EXPECT_FALSE(key.help_ja.empty()) << key.chord;
  }
}

TEST(gui, lays_out_something_in_every_language_and_theme) {
  Laid laid("fin.obj");
  for (const char* line : {"language ja", "theme light", "language en", "theme dark"}) {
    ASSERT_TRUE(laid.session.run(line).done());
    laid.frames(2);
    EXPECT_GT(laid.gui.draw_data().TotalVtxCount, 2000) << line;
  }
}

TEST(gui, a_picture_shows_the_window_without_what_asked_for_it) {
  Laid laid("cube.obj");
  // As in the window: a frame is drawn when all of it has been laid out and what it sent has been carried out.
  int drawn = laid.gui.draw_data().TotalVtxCount;
  const auto frames = [&](int n) {
    for (int i = 0; i < n || laid.gui.wants_frames(); ++i) {
      laid.frames(1);
      drawn = laid.gui.draw_data().TotalVtxCount;
    }
  };
  std::vector<int> pictured;
  laid.session.frontend.take_picture = [&](const std::filesystem::path&) {
    EXPECT_FALSE(laid.gui.is_laying_out());
    pictured.push_back(drawn);
    return success();
  };
  const int bare = drawn;
  for (const std::string line : {"shot a.png", "key F12"}) {
    ASSERT_TRUE(laid.gui.run(laid.session, "panel command").done());
    frames(3);
    ASSERT_GT(drawn, bare);
    for (const char c : line) laid.gui.character(static_cast<unsigned>(c));
    laid.gui.key(ImGuiKey_Enter, true);
    laid.gui.key(ImGuiKey_Enter, false);
    frames(2);
    EXPECT_TRUE(laid.session.layout.open_panel.empty()) << line;
    EXPECT_FALSE(laid.gui.wants_frames());
  }
  EXPECT_EQ(pictured, (std::vector<int>{bare, bare}));
}

// A panel below the end of its column is not laid out, and must not ask for frames until it is.
TEST(gui, whatever_is_open_no_panel_asks_for_frames_for_ever) {
  constexpr int most = 100;
  for (const Size size : {Size{640, 480}, Size{1280, 560}, Size{1280, 800}}) {
    Laid laid("fin.obj", size);
    const auto settles = [&] {
      int frames = 0;
      for (; laid.gui.wants_frames() && frames < most; ++frames) laid.frames(1);
      return frames < most;
    };
    EXPECT_TRUE(settles());
    for (const PanelRow& row : panel_list()) {
      ASSERT_TRUE(laid.gui.run(laid.session, "panel " + std::string(row.id) + " on").done());
      EXPECT_TRUE(settles()) << row.id << " at " << size.width;
      laid.gui.pointer({size.width - 20, 200});
      for (const double notches : {-3, -30, 5, 30}) {
        laid.gui.wheel(notches);
        laid.frames(1);
        EXPECT_TRUE(settles()) << row.id << " at " << size.width << " after " << notches;
      }
    }
  }
}

TEST(gui, frames_are_wanted_until_a_closed_panel_has_gone) {
  Laid laid("torus.off");
  // As in the window: frames are laid out after input until no more are wanted, and then no further ones.
  const auto wait = [&] {
    for (int i = 0; i < 3 || laid.gui.wants_frames(); ++i) laid.frames(1);
  };
  const auto closes = [&](const char* button) {
    wait();
    laid.gui.pointer(laid.place_of(button));
    wait();
    laid.gui.button(0, true);
    laid.gui.button(0, false);  // before there was a frame
    wait();
    EXPECT_EQ(laid.session.layout.open_panel, "");
    const int drawn = laid.gui.draw_data().TotalVtxCount;
    laid.frames(5);
    EXPECT_EQ(laid.gui.draw_data().TotalVtxCount, drawn);
  };
  ASSERT_TRUE(laid.gui.run(laid.session, "panel recover").done());
  closes("Later");
  ASSERT_TRUE(laid.gui.run(laid.session, "split 0-1").done());
  laid.gui.leave(laid.session, {false, test::asset("cube.obj")});
  closes("Discard");
  EXPECT_EQ(laid.session.mesh().live().vertices, 8u);
}

TEST(gui, the_view_lies_between_the_columns) {
  const Laid laid("cube.obj");
  const PixelRect area = laid.gui.view_area(window, laid.session.layout);
  EXPECT_EQ(laid.session.view.size, (Size{area.width(), area.height()}));
  EXPECT_EQ(laid.session.view.origin, glm::dvec2(area.x0, area.y0));
  const double y = (area.y0 + area.y1) / 2.0, x = (area.x0 + area.x1) / 2.0;
  EXPECT_FALSE(laid.gui.owns_pointer(laid.session.layout, window, {x, y}));
  EXPECT_TRUE(laid.gui.owns_pointer(laid.session.layout, window, {area.x0 / 2.0, y}));
  EXPECT_TRUE(laid.gui.owns_pointer(laid.session.layout, window, {(area.x1 + window.width) / 2.0, y}));
  EXPECT_TRUE(laid.gui.owns_pointer(laid.session.layout, window, {x, area.y0 / 2.0}));
}

TEST(gui, a_click_on_a_tool_takes_it_and_another_puts_it_away) {
  Laid laid("torus.off");
  const glm::dvec2 row = test::DrawnText(laid.gui).place("Collapse edge");
  laid.click(row);
  EXPECT_EQ(laid.session.selecting.tool, "collapse");
  laid.click(row);
  EXPECT_EQ(laid.session.selecting.tool, "");
}

TEST(gui, a_highlight_is_switched_in_its_panel) {
  Laid laid("fin.obj");
  ASSERT_TRUE(laid.session.view.highlights.contains("boundary"));
  laid.click({16, test::DrawnText(laid.gui).place("Boundary").y});
  EXPECT_FALSE(laid.session.view.highlights.contains("boundary"));
  EXPECT_TRUE(laid.session.view.highlights.contains("nonmanifold"));
}

TEST(gui, an_open_panel_takes_the_pointer_and_escape_gives_it_back) {
  Laid laid("cube.obj");
  for (const char* panel : {"keys", "open", "save", "command"}) {
    ASSERT_TRUE(laid.gui.run(laid.session, std::string("panel ") + panel).done());
    laid.frames(2);
    EXPECT_TRUE(laid.gui.owns_pointer(laid.session.layout, window, {640, 360})) << panel;
    ASSERT_TRUE(laid.gui.run(laid.session, "cancel").done());
    laid.frames(3);
    EXPECT_FALSE(laid.gui.owns_pointer(laid.session.layout, window, {640, 360})) << panel;
  }
}

TEST(gui, a_key_that_is_up_again_before_a_frame_is_seen) {
  Laid laid("torus.off");
  ASSERT_TRUE(laid.gui.run(laid.session, "panel command").done());
  laid.frames(3);
  for (const char c : std::string_view("split 0-1")) laid.gui.character(static_cast<unsigned>(c));
  laid.frames(1);
  laid.gui.key(ImGuiKey_Enter, true);
  laid.gui.key(ImGuiKey_Enter, false);
  laid.frames(1);
  EXPECT_EQ(laid.session.document().position(), 1u);
  laid.frames(3);
  EXPECT_FALSE(ImGui::GetIO().KeysDown[ImGuiKey_Enter]);
}

// All of Ctrl+A may come in while a frame is drawn.
TEST(gui, a_key_keeps_the_modifiers_that_it_was_pressed_with_until_it_is_seen) {
  Laid laid("torus.off");
  ASSERT_TRUE(laid.session.run("panel command").done());
  laid.frames(4);
  laid.gui.text("split 0-1");
  laid.frames(2);
  ASSERT_EQ(test::DrawnText(laid.gui).count("split0-1"), 1u);
  laid.gui.modifiers(false, true);
  laid.gui.key(ImGuiKey_A, true);
  laid.gui.key(ImGuiKey_A, false);
  laid.gui.modifiers(false, false);
  laid.frames(2);
  EXPECT_FALSE(ImGui::GetIO().KeyCtrl);
  laid.gui.text("u");
  laid.frames(2);
  EXPECT_EQ(test::DrawnText(laid.gui).count("split0-1"), 0u) << "nothing was selected in the field";
}

TEST(gui, asks_before_changes_are_lost) {
  Laid laid("torus.off");
  laid.gui.leave(laid.session, {true, {}});
  EXPECT_TRUE(laid.gui.wants_quit()) << "nothing to lose";

  Laid changed("torus.off");
  ASSERT_TRUE(changed.session.run("split 0-1").done());
  changed.gui.leave(changed.session, {true, {}});
  EXPECT_FALSE(changed.gui.wants_quit());
  EXPECT_EQ(changed.session.layout.open_panel, "unsaved");
  changed.frames(2);
  changed.click_on("Discard");
  EXPECT_TRUE(changed.gui.wants_quit());
}

TEST(gui, the_question_before_a_loss_is_not_asked_where_nothing_would_be_lost) {
  Laid laid("torus.off");
  ASSERT_TRUE(laid.gui.run(laid.session, "split 0-1").done());
  laid.gui.run(laid.session, "panel unsaved");
  laid.frames(3);
  EXPECT_EQ(laid.session.layout.open_panel, "");
  EXPECT_EQ(laid.session.document().history().size(), 1u) << "the mesh is still there";
}

TEST(gui, what_a_crash_left_is_recovered_discarded_or_left_for_later) {
  const test::TemporaryFolder state;
  const test::ScopedVariable home("XDG_STATE_HOME", state.path().string());
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx",
                static_cast<unsigned long long>(Document::open(test::asset("cube.obj")).value()->mesh().hash()));
  const test::TemporaryFolder folder;
  const std::string file = folder.copy(test::asset("cube.obj"), "cube.obj");
  for (const char* n : {"1", "2"})
    state.write("ryosen/recovery/session-" + std::string(n) + ".ryosen",
                "# ryosen session 1\n# mesh " + std::string(hash) + "\nopen " + file_argument(file) + "\nsplit 0-1\n");

  Laid laid("torus.off");
  ASSERT_TRUE(laid.gui.run(laid.session, "panel recover").done());
  laid.frames(3);
  laid.click_on("Later");
  EXPECT_EQ(laid.session.layout.open_panel, "");
  EXPECT_EQ(state.names().size(), 2u);

  ASSERT_TRUE(laid.gui.run(laid.session, "panel recover").done());
  laid.frames(3);
  ASSERT_EQ(test::DrawnText(laid.gui).count("Discard"), 2u);
  laid.click_on("Discard");  // of the second
  EXPECT_EQ(laid.session.layout.open_panel, "recover");
  EXPECT_EQ(state.names(), std::vector<std::string>{"ryosen/recovery/session-1.ryosen"});

  // Changes of this document are asked about first.
  ASSERT_TRUE(laid.session.run("split 0-1").done());
  laid.click_on("Recover Discard");  // Recover, which Discard follows: the title has the word too
  EXPECT_EQ(laid.session.layout.open_panel, "unsaved");
  laid.frames(3);
  laid.click_on("Discard");
  EXPECT_EQ(laid.session.document().path(), file);
  EXPECT_EQ(laid.session.mesh().live().vertices, 9u);
  EXPECT_NE(laid.gui.said().en.find("1 edit is recovered"), std::string::npos) << laid.gui.said().en;
}

TEST(gui, an_existing_file_is_replaced_only_on_the_second_press) {
  const test::TemporaryFolder folder;
  Laid laid("torus.off");
  const std::string path = folder.copy(test::asset("cube.obj"), "other.obj"), before = test::read_file(path);
  ASSERT_TRUE(laid.session.run("open " + path).done());
  ASSERT_TRUE(laid.session.run("split 0-1").done());
  ASSERT_TRUE(laid.gui.run(laid.session, "panel save").done());
  laid.frames(3);
  laid.click_on(save_in_dialog);
  EXPECT_EQ(test::read_file(path), before);
  EXPECT_EQ(laid.session.layout.open_panel, "save");
  laid.click_on(save_in_dialog);
  EXPECT_NE(test::read_file(path), before);
  EXPECT_EQ(laid.session.layout.open_panel, "");
}

TEST(gui, what_a_format_cannot_hold_is_listed_before_it_is_written) {
  const test::TemporaryFolder folder;
  Laid laid("torus.off");
  auto cube = read_mesh_file(test::asset("cube.obj"));
  ASSERT_TRUE(cube);
  laid.session.set_document(std::make_unique<Document>(std::move(cube).value(), folder.at("cube.stl")));
  const std::vector<Message> losses = laid.session.document().losses(folder.at("cube.stl"));
  ASSERT_FALSE(losses.empty()) << "STL knows no quads";
  for (const char* language : {"language en", "language ja"}) {
    ASSERT_TRUE(laid.session.run(language).done());
    ASSERT_TRUE(laid.gui.run(laid.session, "panel save").done());
    laid.frames(3);
    const int before = laid.gui.draw_data().TotalVtxCount;
    laid.click_on(language == std::string_view("language en") ? save_in_dialog : save_in_dialog_ja);
    EXPECT_FALSE(folder.has("cube.stl")) << "it only told what would be lost";
    EXPECT_EQ(laid.session.layout.open_panel, "save");
    EXPECT_GT(laid.gui.draw_data().TotalVtxCount, before + 100) << "a sentence per loss and what to do";
    if (language == std::string_view("language ja")) break;
    ASSERT_TRUE(laid.gui.run(laid.session, "cancel").done());
    laid.frames(3);
  }
  laid.click_on(save_in_dialog_ja);  // which the list has moved up
  EXPECT_TRUE(folder.has("cube.stl"));
  EXPECT_EQ(laid.session.layout.open_panel, "");
  EXPECT_FALSE(laid.session.document().is_modified());
}

TEST(gui, scales_with_the_display) {
  const PixelRect once = Gui(1).view_area({1280, 720}, {}), twice = Gui(2).view_area({2560, 1440}, {});
  EXPECT_EQ(twice, (PixelRect{2 * once.x0, 2 * once.y0, 2 * once.x1, 2 * once.y1}));
  EXPECT_FALSE(Gui(1).view_area({100, 20}, {}).empty());
}

TEST(gui, nothing_is_said_to_be_done_that_was_not) {
  Laid laid("tetrahedron.off");
  const std::uint64_t before = laid.session.mesh().hash();
  const Outcome outcome = laid.gui.run(laid.session, "collapse 0-1");
  EXPECT_EQ(outcome.kind, Outcome::Kind::refused);
  EXPECT_EQ(laid.session.mesh().hash(), before);
  EXPECT_NE(laid.gui.said().en.find("refused"), std::string::npos);
  EXPECT_EQ(laid.gui.said().en.find("done"), std::string::npos);
}

TEST(gui, done_is_said_of_what_was_done_and_of_nothing_else) {
  Laid laid("torus.off");
  const auto said = [&](const char* line) {
    laid.gui.run(laid.session, line);
    return laid.gui.said().en;
  };
  laid.session.frontend.quit = [&] { laid.gui.leave(laid.session, {true, {}}); };
  EXPECT_EQ(said("split 0-1"), "split 0-1: done");
  EXPECT_EQ(said("panel keys"), "");
  EXPECT_EQ(said("panel none"), "");
  EXPECT_EQ(said("frame selected"), "nothing is selected; the whole mesh is shown");
  EXPECT_EQ(said("view top"), "");
  EXPECT_EQ(said("undo"), "undo: done");
  EXPECT_EQ(said("redo"), "redo: done");
  EXPECT_EQ(said("quit"), "") << "it only asks";
  EXPECT_EQ(laid.session.layout.open_panel, "unsaved");
  EXPECT_FALSE(laid.gui.wants_quit());
  EXPECT_EQ(said("cancel"), "");
  laid.gui.run(laid.session, "split 0-2");
  laid.gui.leave(laid.session, {false, "another.obj"});
  EXPECT_EQ(laid.gui.said().en, "");
}

TEST(gui, a_command_is_shown_with_short_numbers_and_kept_with_all_digits) {
  Laid laid("cube.obj", {1600, 900});
  const std::string line = "extrude f1 -0,-0.0,-0.16395576831283612";
  ASSERT_TRUE(laid.gui.run(laid.session, line).done());
  laid.frames(3);
  EXPECT_EQ(test::DrawnText(laid.gui).count("extrude f1 0,0,-0.163956"), 2u) << "in the history and in the last line";
  EXPECT_EQ(test::DrawnText(laid.gui).count("0.16395576"), 0u);
  EXPECT_EQ(laid.session.log(), std::vector<std::string>{"extrude f1 -0,-0,-0.16395576831283612"});
}

TEST(gui, a_dropped_file_is_opened_whatever_its_name) {
  const test::TemporaryFolder folder;
  Laid laid("torus.off");
  const std::string path = folder.copy(test::asset("cube.obj"), "a \"b\"; c #1.obj");
  laid.gui.leave(laid.session, {false, path});
  EXPECT_EQ(laid.session.document().path(), path);
  EXPECT_EQ(laid.session.mesh().live().vertices, 8u);
}

TEST(progress_window, is_cancelled_by_its_button_alone) {
  Session session(std::make_unique<Document>());
  Gui gui(1);
  const auto step = [&] {
    gui.prepare(session);
    return gui.progress_frame(Language::english, test::window, 0.05, {0.4});
  };
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(step());
  EXPECT_GT(ImGui::FindWindowByName("###progress")->WindowBorderSize, 0) << "it ends somewhere, whatever lies behind";
  const auto click = [&](glm::dvec2 pixel) {
    gui.pointer(pixel);
    bool asked = step();
    gui.button(0, true);
    asked = step() || asked;
    gui.button(0, false);
    return step() || asked;
  };
  const ImRect bar = ImGui::FindWindowByName("###progress")->Rect();
  const glm::dvec2 button = test::DrawnText(gui).last_place("Cancel (Esc)");
  EXPECT_FALSE(click({bar.GetCenter().x, button.y - 1.5 * ImGui::GetFrameHeightWithSpacing()})) << "on the bar";
  EXPECT_TRUE(click(button));
}

}  // namespace
}  // namespace ryosen
