// Each system call of a save made to fail in turn: the old file stays whole, nothing else is left, and a sentence says
// what happened; whatever the call, exit code and words tell what became of the file.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

TEST(failing_saves, a_limit_of_the_shell_is_said_too) {
  const test::TemporaryFolder folder;
  const std::string old = test::read_file(test::asset("cube.obj")), out = folder.write("out.obj", old);
  const std::string command = "ulimit -f 100; " + test::shell_program() + " convert " +
                              test::shell_word(test::asset("stanford_bunny.obj")) + " -o " + out + " --lang en 2>" +
                              folder.at("err") + " >" + folder.at("out");
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status)) << "a signal ended it";
  EXPECT_EQ(WEXITSTATUS(status), 5);
  EXPECT_NE(test::read_file(folder.at("err")).find("files may not become that large"), std::string::npos);
  EXPECT_EQ(test::read_file(out), old);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"err", "out", "out.obj"}));
}

#ifdef RYOSEN_FAILING_CALLS  // not under sanitizers

// The name and the path of a call, as failing_calls.cpp logs it.
struct Call {
  std::string name, path;
};

// A folder with one old file, which something in another process is to replace.
class Target {
 public:
  Target() { reset(); }

  std::string path() const { return folder_.at("out.off"); }
  std::string folder() const { return folder_.path(); }
  std::string input() const { return input_; }
  std::string content() const { return test::read_file(path()); }
  const std::string& old_content() const { return old_; }
  bool is_alone() const { return folder_.names() == std::vector<std::string>{"out.off"}; }
  unsigned permissions() const { return static_cast<unsigned>(std::filesystem::status(path()).permissions()); }

  void reset() const {
    std::filesystem::remove(path());
    folder_.write("out.off", old_);
    std::filesystem::permissions(path(), static_cast<std::filesystem::perms>(0604));
    std::filesystem::remove(others_.at("log"));
  }
  // Lets the nth call of another process fail that concerns the folder; none at 0.
  std::vector<std::string> environment(std::size_t nth, const std::string& with) const {
    return {"LD_PRELOAD=" + library_, "RYOSEN_FAIL_FOLDER=" + folder(), "RYOSEN_FAIL_AT=" + std::to_string(nth),
            "RYOSEN_FAIL_WITH=" + with, "RYOSEN_FAIL_LOG=" + others_.at("log")};
  }
  // What the other process called.
  std::vector<Call> calls() const {
    std::vector<Call> calls;
    std::istringstream log(test::read_file(others_.at("log")));
    for (Call call; log >> call.name >> call.path;) calls.push_back(call);
    return calls;
  }

 private:
  std::string old_ = test::read_file(test::asset("tetrahedron.off"));
  test::TemporaryFolder folder_, others_;
  std::string input_ = others_.copy(test::asset("cube.obj"), "in.obj");
  std::string library_ = others_.copy(RYOSEN_FAILING_CALLS, "failing_calls.so");  // of a path without blanks
};

// What a save comes to when this call fails in this way.
enum class Fate { succeeds, old_stays, new_in_place };

Fate fate(const Call& call, const std::string& folder, int error, bool after_rename) {
  if (error == EINTR) return Fate::succeeds;
  const bool cannot_sync = call.name == "fsync" && (error == EINVAL || error == ENOTSUP);
  if (cannot_sync || (call.name == "open" && call.path == folder && error == EACCES)) return Fate::succeeds;
  if (!after_rename) return Fate::old_stays;
  return call.name == "fsync" ? Fate::new_in_place : Fate::succeeds;
}

void expect_fate(const Target& target, const test::ProgramRun& run, Fate expected, const std::string& whole_new,
                 bool is_japanese) {
  EXPECT_TRUE(target.is_alone()) << "a temporary file is left";
  EXPECT_EQ(target.content(), expected == Fate::old_stays ? target.old_content() : whole_new);
  EXPECT_EQ(target.permissions(), 0604u);
  EXPECT_EQ(run.exit_code, expected == Fate::succeeds ? 0 : 5) << run.err;
  const bool says_written = run.out.find(is_japanese ? "書き出し：" : "written: ") != std::string::npos;
  EXPECT_EQ(says_written, expected != Fate::old_stays) << run.out;
  if (expected == Fate::succeeds) {
    EXPECT_EQ(run.err, "");
    return;
  }
  const std::string en = expected == Fate::new_in_place ? "is written, but it is not certain" : "Cannot write ";
  const std::string ja = expected == Fate::new_in_place ? "は書き出しましたが" : "に書き込めません";
  EXPECT_NE(run.err.find(is_japanese ? ja : en), std::string::npos) << run.err;
  EXPECT_NE(run.err.find(target.path()), std::string::npos) << run.err;
}

// Runs the program again and again, with each call failing in each way.
void fail_each_call(const Target& target, const std::vector<std::string>& arguments,
                    std::initializer_list<int> errors) {
  target.reset();
  ASSERT_EQ(test::run_program(arguments, {}, target.environment(0, "0")).exit_code, 0);
  const std::string whole_new = target.content();
  ASSERT_NE(whole_new, target.old_content());
  bool is_japanese = false;
  for (const int error : errors) {
    is_japanese = !is_japanese;
    std::vector<std::string> words = arguments;
    words.insert(words.end(), {"--lang", is_japanese ? "ja" : "en"});
    bool after_rename = false;
    std::size_t nth = 1;
    for (;; ++nth) {
      target.reset();
      const test::ProgramRun run = test::run_program(words, {}, target.environment(nth, std::to_string(error)));
      const std::vector<Call> calls = target.calls();
      if (calls.size() < nth) break;  // none was left to fail
      const Call& failed = calls[nth - 1];
      SCOPED_TRACE(arguments[0] + ": " + failed.name + " " + failed.path + " fails with " + std::to_string(error));
      expect_fate(target, run, fate(failed, target.folder(), error, after_rename), whole_new, is_japanese);
      after_rename = after_rename || failed.name == "rename";
    }
    EXPECT_EQ(nth - 1, 9u) << "open folder, open, fchmod, write, fsync, close, rename, fsync folder, close folder";
  }
}

TEST(failing_saves, each_call_of_convert_in_turn) {
  const Target target;
  fail_each_call(target, {"convert", target.input(), "-o", target.path()},
                 {ENOSPC, EIO, EROFS, ENOENT, EACCES, EDQUOT, EINVAL, EINTR, EMFILE});
}

TEST(failing_saves, each_call_of_an_edits_output_in_turn) {
  const Target target;
  fail_each_call(target, {"edit", target.input(), "-o", target.path(), "--do", "split 0-1"}, {ENOSPC, EIO});
}

TEST(failing_saves, each_call_of_the_save_command_in_turn) {
  const Target target;
  fail_each_call(target, {"edit", target.input(), "--do", "split 0-1; save " + target.path()}, {EIO, ENOSPC});
}

TEST(failing_saves, a_write_that_takes_half_is_gone_on_with) {
  const Target target;
  const std::vector<std::string> words{"convert", target.input(), "-o", target.path()};
  ASSERT_EQ(test::run_program(words, {}, target.environment(0, "0")).exit_code, 0);
  const std::string whole_new = target.content();
  for (std::size_t nth = 1; nth <= 9; ++nth) {
    target.reset();
    EXPECT_EQ(test::run_program(words, {}, target.environment(nth, "short")).exit_code, 0);
    EXPECT_EQ(target.content(), whole_new);
    const bool is_write = target.calls()[nth - 1].name == "write";
    EXPECT_EQ(target.calls().size(), is_write ? 10u : 9u) << "another write for the other half";
  }
}

// Saves in a session and looks at what it says of itself. The test below runs this one again in processes of their own.
TEST(failing_saves, a_document_is_saved_or_says_that_it_is_not) {
  const Target own;
  const char* const given = std::getenv("RYOSEN_SAVE_TARGET");
  const std::string path = given ? given : own.path();
  auto document = Document::open(own.input());
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  ASSERT_TRUE(session.run("split 0-1").done());
  const Outcome outcome = session.run("save " + file_argument(path));
  EXPECT_EQ(session.document().is_modified(), !outcome.done());
  EXPECT_EQ(session.document().path(), outcome.done() ? path : own.input());
  EXPECT_EQ(session.log().size(), outcome.done() ? 2u : 1u);
  EXPECT_EQ(outcome.sentence.en.empty(), outcome.done()) << outcome.sentence.en;
  EXPECT_TRUE(given || outcome.done());
}

TEST(failing_saves, what_it_writes_itself_is_no_change_by_others) {
  const Target own;
  const char* const given = std::getenv("RYOSEN_SAVE_TARGET");
  auto document = Document::open(given ? given : own.path());
  if (!document && given) return;  // the call that fails is one of reading
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  ASSERT_TRUE(session.run("split 0-1").done());
  session.run("save");
  EXPECT_FALSE(session.look_at_disk());
}

// Runs a test again and again in another process, with each call failing; how many there are.
std::size_t fail_each_call_of(const std::string& test) {
  const Target target;
  const std::string self = std::filesystem::read_symlink("/proc/self/exe");
  std::size_t nth = 1;
  for (;; ++nth) {
    target.reset();
    std::string command = "RYOSEN_SAVE_TARGET=" + target.path();
    for (const std::string& variable : target.environment(nth, std::to_string(EIO))) command += " " + variable;
    command += " " + test::shell_word(self) + " --gtest_filter=failing_saves." + test + " >/dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << test << ' ' << nth;
    if (target.calls().size() < nth) return nth - 1;
  }
}

TEST(failing_saves, the_document_stays_unsaved_whichever_call_fails) {
  EXPECT_EQ(fail_each_call_of("a_document_is_saved_or_says_that_it_is_not"), 9u);
  EXPECT_GE(fail_each_call_of("what_it_writes_itself_is_no_change_by_others"), 9u);
}

#endif

}  // namespace
}  // namespace ryosen
