// A session that crashed is brought back by its script. A crash is a session that ends without finishing its autosave;
// tests/ui/window_test.cpp kills a real one.
#include "app/editor/recovery/recovery.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"
#include "ryosen/io/gzip.h"
#include "tests/unit/app/editor/recovery/recovery_fixture.h"

namespace ryosen {
namespace {

namespace fs = std::filesystem;

TEST_F(RecoveryTest, the_folder_is_that_of_the_users_state) {
  EXPECT_EQ(recovery_folder(), state_.path() / "ryosen/recovery");
  unsetenv("XDG_STATE_HOME");
  const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
  setenv("HOME", "/home/somebody", 1);
  EXPECT_EQ(recovery_folder(), "/home/somebody/.local/state/ryosen/recovery");
  setenv("XDG_STATE_HOME", "not/whole", 1);
  EXPECT_EQ(recovery_folder(), "/home/somebody/.local/state/ryosen/recovery");
  unsetenv("HOME");
  EXPECT_EQ(recovery_folder(), "");
  if (!home.empty()) setenv("HOME", home.c_str(), 1);
}

TEST_F(RecoveryTest, what_a_crash_leaves_is_done_again) {
  const std::string path = files_.copy(test::asset("torus.off"), "in put.off");
  auto crashed = open(path);
  EXPECT_TRUE(kept().empty()) << "nothing was done yet";
  for (const char* line : {"split 0-1", "poke f3", "undo", "redo", "undo 2", "redo 2", "move_vertex 0 0.1,1e-9,3"})
    crashed->run(line);
  crashed->run("select v3");
  const std::uint64_t hash = crashed->session.mesh().hash();
  const std::vector<std::string> log = crashed->session.log();
  ASSERT_EQ(log.size(), 7u);
  EXPECT_EQ(kept().size(), 2u) << "the script, and a copy of what it began with";
  EXPECT_TRUE(find_lost_sessions(recovery_folder()).value().empty()) << "it is still running";
  crashed.reset();

  auto again = open_nothing();
  ASSERT_TRUE(again->session.run("recover").done());
  ASSERT_EQ(again->session.lost.size(), 1u);
  EXPECT_EQ(again->session.lost[0].file, path);
  EXPECT_EQ(again->session.lost[0].edits.size(), log.size());
  EXPECT_EQ(again->session.lost[0].unsaved, (Document::Unsaved{3, 0})) << "two of them by one redo";
  const Outcome outcome = again->session.run("recover 1");
  ASSERT_TRUE(outcome.done()) << outcome.sentence.en;
  EXPECT_EQ(outcome.sentence.en, "3 edits are recovered and not saved yet.");
  EXPECT_EQ(outcome.sentence.en.find("But "), std::string::npos);
  EXPECT_EQ(again->session.mesh().hash(), hash);
  EXPECT_EQ(again->session.log(), log);
  EXPECT_TRUE(again->session.document().is_modified());
  EXPECT_EQ(again->session.document().path(), path);
  EXPECT_EQ(test::read_file(path), test::read_file(test::asset("torus.off"))) << "only a save writes";
  // It goes on with the script, and another crash loses nothing either.
  EXPECT_TRUE(find_lost_sessions(recovery_folder()).value().empty());
  again->run("split 2-3");
  const std::uint64_t later = again->session.mesh().hash();
  again.reset();
  auto third = open_nothing();
  ASSERT_TRUE(third->session.run("recover 1").done());
  EXPECT_EQ(third->session.mesh().hash(), later);
  third->autosave.finish();
  EXPECT_TRUE(kept().empty());
}

// Several ways in which an edit works on a selection, one after the other: without the lines that select, none is done.
TEST_F(RecoveryTest, edits_on_a_selection_come_back_with_what_they_worked_on) {
  auto crashed = open(files_.copy(test::asset("torus.off"), "torus.off"));
  for (const char* line : {"select f0 f1 f2", "poke selected", "select v0 v1",   "key G",        "move 900,300",
                           "key X",           "key 2",         "key Enter",      "select f40",   "key E",
                           "key 1",           "key Enter",     "select f50 f60", "key Shift+D",  "key Z",
                           "key 2",           "key Enter",     "select f51",     "key E",        "key 0",
                           "key Enter",       "select 0-1",    "key Shift+E",    "move 700,300", "key Enter"})
    crashed->run(line);
  const std::uint64_t hash = crashed->session.mesh().hash();
  EXPECT_EQ(crashed->session.document().history().size(), 6u);
  crashed.reset();
  auto again = open_nothing();
  ASSERT_TRUE(again->session.run("recover 1").done());
  EXPECT_EQ(again->session.mesh().hash(), hash);
  EXPECT_EQ(again->session.document().history().size(), 6u);
}

TEST_F(RecoveryTest, no_output_takes_the_place_of_what_a_recovered_session_was_read_from) {
  const std::string in = files_.copy(test::asset("torus.off"), "in.off"), out = files_.at("out.off");
  auto crashed = open(in);
  crashed->run("split 0-1");
  crashed->run("save " + file_argument(out));
  crashed->run("split 2-3");
  crashed.reset();
  auto again = open_nothing();
  again->session.files = RunFiles(RunFiles::Policy::keep);
  ASSERT_TRUE(again->session.run("recover").done());
  ASSERT_TRUE(again->session.run("recover 1").done());
  EXPECT_FALSE(again->session.files.may_write(in, FileRole::result).ok());
  EXPECT_TRUE(again->session.files.may_write(out, FileRole::saved).ok());
}

TEST_F(RecoveryTest, an_orderly_end_leaves_nothing) {
  auto window = open(test::asset("torus.off"));
  window->run("split 0-1");
  EXPECT_EQ(kept().size(), 2u);
  for (const std::string& name : kept()) {
    struct stat status;
    ASSERT_EQ(::stat(state_.at(name).c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0600u) << name;
  }
  window->autosave.finish();
  EXPECT_TRUE(kept().empty());
}

TEST_F(RecoveryTest, nothing_is_offered_that_is_saved_or_undone_or_given_up) {
  const std::string path = files_.copy(test::asset("torus.off"), "a.off");
  auto saved = open(path);
  saved->run("split 0-1");
  saved->run("save");
  saved.reset();
  auto undone = open(path);
  undone->run("split 2-3");
  undone->run("undo");
  undone.reset();
  EXPECT_EQ(kept().size(), 4u) << "two scripts and what they began with";
  EXPECT_TRUE(find_lost_sessions(recovery_folder()).value().empty());
  EXPECT_TRUE(kept().empty());
  auto left = open(path);
  left->run("split 2-3");
  left->run("open " + file_argument(test::asset("cube.obj")));
  EXPECT_TRUE(kept().empty()) << "another document takes its place";
}

TEST_F(RecoveryTest, edits_after_a_save_over_the_file_begin_with_what_it_held) {
  const std::string path = files_.copy(test::asset("torus.off"), "a.off");
  auto crashed = open(path);
  crashed->run("collapse 0-1 mid");  // the file that is saved has other numbers from here on
  crashed->run("save");
  const std::string saved = test::read_file(path);
  crashed->run("split 40-41");
  crashed->run("save");
  crashed->run("undo");
  crashed->run("split 30-31");
  const std::uint64_t hash = crashed->session.mesh().hash();
  crashed.reset();
  ASSERT_NE(saved, test::read_file(test::asset("torus.off")));

  const auto lost = find_lost_sessions(recovery_folder()).value();
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost[0].unsaved, (Document::Unsaved{1, 1}));
  EXPECT_EQ(lost[0].edits.size(), 4u);
  auto again = open(path);
  const Outcome outcome = again->session.run("recover 1");
  ASSERT_TRUE(outcome.done()) << outcome.sentence.en;
  EXPECT_EQ(outcome.sentence.en.find("But "), std::string::npos) << outcome.sentence.en;
  EXPECT_EQ(again->session.mesh().hash(), hash);
  EXPECT_EQ(again->session.document().path(), path);
  again->run("save");
  again->autosave.finish();
  EXPECT_TRUE(kept().empty());
}

// What is offered is what the file does not hold, however the session came there.
TEST_F(RecoveryTest, edits_that_are_in_the_file_are_not_counted_behind_an_undo) {
  const std::string path = files_.copy(test::asset("torus.off"), "a.off");
  struct Case {
    std::vector<std::string> behind_the_save;
    std::string listed, recovered;
  };
  const Case cases[] = {
      {{"undo 2", "split 4-5"},
       "1 edit and 2 saved ones undone",
       "2 edits are recovered, of which the last 1 was not saved. The file holds 2 more, which had been undone."},
      {{"undo 2", "redo"},
       "1 saved edit undone",
       "2 edits are recovered. The file holds 1 more, which had been undone."},
      {{"undo 2", "redo 2", "split 4-5"}, "1 edit", "4 edits are recovered, of which the last 1 was not saved."},
      {{"undo", "redo", "split 4-5", "split 6-7", "undo"},
       "1 edit",
       "4 edits are recovered, of which the last 1 was not saved."},
      {{"undo 3", "split 4-5", "split 6-7"},
       "2 edits and 3 saved ones undone",
       "2 edits are recovered and not saved yet. The file holds 3 more, which had been undone."}};
  for (const Case& way : cases) {
    auto crashed = open(path);
    for (const char* line : {"split 0-1", "split 2-3", "split 10-11"}) crashed->run(line);
    crashed->run("save " + file_argument(files_.at("b.off")));
    for (const std::string& line : way.behind_the_save) crashed->run(line);
    const Document::Unsaved unsaved = crashed->session.document().unsaved();
    const std::uint64_t hash = crashed->session.mesh().hash();
    crashed.reset();
    auto again = open_nothing();
    ASSERT_TRUE(list_lost_sessions(again->session.lost));
    ASSERT_EQ(again->session.lost.size(), 1u);
    EXPECT_NE(describe(again->session.lost[0]).en.find("b.off, " + way.listed + ", 2"), std::string::npos)
        << describe(again->session.lost[0]).en;
    EXPECT_EQ(again->session.run("recover 1").sentence.en, way.recovered);
    EXPECT_EQ(again->session.mesh().hash(), hash);
    EXPECT_EQ(again->session.document().unsaved(), unsaved) << "it goes on from there";
    // And so does the script.
    again->run("split 20-21");
    const Document::Unsaved later = again->session.document().unsaved();
    EXPECT_EQ(later.edits, unsaved.edits + 1);
    again.reset();
    auto third = open_nothing();
    ASSERT_TRUE(list_lost_sessions(third->session.lost));
    EXPECT_EQ(third->session.lost[0].unsaved, later);
    ASSERT_TRUE(third->session.run("recover 1").done());
    third->autosave.finish();
  }
}

TEST_F(RecoveryTest, a_packed_file_is_saved_packed_and_its_original_read_by_its_name) {
  // Only its name says that the list is OFF.
  const std::string path = files_.write("a.off.gz", pack_gzip(test::read_file(test::asset("torus.off")).substr(4)));
  auto crashed = open(path);
  crashed->run("collapse 0-1 mid");
  crashed->run("save");
  EXPECT_TRUE(is_gzip(test::read_file(path)));
  EXPECT_EQ(Document::open(path).value()->mesh().live().faces, crashed->session.mesh().live().faces);
  crashed->run("split 40-41");
  const std::uint64_t hash = crashed->session.mesh().hash();
  crashed.reset();
  auto again = open_nothing();
  const Outcome outcome = again->session.run("recover 1");
  ASSERT_TRUE(outcome.done()) << outcome.sentence.en;
  EXPECT_EQ(again->session.mesh().hash(), hash);
}

TEST_F(RecoveryTest, saving_first_and_editing_then_is_the_same) {
  // A point that the file does not use keeps its number in the session and in the file; faces set aside come back.
  const std::string path = files_.copy(test::asset("isolated_vertex.obj"), "a.obj");
  auto crashed = open(path);
  crashed->run("save " + file_argument(files_.at("b.obj")));
  EXPECT_TRUE(kept().empty());
  crashed->run("save " + file_argument(path));
  crashed->run("split 0-1");
  const std::uint64_t hash = crashed->session.mesh().hash();
  crashed.reset();
  auto again = open_nothing();
  ASSERT_TRUE(again->session.run("recover 1").done());
  EXPECT_EQ(again->session.mesh().hash(), hash);
  EXPECT_EQ(again->session.document().path(), path);
}

TEST_F(RecoveryTest, a_new_name_is_the_documents_afterwards_too) {
  const std::string path = files_.copy(test::asset("torus.off"), "a.off"), other = files_.at("b # \"c\".obj");
  auto crashed = open(path);
  crashed->run("split 0-1");
  crashed->run("save " + file_argument(other));
  EXPECT_EQ(kept().size(), 2u) << "the first file is still what it was";
  crashed->run("split 2-3");
  crashed.reset();
  auto again = open_nothing();
  ASSERT_TRUE(again->session.run("recover 1").done());
  EXPECT_EQ(again->session.document().path(), other);
  again->run("undo 2");
  EXPECT_TRUE(again->session.document().is_modified()) << "that file holds another state";
}

TEST_F(RecoveryTest, a_mesh_made_from_nothing_comes_back) {
  auto crashed = open_nothing();
  crashed->run("make_vertex 0,0,0.1");
  crashed->run("make_vertex 0.3333333333333333,1e-300,0");
  const std::uint64_t hash = crashed->session.mesh().hash();
  crashed.reset();
  auto again = open(test::asset("cube.obj"));
  const Outcome outcome = again->session.run("recover 1");
  ASSERT_TRUE(outcome.done()) << outcome.sentence.en;
  EXPECT_EQ(again->session.mesh().hash(), hash);
  EXPECT_EQ(again->session.document().path(), "");
}

TEST_F(RecoveryTest, a_file_that_has_changed_is_said_and_the_line_that_fails) {
  const std::string path = files_.copy(test::asset("torus.off"), "a.off");
  auto crashed = open(path);
  crashed->run("split 0-1");
  crashed->run("split 40-41");
  crashed.reset();
  files_.write("a.off", test::read_file(test::asset("tetrahedron.off")));
  auto again = open_nothing();
  const Outcome outcome = again->session.run("recover 1 as_is");
  EXPECT_EQ(outcome.kind, Outcome::Kind::failed);
  EXPECT_EQ(outcome.exit_code, ExitCode::usage);
  EXPECT_NE(outcome.sentence.en.find("1 of 2 edits are recovered; line 7 of "), std::string::npos)
      << outcome.sentence.en;
  EXPECT_NE(outcome.sentence.en.find("(split 40-41"), std::string::npos) << outcome.sentence.en;
  EXPECT_NE(outcome.sentence.en.find("is not the mesh that it was"), std::string::npos) << outcome.sentence.en;
  EXPECT_NE(outcome.sentence.en.find("exist. The script stays there. But "), std::string::npos) << outcome.sentence.en;
  EXPECT_NE(outcome.sentence.ja.find("7 行目"), std::string::npos) << outcome.sentence.ja;
  EXPECT_EQ(again->session.document().position(), 1u);
  EXPECT_EQ(again->session.lost.size(), 1u) << "the script stays";
  // What goes on from here has a script of its own.
  again->run("split 2-3");
  const std::uint64_t hash = again->session.mesh().hash();
  again.reset();
  const auto lost = find_lost_sessions(recovery_folder()).value();
  ASSERT_EQ(lost.size(), 2u);
  auto third = open_nothing();
  const LostSession& later =
      lost[0].edits[1].text == "split 2-3 0.5" || lost[0].edits[1].text == "split 2-3" ? lost[0] : lost[1];
  EXPECT_TRUE(recover(third->session, later).done());
  EXPECT_EQ(third->session.mesh().hash(), hash);
}

TEST_F(RecoveryTest, where_file_and_copy_are_gone_nothing_changes_and_the_script_is_named) {
  const std::string path = files_.copy(test::asset("torus.off"), "a.off");
  auto crashed = open(path);
  crashed->run("split 0-1");
  crashed.reset();
  fs::remove(path);
  for (const std::string& name : kept())
    if (name.find(".original") != name.npos) fs::remove(state_.at(name));
  auto again = open(test::asset("cube.obj"));
  const Outcome outcome = again->session.run("recover 1");
  EXPECT_EQ(outcome.exit_code, ExitCode::input_missing);
  ASSERT_EQ(again->session.lost.size(), 1u);
  EXPECT_NE(outcome.sentence.en.find(again->session.lost[0].script.string()), std::string::npos);
  EXPECT_EQ(again->session.document().path(), test::asset("cube.obj"));
  EXPECT_TRUE(again->session.run("recover discard 1").done());
  EXPECT_TRUE(kept().empty());
  EXPECT_EQ(again->session.run("recover 1").exit_code, ExitCode::usage);
}

TEST_F(RecoveryTest, where_the_file_cannot_be_read_any_more_its_line_is_named) {
  const std::string path = files_.copy(test::asset("torus.off"), "a.off");
  auto crashed = open(path);
  crashed->run("split 0-1");
  crashed.reset();
  files_.write("a.off", "OFF\n1 0 0\n0 0 x\n");
  auto again = open(test::asset("cube.obj"));
  const Outcome outcome = again->session.run("recover 1 as_is");
  EXPECT_EQ(outcome.exit_code, ExitCode::input_malformed);
  EXPECT_TRUE(outcome.sentence.en.starts_with(path + ":3:5: ")) << outcome.sentence.en;
}

TEST_F(RecoveryTest, two_windows_keep_two_scripts_and_the_latest_comes_first) {
  auto one = open(test::asset("torus.off")), two = open(test::asset("cube.obj"));
  one->run("split 0-1");
  two->run("split 0-1");
  EXPECT_EQ(kept().size(), 4u) << "with what they began with";
  two.reset();
  auto third = open_nothing();
  ASSERT_TRUE(third->session.run("recover list").done());
  ASSERT_EQ(third->session.lost.size(), 1u) << "the other still runs";
  EXPECT_EQ(third->session.lost[0].file, test::asset("cube.obj"));
  // What one window has listed another may have taken.
  auto fourth = open_nothing();
  ASSERT_TRUE(fourth->session.run("recover 1").done());
  const Outcome late = third->session.run("recover 1");
  EXPECT_EQ(late.exit_code, ExitCode::input_missing);
  EXPECT_NE(late.sentence.en.find("another window"), std::string::npos);
}

TEST_F(RecoveryTest, a_line_that_the_crash_cut_off_is_left_out) {
  auto crashed = open(test::asset("torus.off"));
  crashed->run("split 0-1");
  const std::uint64_t hash = crashed->session.mesh().hash();
  ASSERT_TRUE(crashed->autosave.script());
  const std::string script = crashed->autosave.script()->path();
  crashed.reset();
  const std::string whole = test::read_file(script);
  state_.write(fs::relative(script, state_.path()).string(), whole + "split 2-");
  auto again = open_nothing();
  ASSERT_TRUE(again->session.run("recover 1").done());
  EXPECT_EQ(again->session.mesh().hash(), hash);
  EXPECT_EQ(test::read_file(script), whole);
}

TEST_F(RecoveryTest, what_is_no_script_of_a_session_is_left_alone) {
  state_.write("ryosen/recovery/session-1.ryosen", "# ryosen session 2\nsomething new\n");
  state_.write("ryosen/recovery/session-2.ryosen", "split 0-1");
  state_.write("ryosen/recovery/notes.txt", "mine");
  state_.write("ryosen/recovery/session-3.ryosen", "");  // a crash right after it was made
  EXPECT_TRUE(find_lost_sessions(recovery_folder()).value().empty());
  EXPECT_EQ(kept().size(), 3u);
}

// Each was opened, read as empty and deleted, as a script without edits is.
TEST_F(RecoveryTest, what_is_no_file_is_left_alone_by_the_name_of_a_script) {
  const std::string script = "# ryosen session 1\n# mesh 0\nnew\n";
  const std::string outside = files_.write("outside", script);
  fs::create_directories(recovery_folder());
  const auto at = [](const char* name) { return recovery_folder() / name; };
  ASSERT_EQ(::mkfifo(at("session-1.ryosen").c_str(), 0600), 0);
  fs::create_directory(at("session-2.ryosen"));
  fs::create_symlink(outside, at("session-3.ryosen"));
  fs::create_symlink("/dev/null", at("session-4.ryosen"));
  fs::create_symlink("nowhere", at("session-5.ryosen"));
  state_.write("ryosen/recovery/session-6.ryosen", script);
  ASSERT_EQ(::mkfifo(at("session-6.original").c_str(), 0600), 0);
  Session session(std::make_unique<Document>());
  ASSERT_TRUE(session.run("recover list").done());
  EXPECT_TRUE(session.lost.empty());
  for (const char* name : {"session-1.ryosen", "session-2.ryosen", "session-3.ryosen", "session-4.ryosen",
                           "session-5.ryosen", "session-6.original"})
    EXPECT_NE(fs::symlink_status(at(name)).type(), fs::file_type::not_found) << name;
  EXPECT_FALSE(fs::exists(at("session-6.ryosen"))) << "nothing is unsaved there";
  EXPECT_EQ(test::read_file(outside), script);
}

// It began with no file, so that no file can have changed: the sentence named one without a name.
TEST_F(RecoveryTest, a_script_that_begins_with_new_names_no_file_and_ends_its_sentences) {
  const auto recovered = [&](const std::string& lines, bool is_done) {
    state_.write("ryosen/recovery/session-1.ryosen", "# ryosen session 1\n# mesh 0123456789abcdef\n" + lines);
    auto again = open_nothing();
    EXPECT_TRUE(again->session.run("recover list").done());
    const Outcome outcome = again->session.run("recover 1");
    EXPECT_EQ(outcome.done(), is_done) << outcome.sentence.en;
    EXPECT_EQ(outcome.sentence.en.find("But "), std::string::npos) << outcome.sentence.en;
    EXPECT_EQ(outcome.sentence.ja.find("ただし"), std::string::npos) << outcome.sentence.ja;
    EXPECT_TRUE(outcome.sentence.en.ends_with(".")) << outcome.sentence.en;
    EXPECT_TRUE(outcome.sentence.ja.ends_with("。")) << outcome.sentence.ja;
    EXPECT_EQ(again->session.document().path(), "");
    again->autosave.finish();
    fs::remove(state_.at("ryosen/recovery/session-1.ryosen"));
    return outcome.sentence;
  };
  const std::string edits = "make_vertex 0,0,0\nmake_vertex 1,0,0\nmake_edge v0 v1\n";
  EXPECT_EQ(recovered("new\nmake_vertex 0,0,0\n", true).en, "1 edit is recovered and not saved yet.");
  for (const char* begin : {"new\n", "new # by hand\n", "  new \n", "new\r\n", "new\n# a comment\n\n"})
    EXPECT_EQ(recovered(begin + edits, true).en, "3 edits are recovered and not saved yet.") << begin;
  for (const char* second : {"new\n", "open nosuch.obj\n"})
    EXPECT_NE(recovered("new\n" + std::string(second) + edits, false).en.find("it is not an edit. The script stays"),
              std::string::npos);
  for (const char* wrong : {"split 40-41", "nonsense", "poke f7", "select v9", "view top", "save"}) {
    const Text said = recovered("new\nmake_vertex 0,0,0\n" + std::string(wrong) + "\n", false);
    EXPECT_NE(said.en.find(". The script stays there."), std::string::npos) << said.en;
    EXPECT_NE(said.ja.find("。スクリプトは"), std::string::npos) << said.ja;
    EXPECT_EQ(said.en.find(".. "), std::string::npos) << said.en;
  }
}

TEST_F(RecoveryTest, a_folder_that_cannot_be_written_is_said_once_and_stops_no_edit) {
  state_.write("ryosen", "a file where the folder would be");
  auto window = open(test::asset("torus.off"));
  const Outcome first = window->session.run("split 0-1");
  EXPECT_TRUE(first.done());
  EXPECT_NE(first.sentence.en.find("After a crash"), std::string::npos) << first.sentence.en;
  EXPECT_NE(first.sentence.en.find(recovery_folder().string()), std::string::npos) << first.sentence.en;
  EXPECT_FALSE(first.sentence.ja.empty());
  for (const char* line : {"split 2-3", "undo", "redo"}) EXPECT_EQ(window->session.run(line).sentence.en, "") << line;
  EXPECT_EQ(window->session.document().position(), 2u);
  EXPECT_TRUE(window->session.run("save " + file_argument(files_.at("out.off"))).done());
}

TEST_F(RecoveryTest, a_script_that_can_grow_no_more_is_said_and_what_it_holds_is_kept) {
  auto window = open(test::asset("torus.off"));
  window->run("split 0-1");
  const std::uint64_t hash = window->session.mesh().hash();
  // As on a full disk: the descriptor of the script is now one of a device that takes nothing.
  const int full = ::open("/dev/full", O_WRONLY);
  if (full < 0) GTEST_SKIP() << "no /dev/full";
  for (int descriptor = 3; descriptor < full; ++descriptor) {
    std::error_code ignored;
    const fs::path target = fs::read_symlink("/proc/self/fd/" + std::to_string(descriptor), ignored);
    if (target == window->autosave.script()->path()) ::dup2(full, descriptor);
  }
  ::close(full);
  const Outcome outcome = window->session.run("split 2-3");
  EXPECT_TRUE(outcome.done());
  EXPECT_NE(outcome.sentence.en.find("the disk is full"), std::string::npos) << outcome.sentence.en;
  EXPECT_EQ(window->session.run("split 4-5").sentence.en, "");
  window.reset();
  auto again = open_nothing();
  ASSERT_TRUE(again->session.run("recover 1").done());
  EXPECT_EQ(again->session.mesh().hash(), hash);
}

TEST_F(RecoveryTest, what_is_recovered_is_in_view) {
  auto crashed = open(files_.copy(test::asset("torus.off"), "a.off"));
  crashed->run("duplicate elements=f0..f95 by=60,0,0");
  crashed.reset();
  auto next = open_nothing();
  next->run("recover 1");
  const Session& session = next->session;
  for (const glm::dvec3& place : session.mesh().positions()) {
    const auto seen = project(session.view.camera, session.view.size, place);
    ASSERT_TRUE(seen);
    EXPECT_TRUE(seen->pixel.x > 0 && seen->pixel.x < session.view.size.width) << seen->pixel.x;
    EXPECT_TRUE(seen->pixel.y > 0 && seen->pixel.y < session.view.size.height) << seen->pixel.y;
  }
}

TEST_F(RecoveryTest, without_a_window_nothing_is_kept_unless_asked) {
  const std::string path = files_.copy(test::asset("torus.off"), "a.off");
  const std::string variable = "XDG_STATE_HOME=" + state_.path().string();
  ASSERT_EQ(test::run_program({"edit", path, "--do", "split 0-1"}, {}, {variable}).exit_code, 0);
  EXPECT_TRUE(kept().empty());
  auto crashed = open(path);
  crashed->run("split 0-1");
  const std::string hash = "expect V " + std::to_string(crashed->session.mesh().live().vertices);
  crashed.reset();
  const auto listed = test::run_program({"edit", "--new", "--do", "recover list"}, {}, {variable});
  EXPECT_EQ(listed.exit_code, 0);
  EXPECT_NE(listed.err.find("1: " + path + ", 1 edit, "), std::string::npos) << listed.err;
  const std::string out = files_.at("out.off");
  const auto done =
      test::run_program({"edit", "--new", "--do", "recover 1; " + hash, "-o", out, "--lang", "ja"}, {}, {variable});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NE(done.err.find("1 件の編集を復元しました"), std::string::npos) << done.err;
  EXPECT_TRUE(fs::exists(out));
  EXPECT_EQ(kept().size(), 2u) << "only a window takes it over";
  // The file that a recovered document has is none that this line names.
  EXPECT_EQ(test::run_program({"edit", "--new", "--do", "recover 1; save"}, {}, {variable}).exit_code, 2);
  EXPECT_EQ(test::run_program({"edit", "--new", "--do", "recover discard 1"}, {}, {variable}).exit_code, 0);
  EXPECT_TRUE(kept().empty());
}

TEST_F(RecoveryTest, a_folder_that_cannot_be_read_is_not_an_empty_one) {
  Session session(std::make_unique<Document>());
  EXPECT_TRUE(session.run("recover list").done()) << "no folder, nothing lost";
  files_.write("file", "");
  setenv("XDG_STATE_HOME", files_.at("file").c_str(), 1);
  for (const char* line : {"recover list", "recover 1"}) {
    const Outcome outcome = session.run(line);
    EXPECT_EQ(outcome.exit_code, ExitCode::input_missing) << line;
    EXPECT_NE(outcome.sentence.en.find("cannot be read: a part of the path is not a folder"), std::string::npos)
        << outcome.sentence.en;
  }
}

// A recovered session is unsaved wherever its history stands, so its script stays when all is undone.
TEST_F(RecoveryTest, edits_that_are_all_undone_are_not_called_none) {
  struct Case {
    std::vector<std::string> behind_the_recovery;
    std::string listed, recovered;
    std::size_t position;
  };
  const std::string all_undone = "The edits are recovered, and are undone as they were: redo does them again.";
  const Case cases[] = {
      {{"undo 2"}, "all edits undone", all_undone, 0},
      {{"undo", "undo"}, "all edits undone", all_undone, 0},
      {{"split 2-3", "undo 3"}, "all edits undone", all_undone, 0},
      {{"undo 2", "redo", "undo"}, "all edits undone", all_undone, 0},
      {{"undo"}, "1 edit", "1 edit is recovered and not saved yet.", 1},
      {{"undo 2", "redo 2"}, "2 edits", "2 edits are recovered and not saved yet.", 2},
  };
  const std::string path = files_.copy(test::asset("torus.off"), "a.off");
  for (const Case& one : cases) {
    auto first = open(path);
    first->run("split 0-1");
    first->run("poke f3");
    first.reset();
    auto second = open_nothing();
    ASSERT_TRUE(list_lost_sessions(second->session.lost));
    ASSERT_TRUE(second->session.run("recover 1").done());
    for (const std::string& line : one.behind_the_recovery) second->run(line);
    second.reset();
    auto third = open_nothing();
    ASSERT_TRUE(list_lost_sessions(third->session.lost));
    ASSERT_EQ(third->session.lost.size(), 1u);
    const Text listed = describe(third->session.lost[0]);
    EXPECT_NE(listed.en.find("a.off, " + one.listed + ", 2"), std::string::npos) << listed.en;
    EXPECT_EQ(listed.ja.find("0 件"), std::string::npos) << listed.ja;
    EXPECT_EQ(third->session.run("recover 1").sentence.en, one.recovered);
    EXPECT_EQ(third->session.document().position(), one.position);
    third->autosave.finish();
  }
}

}  // namespace
}  // namespace ryosen
