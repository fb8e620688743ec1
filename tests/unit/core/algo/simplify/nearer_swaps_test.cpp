// What it takes to tell how far a simplified surface lies from what it was.
#include "ryosen/algo/simplify/nearer_swaps.h"

#include <gtest/gtest.h>

#include "tests/support/core/open_shapes.h"

namespace ryosen::test {
namespace {

// Triangles of the surface before whose distance is computed, for each of its own samples and for each middle of two
// spokes, on average.
double triangles_asked_on_average(std::uint32_t spokes) {
  const Mesh mesh = from_indexed(wavy_fan(spokes));
  const CollapseSurface surface(mesh, {});
  NearSamples samples(mesh, surface);
  Progress unheard;
  EXPECT_TRUE(samples.assign(std::vector<Vertex>(mesh.vertex_slots()), true, unheard));
  const TriangleTree input = tree_of_input(mesh, surface);
  std::size_t asked = 0, count = 0;
  for (std::uint32_t i = 0; i < mesh.face_slots() + mesh.vertex_slots(); ++i, ++count)
    asked += input.triangles_asked_for(samples.sample(i).place);
  for (std::uint32_t i = 0; i < spokes; ++i) {
    const auto spoke = [&](std::uint32_t k) { return surface.place(Vertex(1 + k % spokes)); };
    asked += input.triangles_asked_for((spoke(i) + spoke(i + 2)) / 2.0);
    asked += input.triangles_asked_for((spoke(i) + surface.place(Vertex(0))) / 2.0);
  }
  return static_cast<double>(asked) / static_cast<double>(count + 2 * spokes);
}

TEST(nearer_swaps, asks_few_triangles_about_a_vertex_of_many_faces) {
  const double of_few = triangles_asked_on_average(1000), of_many = triangles_asked_on_average(8000);
  EXPECT_LT(of_few, 12);
  EXPECT_LT(of_many, 12);
}

}  // namespace
}  // namespace ryosen::test
