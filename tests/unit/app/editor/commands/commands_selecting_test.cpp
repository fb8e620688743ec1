#include <gtest/gtest.h>

#include "app/editor/commands/commands.h"
#include "app/editor/preferences/keys.h"
#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

std::unique_ptr<Session> a_torus() {
  auto document = Document::open(test::asset("torus.off"));
  EXPECT_TRUE(document);
  return std::make_unique<Session>(std::move(document).value());
}

TEST(selecting, every_selector_is_a_command_and_its_key_sends_it) {
  const auto session = a_torus();
  for (const Selector& row : selectors()) {
    const bool has_usual = row.value == Selector::Value::none || !row.usual.empty();
    session->run("select v0 0-1 f0");
    const Outcome outcome = session->run(
        has_usual ? select_line(row)
                  : "select " + std::string(row.id) + (row.value == Selector::Value::map_range ? " area 0 1" : " 0.5"));
    EXPECT_TRUE(outcome.done()) << row.id << ": " << outcome.sentence.en;
    EXPECT_FALSE(outcome.sentence.en.empty()) << row.id;
    if (row.chord.empty()) continue;
    const auto key = find_key(row.chord);
    ASSERT_TRUE(key) << row.id;
    EXPECT_EQ(key->command, select_line(row));
    EXPECT_EQ(key->repeats, row.repeats);
  }
  EXPECT_TRUE(session->log().empty()) << "selecting is no edit";
}

TEST(selecting, is_about_the_elements_of_the_mode) {
  const auto session = a_torus();
  const auto live = session->mesh().live();
  for (const auto& [mode, count] : {std::pair<const char*, std::size_t>{"vertex", live.vertices},
                                    {"edge", live.edges},
                                    {"face", live.faces},
                                    {"halfedge", 2 * live.edges}}) {
    ASSERT_TRUE(session->run(std::string("mode ") + mode).done());
    ASSERT_TRUE(session->run("select all").done());
    EXPECT_EQ(session->selecting.selection.size(), count) << mode;
    ASSERT_TRUE(session->run("select invert").done());
    EXPECT_TRUE(session->selecting.selection.empty()) << mode;
  }
}

TEST(selecting, the_others_are_those_of_what_is_selected_in_any_mode) {
  auto document = Document::open(test::asset("cube.obj"));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  ASSERT_TRUE(session.run("mode edge").done());
  ASSERT_TRUE(session.run("select f0 f1 v3").done());
  ASSERT_TRUE(session.run("select invert").done());
  EXPECT_EQ(session.selecting.selection.count(Element::Kind::face), 4u);
  EXPECT_EQ(session.selecting.selection.count(Element::Kind::vertex), 7u);
  EXPECT_EQ(session.selecting.selection.count(Element::Kind::edge), 0u);
  ASSERT_TRUE(session.run("select none").done());
  ASSERT_TRUE(session.run("select invert").done());
  EXPECT_EQ(session.selecting.selection.count(Element::Kind::edge), 12u) << "of nothing all that the mode picks";
}

TEST(selecting, finds_all_problems_of_a_kind) {
  auto document = Document::open(test::asset("stanford_bunny.obj"));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  ASSERT_TRUE(session.run("select boundary_loop").done());
  EXPECT_EQ(session.selecting.selection.size(), session.findings().highlights().count(ProblemKind::boundary_loop));
  const Outcome unsearched = session.run("select self_intersection");
  EXPECT_TRUE(unsearched.done());
  EXPECT_NE(unsearched.sentence.en.find("since the last edit, as self_intersections does"), std::string::npos)
      << unsearched.sentence.en;
  EXPECT_TRUE(session.selecting.selection.empty());
  EXPECT_EQ(session.run("select quarantined_face").exit_code, ExitCode::usage) << "they are not in the mesh";
}

// Each row of the menu of problems sends its own line, though a selector may have the same id, and has no other's key.
TEST(selecting, every_problem_has_a_line_of_its_own) {
  auto document = Document::open(test::asset("cube.obj"));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  for (const char* line : {"new", "grid columns=3 rows=3", "delete f4", "unite_planar"})
    ASSERT_TRUE(session.run(line).done()) << line;
  std::size_t shared = 0;
  for (const ProblemRow& row : problem_table()) {
    if (!row.is_local() && !row.is_on_request()) continue;
    const std::string line = select_line(row);
    for (const KeyRow& key : key_table()) EXPECT_NE(key.command, line);
    ASSERT_TRUE(session.run(line).done()) << line;
    EXPECT_EQ(session.selecting.selection.size(), session.findings().highlights().count(row.kind)) << line;
    shared += find_selector(row.id) ? 1 : 0;
    if (row.kind != ProblemKind::ring) continue;
    ASSERT_EQ(session.selecting.selection.size(), 1u);
    const std::string face = session.selecting.selected_names()[0];
    EXPECT_EQ(face[0], 'f') << "and no edge";
    ASSERT_TRUE(session.run(select_line(row, face)).done());
  }
  EXPECT_GT(shared, 0u) << "else nothing was tried";
  EXPECT_EQ(session.run("select problem").exit_code, ExitCode::usage);
  EXPECT_EQ(session.run("select problem nonsense").exit_code, ExitCode::usage);
}

TEST(selecting, says_what_is_wrong_or_missing) {
  const auto session = a_torus();
  for (const char* line : {"select sides x", "select shorter", "select shorter -1", "select all 3", "select loop 2",
                           "select sides 3 4", "select add", "select toggle", "select nonsense", "select v99999"})
    EXPECT_EQ(session->run(line).exit_code, ExitCode::usage) << line;
  session->run("select none");
  for (const char* line :
       {"select grow", "select shrink", "select linked", "select loop", "select ring", "select flat"}) {
    const Outcome outcome = session->run(line);
    EXPECT_EQ(outcome.exit_code, ExitCode::refused) << line;
    EXPECT_NE(outcome.sentence.en.find("first"), std::string::npos) << line;
    EXPECT_FALSE(outcome.sentence.ja.empty()) << line;
  }
}

TEST(selecting, keeps_a_selection_under_any_name_in_quotes) {
  const auto session = a_torus();
  session->run("select f1 f2");
  for (const char* line : {"keep one", "keep \"second set\""}) ASSERT_TRUE(session->run(line).done()) << line;
  session->run("select none");
  ASSERT_TRUE(session->run("select kept \"second set\"").done());
  EXPECT_EQ(session->selecting.selected_names(), (std::vector<std::string>{"f1", "f2"}));
  ASSERT_TRUE(session->run("select kept one").done());
  const Outcome refused = session->run("keep second set");
  EXPECT_EQ(refused.exit_code, ExitCode::usage);
  EXPECT_NE(refused.sentence.en.find("quotes"), std::string::npos) << refused.sentence.en;
  ASSERT_TRUE(session->run("forget \"second set\"").done());
  EXPECT_FALSE(session->run("select kept \"second set\"").done());
}

TEST(selecting, says_what_a_word_may_stand_for) {
  const auto session = a_torus();
  const auto said = [&](const char* line) { return session->run(line).sentence; };
  EXPECT_TRUE(said("select boundary").en.ends_with("did you mean boundary_loop?")) << said("select boundary").en;
  EXPECT_TRUE(said("select degenerate").en.ends_with("degenerate_repeat or degenerate_area?"));
  EXPECT_NE(said("select nonmanifold").en.find("nonmanifold_edge or nonmanifold_vertex?"), std::string::npos);
  EXPECT_NE(said("select sharpp").en.find("did you mean sharp?"), std::string::npos);
  EXPECT_NE(said("select boundary").ja.find("boundary_loop"), std::string::npos);
  EXPECT_EQ(said("select nonsense").en.find("mean"), std::string::npos);
}

TEST(selecting, toggles_and_adds_many_at_once) {
  const auto session = a_torus();
  session->run("select f3 f1");
  ASSERT_TRUE(session->run("select add f1 f7 v2").done());
  EXPECT_EQ(session->selecting.selection, (std::vector<Element>{Face(3), Face(1), Face(7), Vertex(2)}));
  ASSERT_TRUE(session->run("select toggle f1 f9 v2").done());
  EXPECT_EQ(session->selecting.selection, (std::vector<Element>{Face(3), Face(7), Face(9)}));
}

TEST(select, as_another_kind_turns_the_mode_too) {
  auto document = Document::open(test::asset("cube.obj"));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  ASSERT_TRUE(session.run("select f0").done());
  ASSERT_TRUE(session.run("key Ctrl+1").done());
  EXPECT_EQ(session.selecting.selection.size(), 4u);
  EXPECT_EQ(session.selecting.mode, PickMode::vertex);
  ASSERT_TRUE(session.run("key Ctrl+3").done());
  EXPECT_EQ(session.selecting.selected_names(), std::vector<std::string>{"f0"});
  EXPECT_EQ(session.selecting.mode, PickMode::face);
  ASSERT_TRUE(session.run("key 2").done());
  EXPECT_EQ(session.selecting.selected_names(), std::vector<std::string>{"f0"}) << "without Ctrl the selection stays";
  ASSERT_TRUE(session.run("select none").done());
  EXPECT_EQ(session.run("select as_edges").exit_code, ExitCode::refused);
}

TEST(selecting, what_was_deleted_or_undone_is_refused_and_what_never_was_is_no_name) {
  for (const char* const command : {"select", "select add", "hide", "isolate", "measure"}) {
    Session session(Document::open(test::asset("cube.obj")).value());
    const auto exit_code = [&](const std::string& name) { return session.run(command + (" " + name)).exit_code; };
    ASSERT_TRUE(session.run("delete f0").done());
    EXPECT_EQ(exit_code("f0"), ExitCode::refused) << command;
    EXPECT_EQ(exit_code("f99"), ExitCode::usage) << command;
    ASSERT_TRUE(session.run("poke f1").done());
    ASSERT_TRUE(session.run("undo").done());
    EXPECT_EQ(exit_code("v8"), ExitCode::refused) << command << ": redo brings it back";
    EXPECT_EQ(exit_code("f0..f3"), ExitCode::done) << command << ": of a range those that live";
  }
}

}  // namespace
}  // namespace ryosen
