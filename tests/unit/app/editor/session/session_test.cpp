#include "app/editor/session/session.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/editor/commands/commands.h"
#include "app/editor/commands/expect.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/preferences/keys.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

// A flat sheet of 6 x 6 squares, each cut in two, seen from above.
std::unique_ptr<Session> sheet_session() {
  constexpr std::uint32_t n = 6;
  MeshFile file;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) file.mesh.positions.push_back({i, j, 0.0});
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    file.mesh.corners.insert(file.mesh.corners.end(), {a, b, c});
    file.mesh.face_offsets.push_back(static_cast<std::uint32_t>(file.mesh.corners.size()));
  };
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 2, d = a + n + 1;
      add(a, b, c);
      add(a, c, d);
    }
  }
  auto session = std::make_unique<Session>(std::make_unique<Document>(std::move(file)));
  EXPECT_TRUE(session->run("view front").done());
  return session;
}

glm::dvec2 pixel_of(const Session& session, const glm::dvec3& place) {
  return project(session.view.camera, session.view.size, place)->pixel;
}

TEST(session, a_click_sends_the_command_of_the_edge_under_it) {
  const auto clicked = sheet_session(), typed = sheet_session();
  // Along the edge from vertex 24 at (3,3) to 25 at (4,3), in its middle third: 24 is nearer and goes.
  const glm::dvec2 pixel = pixel_of(*clicked, {3.4, 3, 0});
  EXPECT_TRUE(clicked->pointing.click(pixel, "collapse").done());
  EXPECT_TRUE(typed->run("collapse 24-25 mid").done());
  EXPECT_EQ(clicked->mesh().hash(), typed->mesh().hash());
  EXPECT_EQ(clicked->log(), std::vector<std::string>{"collapse 24-25 mid"});
}

TEST(session, hovering_shows_the_verdict_and_leaves_the_mesh_alone) {
  const auto session = sheet_session();
  const MeshColumns before = session->mesh().columns();
  EXPECT_TRUE(session->run("tool collapse").done());
  session->pointing.point_at(pixel_of(*session, {3.5, 3, 0}));
  ASSERT_TRUE(session->selecting.hover() && session->selecting.hover()->op);
  EXPECT_TRUE(session->selecting.hover()->preview.verdict.legal());
  EXPECT_FALSE(session->selecting.hover()->preview.faces.empty());
  EXPECT_EQ(session->mesh().columns(), before);
  EXPECT_TRUE(session->run("tool swap").done());
  session->pointing.point_at(pixel_of(*session, {3.5, 0, 0}));
  ASSERT_TRUE(session->selecting.hover() && session->selecting.hover()->op);
  EXPECT_TRUE(session->selecting.hover()->preview.verdict.has(Rule::boundary));
}

TEST(session, a_refused_click_changes_nothing_and_says_why) {
  const auto session = sheet_session();
  const std::uint64_t before = session->mesh().hash();
  const Outcome outcome = session->pointing.click(pixel_of(*session, {3.5, 0, 0}), "swap");
  EXPECT_EQ(outcome.kind, Outcome::Kind::refused);
  EXPECT_EQ(outcome.exit_code, ExitCode::refused);
  EXPECT_NE(outcome.sentence.en.find("one side"), std::string::npos);
  EXPECT_FALSE(outcome.sentence.ja.empty());
  EXPECT_EQ(session->mesh().hash(), before);
  EXPECT_TRUE(session->log().empty());
}

TEST(session, picker_highlights_and_totals_follow_edits_as_if_made_anew) {
  const auto session = sheet_session();
  session->findings().picker();
  ASSERT_TRUE(session->run("show all").done());
  session->findings().highlights();
  session->findings().euler_terms();
  const std::vector<std::string> lines{"collapse 24-25 mid", "split 9-10", "swap 16-24", "collapse 0-1", "undo", "undo",
                                       "split 3-4 0.25",     "undo 2",     "redo"};
  for (const std::string& line : lines) {
    session->run(line);
    EXPECT_FALSE(check_invariants(session->mesh())) << line;
    HighlightSets fresh(session->mesh());
    for (const HighlightRow& row : highlight_table()) fresh.keep(session->mesh(), row);
    EXPECT_EQ(session->findings().highlights(), fresh) << line;
    EXPECT_EQ(session->findings().euler_terms(), euler_poincare(session->mesh())) << line;
    Picker anew(session->mesh());
    for (double x = 0.3; x < 6; x += 0.7) {
      for (double y = 0.2; y < 6; y += 0.9) {
        const glm::dvec2 pixel = pixel_of(*session, {x, y, 0});
        for (const PickMode mode : {PickMode::face, PickMode::edge, PickMode::vertex}) {
          const auto a =
              session->findings().picker().pick(session->mesh(), session->view.camera, session->view.size, pixel, mode);
          const auto b = anew.pick(session->mesh(), session->view.camera, session->view.size, pixel, mode);
          ASSERT_EQ(a.has_value(), b.has_value()) << line;
          if (!a) continue;
          EXPECT_EQ(a->element, b->element) << line;
        }
      }
    }
  }
}

TEST(session, lines_hang_on_the_surface_as_before_when_it_is_simplified_or_remeshed) {
  constexpr std::uint32_t side = 8;
  MeshFile file;
  for (std::uint32_t i = 0; i < (side + 1) * (side + 1); ++i)
    file.mesh.positions.emplace_back(i % (side + 1), i / (side + 1), 0.1 * (i % 3));
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const std::uint32_t a = i / side * (side + 1) + i % side;
    file.mesh.corners.insert(file.mesh.corners.end(), {a, a + 1, a + side + 2, a, a + side + 2, a + side + 1});
    file.mesh.face_offsets.insert(file.mesh.face_offsets.end(), {6 * i + 3, 6 * i + 6});
  }
  constexpr std::uint32_t inner = 40, outer = 4;
  const auto end = static_cast<std::uint32_t>(file.mesh.positions.size());
  file.mesh.positions.emplace_back(4, 4, 5);
  file.elements.items = {{.before_face = 0, .first = 0, .count = 3}};
  file.elements.vertices = {inner, end, outer};
  const std::vector<glm::dvec3> places = file.mesh.positions;
  Session session(std::make_unique<Document>(std::move(file)));
  for (const char* line : {"simplify faces=0 boundary=free", "simplify faces=0 effort=2", "remesh length=3",
                           "levels boundary=free; levels at 0; levels keep"}) {
    for (const ScriptLine& part : split_script(line)) ASSERT_TRUE(session.run(part.text).done()) << line;
    EXPECT_LT(session.mesh().live().vertices, places.size() - 10) << line;
    for (const std::uint32_t on_line : {inner, outer}) {
      ASSERT_TRUE(session.mesh().is_alive(Vertex(on_line))) << line;
      EXPECT_FALSE(session.mesh().is_isolated(Vertex(on_line))) << line;
      EXPECT_EQ(session.mesh().position(Vertex(on_line)), places[on_line]) << line;
    }
    ASSERT_TRUE(session.run("undo").done()) << line;
  }
}

TEST(session, vertices_on_lines_are_not_isolated_whatever_is_edited) {
  MeshFile file;
  for (int i = 0; i < 6; ++i) file.mesh.positions.push_back({i, i * i, 0});
  file.mesh.corners = {0, 1, 2};
  file.mesh.face_offsets = {0, 3};
  file.elements.items = {{.before_face = 1, .first = 0, .count = 3}};
  file.elements.vertices = {2, 3, 4};
  const std::vector<Vertex> on_lines{Vertex(2), Vertex(3), Vertex(4)};
  Session session(std::make_unique<Document>(std::move(file)));
  const auto isolated = [&] { return session.findings().highlights().of(ProblemKind::isolated_vertex).to_vector(); };
  EXPECT_EQ(isolated(), (std::vector<std::uint32_t>{5}));
  EXPECT_EQ(session.findings().euler_terms().isolated, 3) << "points without an edge";
  EXPECT_TRUE(session.findings().euler_terms().holds());
  for (const char* line : {"delete f0", "undo", "redo", "make_edge v3 v5", "undo"}) {
    ASSERT_TRUE(session.run(line).done()) << line;
    EXPECT_EQ(session.findings().highlights(), HighlightSets(session.mesh(), 0, on_lines)) << line;
    EXPECT_TRUE(session.findings().euler_terms().holds()) << line;
  }
  EXPECT_EQ(row_of(session.findings().kind().kind).id, "wires");
  EXPECT_EQ(session.findings().kind().reason.en, "There is no usable face; lines: 1.");
}

TEST(session, looks_for_creases_while_they_are_shown_and_no_longer) {
  const auto session = sheet_session();
  const HighlightRow& creases = *find_highlight("creases");
  EXPECT_FALSE(session->findings().highlights().keeps(creases));
  ASSERT_TRUE(session->run("move_vertex v24 3,3,1").done());
  EXPECT_FALSE(session->findings().highlights().keeps(creases));
  ASSERT_TRUE(session->run("show creases").done());
  ASSERT_TRUE(session->findings().highlights().keeps(creases));
  EXPECT_EQ(session->findings().highlights().count(creases), 12u) << "around the raised vertex";
  ASSERT_TRUE(session->run("undo").done());
  EXPECT_EQ(session->findings().highlights().count(creases), 0u);
  ASSERT_TRUE(session->run("show creases off").done());
  ASSERT_TRUE(session->run("redo").done());
  EXPECT_FALSE(session->findings().highlights().keeps(creases));
  ASSERT_TRUE(session->run("show creases on").done());
  EXPECT_EQ(session->findings().highlights().count(creases), 12u);
}

TEST(session, its_log_is_a_script_that_leads_to_the_same_mesh) {
  const auto session = sheet_session();
  for (const char* line : {"collapse 24-25 mid", "split 9-10", "undo", "swap 16-23", "split 3-4 0.25"})
    session->run(line);
  const auto replay = sheet_session();
  for (const std::string& line : session->log()) EXPECT_TRUE(replay->run(line).done()) << line;
  EXPECT_EQ(replay->mesh().hash(), session->mesh().hash());
}

// As the log of a window is replayed: one text, split again.
void replay(const Session& session, Session& into) {
  std::string text;
  for (const std::string& line : session.log()) text += line + "\n";
  for (const ScriptLine& line : split_script(text)) EXPECT_TRUE(into.run(line.text).done()) << line.text;
}

TEST(session, its_log_holds_file_names_of_any_kind) {
  const test::TemporaryFolder folder;
  for (const char* name :
       {"plain.obj", "two words.obj", "a;b #1.obj", "{\"quoted\"}.obj", " ends \\.obj", "line\nend.obj"}) {
    const auto session = sheet_session(), again = sheet_session();
    const std::string path = folder.at(name);
    ASSERT_TRUE(session->run("split 9-10").done());
    ASSERT_TRUE(session->run("save " + file_argument(path)).done()) << name;
    EXPECT_TRUE(folder.has(name));
    ASSERT_TRUE(session->run("swap 16-23").done());
    replay(*session, *again);
    EXPECT_EQ(again->mesh().hash(), session->mesh().hash()) << name;
    EXPECT_EQ(again->document().path(), path);

    ASSERT_TRUE(session->run("open " + file_argument(path)).done()) << name;
    ASSERT_TRUE(session->run("collapse 24-25 mid").done());
    replay(*session, *again);
    EXPECT_EQ(again->mesh().hash(), session->mesh().hash()) << name;
    EXPECT_EQ(again->document().path(), path);
  }
}

TEST(session, a_file_that_cannot_be_opened_is_refused_at_the_place_that_the_command_line_names) {
  const test::TemporaryFolder folder;
  const auto session = sheet_session();
  const std::string bad = folder.write("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1\n3 0 1 2\n");
  const Text sentence = session->run("open " + file_argument(bad)).sentence;
  EXPECT_TRUE(sentence.en.starts_with(bad + ":5:4: The vertex ")) << sentence.en;
  EXPECT_TRUE(sentence.ja.starts_with(bad + ":5:4：")) << sentence.ja;
  EXPECT_TRUE(test::run_program({"check", bad}).err.starts_with(bad + ":5:4: error: The vertex "));
  const std::string missing = folder.at("missing.off");
  EXPECT_EQ(session->run("open " + file_argument(missing)).sentence.en, "There is no file " + missing + ".")
      << "it is named once";
}

TEST(session, a_file_name_typed_with_blanks_is_logged_in_quotes) {
  const test::TemporaryFolder folder;
  const auto session = sheet_session();
  const std::string path = folder.at("two words.obj");
  ASSERT_TRUE(session->run("save  " + path + " ").done());
  EXPECT_EQ(session->log(), std::vector<std::string>{"save \"" + path + "\""});
}

TEST(session, outcomes_tell_what_was_done_to_the_mesh_and_to_files_only) {
  const test::TemporaryFolder folder;
  const auto session = sheet_session();
  session->frontend.take_picture = [](const std::filesystem::path&) { return success(); };
  const auto performed = [&](const std::string& line) { return session->run(line).performed; };
  EXPECT_EQ(performed("split 9-10"), "split 9-10");
  EXPECT_EQ(performed("key Ctrl+Z"), "undo");
  EXPECT_EQ(performed("redo 1"), "redo");
  EXPECT_EQ(performed("save " + folder.at("a.obj")), "save " + folder.at("a.obj"));
  EXPECT_EQ(performed("shot"), "shot ryosen.png");
  for (const char* line :
       {"panel open",  "panel none",  "quit",      "key Ctrl+Q", "frame selected", "frame all",   "view top",
        "select v3",   "select none", "tool swap", "mode face",  "show all",       "theme light", "cancel",
        "language ja", "expect V 50", "swap 0-1",  "redo",       "click 1,1",      "nonsense"})
    EXPECT_EQ(performed(line), "") << line;
}

TEST(session, nothing_selected_is_said_when_it_was_to_be_framed) {
  const auto session = sheet_session();
  const Outcome outcome = session->run("frame selected");
  EXPECT_TRUE(outcome.done());
  EXPECT_NE(outcome.sentence.en.find("nothing is selected"), std::string::npos);
  EXPECT_FALSE(outcome.sentence.ja.empty());
  ASSERT_TRUE(session->run("select v3").done());
  EXPECT_EQ(session->run("frame selected").sentence.en, "");
}

TEST(session, says_how_what_is_selected_is_given_where_another_value_comes_first) {
  Session session(std::move(Document::open(test::asset("cube.obj"))).value());
  ASSERT_TRUE(session.run("select v0 v1 v2 v5").done());
  const Outcome outcome = session.run("hull selected");
  EXPECT_EQ(outcome.exit_code, ExitCode::usage);
  EXPECT_NE(outcome.sentence.en.find("elements=selected"), std::string::npos) << outcome.sentence.en;
  EXPECT_EQ(outcome.sentence.en.find("v0"), std::string::npos) << "no word that nobody wrote: " << outcome.sentence.en;
  EXPECT_NE(session.run("torus selected").sentence.en.find("takes no elements"), std::string::npos);
  EXPECT_TRUE(session.run("hull elements=selected").done());
  EXPECT_TRUE(session.run("duplicate selected").done()) << "its first value is elements";
}

TEST(session, exit_codes_of_commands) {
  const auto session = sheet_session();
  const auto code = [&](const char* line) { return session->run(line).exit_code; };
  EXPECT_EQ(code("colapse 0-1"), ExitCode::usage);
  EXPECT_NE(session->run("colapse 0-1").sentence.en.find("did you mean collapse"), std::string::npos);
  EXPECT_EQ(code("collapse 0-999"), ExitCode::usage);
  EXPECT_EQ(code("collapse 0-40"), ExitCode::usage);
  EXPECT_EQ(code("collapse 8-9 sideways"), ExitCode::usage);
  EXPECT_EQ(code("swap 0-1"), ExitCode::refused);
  EXPECT_EQ(code("expect V 50"), ExitCode::found_problems);
  EXPECT_EQ(code("expect V 49"), ExitCode::done);
  EXPECT_EQ(code("expect legal collapse 24-25"), ExitCode::done);
  EXPECT_EQ(code("expect refused swap 0-1"), ExitCode::done);
  EXPECT_EQ(code("undo"), ExitCode::refused);
  EXPECT_EQ(code("collapse 24-25"), ExitCode::done);
  EXPECT_EQ(code("swap 24-31"), ExitCode::refused);
  EXPECT_TRUE(session->run("swap 24-31").reasons[0].rule == Rule::deleted);
  EXPECT_EQ(code("swap 8-16"), ExitCode::done);
  EXPECT_TRUE(session->run("swap 8-16").reasons[0].rule == Rule::deleted) << "the edge was there before the swap";
  EXPECT_EQ(code("camera {\"eye\":[0,0,5],\"target\":[0,0,0],\"up\":[0,1,0]}"), ExitCode::done);
  EXPECT_EQ(code("camera {\"eye\":[0,0,0],\"target\":[0,0,0]}"), ExitCode::usage);
  EXPECT_EQ(code("select v0 f3 8-9"), ExitCode::done);
  EXPECT_EQ(session->selecting.selection.size(), 3u);
  EXPECT_EQ(code("show nonsense"), ExitCode::usage);
  EXPECT_EQ(code("shot x.png"), ExitCode::no_backend);
}

TEST(session, more_undo_than_there_is_changes_nothing) {
  const auto session = sheet_session();
  session->run("split 8-9");
  session->run("split 9-10");
  const std::uint64_t before = session->mesh().hash();
  EXPECT_EQ(session->run("undo 5").exit_code, ExitCode::refused);
  EXPECT_EQ(session->mesh().hash(), before);
  EXPECT_TRUE(session->run("undo 2").done());
  EXPECT_EQ(session->run("redo 3").exit_code, ExitCode::refused);
  EXPECT_TRUE(session->run("redo 2").done());
  EXPECT_EQ(session->mesh().hash(), before);
}

TEST(session, expect_knows_that_a_deleted_edge_is_refused) {
  const auto session = sheet_session();
  session->run("split 8-9");
  EXPECT_TRUE(session->run("expect refused swap 8-9").done());
  EXPECT_EQ(session->run("expect legal swap 8-9").exit_code, ExitCode::found_problems);
  EXPECT_EQ(session->run("expect refused swap 0-40").exit_code, ExitCode::usage);
}

TEST(session, an_element_of_an_undone_edit_is_refused_and_redo_brings_it_back) {
  const auto session = sheet_session();
  ASSERT_TRUE(session->run("split 8-9").done());
  ASSERT_TRUE(session->run("swap 24-32").done());
  ASSERT_TRUE(session->run("undo 2").done());
  const std::uint64_t before = session->mesh().hash();
  const std::size_t position = session->document().position();
  for (const char* line : {"split 8-49", "swap 25-31"}) {  // a vertex and an edge that only the future has
    const Outcome outcome = session->run(line);
    EXPECT_EQ(outcome.kind, Outcome::Kind::refused) << line << ": " << outcome.sentence.en;
    EXPECT_EQ(outcome.exit_code, ExitCode::refused);
    ASSERT_EQ(outcome.reasons.size(), 1u);
    EXPECT_EQ(outcome.reasons[0].rule, Rule::deleted);
    EXPECT_NE(outcome.sentence.en.find("redo brings it back"), std::string::npos) << outcome.sentence.en;
    EXPECT_EQ(outcome.sentence.en.find("has been deleted"), std::string::npos) << outcome.sentence.en;
    EXPECT_FALSE(outcome.sentence.ja.empty());
  }
  EXPECT_EQ(session->mesh().hash(), before);
  EXPECT_EQ(session->document().position(), position);
  ASSERT_TRUE(session->run("redo 2").done());
  EXPECT_TRUE(session->run("expect legal split 8-49").done());
  const Outcome gone = session->run("swap 8-9");
  EXPECT_NE(gone.sentence.en.find("undo brings it back"), std::string::npos) << gone.sentence.en;

  ASSERT_TRUE(session->run("undo 2").done());
  ASSERT_TRUE(session->run("swap 8-16").done());
  EXPECT_EQ(session->run("split 8-49").exit_code, ExitCode::usage) << "that future is no more";
}

TEST(session, an_operator_on_the_whole_mesh_is_no_tool) {
  const auto session = sheet_session();
  EXPECT_EQ(session->run("tool orient").exit_code, ExitCode::usage);
  EXPECT_EQ(session->run("click 640,360 orient").exit_code, ExitCode::usage);
}

TEST(session, orienting_keeps_only_selected_points_and_faces) {
  MeshFile file;
  file.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  file.mesh.corners = {0, 1, 2, 1, 2, 3};
  file.mesh.face_offsets = {0, 3, 6};
  Session session(std::make_unique<Document>(std::move(file)));
  EXPECT_TRUE(session.run("select 0-1 f1").done());
  EXPECT_TRUE(session.run("orient").done());
  EXPECT_EQ(session.selecting.selection, std::vector<Element>{Face(1)});
}

TEST(session, every_key_sends_a_command_that_exists) {
  for (const KeyRow& key : key_table()) {
    const std::string_view id = split_words(key.command)[0];
    EXPECT_TRUE(find_command_row(id) || find_op(id)) << key.chord << ": " << key.command;
    EXPECT_FALSE(key.help_en.empty() || key.help_ja.empty());
    EXPECT_EQ(find_key(key.chord)->command, key.command) << "the chord stands twice: " << key.chord;
  }
}

TEST(document, saves_what_it_holds_and_knows_whether_it_is_modified) {
  const auto session = sheet_session();
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "ryosen_session_test.obj";
  EXPECT_TRUE(session->run("collapse 24-25 mid").done());
  EXPECT_TRUE(session->document().is_modified());
  EXPECT_TRUE(session->run("save " + path.string()).done());
  EXPECT_FALSE(session->document().is_modified());
  EXPECT_TRUE(session->run("undo").done());
  EXPECT_TRUE(session->document().is_modified());
  const auto again = Document::open(path);
  ASSERT_TRUE(again);
  EXPECT_EQ((*again)->mesh().live(), (ElementCounts{48, 117, 70}));
  std::filesystem::remove(path);
}

TEST(session, terms_follow_operators_that_change_boundaries_and_parts) {
  auto opened = Document::open(RYOSEN_SOURCE_DIR "/assets/cube.obj");
  ASSERT_TRUE(opened);
  Session session(std::move(opened).value());
  session.findings().euler_terms();
  // Counts that would balance as they were before, too.
  for (const char* line : {"detach f0", "undo", "redo", "delete_loop f3", "make_vertex 5,5,5", "undo 3"}) {
    ASSERT_TRUE(session.run(line).done()) << line;
    EXPECT_EQ(session.findings().euler_terms(), euler_poincare(session.mesh())) << line;
  }
}

TEST(session, terms_are_kept_over_rings_copies_and_wires_as_if_made_anew) {
  auto opened = Document::open(RYOSEN_SOURCE_DIR "/assets/fin.obj");
  ASSERT_TRUE(opened);
  Session session(std::move(opened).value());
  EXPECT_EQ(session.findings().euler_terms().no_genus, NoGenus::nonmanifold_edge);
  for (const char* line : {"split 0-1@f0", "make_vertex 3,3,3", "make_vertex 4,4,4", "make_edge v6 v7", "split 6-7",
                           "poke f0", "detach f1", "detach f2", "undo 3", "redo 2"}) {
    ASSERT_TRUE(session.run(line).done()) << line;
    EXPECT_EQ(session.findings().euler_terms(), euler_poincare(session.mesh())) << line;
  }
}

TEST(session, knows_the_kind_of_its_mesh_after_edits) {
  auto opened = Document::open(RYOSEN_SOURCE_DIR "/assets/cube.obj");
  ASSERT_TRUE(opened);
  Session session(std::move(opened).value());
  const auto kind = [&] { return row_of(session.findings().kind().kind).id; };
  EXPECT_EQ(kind(), "solid");
  ASSERT_TRUE(session.run("reverse f0").done());
  EXPECT_EQ(kind(), "inside_out");
  ASSERT_TRUE(session.run("delete f0").done());
  EXPECT_TRUE(session.findings().is_kind_stale());
  EXPECT_EQ(kind(), "surface");
  EXPECT_FALSE(session.findings().is_kind_stale());
  ASSERT_TRUE(session.run("undo 2").done());
  EXPECT_EQ(kind(), "solid");
}

TEST(session, says_which_edges_a_file_cannot_hold) {
  Session session(std::make_unique<Document>());
  for (const char* line : {"make_vertex 0,0,0", "make_vertex 1,0,0", "make_edge v0 v1"})
    ASSERT_TRUE(session.run(line).done()) << line;
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "ryosen_wires_test.off";
  const Outcome saved = session.run("save " + path.string());
  EXPECT_TRUE(saved.done());
  EXPECT_NE(saved.sentence.en.find("edges without a face: 1"), std::string::npos) << saved.sentence.en;
  std::filesystem::remove(path);
}

// A bow-tie at point 2, whose second copy is the vertex 5.
std::unique_ptr<Session> bow_tie_session() {
  MeshFile file;
  file.mesh.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0.5, 0}, {2, 0, 0}, {2, 1, 0}};
  file.mesh.corners = {0, 2, 1, 2, 3, 4};
  file.mesh.face_offsets = {0, 3, 6};
  return std::make_unique<Session>(std::make_unique<Document>(std::move(file)));
}

TEST(session, an_operator_on_selected_copies_tells_them_apart) {
  const auto session = bow_tie_session();
  session->selecting.selection = {Vertex(2), Vertex(5)};
  const Outcome welded = session->run("weld selected");
  ASSERT_TRUE(welded.done()) << welded.sentence.en;
  EXPECT_EQ(session->log(), (std::vector<std::string>{"select v2@f0 v2@f1", "weld selected"}));
  EXPECT_EQ(session->mesh().live().vertices, 5u);
}

TEST(session, deleting_a_point_names_it_once) {
  const auto session = bow_tie_session();
  const Outcome outcome = session->run("delete v2");
  ASSERT_TRUE(outcome.done()) << outcome.sentence.en;
  EXPECT_EQ(std::count(outcome.deleted.begin(), outcome.deleted.end(), "v2"), 1);
  EXPECT_EQ(std::count_if(outcome.deleted.begin(), outcome.deleted.end(),
                          [](const std::string& name) { return name.starts_with("v2"); }),
            1);
}

TEST(session, what_an_undo_took_away_is_not_called_unknown) {
  const auto session = bow_tie_session();
  ASSERT_TRUE(session->run("split 0-1").done());  // makes the vertex 6 and the face 2
  ASSERT_TRUE(session->run("undo").done());
  for (const char* line : {"move_vertex v6 0,0,0", "poke f2", "collapse 0-6", "detach f0 f2", "weld v0 v6"}) {
    const Outcome outcome = session->run(line);
    EXPECT_EQ(outcome.exit_code, ExitCode::refused) << line << ": " << outcome.sentence.en;
    EXPECT_NE(outcome.sentence.en.find("was undone"), std::string::npos) << line << ": " << outcome.sentence.en;
  }
  for (const char* line : {"move_vertex v9 0,0,0", "poke f7", "detach f0 f7", "collapse 0-3", "detach f2 f7"})
    EXPECT_EQ(session->run(line).exit_code, ExitCode::usage) << line;
  EXPECT_TRUE(session->run("redo").done());
}

TEST(session, a_misspelt_alias_is_recognised) {
  EXPECT_NE(unknown_command("mekrr").sentence.en.find("did you mean mekr?"), std::string::npos);
}

TEST(session, what_is_expected_of_no_operator_is_named_once) {
  Session session(std::make_unique<Document>());
  const Outcome outcome = session.run("expect  legal  spllit 0-1");
  EXPECT_EQ(outcome.exit_code, ExitCode::usage);
  EXPECT_EQ(outcome.sentence.en, "expect: 'spllit' is not an operator; did you mean split?");
  EXPECT_EQ(outcome.sentence.ja, "expect：「spllit」は演算子ではありません。split ですか？");
}

TEST(expect, takes_every_letter_of_the_sum) {
  Session session(Document::open(test::asset("cube.obj")).value());
  for (const EulerTerm& term : euler_letters()) {
    const std::string line = std::string("expect ") + term.letter + " ";
    const std::int64_t value = term.value(session.findings().euler_terms()).value();
    EXPECT_TRUE(session.run(line + std::to_string(value)).done()) << line;
    EXPECT_EQ(session.run(line + std::to_string(value + 1)).exit_code, ExitCode::found_problems) << line;
  }
}

}  // namespace
}  // namespace ryosen
