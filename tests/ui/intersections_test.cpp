// Self-intersections in the window: searched for on request, drawn, listed, and gone with the next edit.
#include <gtest/gtest.h>

#include "app/editor/session/session.h"
#include "app/ui/headless.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

using test::DrawnText;

// Two triangles through each other, and one apart.
std::unique_ptr<Document> crossing() {
  MeshFile file;
  file.mesh.positions = {{-1, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 1, -1}, {0, 1, 1},
                         {0, -1, 0}, {3, 0, 0}, {4, 0, 0}, {3, 1, 0}};
  file.mesh.corners = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  file.mesh.face_offsets = {0, 3, 6, 9};
  return std::make_unique<Document>(std::move(file));
}

std::uint32_t found(Session& session) { return session.findings().highlights().count(ProblemKind::self_intersection); }

TEST(intersections, are_searched_for_on_request_and_selected_as_all_problems_are) {
  Session session(crossing());
  EXPECT_EQ(found(session), 0u);
  EXPECT_FALSE(session.findings().has_searched(ProblemKind::self_intersection));
  const Outcome outcome = session.run("self_intersections");
  EXPECT_EQ(outcome.sentence.en.substr(0, 20), "2 faces meet others ");
  EXPECT_NE(outcome.sentence.en.find("one pair"), std::string::npos) << outcome.sentence.en;
  EXPECT_EQ(found(session), 2u);
  ASSERT_TRUE(session.run("select self_intersection").done());
  EXPECT_EQ(session.selecting.selection, (std::vector<Element>{Face(0), Face(1)}));
  for (const char* face : {"f0", "f1"}) {
    ASSERT_TRUE(session.run(std::string("select self_intersection ") + face).done());
    EXPECT_EQ(session.selecting.selection.size(), 2u) << face << " with what it meets";
  }
  ASSERT_TRUE(session.run("self_intersections off").done());
  EXPECT_EQ(found(session), 0u);
  EXPECT_EQ(session.run("self_intersections on").exit_code, ExitCode::usage);
}

TEST(intersections, are_forgotten_by_the_next_edit_and_by_undo) {
  Session session(crossing());
  for (const char* edit : {"poke f2", "undo"}) {
    ASSERT_TRUE(session.run("self_intersections").done());
    EXPECT_EQ(found(session), 2u);
    ASSERT_TRUE(session.run(edit).done());
    EXPECT_EQ(found(session), 0u) << edit;
    EXPECT_FALSE(session.findings().has_searched(ProblemKind::self_intersection));
  }
}

TEST(intersections, can_be_cancelled_and_then_say_nothing) {
  Session session(crossing());
  session.frontend.on_progress = [](double) { return false; };
  EXPECT_EQ(session.run("self_intersections").exit_code, ExitCode::cancelled);
  EXPECT_FALSE(session.findings().has_searched(ProblemKind::self_intersection));
}

TEST(intersections, are_drawn_as_in_a_picture_made_anew) {
  auto made = Headless::make({.backend = Backend::osmesa, .size = {300, 200}});
  ASSERT_TRUE(made);
  Headless& headless = *made.value();
  Session session(crossing());
  headless.place_view(session);
  const Image before = headless.picture(session);
  ASSERT_TRUE(session.run("self_intersections").done());
  const Image with = headless.picture(session);
  EXPECT_NE(with.pixels, before.pixels);
  EXPECT_EQ(with.pixels, headless.view_drawn_again().pixels);
  ASSERT_TRUE(session.run("show intersecting off").done());
  EXPECT_EQ(headless.picture(session).pixels, before.pixels);
  ASSERT_TRUE(session.run("show intersecting on").done());
  EXPECT_EQ(headless.picture(session).pixels, with.pixels);
  ASSERT_TRUE(session.run("self_intersections off").done());
  EXPECT_EQ(headless.picture(session).pixels, before.pixels);
}

TEST(intersections, are_asked_for_and_listed_in_the_problems_panel) {
  test::Laid laid("cube.obj", test::tall_window);
  laid.session.set_document(crossing());
  laid.frames(4);
  EXPECT_EQ(DrawnText(laid.gui).count("Intersecting"), 0u) << "no row for what nobody asked for";
  laid.click(DrawnText(laid.gui).place("Search for self-intersections"));
  laid.frames(4);
  EXPECT_EQ(found(laid.session), 2u);
  EXPECT_EQ(DrawnText(laid.gui).count("2  faces that meet others"), 1u);
  EXPECT_EQ(DrawnText(laid.gui).count("Search for self-intersections"), 0u);
  EXPECT_EQ(DrawnText(laid.gui).count("Intersecting"), 1u);
}

}  // namespace
}  // namespace ryosen
