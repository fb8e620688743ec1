#include "ryosen/geometry/predicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ryosen {
namespace {

TEST(around_edge, orders_half_planes_by_their_angles_from_the_first) {
  const AroundEdge order({0, 0, -1}, {0, 0, 3}, {2, 0, 7});
  const std::vector<glm::dvec3> ascending{{1, 0, 0},   {3, 1, 0},  {0, 1, 5},  {-1, 3, 0}, {-1, 0, 2},
                                          {-3, -1, 0}, {0, -2, 0}, {1, -1, 0}, {9, -1, -4}};
  for (std::size_t i = 0; i < ascending.size(); ++i)
    for (std::size_t k = 0; k < ascending.size(); ++k)
      EXPECT_EQ(order.compare(ascending[i], ascending[k]), i < k ? -1 : i > k ? 1 : 0) << i << " " << k;
}

TEST(around_edge, seen_from_the_other_end_the_order_is_the_opposite) {
  const glm::dvec3 a{0.1, 0.2, 0.3}, b{1.7, -0.4, 0.9};
  const std::vector<glm::dvec3> places{{1, 0, 0}, {0, 1, 0.5}, {-3, 0.2, 1}, {0.3, -2, 4}, {5, 5, -6}};
  const AroundEdge there(a, b, places[0]), back(b, a, places[0]);
  for (std::size_t i = 1; i < places.size(); ++i)
    for (std::size_t k = 1; k < places.size(); ++k)
      EXPECT_EQ(there.compare(places[i], places[k]), back.compare(places[k], places[i])) << i << " " << k;
}

TEST(around_edge, tells_half_planes_apart_that_rounding_does_not) {
  const glm::dvec3 a{0, 0, 0}, b{1, 1, 1}, first{1, 2, 3};
  const double above = std::nextafter(2.0, 3.0);
  const AroundEdge order(a, b, first);
  EXPECT_EQ(order.compare({4, 7, 10}, first), 0) << "1 + 3 (1 2 3)";
  EXPECT_EQ(order.compare({1, above, 3}, first), 1);
  EXPECT_EQ(order.compare({1, above, 3}, {-1, -2, -3}), 1) << "just below a whole turn";
  const AroundEdge from_above(a, b, {1, above, 3});
  EXPECT_EQ(from_above.compare({1, above, 3}, first), -1);
  EXPECT_EQ(from_above.compare({-1, -above, -3}, first), 1) << "half a turn, and just above none";
  const AroundEdge tiny(a * 1e-300, b * 1e-300, first * 1e-300), huge(a * 1e300, b * 1e300, first * 1e300);
  EXPECT_EQ(tiny.compare(glm::dvec3(4, 7, 10) * 1e-300, first * 1e-300),
            tiny.compare(first * 1e-300, glm::dvec3(4, 7, 10) * 1e-300) * -1);
  EXPECT_EQ(huge.compare(glm::dvec3(-1, 0, 0) * 1e300, first * 1e300), 1);
}

}  // namespace
}  // namespace ryosen
