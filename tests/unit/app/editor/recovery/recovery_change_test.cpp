// What another program does to the file of a session that crashed: it is told before anything is replayed, nothing of
// it is replaced unasked, and the edits come back all the same.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <functional>

#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"
#include "ryosen/io/file_state.h"
#include "tests/unit/app/editor/recovery/recovery_fixture.h"

namespace ryosen {
namespace {

namespace fs = std::filesystem;
using Change = FileState::Change;

// The torus with its first vertex elsewhere: its numbers stay.
std::string moved_torus() {
  std::string text = test::read_file(test::asset("torus.off"));
  const std::size_t at = text.find("4.0 0.0 0.0");
  EXPECT_NE(at, text.npos);
  return text.replace(at, 3, "4.5");
}

void give_time(const std::string& path, const struct stat& times) {
  const timespec both[] = {times.st_atim, times.st_mtim};
  ASSERT_EQ(::utimensat(AT_FDCWD, path.c_str(), both, 0), 0);
}

class RecoveryChange : public RecoveryTest {
 protected:
  RecoveryChange() : path_(files_.copy(test::asset("torus.off"), "a.off")), content_(test::read_file(path_)) {}

  // A session with three edits that has crashed.
  void crash(const std::vector<std::string>& lines = {"split 0-1", "poke f3", "collapse 20-21 mid"}) {
    auto crashed = open(path_);
    for (const std::string& line : lines) crashed->run(line);
    hash_ = crashed->session.mesh().hash();
    log_ = crashed->session.log();
  }
  void write(const std::string& text) const { files_.write("a.off", text); }
  void rename_to(const std::string& text) const { fs::rename(files_.write("b.off", text), path_); }
  std::string on_disk() const { return test::read_file(path_); }
  void forget_copies() const {
    for (const std::string& name : kept())
      if (name.find(".original") != name.npos) fs::remove(state_.at(name));
  }
  // Lists and recovers, and expects that it is told of first.
  static std::string expect_told(Window& window, const std::string& words) {
    const Outcome list = window.session.run("recover list");
    EXPECT_NE(list.sentence.en.find(words), std::string::npos) << list.sentence.en;
    const std::uint64_t serial = window.session.document().serial();
    const std::vector<std::string> log = window.session.log();
    const Outcome told = window.session.run("recover 1");
    EXPECT_EQ(told.exit_code, ExitCode::refused);
    EXPECT_NE(told.sentence.en.find(words), std::string::npos) << told.sentence.en;
    EXPECT_NE(told.sentence.ja, "");
    EXPECT_EQ(window.session.document().serial(), serial) << "nothing is replayed";
    EXPECT_EQ(window.session.log(), log);
    EXPECT_EQ(window.session.lost.size(), 1u) << "the script stays";
    return told.sentence.en;
  }
  void expect_recovered(Window& window, const std::string& line) const {
    const Outcome outcome = window.session.run(line);
    EXPECT_TRUE(outcome.done()) << outcome.sentence.en;
    EXPECT_EQ(window.session.mesh().hash(), hash_);
    EXPECT_EQ(window.session.log(), log_);
    EXPECT_EQ(window.session.document().path(), path_);
    EXPECT_TRUE(window.session.document().is_modified());
  }
  // The file is what the other program wrote until keep_mine says so.
  void expect_kept_until_asked(Window& window, const std::string& theirs) const {
    EXPECT_EQ(window.session.change_on_disk(), Change::changed) << "the window says so at once";
    for (int i = 0; i < 2; ++i) {
      const Outcome refused = window.session.run("save");
      EXPECT_EQ(refused.exit_code, ExitCode::refused);
      EXPECT_NE(refused.sentence.en.find("keep_mine"), std::string::npos) << refused.sentence.en;
      EXPECT_EQ(on_disk(), theirs);
    }
    window.run("keep_mine");
    window.run("save");
    EXPECT_NE(on_disk(), theirs);
    EXPECT_EQ(Document::open(path_).value()->mesh().live().vertices, window.session.mesh().live().vertices);
  }

  std::string path_, content_;
  std::uint64_t hash_ = 0;
  std::vector<std::string> log_;
};

constexpr const char* by_another = "Another program has changed ";

TEST_F(RecoveryChange, is_told_first_and_survives_however_it_was_made) {
  struct Way {
    const char* name;
    std::string theirs;
    std::function<void(const std::string&)> make;
  };
  const auto in_place = [&](const std::string& text) { write(text); };
  const auto by_rename = [&](const std::string& text) { rename_to(text); };
  // Length and time are those of the file that it replaces.
  const auto alike = [&](const std::string& text) {
    struct stat before;
    ASSERT_EQ(::stat(path_.c_str(), &before), 0);
    ASSERT_EQ(static_cast<std::size_t>(before.st_size), text.size());
    rename_to(text);
    give_time(path_, before);
  };
  const Way ways[] = {{"a vertex moved in place", moved_torus(), in_place},
                      {"a vertex moved by rename", moved_torus(), by_rename},
                      {"a file of the same length and time", moved_torus(), alike},
                      {"a remark", "# theirs\n" + content_, in_place},
                      {"another mesh", test::read_file(test::asset("tetrahedron.off")), by_rename},
                      {"no mesh", "not a mesh\n", in_place},
                      {"nothing", "", in_place}};
  for (const Way& way : ways) {
    SCOPED_TRACE(way.name);
    write(content_);
    crash();
    way.make(way.theirs);
    ASSERT_EQ(on_disk(), way.theirs);
    auto again = open(test::asset("cube.obj"));
    const std::string told = expect_told(*again, by_another);
    EXPECT_NE(told.find("recover 1 as_was"), std::string::npos) << told;
    EXPECT_NE(told.find("recover 1 as_is"), std::string::npos) << told;
    expect_recovered(*again, "recover 1 as_was");
    EXPECT_EQ(on_disk(), way.theirs) << "recovering writes nothing";
    again->run("save " + file_argument(files_.at("mine.off")));  // beside it at any time
    again->run("undo");
    again.reset();
    // Now that file is the document's; the other one is as it was left.
    EXPECT_EQ(on_disk(), way.theirs);
    auto third = open_nothing();
    ASSERT_TRUE(third->session.run("recover 1").done());
    EXPECT_EQ(third->session.document().path(), files_.at("mine.off"));
    third->autosave.finish();
    EXPECT_TRUE(kept().empty());
  }
}

TEST_F(RecoveryChange, is_told_again_behind_a_second_crash_and_replaced_when_that_is_wanted) {
  crash();
  write(moved_torus());
  for (int i = 0; i < 3; ++i) {
    auto again = open_nothing();
    expect_told(*again, by_another);
    expect_recovered(*again, "recover 1 as_was");
  }
  auto last = open_nothing();
  expect_recovered(*last, "recover 1 as_was");
  last->run("split 2-3");
  hash_ = last->session.mesh().hash();
  log_ = last->session.log();
  last.reset();
  last = open_nothing();
  expect_told(*last, by_another);
  expect_recovered(*last, "recover 1 as_was");
  expect_kept_until_asked(*last, moved_torus());
  last->autosave.finish();
  EXPECT_TRUE(kept().empty());
}

TEST_F(RecoveryChange, can_be_what_the_edits_are_done_on) {
  for (const std::string& theirs : {moved_torus(), "# theirs\n" + content_}) {
    write(content_);
    crash();
    write(theirs);
    auto plain = open(path_);
    for (const std::string& line : log_) plain->run(line);
    const std::uint64_t both = plain->session.mesh().hash();
    plain->autosave.finish();
    auto again = open_nothing();
    expect_told(*again, by_another);
    ASSERT_TRUE(again->session.run("recover 1 as_is").done());
    EXPECT_EQ(again->session.mesh().hash(), both) << "what both have made";
    EXPECT_EQ(again->session.change_on_disk(), Change::none);
    again.reset();
    again = open_nothing();
    ASSERT_TRUE(again->session.run("recover list").done());
    ASSERT_EQ(again->session.lost.size(), 1u) << "one script in place of the other";
    const Outcome outcome = again->session.run("recover 1");
    ASSERT_TRUE(outcome.done()) << outcome.sentence.en;
    EXPECT_EQ(again->session.mesh().hash(), both);
    again->run("save");
    EXPECT_EQ(on_disk().find("# theirs") != std::string::npos, theirs.find("# theirs") != std::string::npos);
    again->autosave.finish();
    EXPECT_TRUE(kept().empty());
  }
}

TEST_F(RecoveryChange, before_the_first_edit_keeps_both_choices) {
  struct Case {
    const char* file;
    std::vector<std::string> lines;
  };
  const Case cases[] = {{"torus.off", {"split 0-1"}},
                        {"cube.obj", {"collapse 0-1 mid", "poke f3"}},
                        {"ball.off", {"split 0-1", "collapse 2-3 mid"}},
                        {"hanging_pair.obj", {"repair default"}},
                        {"two_quads.obj", {"delete f1"}},
                        {"../tests/data/reports/tristrips.ply", {"poke f0"}},
                        {"../tests/data/reports/realsense.ply", {"poke f0"}},
                        {"../tests/data/reports/stl_report.stl", {"poke f0"}},
                        {"points.xyz", {"delete v1"}}};
  files_.write("points.xyz", "0 0 0\n1 0 0\n0 1 .1\n");
  const std::string theirs = test::read_file(test::asset("tetrahedron.off"));
  for (const Case& c : cases) {
    SCOPED_TRACE(c.file);
    const std::string name = fs::path(c.file).filename().string();
    path_ = name == "points.xyz" ? files_.at(name) : files_.copy(test::asset(c.file), name);
    {
      auto crashed = open(path_);
      files_.write(name, theirs);
      for (const std::string& line : c.lines) crashed->run(line);
      hash_ = crashed->session.mesh().hash();
      log_ = crashed->session.log();
    }
    auto again = open_nothing();
    const std::string told = expect_told(*again, by_another);
    EXPECT_NE(told.find("recover 1 as_was"), std::string::npos) << told;
    EXPECT_NE(told.find("recover 1 as_is"), std::string::npos) << told;
    expect_recovered(*again, "recover 1 as_was");
    EXPECT_EQ(on_disk(), theirs);
    again->autosave.finish();
    EXPECT_TRUE(kept().empty());
  }
}

TEST_F(RecoveryChange, is_none_where_the_bytes_are_equal) {
  const std::function<void()> ways[] = {
      [&] { fs::last_write_time(path_, fs::last_write_time(path_) + std::chrono::hours(1)); }, [&] { write(content_); },
      [&] { rename_to(content_); },
      [&] {
        fs::rename(path_, files_.at("aside.off"));
        fs::rename(files_.at("aside.off"), path_);
      }};
  for (const auto& touch : ways) {
    write(content_);
    crash();
    touch();
    auto again = open_nothing();
    expect_recovered(*again, "recover 1");
    EXPECT_FALSE(again->session.look_at_disk());
    again->run("save");
    EXPECT_NE(on_disk(), content_);
    again->autosave.finish();
    EXPECT_TRUE(kept().empty());
  }
}

TEST_F(RecoveryChange, is_noticed_behind_the_recovery) {
  for (const bool by_rename : {false, true}) {
    write(content_);
    crash();
    auto again = open_nothing();
    expect_recovered(*again, "recover 1");
    EXPECT_EQ(again->session.change_on_disk(), Change::none);
    by_rename ? rename_to(moved_torus()) : write(moved_torus());
    EXPECT_TRUE(again->session.look_at_disk());
    expect_kept_until_asked(*again, moved_torus());
    again->autosave.finish();
  }
  write(content_);
  crash();
  auto again = open_nothing();
  expect_recovered(*again, "recover 1");
  write(moved_torus());
  EXPECT_EQ(again->session.run("save").exit_code, ExitCode::refused);
  again->run("reload");
  EXPECT_EQ(again->session.mesh().hash(), Document::open(path_).value()->mesh().hash());
}

TEST_F(RecoveryChange, to_no_file_is_told_and_the_edits_come_back) {
  crash();
  fs::remove(path_);
  auto again = open(test::asset("cube.obj"));
  const std::string told = expect_told(*again, "has gone from the disk");
  EXPECT_NE(told.find("as_was"), std::string::npos) << told;
  EXPECT_EQ(told.find("as_is"), std::string::npos) << told;
  EXPECT_EQ(again->session.run("recover 1 as_is").exit_code, ExitCode::refused);
  expect_recovered(*again, "recover 1 as_was");
  EXPECT_EQ(again->session.change_on_disk(), Change::gone);
  again->run("save");
  EXPECT_TRUE(fs::exists(path_));
  EXPECT_EQ(again->session.change_on_disk(), Change::none);
  again->autosave.finish();
  EXPECT_TRUE(kept().empty());
}

TEST_F(RecoveryChange, behind_a_save_is_told_too) {
  const std::string out = files_.at("out.off");
  for (const std::string& save : {std::string("save"), "save " + file_argument(out)}) {
    SCOPED_TRACE(save);
    write(content_);
    crash({"collapse 0-1 mid", save, "split 40-41", "poke f7"});
    const std::string file = save == "save" ? path_ : out, saved = test::read_file(file);
    const fs::file_time_type time = fs::last_write_time(file);
    fs::last_write_time(file, time + std::chrono::hours(2));
    {
      auto untold = open_nothing();
      ASSERT_TRUE(untold->session.run("recover 1").done()) << "the bytes are equal";
      EXPECT_EQ(untold->session.mesh().hash(), hash_);
    }
    std::ofstream(file) << "# theirs\n" << saved;
    auto again = open_nothing();
    const std::string told = expect_told(*again, by_another);
    EXPECT_EQ(told.find("as_is"), std::string::npos) << "some edits are in the file: " << told;
    EXPECT_EQ(again->session.run("recover 1 as_is").exit_code, ExitCode::refused);
    ASSERT_TRUE(again->session.run("recover 1 as_was").done());
    EXPECT_EQ(again->session.mesh().hash(), hash_);
    EXPECT_EQ(again->session.document().path(), file);
    EXPECT_EQ(again->session.run("save").exit_code, ExitCode::refused);
    EXPECT_EQ(test::read_file(file), "# theirs\n" + saved);
    again->autosave.finish();
  }
}

TEST_F(RecoveryChange, of_what_it_began_with_does_not_matter_where_the_file_is_another) {
  const std::string out = files_.at("out.off");
  crash({"split 0-1", "save " + file_argument(out), "split 2-3"});
  write(moved_torus());
  auto again = open_nothing();
  ASSERT_TRUE(again->session.run("recover 1").done());
  EXPECT_EQ(again->session.mesh().hash(), hash_);
  again->run("save");
  EXPECT_EQ(on_disk(), moved_torus());
}

TEST_F(RecoveryChange, that_was_kept_before_the_crash_is_not_told_again) {
  auto crashed = open(path_);
  crashed->run("split 0-1");
  write(moved_torus());
  crashed->run("keep_mine");
  crashed->run("split 2-3");
  hash_ = crashed->session.mesh().hash();
  log_ = crashed->session.log();
  crashed.reset();
  auto again = open_nothing();
  expect_recovered(*again, "recover 1");
  again->run("save");
  EXPECT_NE(on_disk(), moved_torus());
}

TEST_F(RecoveryChange, without_a_copy_leaves_the_file_as_it_is) {
  crash({"split 0-1"});
  write(moved_torus());
  forget_copies();
  auto again = open_nothing();
  const std::string told = expect_told(*again, by_another);
  EXPECT_EQ(told.find("as_was"), std::string::npos) << told;
  const Outcome refused = again->session.run("recover 1 as_was");
  EXPECT_EQ(refused.exit_code, ExitCode::refused);
  EXPECT_NE(refused.sentence.en.find("There is no copy of "), std::string::npos) << refused.sentence.en;
  const Outcome outcome = again->session.run("recover 1 as_is");
  ASSERT_TRUE(outcome.done()) << outcome.sentence.en;
  EXPECT_NE(outcome.sentence.en.find("But "), std::string::npos) << outcome.sentence.en;
  EXPECT_EQ(again->session.mesh().live().vertices, 49u);
}

TEST_F(RecoveryChange, may_be_its_own_where_it_ended_while_it_saved) {
  crash();
  const std::string name = kept().back();
  const std::string script = test::read_file(state_.at(name));
  state_.write(name, script + "# saving " + path_ + "\n");
  write(moved_torus());
  auto again = open_nothing();
  expect_told(*again, "was being saved when Ryosen ended, or another program has changed it");
  expect_recovered(*again, "recover 1 as_was");
  again->autosave.finish();
}

// As an earlier version wrote it, or somebody by hand.
TEST_F(RecoveryChange, is_seen_from_the_recovery_on_where_the_script_knows_no_file) {
  crash();
  const std::string name = kept().back();
  std::string script = test::read_file(state_.at(name)), bare;
  for (std::size_t begin = 0, end; (end = script.find('\n', begin)) != script.npos; begin = end + 1)
    if (const std::string line = script.substr(begin, end + 1 - begin);
        !line.starts_with("# file") && !line.starts_with("# original"))
      bare += line;
  ASSERT_LT(bare.size(), script.size());
  forget_copies();
  state_.write(name, bare);
  {
    auto again = open_nothing();
    expect_recovered(*again, "recover 1");
    write(moved_torus());
    EXPECT_EQ(again->session.run("save").exit_code, ExitCode::refused);
  }
  auto third = open_nothing();
  const Outcome told = third->session.run("recover 1");
  EXPECT_EQ(told.exit_code, ExitCode::refused);
  EXPECT_NE(told.sentence.en.find("is not the mesh that it was"), std::string::npos) << told.sentence.en;
  EXPECT_NE(told.sentence.en.find("recover 1 as_is"), std::string::npos) << told.sentence.en;
  for (const char* remark : {"# file", "# file 1 2", "# file x y z w", "# file 1 2 3 nonsense", "# file -1 0 0 1 2"}) {
    state_.write(name, bare + remark + "\n");
    write(content_);
    EXPECT_EQ(find_lost_sessions(recovery_folder()).value().size(), 1u) << remark;
  }
}

TEST_F(RecoveryChange, is_told_in_scripts_without_a_window) {
  crash();
  write(moved_torus());
  const std::string variable = "XDG_STATE_HOME=" + state_.path().string(), out = files_.at("out.off");
  const auto run = [&](const std::string& line, const std::string& language) {
    return test::run_program({"edit", "--new", "--do", line, "-o", out, "--lang", language}, {}, {variable});
  };
  const auto told = run("recover 1", "en");
  EXPECT_EQ(told.exit_code, 6) << told.err;
  EXPECT_NE(told.err.find(by_another), std::string::npos) << told.err;
  EXPECT_NE(run("recover 1", "ja").err.find("他のプログラムが変更しました"), std::string::npos);
  EXPECT_FALSE(fs::exists(out));
  const auto as_was = run("recover 1 as_was", "en");
  EXPECT_EQ(as_was.exit_code, 0) << as_was.err;
  const std::string mine = test::read_file(out);
  fs::remove(out);
  EXPECT_EQ(run("recover 1 as_is", "en").exit_code, 0);
  EXPECT_NE(test::read_file(out), mine);
  EXPECT_EQ(on_disk(), moved_torus());
  for (const char* wrong : {"recover 1 as", "recover as_was", "recover 1 as_is as_was", "recover list as_is",
                            "recover discard 1 as_is", "recover 0 as_was"})
    EXPECT_EQ(run(wrong, "en").exit_code, 2) << wrong;
}

}  // namespace
}  // namespace ryosen
