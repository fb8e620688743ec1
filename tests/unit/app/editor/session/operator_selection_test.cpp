// What menus offer for a selection is what running it comes to.
#include "app/editor/session/operator_selection.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <set>

#include "app/editor/session/session.h"
#include "ryosen/ops/each.h"
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
  Offer offer(std::string_view op) { return offer_on_selection(session_.findings(), session_.selecting, *find_op(op)); }
  bool fits(std::string_view op) { return fits_selection(session_.findings(), session_.selecting, *find_op(op)); }

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

TEST_F(OperatorSelection, takes_the_elements_that_are_enough_alone_or_all_of_them) {
  const Elements elements{Face(2), Vertex(1), Face(0)};
  EXPECT_EQ(elements_taken(*find_op("detach"), elements, {}), (Elements{Face(2), Face(0)}));
  EXPECT_EQ(elements_taken(*find_op("make_face"), elements, {}), elements) << "one vertex is not enough";
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
        const bool does_fit = fits_selection(session_.findings(), session_.selecting, op),
                   may_be = offer_on_selection(session_.findings(), session_.selecting, op).may_be;
        const CalledWith with = called_with(session_.mesh(), op, session_.selecting.selection, {});
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

// Select all takes the kind of the mode, the edges at first; an operator on other elements takes all of its own.
TEST_F(OperatorSelection, of_everything_is_everything_that_the_operator_takes) {
  for (const char* const name : {"cube.obj", "torus.off", "fan.obj", "isolated_vertex.obj"}) {
    for (const OpInfo& op : all_ops()) {
      if (op.on_selection == OnSelection::none) continue;
      const std::string line = std::string(op.id) + " selected";
      std::set<std::pair<bool, std::uint64_t>> results;  // of the modes whose kind it does not take
      std::optional<std::pair<bool, std::uint64_t>> own;
      for (const auto& [mode, kind] : {std::pair("face", Element::Kind::face),
                                       {"edge", Element::Kind::edge},
                                       {"halfedge", Element::Kind::halfedge},
                                       {"vertex", Element::Kind::vertex}}) {
        SCOPED_TRACE(std::string(name) + ", " + mode + "; " + line);
        open(name);
        ASSERT_TRUE(session_.run(std::string("mode ") + mode).done());
        ASSERT_TRUE(session_.run("select all").done());
        const bool takes_it = takes(op, kind, {});
        const bool is_in_place = called_with(session_.mesh(), op, session_.selecting.selection, {}).is_in_place;
        const Outcome outcome = session_.run(line);
        EXPECT_EQ(outcome.sentence.en.find("nothing is selected that it works on"), std::string::npos)
            << outcome.sentence.en;
        const std::pair result(outcome.done(), session_.mesh().hash());
        if (takes_it && !own && op.on_selection == OnSelection::each) own = result;
        if (!takes_it && !is_in_place) results.insert(result);
        if (!outcome.done()) continue;
        // The log does the same without the kind of the mode, and without what is hidden.
        const std::vector<std::string> log = session_.log();
        open(name);
        for (const std::string& each : log) EXPECT_TRUE(session_.run(each).done()) << each;
        EXPECT_EQ(session_.mesh().hash(), result.second);
      }
      EXPECT_LE(results.size(), 1u) << name << ": " << line << " depends on the mode";
      if (own && !results.empty()) {
        EXPECT_EQ(*results.begin(), *own) << name << ": " << line;
      }
    }
  }
}

TEST_F(OperatorSelection, of_everything_that_is_seen_leaves_out_what_is_hidden) {
  open("torus.off");
  ASSERT_TRUE(session_.run("hide f0 f1 f2").done());
  ASSERT_TRUE(session_.run("select all").done());
  EXPECT_TRUE(fits("poke"));
  const std::uint32_t faces = session_.mesh().live().faces;
  ASSERT_TRUE(session_.run("poke selected").done());
  for (std::uint32_t f = 0; f < 3; ++f) EXPECT_TRUE(session_.mesh().is_alive(Face(f))) << f;
  EXPECT_EQ(session_.mesh().live().faces, 3 + 3 * (faces - 3));
  const std::vector<std::string> log = session_.log();
  const std::uint64_t hash = session_.mesh().hash();
  open("torus.off");
  for (const std::string& line : log) ASSERT_TRUE(session_.run(line).done()) << line;
  EXPECT_EQ(session_.mesh().hash(), hash) << "hiding is in no log";
}

TEST_F(OperatorSelection, of_a_part_is_that_part) {
  open("torus.off");
  for (const char* selecting : {"select 0-1 1-2", "select v0..v46", "select h0"}) {
    ASSERT_TRUE(session_.run(selecting).done());
    for (const char* op : {"reverse", "poke", "detach"}) {
      EXPECT_FALSE(fits(op)) << selecting << "; " << op;
      const Outcome outcome = session_.run(std::string(op) + " selected");
      EXPECT_EQ(outcome.exit_code, ExitCode::refused) << selecting << "; " << op;
    }
  }
  ASSERT_TRUE(session_.run("select none").done());
  EXPECT_FALSE(fits("reverse"));
}

TEST(operator_selection, of_everything_works_in_a_headless_script) {
  for (const char* const name : {"cube.obj", "torus.off", "fan.obj", "tetrahedron.off", "stanford_bunny.obj"}) {
    const auto run = test::run_program({"edit", test::asset(name), "--do", "select all; reverse selected"});
    EXPECT_EQ(run.exit_code, 0) << name << ": " << run.err;
  }
}

}  // namespace
}  // namespace ryosen
