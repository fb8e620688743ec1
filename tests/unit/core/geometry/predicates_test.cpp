#include "ryosen/geometry/predicates.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "ryosen/geometry/exact_sum.h"
#include "tests/support/core/long_run.h"
#include "tests/unit/core/geometry/big_integer.h"

namespace ryosen {
namespace {

using glm::dvec2;
using glm::dvec3;
using test_shapes::BigInteger;

int runs(int in_short) { return test::is_long_run() ? 35 * in_short : in_short; }

int oracle(const dvec2& a, const dvec2& b, const dvec2& c) {
  const BigInteger cx = BigInteger::scaled(c.x);
  const BigInteger cy = BigInteger::scaled(c.y);
  return ((BigInteger::scaled(a.x) - cx) * (BigInteger::scaled(b.y) - cy) -
          (BigInteger::scaled(a.y) - cy) * (BigInteger::scaled(b.x) - cx))
      .sign();
}

bool oracle_collinear(const dvec3& a, const dvec3& b, const dvec3& c) {
  return oracle({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == 0 && oracle({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) == 0 &&
         oracle({a.x, a.z}, {b.x, b.z}, {c.x, c.z}) == 0;
}

// Any finite double, all exponents alike.
double any_double(std::mt19937_64& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) return value;
  }
}

void expect_all_orders(const dvec2& a, const dvec2& b, const dvec2& c) {
  const int expected = oracle(a, b, c);
  EXPECT_EQ(orient2d(a, b, c), expected) << a.x << ' ' << a.y << ' ' << b.x << ' ' << b.y << ' ' << c.x << ' ' << c.y;
  EXPECT_EQ(orient2d(b, c, a), expected);
  EXPECT_EQ(orient2d(c, a, b), expected);
  EXPECT_EQ(orient2d(b, a, c), -expected);
}

TEST(predicates, orientation_of_plain_triangles) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {2, 2}), 0);
  EXPECT_EQ(orient2d({1, 1}, {1, 1}, {5, 3}), 0);
}

TEST(predicates, points_one_rounding_step_off_a_line) {
  const double step = std::numeric_limits<double>::epsilon();
  const int apart = test::is_long_run() ? 1 : 3;
  for (int i = 0; i < 64; i += apart) {
    for (int j = 0; j < 64; j += apart) {
      expect_all_orders({0.5 + i * step, 0.5 + j * step}, {12, 12}, {24, 24});
    }
  }
}

TEST(predicates, any_finite_doubles_agree_with_integers) {
  std::mt19937_64 random(1);
  for (int i = 0; i < runs(800); ++i) {
    const auto value = [&] { return any_double(random); };
    expect_all_orders({value(), value()}, {value(), value()}, {value(), value()});
  }
}

TEST(predicates, nearly_collinear_points_of_every_magnitude) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int zeros = 0;
  const int tried = test::is_long_run() ? 20 : 6;
  for (int exponent = -1090; exponent <= 1000; exponent += 11) {
    for (int i = 0; i < tried; ++i) {
      const dvec2 a(unit(random), unit(random));
      const dvec2 d(std::round(unit(random) * 8), std::round(unit(random) * 8));
      const auto place = [&](const dvec2& p) { return dvec2(std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)); };
      const dvec2 p = place(a);
      const dvec2 q = place(a + d);
      const dvec2 r = place(a + d * 3.0);
      expect_all_orders(p, q, r);
      zeros += orient2d(p, q, r) == 0;
    }
  }
  EXPECT_GT(zeros, 5 * tried);
}

TEST(predicates, extremes_of_the_double_range) {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  constexpr double huge = std::numeric_limits<double>::max();
  const std::array<double, 15> values = {0.0,  -0.0,  tiny,  -tiny,  3 * tiny, 1e-310, 1e-160,  1.0,
                                         -1.0, 1e160, 1e300, -1e300, huge,     -huge,  huge / 2};
  std::mt19937_64 random(3);
  std::uniform_int_distribution<std::size_t> pick(0, values.size() - 1);
  for (int i = 0; i < runs(600); ++i) {
    const auto value = [&] { return values[pick(random)]; };
    expect_all_orders({value(), value()}, {value(), value()}, {value(), value()});
  }
  EXPECT_EQ(orient2d({0, 0}, {tiny, 0}, {0, tiny}), 1);
  EXPECT_EQ(orient2d({-huge, -huge}, {huge, -huge}, {huge, huge}), 1);
  EXPECT_EQ(orient2d({-huge, -huge}, {0, 0}, {huge, huge}), 0);
}

TEST(predicates, expansions_and_accumulator_give_the_same_signs) {
  std::mt19937_64 random(4);
  std::uniform_int_distribution<int> small(-3, 3);
  std::uniform_int_distribution<int> exponent(-60, 60);
  const auto value = [&] { return std::ldexp(small(random), exponent(random)); };
  for (int i = 0; i < runs(600); ++i) {
    exact::Expansion<16> expansion;
    exact::ProductAccumulator accumulator;
    BigInteger sum;
    for (int term = 0; term < 6; ++term) {
      const double a = value() + small(random);
      const double b = value() + small(random);
      expansion.add_product(a, b);
      accumulator.add_product(-a, b, true);
      sum = sum + BigInteger::scaled(a) * BigInteger::scaled(b);
    }
    EXPECT_EQ(expansion.sign(), sum.sign());
    EXPECT_EQ(accumulator.sign(), sum.sign());
  }
}

TEST(predicates, cross_component_follows_the_axis) {
  const dvec3 o(0.0);
  EXPECT_EQ(cross_component_sign(o, {0, 1, 0}, {0, 0, 1}, 0), 1);
  EXPECT_EQ(cross_component_sign(o, {0, 0, 1}, {1, 0, 0}, 1), 1);
  EXPECT_EQ(cross_component_sign(o, {1, 0, 0}, {0, 1, 0}, 2), 1);
  EXPECT_EQ(cross_component_sign(o, {1, 0, 0}, {0, 1, 0}, 0), 0);
}

TEST(predicates, collinear_points_in_space_agree_with_integers) {
  std::mt19937_64 random(5);
  std::uniform_int_distribution<int> grid(-2, 2);
  int flat = 0;
  for (int i = 0; i < runs(1200); ++i) {
    const double scale = i % 3 == 0 ? 1e300 : i % 3 == 1 ? std::numeric_limits<double>::denorm_min() : 0.1;
    const auto point = [&] { return dvec3(grid(random), grid(random), grid(random)) * scale; };
    const dvec3 a = point(), b = point(), c = point();
    EXPECT_EQ(are_collinear(a, b, c), oracle_collinear(a, b, c));
    flat += are_collinear(a, b, c);
  }
  EXPECT_GT(flat, runs(1200) / 40);
  EXPECT_LT(flat, runs(1200) * 3 / 4);
}

// The determinant of the rows b - a, c - a, d - a in integers.
int oracle_side(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
  const auto difference = [&](const dvec3& p, int axis) {
    return BigInteger::scaled(p[axis]) - BigInteger::scaled(a[axis]);
  };
  BigInteger sum;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const BigInteger minor = difference(c, j) * difference(d, k) - difference(c, k) * difference(d, j);
    sum = sum + difference(b, i) * minor;
  }
  return sum.sign();
}

void expect_sides(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
  const int side = oracle_side(a, b, c, d);
  ASSERT_EQ(orient3d(a, b, c, d), side);
  ASSERT_EQ(orient3d(b, c, a, d), side);
  ASSERT_EQ(orient3d(b, a, c, d), -side);
  ASSERT_EQ(orient3d(d, b, c, a), -side);
  ASSERT_EQ(orient3d(c, d, a, b), side);
}

TEST(predicates, the_side_of_a_plane_agrees_with_integers) {
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  std::mt19937_64 random(6);
  for (int i = 0; i < runs(100); ++i) {
    const auto point = [&] { return dvec3(any_double(random), any_double(random), any_double(random)); };
    expect_sides(point(), point(), point(), point());
  }
}

TEST(predicates, nearly_coplanar_points_of_every_magnitude) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int zeros = 0;
  const int tried = test::is_long_run() ? 20 : 6;
  for (int exponent = -1080; exponent <= 1000; exponent += 40) {
    for (int i = 0; i < tried; ++i) {
      const auto vector = [&](double grid) {
        return dvec3(std::round(unit(random) * grid), std::round(unit(random) * grid), std::round(unit(random) * grid));
      };
      const dvec3 o = i % 2 == 0 ? vector(50) : vector(1e15) * 1e-15, u = vector(8), v = vector(8);
      const auto place = [&](const dvec3& p) {
        return dvec3(std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent));
      };
      const dvec3 a = place(o), b = place(o + u), c = place(o + v), d = place(o + u * 2.0 - v);
      expect_sides(a, b, c, d);
      zeros += orient3d(a, b, c, d) == 0;
    }
  }
  EXPECT_GT(zeros, 15 * tried);
}

TEST(predicates, sides_of_planes_at_the_extremes_of_the_double_range) {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  constexpr double huge = std::numeric_limits<double>::max();
  const std::array<double, 14> values = {0.0, -0.0, tiny,  -3 * tiny, 1e-310, 1e-160, 1.0,
                                         2.0, -1.0, 1e100, 1e160,     1e300,  huge,   -huge};
  std::mt19937_64 random(8);
  std::uniform_int_distribution<std::size_t> pick(0, values.size() - 1);
  for (int i = 0; i < runs(160); ++i) {
    const auto point = [&] { return dvec3(values[pick(random)], values[pick(random)], values[pick(random)]); };
    expect_sides(point(), point(), point(), point());
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(orient3d({nan, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 0);
}

TEST(predicates, a_tenth_three_tenths_is_not_on_the_diagonal_of_its_steps) {
  // 0.1 + 0.2 differs from 0.3 in the last bit, which the exact test must see.
  EXPECT_TRUE(are_collinear({0, 0, 0}, {0.1, 0.1, 0}, {0.3, 0.3, 0}));
  EXPECT_FALSE(are_collinear({0, 0, 0}, {0.1, 0.1, 0}, {0.3, 0.1 + 0.2, 0}));
}

TEST(predicates, collinear_lists) {
  const std::vector<dvec3> line = {{0, 0, 0}, {0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {-1, -2, -3}};
  EXPECT_TRUE(are_collinear(line));
  EXPECT_TRUE(are_collinear(std::span(line).first(2)));
  EXPECT_TRUE(are_collinear(std::span(line).first(0)));
  std::vector<dvec3> bent = line;
  bent.push_back({2, 4, std::nextafter(6.0, 7.0)});
  EXPECT_FALSE(are_collinear(bent));
  const std::vector<std::uint32_t> corners = {0, 2, 3, 4};
  EXPECT_TRUE(are_collinear(bent, corners));
  const std::vector<std::uint32_t> other = {0, 1, 2, 5};
  EXPECT_FALSE(are_collinear(bent, other));
}

TEST(predicates, numbers_that_are_not_finite_do_no_harm) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(orient2d({nan, 0}, {1, 0}, {0, 1}), 0);
  EXPECT_EQ(orient2d({inf, 0}, {1, 0}, {0, 1}), 0);
}

std::array<BigInteger, 3> scaled(const Difference& d) {
  return {BigInteger::scaled(d.to.x) - BigInteger::scaled(d.from.x),
          BigInteger::scaled(d.to.y) - BigInteger::scaled(d.from.y),
          BigInteger::scaled(d.to.z) - BigInteger::scaled(d.from.z)};
}

void expect_signs_of(const std::array<Difference, 3>& d) {
  const auto u = scaled(d[0]), v = scaled(d[1]), w = scaled(d[2]);
  const BigInteger determinant =
      u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
  ASSERT_EQ(determinant_sign(d[0], d[1], d[2]), determinant.sign());
  const BigInteger longer = (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]) - (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  ASSERT_EQ(compare_lengths(d[0], d[1]), longer.sign());
}

TEST(predicates, signs_of_differences_agree_with_integers) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::uniform_int_distribution<int> small(-2, 2), exponent(-1074, 1020);
  const double step = std::numeric_limits<double>::epsilon();
  for (int round = 0; round < runs(160); ++round) {
    const int kind = round % 4;
    const double scale = std::ldexp(1.0, exponent(random));
    const auto value = [&] {
      if (kind == 0) return any_double(random);
      if (kind == 1) return unit(random);
      if (kind == 2) return small(random) * scale;
      return 1 + small(random) * step;
    };
    const auto point = [&] { return dvec3(value(), value(), value()); };
    std::array<Difference, 3> d;
    for (Difference& difference : d) difference = {point(), point()};
    expect_signs_of(d);
  }
}

}  // namespace
}  // namespace ryosen
