#include "ryosen/algo/parameters.h"

#include <gtest/gtest.h>

#include "ryosen/algo/algorithm_table.h"

namespace ryosen {
namespace {

TEST(parameters, fields_are_called_by_their_labels_in_either_language) {
  const std::vector<ParameterRow>& rows = find_algorithm("weld_close")->parameters;
  ASSERT_EQ(rows.size(), 1u);
  const std::string en(rows[0].name_en), ja(rows[0].name_ja);
  EXPECT_NE(ja, rows[0].id);
  const auto read = [&](const std::string& text) { return read_fields(rows, std::vector<std::string>{text}); };
  const Text missing = read("").sentence, wrong = read("-1").sentence;
  EXPECT_TRUE(missing.en.starts_with(en + " is missing: ")) << missing.en;
  EXPECT_TRUE(missing.ja.starts_with(ja + " を指定してください：")) << missing.ja;
  EXPECT_TRUE(wrong.en.starts_with(en + " is ") && wrong.en.ends_with(", not '-1'")) << wrong.en;
  EXPECT_TRUE(wrong.ja.starts_with(ja + " は")) << wrong.ja;
  ASSERT_TRUE(read("0.1%").values);
  EXPECT_EQ(read("0.1%").values->line(), "distance=0.1%");
}

TEST(parameters, an_empty_field_leaves_what_stands_at_first) {
  const std::vector<ParameterRow>& rows = find_algorithm("fill_holes")->parameters;
  const ReadValues read = read_fields(rows, std::vector<std::string>(rows.size()));
  ASSERT_TRUE(read.values);
  EXPECT_EQ(read.values->line(), ParameterValues(rows).line());
}

}  // namespace
}  // namespace ryosen
