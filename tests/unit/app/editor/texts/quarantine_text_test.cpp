#include "ryosen/document/outcome.h"

#include <gtest/gtest.h>

#include "app/editor/session/session.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

constexpr const char* one_set_aside = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 1 2 2\nf 3 2 4\n";

TEST(quarantine_text, only_names_that_speak_of_such_a_face) {
  const std::vector<QuarantinedFace> quarantine{{1, 6, "repeated_corner", {0, 1, 1}, {}, {}},
                                                {12, 0, "face_too_few_corners", {0, 1}, {}, {}, {}}};
  for (const char* name : {"f1", "0-1@f1", "~0-1@f1", "v2@f1", "f12"})
    EXPECT_TRUE(quarantine_text(quarantine, name)) << name;
  for (const char* name : {"f2", "f", "f1x", "v1", "0-1", "0-1@f2", "0-1@", "", "e1", "face1"})
    EXPECT_FALSE(quarantine_text(quarantine, name)) << name;
  const Text text = *quarantine_text(quarantine, "f1");
  EXPECT_NE(text.en.find("set aside"), std::string::npos) << text.en;
  EXPECT_NE(text.en.find("v1 more than once"), std::string::npos) << text.en;
  EXPECT_NE(text.en.find("line 6"), std::string::npos) << text.en;
  EXPECT_NE(text.ja.find("6 行目"), std::string::npos) << text.ja;
  EXPECT_EQ(quarantine_text(quarantine, "f12")->en.find("line"), std::string::npos);
}

TEST(quarantine_text, commands_say_why_the_face_is_not_there) {
  const test::TemporaryFolder folder;
  auto document = Document::open(folder.write("q.obj", one_set_aside));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  for (const auto& [line, code] :
       std::vector<std::pair<const char*, ExitCode>>{{"select f1", ExitCode::usage},
                                                     {"split 0-1@f1", ExitCode::refused},
                                                     {"collapse 0-1@f1", ExitCode::refused},
                                                     {"expect legal split 0-1@f1", ExitCode::found_problems},
                                                     {"select v0@f1", ExitCode::usage}}) {
    const Outcome outcome = session.run(line);
    EXPECT_EQ(outcome.exit_code, code) << line;
    EXPECT_NE(outcome.sentence.en.find("f1 is set aside"), std::string::npos) << line << ": " << outcome.sentence.en;
    EXPECT_NE(outcome.sentence.en.find("line 6"), std::string::npos) << outcome.sentence.en;
    EXPECT_NE(outcome.sentence.ja.find("隔離"), std::string::npos) << outcome.sentence.ja;
    EXPECT_EQ(outcome.sentence.en.find("no longer"), std::string::npos) << outcome.sentence.en;
  }
}

TEST(quarantine_text, whichever_argument_speaks_of_the_face) {
  const test::TemporaryFolder folder;
  auto document = Document::open(folder.write("q.obj", one_set_aside));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  for (const char* line : {"detach f0 f1", "delete f1", "weld v0@f0 v1@f1"}) {
    const Outcome outcome = session.run(line);
    EXPECT_EQ(outcome.exit_code, ExitCode::refused) << line;
    ASSERT_EQ(outcome.reasons.size(), 1u) << line;
    EXPECT_EQ(outcome.reasons[0].rule, Rule::deleted);
    EXPECT_NE(outcome.sentence.en.find("f1 is set aside"), std::string::npos) << line << ": " << outcome.sentence.en;
  }
  EXPECT_TRUE(session.run("expect refused poke f1").done());
}

}  // namespace
}  // namespace ryosen
