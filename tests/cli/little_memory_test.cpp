// Every command under the limits that a shell can set: it ends with a code of the contract and a true sentence, and by no
// signal. Of memory there are 100 MB and more; the long run goes through all limits.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <set>

#include "tests/support/app/algorithm_call.h"
#include "tests/support/app/contract.h"
#include "tests/support/core/long_run.h"

namespace ryosen::test {
namespace {

// Runs a line under `ulimit LIMIT`, as somebody whom limits of processes concern where `as_nobody`.
ProgramRun run_limited(const std::string& limit, const std::vector<std::string>& words, const TemporaryFolder& folder,
                       bool as_nobody = false) {
  // What it prints goes through pipes, since a limit on the size of files concerns files alone.
  std::string line = "ulimit " + limit + "; ";
  line += as_nobody && geteuid() == 0 ? "exec setpriv --reuid=65534 --clear-groups " : "exec ";
  line += RYOSEN_PROGRAM;
  for (const std::string& word : words) line += " '" + word + "'";
  const std::string out = folder.at("out"), err = folder.at("err"), code = folder.at("code");
  const std::string script =
      folder.write("script", "cd " + folder.path().string() + "; { { (" + line + "); echo $? >&3; } 2>&4 | cat >" +
                                 out + "; } 3>" + code + " 4>&1 | cat >" + err);
  EXPECT_EQ(std::system(("bash " + script + " 2>/dev/null").c_str()), 0);
  return {std::atoi(read_file(code).c_str()), read_file(out), read_file(err)};
}

std::vector<std::vector<std::string>> lines_of_all(const std::string& mesh) {
  std::vector<std::vector<std::string>> lines{
      {"check", mesh, "--self-intersections"},
      {"why", mesh, "--op", "swap", "--all"},
      {"edit", mesh, "--do", "poke f0", "-o", "o.obj"},
      {"repair", mesh, "-o", "o.obj"},
      {"convert", mesh, "-o", "o.ply"},
      {"shot", mesh, "-o", "o.png"},
      {"shot", mesh, "-o", "o.png", "--panels", "--lang", "ja"},
      {"shot", mesh, "-o", "o.png", "--size", "3000x3000"},
      {"shot", mesh, "-o", "o.png", "--backend", "egl"},
      {"forms", mesh},
      {"formats"},
      {"keys"},
      {"doctor"},
      {"help", "json"},
      {"--version"},
  };
  for (const AlgorithmRow& row : algorithm_table()) lines.push_back(words_for(row, mesh));
  for (std::vector<std::string>& line : lines)
    if (line[0] != "shot" && line.size() > 1) line.push_back("--json");
  return lines;
}

void expect_good_end(const std::string& limit, const std::vector<std::string>& words, int code_of_lack,
                     bool as_nobody = false) {
  std::string shown = "ulimit " + limit + ":";
  for (const std::string& word : words) shown += " " + word;
  SCOPED_TRACE(shown);
  const TemporaryFolder folder;
  if (as_nobody) std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  const ProgramRun run = run_limited(limit, words, folder, as_nobody);
  EXPECT_EQ(fault_of_run(words, run), "") << run.err;
  EXPECT_LT(run.exit_code, 70) << run.err;
  for (const char* const untrue : {"not installed", "インストールされていません", "Internal error"}) {
    EXPECT_EQ(run.err.find(untrue), std::string::npos) << run.err;
    EXPECT_EQ(run.out.find(untrue), std::string::npos) << run.out;
  }
  const bool is_done = run.exit_code <= 1;
  EXPECT_TRUE(is_done || run.exit_code == code_of_lack) << run.exit_code << run.err;
  const bool names_memory = run.err.find("emory") != std::string::npos || run.err.find("メモリ") != std::string::npos;
  EXPECT_TRUE(run.exit_code != 10 || names_memory) << run.err;
  const std::set<std::string> own{"out", "err", "code", "script"};
  for (const std::string& name : folder.names())
    EXPECT_TRUE(own.contains(name) || (name.starts_with("o.") && is_done)) << name;
}

TEST(little_memory, ends_no_command_badly) {
  const std::string cube = asset("cube.obj"), bunny = asset("stanford_bunny.obj");
  if (!is_long_run()) {
    for (const std::vector<std::string>& words : lines_of_all(cube)) expect_good_end("-v 100000", words, 10);
    for (const char* const limit : {"-v 200000", "-v 300000", "-v 400000", "-d 50000", "-d 80000"})
      expect_good_end(limit, {"shot", bunny, "-o", "o.png"}, 10);
    expect_good_end("-v 300000", {"doctor", "--json"}, 10);
    return;
  }
  for (int limit = 100'000; limit <= 1'000'000; limit += 50'000)
    for (const std::string& mesh : {cube, bunny})
      for (const std::vector<std::string>& words : lines_of_all(mesh)) {
        expect_good_end("-v " + std::to_string(limit), words, 10);
        expect_good_end("-d " + std::to_string(limit / 2), words, 10);
      }
}

TEST(little_memory, a_picture_says_what_it_needs) {
  const TemporaryFolder folder;
  const ProgramRun run = run_limited("-v 200000", {"shot", asset("cube.obj"), "-o", "o.png"}, folder);
  EXPECT_EQ(run.exit_code, 10);
  EXPECT_NE(run.err.find("This picture needs about "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("ulimit -v leaves "), std::string::npos) << run.err;
  const ProgramRun enough = run_limited("-v 400000", {"shot", asset("cube.obj"), "-o", "o.png"}, folder);
  EXPECT_EQ(enough.exit_code, 0) << enough.err;
  EXPECT_TRUE(folder.has("o.png"));
  const ProgramRun large =
      run_limited("-v 400000", {"shot", asset("cube.obj"), "-o", "p.png", "--size", "16384x8192"}, folder);
  EXPECT_EQ(large.exit_code, 10);
  EXPECT_TRUE(large.err.starts_with("This picture needs about 2.")) << large.err;
  EXPECT_FALSE(folder.has("p.png"));
}

TEST(little_memory, a_picture_counts_what_its_switches_take) {
  const TemporaryFolder folder;
  const std::string script = folder.write("smooth.script", "shading smooth\n");
  const auto need = [&](std::vector<std::string> flags) {
    std::vector<std::string> words{"shot", asset("stanford_bunny.obj"), "-o", "o.png"};
    words.insert(words.end(), flags.begin(), flags.end());
    const ProgramRun run = run_limited("-v 200000", words, folder);
    EXPECT_EQ(run.exit_code, 10);
    EXPECT_NE(run.err.find("This picture needs about "), std::string::npos) << run.err;
    return run.err.substr(0, run.err.find(';'));
  };
  EXPECT_EQ(need({"--shading", "flat"}), need({}));
  EXPECT_NE(need({"--shading", "smooth"}), need({}));
  EXPECT_EQ(need({"--script", script}), need({"--shading", "smooth"}));
}

// A few in the suite.
std::vector<std::vector<std::string>> lines_for_other_limits() {
  const std::string mesh = asset(is_long_run() ? "stanford_bunny.obj" : "cube.obj");
  if (is_long_run()) return lines_of_all(mesh);
  return {{"check", mesh, "--self-intersections", "--json"},
          {"shot", mesh, "-o", "o.png"},
          {"convert", mesh, "-o", "o.ply"}};
}

TEST(little_memory, without_threads_one_does_it_all) {
  for (const std::vector<std::string>& words : lines_for_other_limits()) expect_good_end("-u 1", words, 0, true);
}

TEST(little_memory, few_descriptors_and_small_files_are_said_truly) {
  for (const std::vector<std::string>& words : lines_for_other_limits()) {
    expect_good_end("-n 8", words, 7);
    expect_good_end("-f 1", words, 5);
  }
}

}  // namespace
}  // namespace ryosen::test
