// `steps`: what is played, as lines and as pictures.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "render/image.h"
#include "ryosen/textbook/steps/all.h"
#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

// Every line is whole; they count up.
void expect_lines(const ProgramRun& run) {
  const std::vector<Json> lines = run.lines();
  ASSERT_FALSE(lines.empty()) << run.err;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i]["at"], i + 1);
    EXPECT_EQ(lines[i]["of"], lines.size());
    EXPECT_NE(lines[i]["caption"]["en"], "");
    EXPECT_NE(lines[i]["caption"]["ja"], "");
  }
}

TEST(steps_command, plays_every_row_of_the_table) {
  const std::string fan = asset("fan.obj");
  const std::vector<std::vector<std::string>> lines = {{"steps", "script", "cube"},
                                                       {"steps", "build", fan},
                                                       {"steps", "pair", "hash", fan},
                                                       {"steps", "collapse", "0-1", fan},
                                                       {"steps", "swap", "0-1", fan},
                                                       {"steps", "split3", "1,4", fan},
                                                       {"steps", "split3", "1", "4", fan},
                                                       {"steps", "walk", "v0", fan},
                                                       {"steps", "loop", "f0", fan},
                                                       {"steps", "relation", "vertex_faces", "v0", fan},
                                                       {"steps", "hull", asset("tetrahedron.off")}};
  std::set<std::string> played;
  for (std::vector<std::string> line : lines) {
    played.insert(line[1]);
    line.push_back("--json");
    const ProgramRun run = run_program(line);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    expect_lines(run);
  }
  for (const steps::StepsRow& row : steps::all_steps()) EXPECT_TRUE(played.contains(std::string(row.id))) << row.id;
  EXPECT_EQ(run_program({"steps", "split3 1,4", fan, "--json"}).out,
            run_program({"steps", "split3", "1", "4", fan, "--json"}).out)
      << "in one word or in several";
}

TEST(steps_command, gives_the_delta_of_what_edits) {
  const ProgramRun run = run_program({"steps", "script", "cube_with_hole", "--json"});
  Json sum = {{"V", 0}, {"E", 0}, {"F", 0}, {"B", 0}, {"W", 0}, {"I", 0}, {"H", 0}, {"S", 0}, {"G", 0}};
  for (const Json& line : run.lines()) {
    if (!line.contains("delta")) continue;
    EXPECT_EQ(keys_of(line["delta"]), keys_of(sum));
    for (const auto& [term, by] : line["delta"].items()) sum[term] = int(sum[term]) + int(by);
  }
  EXPECT_EQ(sum, (Json{{"V", 16}, {"E", 24}, {"F", 10}, {"B", 0}, {"W", 0}, {"I", 0}, {"H", 2}, {"S", 1}, {"G", 1}}));
}

// The report: after a deletion the first half of an edge has no face.
TEST(steps_command, asks_every_relation_of_one_sided_edges_after_a_deletion) {
  const std::string mesh = std::string(RYOSEN_SOURCE_DIR) + "/tests/data/reports/two.obj";
  for (const char* const line :
       {"edge_faces 1-2", "edge_faces 2-3", "edge_faces 1-3", "edge_edges 1-2", "edge_vertices 1-2", "face_faces f1",
        "face_edges f1", "face_vertices f1", "vertex_faces v1", "vertex_edges v1", "vertex_vertices v1", "valence v1"})
    EXPECT_EQ(run_program({"edit", mesh, "--do", std::string("delete f0; steps relation ") + line}).exit_code, 0)
        << line;
}

TEST(steps_command, refuses_a_picture_under_the_name_of_another_format) {
  TemporaryFolder folder;
  const std::string file = folder.at("step.jpg");
  const ProgramRun run = run_program({"steps", "build", asset("fan.obj"), "--at", "1", "-o", file, "--json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.lines().back()["messages"][0]["code"], "unknown_format") << run.out;
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(steps_command, plays_a_script_of_a_file_on_a_mesh) {
  TemporaryFolder folder;
  const std::string script = folder.write("s.ryosen", "split 0-1; collapse 0-2\n");
  const ProgramRun run = run_program({"steps", "script", script, asset("tetrahedron.off"), "--json"});
  ASSERT_EQ(run.lines().size(), 2u) << run.err;
  EXPECT_EQ(run.lines()[0]["delta"]["V"], 1);
}

TEST(steps_command, ends_as_edit_does_where_a_script_is_refused_or_wrong) {
  TemporaryFolder folder;
  const std::string mesh = asset("tetrahedron.off");
  for (const char* const lines : {"collapse 0-1\nsplit 0-1\n", "split 0-1\nremove_vertex v0\n", "expect V 9\n",
                                  "delete f0\nfill 0-1\nsplit 0-1\nswap 0-1\n"}) {
    const std::string script = folder.write("s.ryosen", lines);
    const ProgramRun played = run_program({"steps", "script", script, mesh, "--json"}),
                     edited = run_program({"edit", mesh, "--script", script, "--json"});
    EXPECT_NE(played.exit_code, 0) << lines;
    EXPECT_EQ(played.exit_code, edited.exit_code) << lines;
    const Json failure = played.lines().back();
    EXPECT_EQ(failure["status"], "error");
    bool is_said = false;
    for (const Json& line : edited.lines())
      for (const Json& message : line.value("messages", Json::array()))
        is_said |= message["code"] == failure["messages"][0]["code"] &&
                   message["en"].get<std::string>().starts_with(failure["messages"][0]["en"].get<std::string>());
    EXPECT_TRUE(is_said) << failure << edited.out;
    EXPECT_EQ(run_program({"steps", "script", script, mesh, "--at", "1"}).exit_code,
              played.lines()[0]["of"] == 1 ? played.exit_code : 0)
        << "a step before it is as good as any";
  }
}

TEST(steps_command, tells_one_step_and_says_it_in_words) {
  const std::string fan = asset("fan.obj");
  const ProgramRun one = run_program({"steps", "walk", "v0", fan, "--at", "2", "--json"});
  EXPECT_EQ(one.line()["at"], 2);
  EXPECT_NE(run_program({"steps", "walk", "v0", fan, "--at", "1"}).out.find("halfedge(v0)"), std::string::npos);
  EXPECT_NE(run_program({"steps", "walk", "v0", fan, "--at", "1", "--lang", "ja"}).out.find("頂点"), std::string::npos);
  for (const char* const wrong : {"0", "99", "x"})
    EXPECT_EQ(run_program({"steps", "walk", "v0", fan, "--at", wrong}).exit_code, 2) << wrong;
}

TEST(steps_command, of_an_empty_script_are_none) {
  TemporaryFolder folder;
  const std::string script = folder.write("s.ryosen", "# nothing\n"), mesh = asset("tetrahedron.off");
  const ProgramRun run = run_program({"steps", "script", script, mesh, "--at", "1", "--json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.line()["messages"][0]["en"], "There is no step that --at could name.") << run.out;
}

TEST(steps_command, refuses_what_cannot_be_played) {
  const std::string cube = asset("cube.obj");
  const std::vector<std::pair<std::vector<std::string>, int>> wrong = {{{"steps"}, 2},
                                                                       {{"steps", "script"}, 2},
                                                                       {{"steps", "script", "nosuch.ryosen"}, 3},
                                                                       {{"steps", "nonsense", cube}, 2},
                                                                       {{"steps", "build"}, 2},
                                                                       {{"steps", "build", "nosuch.obj"}, 3},
                                                                       {{"steps", "walk", "v99", cube}, 2},
                                                                       {{"steps", "collapse", "0-1", cube}, 6},
                                                                       {{"steps", "walk", "v0", cube, "-o", cube}, 5}};
  for (const auto& [line, exit_code] : wrong) EXPECT_EQ(run_program(line).exit_code, exit_code) << line.back();
}

// The pointer moves what a split makes, also where no window is.
TEST(edit_command, splits_an_edge_at_any_place_by_the_pointer) {
  const ProgramRun run = run_program({"edit", asset("fan.obj"), "--do",
                                      "view front; select 0-1; move 500,300; gesture split; move 560,350; press left "
                                      "560,350; release left 560,350; expect V 8; expect F 8; undo; expect V 7",
                                      "-q"});
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
}

TEST(steps_command, draws_the_step_with_its_marks) {
  TemporaryFolder folder;
  const std::string fan = asset("fan.obj");
  const auto draw = [&](const std::string& at, const std::string& name) {
    const ProgramRun run = run_program({"steps", "collapse", "1-0", fan, "--at", at, "-o", folder.at(name), "--json"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return read_png(folder.at(name));
  };
  const auto first = draw("1", "1.png"), again = draw("1", "1b.png"), later = draw("2", "2.png");
  ASSERT_TRUE(first && again && later);
  EXPECT_EQ(compare(*first, *again)->share, 0.0);
  EXPECT_GT(compare(*first, *later)->share, 0.001);
}

}  // namespace
}  // namespace ryosen::test
