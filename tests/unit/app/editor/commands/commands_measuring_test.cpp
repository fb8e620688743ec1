// The commands `colours` and `measure`, and `select by`.
#include <gtest/gtest.h>

#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/labels/labels.h"
#include "app/editor/session/session.h"
#include "app/editor/texts/measure_text.h"
#include "tests/support/app/program.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

std::unique_ptr<Session> measured_cube() {
  auto document = Document::open(test::asset("cube.obj"));
  EXPECT_TRUE(document);
  return std::make_unique<Session>(std::move(document).value());
}

TEST(commands_measuring, colours_say_what_the_numbers_are_and_keep_their_range) {
  const auto session = measured_cube();
  EXPECT_EQ(session->run("colours edge_length").sentence.en, "Edge length: 1 to 1, mean 1, median 1, of 12");
  EXPECT_EQ(session->run("colours dihedral").sentence.en, "Dihedral angle: 90° to 90°, mean 90°, median 90°, of 12");
  EXPECT_EQ(session->view.colouring->range, (MapRange{90, 270}));
  ASSERT_TRUE(session->run("colours area 0 4").done());
  ASSERT_TRUE(session->run("poke f0").done());
  EXPECT_EQ(session->view.colouring->range, (MapRange{0, 4}));
  EXPECT_EQ(figures_of(session->findings().map_values(*session->view.colouring).all()).count, 9u);
  EXPECT_DOUBLE_EQ(figures_of(session->findings().map_values(*session->view.colouring).all()).lowest, 0.25);
  ASSERT_TRUE(session->run("undo").done());
  EXPECT_EQ(figures_of(session->findings().map_values(*session->view.colouring).all()).count, 6u);
  ASSERT_TRUE(session->run("colours off").done());
  EXPECT_FALSE(session->view.colouring);
}

TEST(commands_measuring, colours_show_the_middle_of_the_values_first_and_all_where_asked) {
  auto document = Document::open(test::asset("torus.off"));
  Session session(std::move(document).value());
  ASSERT_TRUE(session.run("colours area").done());
  const MapFigures figures = figures_of(session.findings().map_values(*session.view.colouring).all());
  EXPECT_EQ(session.view.colouring->range, first_range(*session.view.colouring->map, figures));
  ASSERT_TRUE(session.run("colours area all").done());
  EXPECT_EQ(session.view.colouring->range, (MapRange{figures.lowest, figures.highest}));
  EXPECT_EQ(session.findings().map_extent(*session.view.colouring), (MapRange{figures.lowest, figures.highest}));
  ASSERT_TRUE(session.run("move_vertex v0 9,9,9").done());
  EXPECT_GT(session.findings().map_extent(*session.view.colouring).high, figures.highest) << "followed";
}

TEST(commands_measuring, a_legend_of_equal_values_says_the_value_once) {
  const auto session = measured_cube();
  ASSERT_TRUE(session->run("colours edge_length").done());
  std::vector<Label> labels;
  add_map_legend(session->findings(), session->view, session->preferences, labels);
  ASSERT_EQ(labels.size(), 2u);
  EXPECT_EQ(labels[0].text, "1");
  ASSERT_TRUE(session->run("colours edge_length 0 2").done());
  labels.clear();
  add_map_legend(session->findings(), session->view, session->preferences, labels);
  EXPECT_EQ(labels.size(), 8u);
}

TEST(commands_measuring, a_legend_of_counts_names_none_that_there_cannot_be) {
  Session session(std::move(Document::open(test::asset("ball.off"))).value());  // 4, and 16 at the poles
  ASSERT_TRUE(session.run("colours valence all").done());
  std::vector<Label> labels;
  add_map_legend(session.findings(), session.view, session.preferences, labels);
  ASSERT_EQ(labels.size(), 8u);
  EXPECT_EQ(labels[0].text, "4");
  EXPECT_EQ(labels[6].text, "16");
}

// In the picture, in the panel and in the status line.
TEST(commands_measuring, a_measure_is_told_with_the_same_digits_everywhere) {
  const auto session = measured_cube();
  ASSERT_TRUE(session->run("move_vertex v0 -0.123456789,0,0").done());
  session->preferences.language = Language::english;
  const std::string said = session->run("measure v0 v2").sentence.en;
  EXPECT_GT(said.size(), 16u) << "scripts have all digits";
  std::vector<Label> labels;
  add_measures(session->mesh(), session->selecting, session->preferences, labels);
  ASSERT_EQ(labels.size(), 1u);
  EXPECT_EQ(labels[0].text, with_short_numbers(said));
  EXPECT_EQ(measured_text(session->mesh(), session->selecting.measures[0]).en, with_short_numbers(said));
}

TEST(commands_measuring, wrong_maps_and_ranges_are_refused_with_the_right_ones) {
  const auto session = measured_cube();
  for (const char* line : {"colours", "colours edge_lenght", "colours area some", "colours area 3", "colours area 3 2",
                           "colours area a b"}) {
    EXPECT_FALSE(session->run(line).done()) << line;
    EXPECT_TRUE(fault_of_command(line)) << line;
  }
  EXPECT_NE(session->run("colours edge_lenght").sentence.en.find("edge_length"), std::string::npos);
  session->run("new");
  EXPECT_EQ(session->run("colours area").exit_code, ExitCode::refused);
  EXPECT_FALSE(session->view.colouring);
}

TEST(commands_measuring, select_by_takes_what_lies_in_a_range_with_both_ends) {
  const auto session = measured_cube();
  ASSERT_TRUE(session->run("poke f0").done());
  EXPECT_EQ(session->run("select by area 0.25 0.25").sentence.en, "4 elements are selected");
  EXPECT_EQ(session->run("select by valence 4 4").sentence.en, "5 elements are selected");
  EXPECT_EQ(session->selecting.selection[0].kind, Element::Kind::vertex);
  for (const char* line : {"select by area 1", "select by volume 0 1", "select by area 2 1"})
    EXPECT_FALSE(session->run(line).done()) << line;
}

TEST(commands_measuring, measures_follow_the_mesh_and_say_when_they_are_gone) {
  const auto session = measured_cube();
  EXPECT_EQ(session->run("measure v0 v1").sentence.en, "distance 1");
  EXPECT_EQ(session->run("measure f0 0-1").sentence.en, "distance 0");
  ASSERT_TRUE(session->run("select 0-1 1-2").done());
  EXPECT_EQ(session->run("measure selected").sentence.en, "distance 0, angle 90°");
  ASSERT_TRUE(session->run("move_vertex v0 -1,0,0").done());
  EXPECT_EQ(measured_text(session->mesh(), session->selecting.measures[0]).en, "distance 2");
  ASSERT_TRUE(session->run("delete f0").done());
  EXPECT_EQ(measured_text(session->mesh(), session->selecting.measures[1]).en, "an element of it is gone");
  ASSERT_TRUE(session->run("undo").done());
  EXPECT_EQ(measured_text(session->mesh(), session->selecting.measures[1]).en, "distance 0");
  ASSERT_TRUE(session->run("measure clear").done());
  EXPECT_TRUE(session->selecting.measures.empty());
  EXPECT_EQ(session->run("measure v0").exit_code, ExitCode::refused);
  EXPECT_FALSE(session->run("measure").done());
  EXPECT_FALSE(session->run("measure v0 v99").done());
}

}  // namespace
}  // namespace ryosen
