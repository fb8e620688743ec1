// Remedies: `why` and `edit` name the same ones, and after them the command as it was written can be done. Many runs
// take place within this process, which is faster.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

constexpr std::uintmax_t largest_mesh = 10'000;     // bytes
constexpr std::size_t most_of_an_operator = 40;     // refusals of one mesh
constexpr const char* before_remedy = " Remedy: ";  // in the message of `edit`

struct Refusal {
  std::string line, remedy;  // empty: none
};

std::string joined(const Json& remedy) {
  std::string steps;
  if (remedy.is_array())
    for (const Json& step : remedy) steps += (steps.empty() ? "" : "; ") + std::string(step);
  return steps;
}

// The small meshes of the assets, and the known ones where they are present.
std::vector<std::string> small_meshes() {
  std::vector<std::string> files;
  for (const std::string& folder :
       {std::filesystem::path(asset("cube.obj")).parent_path().string(), shared_file("meshes/known")}) {
    if (folder.empty()) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string kind = entry.path().extension().string();
      if ((kind == ".obj" || kind == ".off") && entry.file_size() <= largest_mesh)
        files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

// What `why` refuses of an operator on edges, spread over the edges. Nothing of a file that cannot be read.
void add_refused_edges(const std::string& file, const std::string& op, std::vector<Refusal>& refusals) {
  std::vector<Refusal> all;
  const ProgramRun run = run_here({"why", file, "--op", op, "--all", "--json"});
  if (run.exit_code != 0) return;
  for (const Json& line : run.lines())
    if (line["legal"] == false) all.push_back({op + " " + std::string(line["edge"]), joined(line["remedy"])});
  const std::size_t step = all.size() / most_of_an_operator + 1;
  for (std::size_t i = 0; i < all.size(); i += step) refusals.push_back(all[i]);
}

// What `why` refuses of a line; one that means nothing on the mesh is no refusal.
void add_refused_line(const std::string& file, const std::string& line, std::vector<Refusal>& refusals) {
  const ProgramRun run = run_here({"why", file, "--do", line, "--json"});
  if (run.exit_code != 0 || run.line()["legal"] == true) return;
  refusals.push_back({line, joined(run.line()["remedy"])});
}

std::string remedy_in_message(const Json& step) {
  if (!step.contains("messages")) return {};
  const std::string text = step["messages"][0]["en"];
  const std::size_t at = text.find(before_remedy);
  return at == std::string::npos ? std::string() : text.substr(at + std::string(before_remedy).size());
}

// In one run: what is refused leaves the mesh as it was, so every line meets the same mesh.
void expect_edit_names_the_same(const std::string& file, const std::vector<Refusal>& refusals) {
  std::vector<std::string> arguments{"edit", file, "--on-refuse", "skip", "--json"};
  for (const Refusal& refusal : refusals) arguments.insert(arguments.end(), {"--do", refusal.line});
  const std::vector<Json> steps = run_here(arguments).lines();
  ASSERT_EQ(steps.size(), refusals.size() + 1) << file;
  for (std::size_t i = 0; i < refusals.size(); ++i) {
    EXPECT_EQ(steps[i]["result"], "refused") << file << ": " << refusals[i].line;
    EXPECT_EQ(remedy_in_message(steps[i]), refusals[i].remedy) << file << ": " << refusals[i].line;
  }
}

// Returns how many had one.
std::size_t expect_remedies_work(const std::string& file, const std::vector<Refusal>& refusals) {
  std::vector<std::string> arguments{"edit", file, "--json"};
  std::size_t count = 0;
  for (const Refusal& refusal : refusals) {
    if (refusal.remedy.empty()) continue;
    const auto steps = 2 + std::count(refusal.remedy.begin(), refusal.remedy.end(), ';');
    const std::string script = refusal.remedy + "; " + refusal.line + "; undo " + std::to_string(steps);
    arguments.insert(arguments.end(), {"--do", script});
    ++count;
  }
  if (count == 0) return 0;
  const ProgramRun run = run_here(arguments);
  EXPECT_EQ(run.exit_code, 0) << file << "\n" << run.out;
  return count;
}

TEST(remedies, are_the_same_in_why_and_edit_and_work) {
  std::size_t asked = 0, remedied = 0;
  for (const std::string& file : small_meshes()) {
    std::vector<Refusal> refusals;
    for (const char* op : {"collapse", "swap", "split", "dissolve"}) add_refused_edges(file, op, refusals);
    for (const char* line : {"make_loop 0-1@f0", "fill 0-1", "vertex_split v0 v2 v3", "extrude f0", "weld v0 v2"})
      add_refused_line(file, line, refusals);
    if (refusals.empty()) continue;
    expect_edit_names_the_same(file, refusals);
    remedied += expect_remedies_work(file, refusals);
    asked += refusals.size();
  }
  std::cout << "  remedies for " << remedied << " of " << asked << " refusals\n";
  EXPECT_GT(remedied, asked / 4);
}

Json why(const std::string& file, const std::string& line) {
  return run_program({"why", file, "--do", line, "--json"}).line();
}

TEST(remedies, detach_a_sheet_where_several_meet) {
  const std::string mesh = asset("three_tri_edge.off");
  for (const char* line : {"swap 0-1@f0", "dissolve 0-1@f0", "unite_loop 1-0@f0"}) {
    const std::string remedy = joined(why(mesh, line)["remedy"]);
    EXPECT_EQ(remedy.rfind("detach ", 0), 0u) << line << ": " << remedy;
    EXPECT_EQ(remedy.find("f0"), std::string::npos) << line << ": " << remedy;
  }
}

TEST(remedies, keep_the_face_that_the_command_names) {
  const std::string pair = asset("hanging_pair.obj");
  EXPECT_EQ(why(pair, "split 0-1@f1")["remedy"], Json::array({"delete_loop f2"}));
  EXPECT_EQ(why(pair, "split 1-0@f2")["remedy"], Json::array({"delete_loop f1"}));
  EXPECT_EQ(run_program({"edit", pair, "--do", "delete_loop f2; split 0-1@f1"}).exit_code, 0);
}

TEST(remedies, delete_the_duplicate_that_the_command_does_not_name) {
  const std::string mesh = asset("duplicate_face.obj");
  for (const std::string line :
       {"extrude f0", "poke f0", "triangulate f0", "separate_loop v0 v2 f0", "vertex_split v1@f0 v2 v0"}) {
    const Json answer = why(mesh, line);
    ASSERT_EQ(answer["legal"], false) << line;
    EXPECT_EQ(answer["remedy"], Json::array({"delete_loop f1"})) << line;
    EXPECT_EQ(run_program({"edit", mesh, "--do", "delete_loop f1; " + line}).exit_code, 0) << line;
  }
  EXPECT_EQ(why(mesh, "extrude f1")["remedy"], Json::array({"delete_loop f0"}));
}

TEST(remedies, weld_is_told_once_and_of_two_points) {
  const TemporaryFolder folder;
  std::string grid;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) grid += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
  grid += "f 1 2 5 4\nf 2 3 6 5\nf 4 5 8 7\nf 5 6 9 8\n";
  const std::string mesh = folder.write("grid.obj", grid);
  const std::string beside = run_program({"why", mesh, "--do", "weld v4 v5"}).out;
  const std::size_t first = beside.find("divide that face");
  ASSERT_NE(first, std::string::npos) << beside;
  EXPECT_EQ(beside.find("divide that face", first + 1), std::string::npos) << beside;
  EXPECT_NE(beside.find("by collapse"), std::string::npos) << beside;
  const std::string across = run_program({"why", mesh, "--do", "weld v1 v7"}).out;
  EXPECT_NE(across.find("common_neighbour: The two points"), std::string::npos) << across;
}

}  // namespace
}  // namespace ryosen::test
