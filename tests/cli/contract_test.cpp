// `ryosen help json` and what the program prints: each holds the other. run_program holds every line of every test
// against it; here all that it lists is printed at least once.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "tests/support/app/contract.h"

namespace {

using namespace ryosen::test;

// Runs the program with --json and notes what it shows.
class Sweep {
 public:
  SeenOfContract seen;

  void run(std::vector<std::string> arguments) {
    arguments.push_back("--json");
    const ProgramRun run = run_unchecked(arguments, folder_.path());
    EXPECT_EQ(fault_of_run(arguments, run, &seen), "");
  }
  // A mesh with that text, checked.
  void check(const std::string& name, const std::string& text) { run({"check", folder_.write(name, text)}); }
  void edit(const std::string& file, const std::string& commands) { run({"edit", file, "--do", commands}); }

  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

std::vector<std::string> files_below(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(RYOSEN_SOURCE_DIR) + "/tests/data/" + folder))
    files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

void sweep_command_lines(Sweep& sweep) {
  const std::string mesh = asset("tetrahedron.off"), three = asset("three_tri_edge.off");
  const std::vector<std::vector<std::string>> lines{
      {"check", mesh, "--jobs", "0"},
      {"check", mesh, "--jobs", "1", "--jobs", "2"},
      {"check", mesh, "--unordered=1"},
      {"check"},
      {"check", mesh, "--bogus"},
      {"keys", "x"},
      {"nonsense"},
      {"convert", mesh},
      {"why", mesh, "--op", "collapse", "--edge", "0-99"},
      {"why", mesh, "--op", "nonsense", "--all"},
      {"why", mesh, "--do", "collapse 0-1; swap 0-1"},
      {"why", mesh, "--op", "collapse", "--all"},
      {"why", mesh, "--op", "--all"},
      {"why", three, "--op", "collapse", "--edge", "0-1"},
      {"edit", mesh, "--do", "undo many"},
      {"shot", mesh},
      {"shot", mesh, "-o", mesh},
      {"shot", mesh, "-o", "p.png", "--diff", "d.png"},
      {"shot", mesh, "-o", "p.png", "--view", "front", "--camera", "{}"},
      {"shot", mesh, "-o", "p.png", "--show", "nonsense"},
      {"shot", mesh, "-o", "p.png", "--tool", "nonsense"},
      {"view"},
      {"formats"},
      {"keys"},
      {"doctor"},
      {"help"},
      {"help", "json"},
      {"--version"},
      {"forms", mesh},
      {"check", asset("stanford_bunny.obj"), "--self-intersections"},
  };
  for (const std::vector<std::string>& line : lines) sweep.run(line);
  sweep.run({"check", "value", "is", "missing", "--jobs"});
}

void sweep_inputs_and_outputs(Sweep& sweep) {
  const TemporaryFolder& folder = sweep.folder();
  const std::string mesh = folder.copy(asset("tetrahedron.off"), "mesh.off");
  std::filesystem::create_directories(folder.path() / "folder.obj");
  std::filesystem::create_symlink("circle.obj", folder.path() / "circle.obj");
  for (const char* const input : {"nosuch.obj", "circle.obj", "folder.obj", "/dev/null"}) sweep.run({"check", input});
  sweep.run({"why", "folder.obj", "--op", "swap", "--all"});
  for (const char* const output : {"mesh.off", "folder.obj", "nosuch/o.obj", "o.nonsense"})
    sweep.run({"convert", mesh, "-o", output});
}

void sweep_runs(Sweep& sweep) {
  const std::string mesh = asset("tetrahedron.off");
  sweep.edit(mesh, "expect V 9");
  sweep.run({"edit", mesh, "--do", "collapse 0-1; split 0-1", "--on-refuse", "skip", "-o", "o.off"});
  sweep.edit(mesh, "collapse 0-1");
  sweep.edit(mesh, "split 0-1; poke f0; delete f1; undo");
  sweep.run({"repair", mesh, "-o", "o.off"});
  sweep.run({"shot", mesh, "-o", "small.png", "--size", "16x16"});
  sweep.run({"shot", mesh, "--compare", "small.png", "--size", "16x16", "--view", "front"});
  sweep.run({"shot", mesh, "--compare", "small.png", "--size", "16x8"});
  sweep.folder().write("bad.png", "no picture");
  sweep.run({"shot", mesh, "--compare", "bad.png", "--size", "16x16"});
}

void sweep_losses(Sweep& sweep) {
  for (const std::string& file : files_below("io"))
    for (const char* const format : {"obj", "ply-ascii", "off", "stl-binary", "txt"})
      sweep.run({"convert", file, "-o", "converted", "--format", format});
}

void sweep_contents(Sweep& sweep) {
  std::vector<std::string> files = files_below("malformed");
  files.insert(files.begin(), "check");
  sweep.run(files);
}

// What no test can bring about, and why.
const std::map<std::string, std::string> out_of_reach{
    {"codes.internal_error", "the program itself would have to be wrong"},
};

TEST(contract, all_that_it_lists_is_printed) {
  Sweep sweep;
  sweep_command_lines(sweep);
  sweep_inputs_and_outputs(sweep);
  sweep_runs(sweep);
  sweep_losses(sweep);
  sweep_contents(sweep);
  const SeenOfContract all = all_of_contract();
  for (const std::string& key : all.keys) EXPECT_TRUE(sweep.seen.keys.contains(key)) << key;
  for (const std::string& id : all.ids) {
    if (!id.starts_with("codes.")) continue;
    EXPECT_NE(sweep.seen.ids.contains(id), out_of_reach.contains(id)) << id;
  }
}

}  // namespace
