#include "app/editor/commands/text/command.h"

#include <gtest/gtest.h>

#include <limits>

#include "app/editor/session/session.h"
#include "ryosen/algo/algorithm_table.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

AlgorithmCall call_of(std::string_view id) {
  const AlgorithmRow& row = *find_algorithm(id);
  return {&row, ParameterValues(row.parameters)};
}

// Two sessions with a cube: one is given values, the other the lines that say the same.
class CommandTest : public testing::Test {
 protected:
  static std::unique_ptr<Document> cube() { return std::move(Document::open(test::asset("cube.obj"))).value(); }
  void expect_same(const Command& value, const std::string& line) {
    const Outcome by_value = values_.run(value), by_line = lines_.run(line);
    EXPECT_EQ(by_value.exit_code, by_line.exit_code) << line;
    EXPECT_EQ(by_value.performed, by_line.performed) << line;
    EXPECT_EQ(by_value.sentence.en, by_line.sentence.en) << line;
    EXPECT_EQ(values_.log(), lines_.log()) << line;
    EXPECT_EQ(values_.mesh().hash(), lines_.mesh().hash()) << line;
    EXPECT_EQ(values_.document().history().size(), lines_.document().history().size()) << line;
  }

  Session values_{cube()}, lines_{cube()};
};

TEST_F(CommandTest, a_value_does_and_logs_what_its_line_does) {
  AlgorithmCall move = call_of("translate");
  move.values.set_place("by", {0.5, -1, 1e-3});
  move.values.set_length("falloff", 0.25);
  move.values.set_names("elements", {"v0", "f3"});
  expect_same(move, "translate by=0.5,-1,0.001 falloff=0.25 elements=v0,f3");
  AlgorithmCall turn = call_of("rotate");
  turn.values.set_number("angle", 30);
  expect_same(turn, "rotate angle=30");
  expect_same(SplitEdge{values_.mesh().halfedge(Face(0))},
              command_of(lines_.mesh(), SplitEdge{lines_.mesh().halfedge(Face(0))}));
  AlgorithmCall weld = call_of("weld_close");
  expect_same(weld, "weld_close");  // lacks its distance
  weld.values.set_length("distance", 0.01);
  weld.is_called_repair = true;
  expect_same(weld, "repair weld_close distance=0.01");
  AlgorithmCall stitch = call_of("stitch");
  expect_same(stitch, "stitch");
}

TEST_F(CommandTest, what_is_selected_is_what_is_selected_when_it_runs) {
  AlgorithmCall move = call_of("translate");
  move.values.set_place("by", {0, 0, 1});
  move.values.set_names("elements", {"selected"});
  expect_same(move, "translate by=0,0,1 elements=selected");  // nothing is
  for (Session* session : {&values_, &lines_}) ASSERT_TRUE(session->run("select f1 v0").done());
  expect_same(move, "translate by=0,0,1 elements=selected");
  EXPECT_EQ(values_.log().back(), "translate by=0,0,1 elements=f1,v0");
}

TEST_F(CommandTest, a_value_that_is_wrong_is_refused_as_its_line_is) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double wrong : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    AlgorithmCall move = call_of("translate");
    move.values.set_place("by", {wrong, 0, 0});
    const std::uint64_t before = values_.mesh().hash();
    EXPECT_EQ(values_.run(move).exit_code, ExitCode::usage);
    AlgorithmCall scale = call_of("scale");
    scale.values.set_number("factor", wrong);
    EXPECT_EQ(values_.run(scale).exit_code, ExitCode::usage);
    const SplitEdge split{values_.mesh().halfedge(Face(0)), 0.5, glm::dvec3(wrong, 0, 0)};
    EXPECT_EQ(values_.run(split).exit_code, ExitCode::usage);
    EXPECT_EQ(values_.mesh().hash(), before);
  }
  AlgorithmCall of_none = call_of("translate");
  of_none.values.set_place("by", {1, 0, 0});
  of_none.values.set_names("elements", {"v99"});
  expect_same(of_none, "translate by=1,0,0 elements=v99");
}

TEST_F(CommandTest, a_line_is_a_command_too) {
  expect_same("subdivide", "subdivide");
  expect_same("", "");
  expect_same("no_such_command 1", "no_such_command 1");
}

}  // namespace
}  // namespace ryosen
