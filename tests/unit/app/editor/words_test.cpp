#include "app/editor/words.h"

#include <gtest/gtest.h>

#include <random>

#include "app/editor/script.h"

namespace ryosen {
namespace {

TEST(words, without_blanks_and_behind_word) {
  EXPECT_EQ(without_blanks(" \ta b\r "), "a b");
  EXPECT_EQ(without_blanks(" \t"), "");
  EXPECT_EQ(behind_word("open  a b.obj "), "a b.obj");
  EXPECT_EQ(behind_word(" save"), "");
}

TEST(words, file_names_as_they_are_typed) {
  EXPECT_EQ(file_name(" my mesh.obj "), "my mesh.obj");
  EXPECT_EQ(file_name("\" my;mesh#1.obj\""), " my;mesh#1.obj");
  EXPECT_EQ(file_name("a\\b.obj"), "a\\b.obj");
  EXPECT_EQ(file_name("\"a\\b \\\"c\\\".obj\""), "a\\b \"c\".obj");
  EXPECT_EQ(file_name("\""), "\"");
  EXPECT_EQ(file_name(""), "");
}

TEST(words, plain_names_stay_plain) {
  EXPECT_EQ(file_argument("/home/me/bunny-2.obj"), "/home/me/bunny-2.obj");
  EXPECT_EQ(file_argument("稜線.obj"), "稜線.obj");
  EXPECT_EQ(file_argument("a b"), "\"a b\"");
  EXPECT_EQ(file_argument(""), "\"\"");
}

TEST(words, every_name_survives_a_script) {
  constexpr std::string_view letters = "ab\\\"' ;#{}[]\t\r\nn@,%$\xE7\xA8\x9C";
  std::mt19937 random(11);
  for (int i = 0; i < 20000; ++i) {
    std::string name;
    for (auto n = random() % 9; n > 0; --n) name += letters[random() % letters.size()];
    const std::string line = "open " + file_argument(name);
    ASSERT_EQ(file_name(behind_word(line)), name) << line;
    for (const std::string& script : {line + "\nundo", line + "; undo", "undo;" + line + " # and so on\nredo"}) {
      const std::vector<ScriptLine> lines = split_script(script);
      ASSERT_GE(lines.size(), 2u) << script;
      const std::string& found = lines[lines[0].text == "undo" ? 1 : 0].text;
      ASSERT_EQ(found, line) << script;
    }
  }
}

}  // namespace
}  // namespace ryosen
