// Every command under the limits that a shell can set: it ends with a code of the contract and a true sentence, and by
// no signal. Of memory there are 100 MB and more; the long run goes through all limits.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>
#include <tuple>

#include "tests/support/app/contract.h"
#include "tests/support/app/process.h"
#include "tests/support/app/program.h"
#include "tests/support/app/table_lines.h"
#include "tests/support/core/long_run.h"

namespace ryosen::test {
namespace {

// Runs a line of this program under `ulimit LIMIT`, as somebody whom limits of processes concern where `as_nobody`.
ProgramRun run_limited(const std::string& limit, const Words& words, const TemporaryFolder& folder,
                       bool as_nobody = false, const std::string& program = RYOSEN_PROGRAM) {
  // What it prints goes through pipes, since a limit on the size of files concerns files alone.
  std::string line = "unset DISPLAY WAYLAND_DISPLAY; ulimit " + limit + "; ";
  line += as_nobody && geteuid() == 0 ? "exec setpriv --reuid=65534 --clear-groups " : "exec ";
  line += shell_word(program);
  for (const std::string& word : words) line += " " + shell_word(word);
  const std::string out = folder.at("out"), err = folder.at("err"), code = folder.at("code");
  const std::string script =
      folder.write("script", "cd " + folder.path().string() + "; { { (" + line + "); echo $? >&3; } 2>&4 | cat >" +
                                 out + "; } 3>" + code + " 4>&1 | cat >" + err);
  EXPECT_EQ(std::system(("bash " + script + " 2>/dev/null").c_str()), 0);
  return {std::atoi(read_file(code).c_str()), read_file(out), read_file(err)};
}

// The tables, and the pictures that need most.
std::vector<Words> lines_of_all(const std::string& mesh, const TemporaryFolder& made) {
  std::vector<Words> lines = lines_of_tables(mesh, made.path());
  for (Words& line : lines)
    if (line[0] != "shot" && line[0] != "view" && line.size() > 1) line.push_back("--json");
  for (const Words& further : {Words{"--panels", "--lang", "ja"}, {"--size", "3000x3000"}, {"--backend", "egl"}}) {
    lines.push_back({"shot", mesh, "-o", "o.png"});
    lines.back().insert(lines.back().end(), further.begin(), further.end());
  }
  return lines;
}

std::string shown(const Words& words) {
  std::string line;
  for (const std::string& word : words) line += " " + word;
  return line;
}

// What it ends with where nothing is limited: the window finds no display, and chance an operator that is refused.
int usual_code(const Words& words) {
  const TemporaryFolder folder;
  const int code = run_limited("-c 0", words, folder).exit_code;
  const bool is_usual = code <= 1 || code == (words[0] == "view" ? 7 : 6);
  EXPECT_TRUE(is_usual) << shown(words) << " ends with " << code << "; words for it belong into table_lines.cpp";
  return code;
}

// Any code that usual_code() lets pass.
constexpr int any_usual_code = -1;

// Ends as usual or with the code of what is lacking; returns which.
bool expect_good_end(const std::string& limit, const Words& words, int usual, int code_of_lack, bool as_nobody = false,
                     const std::string& program = RYOSEN_PROGRAM) {
  SCOPED_TRACE("ulimit " + limit + ":" + shown(words));
  const TemporaryFolder folder;
  if (as_nobody) std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  const ProgramRun run = run_limited(limit, words, folder, as_nobody, program);
  EXPECT_EQ(fault_of_run(words, run), "") << run.err;
  EXPECT_LT(run.exit_code, 70) << run.err;
  for (const char* const untrue : {"not installed", "インストールされていません", "Internal error"}) {
    EXPECT_EQ(run.err.find(untrue), std::string::npos) << run.err;
    EXPECT_EQ(run.out.find(untrue), std::string::npos) << run.out;
  }
  // doctor tells of what there is: under limits another code.
  const bool may_be_usual = run.exit_code <= 1 || run.exit_code == (words[0] == "view" ? 7 : 6);
  const bool is_usual = run.exit_code == usual || (words[0] == "doctor" && run.exit_code == 1) ||
                        (usual == any_usual_code && may_be_usual);
  EXPECT_TRUE(is_usual || run.exit_code == code_of_lack) << run.exit_code << run.err;
  const bool names_memory = run.err.find("emory") != std::string::npos || run.err.find("メモリ") != std::string::npos;
  EXPECT_TRUE(run.exit_code != 10 || names_memory) << run.err;
  const std::set<std::string> own{"out", "err", "code", "script"};
  for (const std::string& name : folder.names())
    EXPECT_TRUE(own.contains(name) || (name.starts_with("o.") && is_usual)) << name;
  return is_usual;
}

// From 100 MB of addresses, and from 50 MB of data, in steps up to where it ends as usual three times in a row.
int sweep_limits(const Words& words) {
  const int usual = usual_code(words);
  int runs = 0;
  for (const auto& [kind, least, step] : {std::tuple("-v ", 100'000, 50'000), std::tuple("-d ", 50'000, 25'000)}) {
    constexpr int enough = 3, most = 40;
    int in_a_row = 0;
    for (int i = 0; i < most && in_a_row < enough; ++i, ++runs)
      in_a_row = expect_good_end(kind + std::to_string(least + i * step), words, usual, 10) ? in_a_row + 1 : 0;
    EXPECT_EQ(in_a_row, enough) << shown(words) << " wants more than any machine has";
  }
  return runs;
}

TEST(little_memory, ends_no_command_badly) {
  const TemporaryFolder made;
  const std::string cube = asset("cube.obj"), bunny = asset("stanford_bunny.obj");
  if (!is_long_run()) {
    const std::vector<Words> lines = lines_of_all(cube, made);
    for (std::size_t i = 0; i < lines.size(); i += 2) expect_good_end("-v 100000", lines[i], any_usual_code, 10);
    for (const char* const limit : {"-v 200000", "-v 400000", "-d 50000"})
      expect_good_end(limit, {"shot", bunny, "-o", "o.png"}, 0, 10);
    expect_good_end("-v 300000", {"doctor", "--json"}, 0, 10);
    return;
  }
  int runs = 0;
  for (const std::string& mesh : {cube, bunny})
    for (const Words& words : lines_of_all(mesh, made)) runs += sweep_limits(words);
  std::printf("%d runs\n", runs);
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

// A control group within that of this process, with a limit of memory; of no path where none can be made.
class MemoryGroup {
 public:
  explicit MemoryGroup(std::uint64_t bytes) {
    std::ifstream list("/proc/self/cgroup");
    for (std::string line; std::getline(list, line) && path_.empty();) {
      const bool is_first = line.find(":memory:") != std::string::npos;
      if (!is_first && !line.starts_with("0::")) continue;
      const std::string root = is_first ? "/sys/fs/cgroup/memory" : "/sys/fs/cgroup";
      const std::string path = root + line.substr(line.rfind(':') + 1) + "/ryosen-test-" + std::to_string(getpid());
      if (mkdir(path.c_str(), 0755) != 0) continue;
      path_ = path;
      std::ofstream(path_ + (is_first ? "/memory.limit_in_bytes" : "/memory.max")) << bytes << std::flush;
      if (!std::filesystem::exists(path_ + (is_first ? "/memory.limit_in_bytes" : "/memory.max"))) remove();
    }
  }
  MemoryGroup(const MemoryGroup&) = delete;
  MemoryGroup& operator=(const MemoryGroup&) = delete;
  ~MemoryGroup() { remove(); }

  const std::string& path() const { return path_; }

 private:
  void remove() {
    if (!path_.empty()) rmdir(path_.c_str());
    path_.clear();
  }

  std::string path_;
};

TEST(little_memory, of_a_real_control_group_is_said) {
  if (!is_long_run()) GTEST_SKIP() << "makes a control group, in long runs alone";
  const MemoryGroup group(std::uint64_t{60} << 20);
  if (group.path().empty()) GTEST_SKIP() << "no control group can be made here";
  const TemporaryFolder folder;
  const auto run = [&](const std::string& words) {
    const std::string line = "echo $$ >" + group.path() + "/cgroup.procs && exec " + shell_program() + " --lang en " +
                             words + " 2>" + folder.at("err");
    Process process({"sh", "-c", line}, {}, folder.at("out"));
    return process.wait();
  };
  EXPECT_EQ(run("shot " + shell_word(asset("cube.obj")) + " -o " + folder.at("o.png")), 10);
  EXPECT_NE(read_file(folder.at("err")).find("the control group (cgroup) leaves "), std::string::npos);
  EXPECT_FALSE(folder.has("o.png"));
  EXPECT_EQ(run("check " + shell_word(asset("cube.obj"))), 0) << read_file(folder.at("err"));
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
    return run.err.substr(0, run.err.find(" more memory"));  // not what is left, which differs from run to run
  };
  EXPECT_EQ(need({"--shading", "flat"}), need({}));
  EXPECT_NE(need({"--shading", "smooth"}), need({}));
  EXPECT_EQ(need({"--script", script}), need({"--shading", "smooth"}));
}

// A few in the suite.
std::string mesh_for_other_limits() { return asset(is_long_run() ? "stanford_bunny.obj" : "cube.obj"); }
std::vector<Words> lines_for_other_limits(const std::string& mesh, const TemporaryFolder& made) {
  if (is_long_run()) return lines_of_all(mesh, made);
  return {{"check", mesh, "--self-intersections", "--json"},
          {"shot", mesh, "-o", "o.png"},
          {"convert", mesh, "-o", "o.ply"}};
}

TEST(little_memory, without_threads_one_does_it_all) {
  // The other user may not enter the home in which the clone may lie.
  const TemporaryFolder made;
  const std::string mesh = made.copy(mesh_for_other_limits(), "mesh.obj"),
                    program = made.copy(RYOSEN_PROGRAM, "ryosen");
  for (const std::string& path : {made.path().string(), mesh, program})
    std::filesystem::permissions(path, std::filesystem::perms::all);
  for (const Words& words : lines_for_other_limits(mesh, made)) {
    const int usual = usual_code(words);
    expect_good_end("-u 1", words, usual, usual, true, program);
  }
}

TEST(little_memory, few_descriptors_and_small_files_are_said_truly) {
  const TemporaryFolder made;
  for (const Words& words : lines_for_other_limits(mesh_for_other_limits(), made)) {
    const int usual = usual_code(words);
    expect_good_end("-n 8", words, usual, 7);
    expect_good_end("-f 1", words, usual, 5);
  }
}

}  // namespace
}  // namespace ryosen::test
