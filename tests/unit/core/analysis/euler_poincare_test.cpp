#include "core/analysis/euler_poincare.h"

#include <gtest/gtest.h>

#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

TEST(euler_poincare, of_closed_surfaces) {
  EXPECT_EQ(euler_poincare(make_mesh(cube())), (EulerPoincare{8, 12, 6, 0, 0, 1, 0}));
  EXPECT_EQ(euler_poincare(make_mesh(torus_grid(4, 5))), (EulerPoincare{20, 60, 40, 0, 0, 1, 1}));
}

TEST(euler_poincare, counts_boundaries_and_isolated_vertices) {
  EXPECT_EQ(euler_poincare(make_mesh(two_quads())), (EulerPoincare{6, 7, 2, 1, 0, 1, 0}));
  EXPECT_EQ(euler_poincare(make_mesh(two_quads(), 8)), (EulerPoincare{8, 7, 2, 3, 0, 3, 0}));
  EXPECT_EQ(euler_poincare(make_mesh({}, 0)), EulerPoincare());
}

TEST(euler_poincare, counts_every_copy_and_cut_edge) {
  EXPECT_EQ(euler_poincare(make_mesh(bow_tie())), (EulerPoincare{6, 6, 2, 2, 0, 2, 0}));
  EXPECT_EQ(euler_poincare(make_mesh(fin())), (EulerPoincare{9, 9, 3, 3, 0, 3, 0}));
  EXPECT_EQ(euler_poincare(make_mesh(two_tetrahedra_on_an_edge())), (EulerPoincare{8, 12, 8, 0, 0, 2, 0}));
}

TEST(euler_poincare, holds_for_what_cannot_be_oriented) {
  // Cut along its misoriented edges, the strip is one or more disks.
  const EulerPoincare e = euler_poincare(make_mesh(moebius_strip()));
  EXPECT_EQ(e.left(), e.right());
  EXPECT_EQ(e.genus, 0);
  EXPECT_EQ(e.boundaries, e.components);
}

}  // namespace
}  // namespace ryosen
