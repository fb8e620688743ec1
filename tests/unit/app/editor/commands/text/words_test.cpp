#include "app/editor/commands/text/words.h"

#include <gtest/gtest.h>

#include <random>

#include "app/editor/commands/text/script.h"

namespace ryosen {
namespace {

TEST(words, without_blanks_and_behind_word) {
  EXPECT_EQ(without_blanks(" \ta b\r "), "a b");
  EXPECT_EQ(without_blanks(" \t"), "");
  EXPECT_EQ(behind_word("open  a b.obj "), "a b.obj");
  EXPECT_EQ(behind_word(" save"), "");
}

TEST(words, numbers_are_shown_short_and_names_as_they_are) {
  EXPECT_EQ(with_short_numbers("extrude f1 -0,-0,-0.16395576831283612"), "extrude f1 0,0,-0.163956");
  EXPECT_EQ(with_short_numbers("translate by=0.0014944814655063268,-1e-17,2 elements=v4,v7: 2 moved."),
            "translate by=0.00149448,-1e-17,2 elements=v4,v7: 2 moved.");
  EXPECT_EQ(with_short_numbers("平均曲率：-880.181286 ～ 1073.84404、平均 1.5"),
            "平均曲率：-880.181 ～ 1073.84、平均 1.5");
  EXPECT_EQ(with_short_numbers("Loops 1 → 3. Mean 0.123456789. Left: 1.23456789."),
            "Loops 1 → 3. Mean 0.123457. Left: 1.23457.");
  for (const char* const same :
       {"collapse 29161-29331 mid", "points seed=123456789", "scale 50%", "split 0-1 0.25", "select 12-0 h1234567890",
        "", "open a-0.1234567890.obj", "export 0.1234567890.obj", "open 1e5.obj", "v0.12345678", "by=1,2,3"})
    EXPECT_EQ(with_short_numbers(same), same);
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

TEST(words, text_behind_the_id_keeps_its_blanks) {
  for (const auto& [line, behind] :
       {std::pair{"swap 1-2", " 1-2"}, {"  save  a b \t", "  a b \t"}, {"undo", ""}, {"", ""}, {" ", ""}})
    EXPECT_EQ(behind_id(line), behind) << line;
}

}  // namespace
}  // namespace ryosen
