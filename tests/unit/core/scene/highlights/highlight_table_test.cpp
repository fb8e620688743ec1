#include "ryosen/scene/highlights/highlight_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace ryosen {
namespace {

TEST(highlight_table, rows_say_what_they_mark_in_both_languages) {
  for (const HighlightRow& row : highlight_table()) {
    EXPECT_EQ(find_highlight(row.id), &row);
    EXPECT_NE(row.kinds.empty(), !row.has_predicate()) << row.id << " marks problems or has a predicate";
    for (std::string_view text : {row.name_en, row.name_ja, row.legend_en, row.legend_ja})
      EXPECT_FALSE(text.empty()) << row.id;
    EXPECT_NE(row.name_en, row.name_ja) << row.id;
    EXPECT_NE(row.legend_en, row.legend_ja) << row.id;
  }
  EXPECT_EQ(find_highlight("no_such_highlight"), nullptr);
}

TEST(highlight_table, problems_come_first_and_are_shown_at_first) {
  const auto rows = highlight_table();
  EXPECT_TRUE(
      std::is_partitioned(rows.begin(), rows.end(), [](const HighlightRow& row) { return !row.kinds.empty(); }));
  for (const HighlightRow& row : rows) EXPECT_EQ(row.is_shown_at_first(), !row.has_predicate()) << row.id;
}

TEST(highlight_table, whatever_is_listed_of_elements_of_the_mesh_can_be_drawn) {
  for (const ProblemRow& problem : problem_table()) {
    if (problem.kind == ProblemKind::nonfinite_vertex) continue;    // that has no place
    if (!problem.is_local() || problem.is_found_whole()) continue;  // one is seen where another is
    EXPECT_TRUE(std::any_of(highlight_table().begin(), highlight_table().end(), [&](const HighlightRow& row) {
      return row.kinds.contains(problem.kind);
    })) << problem.id;
  }
}

// All of what lies on one edge is seen: what is above leaves gaps, or is narrower than what it lies on.
TEST(highlight_table, no_line_hides_those_that_are_drawn_below_it) {
  std::set<std::size_t> ranks;
  const auto meets_none = [](const HighlightRow& row) { return row.id == "isolated" || row.id == "wires"; };
  for (const HighlightRow& above : highlight_table()) {
    EXPECT_TRUE(ranks.insert(drawing_rank(above)).second) << above.id;
    for (const HighlightRow& below : highlight_table()) {
      if (drawing_rank(below) >= drawing_rank(above) || meets_none(above) || meets_none(below)) continue;
      EXPECT_TRUE(above.looks.line != LineStyle::solid || above.looks.width_px + 0.5f < below.looks.width_px)
          << above.id << " hides " << below.id;
    }
  }
  EXPECT_EQ(*ranks.rbegin() + 1, highlight_table().size());
}

TEST(highlight_table, marks_have_numbers_of_their_own) {
  std::set<std::uint16_t> numbers;
  for (const HighlightRow& row : highlight_table()) {
    const std::size_t before = numbers.size();
    for_each_mark(row, [&](Mark mark) {
      EXPECT_LT(mark.number, most_marks);
      EXPECT_TRUE(numbers.insert(mark.number).second) << row.id;
    });
    for_each_own_mark(row, [&](Mark mark) { EXPECT_LT(mark.number, own_marks) << row.id << " lies beneath problems"; });
    EXPECT_GT(numbers.size(), before) << row.id << " marks nothing";
  }
}

TEST(highlight_table, has_an_added_row_while_it_is_wanted) {
  const std::size_t before = highlight_table().size();
  {
    const ScopedHighlight added({.id = "even",
                                 .name_en = "Even",
                                 .name_ja = "偶数",
                                 .legend_en = "Vertices with an even number.",
                                 .legend_ja = "番号が偶数の頂点。",
                                 .vertex = [](Neighbourhood&, Vertex v) { return v.index % 2 == 0; },
                                 .looks = {0x00FF00, 0x00FF00, LineStyle::solid, 2, PointShape::disc, 4}});
    ASSERT_EQ(highlight_table().size(), before + 1);
    EXPECT_EQ(find_highlight("even"), &highlight_table().back());
  }
  EXPECT_EQ(highlight_table().size(), before);
  EXPECT_EQ(find_highlight("even"), nullptr);
}

}  // namespace
}  // namespace ryosen
