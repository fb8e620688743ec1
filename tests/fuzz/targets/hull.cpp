// Coordinates of any bits to the convex hull, held against brute force over big integers; and the steps against it.
#include <boost/multiprecision/cpp_int.hpp>

#include <bit>
#include <cmath>

#include "ryosen/textbook/steps/hull/hull_steps.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/failure.h"
#include "tests/fuzz/targets/targets.h"
#include "tests/support/core/brute_hull.h"

namespace ryosen::fuzz {
namespace {

using Big = boost::multiprecision::cpp_int;
using Brute = test::BruteForce<Big, Big>;

// In units of the smallest double.
Big integer_of(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  auto scaled = Big(static_cast<std::int64_t>(std::ldexp(mantissa, 53)));
  const int shift = exponent - 53 + 1074;
  return shift >= 0 ? Big(scaled << static_cast<unsigned>(shift)) : Big(scaled >> static_cast<unsigned>(-shift));
}

double raw_double(Bytes& bytes) {
  std::uint64_t bits = 0;
  for (int i = 0; i < 8; ++i) bits = bits << 8u | bytes.byte();
  return std::bit_cast<double>(bits);
}

// Each coordinate of its own bits, or one of a few, so that points share planes; these are of any bits or whole
// numbers.
std::vector<glm::dvec3> points_of(Bytes& bytes) {
  const std::size_t count = bytes.below(10), kind = bytes.below(3);
  std::vector<double> few;
  for (std::size_t i = 0; kind > 0 && i < 6; ++i)
    few.push_back(kind == 1 ? raw_double(bytes) : static_cast<double>(static_cast<std::int8_t>(bytes.byte())));
  std::vector<glm::dvec3> points(count);
  for (glm::dvec3& p : points)
    for (int axis = 0; axis < 3; ++axis) p[axis] = kind == 0 ? raw_double(bytes) : few[bytes.below(few.size())];
  return points;
}

test::BruteHull expected_of(const std::vector<glm::dvec3>& points) {
  std::vector<Brute::Point> finite;
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const glm::dvec3& p = points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
    finite.push_back({integer_of(p.x), integer_of(p.y), integer_of(p.z)});
    numbers.push_back(i);
  }
  test::BruteHull hull = Brute(finite).hull();
  for (std::uint32_t& v : hull.vertices) v = numbers[v];
  std::set<std::vector<std::uint32_t>> facets;
  for (std::vector<std::uint32_t> facet : hull.facets) {
    for (std::uint32_t& v : facet) v = numbers[v];
    facets.insert(std::move(facet));
  }
  hull.facets = std::move(facets);
  return hull;
}

void expect_hull(const std::vector<glm::dvec3>& points, const test::BruteHull& expected) {
  const ConvexHull hull = convex_hull(points);
  expect(hull.dimension == expected.dimension, "the dimension is another");
  expect(hull.vertices == expected.vertices, "the extreme points are others");
  expect(hull.facet_count() == expected.facets.size(), "the number of facets is another");
  std::vector<std::vector<std::uint32_t>> facets;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) facets.emplace_back(hull.facet(f).begin(), hull.facet(f).end());
  expect(facets == std::vector(expected.facets.begin(), expected.facets.end()), "the facets are others");
  for (const HullOrderRow& row : hull_orders()) {
    HullSteps steps(points, row.order, 1);
    while (steps.next()) continue;
    expect(steps.hull() == hull, "the steps end with another hull");
  }
}

}  // namespace

void fuzz_hull(Input input) {
  Bytes bytes(input);
  const std::vector<glm::dvec3> points = points_of(bytes);
  for (const glm::dvec3& p : points) tell(std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z));
  expect_hull(points, expected_of(points));
}

}  // namespace ryosen::fuzz
