// The fields of operators: what they say is the line that runs.
#include "app/editor/shown/asked_values.h"

#include <gtest/gtest.h>

#include "app/editor/commands/command_syntax.h"
#include "app/editor/session/session.h"
#include "ryosen/algo/algorithm_table.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class AskedValuesOf : public testing::Test {
 protected:
  AskedValuesOf() {
    auto document = Document::open(test::asset("cube.obj"));
    session_.set_document(std::move(document).value());
  }
  std::unique_ptr<AskedValues> ask(std::string_view op, const std::string& selected = "") {
    EXPECT_TRUE(session_.run(selected.empty() ? "select none" : "select " + selected).done()) << selected;
    return ask_values(*find_op(op), session_.document(), session_.findings(), session_.selecting);
  }
  std::string line_of(const AskedValues& asked) const { return asked.command().line(session_.mesh()); }
  static bool may_run(const AskedValues& asked) { return !asked.fault(); }
  static void choose(AskedValues& asked, std::size_t field, std::string_view text) {
    asked.fields().at(field).text = text;
    asked.follow();
  }

  Session session_{std::make_unique<Document>()};
};

TEST_F(AskedValuesOf, an_operator_lead_to_what_may_be_written) {
  const auto asked = ask("extrude", "f0");
  ASSERT_EQ(asked->fields().size(), 3u);
  EXPECT_TRUE(may_run(*asked)) << "as usual";
  EXPECT_EQ(line_of(*asked), "extrude selected");
  EXPECT_FALSE(asked->fields()[1].is_shown || asked->fields()[2].is_shown);
  choose(*asked, 0, "DISTANCE");
  EXPECT_TRUE(asked->fields()[1].is_shown && !asked->fields()[2].is_shown);
  EXPECT_EQ(asked->lacking(), 1u);
  EXPECT_FALSE(may_run(*asked));
  choose(*asked, 1, "abc");
  EXPECT_FALSE(may_run(*asked));
  EXPECT_EQ(asked->lacking(), std::nullopt);
  choose(*asked, 1, "0.5");
  EXPECT_EQ(line_of(*asked), "extrude selected 0.5");
  ASSERT_TRUE(may_run(*asked));
  EXPECT_TRUE(session_.run(asked->command()).done());
  choose(*asked, 0, "X,Y,Z");
  EXPECT_EQ(asked->fields()[2].text, "") << "a way has no usual place";
  choose(*asked, 2, "0,0,1");
  EXPECT_EQ(line_of(*asked), "extrude selected 0,0,1");
}

TEST_F(AskedValuesOf, an_operator_have_words_that_are_ticked_or_chosen) {
  const auto swap = ask("swap", "0-1");
  ASSERT_EQ(swap->fields().size(), 1u);
  EXPECT_EQ(line_of(*swap), "swap selected");
  choose(*swap, 0, "on");
  EXPECT_EQ(line_of(*swap), "swap selected back");
  const auto collapse = ask("collapse", "0-1");
  choose(*collapse, 0, "mid");
  EXPECT_EQ(line_of(*collapse), "collapse selected mid");
  EXPECT_FALSE(collapse->fields().at(1).is_shown);
}

TEST_F(AskedValuesOf, an_operator_begin_in_the_middle_of_what_is_selected) {
  const auto poke = ask("poke", "f0");
  ASSERT_EQ(poke->fields().size(), 1u);
  const std::string line = line_of(*poke);
  EXPECT_EQ(std::count(line.begin(), line.end(), ','), 2) << line;
  EXPECT_TRUE(session_.run(poke->command()).done());
  const auto of_several = ask("poke", "f1 f2");
  EXPECT_EQ(line_of(*of_several), "poke selected") << "one place serves one";
}

TEST_F(AskedValuesOf, an_operator_fit_the_kind_of_what_is_selected) {
  EXPECT_EQ(ask("weld", "v0 v1")->fields().size(), 2u) << "in the middle, or at a position";
  EXPECT_EQ(ask("weld", "0-1 2-3")->fields().size(), 1u) << "in the middle";
  EXPECT_EQ(line_of(*ask("make_vertex")), "make_vertex");
  EXPECT_FALSE(may_run(*ask("make_vertex"))) << "the position is missing";
  const auto made = ask("make_vertex");
  choose(*made, 0, "1,2,3");
  EXPECT_EQ(line_of(*made), "make_vertex 1,2,3");
  EXPECT_TRUE(may_run(*made)) << "it works on nothing that is selected";
  EXPECT_FALSE(may_run(*ask("poke"))) << "nothing is selected";
  EXPECT_FALSE(may_run(*ask("poke", "0-1"))) << "it takes faces";
}

TEST_F(AskedValuesOf, an_operator_follow_what_is_selected) {
  const auto look_at = [&](AskedValues& asked, const std::string& selected) {
    ASSERT_TRUE(session_.run("select " + selected).done());
    asked.look_at_selection(session_.document(), session_.findings(), session_.selecting);
  };
  const auto weld = ask("weld", "v0 v1");
  choose(*weld, 0, "X,Y,Z");
  choose(*weld, 1, "1,2,3");
  look_at(*weld, "0-1 2-3");
  EXPECT_EQ(line_of(*weld), "weld selected") << "edges meet in the middle or at the first";
  const auto move = ask("move_vertex", "v0");
  const std::string first = line_of(*move);
  look_at(*move, "v6");
  EXPECT_NE(line_of(*move), first) << "another vertex begins at its own place";
  choose(*move, 0, "1,2,3");
  look_at(*move, "v0");
  EXPECT_EQ(line_of(*move), "move_vertex selected 1,2,3") << "what was written stays";
  look_at(*move, "f0");
  EXPECT_FALSE(may_run(*move));
}

// Whatever is chosen and written, the line has the syntax of the operator.
TEST_F(AskedValuesOf, each_operator_are_those_of_its_line) {
  int lines = 0;
  for (const OpInfo& op : all_ops()) {
    if (!has_values(op)) continue;
    for (const std::string selected : {"f0", "0-1", "v0", "v0 v1", "0-1 2-3"}) {
      const auto asked = ask(op.id, selected);
      const std::vector<ValueField> first = asked->fields();
      for (std::size_t i = 0; i < first.size(); ++i) {
        std::vector<std::string> choices{first[i].text};
        for (const Choice& choice : first[i].row.choices) choices.emplace_back(choice.id);
        if (first[i].row.kind == ParameterKind::flag) choices.emplace_back("on");
        for (const std::string& choice : choices) {
          choose(*asked, i, choice);
          for (ValueField& field : asked->fields())
            if (field.is_shown && field.text.empty() && field.row.kind == ParameterKind::number) field.text = "0.25";
          for (ValueField& field : asked->fields())
            if (field.is_shown && field.text.empty() && field.row.kind == ParameterKind::place) field.text = "1,2,3";
          if (!may_run(*asked)) continue;
          const std::string line = line_of(*asked);
          const auto fault = fault_of_command(line);
          EXPECT_FALSE(fault) << line << ": " << fault->en;
          ++lines;
        }
        asked->fields() = first;
        asked->follow();
      }
    }
  }
  EXPECT_GT(lines, 40);
}

TEST_F(AskedValuesOf, nothing_are_asked_where_elements_are_all_that_it_takes) {
  EXPECT_EQ(session_.run("values delete").exit_code, ExitCode::usage);
  EXPECT_EQ(session_.run("values no_such_thing").exit_code, ExitCode::usage);
  ASSERT_TRUE(session_.run("values smooth").done());
  ASSERT_TRUE(session_.run("values split").done());
  EXPECT_EQ(session_.layout.asked_operator, "split");
  EXPECT_EQ(session_.layout.asked_algorithm, "");
  for (const OpInfo& op : all_ops()) EXPECT_FALSE(has_values(op) && find_algorithm(op.id)) << op.id << " is two things";
}

}  // namespace
}  // namespace ryosen
