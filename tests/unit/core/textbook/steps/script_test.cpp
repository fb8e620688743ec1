// Scripts that are played: the exercises of the texts, step by step.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "ryosen/textbook/steps/all.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/stated_changes.h"
#include "tests/support/core/step_checks.h"

namespace ryosen {
namespace {

using namespace test;
using steps::Sequence;

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    line = line.substr(0, line.find('#'));
    if (!split_words(line).empty()) lines.push_back(line);
  }
  return lines;
}

std::vector<std::filesystem::path> scripts() {
  std::vector<std::filesystem::path> all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(RYOSEN_SOURCE_DIR "/assets/exercises"))
    if (entry.path().extension() == ".ryosen") all.push_back(entry.path());
  return all;
}

Result<std::unique_ptr<Sequence>> play(const Mesh& mesh, const std::vector<std::string>& lines) {
  return steps::find_steps("script")->make(mesh, lines);
}

// The law of each operator's header, asked of a mesh that a test of its own builds line by line.
TEST(script_steps, each_delta_is_what_the_header_of_the_operator_promises) {
  std::size_t compared = 0;
  for (const std::filesystem::path& file : scripts()) {
    const std::vector<std::string> lines = lines_of(file);
    const auto sequence = play(Mesh(), lines);
    ASSERT_TRUE(sequence.ok()) << file << sequence.failure().message.text.en;
    ASSERT_EQ((*sequence)->size(), lines.size()) << file;
    Mesh mesh;
    for (std::size_t i = 1; i <= lines.size(); ++i) {
      const steps::Step step = (*sequence)->at(i);
      EXPECT_TRUE(step.caption.en.find(lines[i - 1]) == 0) << step.caption.en;
      if (lines[i - 1].starts_with("expect")) {
        EXPECT_FALSE(step.delta) << lines[i - 1];
        EXPECT_NE(step.caption.en.find("it is so"), std::string::npos) << file << ": " << step.caption.en;
        continue;
      }
      const AnyOp op = op_of(mesh, lines[i - 1]);
      ASSERT_TRUE(step.delta && step.delta->g && step.source) << lines[i - 1];
      const Change change{step.delta->v,
                          step.delta->e,
                          step.delta->f,
                          step.delta->h,
                          step.delta->s,
                          *step.delta->g,
                          *step.delta->b + step.delta->w + step.delta->i};
      const std::vector<Change> stated = law_of(Stated{mesh}, op);
      ASSERT_FALSE(stated.empty()) << lines[i - 1];
      EXPECT_TRUE(std::count(stated.begin(), stated.end(), change)) << file << ": " << step.caption.en;
      ++compared;
      Edit edit(mesh, nullptr);
      apply(edit, op);
      edit.commit();
      EXPECT_EQ(mesh.hash(), (*sequence)->mesh_at(i).hash()) << lines[i - 1];
    }
  }
  EXPECT_GT(compared, 150u);
}

// By hand from the text's figures: a vertex by itself is an I, an edge by itself a walk W around it, a triangle's rim a
// B.
TEST(script_steps, tell_boundary_loops_walks_along_wires_and_points_apart) {
  struct Told {
    const char *line, *changes;
  };
  const Told told[] = {{"make_vertex 0,0,0", "V + 1, I + 1, S + 1"},
                       {"make_vertex 2,0,0", "V + 1, I + 1, S + 1"},
                       {"make_vertex 1,2,0", "V + 1, I + 1, S + 1"},
                       {"expect B 0", nullptr},
                       {"expect I 3", nullptr},
                       {"make_edge v0 v1", "E + 1, W + 1, I - 2, S - 1"},
                       {"make_edge v1 v2", "E + 1, I - 1, S - 1"},
                       {"make_edge v2 v0", "E + 1, W + 1"},
                       {"expect W 2", nullptr},
                       {"make_loop 0-1", "F + 1, B + 1, W - 2"},
                       {"expect B 1", nullptr},
                       {"expect W 0", nullptr},
                       {"delete_loop f0", "F - 1, B - 1, W + 2"}};
  std::vector<std::string> lines;
  for (const Told& one : told) lines.emplace_back(one.line);
  const auto sequence = play(Mesh(), lines);
  ASSERT_TRUE(sequence.ok());
  ASSERT_EQ((*sequence)->size(), std::size(told));
  for (std::size_t i = 0; i < std::size(told); ++i) {
    const steps::Step step = (*sequence)->at(i + 1);
    if (!told[i].changes) {
      EXPECT_NE(step.caption.en.find("it is so"), std::string::npos) << step.caption.en;
      continue;
    }
    ASSERT_TRUE(step.delta) << told[i].line;
    EXPECT_EQ(steps::text_of(*step.delta).en, told[i].changes) << told[i].line;
    EXPECT_TRUE(step.caption.en.ends_with(told[i].changes)) << step.caption.en;
  }
}

// Where boundary edges close to no loop there is no B, before or after.
TEST(script_steps, tell_no_boundary_loops_where_chains_stay_open) {
  const auto sequence = play(make_mesh(fin()), {"delete f2", "expect B 1"});
  ASSERT_TRUE(sequence.ok());
  ASSERT_EQ((*sequence)->size(), 2u);
  EXPECT_FALSE((*sequence)->at(1).delta->b);
  EXPECT_EQ((*sequence)->at(1).caption.en.find(" B "), std::string::npos) << (*sequence)->at(1).caption.en;
}

TEST(script_steps, go_forth_and_back) {
  for (const char* const name : {"triangle", "cube_with_hole"}) {
    const auto sequence =
        play(Mesh(), lines_of(std::string(RYOSEN_SOURCE_DIR "/assets/exercises/") + name + ".ryosen"));
    ASSERT_TRUE(sequence.ok());
    expect_plays(**sequence);
  }
}

TEST(script_steps, end_at_what_is_refused_and_at_what_is_not_so) {
  const auto refused = play(make_mesh(tetrahedron()), {"collapse 0-1", "split 0-1"});
  ASSERT_TRUE(refused.ok());
  ASSERT_EQ((*refused)->size(), 1u);
  const steps::Step step = (*refused)->at(1);
  EXPECT_FALSE(step.delta);
  EXPECT_FALSE(step.marks.empty()) << "what stands in the way";
  EXPECT_NE(step.caption.en.find("refused"), std::string::npos);
  expect_plays(**refused);
  const auto wrong = play(make_mesh(tetrahedron()), {"expect V 5", "split 0-1"});
  ASSERT_TRUE(wrong.ok());
  ASSERT_EQ((*wrong)->size(), 1u);
  EXPECT_NE((*wrong)->at(1).caption.en.find("it is 4"), std::string::npos);
}

TEST(script_steps, refuse_what_they_cannot_play) {
  for (const char* const line : {"select v0", "split 0-9", "split", "expect V", "expect X 1", "expect V x"}) {
    const auto played = play(make_mesh(tetrahedron()), {line});
    ASSERT_FALSE(played.ok()) << line;
    EXPECT_EQ(played.failure().exit_code, ExitCode::usage);
    EXPECT_NE(played.failure().message.text.en.find(line), std::string::npos);
    EXPECT_NE(played.failure().message.text.ja.find(line), std::string::npos);
  }
}

TEST(steps, every_row_has_words_in_both_languages_and_its_own_id) {
  for (const steps::StepsRow& row : steps::all_steps()) {
    EXPECT_EQ(steps::find_steps(row.id), &row);
    for (const std::string_view text : {row.en, row.ja, row.help_en, row.help_ja}) EXPECT_NE(text, "") << row.id;
  }
  EXPECT_EQ(steps::find_steps("nonsense"), nullptr);
  for (const steps::RoleRow& row : steps::roles()) EXPECT_NE(row.en, row.ja) << row.id;
}

}  // namespace
}  // namespace ryosen
