// The distance of a place from the input, searched from any triangle, is that from the nearest of all.
#include "ryosen/algo/simplify/input_search.h"

#include <gtest/gtest.h>

#include <random>

#include "ryosen/algo/simplify/near_samples.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/delete.h"
#include "tests/support/core/open_shapes.h"
#include "tests/support/core/simplified.h"

namespace ryosen::test {
namespace {

double least_square(const Mesh& input, const ScaledPlaces& scale, const glm::dvec3& place) {
  double least = std::numeric_limits<double>::infinity();
  for (const Face f : live_faces(input)) {
    std::array<glm::dvec3, 3> corners{};
    const Primitive t = triangle_primitive(input, f);
    for (std::size_t i = 0; i < 3; ++i) corners[i] = scale.scaled(input.position(Vertex(t.vertices[i])));
    const double distance = nearest_on_triangle(corners, place).distance;
    least = std::min(least, distance * distance);
  }
  return least;
}

struct Asked {
  std::size_t places = 0, nearest = 0;
};
// Places about random points of a mesh, up to so far away, each from a random triangle within twice the distance.
Asked ask(const Mesh& input, double away, std::uint32_t seed) {
  const ScaledPlaces scale(input.positions());
  const InputSearch search(input, scale);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  Asked asked;
  for (int i = 0; i < 300; ++i) {
    const Face start(random() % input.face_slots());
    if (!input.is_alive(start)) continue;
    const Halfedge h = input.halfedge(start);
    const glm::dvec3 place =
        scale.scaled(input.position(input.from(h))) + away * glm::dvec3(unit(random), unit(random), unit(random));
    const double is = search.nearest(place, h).square, least = least_square(input, scale, place);
    EXPECT_GE(is, least * (1 - 1e-9));
    ++asked.places;
    asked.nearest += is <= least * (1 + 1e-9) + 1e-24;
    EXPECT_LE(search.nearest(place, h, 4 * least).square, 4 * least + 1e-24);
  }
  return asked;
}

TEST(input_search, finds_the_nearest_triangle_of_round_shapes) {
  for (const char* const shape : {"sphere", "torus", "cylinder", "cone", "grid"})
    for (const double away : {0.01, 0.1, 0.5}) {
      const Asked asked = ask(triangulated(shape), away, 11);
      EXPECT_EQ(asked.nearest, asked.places) << shape << " " << away;
    }
}

TEST(input_search, comes_around_hubs) {
  for (const std::uint32_t spokes : {20u, 300u, 1000u}) {
    const Asked asked = ask(from_indexed(wavy_fan(spokes)), 0.3, spokes);
    EXPECT_EQ(asked.nearest, asked.places) << spokes;
  }
}

TEST(input_search, gives_the_way_from_the_input) {
  const Mesh mesh = triangulated("sphere");
  const ScaledPlaces scale(mesh.positions());
  const InputSearch search(mesh, scale);
  for (const Vertex v : live_vertices(mesh)) {
    const glm::dvec3 at = scale.scaled(mesh.position(v)), place = 1.25 * at;
    const InputSearch::Near near = search.nearest(place, *outgoing(mesh, v).begin());
    EXPECT_EQ(near.way, place - at);
    EXPECT_EQ(near.square, glm::dot(near.way, near.way));
  }
}

// A hole is gone around, and beside it nothing is found where there is nothing.
TEST(input_search, ends_at_boundaries) {
  Mesh mesh = triangulated("grid");
  Edit edit(mesh, nullptr);
  Delete{*live_faces(mesh).begin()}.apply(edit);
  edit.commit();
  const Asked asked = ask(mesh, 0.2, 5);
  EXPECT_EQ(asked.nearest, asked.places);
  const ScaledPlaces scale(mesh.positions());
  for (const Edge e : live_edges(mesh))
    for (const Halfedge h : {halfedge(e), twin(halfedge(e))})
      if (mesh.is_outside(h)) {
        EXPECT_FALSE(InputSearch(mesh, scale).nearest({0, 0, 0}, h).square < 1e300);
      }
}

}  // namespace
}  // namespace ryosen::test
