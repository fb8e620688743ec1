#include "app/ui/overlays.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

// What the ghost of a tool draws: lines by how they look, and points.
struct Drawn {
  std::size_t goes = 0, comes = 0, stays = 0, points = 0, ghosts = 0;
};

Drawn ghost_of(const std::string& tool) {
  auto document = Document::open(test::asset("torus.off"));
  EXPECT_TRUE(document);
  Session session(std::move(document).value());
  session.framing.frame_all();
  const auto picked = session.pointing.pick({478, 488}, PickMode::edge);
  const auto [a, b] = ends(session.mesh(), picked->element.edge());
  const glm::dvec3 middle = (session.mesh().position(a) + session.mesh().position(b)) / 2.0;
  session.selecting.tool = tool;
  session.pointing.point_at(project(session.view.camera, session.view.size, middle)->pixel);
  EXPECT_TRUE(session.selecting.hover() && session.selecting.hover()->preview.verdict.legal()) << tool;
  const Overlay overlay =
      hover_overlay(session.mesh(), session.view, session.selecting, session.gesturing, Theme::dark);
  Drawn drawn;
  const float thick = style(Role::legal, Theme::dark).width_px;
  for (const Line& line : overlay.lines) {
    EXPECT_EQ(line.hidden, 1) << "whole, not cut by the old surface";
    (line.style == LineStyle::dashed ? drawn.goes : line.width_px == thick ? drawn.comes : drawn.stays) += 1;
  }
  for (const GhostTriangle& triangle : overlay.ghosts) EXPECT_EQ(triangle.hidden, 1);
  drawn.points = overlay.points.size();
  drawn.ghosts = overlay.ghosts.size();
  return drawn;
}

// A side of two faces is drawn from both.
TEST(overlays, ghosts_tell_what_goes_what_comes_and_what_stays) {
  const Drawn split = ghost_of("split"), swap = ghost_of("swap"), collapse = ghost_of("collapse");
  EXPECT_EQ(split.goes, 1u);
  EXPECT_EQ(split.comes, 8u) << "two halves and two edges to the corners beside";
  EXPECT_EQ(split.stays, 4u);
  EXPECT_EQ(split.points, 1u) << "the new vertex";
  EXPECT_EQ(split.ghosts, 4u);

  EXPECT_EQ(swap.goes, 1u);
  EXPECT_EQ(swap.comes, 2u) << "one edge";
  EXPECT_EQ(swap.stays, 4u);
  EXPECT_EQ(swap.points, 0u);

  EXPECT_GE(collapse.goes, 3u) << "the edge and one of each triangle beside it";
  EXPECT_EQ(collapse.points, 2u) << "the vertex that goes, and where the other one comes to";
  EXPECT_GT(collapse.comes, 2u);
}

TEST(overlays, the_last_of_several_selected_has_a_ring_at_its_middle) {
  auto document = Document::open(test::asset("torus.off"));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  const auto rings = [&](const char* line) {
    EXPECT_TRUE(session.run(line).done());
    std::vector<glm::dvec3> places;
    for (const Point& point :
         selection_overlay(session.findings(), session.view, session.selecting, session.gesturing, Theme::dark).points)
      if (point.shape == PointShape::ring) places.push_back(point.at);
    return places;
  };
  EXPECT_TRUE(rings("select v3").empty());
  EXPECT_EQ(rings("select v3 v9 v5"), std::vector{session.mesh().position(Vertex(5))});
  const auto place = [&](std::uint32_t v) { return session.mesh().position(Vertex(v)); };
  const auto [a, b] = ends(session.mesh(), Edge(7));
  EXPECT_EQ(rings("select v3 e7"), std::vector{(place(a.index) + place(b.index)) / 2.0});
  EXPECT_EQ(rings("select v3 f1").size(), 1u);
  EXPECT_TRUE(rings("select f1").empty());
}

// Lines of a highlight would hide the vertices that one picks.
TEST(overlays, the_ends_of_highlighted_edges_are_dots_where_vertices_are_drawn) {
  Session session(Document::open(test::asset("moebius.off")).value());
  const HighlightRow& row = *std::find_if(highlight_table().begin(), highlight_table().end(),
                                          [](const HighlightRow& one) { return one.id == "boundary"; });
  std::size_t lines = 0, points = 0, plain = 0;
  for_each_mark(row, [&](Mark mark) {
    ViewSettings settings = session.view.settings;
    settings.dots = Dots::always;
    const Overlay overlay =
        highlight_overlay(session.findings(), session.gesturing.drawn_positions(), row, mark, 0, 100000, settings, 0);
    lines += overlay.lines.size();
    points += overlay.points.size();
    settings.dots = Dots::never;
    plain +=
        highlight_overlay(session.findings(), session.gesturing.drawn_positions(), row, mark, 0, 100000, settings, 0)
            .points.size();
  });
  EXPECT_GT(lines, 0u);
  EXPECT_EQ(points, lines) << "on loops as many";
  EXPECT_EQ(plain, 0u);
}

TEST(overlays, many_faces_that_a_gesture_turns_over_are_drawn_thin) {
  const auto turned_over = [](const char* segments) {
    Session session(std::make_unique<Document>());
    EXPECT_TRUE(session.run(std::string("sphere segments=") + segments).done());
    EXPECT_TRUE(session.run("select all").done());
    session.framing.frame_all();
    for (const char* const line : {"gesture scale x", "key -", "key 1"}) EXPECT_TRUE(session.run(line).done()) << line;
    const Overlay overlay =
        hover_overlay(session.mesh(), session.view, session.selecting, session.gesturing, Theme::dark);
    EXPECT_GT(session.gesturing.spoilt().size(), 0u);
    return std::pair(session.gesturing.spoilt().size(), overlay);
  };
  const auto [few, thick] = turned_over("8");
  const auto [many, thin] = turned_over("40");
  ASSERT_LT(few, 200u);
  ASSERT_GT(many, 200u);
  const float width = style(Role::refused, Theme::dark).width_px;
  for (const Line& line : thick.lines) EXPECT_EQ(line.width_px, width);
  ASSERT_FALSE(thin.lines.empty()) << "their number is told, and where they are";
  for (const Line& line : thin.lines) {
    EXPECT_LE(line.width_px, 1);
    EXPECT_EQ(line.hidden, 0) << "what is moved stays to be seen";
    EXPECT_EQ(line.style, LineStyle::solid);
  }
}

}  // namespace
}  // namespace ryosen
