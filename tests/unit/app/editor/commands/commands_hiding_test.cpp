#include <gtest/gtest.h>

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

std::unique_ptr<Session> laid_out(const char* asset) {
  auto document = Document::open(test::asset(asset));
  EXPECT_TRUE(document);
  auto session = std::make_unique<Session>(std::move(document).value());
  session->view.size = {640, 480};
  session->framing.frame_all();
  return session;
}

void run(Session& session, std::initializer_list<const char*> lines) {
  for (const char* line : lines) EXPECT_TRUE(session.run(line).done()) << line;
}

glm::dvec2 middle_of(const Session& session, Face f) {
  glm::dvec3 sum(0);
  for (const Vertex v : vertices_around(session.mesh(), f)) sum += session.mesh().position(v);
  return project(session.view.camera, session.view.size, sum / double(corner_count(session.mesh(), f)))->pixel;
}

TEST(hiding, is_no_edit_and_leaves_the_selection) {
  const auto session = laid_out("torus.off");
  const auto live = session->mesh().live();
  run(*session, {"select f3 f7 v0", "hide f3 f4"});
  EXPECT_EQ(session->findings().hidden().faces().to_vector(), (std::vector<std::uint32_t>{3, 4}));
  EXPECT_EQ(session->selecting.selection, (std::vector<Element>{Face(7), Vertex(0)}));
  run(*session, {"mode face", "select all"});
  EXPECT_EQ(session->selecting.selection.size(), session->mesh().live().faces - 2);
  EXPECT_TRUE(session->log().empty());
  EXPECT_TRUE(session->document().history().empty());
  EXPECT_EQ(session->mesh().live().faces, live.faces);
  run(*session, {"unhide"});
  EXPECT_TRUE(session->findings().hidden().empty());
}

TEST(hiding, goes_by_its_keys) {
  const auto session = laid_out("torus.off");
  run(*session, {"select f1..f5", "key H"});
  EXPECT_EQ(session->findings().hidden().faces().size(), 5u);
  EXPECT_TRUE(session->selecting.selection.empty());
  run(*session, {"key Ctrl+H", "select f1..f5", "key Shift+H"});
  EXPECT_EQ(session->findings().hidden().faces().size(), session->mesh().live().faces - 5);
  EXPECT_EQ(session->selecting.selection.size(), 5u) << "what is left stays selected";
  run(*session, {"key Ctrl+H"});
  EXPECT_TRUE(session->findings().hidden().empty());
}

TEST(hiding, takes_the_faces_at_edges_and_vertices_along) {
  const auto session = laid_out("cube.obj");
  run(*session, {"hide v0"});
  EXPECT_EQ(session->findings().hidden().faces().size(), 3u);
  EXPECT_TRUE(session->findings().hidden().hides(session->mesh(), Vertex(0)));
  std::size_t shown = 0;
  for (std::uint32_t i = 0; i < session->mesh().vertex_slots(); ++i)
    shown += !session->findings().hidden().hides(session->mesh(), Vertex(i));
  EXPECT_EQ(shown, 7u);
  run(*session, {"unhide", "select all", "isolate e0"});
  EXPECT_EQ(session->findings().hidden().faces().size(), 4u);
}

TEST(hiding, hides_wires_and_isolated_vertices_themselves) {
  Session session(std::make_unique<Document>());
  run(session, {"make_vertex 0,0,0", "make_vertex 1,0,0", "make_edge v0 v1", "make_vertex 0,1,0", "hide v0"});
  EXPECT_TRUE(session.findings().hidden().hides(session.mesh(), Edge(0)));
  EXPECT_FALSE(session.findings().hidden().hides(session.mesh(), Vertex(2)));
  run(session, {"hide v2"});
  EXPECT_EQ(session.findings().hidden().isolated().to_vector(), (std::vector<std::uint32_t>{2}));
  run(session, {"make_edge v1 v2"});
  EXPECT_TRUE(session.findings().hidden().isolated().empty()) << "it is isolated no more";
  EXPECT_FALSE(session.findings().hidden().hides(session.mesh(), Vertex(2)));
}

TEST(hiding, says_what_is_wrong) {
  const auto session = laid_out("cube.obj");
  for (const char* line : {"hide", "hide nonsense", "isolate", "unhide f1", "hide f99"})
    EXPECT_EQ(session->run(line).exit_code, ExitCode::usage) << line;
  for (const char* line : {"hide selected", "isolate selected"}) {
    EXPECT_EQ(session->run(line).exit_code, ExitCode::refused) << line;
  }
  EXPECT_TRUE(session->findings().hidden().empty());
  run(*session, {"select f0"});
  EXPECT_EQ(session->run("hide selected").sentence.en, "one face is hidden");
}

// A click through the hole meets what lies behind.
TEST(hiding, what_is_hidden_is_neither_picked_nor_in_the_way) {
  const auto session = laid_out("torus.off");
  const glm::dvec2 pixel = middle_of(*session, Face(0));
  std::vector<std::uint32_t> met;
  for (auto picked = session->pointing.pick(pixel, PickMode::face); picked;
       picked = session->pointing.pick(pixel, PickMode::face)) {
    met.push_back(picked->element.index);
    ASSERT_LE(met.size(), 4u);
    run(*session, {("hide f" + std::to_string(met.back())).c_str()});
  }
  EXPECT_GE(met.size(), 2u);
  run(*session, {"unhide"});
  EXPECT_EQ(session->pointing.pick(pixel, PickMode::face)->element, Element(Face(met[0])));

  EXPECT_EQ(session->run("box 1,1 2,2").sentence.en,
            "nothing lies wholly in there and is seen; 0 elements are selected");
  EXPECT_EQ(session->run("box 1,1 2,2 through").sentence.en, "nothing lies wholly in there; 0 elements are selected");
  run(*session, {"mode face", "hide f0..f9", "box 0,0 640,480 through"});
  EXPECT_EQ(session->selecting.selection.size(), session->mesh().live().faces - 10);
  run(*session, {"isolate f0..f9"});
  for (const PickMode mode : {PickMode::vertex, PickMode::edge, PickMode::face}) {
    Session anew(Document::open(test::asset("torus.off")).value());
    anew.view.size = session->view.size;
    anew.view.camera = session->view.camera;
    anew.run("isolate f0..f9");  // before there is a tree to pick from
    for (int x = 5; x < 640; x += 11)
      for (int y = 3; y < 480; y += 13) {
        const auto a = session->pointing.pick({x, y}, mode), b = anew.pointing.pick({x, y}, mode);
        ASSERT_EQ(a.has_value(), b.has_value());
        if (a) {
          ASSERT_EQ(a->element, b->element);
          ASSERT_FALSE(session->findings().hidden().hides(session->mesh(), a->element));
        }
      }
  }
}

TEST(hiding, follows_edits_undo_and_redo) {
  const auto session = laid_out("torus.off");
  run(*session, {"hide f0 f1 f2 f3", "delete f1"});
  EXPECT_EQ(session->findings().hidden().faces().to_vector(), (std::vector<std::uint32_t>{0, 2, 3}));
  run(*session, {"undo"});
  EXPECT_EQ(session->findings().hidden().faces().to_vector(), (std::vector<std::uint32_t>{0, 2, 3}))
      << "what comes back is seen";
  run(*session, {"redo", "undo", "select f8", "poke selected"});
  for (std::uint32_t i = 0; i < session->mesh().face_slots(); ++i)
    EXPECT_EQ(session->findings().hidden().hides(session->mesh(), Face(i)), i == 0 || i == 2 || i == 3) << i;
  run(*session, {"select f5", "move_vertex v1 0,0,9", "select none", "hide f5", "undo"});
  EXPECT_TRUE(session->selecting.selection.empty()) << "what was selected then is hidden now";
}

TEST(hiding, ends_where_everything_is_numbered_anew_or_replaced) {
  const auto session = laid_out("misoriented.obj");
  run(*session, {"hide f0", "orient"});
  EXPECT_TRUE(session->findings().hidden().empty());
  run(*session, {"hide f0", "new"});
  EXPECT_TRUE(session->findings().hidden().empty());
}

}  // namespace
}  // namespace ryosen
