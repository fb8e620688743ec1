// `practice`: what is no answer to a question is not wrong, but a word too many.
#include <gtest/gtest.h>

#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

int answered(const std::string& kind, const std::string& word) {
  return run_program({"practice", asset("cube.obj"), "--kind", kind, "--seed", "3", "--answer", word}).exit_code;
}

TEST(practice_command, takes_for_an_answer_only_what_may_be_one) {
  for (const char* const kind : {"next", "twin", "record", "legal", "valence"}) {
    EXPECT_EQ(answered(kind, "banana"), 2) << kind;
    EXPECT_EQ(answered(kind, ""), 2) << kind;
    const Json asked = run_program({"practice", asset("cube.obj"), "--kind", kind, "--seed", "3", "--json"}).line();
    for (const Json& right : asked["answers"]) EXPECT_EQ(answered(kind, right.get<std::string>()), 0) << kind << right;
  }
  for (const char* const word : {"h0", "h1", "h2"})
    EXPECT_LE(answered("next", word), 1) << "an element, right or wrong: " << word;
  EXPECT_EQ(answered("valence", "17"), 1);
  EXPECT_EQ(answered("valence", "h1"), 2);
  EXPECT_EQ(answered("next", "17"), 2);
  EXPECT_EQ(answered("legal", "no"), 1) << "the rule is asked for";
  EXPECT_LE(answered("record", "none"), 1);
  EXPECT_LE(answered("record", "17"), 1);
}

TEST(practice_command, says_what_is_asked_for) {
  const ProgramRun run = run_program(
      {"practice", asset("cube.obj"), "--kind", "next", "--seed", "3", "--answer", "banana", "--lang", "en"});
  EXPECT_NE(run.err.find("the name of an element is asked for"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace ryosen::test
