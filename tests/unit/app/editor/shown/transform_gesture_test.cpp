#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <glm/geometric.hpp>

#include "app/editor/commands/commands.h"
#include "app/editor/input/view/view_input.h"
#include "app/editor/labels/labels.h"
#include "app/editor/session/session.h"
#include "app/ui/headless.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/names.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class GestureTest : public testing::Test {
 protected:
  GestureTest() : session_(open()) {
    session_->run("mode vertex");
    session_->run("select v0");
    session_->run("select grow");
    session_->run("move 640,360");
  }
  static std::unique_ptr<Session> open() {
    auto document = Document::open(test::asset("torus.off"));
    EXPECT_TRUE(document);
    return std::make_unique<Session>(std::move(document).value());
  }
  void run(std::initializer_list<const char*> lines) {
    for (const char* line : lines) {
      const Outcome outcome = session_->run(line);
      EXPECT_TRUE(outcome.done()) << line << ": " << outcome.sentence.en;
    }
  }
  std::vector<glm::dvec3> places() const {
    return {session_->mesh().positions().begin(), session_->mesh().positions().end()};
  }

  std::unique_ptr<Session> session_;
};

TEST_F(GestureTest, changes_only_the_view_until_it_ends_as_one_entry) {
  const std::uint64_t hash = session_->mesh().hash();
  run({"key G", "move 700,300"});
  ASSERT_TRUE(session_->gesturing.is_active());
  EXPECT_EQ(session_->mesh().hash(), hash);
  EXPECT_NE(session_->gesturing.drawn_positions()[0], session_->mesh().position(Vertex(0)));
  const std::vector<glm::dvec3> shown(session_->gesturing.drawn_positions().begin(),
                                      session_->gesturing.drawn_positions().end());
  run({"press left 700,300", "release left 700,300"});
  EXPECT_FALSE(session_->gesturing.is_active());
  EXPECT_EQ(session_->document().history().size(), 1u);
  ASSERT_EQ(session_->log().size(), 1u);
  EXPECT_TRUE(session_->log()[0].starts_with("translate by=")) << session_->log()[0];
  EXPECT_EQ(places(), shown) << "as it was shown";
  run({"undo"});
  EXPECT_EQ(session_->mesh().hash(), hash);
}

TEST_F(GestureTest, escape_costs_nothing_and_so_does_the_right_button) {
  const std::uint64_t hash = session_->mesh().hash();
  for (const char* end : {"key Escape", "press right 700,300"}) {
    run({"key G", "move 700,300", end});
    EXPECT_FALSE(session_->gesturing.is_active());
    EXPECT_TRUE(session_->log().empty());
    EXPECT_EQ(session_->mesh().hash(), hash);
    EXPECT_EQ(session_->gesturing.drawn_positions().data(), session_->mesh().positions().data());
    session_->run("release right 700,300");
  }
  EXPECT_FALSE(session_->selecting.selection.empty());
}

TEST_F(GestureTest, typed_numbers_and_axes_are_exact) {
  const std::vector<glm::dvec3> before = places();
  run({"key G", "key Z", "key -", "key 1", "key .", "key 2", "key 5", "key Enter"});
  for (const Element& e : session_->selecting.selection)
    EXPECT_EQ(session_->mesh().position(e.vertex()), before[e.index] + glm::dvec3(0, 0, -1.25));
  run({"undo", "key R", "key Y", "key 1", "key 8", "key 0", "key Enter"});
  EXPECT_TRUE(session_->log().back().starts_with("rotate angle=180 axis=0,1,0 about=")) << session_->log().back();
  run({"undo", "key Shift+S", "key 2", "key Enter"});
  EXPECT_TRUE(session_->log().back().starts_with("scale factor=2 about=")) << session_->log().back();
  EXPECT_EQ(session_->document().history().size(), 1u);
}

std::uint32_t flat_faces(Session& session) {
  return session.findings().highlights().count(ProblemKind::degenerate_area);
}

// While faces are pulled out their sides are where they are drawn, not where the operator on trial has put them.
TEST_F(GestureTest, lists_no_face_that_only_the_trial_leaves_without_area) {
  session_->set_document(std::move(Document::open(test::asset("cube.obj"))).value());
  EXPECT_EQ(flat_faces(*session_), 0u);
  run({"mode face", "select f0", "move 600,300", "key E"});
  EXPECT_EQ(session_->mesh().live().faces, 10u);
  EXPECT_EQ(flat_faces(*session_), 0u) << "nothing has been pulled yet";
  run({"move 700,350"});
  ASSERT_TRUE(session_->gesturing.is_active());
  EXPECT_EQ(flat_faces(*session_), 0u);
  run({"key Escape"});
  EXPECT_EQ(session_->mesh().live().faces, 6u);
  EXPECT_EQ(flat_faces(*session_), 0u);
  run({"key E", "move 640,420", "key Enter"});
  EXPECT_EQ(session_->document().history().size(), 1u);
  EXPECT_EQ(flat_faces(*session_), 0u);
}

TEST_F(GestureTest, lists_faces_that_it_flattens_until_it_is_given_up) {
  session_->set_document(std::move(Document::open(test::asset("cube.obj"))).value());
  run({"mode face", "select all", "triangulate selected", "mode vertex", "select v0", "move 600,300"});
  const Mesh& mesh = session_->mesh();
  ASSERT_EQ(mesh.position(Vertex(1)) - mesh.position(Vertex(0)), glm::dvec3(1, 0, 0));
  ASSERT_TRUE(find_halfedge(mesh, Vertex(0), Vertex(1)));
  session_->findings().highlights();
  const ChangeFeed::Cursor before = session_->findings().changes().since({}).now;
  run({"key G", "key X", "key 1"});
  EXPECT_EQ(flat_faces(*session_), 2u) << "those at the edge that has no length any more";
  const std::vector<ChangeFeed::Marked> marks = session_->findings().changes().since(before).marks;
  EXPECT_GE(std::count_if(marks.begin(), marks.end(),
                          [](const ChangeFeed::Marked& m) { return m.mark.sort == Element::Kind::face; }),
            2);
  run({"key Escape"});
  EXPECT_EQ(flat_faces(*session_), 0u);
}

TEST_F(GestureTest, a_movement_of_what_an_operator_makes_is_called_by_its_name) {
  session_->set_document(std::move(Document::open(test::asset("cube.obj"))).value());
  const auto told = [&] { return session_->gesturing.transform()->told(); };
  run({"select f0", "move 600,300", "key E", "key 1"});
  EXPECT_EQ(told().en, "Extrude faces N 1 [1]");
  EXPECT_EQ(told().ja, "面の押し出し N 1 [1]");
  run({"key Escape", "select 0-1", "key E"});
  EXPECT_TRUE(told().en.starts_with("Extrude edges ")) << told().en;
  run({"key Escape", "gesture split"});
  EXPECT_TRUE(told().en.starts_with("Split edge ")) << told().en;
  run({"key Escape", "key G"});
  EXPECT_TRUE(told().en.starts_with("Move ")) << told().en;
}

TEST_F(GestureTest, the_pointer_stays_at_what_it_took_hold_of) {
  const glm::dvec3 held = session_->run("key G").done() ? session_->gesturing.transform()->middle() : glm::dvec3();
  run({"move 740,280"});
  const auto before = project(session_->view.camera, session_->view.size, held);
  run({"press left 740,280", "release left 740,280"});
  std::vector<Vertex> points;
  for (const Element& e : session_->selecting.selection) points.push_back(e.vertex());
  const auto after = project(session_->view.camera, session_->view.size, middle_of(session_->mesh(), points));
  EXPECT_NEAR(after->pixel.x - before->pixel.x, 100, 1e-6);
  EXPECT_NEAR(after->pixel.y - before->pixel.y, -80, 1e-6);
}

class SnapTest : public GestureTest {
 protected:
  glm::dvec2 pixel_of(Vertex v) const {
    return project(session_->view.camera, session_->view.size, session_->mesh().position(v))->pixel;
  }
  static std::string at(glm::dvec2 pixel) { return std::to_string(pixel.x) + "," + std::to_string(pixel.y); }
  bool is_selected(Vertex v) const {
    return std::find(session_->selecting.selection.begin(), session_->selecting.selection.end(), Element(v)) !=
           session_->selecting.selection.end();
  }
  // One that is in sight, and selected or not.
  Vertex seen_vertex(bool selected) {
    for (std::uint32_t i = 0; i < session_->mesh().vertex_slots(); ++i) {
      const auto picked = session_->pointing.pick(pixel_of(Vertex(i)), PickMode::vertex);
      if (is_selected(Vertex(i)) == selected && picked && picked->element == Element(Vertex(i))) return Vertex(i);
    }
    ADD_FAILURE() << "none is in sight";
    return {};
  }
  void run_line(const std::string& line) {
    const Outcome outcome = session_->run(line);
    EXPECT_TRUE(outcome.done()) << line << ": " << outcome.sentence.en;
  }
  void open_off(const std::string& text) {
    const std::string path = testing::TempDir() + "snap_test.off";
    std::ofstream(path) << text;
    session_->set_document(std::move(Document::open(path)).value());
    run({"view front", "projection orthographic", "mode face", "select f0"});
  }
  std::string told() const { return session_->gesturing.transform()->told().en; }
  // The line that the gesture ends with does the same to the mesh as it was.
  void expect_replays_from(const std::string& undo) {
    const std::uint64_t hash = session_->mesh().hash();
    const std::string line = session_->log().back();
    run_line(undo);
    EXPECT_NE(session_->mesh().hash(), hash);
    run_line(line);
    EXPECT_EQ(session_->mesh().hash(), hash) << line;
  }
};

TEST_F(SnapTest, the_point_that_is_held_lands_on_a_vertex_near_the_pointer_exactly) {
  const Vertex held = seen_vertex(true), other = seen_vertex(false);
  run_line("move " + at(pixel_of(held)));
  const glm::dvec2 near = pixel_of(other) + glm::dvec2(7, -6);  // farther than what a click picks
  run({"key G"});
  run_line("move " + at(near) + " Ctrl");
  EXPECT_EQ(session_->gesturing.drawn_positions()[held.index], session_->mesh().position(other));
  const std::string named = slot_name(Element(held)) + " on " + slot_name(Element(other));
  EXPECT_TRUE(told().ends_with(", " + named)) << told();
  const auto labels = placed_labels(
      *session_,
      [](const std::string&) {
        return Size{30, 12};
      },
      1);
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(),
                          [&](const PlacedLabel& label) { return label.text == slot_name(Element(other)); }));
  run_line("press left " + at(near) + " Ctrl");
  EXPECT_EQ(session_->mesh().position(held), session_->mesh().position(other));
  expect_replays_from("undo");
}

// Where the pointer is at no point of it.
TEST_F(SnapTest, the_middle_lands_where_no_point_is_held) {
  const Vertex other = seen_vertex(false);
  run({"move 640,120", "key G"});
  run_line("move " + at(pixel_of(other)) + " Ctrl");
  run_line("press left " + at(pixel_of(other)) + " Ctrl");
  std::vector<Vertex> points;
  for (const Element& e : session_->selecting.selection) points.push_back(e.vertex());
  EXPECT_NEAR(glm::distance(middle_of(session_->mesh(), points), session_->mesh().position(other)), 0, 1e-9);
}

// An edge from v4 to v5 along X, and a face above it.
constexpr const char* square_and_others =
    "OFF\n8 2 0\n-3 0 1\n-2 0 1\n-2 1 1\n-3 1 1\n0 -1 0\n3 -1 0\n3 2 0\n0 2 0\n4 0 1 2 3\n4 4 5 6 7\n";

TEST_F(SnapTest, lands_on_an_edge_and_on_a_face_and_else_goes_in_steps_of_the_ground) {
  open_off(square_and_others);
  const glm::dvec2 from = pixel_of(Vertex(1)), a = pixel_of(Vertex(4)), b = pixel_of(Vertex(6));
  run_line("move " + at(from));
  run({"key G"});
  run_line("move " + at({0.5 * (a.x + b.x), a.y + 3}) + " Ctrl");
  EXPECT_EQ(session_->gesturing.drawn_positions()[1].y, -1);
  EXPECT_EQ(session_->gesturing.drawn_positions()[1].z, 0);
  EXPECT_TRUE(told().ends_with(", v1 on edge 4-5")) << told();
  run_line("move " + at(0.5 * (a + b)) + " Ctrl");
  EXPECT_NEAR(session_->gesturing.drawn_positions()[1].z, 0, 1e-12);
  EXPECT_TRUE(told().ends_with(", v1 on f1")) << told();
  run({"key X"});
  EXPECT_TRUE(told().ends_with(", v1 level with f1")) << told();
  EXPECT_EQ(session_->gesturing.drawn_positions()[1].z, 1);
  run({"key X"});

  // Seven cells of the ground at 0.5 are 6 units wide.
  const double unit_px = pixel_of(Vertex(5)).x - a.x;
  run_line("move " + at(from + glm::dvec2(0.62, 0.55) * unit_px / 3.0) + " Ctrl");
  EXPECT_EQ(session_->gesturing.drawn_positions()[1], glm::dvec3(-1.5, -0.5, 1));
  EXPECT_TRUE(told().ends_with(", in steps of 0.5")) << told();
  run_line("move " + at(from + glm::dvec2(0.62, 0.55) * unit_px / 3.0) + " Ctrl+Shift");
  EXPECT_EQ(session_->gesturing.drawn_positions()[1], glm::dvec3(-2, 0, 1) + glm::dvec3(0.6, -0.55, 0));
  EXPECT_TRUE(told().ends_with(", in steps of 0.05")) << told();
  run({"key Enter"});
  EXPECT_TRUE(session_->log().back().starts_with("translate by=0.6,-0.55,0 ")) << session_->log().back();
  expect_replays_from("undo");
}

TEST_F(SnapTest, steps_are_tenths_where_a_cell_would_be_wider_than_the_hand_goes) {
  open_off(square_and_others);
  run_line("move " + at(pixel_of(Vertex(1))));
  run_line("wheel 12 " + at(pixel_of(Vertex(1))));
  const glm::dvec2 from = pixel_of(Vertex(1));
  run_line("move " + at(from));
  run({"key G"});
  run_line("move " + at(from + glm::dvec2(80, 0)) + " Ctrl");
  EXPECT_TRUE(told().ends_with(", in steps of 0.05")) << told();
  EXPECT_GT(session_->gesturing.drawn_positions()[1].x, -2);
}

// What is moved is no longer where the mesh has it.
TEST_F(SnapTest, what_is_moved_is_not_in_the_way_of_what_lay_behind_it) {
  open_off(
      "OFF\n9 2 0\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n-.5 -.5 0\n.5 -.5 0\n.5 .5 0\n-.5 .5 0\n3 0 0\n"
      "4 0 1 2 3\n4 4 5 6 7\n");
  run_line("move " + at(pixel_of(Vertex(2))));
  const glm::dvec2 behind = pixel_of(Vertex(6));
  run({"key G"});
  run_line("move " + at(behind) + " Ctrl");
  EXPECT_EQ(session_->gesturing.drawn_positions()[2], session_->mesh().position(Vertex(6))) << told();
}

TEST_F(GestureTest, falloff_takes_more_along_and_the_wheel_widens_it) {
  run({"key G", "key O"});
  const std::size_t few = session_->gesturing.transform()->moved().size();
  for (int i = 0; i < 20; ++i) session_->run("wheel 1 640,360");
  EXPECT_GT(session_->gesturing.transform()->moved().size(), few);
  run({"key X", "key 1", "key Enter"});
  EXPECT_NE(session_->log().back().find("falloff="), std::string::npos);
}

TEST_F(GestureTest, marks_faces_that_turn_over) {
  run({"key Shift+S", "key -", "key 3"});
  EXPECT_FALSE(session_->gesturing.spoilt().empty());
  run({"key Escape"});
  EXPECT_TRUE(session_->gesturing.spoilt().empty());
}

TEST_F(GestureTest, needs_a_selection_and_gives_way_to_an_edit) {
  run({"select none"});
  EXPECT_EQ(session_->run("gesture move").exit_code, ExitCode::refused);
  run({"select v3", "gesture move", "move 700,300", "poke f0"});
  EXPECT_FALSE(session_->gesturing.is_active());
  EXPECT_EQ(session_->log(), std::vector<std::string>{"poke f0"});
}

TEST_F(GestureTest, a_key_of_an_axis_shows_at_once_what_the_pointer_says_along_it) {
  run({"key G", "move 700,300", "key X"});
  const Vertex v = session_->selecting.selection[0].vertex();
  const glm::dvec3 moved = session_->gesturing.drawn_positions()[v.index] - session_->mesh().position(v);
  EXPECT_NE(moved.x, 0);
  EXPECT_EQ(moved.y, 0);
  EXPECT_EQ(moved.z, 0);
}

TEST_F(GestureTest, extruding_is_one_entry_along_the_normal_of_the_faces_or_nothing) {
  const std::uint64_t hash = session_->mesh().hash();
  run({"mode face", "select f0 f1", "key E"});
  ASSERT_TRUE(session_->gesturing.is_active());
  EXPECT_FALSE(session_->gesturing.transform()->movement() &&
               *session_->gesturing.transform()->movement() != glm::dvec3(0))
      << "by nothing yet";
  run({"key Escape"});
  EXPECT_EQ(session_->mesh().hash(), hash);
  EXPECT_EQ(session_->document().position(), 0u);
  run({"key E", "key 2", "key Enter"});
  EXPECT_EQ(session_->document().history().size(), 1u);
  EXPECT_TRUE(session_->document().history()[0].command.starts_with("extrude f0 f1 "))
      << session_->document().history()[0].command;
  EXPECT_EQ(session_->selecting.selection, (Elements{Face(0), Face(1)}));
  const std::uint64_t moved = session_->mesh().hash();
  const auto again = open();
  for (const std::string& line : session_->log()) ASSERT_TRUE(again->run(line).done()) << line;
  EXPECT_EQ(again->mesh().hash(), moved);
  run({"undo"});
  EXPECT_EQ(session_->mesh().hash(), hash);
}

TEST_F(GestureTest, extruding_edges_is_one_entry_and_goes_on_from_the_new_ones) {
  const std::uint64_t hash = session_->mesh().hash();
  const std::string edge = name_of(session_->mesh(), Edge(0)), select = "select " + edge;
  run({"mode edge", select.c_str(), "key E"});
  ASSERT_TRUE(session_->gesturing.is_active());
  ASSERT_EQ(session_->selecting.selection.size(), 1u);
  EXPECT_NE(name_of(session_->mesh(), session_->selecting.selection[0]), edge) << "what moves";
  EXPECT_EQ(flat_faces(*session_), 0u) << "nothing has moved yet";
  run({"key Escape"});
  EXPECT_EQ(session_->mesh().hash(), hash);
  EXPECT_TRUE(session_->document().history().empty());
  EXPECT_EQ(session_->selecting.selection, Elements{Edge(0)});
  run({"key E", "key Z", "key 2", "key Enter"});
  ASSERT_EQ(session_->document().history().size(), 1u);
  EXPECT_EQ(session_->document().history()[0].command, "extrude_edges " + edge + " 0,0,2");
  ASSERT_EQ(session_->selecting.selection.size(), 1u);
  const Element top = session_->selecting.selection[0];
  ASSERT_EQ(top.kind, Element::Kind::edge);
  EXPECT_NE(name_of(session_->mesh(), top), edge) << "the new edge";
  run({"key E", "key Z", "key 1", "key Enter"});
  EXPECT_EQ(session_->document().history()[1].command, "extrude_edges " + name_of(session_->mesh(), top) + " 0,0,1");
  const std::uint64_t moved = session_->mesh().hash();
  const auto again = open();
  for (const std::string& line : session_->log()) ASSERT_TRUE(again->run(line).done()) << line;
  EXPECT_EQ(again->mesh().hash(), moved);
  run({"undo", "undo"});
  EXPECT_EQ(session_->mesh().hash(), hash);
}

// Anywhere: where the pointer leaves it, as one entry.
TEST_F(GestureTest, splitting_puts_the_vertex_wherever_the_pointer_leaves_it) {
  const std::uint64_t hash = session_->mesh().hash();
  run({"mode edge", "select 0-1", "key Shift+E"});
  ASSERT_TRUE(session_->gesturing.is_active());
  run({"key Escape"});
  EXPECT_EQ(session_->mesh().hash(), hash);
  EXPECT_TRUE(session_->document().history().empty());
  run({"select 0-1", "move 500,300", "key Shift+E", "move 560,350"});
  const Vertex made = session_->gesturing.transform()->moved()[0].point;
  const glm::dvec3 shown = session_->gesturing.drawn_positions()[made.index];
  run({"press left 560,350", "release left 560,350"});
  EXPECT_FALSE(session_->gesturing.is_active());
  ASSERT_EQ(session_->document().history().size(), 1u);
  EXPECT_TRUE(session_->document().history()[0].command.starts_with("split 0-1 "));
  EXPECT_NEAR(glm::length(session_->mesh().position(made) - shown), 0, 1e-12) << "what was shown is what is there";
  const glm::dvec3 &a = session_->mesh().position(Vertex(0)), &b = session_->mesh().position(Vertex(1));
  EXPECT_GT(glm::length(glm::cross(shown - a, b - a)), 0.01 * glm::dot(b - a, b - a)) << "beside the edge";
  const auto again = open();
  for (const std::string& line : session_->log()) ASSERT_TRUE(again->run(line).done()) << line;
  EXPECT_EQ(again->mesh().hash(), session_->mesh().hash());
  run({"undo"});
  EXPECT_EQ(session_->mesh().hash(), hash);
}

// With the tool in hand it begins where the pointer is on the edge; not moved, it is a split there.
TEST_F(GestureTest, splitting_begins_under_the_tool) {
  const Mesh& mesh = session_->mesh();
  run({"tool split"});
  const auto seen = session_->pointing.pick({478, 488}, PickMode::edge);
  ASSERT_TRUE(seen);
  run({"move 478,488", "key Shift+E", "key Enter"});
  ASSERT_EQ(session_->document().history().size(), 1u);
  EXPECT_TRUE(session_->document().history()[0].command.starts_with("split "));
  const Vertex made(mesh.vertex_slots() - 1);
  EXPECT_LT(glm::length(project(session_->view.camera, session_->view.size, mesh.position(made))->pixel -
                        glm::dvec2(478, 488)),
            pick_radius_px + 1);
  run({"tool none", "select none"});
  EXPECT_EQ(session_->run("gesture split").exit_code, ExitCode::refused);
}

// What a hand makes and moves: how it begins, on what is selected, and the line that it ends with.
struct MadeByHand {
  const char *select, *begin, *line;
};
constexpr MadeByHand made_by_hand[] = {{"select f0 f1", "key Shift+D", "duplicate elements=f0,f1 by="},
                                       {"select v3 0-1 f7", "key Shift+D", "duplicate elements="},
                                       {"select all", "gesture duplicate", "duplicate elements="},
                                       {"select f0 f1", "key E", "extrude f0 f1 "},
                                       {"select 0-1", "key E", "extrude_edges "},
                                       {"select 0-1", "key Shift+E", "split 0-1 "}};

class MadeByHandTest : public GestureTest {
 protected:
  std::size_t coincident() { return session_->findings().highlights().count(ProblemKind::coincident_points); }
};

TEST_F(MadeByHandTest, one_hand_is_one_entry_and_one_undo) {
  for (const MadeByHand& made : made_by_hand) {
    SCOPED_TRACE(std::string(made.select) + ", " + made.begin);
    for (const std::initializer_list<const char*> moved :
         {std::initializer_list<const char*>{"move 740,280", "press left 740,280", "release left 740,280"},
          {"key Z", "key 3", "key Enter"},
          {"move 700,300", "key X", "key Enter"},
          {"key O", "move 700,300", "wheel 3 700,300", "key O", "key Enter"},
          {"key Shift+Y", "move 720,310", "press left 720,310", "release left 720,310"}}) {
      session_ = open();
      run({"poke f9", "move 640,360"});
      const std::uint64_t before = session_->mesh().hash();
      const std::size_t lay_on_others = coincident();
      run({made.select, made.begin});
      EXPECT_EQ(coincident(), lay_on_others) << "nothing is listed that is only on trial";
      run(moved);
      EXPECT_FALSE(session_->gesturing.is_active());
      ASSERT_EQ(session_->document().history().size(), 2u);
      ASSERT_EQ(session_->log().size(), 2u);
      EXPECT_TRUE(session_->log()[1].starts_with(made.line)) << session_->log()[1];
      EXPECT_EQ(session_->document().history()[1].command, session_->log()[1]);
      EXPECT_EQ(coincident(), lay_on_others);
      EXPECT_FALSE(session_->selecting.selection.empty());
      const std::uint64_t after = session_->mesh().hash();
      EXPECT_NE(after, before);
      const auto again = open();
      for (const std::string& line : session_->log()) ASSERT_TRUE(again->run(line).done()) << line;
      EXPECT_EQ(again->mesh().hash(), after) << "as a script";
      run({"undo"});
      EXPECT_EQ(session_->mesh().hash(), before);
      EXPECT_EQ(coincident(), lay_on_others);
      run({"redo"});
      EXPECT_EQ(session_->mesh().hash(), after);
      run({"undo 2"});
      EXPECT_EQ(session_->document().position(), 0u);
      EXPECT_FALSE(session_->run("undo").done());
      run({"redo 2"});
      EXPECT_EQ(session_->mesh().hash(), after);
    }
  }
}

TEST_F(MadeByHandTest, given_up_it_leaves_nothing) {
  const std::vector<std::vector<std::string>> ends{
      {"key Escape"}, {"press right 700,300", "release right 700,300"}, {"undo", "redo"}, {"poke f20", "undo"}};
  for (const MadeByHand& made : made_by_hand)
    for (const std::vector<std::string>& end : ends) {
      SCOPED_TRACE(std::string(made.select) + ", " + made.begin + ", " + end[0]);
      session_ = open();
      run({"poke f10", made.select, "move 640,360"});
      const std::uint64_t before = session_->mesh().hash();
      const Elements selected = session_->selecting.selection;
      run({made.begin, "move 700,300"});
      ASSERT_TRUE(session_->gesturing.is_active());
      EXPECT_NE(session_->mesh().hash(), before);
      std::string said;
      for (const std::string& line : end) said += session_->run(line).sentence.en;
      EXPECT_FALSE(session_->gesturing.is_active());
      EXPECT_EQ(session_->mesh().hash(), before);
      EXPECT_EQ(session_->document().position(), 1u);
      EXPECT_EQ(coincident(), 0u);
      if (end[0] == "undo" || end[0] == "poke f20") continue;
      EXPECT_EQ(session_->selecting.selection, selected);
      EXPECT_EQ(session_->document().history().size(), 1u);
      EXPECT_EQ(session_->log().size(), 1u);
      const bool is_of_copy = std::string_view(made.line).starts_with("duplicate");
      EXPECT_EQ(said.find("No copy is left") != said.npos, is_of_copy) << said;
    }
}

// What ends without a movement is done by nothing, and said.
TEST_F(MadeByHandTest, a_copy_that_is_not_moved_stays_where_that_is_confirmed_and_is_said_and_listed) {
  run({"select f0 f1", "move 640,360", "key Shift+D"});
  EXPECT_EQ(coincident(), 0u);
  const Outcome confirmed = session_->run("key Enter");
  EXPECT_NE(confirmed.sentence.en.find("The copy lies exactly on the original"), std::string::npos)
      << confirmed.sentence.en;
  EXPECT_NE(confirmed.sentence.ja.find("複製は元と"), std::string::npos) << confirmed.sentence.ja;
  EXPECT_EQ(session_->log(), std::vector<std::string>{"duplicate elements=f0,f1 by=0,0,0"});
  EXPECT_EQ(session_->selecting.selection, (Elements{Face(96), Face(97)}));
  EXPECT_EQ(coincident(), 8u) << "four points and their copies";
  run({"undo"});
  EXPECT_EQ(coincident(), 0u);
  EXPECT_EQ(session_->mesh().live().faces, 96u);
}

TEST_F(MadeByHandTest, extruding_by_nothing_is_done_and_said_and_scaling_then_insets) {
  for (const char* const number : {"0", "", "0.0", "-0"})
    for (const char* const select : {"select f0", "select f0 f1", "select 0-1"}) {
      SCOPED_TRACE(std::string(select) + ", " + number);
      session_ = open();
      run({select, "move 640,360"});
      const std::uint64_t before = session_->mesh().hash();
      const bool is_of_edges = std::string_view(select) == "select 0-1";
      const Elements faces = session_->selecting.selection;
      run({"key E"});
      for (const char* c = number; *c; ++c) run({("key " + std::string(1, *c)).c_str()});
      const Outcome outcome = session_->run("key Enter");
      ASSERT_TRUE(outcome.done()) << outcome.sentence.en;
      EXPECT_NE(outcome.sentence.en.find("Extruded by nothing"), std::string::npos) << outcome.sentence.en;
      EXPECT_NE(outcome.sentence.ja.find("移動量ゼロ"), std::string::npos) << outcome.sentence.ja;
      ASSERT_EQ(session_->log().size(), 1u);
      EXPECT_TRUE(session_->log()[0].ends_with(" 0")) << session_->log()[0];
      EXPECT_GT(session_->mesh().live().faces, 96u);
      EXPECT_GT(coincident(), 0u);
      if (!is_of_edges) {
        EXPECT_EQ(session_->selecting.selection, faces);
        run({"key Shift+S", "key .", "key 5", "key Enter"});
        EXPECT_EQ(coincident(), 0u) << "the faces lie within a rim";
        EXPECT_EQ(flat_faces(*session_), 0u);
      }
      const std::uint64_t after = session_->mesh().hash();
      const auto again = open();
      for (const std::string& line : session_->log()) ASSERT_TRUE(again->run(line).done()) << line;
      EXPECT_EQ(again->mesh().hash(), after);
      run({is_of_edges ? "undo" : "undo 2"});
      EXPECT_EQ(session_->mesh().hash(), before);
    }
}

TEST_F(MadeByHandTest, takes_no_falloff_and_says_so) {
  for (const MadeByHand& made : made_by_hand) {
    session_ = open();
    run({made.select, made.begin});
    const Outcome outcome = session_->run("key O");
    EXPECT_NE(outcome.sentence.en.find("moves alone"), std::string::npos) << made.begin;
    EXPECT_FALSE(session_->gesturing.transform()->has_falloff());
    EXPECT_FALSE(session_->gesturing.widen(1));
    run({"key Escape"});
  }
}

TEST_F(MadeByHandTest, a_copy_needs_a_selection) {
  run({"select none"});
  EXPECT_EQ(session_->run("gesture duplicate").exit_code, ExitCode::refused);
  EXPECT_FALSE(session_->gesturing.is_active());
  EXPECT_TRUE(session_->log().empty());
}

TEST_F(GestureTest, extruding_that_is_given_up_leaves_what_can_be_redone_and_what_is_saved) {
  run({"mode face", "select f0 f1", "poke f9", "poke f10", "undo"});
  const std::string saved = testing::TempDir() + "given_up.off";
  ASSERT_TRUE(session_->document().save(saved));
  const std::uint64_t hash = session_->mesh().hash();
  run({"select f0 f1 v3 0-1"});
  const Elements selected = session_->selecting.selection;
  for (const char* end : {"key Escape", "press right 700,300"}) {
    run({"key E"});
    EXPECT_NE(session_->mesh().hash(), hash);
    EXPECT_FALSE(session_->document().is_modified());
    EXPECT_EQ(session_->log().size(), 3u);
    run({"key 3", end});
    EXPECT_FALSE(session_->gesturing.is_active());
    EXPECT_EQ(session_->mesh().hash(), hash);
    EXPECT_EQ(session_->selecting.selection, selected);
    EXPECT_FALSE(session_->document().is_modified());
  }
  run({"release right 700,300", "redo"});
  EXPECT_EQ(session_->document().history().back().command, "poke f10");
  EXPECT_FALSE(session_->run("redo").done());
}

TEST_F(GestureTest, whatever_edits_points_or_goes_back_ends_an_extrusion_first) {
  run({"mode face", "poke f9", "select f0 f1"});
  const std::uint64_t hash = session_->mesh().hash();
  run({"key E", "undo"});
  EXPECT_FALSE(session_->gesturing.is_active());
  EXPECT_EQ(session_->document().position(), 0u);
  run({"redo"});
  EXPECT_EQ(session_->mesh().hash(), hash);
  EXPECT_FALSE(session_->run("redo").done());
  run({"select f0 f1", "key E", "poke f20"});
  EXPECT_EQ(session_->document().history().size(), 2u);
  run({"undo"});
  EXPECT_EQ(session_->mesh().hash(), hash);
  run({"select f0 f1", "key E"});
  EXPECT_FALSE(session_->run("select v100000").done()) << "and asks whether it was there at another time";
  EXPECT_FALSE(session_->gesturing.is_active());
  EXPECT_EQ(session_->mesh().hash(), hash);
  EXPECT_EQ(session_->selecting.selection.size(), 2u) << "the faces that were to be pulled";
  run({"key E"});
  session_->run("click 640,360 poke");
  EXPECT_FALSE(session_->gesturing.is_active());
  EXPECT_EQ(session_->mesh().hash(), hash) << "there is nothing in the middle of a ring";
}

TEST_F(GestureTest, a_button_that_ends_it_is_told_from_one_that_turns_the_view) {
  run({"key G", "press middle 640,360", "press left 640,360", "release middle 640,360"});
  const Camera camera = session_->view.camera;
  run({"release left 640,360", "move 700,400"});
  EXPECT_EQ(session_->view.camera.eye, camera.eye) << "no drag is left over";
}

TEST_F(GestureTest, a_second_dot_types_nothing) {
  run({"key G", "move 700,300", "key X", "key 1", "key .", "key 5", "key .", "key Enter"});
  EXPECT_TRUE(session_->log().back().starts_with("translate by=1.5,0,0 ")) << session_->log().back();
}

// What is drawn while it goes on and afterwards is what would be drawn anew.
TEST_F(GestureTest, a_part_that_is_drawn_again_equals_the_whole) {
  // So that the buffers keep their bounds, and with them every rounding.
  for (const char* line : {"make_vertex -9,-9,-9", "make_vertex 9,9,9"}) session_->run(line);
  auto headless = Headless::make({.backend = Backend::osmesa, .size = {640, 480}}).value();
  headless->place_view(*session_);
  session_->framing.frame_all();
  const auto is_as_drawn_anew = [&] {
    const Image followed = headless->picture(*session_);
    return followed == headless->view_drawn_again();
  };
  const Image before = headless->picture(*session_);
  for (const char* line : {"move 320,240", "key G", "move 380,200", "move 300,300", "key O", "move 350,250",
                           "wheel 3 350,250", "key Z", "move 360,200"}) {
    ASSERT_TRUE(session_->run(line).done());
    EXPECT_TRUE(is_as_drawn_anew()) << line;
  }
  EXPECT_FALSE(headless->picture(*session_) == before);
  session_->run("key Escape");
  EXPECT_TRUE(is_as_drawn_anew());
  headless->forget();  // the guides reached farther than the mesh, and depths are rounded by that
  EXPECT_TRUE(headless->picture(*session_) == before);
  for (const char* line : {"key R", "move 380,200", "key Enter", "undo", "redo"}) {
    ASSERT_TRUE(session_->run(line).done());
    EXPECT_TRUE(is_as_drawn_anew()) << line;
  }
}

}  // namespace
}  // namespace ryosen
