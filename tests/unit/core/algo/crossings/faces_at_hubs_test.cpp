// Of many pages on a spine a triangle finds those it can meet.
#include "ryosen/algo/crossings/faces_at_hubs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/geometry/predicates.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {
namespace {

constexpr std::uint32_t lower = 0, upper = 1, other = 7, another = 8, third_one = 9;
const glm::dvec3 along = glm::normalize(glm::dvec3(1, 2, 3)), aside = glm::normalize(glm::cross(along, {0, 0, 1}));

// So far along the spine, which goes from 0 to 1, so far from it, and turned about it by a share of a whole turn.
glm::dvec3 at(double height, double distance = 0, double turn = 0) {
  const double angle = 6.283185307179586 * turn;
  return height * along + distance * (std::cos(angle) * aside + std::sin(angle) * glm::cross(along, aside));
}

std::size_t count_found(std::uint32_t pages, const NumberedTriangle& triangle) {
  const std::array<glm::dvec3, 2> spine{at(0), at(1)};
  FacesAtHubs faces(spine);
  for (std::uint32_t i = 0; i < pages; ++i) faces.add(Face(i), {spine[0], spine[1], at(0.4, 1, (i + 0.5) / pages)});
  std::size_t found = 0;
  const std::array<std::uint32_t, 2> numbers{lower, upper};
  faces.find(triangle, numbers, [&](Face) { ++found; });
  return found;
}

TEST(faces_at_hubs, find_few_of_many_pages_on_a_spine) {
  for (const std::uint32_t n : {1000u, 4000u}) {
    const double turn = 0.3 + 0.5 / n;  // in the plane of one of them
    const auto found = [&](const NumberedTriangle& t) { return count_found(n, t); };
    EXPECT_EQ(found({{at(0), at(1), at(0.7, 0.5, turn)}, {lower, upper, other}}), 1u) << "on the spine";
    EXPECT_EQ(found({{at(0.2, 0.5, turn), at(1), at(1.2, 1, turn)}, {other, upper, another}}), 1u) << "at an end";
    EXPECT_EQ(found({{at(1), at(2), at(1.2, 1, turn)}, {upper, other, another}}), 1u) << "on the next piece";
    EXPECT_EQ(found({{at(0.2, 1, turn), at(2), at(2.2, 1, turn)}, {other, another, third_one}}), 1u) << "farther on";
    EXPECT_EQ(found({{at(0.2, 0.5, turn), at(0.3, 0.6, turn), at(0.2, 0.7, turn)}, {other, another, third_one}}), 1u);
  }
}

TEST(faces_at_hubs, find_what_a_triangle_crosses) {
  constexpr std::uint32_t n = 1000;
  const NumberedTriangle wide{{at(0.5, 0.5, 0.2), at(0.5, 0.5, 0.45), at(0.5, 0.9, 0.3)}, {other, another, third_one}};
  EXPECT_GE(count_found(n, wide), 250u);
  EXPECT_LE(count_found(n, wide), 260u);
  const NumberedTriangle through{{at(0.5, 1, 0), at(0.5, 1, 0.4), at(0.5, 1, 0.7)}, {other, another, third_one}};
  EXPECT_EQ(count_found(n, through), n) << "across the spine";
  const NumberedTriangle tip{{at(0.5), at(0.5, 1, 0.4), at(0.6, 1, 0.4)}, {other, another, third_one}};
  EXPECT_EQ(count_found(n, tip), n) << "touches the spine";
  const NumberedTriangle along_it{{at(0), at(2), at(1, 1, 0.4)}, {lower, other, another}};
  EXPECT_EQ(count_found(n, along_it), n) << "along all of the spine";
  const NumberedTriangle same_place{{at(1), at(0.5, 1, 0.4), at(0.6, 1, 0.4)}, {other, another, third_one}};
  EXPECT_EQ(count_found(n, same_place), n) << "another point at its end";
}

// Corners at the ends and on the line through them but for rounding, at those of pages, in their planes and anywhere.
TEST(faces_at_hubs, hold_each_page_that_a_triangle_meets) {
  Dice dice(5);
  const auto unit = [&] { return 2 * dice.unit() - 1; };
  const auto tiny = [&] { return std::pow(10.0, -dice.below(18)) * unit(); };
  const std::array<std::uint32_t, 2> numbers{lower, upper};
  std::size_t met = 0;
  for (int round = 0; round < 20'000; ++round) {
    const double turn = unit();
    std::vector<NumberedTriangle> pages;
    FacesAtHubs faces(std::array{at(0), at(1)});
    for (int i = 1 + dice.below(12); i > 0; --i) {
      const glm::dvec3 third =
          at(2 * unit(), dice.one_in(4) ? tiny() : unit(), dice.one_in(3) ? unit() : turn + tiny());
      if (are_collinear(at(0), at(1), third)) continue;
      pages.push_back({{at(0), at(1), third}, {lower, upper, third_one + i}});
      faces.add(Face(static_cast<std::uint32_t>(pages.size() - 1)), pages.back().places);
    }
    if (pages.empty()) continue;
    const auto corner = [&](NumberedTriangle& t, std::uint32_t i) {
      const NumberedTriangle& page = pages[dice.below(static_cast<int>(pages.size()))];
      const auto end = static_cast<std::uint32_t>(dice.below(2));
      const int kind = dice.below(6);
      t.numbers[i] = kind == 0 ? end : kind == 1 ? page.numbers[2] : 100 + i;
      t.places[i] = kind <= 0   ? at(end)
                    : kind == 1 ? page.places[2]
                    : kind == 2 ? at(dice.one_in(2) ? 1 + std::abs(tiny()) : -std::abs(tiny()), tiny(), unit())
                    : kind == 3 ? at(0) + 2 * unit() * (at(1) - at(0)) + 2 * unit() * (page.places[2] - at(0))
                                : at(3 * unit(), 2 * unit(), kind == 4 ? turn + tiny() : unit());
    };
    NumberedTriangle t;
    for (const std::uint32_t i : {0u, 1u, 2u}) corner(t, i);
    if (are_collinear(t.places[0], t.places[1], t.places[2])) continue;
    std::vector<Face> found;
    faces.find(t, numbers, [&](Face f) { found.push_back(f); });
    for (std::uint32_t i = 0; i < pages.size(); ++i) {
      if (!meet_elsewhere(pages[i], t)) continue;
      ++met;
      EXPECT_NE(std::find(found.begin(), found.end(), Face(i)), found.end()) << "round " << round;
    }
  }
  EXPECT_GT(met, 10'000u);
}

}  // namespace
}  // namespace ryosen::test
