// What the panels of the pointer and of the selected element say.
#include <gtest/gtest.h>

#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

using test::DrawnText;

class InspectorPanel : public testing::Test, protected test::Laid {
 protected:
  InspectorPanel() : Laid("cube.obj", test::tall_window) {}

  std::size_t drawn(const char* text) {
    frames(3);
    return DrawnText(gui).count(text);
  }

  test::TemporaryFolder folder_;
};

TEST_F(InspectorPanel, an_edge_of_two_faces_is_misoriented_and_one_of_three_not_manifold) {
  const char* const points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n";
  const std::string two = folder_.write("two.off", "OFF\n5 2 0\n" + std::string(points) + "3 0 1 2\n3 0 1 3\n");
  const std::string three =
      folder_.write("three.off", "OFF\n5 3 0\n" + std::string(points) + "3 0 1 2\n3 1 0 3\n3 0 1 4\n");
  for (const auto& [file, misoriented, nonmanifold] : {std::tuple(two, 1u, 0u), std::tuple(three, 0u, 1u)}) {
    ASSERT_TRUE(gui.run(session, "open " + file_argument(file)).done());
    ASSERT_TRUE(gui.run(session, "select none").done());
    const std::size_t as_misoriented = drawn("misoriented"), as_nonmanifold = drawn("not manifold");
    ASSERT_TRUE(gui.run(session, "select 0-1@f0").done());
    EXPECT_EQ(drawn("misoriented"), as_misoriented + misoriented) << file;
    EXPECT_EQ(drawn("not manifold"), as_nonmanifold + nonmanifold) << file;
  }
}

TEST_F(InspectorPanel, a_normal_has_no_more_digits_than_are_seen) {
  const std::string file =
      folder_.write("flat.off", "OFF\n3 1 0\n0.1 0.2 0.30000000000000004\n1.1 0.3 0.3\n0.4 1.7 0.3\n3 0 1 2\n");
  ASSERT_TRUE(gui.run(session, "open " + file_argument(file)).done());
  ASSERT_TRUE(gui.run(session, "select f0").done());
  EXPECT_EQ(drawn("001"), 1u) << "0 0 1";
}

TEST_F(InspectorPanel, an_edge_that_a_simplification_left_tells_its_rule) {
  ASSERT_TRUE(gui.run(session, "simplify faces=0 triangulate=on max_turn=20").done());
  ASSERT_TRUE(gui.run(session, "account").done());
  ASSERT_TRUE(gui.run(session, "select none").done());
  EXPECT_EQ(drawn("left by"), 0u);
  ASSERT_TRUE(gui.run(session, "account normal").done());
  EXPECT_EQ(drawn("left by"), 1u);
  EXPECT_EQ(drawn("turn too far"), 1u);
  ASSERT_TRUE(gui.run(session, "undo").done());
  ASSERT_TRUE(gui.run(session, "select e0").done());
  EXPECT_EQ(drawn("left by"), 0u);
}

// However many lines the numbers below it take, and however narrow the column is.
TEST_F(InspectorPanel, what_is_said_of_several_elements_stands_whole_below_the_name) {
  for (const char* const columns : {"columns right 292", "columns right 200"}) {
    ASSERT_TRUE(gui.run(session, columns).done());
    ASSERT_TRUE(gui.run(session, "select f0 f1").done());
    ASSERT_TRUE(gui.run(session, "language en").done());
    EXPECT_EQ(drawn("f1 One more element is selected. This one was selected last: it has the ring. area"), 1u)
        << columns;
    ASSERT_TRUE(gui.run(session, "language ja").done());
    const std::string letters(29, '?');
    EXPECT_EQ(drawn(("f1 ???1" + letters + "??" + "1").c_str()), 1u) << columns;
    EXPECT_EQ(DrawnText(gui).cut_in_height(), "") << columns;
    ASSERT_TRUE(gui.run(session, "language en").done());
    ASSERT_TRUE(gui.run(session, "select v0 v1 v2").done());
    EXPECT_EQ(drawn("v2 2 more elements are selected. This one was selected last: it has the ring. Welding joins the "
                    "others into it. position"),
              1u)
        << columns;
  }
}

// As commands name it, and behind it the number in the view.
TEST_F(InspectorPanel, a_halfedge_has_its_name_and_its_number_wherever_it_is_told) {
  const Mesh& mesh = session.mesh();
  const Halfedge h = mesh.halfedge(Face(0)), next = mesh.next(h);
  const auto told = [&](Halfedge each) { return name_of(mesh, each) + "(" + slot_name(each) + ")"; };
  ASSERT_TRUE(gui.run(session, "select " + slot_name(h)).done());
  frames(3);
  const std::string all =
      told(h) + "from" + slot_name(mesh.from(h)) + "to" + slot_name(mesh.to(h)) + "next" + told(next);
  EXPECT_EQ(drawn(all.c_str()), 1u) << all;
  ASSERT_TRUE(gui.run(session, "select " + slot_name(edge(h))).done());
  EXPECT_EQ(drawn((name_of(mesh, edge(h)) + "(" + slot_name(edge(h)) + ")").c_str()), 1u);
  EXPECT_EQ(drawn(told(twin(h)).c_str()), 1u) << "its halves";
}

TEST_F(InspectorPanel, what_to_point_at_is_what_the_tool_applies_to) {
  for (const auto& [line, text] : {std::pair("tool collapse", "Point at an edge."),
                                   {"tool poke", "Point at a face."},
                                   {"tool none", "Point at an edge."},
                                   {"mode vertex", "Point at a vertex."}}) {
    ASSERT_TRUE(gui.run(session, line).done());
    EXPECT_EQ(drawn(text), 1u) << line;
  }
}

}  // namespace
}  // namespace ryosen
