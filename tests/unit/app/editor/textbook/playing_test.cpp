// What is played is shown beside the document: nothing saves, counts, picks, clicks or selects the mesh of a step.
#include "app/editor/textbook/playing.h"

#include <gtest/gtest.h>

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "ryosen/ops/all.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

std::unique_ptr<Session> playing_session(const std::string& asset) {
  auto document = Document::open(test::asset(asset));
  EXPECT_TRUE(document);
  return std::make_unique<Session>(std::move(document).value());
}

void do_all(Session& session, std::initializer_list<const char*> lines) {
  for (const char* const line : lines) {
    const Outcome outcome = session.run(line);
    EXPECT_TRUE(outcome.done()) << line << ": " << outcome.sentence.en;
  }
}

// Over all of the view.
template <class Visit>
void over_the_view(const Session& session, Visit visit) {
  for (int x = 20; x < session.view.size.width; x += 60)
    for (int y = 20; y < session.view.size.height; y += 60) visit(glm::dvec2(x, y));
}

TEST(playing, what_is_written_is_the_document) {
  const auto session = playing_session("cube.obj");
  const std::uint64_t hash = session->mesh().hash();
  const std::vector<glm::dvec3> positions = session->document().contents().mesh.positions;
  do_all(*session, {"steps script square", "steps last"});
  ASSERT_NE(session->mesh().hash(), hash) << "the view shows the step";
  EXPECT_EQ(session->document().contents().mesh.positions, positions);
  test::TemporaryFolder folder;
  ASSERT_TRUE(session->document().save(folder.at("out.obj")));
  EXPECT_EQ(Document::open(folder.at("out.obj")).value()->mesh().live().vertices, 8u);
  EXPECT_NE(session->mesh().hash(), hash) << "it is still shown";
}

TEST(playing, lines_about_elements_see_the_document_and_the_player_goes_on) {
  const auto session = playing_session("cube.obj");
  do_all(*session, {"steps script square", "steps at 5", "expect V 8", "select v7", "measure v0 v7", "expect F 6"});
  EXPECT_EQ(session->selecting.selection, Elements{Vertex(7)});
  ASSERT_TRUE(session->shown.player());
  EXPECT_FALSE(session->shown.shows(ShownBy::step));
  do_all(*session, {"steps forward"});
  EXPECT_EQ(session->shown.player()->position(), 6u);
  EXPECT_TRUE(session->shown.shows(ShownBy::step));
  EXPECT_TRUE(session->selecting.selection.empty());
}

TEST(playing, a_tool_points_at_nothing_of_a_step) {
  const auto session = playing_session("figures/000-3.obj");
  do_all(*session, {"new", "steps script cube", "steps last"});
  const std::uint64_t shown = session->mesh().hash();
  for (const OpInfo& op : all_ops()) {
    if (!session->run("tool " + std::string(op.id)).done()) continue;  // one that no click does
    over_the_view(*session, [&](glm::dvec2 pixel) {
      session->pointing.point_at(pixel);
      EXPECT_FALSE(session->selecting.hover()) << op.id;
    });
  }
  EXPECT_EQ(session->mesh().hash(), shown);
}

TEST(playing, a_tool_in_hand_that_is_refused_does_not_end_what_begins_to_be_shown) {
  const auto session = playing_session("cube.obj");
  do_all(*session, {"tool collapse"});
  over_the_view(*session, [&](glm::dvec2 pixel) { session->pointing.point_at(pixel); });
  session->pointing.point_at({640, 360});
  do_all(*session, {"steps script square", "steps last"});
  EXPECT_TRUE(session->shown.is_replaced());
}

TEST(playing, clicks_leave_the_step_and_select_nothing) {
  const auto session = playing_session("cube.obj");
  do_all(*session, {"mode face", "select f0", "steps script square", "steps last"});
  const std::uint64_t shown = session->mesh().hash();
  for (const char* const tool : {"", "poke", "collapse"})
    over_the_view(*session, [&](glm::dvec2 pixel) {
      EXPECT_EQ(session->pointing.click(pixel, tool).exit_code, ExitCode::refused);
      session->pointing.select_for_menu(pixel);
    });
  EXPECT_EQ(session->run("box 0,0 1279,719").exit_code, ExitCode::refused);
  do_all(*session, {"camera {}", "view front", "mode edge", "show creases on"});
  EXPECT_EQ(session->mesh().hash(), shown);
  EXPECT_TRUE(session->selecting.selection.empty());
  do_all(*session, {"steps close"});
  EXPECT_EQ(session->selecting.selection, Elements{Face(0)});
  EXPECT_TRUE(session->document().history().empty());
}

// It cannot be seen then: a key took away what was selected of the mesh beneath.
TEST(playing, the_mesh_beneath_is_not_edited) {
  const auto session = playing_session("cube.obj");
  for (const char* const shows : {"steps script square", "levels"}) {
    do_all(*session, {"mode face", "select f0", shows});
    do_all(*session, {std::string(shows) == "levels" ? "levels at 4" : "steps last"});
    ASSERT_TRUE(session->shown.is_replaced()) << shows;
    const std::uint64_t shown = session->mesh().hash();
    for (const char* const line : {"delete selected", "weld selected mid", "duplicate elements=selected",
                                   "either extrude selected | extrude_edges selected", "delete f1", "cube", "repair",
                                   "gesture move", "gesture extrude", "gesture duplicate", "key E", "key Shift+D",
                                   "key O", "ask extrude f0", "remedy", "values mirror"}) {
      const Outcome outcome = session->run(line);
      EXPECT_EQ(outcome.exit_code, ExitCode::refused) << line;
      EXPECT_NE(outcome.sentence.en.find("Esc or "), std::string::npos) << outcome.sentence.en;
      EXPECT_EQ(session->mesh().hash(), shown) << line;
    }
    do_all(*session, {std::string(shows) == "levels" ? "levels close" : "steps close"});
    EXPECT_TRUE(session->document().history().empty());
    EXPECT_EQ(session->selecting.selection, Elements{Face(0)});
  }
  do_all(*session, {"delete selected"});
  EXPECT_EQ(session->mesh().live().faces, 5u);
}

TEST(playing, a_gesture_beneath_that_is_given_up_ends_nothing) {
  const auto session = playing_session("cube.obj");
  for (const bool is_level : {false, true}) {
    do_all(*session, {"select f0", is_level ? "levels" : "steps script square"});
    do_all(*session, {is_level ? "levels at 4" : "steps last", "select f0"});
    ASSERT_FALSE(session->shown.is_replaced()) << "the mesh beneath is seen";
    do_all(*session, {"gesture extrude", "key Escape", is_level ? "levels at 4" : "steps last"});
    EXPECT_TRUE(session->shown.is_replaced());
    EXPECT_TRUE(session->document().history().empty());
  }
}

// One of both is there at a time, and what goes is told.
TEST(playing, steps_end_levels_and_levels_end_steps) {
  const auto session = playing_session("cube.obj");
  do_all(*session, {"levels", "levels at 4"});
  const Outcome played = session->run("steps script square");
  ASSERT_TRUE(played.done());
  EXPECT_NE(played.sentence.en.find("levels of detail are left"), std::string::npos) << played.sentence.en;
  EXPECT_FALSE(session->shown.levels());
  do_all(*session, {"steps last"});
  EXPECT_TRUE(session->shown.is_replaced());
  const Outcome levelled = session->run("levels");
  ASSERT_TRUE(levelled.done());
  EXPECT_NE(levelled.sentence.en.find("The steps of 'A square' are left."), std::string::npos) << levelled.sentence.en;
  EXPECT_FALSE(session->shown.player());
  do_all(*session, {"levels at 4"});
  EXPECT_EQ(session->mesh().live().faces, 4u);
}

TEST(playing, an_exercise_over_a_step_says_what_is_shown) {
  const auto session = playing_session("cube.obj");
  do_all(*session, {"new", "steps script cube", "steps at 9"});
  const Outcome outcome = session->run("exercise square");
  EXPECT_EQ(outcome.exit_code, ExitCode::refused);
  EXPECT_NE(outcome.sentence.en.find("Esc or steps close ends that"), std::string::npos) << outcome.sentence.en;
}

TEST(playing, what_was_selected_hidden_measured_and_found_comes_back) {
  const auto session = playing_session("figures/003-image41.obj");
  do_all(*session, {"mode face", "select f0", "hide f3", "measure f0", "self_intersections", "steps collapse 0-1"});
  const std::vector<std::uint32_t> found =
      session->findings().highlights().of(ProblemKind::self_intersection).to_vector();
  do_all(*session, {"steps last"});
  ASSERT_TRUE(session->shown.is_replaced());
  EXPECT_TRUE(session->selecting.selection.empty());
  EXPECT_TRUE(session->findings().hidden().empty());
  do_all(*session, {"steps first"});
  EXPECT_FALSE(session->shown.is_replaced());
  EXPECT_EQ(session->selecting.selection, Elements{Face(0)});
  do_all(*session, {"steps last", "steps close"});
  EXPECT_EQ(session->selecting.selection, Elements{Face(0)});
  EXPECT_EQ(session->selecting.measures.size(), 1u);
  EXPECT_TRUE(session->findings().hidden().hides(session->mesh(), Face(3)));
  EXPECT_EQ(session->findings().highlights().of(ProblemKind::self_intersection).to_vector(), found);
  EXPECT_TRUE(session->findings().has_searched(ProblemKind::self_intersection));
}

TEST(playing, findings_outlive_a_gesture_that_is_given_up) {
  MeshFile file;  // two triangles that cross
  file.mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}, {2, 2, 0.5}};
  file.mesh.corners = {0, 1, 2, 3, 4, 5};
  file.mesh.face_offsets = {0, 3, 6};
  Session session(std::make_unique<Document>(std::move(file)));
  do_all(session, {"self_intersections", "select f0", "gesture extrude"});
  session.gesturing.cancel();
  EXPECT_EQ(session.selecting.selection, Elements{Face(0)});
  EXPECT_TRUE(session.findings().has_searched(ProblemKind::self_intersection));
  EXPECT_EQ(session.findings().highlights().of(ProblemKind::self_intersection).size(), 2u);
}

TEST(playing, a_mesh_that_is_pulled_is_not_written_and_not_asked) {
  const auto session = playing_session("cube.obj");
  do_all(*session, {"select f0", "gesture extrude"});
  ASSERT_NE(session->mesh().live().faces, 6u);
  EXPECT_EQ(session->document().contents().mesh.face_offsets.size(), 7u);
  do_all(*session, {"expect F 6"});
  EXPECT_FALSE(session->gesturing.is_active());
}

TEST(playing, players_differ_though_one_takes_the_place_of_the_other) {
  const auto session = playing_session("cube.obj");
  do_all(*session, {"steps walk v0"});
  const std::uint64_t first = session->shown.player()->serial();
  do_all(*session, {"steps walk v5"});
  EXPECT_NE(session->shown.player()->serial(), first);
}

TEST(playing, what_begins_with_nothing_is_seen_whole_whatever_was_looked_at) {
  const auto session = playing_session("cube.obj");
  session->run("view top");
  const Camera before = session->view.camera;
  do_all(*session, {"steps script cube_with_hole", "steps last"});
  const Mesh& mesh = session->mesh();
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const auto at = project(session->view.camera, session->view.size, mesh.position(Vertex(i)));
    ASSERT_TRUE(at) << i;
    EXPECT_TRUE(at->pixel.x >= 0 && at->pixel.y >= 0 && at->pixel.x < session->view.size.width &&
                at->pixel.y < session->view.size.height)
        << i;
  }
  do_all(*session, {"steps close"});
  EXPECT_EQ(session->view.camera, before);
  do_all(*session, {"steps walk v0"});
  EXPECT_EQ(session->view.camera, before) << "on the mesh that is open nobody moves it";
}

}  // namespace
}  // namespace ryosen
