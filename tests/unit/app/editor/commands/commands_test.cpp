// The rows of the table of commands say all that others need to know: held for every row, and for one that is new.
#include "app/editor/commands/commands.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "app/cli/run.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/recovery/autosave.h"
#include "app/editor/session/session.h"
#include "tests/support/app/probe_command.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

using test::probe_row;

TEST(commands, every_row_is_whole) {
  std::set<std::string_view> ids;
  for (const CommandRow* const at : command_table()) {
    const CommandRow& row = *at;
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_FALSE(row.help_en.empty() || row.help_ja.empty()) << row.id;
    ASSERT_TRUE(row.run) << row.id;
    ASSERT_TRUE(find_command_row(row.id)) << row.id;
    EXPECT_EQ(find_command_row(row.id)->effect, row.effect) << row.id;
    for (std::string_view alias : split_words(row.aliases))  // or a command that sends what is not its own
      EXPECT_TRUE(find_command_row(alias)->id == row.id || find_command_row(alias)->sends) << alias;
    // Who touches files is not tried to see what is wrong with its arguments.
    EXPECT_TRUE(row.fault || row.file == FileAccess::none) << row.id;
  }
  for (const OpInfo& op : all_ops()) EXPECT_EQ(find_command_row(op.id)->effect, Effect::edits) << op.id;
}

TEST(commands, a_line_has_the_properties_that_its_arguments_give_it) {
  const auto effect = [](const char* line) { return call_of(line)->effect; };
  EXPECT_EQ(effect("flip 0-1"), Effect::edits) << "an alias";
  EXPECT_EQ(effect("undo 2"), Effect::steps);
  EXPECT_EQ(effect("recover 1"), Effect::replaces);
  EXPECT_EQ(effect("recover list"), Effect::view);
  EXPECT_EQ(effect("recover discard 1"), Effect::view);
  EXPECT_TRUE(call_of("recover 1")->is_long);
  EXPECT_FALSE(call_of("recover")->is_long);
  EXPECT_EQ(effect("key Ctrl+Z"), Effect::steps) << "what the key sends";
  EXPECT_EQ(file_of(*call_of("open  \"a b.obj\" ")), "a b.obj");
  EXPECT_EQ(file_of(*call_of("key F12")), "");
  EXPECT_EQ(file_of(*call_of("save")), "");
  EXPECT_EQ(file_of(*call_of("split 0-1")), "");
  EXPECT_FALSE(call_of("nonsense") || call_of(""));
}

TEST(commands, one_that_is_new_is_kept_for_after_a_crash) {
  const test::TemporaryFolder state;
  setenv("XDG_STATE_HOME", state.path().c_str(), 1);
  const ScopedCommand probe(probe_row());
  std::uint64_t hash = 0;
  {
    Session crashed(std::make_unique<Document>());
    Autosave autosave(recovery_folder());
    crashed.frontend.autosave = &autosave;
    autosave.begin(crashed.document());
    for (const char* line : {"make_vertex 1,1,1", " probe  2", "make_edge v0 v1"})
      ASSERT_TRUE(crashed.run(line).done()) << line;
    EXPECT_EQ(crashed.log()[1], "probe  2");
    hash = crashed.mesh().hash();
  }
  Session again(std::make_unique<Document>());
  ASSERT_TRUE(again.run("recover").done());
  const Outcome outcome = again.run("recover 1");
  EXPECT_TRUE(outcome.done()) << outcome.sentence.en;
  EXPECT_EQ(again.mesh().hash(), hash);
  EXPECT_EQ(again.log().size(), 3u);
  unsetenv("XDG_STATE_HOME");
}

TEST(commands, one_that_is_new_is_checked_before_a_script_runs_and_explained) {
  EXPECT_TRUE(fault_of_command("probe 2")) << "there is none";
  const ScopedCommand probe(probe_row());
  EXPECT_FALSE(fault_of_command("probe 2"));
  EXPECT_EQ(fault_of_command("probe x")->en, "probe needs a number");
  EXPECT_EQ(unknown_command("prove").sentence.en, "there is no command 'prove'; did you mean probe?");
  EXPECT_NE(test::run_here({"help", "edit"}).out.find("probe N"), std::string::npos);
  EXPECT_EQ(test::run_here({"edit", test::asset("cube.obj"), "--do", "probe 2; expect V 9; undo; expect V 8", "-q"})
                .exit_code,
            0);
  const auto [code, out, err] =
      test::run_here({"edit", test::asset("cube.obj"), "--do", "split 0-1; probe x", "-q", "--json"});
  EXPECT_EQ(code, 2);
  EXPECT_EQ(out.find("\"done\""), std::string::npos) << "nothing has run";
}

}  // namespace
}  // namespace ryosen
