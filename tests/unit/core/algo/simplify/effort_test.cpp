// More effort never leaves the result farther from the surface than less effort does.
#include <gtest/gtest.h>

#include "ryosen/analysis/measure/distance.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/simplified.h"

namespace ryosen::test {
namespace {

double rms_after(const Mesh& mesh, const std::string& words) {
  Mesh made = mesh;
  simplified(made, words);
  Progress unheard;
  return surface_distance(mesh, made, {.gap = 1, .samples = 50000}, unheard)->rms;
}

TEST(SimplifyEffort, two_is_never_farther_than_one) {
  std::size_t nearer = 0;
  for (const char* const shape : {"sphere", "torus", "icosahedron"})
    for (const char* const goal : {"ratio=0.5", "ratio=0.2", "ratio=0.05", "ratio=0.02"}) {
      const std::string words = std::string("triangulate=on ") + goal;
      const Mesh mesh = made_by(shape);
      const double one = rms_after(mesh, words + " effort=1"), two = rms_after(mesh, words + " effort=2");
      EXPECT_LE(two, one) << shape << " " << goal;
      nearer += two < one;
    }
  EXPECT_GE(nearer, 4u);
}

// Effort 2 alone comes out a tenth farther here.
TEST(SimplifyEffort, one_takes_the_place_of_two_where_it_lies_nearer) {
  const Mesh sphere = made_by("sphere");
  Mesh one = sphere, two = sphere;
  simplified(one, "ratio=0.02 triangulate=on");
  simplified(two, "ratio=0.02 triangulate=on effort=2");
  EXPECT_EQ(one.columns(), two.columns());
}

}  // namespace
}  // namespace ryosen::test
