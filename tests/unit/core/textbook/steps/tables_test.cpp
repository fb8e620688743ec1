// The tables along what is played equal a replay from the start, in whatever order they are asked for.
#include "ryosen/textbook/steps/tables.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "ryosen/textbook/steps/all.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

using Cells = std::map<std::tuple<std::string, std::string, std::string>, std::string>;

Cells cells_of(const steps::Tables& tables) {
  Cells cells;
  for (const auto& [table, rows] : tables.all())
    for (const auto& [row, fields] : rows)
      for (const auto& [field, value] : fields) cells[{table, row, field}] = value;
  return cells;
}

TEST(step_tables, equal_a_replay_at_each_step) {
  const Mesh mesh = make_mesh(torus_grid(4, 4));
  for (const auto& [id, arguments] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"pair", {"hash_16"}}, {"build", {}}, {"split3", {"1", "4"}}, {"collapse", {"0-1"}}}) {
    const auto sequence = steps::find_steps(id)->make(mesh, arguments);
    ASSERT_TRUE(sequence.ok()) << id;
    std::vector<Cells> replayed(1);
    for (std::size_t i = 1; i <= (*sequence)->size(); ++i) {
      Cells cells = replayed.back();
      for (const steps::RowChange& row : (*sequence)->at(i).rows) {
        if (row.new_value)
          cells[{row.table, row.row, row.field}] = *row.new_value;
        else
          cells.erase({row.table, row.row, row.field});
      }
      replayed.push_back(std::move(cells));
    }
    steps::TablesAlong tables(**sequence);
    for (std::size_t i = 0; i < replayed.size(); i += 7) EXPECT_EQ(cells_of(tables.at(i)), replayed[i]) << id << i;
    for (std::size_t i = replayed.size(); i-- > 0; i -= std::min<std::size_t>(i, 31))
      EXPECT_EQ(cells_of(tables.at(i)), replayed[i]) << id << i;
    EXPECT_EQ(cells_of(tables.at(replayed.size() - 1)), replayed.back());
  }
}

TEST(step_tables, rows_are_in_the_order_of_their_numbers) {
  steps::Tables tables;
  for (const char* const row : {"h10", "h2", "h1", "(10,2)", "(2,10)", "v1"}) tables.apply({{"t", row, "f", {}, "x"}});
  std::string order;
  for (const auto& [row, fields] : tables.rows_of("t")) order += row + " ";
  EXPECT_EQ(order, "(2,10) (10,2) h1 h2 h10 v1 ");
  tables.apply({{"t", "h2", "f", "x", {}}});
  EXPECT_EQ(tables.rows_of("t").count("h2"), 0u);
  EXPECT_TRUE(tables.rows_of("u").empty());
}

}  // namespace
}  // namespace ryosen
