// Repairs that are tried before anybody runs them: the sentence is that of the deed, and the mesh stays as it is.
#include "app/editor/document/repair_trials.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

std::unique_ptr<Session> repair_session(const std::string& asset_name) {
  return std::make_unique<Session>(Document::open(test::asset(asset_name)).value());
}

constexpr std::string_view said_before = "Tried, not done: ";

TEST(repair_trials, would_says_what_the_repair_then_does_and_changes_nothing) {
  for (const char* file : {"duplicate_face.obj", "misoriented.obj", "fin.obj", "bow_tie.obj", "fan.obj",
                           "isolated_vertex.obj", "hanging_pair.obj", "collinear.obj"})
    for (const char* what : {"repair default", "repair fill_holes", "repair default,remove_degenerate,fill_holes=9"}) {
      SCOPED_TRACE(std::string(file) + ": " + what);
      const auto session = repair_session(file);
      const auto before = session->mesh().live();
      const std::string line = what;
      const Outcome would = session->run("would " + line);
      ASSERT_TRUE(would.done()) << would.sentence.en;
      EXPECT_EQ(session->mesh().live(), before);
      EXPECT_EQ(session->document().position(), 0u);
      EXPECT_TRUE(session->log().empty());
      ASSERT_TRUE(would.sentence.en.starts_with(said_before));
      const RepairReport* const tried_report = tried(session->document(), session->trials, line);
      ASSERT_NE(tried_report, nullptr) << "at once without a window";
      const RepairReport expected = *tried_report;
      ASSERT_TRUE(session->run(line).done());
      ASSERT_TRUE(session->findings().last_repair());
      EXPECT_EQ(session->findings().last_repair()->changed, expected.changed);
      EXPECT_EQ(session->findings().last_repair()->text.en, expected.text.en);
      ASSERT_EQ(session->findings().last_repair()->left.size(), expected.left.size());
      for (std::size_t i = 0; i < expected.left.size(); ++i) {
        EXPECT_EQ(session->findings().last_repair()->left[i].elements, expected.left[i].elements);
        EXPECT_NE(expected.left[i].reason.en, expected.left[i].reason.ja);
      }
      EXPECT_LE(session->document().position(), 1u) << "one entry of the history";
      EXPECT_EQ(session->document().position() == 1, expected.changed > 0);
    }
}

TEST(repair_trials, what_is_left_is_told_with_its_elements_and_what_is_for_it) {
  const auto session = repair_session("isolated_vertex.obj");
  const std::string said = session->run("would repair default").sentence.en;
  EXPECT_NE(said.find("\"Remove isolated vertices\" is for it (1: v3)"), said.npos) << said;
  EXPECT_NE(said.find("\"Weld close points\" or \"Fill holes\" is for it (1: "), said.npos) << said;
}

TEST(repair_trials, a_list_is_one_entry_that_undo_takes_back_and_the_log_does_again) {
  const auto session = repair_session("fin.obj");
  const std::uint64_t before = session->mesh().hash();
  ASSERT_TRUE(session->run("repair default").done());
  const std::uint64_t after = session->mesh().hash();
  EXPECT_NE(before, after);
  ASSERT_EQ(session->document().history().size(), 1u);
  EXPECT_EQ(session->log(), std::vector<std::string>{"repair default"});
  ASSERT_TRUE(session->run("undo").done());
  EXPECT_EQ(session->mesh().hash(), before);
  EXPECT_EQ(session->findings().last_repair(), nullptr) << "that was another mesh";
  const auto again = repair_session("fin.obj");
  ASSERT_TRUE(again->run(session->log().front()).done());
  EXPECT_EQ(again->mesh().hash(), after);
}

TEST(repair_trials, wrong_lists_say_what_is_wrong) {
  const auto session = repair_session("fin.obj");
  const std::pair<const char*, const char*> wrong[] = {
      {"repair default,fill_hole", "there is no repair 'fill_hole'; did you mean fill_holes?"},
      {"would repair fill_hole", "there is no repair 'fill_hole'; did you mean fill_holes?"},
      {"repair default=3", "default stands for several repairs and takes no number"},
      {"repair default 3", "repair"},
      {"would collapse 0-1", "would"},
      {"would", "would"},
  };
  for (const auto& [line, expected] : wrong) {
    const Outcome outcome = session->run(line);
    EXPECT_EQ(outcome.exit_code, ExitCode::usage) << line;
    EXPECT_NE(outcome.sentence.en.find(expected), std::string::npos) << line << ": " << outcome.sentence.en;
  }
  EXPECT_EQ(session->document().position(), 0u);
}

TEST(repair_trials, in_the_background_it_is_there_later_and_edits_meanwhile_are_safe) {
  const auto session = repair_session("stanford_bunny.obj");
  session->trials.in_background = true;
  ASSERT_EQ(tried(session->document(), session->trials, "repair fill_holes"), nullptr);
  ASSERT_TRUE(session->trials.share());
  for (int i = 0; i < 6000 && session->trials.share(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    session->prepare();
  }
  const RepairReport* const report = tried(session->document(), session->trials, "repair fill_holes");
  ASSERT_NE(report, nullptr);
  EXPECT_EQ(report->changed, 5u);
  EXPECT_EQ(tried(session->document(), session->trials, "repair default"), nullptr);
  ASSERT_TRUE(session->run("delete f0").done()) << "while the mesh may be copied";
  EXPECT_EQ(tried(session->document(), session->trials, "repair fill_holes"), nullptr) << "of another revision";
  EXPECT_TRUE(session->trials.share());
  session->trials.cancel();
  EXPECT_FALSE(session->trials.share());
}

}  // namespace
}  // namespace ryosen
