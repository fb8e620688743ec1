// What menus offer for a selection is what running it comes to.
#include "app/editor/operator_selection.h"

#include <gtest/gtest.h>

#include <random>

#include "app/editor/session.h"
#include "core/ops/each.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class OperatorSelection : public testing::Test {
 protected:
  void open(const char* asset_name) {
    auto document = Document::open(test::asset(asset_name));
    ASSERT_TRUE(document) << asset_name;
    session_.set_document(std::move(document).value());
  }
  Offer offer(std::string_view op) { return offer_on_selection(session_, *find_op(op)); }
  bool fits(std::string_view op) { return fits_selection(session_, *find_op(op)); }

  Session session_{std::make_unique<Document>()};
};

TEST_F(OperatorSelection, of_edges_in_the_middle_of_a_surface) {
  open("torus.off");
  ASSERT_TRUE(session_.run("select 0-1 1-2 2-3").done());
  EXPECT_FALSE(fits("vertex_split")) << "it takes vertices";
  EXPECT_TRUE(fits("fill"));
  EXPECT_FALSE(offer("fill").may_be) << "there is no hole at any of them";
  EXPECT_FALSE(offer("fill").why_not.empty());
  EXPECT_TRUE(offer("swap").may_be);
}

// Two at least go together: a vertex alone is welded to nothing.
TEST_F(OperatorSelection, of_one_that_is_united_with_another) {
  open("cube.obj");
  ASSERT_TRUE(session_.run("select v5").done());
  EXPECT_FALSE(fits("weld"));
  const Outcome outcome = session_.run("weld selected");
  EXPECT_EQ(outcome.exit_code, ExitCode::refused);
  EXPECT_NE(outcome.sentence.en.find("two vertices or more"), std::string::npos) << outcome.sentence.en;
  ASSERT_TRUE(session_.run("select v5 v6").done());
  EXPECT_TRUE(fits("weld"));
}

// What is told before is what happens: nothing that is refused or does not fit is done, and all else is; of what unites
// several, or what stands in place of what is selected, only the turns tell.
TEST_F(OperatorSelection, agrees_with_what_running_it_comes_to) {
  std::mt19937 random(13);
  int refused = 0, unfit = 0, done = 0;
  for (const char* const name : {"fan.obj", "cube.obj", "torus.off"}) {
    for (int round = 0; round < 12; ++round) {
      open(name);
      // Of one kind, and in each fourth round of any.
      std::string line = "select";
      for (auto n = 1 + random() % 3; n > 0; --n)
        line += std::string(" ") + "vef"[round % 4 == 3 ? random() % 3 : round % 3] + std::to_string(random() % 5);
      ASSERT_TRUE(session_.run(line).done()) << line;
      for (const OpInfo& op : all_ops()) {
        if (op.on_selection == OnSelection::none) continue;
        const bool does_fit = fits_selection(session_, op), may_be = offer_on_selection(session_, op).may_be;
        const CalledWith with = called_with(session_.mesh(), op, session_.selection, {});
        const Outcome outcome = session_.run(std::string(op.id) + " selected");
        const bool is_known = op.on_selection == OnSelection::all || op.on_selection == OnSelection::each;
        if (is_known && !with.is_in_place)
          EXPECT_EQ(outcome.done(), does_fit && may_be) << name << ": " << line << "; " << op.id;
        else
          EXPECT_FALSE(outcome.done() && !(does_fit && may_be)) << name << ": " << line << "; " << op.id;
        unfit += !does_fit;
        refused += !may_be;
        if (!outcome.done()) continue;
        ++done;
        ASSERT_TRUE(session_.run("undo").done());
        ASSERT_TRUE(session_.run(line).done());
      }
    }
  }
  EXPECT_GT(unfit, 20);
  EXPECT_GT(refused, 20);
  EXPECT_GT(done, 20);
}

}  // namespace
}  // namespace ryosen
