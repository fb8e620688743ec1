#include "ryosen/base/codes.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace {

using namespace ryosen;

TEST(codes, each_stands_once_in_the_table_with_a_sentence_in_both_languages) {
  std::set<std::string_view> ids;
  for (const CodeRow& row : code_table()) {
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_EQ(row.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string_view::npos) << row.id;
    EXPECT_TRUE(row.en.ends_with(".")) << row.id;
    EXPECT_TRUE(row.ja.ends_with("。")) << row.id;
  }
}

TEST(codes, are_compared_with_each_other_and_with_texts) {
  const Code code = "empty_file", same = "empty_file", other = "zeros";
  EXPECT_TRUE(code == same);
  EXPECT_FALSE(code == other);
  EXPECT_TRUE(code == "empty_file");
  EXPECT_FALSE(code == std::string("zeros"));
  EXPECT_EQ(code.row().severity, CodeSeverity::error);
}

}  // namespace
