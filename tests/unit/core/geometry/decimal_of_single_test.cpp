#include "ryosen/geometry/single_precision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ryosen::test {
namespace {

TEST(decimal_of_single, is_what_a_float_is_printed_to) {
  for (const double value : {0.0, 1.0, -0.5, 0.1, -0.1, 0.70710677, -0.70710677, 0.707106769, 1e-40, 3.4e38, 123456.0})
    EXPECT_TRUE(is_decimal_of_single(value)) << value;
  for (const double value : {0.70710678118654757, -0.309016994, 1.000000001, 1e39, -1e300, 1e-60})
    EXPECT_FALSE(is_decimal_of_single(value)) << value;
  EXPECT_TRUE(is_decimal_of_single(std::numeric_limits<double>::infinity()));
  EXPECT_TRUE(is_decimal_of_single(std::nan("")));
}

}  // namespace
}  // namespace ryosen::test
