#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/session/session.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/ops/each.h"
#include "ryosen/ops/rules/surgery.h"
#include "tests/support/app/program.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen {
namespace {

std::unique_ptr<Session> session_opened(const RandomMesh& random) {
  MeshFile file;
  Dice dice(random.seed);
  for (int i = 0; i < random.points; ++i) file.mesh.positions.push_back({dice.unit(), dice.unit(), dice.unit()});
  file.mesh.face_offsets = {0};
  for (const std::vector<int>& face : random.faces) {
    for (const int corner : face) file.mesh.corners.push_back(static_cast<std::uint32_t>(corner));
    file.mesh.face_offsets.push_back(static_cast<std::uint32_t>(file.mesh.corners.size()));
  }
  return std::make_unique<Session>(std::make_unique<Document>(std::move(file)));
}

std::unique_ptr<Session> session_opened(const char* asset) {
  auto document = Document::open(test::asset(asset));
  EXPECT_TRUE(document);
  return std::make_unique<Session>(std::move(document).value());
}

Elements some_elements(const Mesh& mesh, Dice& dice) {
  Elements some;
  const auto gather = [&](auto handle, std::uint32_t slots) {
    using Handle = decltype(handle);
    for (std::uint32_t i = 0; i < slots; ++i)
      if (mesh.is_alive(Handle(i)) && dice.one_in(2)) some.emplace_back(Handle(i));
  };
  gather(Vertex(), mesh.vertex_slots());
  gather(Edge(), mesh.edge_slots());
  gather(Face(), mesh.face_slots());
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i)
    if (mesh.is_alive(edge(Halfedge(i))) && dice.one_in(8)) some.emplace_back(Halfedge(i));
  for (std::size_t i = some.size(); i > 1; --i)
    std::swap(some[i - 1], some[static_cast<std::size_t>(dice.below(static_cast<int>(i)))]);
  return some;
}

std::string own_name(const Mesh& mesh, Element e) {
  return e.kind == Element::Kind::vertex ? name_of_copy(mesh, e.vertex()) : name_of(mesh, e);
}

// What shares the subject of an edge: its two points, or its walk outside of the faces.
using SubjectKey = std::set<std::uint32_t>;
SubjectKey edges_of_subject(const Mesh& mesh, Subject subject, Edge e) {
  SubjectKey edges;
  const auto points = [&](Edge other) {
    return SubjectKey{mesh.copy_point(ends(mesh, other).first).index, mesh.copy_point(ends(mesh, other).second).index};
  };
  if (subject == Subject::points)
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i)
      if (mesh.is_alive(Edge(i)) && points(Edge(i)) == points(e)) edges.insert(i);
  if (subject == Subject::cycle)
    for (int side = 0; side < 2 && edges.empty(); ++side) {
      Halfedge h = halfedge(e, side);
      if (mesh.face(h)) continue;
      for (const Halfedge first = h; edges.empty() || h != first; h = mesh.next(h)) edges.insert(edge(h).index);
    }
  return edges;
}

// Says the commands one by one; the elements that were refused.
std::set<Element> one_by_one(Session& session, const OpInfo& op, Elements elements, std::size_t& done) {
  std::sort(elements.begin(), elements.end());
  std::set<Element> refused;
  SubjectKey done_edges;
  for (const Element& e : elements) {
    if (!takes(op, e.kind, {}) || !is_alive(session.mesh(), e)) continue;
    const bool is_edge = e.kind == Element::Kind::edge || e.kind == Element::Kind::halfedge;
    const Edge at = e.kind == Element::Kind::halfedge ? edge(e.halfedge()) : Edge(e.index);
    if (is_edge && done_edges.contains(at.index)) {
      ++done;
      continue;
    }
    const SubjectKey same = is_edge ? edges_of_subject(session.mesh(), op.subject, at) : SubjectKey();
    const Outcome outcome = session.run(std::string(op.id) + " " + own_name(session.mesh(), e));
    EXPECT_NE(outcome.kind, Outcome::Kind::failed) << outcome.sentence.en;
    if (outcome.done()) {
      ++done;
      done_edges.insert(same.begin(), same.end());
    } else {
      refused.insert(e);
    }
  }
  return refused;
}

std::set<Vertex> ends_of(const Mesh& mesh, const Elements& elements) {
  std::set<Vertex> found;
  for (const Element& e : elements) {
    if (e.kind != Element::Kind::edge && e.kind != Element::Kind::halfedge) continue;
    const auto [a, b] = ends(mesh, e.kind == Element::Kind::edge ? e.edge() : edge(e.halfedge()));
    for (const Vertex v : {a, b})
      if (!has_two_edges(mesh, v)) found.insert(v);
  }
  return found;
}

TEST(on_selection, each_is_the_same_as_one_command_after_the_other) {
  std::size_t entries = 0, refusals = 0, taken_along = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
    for (const OpInfo& op : all_ops()) {
      if (op.on_selection != OnSelection::each) continue;
      if (!takes(op, Element::Kind::vertex, {}) && !takes(op, Element::Kind::edge, {}) &&
          !takes(op, Element::Kind::face, {}))
        continue;  // needs more than the element
      SCOPED_TRACE(std::string(op.id) + ", seed " + std::to_string(seed));
      const RandomMesh random = random_mesh(seed);
      const auto at_once = session_opened(random), apart = session_opened(random);
      Dice dice(seed);
      const Elements elements = some_elements(at_once->mesh(), dice);
      const std::uint64_t before = at_once->mesh().hash();
      std::size_t done = 0;
      const std::set<Vertex> ends = op.takes_ends_along ? ends_of(apart->mesh(), elements) : std::set<Vertex>();
      const std::set<Element> refused = one_by_one(*apart, op, elements, done);
      for (const Vertex v : ends)
        if (done > 0 && apart->mesh().is_alive(v) && has_two_edges(apart->mesh(), v))
          taken_along += apart->run("unite_edge " + own_name(apart->mesh(), v)).done();
      at_once->selecting.selection = elements;
      const Outcome outcome = at_once->run(std::string(op.id) + " selected");
      ASSERT_EQ(at_once->mesh().hash(), apart->mesh().hash()) << outcome.sentence.en;
      ASSERT_EQ(at_once->document().history().size(), done > 0 ? 1u : 0u);
      if (done == 0) continue;
      ++entries;
      refusals += refused.size();
      for (const Element& e : at_once->selecting.selection) EXPECT_TRUE(is_alive(at_once->mesh(), e));
      for (const Reason& reason : outcome.reasons)
        for (const Element& e : reason.witnesses) EXPECT_TRUE(is_alive(at_once->mesh(), e)) << "its name is printed";
      if (!refused.empty())
        for (const Element& e : elements)
          if (takes(op, e.kind, {}) && is_alive(at_once->mesh(), e)) {
            const auto& left = at_once->selecting.selection;
            EXPECT_EQ(std::find(left.begin(), left.end(), e) != left.end(), refused.contains(e));
          }
      ASSERT_TRUE(at_once->run("undo").done());
      EXPECT_EQ(at_once->mesh().hash(), before);
      EXPECT_EQ(at_once->selecting.selection, elements) << "undo brings the selection back";
    }
  EXPECT_GT(entries, 200u);
  EXPECT_GT(refusals, 200u);
  EXPECT_GT(taken_along, 5u);
}

TEST(on_selection, the_log_does_the_same_again) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed)
    for (const OpInfo& op : all_ops()) {
      if (op.on_selection == OnSelection::none) continue;
      const RandomMesh random = random_mesh(seed);
      const auto session = session_opened(random), again = session_opened(random);
      Dice dice(seed + 100);
      session->selecting.selection = some_elements(session->mesh(), dice);
      if (op.on_selection != OnSelection::each)
        session->selecting.selection.changed().resize(std::min<std::size_t>(session->selecting.selection.size(), 3));
      session->run(std::string(op.id) + " selected");
      for (const std::string& line : session->log()) ASSERT_TRUE(again->run(line).done()) << line;
      ASSERT_EQ(session->mesh().hash(), again->mesh().hash()) << op.id << ", seed " << seed;
    }
}

Vertex to_of_last(const Mesh& mesh, Face f) { return mesh.from(mesh.prev(mesh.halfedge(f))); }

TEST(on_selection, welds_into_the_last_and_fills_each_hole_once) {
  const auto cubes = session_opened("cube.obj");
  cubes->run("delete f0");
  cubes->run("select boundary_loop");
  ASSERT_EQ(cubes->selecting.selection.size(), 4u);
  const Outcome filled = cubes->run("fill selected");
  ASSERT_TRUE(filled.done()) << filled.sentence.en;
  EXPECT_EQ(cubes->mesh().live().faces, 6u) << "one face, though four edges are selected";
  EXPECT_EQ(filled.sentence.en, "One face was made.");
  EXPECT_EQ(filled.sentence.ja, "面を 1 個張りました。");
  EXPECT_EQ(cubes->document().history().size(), 2u);
  const auto apart = session_opened("cube.obj");
  for (const char* place : {"5,0,0", "6,0,0", "7,0,0"}) apart->run(std::string("make_vertex ") + place);
  apart->run("select v8 v10 v9");
  ASSERT_TRUE(apart->run("weld selected").done());
  EXPECT_EQ(apart->mesh().live().vertices, 9u);
  EXPECT_EQ(apart->mesh().position(Vertex(8)), glm::dvec3(6, 0, 0)) << "at the place of the last one";
}

TEST(on_selection, welds_in_the_middle_of_all_as_one_entry) {
  const auto session = session_opened("cube.obj");
  for (const char* place : {"5,0,0", "6,3,0", "7,0,6", "0,1,2"}) session->run(std::string("make_vertex ") + place);
  const std::uint64_t before = session->mesh().hash();
  session->run("select v8 v11 v10 v9");
  ASSERT_TRUE(session->run("weld selected mid").done());
  EXPECT_EQ(session->mesh().live().vertices, 9u);
  EXPECT_EQ(session->mesh().position(Vertex(8)), glm::dvec3(4.5, 1, 2));
  EXPECT_EQ(session->document().history().size(), 5u);
  EXPECT_EQ(session->log().back(), "weld selected mid");
  session->run("undo");
  EXPECT_EQ(session->mesh().hash(), before);
  ASSERT_TRUE(session->run("weld v8 v9 1,2,3").done());
  EXPECT_EQ(session->mesh().position(Vertex(8)), glm::dvec3(1, 2, 3));
  ASSERT_TRUE(session->run("weld v10 v11 mid").done());
  EXPECT_EQ(session->mesh().position(Vertex(10)), glm::dvec3(3.5, 0.5, 4));
}

// A loop of edges goes with its vertices, as whoever knows other editors expects; what had two edges before stays.
TEST(on_selection, dissolves_edges_with_the_ends_that_they_leave_with_two_edges) {
  const auto session = session_opened("cube.obj"), again = session_opened("cube.obj");
  ASSERT_TRUE(session->run("new").done());
  ASSERT_TRUE(session->run("grid columns=4 rows=4").done());
  ASSERT_TRUE(session->run("separate_edge 6-7").done());  // a vertex with two edges on the row below
  const Vertex between(session->mesh().vertex_slots() - 1);
  session->run("select 10-11");
  session->run("select loop");
  ASSERT_EQ(session->selecting.selection.size(), 4u);
  session->run("select add 0-1 6-" + std::to_string(between.index));
  const auto before = session->mesh().live();
  const std::uint64_t hash = session->mesh().hash();
  const Outcome outcome = session->run("dissolve selected");
  ASSERT_TRUE(outcome.done()) << outcome.sentence.en;
  EXPECT_NE(outcome.sentence.en.find("5 vertices that were left with two edges went too."), std::string::npos)
      << outcome.sentence.en;
  EXPECT_NE(outcome.sentence.ja.find("頂点 5 個も"), std::string::npos) << outcome.sentence.ja;
  EXPECT_EQ(session->mesh().live().vertices, before.vertices - 6) << "one goes within the chain that is dissolved";
  EXPECT_TRUE(session->mesh().is_alive(Vertex(0))) << "a corner of the sheet, which had two before";
  EXPECT_EQ(session->document().history().size(), 3u);
  ASSERT_TRUE(again->run("new").done());
  for (const std::string& line : session->log()) ASSERT_TRUE(again->run(line).done()) << line;
  EXPECT_EQ(again->mesh().hash(), session->mesh().hash());
  ASSERT_TRUE(session->run("undo").done());
  EXPECT_EQ(session->mesh().hash(), hash);
}

// As whoever knows other editors expects of selected faces: the edges between them go, with the vertices that only they
// had.
TEST(on_selection, dissolves_selected_faces_into_one_as_one_entry) {
  const auto session = session_opened("cube.obj");
  ASSERT_TRUE(session->run("new").done());
  ASSERT_TRUE(session->run("grid columns=3 rows=3").done());
  const std::uint64_t before = session->mesh().hash();
  ASSERT_TRUE(session->run("select f0..f8").done());
  const Outcome outcome = session->run("dissolve selected");
  ASSERT_TRUE(outcome.done()) << outcome.sentence.en;
  EXPECT_TRUE(outcome.reasons.empty()) << outcome.sentence.en;
  EXPECT_EQ(session->mesh().live(), (ElementCounts{12, 12, 1}));
  EXPECT_EQ(session->document().history().size(), 2u);
  EXPECT_EQ(session->selecting.selection, Elements{Face(0)});
  const std::vector<std::string> log = session->log();
  const auto again = session_opened("cube.obj");
  for (const std::string& line : log) ASSERT_TRUE(again->run(line).done()) << line;
  EXPECT_EQ(again->mesh().hash(), session->mesh().hash());
  session->run("undo");
  EXPECT_EQ(session->mesh().hash(), before);
  ASSERT_TRUE(session->run("select f0 f8").done());
  EXPECT_EQ(session->run("dissolve selected").exit_code, ExitCode::refused) << "they have no edge in common";
}

TEST(on_selection, welds_the_vertices_of_selected_faces_into_the_last) {
  const auto session = session_opened("cube.obj");
  ASSERT_TRUE(session->run("select f0").done());
  const Vertex last = to_of_last(session->mesh(), Face(0));
  const glm::dvec3 place = session->mesh().position(last);
  const Outcome outcome = session->run("weld selected");
  ASSERT_TRUE(outcome.done()) << outcome.sentence.en;
  EXPECT_TRUE(outcome.reasons.empty()) << outcome.sentence.en;
  EXPECT_EQ(session->mesh().live(), (ElementCounts{5, 8, 5})) << "a pyramid";
  EXPECT_EQ(session->document().history().size(), 1u);
  EXPECT_EQ(session->mesh().position(last), place);
  session->run("undo");
  EXPECT_EQ(session->mesh().live().vertices, 8u);
}

TEST(on_selection, says_what_was_refused_and_what_is_missing) {
  const auto session = session_opened("cube.obj");
  for (const OpInfo& op : all_ops()) {
    session->selecting.selection.clear();
    const Outcome outcome = session->run(std::string(op.id) + " selected");
    if (op.on_selection == OnSelection::none) {
      EXPECT_EQ(outcome.exit_code, ExitCode::usage) << op.id;
      continue;
    }
    EXPECT_FALSE(outcome.done()) << op.id;
    EXPECT_FALSE(outcome.sentence.ja.empty());
  }
  EXPECT_TRUE(session->log().empty());
  session->run("select f0 f1");
  EXPECT_EQ(session->run("poke selected nonsense").exit_code, ExitCode::usage);
  session->run("mode edge");
  session->run("select all");
  const Outcome refused = session->run("collapse selected");
  ASSERT_FALSE(refused.reasons.empty());
  EXPECT_NE(refused.sentence.en.find("refused"), std::string::npos) << refused.sentence.en;
}

TEST(either, does_the_first_that_is_possible_and_tells_the_refusal_that_was_meant) {
  const auto session = session_opened("cube.obj");
  session->run("select v0 v2");
  const Outcome joined = session->run("either separate_loop selected | unite_ring selected | make_edge selected");
  ASSERT_TRUE(joined.done()) << joined.sentence.en;
  EXPECT_EQ(session->document().history().size(), 1u);
  EXPECT_EQ(session->log().size(), 1u);
  const Outcome again = session->run("either separate_loop selected | make_edge selected");
  EXPECT_EQ(again.exit_code, ExitCode::refused) << again.sentence.en;
  EXPECT_EQ(session->run("either undo").exit_code, ExitCode::usage);
}

TEST(on_each, both_sides_of_a_wire_are_cycles_of_their_own) {
  const auto session = session_opened("cube.obj");
  for (const char* line : {"make_vertex 5,0,0", "make_vertex 6,0,0", "make_vertex 5,1,0", "make_edge v8 v9",
                           "make_edge v9 v10", "make_edge v10 v8"})
    ASSERT_TRUE(session->run(line).done()) << line;
  const Edge wire = edge(find_edge(session->mesh(), "8-9").element);
  for (const int side : {0, 1}) session->run("select add h" + std::to_string(halfedge(wire, side).index));
  const Outcome outcome = session->run("fill selected");
  ASSERT_TRUE(outcome.done()) << outcome.sentence.en;
  EXPECT_TRUE(outcome.sentence.en.starts_with("One face was made. One refused: Two faces would have"))
      << outcome.sentence.en;
  EXPECT_EQ(session->mesh().live().faces, 7u);
}

TEST(on_each, what_is_strict_is_logged_so_that_it_is_done_again_without) {
  const auto session = session_opened("cube.obj");
  session->frontend.is_strict = true;
  session->run("triangulate f0");
  session->run("select all");
  const std::string before = session->selecting.select_line();
  if (!session->run("collapse selected").done()) GTEST_FAIL();
  const auto again = session_opened("cube.obj");
  for (const std::string& line : session->log()) ASSERT_TRUE(again->run(line).done()) << line;
  EXPECT_EQ(again->mesh().hash(), session->mesh().hash());
}

TEST(selection_memory, what_was_kept_on_a_branch_that_is_gone_is_not_of_the_next) {
  const auto session = session_opened("cube.obj");
  session->run("poke f0");
  session->run("select v8 f1");
  session->run("keep mine");
  session->run("undo");
  session->run("poke f3");  // makes another v8
  ASSERT_TRUE(session->run("select kept mine").done());
  EXPECT_EQ(session->selecting.selection, Elements{Face(1)});
}

TEST(selection_memory, each_entry_brings_back_what_was_selected_around_it) {
  const auto session = session_opened("cube.obj");
  session->run("select f0 f1");
  session->run("poke f0");
  session->run("select f2");
  session->run("poke f3");
  session->run("select v1 v2");
  session->run("undo");
  EXPECT_EQ(session->selecting.selection, (Elements{Face(2)}));
  session->run("undo");
  EXPECT_EQ(session->selecting.selection, (Elements{Face(0), Face(1)}));
  session->run("redo");
  EXPECT_EQ(session->selecting.selection, (Elements{Face(2)})) << "as it was when the next one began";
  session->run("redo");
  EXPECT_EQ(session->selecting.selection, (Elements{Vertex(1), Vertex(2)}));
}

TEST(selection_memory, keeps_selections_by_name_through_edits) {
  const auto session = session_opened("cube.obj");
  EXPECT_EQ(session->run("keep some").exit_code, ExitCode::refused);
  session->run("select f0 f1 v3");
  ASSERT_TRUE(session->run("keep some").done());
  session->run("delete f0");
  ASSERT_TRUE(session->run("select kept some").done());
  EXPECT_EQ(session->selecting.selection, (Elements{Face(1), Vertex(3)}));
  session->run("undo");
  ASSERT_TRUE(session->run("select kept some").done());
  EXPECT_EQ(session->selecting.selection.size(), 3u);
  session->run("reverse f0");  // renumbers
  session->run("undo");
  ASSERT_TRUE(session->run("select kept some").done());
  EXPECT_EQ(session->selecting.selection.size(), 3u);
  EXPECT_NE(session->run("select kept sone").sentence.en.find("some"), std::string::npos);
  ASSERT_TRUE(session->run("forget some").done());
  EXPECT_EQ(session->run("select kept some").exit_code, ExitCode::refused);
}

TEST(selection_memory, many_are_selected_in_few_words) {
  const auto session = session_opened("torus.off");
  session->run("mode face");
  session->run("select all");
  const Elements all = session->selecting.selection;
  EXPECT_EQ(session->selecting.select_line(), "select f0..f" + std::to_string(all.size() - 1));
  session->run("select none");
  ASSERT_TRUE(session->run("select f0..f" + std::to_string(all.size() - 1)).done());
  EXPECT_EQ(session->selecting.selection, all);
  for (const char* wrong : {"select f3..f1", "select f1..e3", "select f1..", "select ..f2", "select f1..f99999999999"})
    EXPECT_EQ(session->run(wrong).exit_code, ExitCode::usage) << wrong;
}

TEST(on_selection, says_in_words_what_an_operator_takes) {
  auto document = Document::open(test::asset("cube.obj"));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  for (const OpInfo& op : all_ops()) {
    const std::string line = std::string(op.id) + " selected";
    if (op.on_selection == OnSelection::none || fault_of_command(line)) continue;
    const Outcome outcome = session.run(line);
    ASSERT_EQ(outcome.exit_code, ExitCode::refused) << op.id;
    const std::string& told = outcome.sentence.en;
    EXPECT_TRUE(told.find("vertex") != told.npos || told.find("vertices") != told.npos ||
                told.find("edge") != told.npos || told.find("face") != told.npos || op.id == "vertex_split")
        << told;
    EXPECT_TRUE(told.find('[') == told.npos || op.id == "vertex_split") << told;
  }
  ASSERT_TRUE(session.run("select v0").done());
  EXPECT_NE(session.run("make_edge selected").sentence.en.find("two vertices, in order"), std::string::npos);
}

}  // namespace
}  // namespace ryosen
