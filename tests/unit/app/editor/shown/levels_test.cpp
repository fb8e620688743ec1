#include "app/editor/shown/levels.h"

#include <gtest/gtest.h>

#include <numeric>

#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"
#include "app/editor/textbook/playing.h"
#include "ryosen/algo/edge_rules.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/app/program.h"

namespace ryosen::test {
namespace {

class LevelsTest : public testing::Test {
 protected:
  Outcome say(const std::string& line) { return session_.run(line); }
  std::size_t faces() const { return session_.mesh().live().faces; }

  // A torus of triangles, as a file has it.
  std::string write_torus() const {
    const std::string file = folder_.at("torus.obj");
    Session session(std::make_unique<Document>());
    for (const std::string& line : {std::string("torus segments=24"), std::string("triangulate"), "save " + file})
      EXPECT_TRUE(session.run(line).done()) << line;
    return file;
  }

  TemporaryFolder folder_;
  Session session_{Document::open(write_torus()).value()};
};

TEST_F(LevelsTest, are_shown_beside_the_history_forward_and_back) {
  const std::uint64_t hash = session_.mesh().hash();
  const std::size_t all = faces();
  EXPECT_EQ(say("levels at 10").exit_code, ExitCode::refused) << "there are none yet";
  ASSERT_TRUE(say("levels").done());
  ASSERT_TRUE(session_.shown.levels());
  EXPECT_TRUE(session_.layout.is_shown(panel_opened_by(PanelOpener::levelled)));
  EXPECT_EQ(faces(), all);
  for (const std::size_t wanted : {all / 2, all / 4, all / 3, std::size_t{0}, all}) {
    const Outcome outcome = say("levels at " + std::to_string(wanted));
    ASSERT_TRUE(outcome.done()) << outcome.sentence.en;
    EXPECT_EQ(outcome.sentence.en.find(std::to_string(faces())), 0u) << outcome.sentence.en;
    if (wanted > 0) {
      EXPECT_LE(faces(), wanted);
    }
    EXPECT_FALSE(check_invariants(session_.mesh()));
  }
  ASSERT_TRUE(say("levels at " + std::to_string(all / 2)).done());
  EXPECT_TRUE(session_.document().history().empty());
  EXPECT_FALSE(session_.document().is_modified());
  EXPECT_TRUE(session_.log().empty());
  ASSERT_TRUE(say("levels close").done());
  EXPECT_EQ(session_.mesh().hash(), hash);
  EXPECT_FALSE(session_.shown.levels());
}

TEST_F(LevelsTest, are_kept_as_one_edit_that_a_script_does_again) {
  const std::uint64_t hash = session_.mesh().hash();
  ASSERT_TRUE(say("levels boundary=locked max_turn=60").done());
  ASSERT_TRUE(say("levels at 100").done());
  const std::uint64_t shown = session_.mesh().hash();
  ASSERT_TRUE(say("levels keep").done());
  EXPECT_EQ(session_.mesh().hash(), shown) << "what was shown is what is made";
  EXPECT_FALSE(session_.shown.levels());
  ASSERT_EQ(session_.log().size(), 1u);
  ASSERT_EQ(session_.document().position(), 1u);
  EXPECT_EQ(session_.log()[0].find("simplify faces=100 "), 0u) << session_.log()[0];
  EXPECT_NE(session_.log()[0].find("max_turn=60"), std::string::npos);
  ASSERT_TRUE(say("undo").done());
  EXPECT_EQ(session_.mesh().hash(), hash);
  ASSERT_TRUE(say(session_.log()[0]).done());
  EXPECT_EQ(session_.mesh().hash(), shown);
}

TEST_F(LevelsTest, undo_and_escape_leave_what_is_shown_of_them_and_take_back_no_edit) {
  ASSERT_TRUE(say("poke f0").done());
  const std::uint64_t hash = session_.mesh().hash();
  const std::vector<std::string> log = session_.log();
  ASSERT_TRUE(say("levels").done());
  ASSERT_TRUE(say("levels at 100").done());
  const Outcome left = say("key Ctrl+Z");
  EXPECT_TRUE(left.done());
  EXPECT_NE(left.sentence.en.find("levels of detail are left"), std::string::npos) << left.sentence.en;
  EXPECT_FALSE(session_.shown.levels());
  EXPECT_EQ(session_.mesh().hash(), hash);
  EXPECT_EQ(session_.document().position(), 1u);
  EXPECT_EQ(session_.log(), log) << "nothing to replay";
  ASSERT_TRUE(say("levels").done());
  EXPECT_TRUE(say("key Escape").done());
  EXPECT_FALSE(session_.shown.levels());
  EXPECT_EQ(session_.mesh().hash(), hash);
  ASSERT_TRUE(say("key Ctrl+Z").done());
  EXPECT_EQ(session_.document().position(), 0u);
}

TEST_F(LevelsTest, end_with_any_edit_of_the_mesh_once_that_is_seen) {
  ASSERT_TRUE(say("levels").done());
  ASSERT_TRUE(say("levels at 20").done());
  const std::size_t entries = session_.document().history().size();
  const Outcome refused = say("poke f0");
  EXPECT_EQ(refused.exit_code, ExitCode::refused);
  EXPECT_NE(refused.sentence.en.find("shows a level of detail"), std::string::npos) << refused.sentence.en;
  EXPECT_EQ(faces(), 20u);
  ASSERT_TRUE(say("select f0").done());
  const Outcome outcome = say("poke f0");
  ASSERT_TRUE(outcome.done());
  EXPECT_FALSE(session_.shown.levels());
  EXPECT_GT(faces(), 20u) << "the whole mesh was poked";
  EXPECT_EQ(session_.document().history().size(), entries + 1);
  EXPECT_EQ(say("levels at 20").exit_code, ExitCode::refused);
}

// What is no edit leaves them; what is about elements shows the mesh beneath, and says so.
TEST_F(LevelsTest, stay_where_nothing_is_edited) {
  ASSERT_TRUE(say("levels").done());
  ASSERT_TRUE(say("levels at 20").done());
  const auto is_at_level = [&] {
    return session_.shown.levels() && session_.shown.shows(ShownBy::level) && faces() <= 20;
  };
  const std::string file = folder_.at("saved.ply");
  for (const std::string& line : {std::string("collapse 0-0"), "open " + file, "save " + file}) {
    say(line);
    EXPECT_TRUE(is_at_level()) << line;
  }
  EXPECT_GT(Document::open(file).value()->mesh().live().faces, 20u) << "the mesh that is open is what is saved";
  const Outcome saved = say("save " + file);
  ASSERT_TRUE(saved.done());
  EXPECT_NE(saved.sentence.en.find("the open mesh, not the level that is shown"), std::string::npos)
      << saved.sentence.en;
  EXPECT_EQ(shown_name(session_), "Level of detail (beneath: saved.ply)");
  EXPECT_FALSE(say("select f999999").done());
  EXPECT_TRUE(is_at_level()) << "a refusal";
  const Outcome selected = say("select all");
  ASSERT_TRUE(selected.done());
  EXPECT_NE(selected.sentence.en.find("selected. The view shows the open mesh"), std::string::npos)
      << selected.sentence.en;
  EXPECT_GT(faces(), 20u);
  ASSERT_TRUE(say("levels at 20").done());
  EXPECT_TRUE(is_at_level());
}

TEST_F(LevelsTest, undo_and_redo_of_any_number_leave_them_and_do_nothing_else) {
  ASSERT_TRUE(say("poke f0").done());
  ASSERT_TRUE(say("poke f1").done());
  ASSERT_TRUE(say("undo").done());
  for (const char* const line : {"undo", "redo", "undo 1", "redo 1"}) {
    ASSERT_TRUE(say("levels").done());
    ASSERT_TRUE(say("levels at 20").done());
    const Outcome outcome = say(line);
    ASSERT_TRUE(outcome.done()) << line;
    EXPECT_NE(outcome.sentence.en.find("levels of detail are left"), std::string::npos) << outcome.sentence.en;
    EXPECT_FALSE(session_.shown.levels()) << line;
    EXPECT_EQ(session_.document().position(), 1u) << line;
  }
}

TEST_F(LevelsTest, are_not_spoken_of_where_another_mesh_is_opened) {
  ASSERT_TRUE(say("poke f0").done());
  ASSERT_TRUE(say("levels").done());
  ASSERT_TRUE(say("levels at 20").done());
  const Outcome outcome = say("open " + file_argument(asset("cube.obj")));
  ASSERT_TRUE(outcome.done());
  EXPECT_FALSE(session_.shown.levels());
  EXPECT_EQ(outcome.sentence.en.find("before its levels of detail"), std::string::npos) << outcome.sentence.en;
}

TEST_F(LevelsTest, refuse_words_that_no_mesh_makes_right) {
  for (const char* const line :
       {"levels at", "levels at x", "levels at 1 2", "levels keep 3", "levels faces=3", "levels ratio=0.5",
        "levels max_turn=0", "levels nothing", "account nothing", "account free free"})
    EXPECT_EQ(say(line).exit_code, ExitCode::usage) << line;
  EXPECT_FALSE(session_.shown.levels());
  Session empty(std::make_unique<Document>());
  EXPECT_EQ(empty.run("levels").exit_code, ExitCode::refused) << "there are no faces";
}

TEST_F(LevelsTest, account_of_a_simplification_is_there_until_the_next_change) {
  EXPECT_EQ(say("account").exit_code, ExitCode::refused);
  ASSERT_TRUE(say("simplify faces=100").done());
  EXPECT_FALSE(session_.findings().left_edges()) << "nobody has asked for it";
  const std::uint64_t hash = session_.mesh().hash(), revision = session_.document().revision();
  ASSERT_TRUE(say("account").done());
  EXPECT_EQ(session_.mesh().hash(), hash);
  EXPECT_EQ(session_.document().revision(), revision);
  EXPECT_EQ(session_.document().position(), 1u);
  const LeftEdges* const left_edges = session_.findings().left_edges();
  ASSERT_TRUE(left_edges);
  EXPECT_EQ(std::accumulate(left_edges->counts.begin(), left_edges->counts.end(), std::size_t{0}),
            session_.mesh().live().edges);
  for (const EdgeRuleRow& rule : edge_rule_table()) {
    const std::size_t count = left_edges->counts[static_cast<std::size_t>(rule.rule)];
    ASSERT_TRUE(say("account " + std::string(rule.id)).done());
    EXPECT_EQ(session_.selecting.selection.size(), count) << rule.id;
    for (const Element& e : session_.selecting.selection) EXPECT_EQ(e.kind, Element::Kind::edge);
  }
  const std::string free = std::to_string(left_edges->counts[static_cast<std::size_t>(EdgeRule::free)]);
  EXPECT_NE(say("account").sentence.en.find("free " + free), std::string::npos);
  ASSERT_TRUE(say("undo").done());
  EXPECT_EQ(say("account").exit_code, ExitCode::refused);
  ASSERT_TRUE(say("redo").done());
  EXPECT_NE(say("account").sentence.en.find("free " + free), std::string::npos) << "it is the same again";
  EXPECT_EQ(session_.mesh().hash(), hash);
  for (const std::string other : {"subdivide", "smooth", "remesh length=0.5"}) {
    ASSERT_TRUE(say(other).done());
    EXPECT_EQ(say("account").exit_code, ExitCode::refused) << "of edges " << other << " tells nothing";
  }
}

TEST_F(LevelsTest, account_is_made_at_once_where_its_panel_is_shown) {
  ASSERT_TRUE(say("panel levels on").done());
  ASSERT_TRUE(say("simplify faces=100").done());
  EXPECT_TRUE(session_.findings().left_edges());
}

TEST_F(LevelsTest, account_of_a_level_is_that_of_the_simplification_to_it) {
  ASSERT_TRUE(say("levels max_turn=40").done());
  ASSERT_TRUE(say("levels at 200").done());
  EXPECT_FALSE(session_.findings().left_edges());
  const Outcome of_level = say("account");
  ASSERT_TRUE(of_level.done()) << of_level.sentence.en;
  ASSERT_TRUE(session_.shown.levels()) << "they stay";
  EXPECT_LE(faces(), 200u) << "the level stays in the view";
  ASSERT_TRUE(session_.findings().left_edges());
  const std::vector<std::uint8_t> rules = session_.findings().left_edges()->rules;
  ASSERT_TRUE(say("account free").done());
  EXPECT_EQ(session_.selecting.selection.size(),
            session_.findings().left_edges()->counts[static_cast<std::size_t>(EdgeRule::free)]);
  session_.view.gizmo_kind = GizmoKind::move;
  EXPECT_FALSE(session_.pointing.gizmo()) << "nothing of a level is moved";
  ASSERT_TRUE(say("levels at 300").done());
  EXPECT_FALSE(session_.findings().left_edges()) << "that is another mesh";
  ASSERT_TRUE(say("levels at 200").done());
  ASSERT_TRUE(say("panel levels off").done());
  ASSERT_TRUE(say("levels keep").done());
  EXPECT_EQ(say("account").sentence.en, of_level.sentence.en);
  EXPECT_EQ(session_.findings().left_edges()->rules, rules);
}

TEST_F(LevelsTest, account_survives_a_look_at_the_levels) {
  ASSERT_TRUE(say("simplify faces=100").done());
  const std::string before = say("account").sentence.en;
  ASSERT_TRUE(say("levels").done());
  ASSERT_TRUE(say("levels at 50").done());
  ASSERT_TRUE(say("levels close").done());
  EXPECT_EQ(say("account").sentence.en, before);
}

}  // namespace
}  // namespace ryosen::test
