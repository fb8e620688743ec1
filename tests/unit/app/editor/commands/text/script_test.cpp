#include "app/editor/commands/text/script.h"

#include <gtest/gtest.h>

namespace ryosen {
namespace {

TEST(split_script, lines_semicolons_and_comments) {
  const auto lines = split_script("collapse 0-1 # first\n\n  swap 2-3 ;split 4-5 0.5;\r\n#nothing\nundo");
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].text, "collapse 0-1");
  EXPECT_EQ(lines[0].line, 1);
  EXPECT_EQ(lines[1].text, "swap 2-3");
  EXPECT_EQ(lines[1].line, 3);
  EXPECT_EQ(lines[2].text, "split 4-5 0.5");
  EXPECT_EQ(lines[2].line, 3);
  EXPECT_EQ(lines[3].line, 5);
}

TEST(split_script, braces_and_quotes_keep_their_text) {
  const auto lines = split_script("save \"a;b#c.obj\"; camera {\"eye\":[0,0,1]; }");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].text, "save \"a;b#c.obj\"");
}

TEST(did_you_mean, finds_slips_but_not_strangers) {
  const std::vector<std::string> known{"collapse", "swap", "split"};
  EXPECT_EQ(did_you_mean("colapse", known).en, "; did you mean collapse?");
  EXPECT_EQ(did_you_mean("sawp", known, HintForm::sentence).en, " Did you mean 'swap'?");
  EXPECT_EQ(did_you_mean("sawp", known).ja, "。swap ですか？");
  EXPECT_EQ(did_you_mean("elephant", known).en, "");
}

}  // namespace
}  // namespace ryosen
