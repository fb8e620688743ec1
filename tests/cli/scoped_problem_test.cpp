// A kind of problem that the program does not have: its row is all that reports need.
#include <gtest/gtest.h>

#include "ryosen/analysis/problem_kinds.h"
#include "tests/support/app/contract.h"

namespace ryosen::test {
namespace {

ProblemRow far_row() {
  return {.kind = {},
          .id = "far_vertex",
          .severity = ProblemSeverity::problem,
          .name_en = "Far vertex",
          .name_ja = "遠い頂点",
          .one_en = "One vertex lies far away.",
          .many_en = "# vertices lie far away.",
          .many_ja = "遠い頂点が # 個あります。",
          .figure = "far_vertices",
          .figure_en = "Vertices that lie far away.",
          .figure_ja = "遠い頂点の数。",
          .vertex = [](Neighbourhood& around, Vertex v) { return around.mesh().position(v).x > 500; }};
}

TEST(scoped_problem, has_its_figure_and_its_findings_wherever_kinds_are_reported) {
  const TemporaryFolder folder;
  const std::string far = folder.write("far.obj", "v 0 0 0\nv 900 0 0\nv 0 1 0\nv 900 1 0\nf 1 2 3\nf 2 4 3\n");
  const auto check = [&](const std::vector<std::string>& flags) { return run_here({"check", far}, flags); };
  EXPECT_FALSE(check({"--json"}).line().contains("far_vertices"));
  EXPECT_EQ(check({"--fail-on", "far_vertex"}).exit_code, 2);
  const ScopedProblem added(far_row());

  const Json report = check({"--json"}).line();
  EXPECT_EQ(report["far_vertices"], 2);
  EXPECT_EQ(report["problems"].back()["kind"], "far_vertex");
  EXPECT_EQ(report["problems"].back()["elements"], Json::array({"v1", "v3"}));
  const std::vector<Json> contract = run_here({"help", "json", "--json"}).lines();
  EXPECT_EQ(keys_of(report), required_keys(contract, "check"));
  EXPECT_NE(check({"--lang", "en"}).out.find("PROBLEM far_vertex x2: 2 vertices lie far away."), std::string::npos);
  for (const auto& [language, name, figure] : {std::tuple("en", "Far vertex", "Vertices that lie far away."),
                                               std::tuple("ja", "遠い頂点", "遠い頂点の数。")}) {
    const std::string all = run_here({"help", "json", "--lang", language}).out;
    EXPECT_NE(all.find(figure), std::string::npos);
    EXPECT_NE(all.find(name), std::string::npos);
    EXPECT_NE(run_here({"help", "check", "--lang", language}).out.find(name), std::string::npos);
  }
  EXPECT_EQ(check({"--fail-on", "far_vertex"}).exit_code, 1);
  EXPECT_EQ(run_here({"check", asset("cube.obj"), "--fail-on", "far_vertex"}).exit_code, 0);
  EXPECT_NE(check({"--fail-on", "far_vertx", "--lang", "en"}).err.find("Did you mean 'far_vertex'?"),
            std::string::npos);
}

}  // namespace
}  // namespace ryosen::test
