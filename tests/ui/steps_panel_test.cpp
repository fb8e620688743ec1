// What is played step by step in the window: by commands, by keys and by the panel; the document stays as it is.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>

#include "app/editor/camera/framing.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/labels/labels.h"
#include "app/editor/session/session.h"
#include "app/editor/textbook/playing.h"
#include "app/ui/overlays.h"
#include "app/ui/window_input.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

class StepsPanelTest : public testing::Test, protected test::Laid {
 protected:
  StepsPanelTest() : Laid("fan.obj", test::tall_window) {
    input_.resize(size_);
    for (const PanelRow& row : panel_list())
      if (row.place == PanelPlace::right) session.run("panel " + std::string(row.id) + " off");
  }
  Outcome say(const std::string& line) {
    Outcome outcome = gui.run(session, line);
    frames(3);
    return outcome;
  }
  bool has(std::string_view text) const { return test::DrawnText(gui).count(text) > 0; }
  void take(std::string_view text) {
    click(test::DrawnText(gui).place(text));
    frames(3);
  }
  static std::vector<std::string> split(const std::string& call) {
    const std::vector<std::string_view> words = split_words(call);
    return {words.begin(), words.end()};
  }
  std::set<std::string> labels() {
    const auto size_of = [](const std::string& text) { return Size{static_cast<int>(8 * text.size()), 14}; };
    std::set<std::string> all;
    for (const PlacedLabel& label : placed_labels(session, size_of, 1)) all.insert(label.text);
    return all;
  }

  WindowInput input_{gui, session, [this] { frames(1); }};
};

TEST_F(StepsPanelTest, no_gap_stands_where_no_cell_changes) {
  ASSERT_TRUE(say("panel steps").done());
  ASSERT_TRUE(say("steps collapse 0-1").done());
  int without = 0;
  for (std::size_t i = 1; i <= session.shown.player()->size() && without < 3; ++i) {
    ASSERT_TRUE(say("steps at " + std::to_string(i)).done());
    const steps::Step& step = *steps_player(session.shown)->step();
    if (!step.rows.empty() || !step.source || step.marks.empty()) continue;
    ++without;
    const test::DrawnText drawn(gui);
    EXPECT_LT(drawn.place("Text000").y - drawn.place("Play").y, 0.6f * static_cast<float>(size_.height)) << i;
  }
  EXPECT_GT(without, 0);
}

// In a narrow window the panel lies over the view, and what is played goes beside it.
TEST(steps_flyout, what_is_played_is_seen_beside_it) {
  test::Laid laid("cube.obj", {640, 480});
  Session& session = laid.session;
  const auto say = [&](const std::string& line) {
    ASSERT_TRUE(laid.gui.run(session, line).done()) << line;
    laid.frames(4);
  };
  const auto shows_all_of = [&](std::span<const glm::dvec3> places) {
    Covered covered = session.framing.covered();
    EXPECT_GT(covered.right, 200);
    return shows_all(session.view.camera, session.view.size, covered, places);
  };
  const Camera before = session.view.camera;
  say("panel steps flyout");
  EXPECT_EQ(session.view.camera, before) << "who opens a tab is not moved";
  say("steps walk v0");
  EXPECT_TRUE(shows_all_of(session.mesh().positions()));
  say("steps close");
  say("panel none");
  EXPECT_LT(glm::length(session.view.camera.eye - before.eye), 1e-9);
  say("new");
  say("steps script cube");
  ASSERT_FALSE(session.shown.player()->places_at_end.empty());
  for (const char* const line : {"steps at 12", "frame all", "steps last", "panel steps flyout"}) {
    say(line);
    EXPECT_TRUE(shows_all_of(session.shown.player()->places_at_end)) << line;
    for (const glm::dvec3& place : session.shown.player()->places_at_end)
      EXPECT_GT(project(session.view.camera, session.view.size, place)->pixel.y, caption_px(session.preferences))
          << line;
  }
  say("panel none");
  EXPECT_EQ(session.view.covered_px, glm::dvec2(0));
  EXPECT_TRUE(session.framing.is_framed());
}

TEST(steps_flyout, closing_it_moves_nothing_that_was_not_framed_beside_it) {
  test::Laid laid("cube.obj", {640, 480});
  Session& session = laid.session;
  const auto say = [&](const std::string& line) {
    ASSERT_TRUE(laid.gui.run(session, line).done()) << line;
    laid.frames(4);
  };
  const Camera before = session.view.camera;
  say("translate by=3,0,0");
  for (const char* const line : {"panel steps flyout", "panel none"}) {
    say(line);
    EXPECT_EQ(session.view.camera, before) << line;
  }
  say("panel steps flyout");
  say("frame all");
  const Camera beside = session.view.camera;
  EXPECT_NE(beside, before);
  say("panel none");
  EXPECT_NE(session.view.camera, beside) << "all of the view is free again";
  EXPECT_TRUE(session.framing.is_framed());
}

// However much there is to play, the panels below stay in sight.
TEST_F(StepsPanelTest, the_list_of_what_there_is_to_play_has_a_height_of_its_own) {
  ASSERT_TRUE(say("panel steps").done());
  ASSERT_TRUE(say("panel history on").done());
  const test::DrawnText text(gui);
  EXPECT_LT(text.place("History").y - text.place("Stepbystep").y, 320);
  EXPECT_EQ(text.cut_in_height(), "");
}

TEST_F(StepsPanelTest, every_row_and_script_is_offered_and_goes_forth_and_back) {
  ASSERT_TRUE(say("panel steps").done());
  EXPECT_TRUE(has("Acube"));
  gui.pointer(test::DrawnText(gui).place("Acube"));
  for (int notch = 0; notch < 60 && !has("One-ringv0"); ++notch) {
    gui.wheel(-1);
    frames(2);
  }
  EXPECT_TRUE(has("One-ringv0"));
  const std::uint64_t hash = session.mesh().hash();
  const auto expect_playing = [&](const std::string& call) {
    ASSERT_TRUE(say("steps " + call).done()) << call;
    ASSERT_TRUE(session.shown.player());
    EXPECT_EQ(session.shown.player()->position(), 0u);
    ASSERT_TRUE(say("steps last").done());
    EXPECT_EQ(session.shown.player()->position(), session.shown.player()->size());
    EXPECT_TRUE(session.shown.shows(ShownBy::step));
    while (session.shown.player()->position() > 0) ASSERT_TRUE(session.run("steps back").done());
    EXPECT_EQ(say("steps close").kind, Outcome::Kind::done);
    EXPECT_EQ(session.mesh().hash(), hash) << call;
    EXPECT_TRUE(session.document().history().empty()) << "it is no edit";
    EXPECT_FALSE(session.document().is_modified());
  };
  for (const char* const script : {"triangle", "cube_with_hole", "figure_2", "figure_6"})
    expect_playing("script " + std::string(script));
  for (const steps::StepsRow& row : steps::all_steps()) {
    if (row.plays_script || row.choices(session.mesh(), session.selecting.selection).empty()) continue;
    std::string call(row.id);
    const std::vector<std::vector<std::string>> choices = row.choices(session.mesh(), session.selecting.selection);
    ASSERT_FALSE(choices.empty()) << row.id;
    for (const std::string& argument : choices.front()) call += " " + argument;
    expect_playing(call);
  }
}

TEST_F(StepsPanelTest, the_panel_leads_through_and_says_what_changes) {
  ASSERT_TRUE(say("steps script triangle").done());
  EXPECT_TRUE(has("0/14"));
  EXPECT_TRUE(has("Beforethefirststep."));
  for (int i = 0; i < 4; ++i) take(">");
  EXPECT_TRUE(has("4/14"));
  EXPECT_TRUE(has("E+1,W+1,I-2,S-1"));
  EXPECT_TRUE(has("none>h0"));
  EXPECT_TRUE(has("MakeEdge,figure4"));
  EXPECT_EQ(session.mesh().live().edges, 1u) << "the view shows the state";
  take("Thetriangleof");
  EXPECT_FALSE(session.shown.player());
  EXPECT_EQ(session.mesh().live().faces, 6u) << "the fan is back";
}

TEST_F(StepsPanelTest, calls_are_told_by_name_in_the_language_of_the_window) {
  ASSERT_TRUE(say("language ja").done());
  for (const steps::StepsRow& row : steps::all_steps()) {
    const std::vector<std::vector<std::string>> choices = row.choices(session.mesh(), session.selecting.selection);
    if (row.plays_script || choices.empty()) continue;
    std::string call(row.id);
    for (const std::string& argument : choices.front()) call += " " + argument;
    ASSERT_TRUE(say("steps " + call).done());
    EXPECT_TRUE(session.shown.player()->name().ja.starts_with(row.ja)) << session.shown.player()->name().ja;
    EXPECT_FALSE(has(row.id)) << row.id;
    EXPECT_EQ(leave_playing(session.view, session.framing, session.shown).sentence.ja,
              "「" + name_of_played(split(call)).ja + "」の再生を終えました。");
  }
}

TEST_F(StepsPanelTest, keys_lead_through) {
  ASSERT_TRUE(say("steps walk v0").done());
  EXPECT_TRUE(input_.key("Alt+Right").done());
  EXPECT_EQ(session.shown.player()->position(), 1u);
  EXPECT_TRUE(input_.key("Alt+End").done());
  EXPECT_EQ(session.shown.player()->position(), session.shown.player()->size());
  EXPECT_TRUE(input_.key("Alt+Left").done());
  EXPECT_EQ(session.shown.player()->position(), session.shown.player()->size() - 1);
  EXPECT_TRUE(input_.key("Alt+Home").done());
  EXPECT_EQ(session.shown.player()->position(), 0u);
}

TEST_F(StepsPanelTest, it_plays_by_itself_and_stops_at_the_end) {
  ASSERT_TRUE(say("steps loop f0").done());
  ASSERT_TRUE(say("steps play").done());
  EXPECT_TRUE(session.shown.player()->is_running);
  frames(30);
  EXPECT_EQ(session.shown.player()->position(), 0u) << "not yet: frames are a fiftieth of a second";
  for (int i = 0; i < 30; ++i) {
    frames(1);
    const std::string at =
        std::to_string(session.shown.player()->position()) + "/" + std::to_string(session.shown.player()->size());
    ASSERT_TRUE(has(at)) << "the panel shows the step that the view shows: " << at;
  }
  EXPECT_GE(session.shown.player()->position(), 1u);
  frames(400);
  EXPECT_EQ(session.shown.player()->position(), session.shown.player()->size());
  EXPECT_FALSE(session.shown.player()->is_running);
}

TEST_F(StepsPanelTest, marks_and_labels_are_in_the_view) {
  ASSERT_TRUE(say("steps collapse 0-1").done());
  EXPECT_TRUE(step_overlay(session.mesh(), session.view, session.gesturing, session.shown, Theme::dark).empty());
  ASSERT_TRUE(say("steps forward").done());
  EXPECT_FALSE(step_overlay(session.mesh(), session.view, session.gesturing, session.shown, Theme::dark).empty());
  const std::set<std::string> texts = labels();
  for (const char* const label : {"(1)", "(2)", "(3)", "(4)"}) EXPECT_TRUE(texts.contains(label)) << label;
  bool has_caption = false;
  for (const std::string& text : texts) has_caption |= text.starts_with("1/");
  EXPECT_TRUE(has_caption);
}

// Whole at any scale: each line has room in the view.
TEST_F(StepsPanelTest, the_words_of_a_step_have_lines_that_fit) {
  ASSERT_TRUE(say("steps hull").done());
  ASSERT_TRUE(say("steps at 4").done());
  for (const double scale : {1.0, 2.0}) {
    session.preferences.display_scale = scale;
    std::vector<Label> labels;
    add_step(session.mesh(), session.view, session.shown, session.preferences, labels);
    std::string all;
    for (const Label& label : labels) {
      if (!label.begins_there) continue;
      all += label.text;
      EXPECT_LT(scale * (7.8 * static_cast<double>(label.text.size()) + label.shift_px.x), session.view.size.width)
          << label.text;
    }
    EXPECT_NE(all.find(steps_player(session.shown)->step()->caption.en), std::string::npos) << all;
  }
}

TEST_F(StepsPanelTest, a_halfedge_is_an_arrow_in_its_face_and_not_its_edge) {
  ASSERT_TRUE(say("steps walk v0").done());
  std::size_t arrows = 0;
  while (session.shown.player()->position() < session.shown.player()->size()) {
    ASSERT_TRUE(session.run("steps forward").done());
    std::size_t marked = 0;
    for (const steps::Mark& mark : steps_player(session.shown)->step()->marks)
      marked += mark.element.kind == Element::Kind::halfedge ? 1 : 0;
    std::size_t drawn = 0;
    for (const Line& line :
         step_overlay(session.mesh(), session.view, session.gesturing, session.shown, Theme::dark).lines) {
      if (!line.arrow) continue;
      ++drawn;
      for (std::uint32_t v = 0; v < session.mesh().vertex_slots(); ++v) {
        EXPECT_NE(line.a, session.mesh().position(Vertex(v)));
        EXPECT_NE(line.b, session.mesh().position(Vertex(v)));
      }
    }
    EXPECT_EQ(drawn, marked);
    arrows += drawn;
  }
  EXPECT_GT(arrows, 12u);
}

TEST_F(StepsPanelTest, the_history_is_a_script_too) {
  EXPECT_EQ(say("steps script history").exit_code, ExitCode::refused) << "there is none yet";
  ASSERT_TRUE(say("split 0-1").done());
  ASSERT_TRUE(say("poke f0").done());
  const std::uint64_t hash = session.mesh().hash();
  ASSERT_TRUE(say("steps script history").done());
  EXPECT_EQ(session.shown.player()->size(), 2u);
  EXPECT_EQ(session.mesh().live().vertices, 7u) << "as it was read";
  ASSERT_TRUE(say("steps last").done());
  EXPECT_EQ(session.mesh().hash(), hash);
  ASSERT_TRUE(say("steps first").done());
  ASSERT_TRUE(say("undo").done());
  ASSERT_TRUE(session.shown.player()) << "undo takes the edit back and nothing else";
  EXPECT_EQ(session.mesh().live().vertices, 8u) << "what it has taken back is seen";
  ASSERT_TRUE(say("steps first").done());
  EXPECT_EQ(session.mesh().live().vertices, 7u) << "as it was read";
  ASSERT_TRUE(say("steps close").done());
  EXPECT_EQ(session.mesh().live().vertices, 8u);
}

// What is taken back and done again beneath what is played is seen, and the next step goes on where it was.
TEST_F(StepsPanelTest, undo_takes_back_the_edit_alone) {
  ASSERT_TRUE(say("split 0-1").done());
  const std::size_t vertices = session.mesh().live().vertices;
  ASSERT_TRUE(say("steps script cube").done());
  ASSERT_TRUE(say("steps at 12").done());
  const Camera camera = session.view.camera;
  const std::uint64_t shown = session.mesh().hash();
  for (const auto& [chord, position] : {std::pair("Ctrl+Z", 0u), {"Ctrl+Z", 0u}, {"Ctrl+Y", 1u}, {"Ctrl+Z", 0u}}) {
    input_.key(chord);
    EXPECT_EQ(session.document().position(), position) << chord;
    ASSERT_TRUE(session.shown.player()) << chord;
    EXPECT_EQ(session.shown.player()->position(), 12u);
    EXPECT_FALSE(session.shown.is_replaced()) << chord;
    EXPECT_EQ(session.mesh().live().vertices, vertices - 1 + position) << chord;
    EXPECT_NE(session.view.camera, camera) << "as the mesh was looked at before";
  }
  ASSERT_TRUE(say("steps at 12").done());
  EXPECT_EQ(session.mesh().hash(), shown);
  EXPECT_LT(glm::distance(session.view.camera.eye, camera.eye), 1e-9);
  EXPECT_FALSE(session.run("redo 7").done());
  EXPECT_EQ(session.mesh().hash(), shown) << "what is refused leaves the step";
  ASSERT_TRUE(say("steps close").done());
  EXPECT_EQ(session.mesh().live().vertices, vertices - 1);
  EXPECT_TRUE(session.framing.is_framed()) << "seen as before the exercise";
}

// It is made anew of the mesh as it is then; where that has not what it is about, it ends.
TEST_F(StepsPanelTest, undo_beneath_what_is_about_the_mesh) {
  ASSERT_TRUE(say("split 0-1").done());
  ASSERT_TRUE(say("steps walk v0").done());
  ASSERT_TRUE(say("steps at 2").done());
  ASSERT_TRUE(say("undo").done());
  ASSERT_TRUE(session.shown.player());
  EXPECT_EQ(session.shown.player()->position(), 2u);
  EXPECT_TRUE(session.shown.shows(ShownBy::step));
  ASSERT_TRUE(say("redo").done());
  ASSERT_TRUE(say("steps walk v7").done());
  const Outcome outcome = say("undo");
  EXPECT_TRUE(outcome.done());
  EXPECT_FALSE(session.shown.player());
  EXPECT_EQ(session.document().position(), 0u);
  EXPECT_NE(outcome.sentence.en.find("one-ring v7"), std::string::npos) << outcome.sentence.en;
}

// And that the file is not gone.
TEST_F(StepsPanelTest, the_bar_names_what_is_seen_and_the_file_beneath) {
  ASSERT_TRUE(say("steps script square").done());
  EXPECT_TRUE(has("Playing:Asquare(beneath:fan.obj)"));
  EXPECT_EQ(shown_name(session, false), "Playing: A square");
  ASSERT_TRUE(say("steps close").done());
  EXPECT_FALSE(has("Playing"));
  ASSERT_TRUE(say("split 0-1").done());
  ASSERT_TRUE(say("steps collapse 0-2").done());
  EXPECT_EQ(shown_name(session), "Playing: edge collapse 0-2 (beneath: * fan.obj)");
  ASSERT_TRUE(say("language ja").done());
  EXPECT_EQ(shown_name(session), "再生中：稜線削除 0-2（下に * fan.obj）");
  ASSERT_TRUE(say("steps walk v0").done());
  EXPECT_EQ(shown_name(session), "* fan.obj") << "that is what is seen";
}

TEST_F(StepsPanelTest, escape_leaves_what_is_played_last) {
  ASSERT_TRUE(say("select v1").done());
  ASSERT_TRUE(say("tool collapse").done());
  ASSERT_TRUE(say("steps walk v0").done());
  ASSERT_TRUE(say("panel keys").done());
  const auto escape = [&] {
    EXPECT_TRUE(input_.key("Escape").done());
    frames(3);
  };
  escape();
  EXPECT_EQ(session.layout.open_panel, "");
  escape();
  EXPECT_EQ(session.selecting.tool, "");
  EXPECT_EQ(session.selecting.selection.size(), 1u);
  escape();
  EXPECT_TRUE(session.selecting.selection.empty());
  ASSERT_TRUE(session.shown.player());
  escape();
  EXPECT_FALSE(session.shown.player());
  // What is selected of the mesh beneath a step is not to be seen.
  ASSERT_TRUE(say("select v1").done());
  const std::uint64_t hash = session.mesh().hash();
  ASSERT_TRUE(say("steps script cube").done());
  ASSERT_TRUE(say("steps at 9").done());
  escape();
  EXPECT_FALSE(session.shown.player());
  EXPECT_EQ(session.mesh().hash(), hash);
  EXPECT_EQ(session.selecting.selection.size(), 1u);
}

// Only an edit of the mesh beneath ends it, which is said; what changes nothing, and what writes, leaves it as it is.
TEST_F(StepsPanelTest, what_is_played_ends_by_an_edit_of_what_is_seen_and_by_no_other_command) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(say("steps script cube").done());
  ASSERT_TRUE(say("steps at 9").done());
  const Camera camera = session.view.camera;
  const std::uint64_t shown = session.mesh().hash();
  for (const std::string& line :
       {std::string("collapse 0-99"), "save " + (folder.path() / "a.obj").string(), std::string("open nowhere.obj"),
        std::string("repair"), std::string("key Enter"), std::string("select v99"), std::string("split 0-1"),
        std::string("key O"), std::string("cube")}) {
    const Outcome outcome = say(line);
    ASSERT_TRUE(session.shown.player()) << line << ": " << outcome.sentence.en;
    EXPECT_EQ(session.shown.player()->position(), 9u) << line;
    EXPECT_EQ(session.mesh().hash(), shown) << line;
    EXPECT_EQ(session.view.camera, camera) << line;
    EXPECT_TRUE(session.framing.is_framed()) << line;
  }
  const Outcome saved = say("save " + (folder.path() / "b.obj").string());
  EXPECT_NE(saved.sentence.en.find("the open mesh, not the step that is shown"), std::string::npos)
      << saved.sentence.en;
  const Outcome selected = say("select v0");
  EXPECT_NE(selected.sentence.en.find("The view shows the open mesh"), std::string::npos) << selected.sentence.en;
  EXPECT_EQ(session.mesh().live().vertices, 7u);
  EXPECT_NE(session.view.camera, camera) << "as it was looked at before";
  ASSERT_TRUE(say("steps at 9").done());
  EXPECT_EQ(session.mesh().hash(), shown);
  EXPECT_TRUE(session.framing.is_framed());
  EXPECT_EQ(say("split 0-1").exit_code, ExitCode::refused) << "what it would be done to is not seen";
  ASSERT_TRUE(say("select v0").done());
  const Outcome outcome = say("split 0-1");
  EXPECT_FALSE(session.shown.player());
  EXPECT_EQ(session.mesh().live().vertices, 8u);
  EXPECT_NE(outcome.sentence.en.find("The steps of 'A cube' are left."), std::string::npos) << outcome.sentence.en;
  EXPECT_NE(outcome.sentence.ja.find("「立方体」の再生を終えました。"), std::string::npos) << outcome.sentence.ja;
}

TEST_F(StepsPanelTest, a_script_may_have_a_name_with_blanks) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("two words.ryosen", "split 0-1\n");
  for (const std::string& line : {"steps script " + file, "steps script \"" + file + "\""}) {
    ASSERT_TRUE(say(line).done()) << line;
    EXPECT_EQ(session.shown.player()->size(), 1u);
    ASSERT_TRUE(say("steps " + session.shown.player()->call()).done()) << "the call is a line that does it again";
  }
  EXPECT_FALSE(session.files.may_write(file, FileRole::picture)) << "no picture takes its place";
}

// By the frames alone, also where its panel is folded or not shown.
TEST_F(StepsPanelTest, plays_on_without_its_panel) {
  ASSERT_TRUE(say("steps loop f0").done());
  ASSERT_TRUE(say("panel steps off").done());
  EXPECT_FALSE(gui.seconds_to_step());
  ASSERT_TRUE(say("steps play").done());
  ASSERT_TRUE(gui.seconds_to_step());
  EXPECT_LE(*gui.seconds_to_step(), 0.8);
  frames(60);
  EXPECT_GE(session.shown.player()->position(), 1u);
  EXPECT_FALSE(gui.wants_frames()) << "between the steps nothing is to be laid out";
  ASSERT_TRUE(say("steps pause").done());
  frames(1);
  EXPECT_FALSE(gui.seconds_to_step());
}

TEST_F(StepsPanelTest, refuses_what_is_not_there) {
  EXPECT_EQ(say("steps forward").exit_code, ExitCode::refused);
  EXPECT_EQ(say("steps nonsense").exit_code, ExitCode::usage);
  EXPECT_EQ(say("steps").exit_code, ExitCode::usage);
  ASSERT_TRUE(say("steps walk v0").done());
  EXPECT_EQ(say("steps at 99").exit_code, ExitCode::usage);
  EXPECT_EQ(say("steps at x").exit_code, ExitCode::usage);
  ASSERT_TRUE(say("steps at 2").done());
  EXPECT_EQ(session.shown.player()->position(), 2u);
}

}  // namespace
}  // namespace ryosen
