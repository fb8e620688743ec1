#include "ryosen/algo/repair/report.h"

#include <gtest/gtest.h>

#include "ryosen/algo/algorithm_table.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

RepairReport long_report() {
  RepairReport report;
  report.text = {"Done.", "完了。"};
  for (const ProblemKind kind :
       {ProblemKind::nonmanifold_edge, ProblemKind::misoriented_edge, ProblemKind::isolated_vertex})
    report.findings.push_back({kind, 5, 2});
  for (const char* const reason : {"reason A", "reason B", "reason C", "reason D"})
    report.left.push_back({{reason, reason}, {Vertex(0)}, false});
  return report;
}

TEST(repair_report, counts_what_it_does_not_tell) {
  const RepairReport report = long_report();
  const Mesh mesh;
  EXPECT_EQ(told(report, mesh).en.find("more"), std::string::npos);
  const std::string some = told(report, mesh, 6).en, few = told(report, mesh, 0).en;
  EXPECT_NE(some.find("one vertex: reason A; one vertex: reason B; one vertex: reason C; and one more."),
            std::string::npos)
      << some;
  EXPECT_NE(few.find(", and 2 more. Left: one vertex: reason A; and 3 more."), std::string::npos) << few;
  EXPECT_NE(told(report, mesh, 0).ja.find("ほか 3 件"), std::string::npos) << told(report, mesh, 0).ja;
}

TEST(repair_report, says_in_a_few_words_how_much) {
  RepairReport report = long_report();
  report.problems = 4;
  EXPECT_EQ(in_short(report).en, "Done. 4 problems are left.");
  EXPECT_EQ(in_numbers(report).en, "No change. 4 problems are left.");
  report.changed = 3;
  report.problems = 1;
  EXPECT_EQ(in_numbers(report).en, "3 changes. One problem is left.");
  EXPECT_EQ(in_numbers(report).ja, "変更 3 件。問題が 1 件残ります。");
  report.problems = 0;
  report.others = 2;
  EXPECT_EQ(in_numbers(report).en, "3 changes. 2 elements stay as they are.");
  EXPECT_EQ(in_numbers(report).ja, "変更 3 件。2 要素はそのまま残ります。");
  report.others = 0;
  report.changed = 1;
  EXPECT_EQ(in_numbers(report).en, "One change.");
}

TEST(repair_report, says_in_one_clause_what_was_done_or_why_nothing_was) {
  RepairReport report;
  report.changed = report.problems = 1;
  report.text = {"One hole was filled by 4 triangles; 1 could not be: it crosses (6-7).",
                 "穴を 1 個ふさぎました（三角形 4）。ふさげない穴 1：交わるため (6-7)。"};
  EXPECT_EQ(in_one_clause(report).en, "One hole was filled by 4 triangles. One problem is left.");
  EXPECT_EQ(in_one_clause(report).ja, "穴を 1 個ふさぎました。問題が 1 件残ります。");
  report.text = {"One hole was filled. 3 points were welded.", "穴を 1 個ふさぎました。3 点をつなぎました。"};
  EXPECT_EQ(in_one_clause(report).en, in_numbers(report).en) << "the first of several would not be all";
  report.changed = report.problems = 0;
  report.others = 2;
  report.left.push_back({{"there is a face ('Orient' first)", "面があるため（先に「揃える」）"}, {Edge(0)}, false});
  EXPECT_EQ(in_one_clause(report).en, "No change: there is a face.");
  EXPECT_EQ(in_one_clause(report).ja, "変更なし：面があるため。");
}

// The sheets of a fin that are taken apart keep two points at one place, which nobody lists as a problem.
TEST(repair_report, counts_as_problems_what_a_list_of_problems_has) {
  const auto report_by = [](const Mesh& mesh, std::initializer_list<std::string_view> repairs, bool in_rounds) {
    RepairCall call{{}, in_rounds};
    for (const std::string_view id : repairs) {
      const AlgorithmRow& row = *find_algorithm(id);
      ParameterValues values(row.parameters);
      if (!row.parameters.empty() && row.parameters[0].is_required) values.set(row.parameters[0].id, "0", {});
      call.steps.push_back({&row, std::move(values)});
    }
    return try_repair(mesh, call, {}, {}).value();
  };
  const RepairReport apart = report_by(test::make_mesh(test::fin()), {"weld_equal", "detach_nonmanifold"}, true);
  EXPECT_EQ(apart.problems, 2u) << "the boundary loops of two sheets";
  EXPECT_EQ(apart.others, 2u) << "the points at the ends of the edge";
  const RepairReport twice =
      report_by(test::make_mesh(test::fin()), {"weld_equal", "weld_close", "detach_nonmanifold"}, true);
  EXPECT_EQ(twice.others, 2u) << "though both weldings leave them";
  const RepairReport twisted = report_by(test::make_mesh(test::moebius_strip()), {"orient"}, false);
  ASSERT_EQ(twisted.left.size(), 1u);
  EXPECT_EQ(twisted.problems, twisted.left[0].elements.size()) << "counted once, though told with its reason";
  EXPECT_EQ(twisted.others, 0u);
}

}  // namespace
}  // namespace ryosen
