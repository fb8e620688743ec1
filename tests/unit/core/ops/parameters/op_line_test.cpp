#include "ryosen/ops/parameters/op_line.h"

#include <gtest/gtest.h>

#include <set>

#include "ryosen/ops/all.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

std::optional<std::size_t> misfit(std::string_view id, std::string_view words) {
  const std::vector<std::string_view> list = split_words(words);
  return first_misfit(find_op(id)->line, op_arguments(list));
}

TEST(OpLine, places_may_be_empty_take_several_kinds_or_repeat) {
  EXPECT_EQ(misfit("collapse", "1-2"), std::nullopt);
  EXPECT_EQ(misfit("collapse", "1-2@f5 0,1e3,-2"), std::nullopt);
  EXPECT_EQ(misfit("collapse", "h5 mid"), std::nullopt);
  EXPECT_EQ(misfit("collapse", ""), 0u);
  EXPECT_EQ(misfit("collapse", "1"), 0u);
  EXPECT_EQ(misfit("collapse", "1-2 middle"), 1u);
  EXPECT_EQ(misfit("collapse", "1-2 mid mid"), 2u);
  EXPECT_EQ(misfit("make_face", "1 v2 v3@f5"), std::nullopt);
  EXPECT_EQ(misfit("make_face", "1 2 3 4 5"), std::nullopt);
  EXPECT_EQ(misfit("make_face", "1 2"), 2u);
  EXPECT_EQ(misfit("make_face", "1 2 3 4 f5"), 4u);
  EXPECT_EQ(misfit("detach", "f1 f2 f3"), std::nullopt);
  EXPECT_EQ(misfit("detach", "f1 f2 x"), 2u);
  EXPECT_EQ(misfit("separate_loop", "1 2 3-2"), std::nullopt);
  EXPECT_EQ(misfit("separate_loop", "1 2 3-2 f1"), 3u);
  EXPECT_EQ(misfit("weld", "1-2 3-4"), std::nullopt);
  EXPECT_EQ(misfit("weld", "1-2 3"), 1u);
  EXPECT_EQ(misfit("vertex_split", "1 - 1-2@f3"), std::nullopt);
  EXPECT_EQ(misfit("orient", ""), std::nullopt);
  EXPECT_EQ(misfit("orient", "1"), 0u);
}

TEST(OpLine, has_a_syntax) {
  const auto syntax = [](std::string_view id) { return syntax_of(find_op(id)->line); };
  EXPECT_EQ(syntax("collapse"), "A-B [start|end|mid|X,Y,Z]");
  EXPECT_EQ(syntax("make_face"), "A B C ...");
  EXPECT_EQ(syntax("extrude"), "fN [fM ...] [DISTANCE|X,Y,Z]");
  EXPECT_EQ(syntax("weld"), "A B [mid|X,Y,Z] | A-B C-D [mid]");
  EXPECT_EQ(syntax("delete"), "vN | A-B | fN");
  EXPECT_EQ(syntax("dissolve"), "A-B|vN");
  EXPECT_EQ(syntax("vertex_split"), "v L|v-L|- R|v-R|- [X,Y,Z]");
  EXPECT_EQ(syntax("make_edge"), "A B [P-A] [Q-B]");
  EXPECT_EQ(syntax("orient"), "");
}

TEST(OpLine, says_what_comes_next) {
  const auto next = [](std::string_view id, std::string_view words) {
    const std::vector<std::string_view> list = split_words(words);
    return next_element(find_op(id)->line, op_arguments(list));
  };
  EXPECT_EQ(next("collapse", ""), Element::Kind::edge);
  EXPECT_EQ(next("collapse", "0-1"), std::nullopt) << "a place";
  EXPECT_EQ(next("collapse", "x"), std::nullopt);
  EXPECT_EQ(next("weld", ""), Element::Kind::vertex);
  EXPECT_EQ(next("weld", "0-1"), Element::Kind::edge);
  EXPECT_EQ(next("weld", "0 1"), std::nullopt);
  EXPECT_EQ(next("separate_loop", "0 1"), Element::Kind::edge) << "before a face";
  EXPECT_EQ(next("detach", "f1 f2"), Element::Kind::face);
  EXPECT_EQ(next("move_vertex", "v0"), std::nullopt);
  EXPECT_EQ(next("orient", ""), std::nullopt);
}

TEST(OpLine, extrude_edges_takes_edges_by_their_slots) {
  const Mesh mesh = make_mesh(tetrahedron());
  const ParsedOp parsed = parse_line(mesh, "extrude_edges 0-1 h4 e5 -2");
  ASSERT_TRUE(parsed.op) << parsed.sentence.en;
  const auto& extrude = std::get<ExtrudeEdges>(*parsed.op);
  EXPECT_EQ(extrude.edges.size(), 3u);
  EXPECT_EQ(extrude.distance, -2);
}

// Every line that is printed reads back as the operator, or, where a name stands for a point and its copies, as one
// that is judged alike and gives the same mesh.
TEST(OpLine, reads_back_as_the_operator_it_was_printed_for) {
  Dice dice(5);
  std::size_t equal = 0, alike = 0;
  for (std::uint64_t seed = 0; seed < seed_count(60, 2000); ++seed) {
    const Mesh mesh = random_complex(seed);
    for (std::size_t place = 0; place < all_ops().size(); ++place) {
      const AnyOp op = random_op(mesh, place, dice);
      const std::string line = command_of(mesh, op);
      const ParsedOp parsed = parse_line(mesh, line);
      if (!parsed.op) {  // no line splits a vertex at no neighbour
        EXPECT_FALSE(check(mesh, op).legal()) << seed << " " << line << ": " << parsed.sentence.en;
        continue;
      }
      if (*parsed.op == op) {
        ++equal;
        continue;
      }
      const Verdict verdict = check(mesh, op), again = check(mesh, *parsed.op);
      if (verdict.has(Rule::different_faces)) continue;  // no line names corners of two faces
      ++alike;
      ASSERT_EQ(again.legal(), verdict.legal()) << seed << " " << line;
      if (!verdict.legal()) {
        EXPECT_EQ(again.reasons[0].rule, verdict.reasons[0].rule) << seed << " " << line;
      }
      EXPECT_EQ(command_of(mesh, *parsed.op), line) << seed;
      if (!verdict.legal()) continue;
      Mesh one = mesh, other = mesh;
      ASSERT_TRUE(try_apply(one, nullptr, op) && try_apply(other, nullptr, *parsed.op));
      EXPECT_EQ(one.hash(), other.hash()) << seed << " " << line;
    }
  }
  EXPECT_GT(equal, 10 * alike);
}

TEST(OpLine, every_operator_reads_its_own_lines_and_no_line_that_does_not_fit) {
  Dice dice(7);
  const std::vector<std::string> words{"0",     "v1",  "0-1", "1-2@f0", "~0-1@f1", "h3", "f0", "f1",
                                       "0,1,2", "0.5", "-",   "mid",    "back",    "x",  "1-", "f"};
  std::size_t understood = 0, fitting = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Mesh mesh = random_complex(seed);
    for (std::size_t place = 0; place < all_ops().size(); ++place) {
      const std::string line = command_of(mesh, random_op(mesh, place, dice));
      const std::vector<std::string_view> said = split_words(line);
      EXPECT_EQ(first_misfit(find_op(said[0])->line, op_arguments(std::span(said).subspan(1))), std::nullopt) << line;
      EXPECT_FALSE(fault_of_arguments(said[0], op_arguments(std::span(said).subspan(1)))) << line;
      const OpInfo& op = all_ops()[place];
      for (int i = 0; i < 60; ++i) {
        std::vector<std::string_view> arguments;
        for (int n = dice.below(4); n > 0; --n) arguments.push_back(words[dice.below(static_cast<int>(words.size()))]);
        const bool fits = !fault_of_arguments(op.id, op_arguments(arguments));
        const ParsedOp parsed = parse_op(mesh, op.id, op_arguments(arguments));
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

TEST(OpLine, what_is_expected_is_said_in_each_language) {
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
    const auto fault = fault_of_arguments(op.id, op_arguments(junk));
    ASSERT_TRUE(fault) << op.id;
    EXPECT_EQ(fault->ja.find("expected"), std::string::npos) << fault->ja;
    EXPECT_EQ(fault->ja.find(" or "), std::string::npos) << fault->ja;
  }
}

TEST(OpLine, tells_of_each_place_what_it_is_for) {
  const auto is_id = [](std::string_view id) {
    return !id.empty() && id.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == id.npos;
  };
  std::set<std::string> all;
  for (const OpInfo& op : all_ops())
    for (const OpParameters& list : op.line.all_lists()) {
      std::set<std::string_view> ids;
      for (const OpParameter& place : list) {
        const std::string where = std::string(op.id) + " " + std::string(place.id);
        EXPECT_TRUE(is_id(place.id)) << where;
        EXPECT_TRUE(ids.insert(place.id).second) << where << " is there twice";
        for (const std::string_view words : {place.name_en, place.name_ja, place.help_en, place.help_ja})
          EXPECT_FALSE(words.empty()) << where;
        EXPECT_FALSE(place.help_en.ends_with('.') || place.help_ja.ends_with("。"))
            << where << ": a clause, no sentence";
        EXPECT_TRUE(place.help_en.find_first_of(":;") == std::string_view::npos)
            << where << ": lists put these between";
        if (place.drag) all.insert(where);
        for (const OpValue& value : std::span(place.values).first(place.count()))
          EXPECT_TRUE(!place.is_told() || place.count() == 1 || !(value.name_en.empty() || value.name_ja.empty()))
              << where;
      }
    }
  EXPECT_EQ(all, (std::set<std::string>{"extrude by", "extrude_edges by", "split at"})) << "what is dragged";
}

}  // namespace
}  // namespace ryosen
