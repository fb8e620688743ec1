#include "tests/support/core/played_steps.h"

#include <gtest/gtest.h>

#include "ryosen/textbook/steps/all.h"

namespace ryosen::test {

using steps::Sequence;
using steps::Step;

Result<std::unique_ptr<Sequence>> play_or_refuse(std::string_view id, const Mesh& mesh,
                                                 const PlayArguments& arguments) {
  return steps::find_steps(id)->make(mesh, arguments);
}

std::unique_ptr<Sequence> played(std::string_view id, const Mesh& mesh, const PlayArguments& arguments) {
  auto sequence = play_or_refuse(id, mesh, arguments);
  EXPECT_TRUE(sequence.ok()) << id << ": " << sequence.failure().message.text.en;
  return std::move(sequence).value();
}

void replay(PlayedTables& tables, const Step& step) {
  for (const steps::RowChange& row : step.rows) {
    auto& fields = tables[row.table][row.row];
    const auto known = fields.find(row.field);
    if (known != fields.end()) {
      EXPECT_EQ(known->second, row.old_value.value_or("-")) << step.caption.en;
    }
    fields[row.field] = row.new_value.value_or("-");
  }
}

}  // namespace ryosen::test
