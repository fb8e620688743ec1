#include "app/editor/texts/remedy_text.h"

#include <gtest/gtest.h>

namespace ryosen {
namespace {

Text text_for(std::initializer_list<Rule> rules) {
  Verdict verdict;
  for (const Rule rule : rules) verdict.refuse(rule, {});
  return without_remedy(verdict);
}

TEST(remedy_text, never_is_said_only_where_nothing_can_help) {
  EXPECT_EQ(text_for({Rule::deleted}).en.find("never"), 0u);
  EXPECT_EQ(text_for({Rule::oriented}).en, "nothing to do");
  EXPECT_EQ(text_for({Rule::detached}).en, "nothing to do");
  for (const RuleText& row : rule_table()) {
    if (row.severity != RuleSeverity::refuse) continue;
    const Text text = text_for({row.rule});
    EXPECT_FALSE(text.en.empty() || text.ja.empty()) << row.id;
    const bool is_final = row.remedy_en.starts_with("never") || row.rule == Rule::deleted;
    EXPECT_EQ(text.en.find("never") != std::string::npos, is_final) << row.id << ": " << text.en;
  }
}

TEST(remedy_text, a_search_that_found_nothing_names_what_the_table_does) {
  const Text text = text_for({Rule::common_face, Rule::duplicate_face});
  EXPECT_NE(text.en.find("none was found"), std::string::npos);
  for (const Rule rule : {Rule::common_face, Rule::duplicate_face}) {
    EXPECT_NE(text.en.find(text_of(rule).remedy_en), std::string::npos);
    EXPECT_NE(text.ja.find(text_of(rule).remedy_ja), std::string::npos);
  }
}

TEST(remedy_text, advice_is_not_said_twice) {
  const Text twice = text_for({Rule::common_face, Rule::common_face});
  EXPECT_EQ(twice.en, text_for({Rule::common_face}).en);
  EXPECT_EQ(twice.ja, text_for({Rule::common_face}).ja);
}

}  // namespace
}  // namespace ryosen
