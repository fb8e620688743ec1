#include "ryosen/ops/lines/syntax.h"

#include <gtest/gtest.h>

#include "ryosen/ops/all.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

std::optional<std::size_t> misfit(std::string_view syntax, std::string_view words) {
  const std::vector<std::string_view> list = split_words(words);
  return first_misfit(syntax, list);
}

TEST(form, items_that_may_be_missing_stand_for_others_or_repeat) {
  constexpr std::string_view collapse = "A-B [start|end|mid|X,Y,Z]";
  EXPECT_EQ(misfit(collapse, "1-2"), std::nullopt);
  EXPECT_EQ(misfit(collapse, "1-2@f5 0,1e3,-2"), std::nullopt);
  EXPECT_EQ(misfit(collapse, "h5 mid"), std::nullopt);
  EXPECT_EQ(misfit(collapse, ""), 0u);
  EXPECT_EQ(misfit(collapse, "1"), 0u);
  EXPECT_EQ(misfit(collapse, "1-2 middle"), 1u);
  EXPECT_EQ(misfit(collapse, "1-2 mid mid"), 2u);
  constexpr std::string_view make_face = "A B C ...";
  EXPECT_EQ(misfit(make_face, "1 v2 v3@f5"), std::nullopt);
  EXPECT_EQ(misfit(make_face, "1 2 3 4 5"), std::nullopt);
  EXPECT_EQ(misfit(make_face, "1 2"), 2u);
  EXPECT_EQ(misfit(make_face, "1 2 3 4 f5"), 4u);
  EXPECT_EQ(misfit("fN [fM ...]", "f1 f2 f3"), std::nullopt);
  EXPECT_EQ(misfit("fN [fM ...]", "f1 f2 x"), 2u);
  EXPECT_EQ(misfit("A B [fN] [P-A] [Q-B]", "1 2 3-2"), std::nullopt);
  EXPECT_EQ(misfit("A B [fN] [P-A] [Q-B]", "1 2 3-2 f1"), 3u);
  EXPECT_EQ(misfit("A B | A-B C-D", "1-2 3-4"), std::nullopt);
  EXPECT_EQ(misfit("A B | A-B C-D", "1-2 3"), 1u);
  EXPECT_EQ(misfit("v L|v-L|- R|v-R|- [X,Y,Z]", "1 - 1-2@f3"), std::nullopt);
  EXPECT_EQ(misfit("", ""), std::nullopt);
  EXPECT_EQ(misfit("", "1"), 0u);
}

TEST(form, every_operator_reads_its_own_lines_and_no_line_that_does_not_fit) {
  Dice dice(7);
  const std::vector<std::string> words{"0",     "v1",  "0-1", "1-2@f0", "~0-1@f1", "h3", "f0", "f1",
                                       "0,1,2", "0.5", "-",   "mid",    "back",    "x",  "1-", "f"};
  std::size_t understood = 0, fitting = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Mesh mesh = random_complex(seed);
    for (std::size_t place = 0; place < all_ops().size(); ++place) {
      const std::string line = command_of(mesh, random_op(mesh, place, dice));
      const std::vector<std::string_view> said = split_words(line);
      EXPECT_EQ(first_misfit(find_op(said[0])->syntax, std::span(said).subspan(1)), std::nullopt) << line;
      EXPECT_FALSE(fault_of_arguments(said[0], std::span(said).subspan(1))) << line;
      const OpInfo& op = all_ops()[place];
      for (int i = 0; i < 60; ++i) {
        std::vector<std::string_view> arguments;
        for (int n = dice.below(4); n > 0; --n) arguments.push_back(words[dice.below(static_cast<int>(words.size()))]);
        const bool fits = !fault_of_arguments(op.id, arguments);
        const Parsed<AnyOp> parsed = parse_op(mesh, op.id, arguments);
        fitting += fits;
        understood += parsed.op.has_value();
        std::string all(op.id);
        for (std::string_view word : arguments) all.append(" ").append(word);
        EXPECT_TRUE(fits || !parsed.op) << all;
      }
    }
  }
  EXPECT_GT(understood, 100u);
  EXPECT_GT(fitting, understood);
}

TEST(form, what_is_expected_is_said_in_each_language) {
  const Mesh mesh = make_mesh(tetrahedron());
  const auto japanese = [&](std::string_view line) { return parse_line(mesh, line).sentence.ja; };
  EXPECT_EQ(japanese("split 0-1 x"), "「x」は解釈できません。数 t または X,Y,Z を指定してください");
  EXPECT_EQ(japanese("collapse 0-1 x"), "「x」は解釈できません。start、end、mid、X,Y,Z のいずれかを指定してください");
  EXPECT_EQ(japanese("orient x"), "「x」は解釈できません。引数は付けられません");
  EXPECT_EQ(japanese("swap x"), "「x」は名前ではありません。A-B、A-B@f5、h12、e6 のいずれかの形で書いてください");
  EXPECT_EQ(japanese("poke x"), "「x」は名前ではありません。f3 の形で書いてください");
  EXPECT_EQ(japanese("colapse 0-1"), "「colapse 0-1」は解釈できません。演算子を指定してください");
  for (const OpInfo& op : all_ops()) {
    const std::string_view junk[] = {"?"};
    const auto fault = fault_of_arguments(op.id, junk);
    ASSERT_TRUE(fault) << op.id;
    EXPECT_EQ(fault->ja.find("expected"), std::string::npos) << fault->ja;
    EXPECT_EQ(fault->ja.find(" or "), std::string::npos) << fault->ja;
  }
}

}  // namespace
}  // namespace ryosen
