// Each allocation of reading, checking, repairing, editing and saving small files fails in turn, once and together with
// all that follow: nothing crashes or leaks, nothing but the lack of memory is said, what was there stays as it was.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <thread>

#include "app/cli/run.h"
#include "app/cli/sudden_end.h"
#include "app/editor/commands/commands.h"
#include "app/editor/document/preparation.h"
#include "app/editor/document/repair_trials.h"
#include "app/editor/recovery/autosave.h"
#include "app/editor/session/session.h"
#include "ryosen/mesh/invariants.h"
#include "tests/faults/failing_memory.h"
#include "tests/support/core/long_run.h"

namespace ryosen::test {
namespace {

namespace fs = std::filesystem;

class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "ryosen-faults-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path_); }
  std::string at(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string source(const std::string& path) { return std::string(RYOSEN_SOURCE_DIR) + "/" + path; }

enum class Keeps { nothing, history };

// Calls work() with each allocation failing, all of them in a long run and else some `trials` of them, and after() with
// what became of it: whether it was thrown through.
template <class Work, class After>
void at_each_allocation(long trials, Keeps keeps, const Work& work, const After& after) {
  const auto run = [&] {
    work();
    after(false);
  };
  run();
  run();  // by now all that is made once is there
  const long before = living_blocks();
  static std::mt19937 random(std::random_device{}());
  for (const Failing failing : {Failing::once, Failing::from_then_on}) {
    fail_allocation(0, Failing::once);
    work();
    const long all = counted_allocations(), step = is_long_run() ? 1 : std::max(1l, all / trials);
    after(false);
    for (long nth = 1 + static_cast<long>(random() % static_cast<unsigned long>(step));; nth += step) {
      SCOPED_TRACE("allocation " + std::to_string(nth) + (failing == Failing::once ? "" : " and all behind it"));
      bool is_thrown = false;
      fail_allocation(nth, failing);
      try {
        work();
      } catch (const std::bad_alloc&) {
        is_thrown = true;
      }
      const bool has_failed = fail_no_more();
      after(is_thrown);
      if (!has_failed || testing::Test::HasFailure()) break;
    }
  }
  run();
  if (keeps == Keeps::nothing) {
    EXPECT_LE(living_blocks(), before) << "something was not released";
  }
}

TEST(allocation_faults, of_reading) {
  for (const char* const name :
       {"assets/cube.obj", "assets/klein_bottle.off", "assets/three_tri_edge.off", "tests/data/io/everything.obj",
        "tests/data/io/everything.ply", "tests/data/io/everything_big.ply", "tests/data/io/two_solids.stl",
        "tests/data/io/attributes.stl", "tests/data/io/triangles.txt", "tests/data/io/colours.off"}) {
    SCOPED_TRACE(name);
    const fs::path path = source(name);
    const std::size_t faces = read_mesh_file(path)->mesh.face_count();
    at_each_allocation(
        150, Keeps::nothing,
        [&] {
          const Result<MeshFile> file = read_mesh_file(path);
          const bool is_right = file.ok() && file->mesh.face_count() == faces;
          if (!is_right) fail_no_more();
          ASSERT_TRUE(is_right) << (file ? "" : file.failure().message.text.en);
        },
        [](bool) {});
  }
}

// Runs the program in a process of its own, with that allocation failing; 128 + signal where one ended it.
int run_apart(const std::vector<std::string>& line, long nth, Failing failing) {
  const pid_t child = fork();
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    cli::answer_lack_of_memory();
    fail_allocation(nth, failing);
    _exit(static_cast<int>(cli::run(line)));
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

long allocations_of(const std::vector<std::string>& line) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  fail_allocation(0, Failing::once);
  cli::run(line);
  const long all = counted_allocations();
  testing::internal::GetCapturedStdout();
  testing::internal::GetCapturedStderr();
  return all;
}

class Outputs {
 public:
  // What is in the folder by now.
  explicit Outputs(const Folder& folder) : folder_(folder) {
    for (const auto& entry : fs::directory_iterator(folder_.at("")))
      whole_.emplace(entry.path().filename().string(), content_of(entry.path().string()));
  }
  // Expects each file to be as it was, if it is there, and removes it.
  void expect_whole_or_absent() const {
    for (const auto& [name, content] : Outputs(folder_).whole_) {
      EXPECT_TRUE(whole_.contains(name) && whole_.at(name) == content) << name << " is torn or left over";
      fs::remove(folder_.at(name));
    }
  }

 private:
  const Folder& folder_;
  std::map<std::string, std::string> whole_;
};

void fail_command_line(const std::vector<std::string>& line, const Folder& folder) {
  SCOPED_TRACE(line[0]);
  const int usual = run_apart(line, 0, Failing::once);
  const Outputs outputs(folder);
  const long all = allocations_of(line);
  outputs.expect_whole_or_absent();
  static std::mt19937 random(std::random_device{}());
  const long trials = is_long_run() ? 1500 : 12;  // each is a process of its own
  const long step = std::max(1l, all / trials);
  if (is_long_run()) std::printf("%s: %ld allocations, every %ld. fails\n", line[0].c_str(), all, step);
  for (const Failing failing : {Failing::once, Failing::from_then_on})
    for (long nth = 1 + static_cast<long>(random() % static_cast<unsigned long>(step)); nth <= all; nth += step) {
      const int code = run_apart(line, nth, failing);
      EXPECT_TRUE(code == usual || code == 10 || (code == 9 && line[0] == "check"))
          << code << " at allocation " << nth << (failing == Failing::once ? "" : " and all behind it");
      outputs.expect_whole_or_absent();
      if (testing::Test::HasFailure()) return;
    }
}

TEST(allocation_faults, of_commands) {
  const std::string cube = source("assets/cube.obj"), fin = source("assets/fin.obj"),
                    klein = source("assets/klein_bottle.off"), rest = source("tests/data/io/everything.obj");
  const Folder folder;
  const std::vector<std::vector<std::string>> lines{
      {"check", cube, "--self-intersections", "--json"},
      {"check", cube, fin, rest},
      {"check", source("tests/data/malformed/cut.txt"), "--json"},
      {"why", cube, "--op", "swap", "--all"},
      {"edit", fin, "--do", "split 0-2; undo; save " + folder.at("s.ply"), "-o", folder.at("o.obj"), "--json"},
      {"convert", rest, "-o", folder.at("o.ply.gz"), "--json"},
      {"repair", fin, "-o", folder.at("o.obj"), "--json"},
      {"fill_holes", klein, "-o", folder.at("o.off")},
      {"help", "json"},
  };
  for (const std::vector<std::string>& line : lines) fail_command_line(line, folder);
  if (is_long_run()) fail_command_line({"forms", fin, "--json"}, folder);
}

// What a session shows besides the mesh, so that edits keep it up.
void look_at_all(Session& session) {
  session.findings().picker();
  session.findings().corner_normals();
  session.findings().boundary_loops();
  session.findings().euler_terms();
  session.findings().kind();
}

void expect_as_new(Session& session) {
  const HighlightSets fresh(session.mesh(), 0, {});
  for (const ProblemRow& row : problem_table()) {
    if (row.kind == ProblemKind::self_intersection) continue;
    EXPECT_EQ(session.findings().highlights().of(row.kind).size(), fresh.of(row.kind).size()) << row.id;
  }
}

// Runs the line on this session again and again; where it succeeds, it is undone.
void fail_command(Session& session, const std::string& line, const std::string& back) {
  SCOPED_TRACE(line);
  look_at_all(session);
  const std::uint64_t before = session.mesh().hash();
  const std::size_t position = session.document().position();
  std::uint64_t done = 0;
  Outcome outcome;
  std::size_t entries = 0, logged = 0;
  at_each_allocation(
      150, Keeps::history,
      [&] {
        entries = session.document().history().size();
        logged = session.log().size();
        outcome = {};
        outcome = session.run(line);
      },
      [&](bool is_thrown) {
        const auto broken = check_invariants(session.mesh());
        EXPECT_FALSE(broken) << broken->sentence;
        if (!is_thrown && outcome.done()) {
          if (done == 0) done = session.mesh().hash();
          EXPECT_EQ(session.mesh().hash(), done);
          EXPECT_EQ(session.log().size(), logged + 1);
          EXPECT_TRUE(session.run(back).done());
        } else {
          EXPECT_TRUE(is_thrown || outcome.exit_code == ExitCode::out_of_memory) << outcome.sentence.en;
          EXPECT_EQ(session.document().history().size(), entries);
          EXPECT_EQ(session.log().size(), logged);
        }
        EXPECT_EQ(session.mesh().hash(), before);
        EXPECT_EQ(session.document().position(), position);
        expect_as_new(session);
        look_at_all(session);
      });
}

TEST(allocation_faults, of_edits_leave_the_document_as_it_was) {
  auto document = Document::open(source("assets/fin.obj"));
  ASSERT_TRUE(document.ok());
  Session session(std::move(document).value());
  for (const char* const line : {"split 0-2", "repair detach_nonmanifold", "poke f0"})
    if (session.run(line).done()) {
      session.run("undo");
      fail_command(session, line, "undo");
    } else {
      ADD_FAILURE() << line;
    }
  ASSERT_TRUE(session.run("repair detach_nonmanifold").done());
  fail_command(session, "undo", "redo");
  ASSERT_TRUE(session.run("undo").done());
  fail_command(session, "redo", "undo");
}

TEST(allocation_faults, of_attributes_leave_them_as_they_were) {
  auto document = Document::open(source("assets/fin.obj"));
  ASSERT_TRUE(document.ok());
  Session session(std::move(document).value());
  for (const char* const line :
       {"attribute add vertex.load doublex3 blend 1 2 3", "attribute add edge.crease float sum",
        "attribute set vertex.load 4 5 6 v0..v3", "attribute set edge.crease 2 e0..e4", "split 0-2",
        "attribute remove vertex.load", "attribute add vertex.load bool"}) {
    SCOPED_TRACE(line);
    const MeshColumns before = session.mesh().columns();
    fail_command(session, line, "undo");
    EXPECT_EQ(session.mesh().attributes().size(), before.attributes.size());
    EXPECT_TRUE(session.mesh().columns() == before);
    ASSERT_TRUE(session.run(line).done());
  }
}

// Wherever it runs out on a way through several entries, the document is back where it was, and the way is still there.
TEST(allocation_faults, of_long_ways_through_the_history_lead_back) {
  auto document = Document::open(source("assets/fin.obj"));
  ASSERT_TRUE(document.ok());
  Session session(std::move(document).value());
  for (const char* const line : {"split 0-2", "repair detach_nonmanifold", "poke f0", "poke f1"})
    ASSERT_TRUE(session.run(line).done()) << line;
  fail_command(session, "undo 4", "redo 4");
  ASSERT_TRUE(session.run("undo 4").done());
  fail_command(session, "redo 4", "undo 4");
  ASSERT_TRUE(session.run("redo 2").done());
  fail_command(session, "undo 2", "redo 2");
  fail_command(session, "redo 2", "undo 2");
}

// A name that is unknown here is looked for at the other ends of the history.
TEST(allocation_faults, of_a_search_through_the_history_lead_back) {
  auto document = Document::open(source("assets/fin.obj"));
  ASSERT_TRUE(document.ok());
  Session session(std::move(document).value());
  for (const char* const line : {"poke f0", "split 0-2", "repair detach_nonmanifold", "poke f1"})
    ASSERT_TRUE(session.run(line).done()) << line;
  const std::string last = "poke f" + std::to_string(session.mesh().face_slots() - 1);
  ASSERT_TRUE(session.run("undo 2").done());
  const std::uint64_t before = session.mesh().hash();
  for (const std::string& line : {last, std::string("poke f99")}) {
    SCOPED_TRACE(line);
    ASSERT_FALSE(session.run(line).done());
    at_each_allocation(
        150, Keeps::history, [&] { EXPECT_FALSE(session.run(line).done()); },
        [&](bool) {
          EXPECT_EQ(session.mesh().hash(), before);
          EXPECT_EQ(session.document().position(), 2u);
          EXPECT_EQ(session.document().history().size(), 4u);
        });
  }
}

// The mesh beside is the new one, or the one that was there.
TEST(allocation_faults, of_a_comparison_leave_the_mesh_beside_as_it_was) {
  const std::string cube = source("assets/cube.obj"), klein = source("assets/klein_bottle.off");
  auto document = Document::open(source("assets/fin.obj"));
  ASSERT_TRUE(document.ok());
  Session session(std::move(document).value());
  const std::uint64_t own = session.mesh().hash(), of_cube = Document::open(cube).value()->mesh().hash();
  for (const std::string& first : {std::string("compare off"), "compare " + klein}) {
    SCOPED_TRACE(first);
    ASSERT_TRUE(session.run(first).done());
    const auto beside = [&] { return session.is_comparing() ? session.compared()->document().mesh().hash() : 0; };
    const std::uint64_t before = beside();
    Outcome outcome;
    at_each_allocation(
        150, Keeps::history,
        [&] {
          outcome = {};
          outcome = session.run("compare " + cube);
        },
        [&](bool is_thrown) {
          const bool is_done = !is_thrown && outcome.done();
          EXPECT_TRUE(is_thrown || is_done || outcome.exit_code == ExitCode::out_of_memory) << outcome.sentence.en;
          EXPECT_EQ(session.mesh().hash(), own);
          EXPECT_EQ(beside(), is_done ? of_cube : before);
          if (is_done) {
            EXPECT_TRUE(session.run(first).done());
          }
          EXPECT_EQ(beside(), before);
          for (const double x : {5.0, session.view.origin.x + session.view.size.width + 20.0})
            session.pointing.point_at({x, 40});  // no view that is gone is asked
        });
  }
}

// A repair that is tried, at once and on a thread of its own, tells what it would do or that there is no memory.
TEST(allocation_faults, of_a_tried_repair_are_told) {
  const auto document = Document::open(source("assets/fin.obj"));
  ASSERT_TRUE(document.ok());
  const std::uint64_t before = (*document)->mesh().hash();
  for (const bool in_background : {false, true}) {
    SCOPED_TRACE(in_background);
    RepairTrials trials;
    trials.in_background = in_background;
    const RepairReport* report = nullptr;
    at_each_allocation(
        150, Keeps::history,
        [&] {
          report = nullptr;
          trials.forget();
          report = tried(**document, trials, "repair detach_nonmanifold");
          while (!report && trials.share()) {
            trials.follow(**document);
            report = tried(**document, trials, "repair detach_nonmanifold");
          }
        },
        [&](bool is_thrown) {
          EXPECT_TRUE(is_thrown || report);
          EXPECT_EQ((*document)->mesh().hash(), before);
        });
  }
}

// What cannot be prepared is told to whoever takes it. Without a thread it is done on this one, which keeps what
// threads have of their own.
TEST(allocation_faults, of_preparing_are_told) {
  auto document = Document::open(source("assets/fin.obj"));
  ASSERT_TRUE(document.ok());
  const Mesh& mesh = (*document)->mesh();
  const std::size_t edges = HighlightSets(mesh, 0, {}).of(ProblemKind::nonmanifold_edge).size();
  at_each_allocation(
      150, Keeps::history,
      [&] {
        Picker picker(mesh);
        Preparation preparation(mesh, picker, {});
        while (!preparation.is_done()) std::this_thread::yield();
        EXPECT_EQ(preparation.take().highlights.of(ProblemKind::nonmanifold_edge).size(), edges);
      },
      [](bool) {});
}

// An edit stands where there is no memory to record it, and ends are no errors.
TEST(allocation_faults, of_recording_leave_the_edit) {
  const Folder folder;
  auto document = Document::open(source("assets/fin.obj"));
  ASSERT_TRUE(document.ok());
  Session session(std::move(document).value());
  Autosave autosave(folder.at("recovery"));
  session.frontend.autosave = &autosave;
  autosave.begin(session.document());
  fail_command(session, "poke f0", "undo");
  at_each_allocation(
      150, Keeps::history, [&] { autosave.finish(); },
      [&](bool is_thrown) {
        EXPECT_FALSE(is_thrown);
        autosave.finish();
        autosave.begin(session.document());
        EXPECT_TRUE(session.run("poke f0").done());
        EXPECT_TRUE(session.run("undo").done());
      });
  session.frontend.autosave = nullptr;
}

}  // namespace
}  // namespace ryosen::test
