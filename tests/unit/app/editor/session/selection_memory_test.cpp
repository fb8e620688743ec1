#include "app/editor/session/selection.h"

#include <gtest/gtest.h>

#include <set>

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/app/program.h"
#include "tests/support/core/sound_value.h"

namespace ryosen {
namespace {

std::unique_ptr<Session> memory_session(const std::string& name) {
  auto document = Document::open(test::asset(name));
  EXPECT_TRUE(document);
  return std::make_unique<Session>(std::move(document).value());
}

// What is kept under a name, as what is selected.
Elements what_is_kept(Session& session, const std::string& name) {
  EXPECT_TRUE(session.run("select kept " + name).done()) << name;
  return session.selecting.selection;
}

std::vector<glm::dvec3> corner_places(const Mesh& mesh, const Element& e) {
  std::vector<glm::dvec3> places;
  if (e.kind == Element::Kind::face) {
    for (const Vertex v : vertices_around(mesh, e.face())) places.push_back(mesh.position(v));
  } else {
    const auto [a, b] = ends(mesh, e.kind == Element::Kind::edge ? e.edge() : edge(e.halfedge()));
    places = {mesh.position(a), mesh.position(b)};
  }
  return places;
}

struct Divided {
  const char* scheme;
  std::size_t faces;  // of one quad
};

class WhatIsDividedTest : public testing::TestWithParam<Divided> {};

// The face z = 1 of the cube and one of its edges lie in planes that the midpoint scheme keeps; the others move them,
// but divide all alike.
TEST_P(WhatIsDividedTest, is_kept_and_selected_with_all_its_parts) {
  const auto session = memory_session("cube.obj");
  const Mesh& mesh = session->mesh();
  const Edge side = edge(mesh.halfedge(Face(0)));
  session->selecting.selection = {Face(0)};
  ASSERT_TRUE(session->run("keep patch").done());
  session->selecting.selection = {side};
  ASSERT_TRUE(session->run("keep side").done());
  session->selecting.selection = {Face(0)};
  ASSERT_TRUE(session->run(std::string("subdivide steps=2 scheme=") + GetParam().scheme).done());
  EXPECT_EQ(session->selecting.selection.size(), GetParam().faces) << "what is selected goes on in the same way";
  const Elements faces = what_is_kept(*session, "patch");
  EXPECT_EQ(faces.size(), GetParam().faces);
  ASSERT_TRUE(session->run("undo").done());
  EXPECT_EQ(what_is_kept(*session, "patch"), Elements{Face(0)});
  EXPECT_EQ(what_is_kept(*session, "side"), Elements{side});
  ASSERT_TRUE(session->run("redo").done());
  EXPECT_EQ(what_is_kept(*session, "patch"), faces);
}

INSTANTIATE_TEST_SUITE_P(schemes, WhatIsDividedTest,
                         testing::Values(Divided{"midpoint", 16}, Divided{"catmull_clark", 16}, Divided{"loop", 32},
                                         Divided{"sqrt3", 18}),
                         [](const auto& each) { return each.param.scheme; });

TEST(selection_memory, parts_lie_where_that_was_of_which_they_come) {
  const auto session = memory_session("cube.obj");
  const Edge side = edge(session->mesh().halfedge(Face(0)));
  const Halfedge half = halfedge(side, 1);
  for (const Element& e : {Element(Face(0)), Element(side), Element(half)}) {
    const std::vector<glm::dvec3> before = corner_places(session->mesh(), e);
    glm::dvec3 low = before[0], high = before[0];
    for (const glm::dvec3& p : before) low = glm::min(low, p), high = glm::max(high, p);
    session->selecting.selection = {e};
    session->run("keep it");
    ASSERT_TRUE(session->run("subdivide steps=2 scheme=midpoint").done());
    const Elements parts = what_is_kept(*session, "it");
    EXPECT_EQ(parts.size(), e.kind == Element::Kind::face ? 16u : 4u);
    for (const Element& part : parts)
      for (const glm::dvec3& p : corner_places(session->mesh(), part)) {
        EXPECT_EQ(glm::min(low, p), low);
        EXPECT_EQ(glm::max(high, p), high);
      }
    session->run("undo");
  }
}

TEST(selection_memory, edges_that_are_swapped_are_parts_of_none_and_polygons_go_on_as_their_triangles) {
  const auto session = memory_session("cube.obj");
  session->run("select f0 f1");
  session->run("keep faces");
  session->run("mode edge");
  session->run("select all");
  session->run("keep edges");
  ASSERT_TRUE(session->run("delaunay").done());
  EXPECT_EQ(what_is_kept(*session, "faces").size(), 4u);
  EXPECT_EQ(what_is_kept(*session, "edges").size(), 12u);
  session->run("undo");
  ASSERT_TRUE(session->run("simplify faces=12 triangulate=on").done());
  EXPECT_EQ(what_is_kept(*session, "faces").size(), 4u);
  EXPECT_EQ(what_is_kept(*session, "edges").size(), 12u);
}

TEST(selection_memory, what_nobody_can_follow_goes_with_a_word_and_comes_back_with_undo) {
  const auto session = memory_session("torus.off");
  session->run("select f0 f1");
  session->run("keep patch");
  session->run("select v3");
  session->run("keep \"a point\"");
  const Outcome outcome = session->run("remesh 10%");
  ASSERT_TRUE(outcome.done());
  EXPECT_NE(outcome.sentence.en.find("'a point', 'patch'"), std::string::npos) << outcome.sentence.en;
  EXPECT_NE(outcome.sentence.ja.find("「patch」"), std::string::npos) << outcome.sentence.ja;
  EXPECT_TRUE(session->selecting.selection.empty());
  EXPECT_EQ(session->run("select kept patch").exit_code, ExitCode::refused);
  ASSERT_TRUE(session->run("undo").done());
  EXPECT_EQ(what_is_kept(*session, "patch"), (Elements{Face(0), Face(1)}));
  ASSERT_TRUE(session->run("redo").done());
  EXPECT_EQ(session->run("select kept patch").exit_code, ExitCode::refused);
}

TEST(selection_memory, what_is_kept_changes_nothing_of_what_is_made) {
  for (const char* line : {"subdivide steps=2 scheme=catmull_clark", "subdivide steps=2 scheme=sqrt3", "delaunay",
                           "simplify ratio=0.5 triangulate=on"}) {
    const auto plain = memory_session("seam.obj"), with_set = memory_session("seam.obj");
    with_set->run("mode face");
    with_set->run("select all");
    with_set->run("keep all");
    plain->run(line);
    with_set->run(line);
    EXPECT_EQ(plain->mesh().hash(), with_set->mesh().hash()) << line;
  }
}

// A row that puts faces in the place of others and says nothing of it is found here: all faces of a mesh whose every
// face is kept come of these.
TEST(selection_memory, behind_every_algorithm_that_replaces_all_the_set_of_all_faces_is_that_of_all) {
  for (const AlgorithmRow& row : algorithm_table()) {
    const auto session = memory_session("cube.obj");
    session->run("mode face");
    session->run("select all");
    session->run("keep everything");
    std::string line = called(row);
    for (const ParameterRow& parameter : row.parameters)
      if (must_be_given(row.parameters, parameter))
        line += " " + std::string(parameter.id) + "=" + test::sound_value(parameter);
    if (!session->run(line).done()) continue;
    const Document& document = session->document();
    if (document.position() == 0 || !document.journal().replaces_everything(0)) continue;
    if (row.lineage == Lineage::lost)
      EXPECT_FALSE(session->selecting.memory.kept.contains("everything")) << line;
    else
      EXPECT_EQ(what_is_kept(*session, "everything").size(), session->mesh().live().faces) << line;
  }
}

}  // namespace
}  // namespace ryosen
