#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/scene/pick/picker.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

constexpr Size view{640, 480};

bool is_inside(const std::vector<glm::dvec2>& polygon, glm::dvec2 pixel) {
  int crossings = 0;  // to the right
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i] - pixel, b = polygon[(i + 1) % polygon.size()] - pixel;
    if ((a.y > 0) != (b.y > 0) && a.x - a.y * (b.x - a.x) / (b.y - a.y) > 0) ++crossings;
  }
  return crossings % 2 == 1;
}

TEST(screen_region, holds_what_an_odd_number_of_sides_surrounds) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Dice dice(seed);
    std::vector<glm::dvec2> polygon;
    for (int i = 0; i < 3 + dice.below(9); ++i) polygon.push_back({100 * dice.unit(), 100 * dice.unit()});
    const ScreenRegion region(polygon);
    for (int i = 0; i < 50; ++i) {
      const glm::dvec2 pixel(120 * dice.unit() - 10, 120 * dice.unit() - 10);
      ASSERT_EQ(region.holds(pixel), is_inside(polygon, pixel)) << seed;
    }
  }
  EXPECT_FALSE(ScreenRegion({}).holds({0, 0}));
  EXPECT_TRUE(ScreenRegion::box({10, 20}, {5, 3}).holds({7, 10}));
}

Mesh torus(std::uint32_t rows, std::uint32_t columns) {
  IndexedMesh list;
  for (std::uint32_t i = 0; i < rows; ++i)
    for (std::uint32_t j = 0; j < columns; ++j) {
      const double a = 2 * std::numbers::pi * i / rows, b = 2 * std::numbers::pi * j / columns;
      list.positions.push_back({(2 + std::cos(a)) * std::cos(b), (2 + std::cos(a)) * std::sin(b), std::sin(a)});
    }
  list.face_offsets = {0};
  for (const auto& face : torus_grid(rows, columns)) {
    list.corners.insert(list.corners.end(), face.begin(), face.end());
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  return from_indexed(std::move(list));
}

class PickRegionTest : public ::testing::Test {
 protected:
  PickRegionTest() {
    camera_.eye = {0.4, 0.3, 3};
    camera_ = fitted(camera_, mesh_.positions(), 4.0 / 3);
  }
  std::set<Element> pick(const ScreenRegion& region, PickMode mode, Picker::Depth depth) {
    const std::vector<Element> found = picker_.pick_region(mesh_, camera_, view, region, mode, depth);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    return {found.begin(), found.end()};
  }

  const ScreenRegion all_ = ScreenRegion::box({0, 0}, {640, 480});
  Mesh mesh_ = torus(12, 18);
  Picker picker_{mesh_};
  Camera camera_;
};

TEST_F(PickRegionTest, through_the_surface_it_takes_everything_in_the_region) {
  EXPECT_EQ(pick(all_, PickMode::vertex, Picker::Depth::through).size(), mesh_.live().vertices);
  EXPECT_EQ(pick(all_, PickMode::edge, Picker::Depth::through).size(), mesh_.live().edges);
  EXPECT_EQ(pick(all_, PickMode::face, Picker::Depth::through).size(), mesh_.live().faces);
  EXPECT_EQ(pick(all_, PickMode::halfedge, Picker::Depth::through).size(), 2 * mesh_.live().edges);
  const ScreenRegion left = ScreenRegion::box({0, 0}, {320, 480});
  const auto faces = pick(left, PickMode::face, Picker::Depth::through);
  for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
    bool is_left = true;
    for (const Vertex v : vertices_around(mesh_, Face(i)))
      is_left = is_left && project(camera_, view, mesh_.position(v))->pixel.x < 320;
    EXPECT_EQ(faces.contains(Face(i)), is_left) << i;
  }
}

// What a click picks at a vertex or the middle of an edge or triangle is seen there.
TEST_F(PickRegionTest, seen_is_what_a_click_there_picks) {
  const auto vertices = pick(all_, PickMode::vertex, Picker::Depth::seen);
  EXPECT_GT(vertices.size(), mesh_.live().vertices / 3);
  EXPECT_LT(vertices.size(), mesh_.live().vertices);
  const auto clicked = [&](const glm::dvec3& place, PickMode mode, Element e) {
    const auto picked = picker_.pick(mesh_, camera_, view, project(camera_, view, place)->pixel, mode);
    return picked && picked->element == e;
  };
  for (std::uint32_t i = 0; i < mesh_.vertex_slots(); ++i)
    EXPECT_EQ(vertices.contains(Vertex(i)), clicked(mesh_.position(Vertex(i)), PickMode::vertex, Vertex(i))) << i;
  const auto edges = pick(all_, PickMode::edge, Picker::Depth::seen);
  for (std::uint32_t i = 0; i < mesh_.edge_slots(); ++i) {
    const auto [a, b] = ends(mesh_, Edge(i));
    const glm::dvec3 middle = 0.5 * mesh_.position(a) + 0.5 * mesh_.position(b);
    EXPECT_EQ(edges.contains(Edge(i)), clicked(middle, PickMode::edge, Edge(i))) << i;
  }
  const auto faces = pick(all_, PickMode::face, Picker::Depth::seen);
  for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
    glm::dvec3 middle(0);
    for (const Vertex v : vertices_around(mesh_, Face(i))) middle += mesh_.position(v) / 3.0;
    EXPECT_EQ(faces.contains(Face(i)), clicked(middle, PickMode::face, Face(i))) << i;
  }
}

}  // namespace
}  // namespace ryosen
