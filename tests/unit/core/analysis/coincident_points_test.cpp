#include "ryosen/analysis/coincident_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "ryosen/analysis/problem_sets.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/random_edits.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

using Numbers = std::vector<std::uint32_t>;

// Vertices alone at these places.
Mesh points_at(const std::vector<glm::dvec3>& places) {
  IndexedMesh source;
  source.positions = places;
  return from_indexed(std::move(source));
}

Numbers found(const Mesh& mesh) {
  const CoincidentPoints points(mesh);
  Numbers numbers;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (points.is_on_another(Vertex(i))) numbers.push_back(i);
  return numbers;
}

// By comparing all places in order.
Numbers expected(const Mesh& mesh) {
  std::map<std::tuple<double, double, double>, Numbers> at;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const Vertex v(i);
    if (!mesh.is_alive(v) || point(mesh, v) != v) continue;
    const glm::dvec3& p = mesh.position(v);
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) at[{p.x, p.y, p.z}].push_back(i);
  }
  Numbers all;
  for (const auto& [place, points] : at)
    if (points.size() > 1) all.insert(all.end(), points.begin(), points.end());
  std::sort(all.begin(), all.end());
  return all;
}

TEST(coincident_points, are_those_at_equal_places) {
  EXPECT_EQ(found(points_at({})), Numbers());
  EXPECT_EQ(found(points_at({{1, 2, 3}})), Numbers());
  EXPECT_EQ(found(points_at({{1, 2, 3}, {1, 2, 4}, {1, 2, 3}})), (Numbers{0, 2}));
  EXPECT_EQ(found(points_at({{5, 5, 5}, {5, 5, 5}, {0, 0, 1}, {5, 5, 5}})), (Numbers{0, 1, 3}));
  EXPECT_EQ(found(points_at({{0, 1, 2}, {-0.0, 1, 2}})), (Numbers{0, 1})) << "equal as numbers";
  EXPECT_EQ(found(points_at({{1, 1, 1}, {1, 1, std::nextafter(1.0, 2)}})), Numbers()) << "near is not equal";
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(found(points_at({{nan, 0, 0}, {nan, 0, 0}, {inf, 0, 0}, {inf, 0, 0}})), Numbers()) << "these have no place";
}

// The copies of one point are one, wherever they are among others.
TEST(coincident_points, copies_of_a_point_are_no_others) {
  const Mesh fans = make_mesh(bow_tie());
  ASSERT_TRUE(fans.has_copies());
  EXPECT_EQ(found(fans), Numbers());
  for (std::uint64_t seed = 1; seed <= 400 && !HasFailure(); ++seed) {
    const Mesh mesh = random_kernel_mesh(seed);
    EXPECT_EQ(found(mesh), expected(mesh)) << seed;
  }
}

// Points on a small grid that are moved, made, deleted, undone and redone.
TEST(coincident_points, are_kept_current_through_edits_undo_and_redo) {
  std::size_t met = 0, parted = 0;
  for (std::uint64_t seed = 1; seed <= 60 && !HasFailure(); ++seed) {
    Dice dice(seed);
    const auto place = [&] { return glm::dvec3(dice.below(2), dice.below(2), dice.below(3)); };
    std::vector<glm::dvec3> places;
    for (int i = 0; i < 8; ++i) places.push_back(place());
    Mesh mesh = points_at(places);
    Journal journal;
    ProblemSets sets(mesh);
    const auto edit_one = [&](int thrown) {
      const Vertex v(static_cast<std::uint32_t>(dice.below(static_cast<int>(mesh.vertex_slots()))));
      const bool makes = thrown == 2;
      if (!makes && !mesh.is_alive(v)) return false;
      Edit edit(mesh, &journal);
      if (makes)
        edit.fresh(edit.add_vertex(place()));
      else if (thrown == 3)
        edit.drop(v);
      else
        edit.set_position(v, place());
      edit.commit();
      return true;
    };
    for (int step = 0; step < 120; ++step) {
      const std::uint32_t before = sets.count(ProblemKind::coincident_points);
      const auto transaction = random_step(mesh, journal, dice, 7, edit_one);
      if (!transaction) continue;
      sets.update(mesh, journal, *transaction);
      ASSERT_EQ(sets.of(ProblemKind::coincident_points).to_vector(), expected(mesh)) << seed << " step " << step;
      met += sets.count(ProblemKind::coincident_points) > before;
      parted += sets.count(ProblemKind::coincident_points) < before;
    }
  }
  EXPECT_GT(met, 500u) << "the dice must find enough to do";
  EXPECT_GT(parted, 500u);
}

// However many share a place, each comes and goes at the same cost: a pass over the others would take hours here.
TEST(coincident_points, of_one_place_cost_no_more_than_those_of_many) {
  constexpr std::uint32_t n = 200'000;
  Mesh mesh = points_at(std::vector<glm::dvec3>(n, glm::dvec3(1, 2, 3)));
  CoincidentPoints points(mesh);
  for (const bool is_back : {false, true}) {
    for (std::uint32_t i = 0; i < n; ++i) {
      Edit edit(mesh, nullptr);
      edit.set_position(Vertex(i), is_back ? glm::dvec3(1, 2, 3) : glm::dvec3(i, 0, 0));
      edit.commit();
      points.update(mesh, std::vector<Vertex>{Vertex(i)});
    }
    for (const std::uint32_t i : {0u, n / 2, n - 1}) EXPECT_EQ(points.is_on_another(Vertex(i)), is_back);
  }
}

}  // namespace
}  // namespace ryosen
