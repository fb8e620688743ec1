#include "app/editor/commands/fly.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "app/editor/session/session.h"
#include "ryosen/base/number_text.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

std::unique_ptr<Session> session_of(const std::string& name) {
  auto document = Document::open(test::asset(name));
  EXPECT_TRUE(document) << name;
  auto session = std::make_unique<Session>(std::move(document).value());
  session->framing.frame_all();
  return session;
}

bool is_in_view(const Session& session, const glm::dvec3& place) {
  const auto at = project(session.view.camera, session.view.size, place);
  return at && at->pixel.x >= 0 && at->pixel.y >= 0 && at->pixel.x <= session.view.size.width &&
         at->pixel.y <= session.view.size.height;
}

TEST(fly, shows_elements_beside_what_a_tab_has_opened) {
  const auto session = session_of("torus.off");
  session->view.covered_px = {0, 0.5 * session->view.size.width};
  ASSERT_TRUE(session->run("select v0").done());
  ASSERT_TRUE(session->run("frame selected").done());
  const auto at = project(session->view.camera, session->view.size, session->mesh().position(Vertex(0)));
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->pixel.x, 0.25 * session->view.size.width, 0.05 * session->view.size.width);
  EXPECT_NEAR(at->pixel.y, 0.5 * session->view.size.height, 0.05 * session->view.size.height);
}

TEST(fly, shows_a_face_from_a_side_from_which_it_is_seen_with_all_around_it) {
  for (const char* name : {"stanford_bunny.obj", "torus.off"}) {
    const auto session = session_of(name);
    const Mesh& m = session->mesh();
    std::mt19937 random(5);
    int shown = 0;
    constexpr int asked = 60;
    for (int i = 0; i < asked; ++i) {
      const Face f(static_cast<std::uint32_t>(random() % m.face_slots()));
      session->selecting.selection = {f};
      fly_to(session->findings(), session->view, session->framing, session->selecting.selection);
      for (Vertex v : vertices_around(m, f))
        for (Vertex w : neighbours(m, v)) EXPECT_TRUE(is_in_view(*session, m.position(w))) << name << " f" << f.index;
      glm::dvec3 middle{0};
      for (Vertex v : vertices_around(m, f)) middle += m.position(v) / double(corner_count(m, f));
      const auto front =
          session->pointing.pick(project(session->view.camera, session->view.size, middle)->pixel, PickMode::face);
      shown += front && front->face == f;
    }
    EXPECT_GE(shown, asked - 1) << name;
  }
}

TEST(fly, keeps_the_direction_where_that_shows_it) {
  const auto session = session_of("torus.off");
  const auto front = session->pointing.pick({640, 560}, PickMode::face);
  ASSERT_TRUE(front);
  const glm::dvec3 before = axes(session->view.camera).forward;
  session->selecting.selection = {front->face};
  ASSERT_TRUE(session->run("frame selected").done());
  EXPECT_LT(glm::length(axes(session->view.camera).forward - before), 1e-9);
}

TEST(fly, a_walk_stays_beside_what_a_tab_has_opened) {
  const auto session = session_of("torus.off");
  session->view.covered_px = {0.6 * session->view.size.width, 0};
  ASSERT_TRUE(session->run("select h0").done());
  ASSERT_TRUE(session->run("frame selected").done());
  const glm::dvec3 eye = session->view.camera.eye;
  const Mesh& m = session->mesh();
  for (int i = 0; i < 60; ++i) {
    ASSERT_TRUE(session->run(i % 3 == 2 ? "walk twin" : "walk next").done());
    const Halfedge h = session->selecting.selection[0].halfedge();
    const auto at =
        project(session->view.camera, session->view.size, (m.position(m.from(h)) + m.position(m.to(h))) / 2.0);
    ASSERT_TRUE(at);
    EXPECT_GE(at->pixel.x, 0.6 * session->view.size.width - 1e-6) << i;
    EXPECT_LE(at->pixel.x, session->view.size.width) << i;
  }
  EXPECT_NE(session->view.camera.eye, eye) << "else nothing was tried";
}

TEST(fly, a_walk_takes_the_camera_along_where_the_next_halfedge_is_hidden) {
  const auto session = session_of("torus.off");
  const Mesh& m = session->mesh();
  session->selecting.selection = {Halfedge(0)};
  int turned = 0;
  for (int i = 0; i < 60; ++i) {  // around the torus: across each quad
    const Camera before = session->view.camera;
    for (const char* line : {"walk next", "walk next", "walk twin"}) ASSERT_TRUE(session->run(line).done());
    turned += !(before == session->view.camera);
    const Halfedge h = session->selecting.selection[0].halfedge();
    const glm::dvec3 middle = (m.position(m.from(h)) + m.position(m.to(h))) / 2.0;
    ASSERT_TRUE(is_in_view(*session, middle));
    const auto front =
        session->pointing.pick(project(session->view.camera, session->view.size, middle)->pixel, PickMode::face);
    if (!front) continue;  // on the silhouette
    EXPECT_TRUE(front->face == m.face(h) || front->face == m.face(twin(h))) << i;
  }
  EXPECT_GT(turned, 0);
  EXPECT_LT(turned, 40) << "where it is seen the camera stays";
}

TEST(fly, stands_upright_where_it_turns_and_knows_what_an_orthographic_picture_shows) {
  const auto session = session_of("torus.off");
  const Mesh& m = session->mesh();
  for (const char* first : {"view top", "view front", "projection orthographic"}) {
    ASSERT_TRUE(session->run(first).done()) << first;
    for (std::uint32_t f = 0; f < m.face_slots(); f += 7) {
      const glm::dvec3 before = axes(session->view.camera).forward;
      ASSERT_TRUE(session->run("select f" + std::to_string(f)).done());
      ASSERT_TRUE(session->run("frame selected").done());
      const CameraAxes now = axes(session->view.camera);
      if (glm::length(now.forward - before) > 1e-9) {
        EXPECT_NEAR(now.right.y, 0, 1e-9) << first << " f" << f;
      }
      glm::dvec3 middle{0};
      for (Vertex v : vertices_around(m, Face(f))) middle += m.position(v) / double(corner_count(m, Face(f)));
      Camera far = session->view.camera;
      if (far.ortho_height) far.eye -= 100.0 * now.forward;
      const auto at = project(far, session->view.size, middle);
      const auto front = session->findings().picker().pick(m, far, session->view.size, at->pixel, PickMode::face);
      ASSERT_TRUE(front) << first << " f" << f;
      EXPECT_EQ(front->face, Face(f)) << first;
    }
  }
}

TEST(fly, copes_with_what_has_no_place_and_with_nothing) {
  const test::TemporaryFolder folder;
  auto document = Document::open(folder.write("n.off", "OFF\n4 2 0\n0 0 0\n1 0 0\nnan 1 0\n1 1 1\n3 0 1 2\n3 1 0 3\n"));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  session.framing.frame_all();
  for (const char* line : {"select h0", "walk next", "walk twin", "walk next", "walk next", "select v2",
                           "frame selected", "select f0 f1", "frame selected", "frame all"})
    ASSERT_TRUE(session.run(line).done()) << line;
  EXPECT_TRUE(is_finite(session.view.camera.eye) && is_finite(session.view.camera.target));
  Session empty(std::make_unique<Document>());
  fly_to(empty.findings(), empty.view, empty.framing, {});
  EXPECT_TRUE(is_finite(empty.view.camera.eye));
}

// Each face at the hub would bring all of its neighbours again.
TEST(fly, costs_no_square_of_the_valence) {
  const test::TemporaryFolder folder;
  std::string text = "OFF\n20001 20000 0\n0 0 1\n";
  for (int i = 0; i < 20000; ++i)
    text += format_double(std::cos(i * 3.14159e-4)) + " " + format_double(std::sin(i * 3.14159e-4)) + " 0\n";
  for (int i = 0; i < 20000; ++i)
    text += "3 0 " + std::to_string(1 + i) + " " + std::to_string(1 + (i + 1) % 20000) + "\n";
  auto document = Document::open(folder.write("fan.off", text));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  for (std::uint32_t f = 0; f < 20000; ++f) session.selecting.selection.changed().emplace_back(Face(f));
  fly_to(session.findings(), session.view, session.framing, session.selecting.selection);  // else 40 GB
}

TEST(fly, selects_what_a_problem_is_about) {
  const auto bunny = session_of("stanford_bunny.obj");
  const IndexSet& boundary = bunny->findings().highlights().of(ProblemKind::boundary_loop);
  const Element edge = Edge(boundary.nth(0));
  ASSERT_TRUE(bunny->run("select boundary_loop " + name_to_select(bunny->mesh(), edge)).done());
  EXPECT_GT(bunny->selecting.selection.size(), 2u);
  EXPECT_EQ(bunny->selecting.selection[0], edge);
  for (const Element& e : bunny->selecting.selection) EXPECT_TRUE(boundary.contains(e.index));

  const auto tie = session_of("bow_tie.obj");
  const IndexSet& points = tie->findings().highlights().of(ProblemKind::nonmanifold_vertex);
  ASSERT_EQ(points.size(), 1u);
  const Element knot = Vertex(points.nth(0));
  ASSERT_TRUE(tie->run("select nonmanifold_vertex " + name_to_select(tie->mesh(), knot)).done());
  EXPECT_EQ(tie->selecting.selection.size(), 1 + tie->mesh().live().faces) << "the vertex and both fans";

  const auto fin = session_of("fin.obj");
  const Element many = Edge(fin->findings().highlights().of(ProblemKind::nonmanifold_edge).nth(0));
  ASSERT_TRUE(fin->run("select nonmanifold_edge " + name_to_select(fin->mesh(), many)).done());
  EXPECT_EQ(fin->selecting.selection.size(), 4u) << "the edge and three faces";

  const auto twice = session_of("duplicate_face.obj");
  const Element face = Face(twice->findings().highlights().of(ProblemKind::duplicate_face).nth(0));
  ASSERT_TRUE(twice->run("select duplicate_face " + name_of(twice->mesh(), face)).done());
  EXPECT_EQ(twice->selecting.selection.size(), 2u);
  EXPECT_EQ(twice->run("select duplicate_face none").exit_code, ExitCode::usage);
}

}  // namespace
}  // namespace ryosen
