// Samples of a surface find the faces that they are nearest to when edges have collapsed.
#include "ryosen/algo/simplify/near_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/delete.h"
#include "tests/support/core/open_shapes.h"
#include "tests/support/core/simplified.h"

namespace ryosen::test {
namespace {

struct Collapsed {
  Mesh input, mesh;
  std::vector<Vertex> merged;  // by vertex, the one that it has become, or none

  // Collapses edges by chance until so many faces are left.
  Collapsed(Mesh before, std::size_t faces, std::uint32_t seed)
      : input(before), mesh(std::move(before)), merged(mesh.vertex_slots()) {
    std::mt19937 random(seed);
    Edit edit(mesh, nullptr);
    for (int tries = 0; mesh.live().faces > faces && tries < 100000; ++tries) {
      const Edge e(random() % mesh.edge_slots());
      if (!mesh.is_alive(e) || !CollapseEdge{halfedge(e)}.is_legal(mesh)) continue;
      const Vertex gone = mesh.from(halfedge(e)), kept = mesh.to(halfedge(e));
      CollapseEdge{halfedge(e)}.apply(edit);
      for (Vertex& v : merged)
        if (v == gone) v = kept;
      merged[gone.index] = kept;
    }
    edit.commit();
    EXPECT_LE(mesh.live().faces, faces);
  }
};

double distance_to(const CollapseSurface& surface, Face f, const glm::dvec3& place) {
  const auto& [a, b, c] = triangle_primitive(surface.mesh(), f).vertices;
  return nearest_on_triangle({surface.place(Vertex(a)), surface.place(Vertex(b)), surface.place(Vertex(c))}, place)
      .distance;
}

struct Compared {
  std::size_t samples = 0, at_nearest = 0;
  double area = 0;
};
// With the nearest of all faces.
Compared compare(const Collapsed& shape, bool is_exact) {
  const CollapseSurface surface(shape.mesh, {});
  NearSamples samples(shape.input, surface);
  Progress unheard;
  EXPECT_TRUE(samples.assign(shape.merged, is_exact, unheard));
  Compared compared;
  for (const Face f : live_faces(shape.mesh))
    samples.for_each(f, [&](std::uint32_t i) {
      const auto [place, area] = samples.sample(i);
      double least = std::numeric_limits<double>::infinity();
      for (const Face g : live_faces(shape.mesh)) least = std::min(least, distance_to(surface, g, place));
      ++compared.samples;
      compared.at_nearest += distance_to(surface, f, place) <= least + 1e-9;
      compared.area += area;
    });
  return compared;
}

double scaled_area(const Mesh& mesh) {
  const CollapseSurface surface(mesh, {});
  double sum = 0;
  for (const Face f : live_faces(mesh)) {
    const auto& [a, b, c] = triangle_primitive(mesh, f).vertices;
    const glm::dvec3& p = surface.place(Vertex(a));
    sum += glm::length(glm::cross(surface.place(Vertex(b)) - p, surface.place(Vertex(c)) - p)) / 2;
  }
  return sum;
}

TEST(near_samples, stand_for_the_area_and_are_at_the_nearest_face) {
  for (const char* const shape : {"sphere", "torus", "cylinder", "grid"})
    for (const std::uint32_t divisor : {1u, 4u}) {
      const Mesh mesh = triangulated(shape);
      const Collapsed collapsed(mesh, mesh.live().faces / divisor, 7 + divisor);
      const Compared exact = compare(collapsed, true), near = compare(collapsed, false);
      EXPECT_EQ(exact.at_nearest, exact.samples) << shape << divisor;
      EXPECT_EQ(exact.samples, mesh.live().faces + mesh.live().vertices) << shape << divisor;
      EXPECT_EQ(near.samples, exact.samples) << shape << divisor;
      EXPECT_GE(20 * near.at_nearest, 17 * near.samples) << shape << divisor;  // collapses by chance make needles
      EXPECT_NEAR(exact.area, scaled_area(mesh), 1e-5) << shape << divisor;
    }
}

TEST(near_samples, of_a_hub_are_at_the_nearest_face) {
  for (const std::uint32_t spokes : {20u, 40u, 300u}) {
    const Mesh fan = from_indexed(wavy_fan(spokes));
    const Collapsed collapsed(fan, spokes * 4 / 5, spokes);
    const Compared near = compare(collapsed, false);
    EXPECT_EQ(near.samples, fan.live().faces + fan.live().vertices) << spokes;
    EXPECT_GE(10 * near.at_nearest, 9 * near.samples) << spokes;
  }
}

// A part that is gone has no samples, and what is left has its own.
TEST(near_samples, of_what_is_gone_have_no_face) {
  Collapsed two(triangulated("sphere"), 100, 3);
  const std::size_t faces = two.mesh.live().faces;
  Edit edit(two.mesh, nullptr);
  const Vertex gone = *live_vertices(two.mesh).begin();
  Delete{gone}.apply(edit);
  edit.commit();
  ASSERT_LT(two.mesh.live().faces, faces);
  std::size_t left = 0;
  for (const Vertex v : live_vertices(two.input)) left += (two.merged[v.index] ? two.merged[v.index] : v) != gone;
  for (const Face f : live_faces(two.input)) {
    const Vertex v = two.input.from(two.input.halfedge(f));
    left += (two.merged[v.index] ? two.merged[v.index] : v) != gone;
  }
  EXPECT_EQ(compare(two, false).samples, left);
  EXPECT_EQ(compare(two, true).samples, left);
}

}  // namespace
}  // namespace ryosen::test
