#include "app/ui/overlays.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/circulate.h"
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
  session.frame_all();
  const auto picked = session.pick({478, 488}, PickMode::edge);
  const auto [a, b] = ends(session.mesh(), picked->element.edge());
  const glm::dvec3 middle = (session.mesh().position(a) + session.mesh().position(b)) / 2.0;
  session.tool = tool;
  session.point_at(project(session.camera, session.view, middle)->pixel);
  EXPECT_TRUE(session.hover() && session.hover()->preview.verdict.legal()) << tool;
  const Overlay overlay = hover_overlay(session, Theme::dark);
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
    for (const Point& point : selection_overlay(session, Theme::dark).points)
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

}  // namespace
}  // namespace ryosen
