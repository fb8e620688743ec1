// Texture and colours stay at their places while remeshing moves the points.
#include <gtest/gtest.h>

#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/valued_sheet.h"

namespace ryosen::test {
namespace {

TEST(RemeshValues, are_those_of_the_places_that_points_come_to) {
  constexpr double across = 100 * 1e-15;  // of rounding, where values lie beyond the seam
  for (const char* const words : {"length=0.08", "length=0.03", "length=0.08 adaptive=on", "length=0.11 rounds=1"})
    for (const double seam : {no_seam, 0.5})
      for (const glm::dmat3& turn : {glm::dmat3(1), some_turn()}) {
        Mesh mesh = valued_sheet(20, seam, turn);
        Journal journal;
        ASSERT_GT(run_algorithm(mesh, journal, std::string("remesh ") + words).changed, 0u);
        EXPECT_LT(worst_value(mesh, seam, turn), across) << words << ", seam " << seam;
      }
}

}  // namespace
}  // namespace ryosen::test
