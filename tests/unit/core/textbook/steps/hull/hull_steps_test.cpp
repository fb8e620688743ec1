#include "ryosen/textbook/steps/hull/hull_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "ryosen/geometry/predicates.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/textbook/forms/dcel.h"

namespace ryosen {
namespace {

using forms::DcelRecords;

// The records without rows that are gone, for a Dcel; vertices without an edge stay.
DcelRecords in_use(const DcelRecords& records) {
  using Index = std::uint32_t;
  std::vector<Index> half_edge(records.half_edges.size(), no_index), face(records.faces.size(), no_index);
  DcelRecords kept;
  kept.vertices = records.vertices;
  for (Index h = 0; h < half_edge.size(); ++h) {
    if (records.half_edges[h].origin == no_index) continue;
    half_edge[h] = static_cast<Index>(kept.half_edges.size());
    kept.half_edges.push_back(records.half_edges[h]);
  }
  for (Index f = 0; f < face.size(); ++f) {
    if (records.faces[f].outer_component == no_index) continue;
    face[f] = static_cast<Index>(kept.faces.size());
    kept.faces.push_back(records.faces[f]);
  }
  const auto renumber = [](Index& link, const std::vector<Index>& number) {
    if (link != no_index) link = number[link];
  };
  for (auto& v : kept.vertices) renumber(v.incident_edge, half_edge);
  for (auto& h : kept.half_edges) {
    for (Index* const link : {&h.twin, &h.next, &h.prev}) renumber(*link, half_edge);
    renumber(h.face, face);
  }
  for (auto& f : kept.faces) renumber(f.outer_component, half_edge);
  return kept;
}

std::vector<glm::dvec3> points_of(int kind, std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> small(-2, 2);
  std::normal_distribution<double> normal;
  std::vector<glm::dvec3> points;
  while (points.size() < count) {
    const glm::dvec3 p(normal(random), normal(random), normal(random));
    if (kind == 0) points.push_back(p);
    if (kind == 1) points.emplace_back(small(random), small(random), small(random));
    if (kind == 2) points.push_back(p / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z));
    if (kind == 3) points.emplace_back(small(random), small(random), points.size() % 7 == 0 ? 1 : 0);
  }
  return points;
}

class HullStepsOf : public testing::TestWithParam<std::tuple<int, HullOrder>> {
 protected:
  std::vector<glm::dvec3> points_ = points_of(std::get<0>(GetParam()), 160, 4);
  HullOrder order_ = std::get<1>(GetParam());
};

std::array<std::uint32_t, 3> corners_of(const DcelRecords& records, std::uint32_t face) {
  std::array<std::uint32_t, 3> corners{};
  std::uint32_t h = records.faces[face].outer_component;
  for (std::uint32_t& corner : corners) {
    corner = records.half_edges[h].origin;
    h = records.half_edges[h].next;
  }
  return corners;
}

using Edge2 = std::pair<std::uint32_t, std::uint32_t>;

// The directed edges of these faces of which the opposite one is in none of them.
std::set<Edge2> boundary_of(const DcelRecords& records, const std::vector<std::uint32_t>& faces) {
  std::set<Edge2> all, boundary;
  for (const std::uint32_t f : faces) {
    const auto c = corners_of(records, f);
    for (std::size_t k = 0; k < 3; ++k) all.emplace(c[k], c[(k + 1) % 3]);
  }
  for (const Edge2& e : all)
    if (!all.contains({e.second, e.first})) boundary.insert(e);
  return boundary;
}

// Faces beside each other in one plane of which one is made, by asking each made one.
std::set<Edge2> coplanar_with(const DcelRecords& after, const std::vector<std::uint32_t>& made,
                              const std::vector<glm::dvec3>& points) {
  std::set<Edge2> pairs;
  for (const std::uint32_t f : made) {
    const auto c = corners_of(after, f);
    std::uint32_t h = after.faces[f].outer_component;
    for (int k = 0; k < 3; ++k, h = after.half_edges[h].next) {
      const std::uint32_t beside = after.half_edges[after.half_edges[h].twin].face;
      const auto d = corners_of(after, beside);
      if (std::all_of(d.begin(), d.end(), [&](std::uint32_t p) {
            return orient3d(points[c[0]], points[c[1]], points[c[2]], points[p]) == 0;
          }))
        pairs.insert(std::minmax(f, beside));
    }
  }
  return pairs;
}

// What a step says of the records before it.
void expect_sound(const HullStep& step, const DcelRecords& before, const std::vector<glm::dvec3>& points) {
  std::vector<std::uint32_t> seen;
  for (std::uint32_t f = 0; f < before.faces.size(); ++f) {
    if (before.faces[f].outer_component == no_index) continue;
    const auto c = corners_of(before, f);
    if (orient3d(points[c[0]], points[c[1]], points[c[2]], points[step.point]) > 0) seen.push_back(f);
  }
  std::vector<std::uint32_t> told = step.seen;
  std::sort(told.begin(), told.end());
  ASSERT_EQ(told, seen) << "all faces that the point sees, by asking each";
  ASSERT_EQ(step.kind == HullStep::Kind::extend, !seen.empty());
  std::set<Edge2> horizon;
  const std::size_t count = step.horizon.size();
  for (std::size_t k = 0; k < count; ++k) {
    const auto& h = before.half_edges[step.horizon[k]];
    const std::uint32_t from = before.half_edges[h.next].origin, to = h.origin;  // as the seen face has it
    horizon.emplace(from, to);
    const auto& after = before.half_edges[step.horizon[(k + 1) % count]];
    ASSERT_EQ(before.half_edges[after.next].origin, to) << "the horizon is in order";
  }
  ASSERT_EQ(horizon, boundary_of(before, seen));
  ASSERT_EQ(step.made.size(), count);
}

// And what is there behind it is a mesh.
void expect_goes_back(const HullStep& step, const DcelRecords& after, const DcelRecords& before) {
  DcelRecords back = after;
  take_back(step, back);
  ASSERT_EQ(back, before);
  const auto broken = check_invariants(forms::Dcel(in_use(after)).to_mesh());
  ASSERT_FALSE(broken) << broken->sentence;
}

TEST_P(HullStepsOf, are_sound_and_can_be_taken_back) {
  HullSteps steps(points_, order_, 7);
  ASSERT_EQ(steps.dimension(), 3);
  DcelRecords before;
  for (const glm::dvec3& p : points_) before.vertices.push_back({p, no_index});
  std::size_t done = 0, united = 0;
  while (const HullStep* const step = steps.next()) {
    SCOPED_TRACE(caption(*step).en);
    EXPECT_NE(caption(*step).en, caption(*step).ja);
    if (done++ == 0)
      EXPECT_EQ(step->points.size(), 4u);
    else
      expect_sound(*step, before, points_);
    if (HasFatalFailure()) return;
    united += step->united.size();
    DcelRecords after = before;
    apply(*step, after);
    ASSERT_EQ(after, steps.records());
    if (step->kind == HullStep::Kind::extend) {
      std::set<Edge2> pairs;
      for (const auto& [one, other] : step->united) pairs.insert(std::minmax(one, other));
      ASSERT_EQ(pairs, coplanar_with(after, step->made, points_));
    }
    expect_goes_back(*step, after, before);
    if (HasFatalFailure()) return;
    before = std::move(after);
  }
  EXPECT_EQ(done, steps.step_count());
  EXPECT_EQ(done, points_.size() - 3);
  EXPECT_EQ(steps.hull(), convex_hull(points_));
  if (std::get<0>(GetParam()) == 1) {
    EXPECT_GT(united, 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(, HullStepsOf,
                         testing::Combine(testing::Range(0, 4), testing::Values(HullOrder::as_given, HullOrder::random,
                                                                                HullOrder::farthest)));

TEST(hull_steps, of_every_seed_end_with_the_same_bytes) {
  for (int kind = 0; kind < 4; ++kind) {
    const std::vector<glm::dvec3> points = points_of(kind, 300, 11);
    const ConvexHull expected = convex_hull(points);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      HullSteps steps(points, HullOrder::random, seed);
      while (steps.next()) continue;
      ASSERT_EQ(steps.hull(), expected) << kind << " " << seed;
    }
  }
}

TEST(hull_steps, say_why_a_point_changes_nothing) {
  const std::vector<glm::dvec3> points{{0, 0, 0},    {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {4, 0, 0},
                                       {.5, .5, .5}, {1, 1, 0}, {5, 5, 5}, {2, 2, 1}};
  HullSteps steps(points, HullOrder::as_given);
  std::vector<HullStep::Kind> kinds;
  std::vector<std::uint32_t> witnesses;
  while (const HullStep* const step = steps.next()) {
    kinds.push_back(step->kind);
    witnesses.push_back(step->witness);
  }
  using Kind = HullStep::Kind;
  EXPECT_EQ(kinds, (std::vector{Kind::begin, Kind::equal, Kind::inside, Kind::on_face, Kind::extend, Kind::inside}));
  EXPECT_EQ(witnesses[1], 1u);
  const std::vector<glm::dvec3> equal(5);
  const HullSteps flat(equal, HullOrder::as_given);
  EXPECT_EQ(flat.dimension(), 0);
  EXPECT_EQ(flat.step_count(), 0u);
}

TEST(hull_steps, the_farthest_first_makes_fewest_faces) {
  const std::vector<glm::dvec3> points = points_of(0, 3000, 2);
  std::map<HullOrder, std::size_t> made;
  for (const HullOrderRow& row : hull_orders()) {
    HullSteps steps(points, row.order, 1);
    while (steps.next()) continue;
    made[row.order] = steps.made_so_far();
  }
  EXPECT_LT(made[HullOrder::farthest], made[HullOrder::random]);
}

// In a plane the elements are the half-edges within the face.
class PlanarStepsOf : public testing::TestWithParam<std::tuple<int, HullOrder>> {
 protected:
  static std::vector<glm::dvec3> flat_points(int kind) {
    std::mt19937 random(6);
    std::uniform_int_distribution<int> small(-3, 3);
    std::normal_distribution<double> normal;
    std::vector<glm::dvec3> points;
    while (points.size() < 150) {
      const double x = normal(random), y = normal(random);
      if (kind == 0) points.emplace_back(x, y, 0);
      if (kind == 1) points.emplace_back(small(random), small(random), 0);
      if (kind == 2) points.emplace_back(0, std::cos(x * 9), std::sin(x * 9));
      const int s = small(random), t = small(random);
      if (kind == 3) points.emplace_back(s + 2 * t, s - t, 1 - 3 * s);  // any plane, all sums exact
    }
    return points;
  }
  std::vector<glm::dvec3> points_ = flat_points(std::get<0>(GetParam()));
  HullOrder order_ = std::get<1>(GetParam());
};

// Half-edges within the face from which the point lies strictly outside, by asking each with the normal of three
// corners.
std::set<std::uint32_t> edges_seen(const DcelRecords& records, const std::vector<glm::dvec3>& points, std::uint32_t p) {
  const auto corner = [&](std::uint32_t h) { return points[records.half_edges[h].origin]; };
  std::set<std::uint32_t> all, seen;
  for (std::uint32_t h = 0; h < records.half_edges.size(); ++h)
    if (records.half_edges[h].face != no_index) all.insert(h);
  for (const std::uint32_t h : all) {
    const glm::dvec3 from = corner(h), to = corner(records.half_edges[h].next);
    int sign = 0, inner = 0;
    for (int axis = 0; axis < 3 && inner == 0; ++axis) {
      for (const std::uint32_t k : all)
        if (inner == 0) inner = cross_component_sign(from, to, corner(k), axis);
      sign = cross_component_sign(from, to, points[p], axis);
    }
    if (sign * inner < 0) seen.insert(h);
  }
  return seen;
}

// Half-edges behind each other on one line of which one is made, by asking each made one.
std::set<Edge2> collinear_with(const DcelRecords& after, const std::vector<std::uint32_t>& made,
                               const std::vector<glm::dvec3>& points) {
  const auto begin_of = [&](std::uint32_t h) { return points[after.half_edges[h].origin]; };
  std::set<Edge2> pairs;
  for (const std::uint32_t h : made)
    for (const std::uint32_t first : {h, after.half_edges[h].prev}) {
      const std::uint32_t second = after.half_edges[first].next, third = after.half_edges[second].next;
      if (are_collinear(begin_of(first), begin_of(second), begin_of(third))) pairs.insert(std::minmax(first, second));
    }
  return pairs;
}

TEST_P(PlanarStepsOf, are_sound_and_can_be_taken_back) {
  HullSteps steps(points_, order_, 7);
  ASSERT_EQ(steps.dimension(), 2);
  DcelRecords before;
  for (const glm::dvec3& p : points_) before.vertices.push_back({p, no_index});
  std::size_t done = 0, united = 0;
  while (const HullStep* const step = steps.next()) {
    SCOPED_TRACE(caption(*step).en);
    EXPECT_TRUE(step->is_planar);
    if (done++ > 0) {
      const std::set<std::uint32_t> seen = edges_seen(before, points_, step->point);
      ASSERT_EQ(std::set(step->seen.begin(), step->seen.end()), seen);
      ASSERT_EQ(step->kind == HullStep::Kind::extend, !seen.empty());
      if (!seen.empty()) {
        ASSERT_EQ(step->horizon.size(), 2u);
        EXPECT_EQ(before.half_edges[step->horizon[0]].next, step->seen.front());
        EXPECT_EQ(before.half_edges[step->seen.back()].next, step->horizon[1]);
        EXPECT_EQ(step->made.size(), 2u);
      }
    }
    united += step->united.size();
    DcelRecords after = before;
    apply(*step, after);
    ASSERT_EQ(after, steps.records());
    if (step->kind == HullStep::Kind::extend) {
      std::set<Edge2> pairs;
      for (const auto& [one, other] : step->united) pairs.insert(std::minmax(one, other));
      ASSERT_EQ(pairs, collinear_with(after, step->made, points_));
    }
    expect_goes_back(*step, after, before);
    if (HasFatalFailure()) return;
    ASSERT_EQ(in_use(after).faces.size(), 1u);
    before = std::move(after);
  }
  EXPECT_EQ(done, points_.size() - 2);
  EXPECT_EQ(steps.hull(), convex_hull(points_));
  if (std::get<0>(GetParam()) % 2 == 1 && order_ == HullOrder::random) {
    EXPECT_GT(united, 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(, PlanarStepsOf,
                         testing::Combine(testing::Range(0, 4), testing::Values(HullOrder::as_given, HullOrder::random,
                                                                                HullOrder::farthest)));

TEST(hull_steps, a_copy_goes_on_from_the_same_state) {
  for (const bool is_flat : {false, true}) {
    std::vector<glm::dvec3> points = points_of(2, 120, 3);
    if (is_flat)
      for (glm::dvec3& p : points) p.z = 0;
    HullSteps steps(points, HullOrder::farthest);
    for (int i = 0; i < 40; ++i) steps.next(i % 2 == 0);
    HullSteps other = steps.copy();
    EXPECT_EQ(other.steps_done(), 40u);
    while (const HullStep* const step = steps.next()) {
      const HullStep* const same = other.next();
      ASSERT_TRUE(same);
      ASSERT_EQ(step->changes, same->changes);
      ASSERT_EQ(step->kind, same->kind);
      ASSERT_EQ(step->witness, same->witness);
    }
    EXPECT_EQ(other.next(), nullptr);
    EXPECT_EQ(other.hull(), convex_hull(points));
  }
}

// Points along a curve all of whose pairs are edges: whoever hands all
// points over all new faces takes n^2 of them; these n points take about 30 hand-overs each.
TEST(hull_steps, of_bad_shapes_make_few_faces) {
  std::vector<glm::dvec3> moments;
  for (int i = -2000; i < 2000; ++i) {
    const double t = i / 2000.0;
    moments.emplace_back(t, t * t, t * t * t);
  }
  HullSteps steps(moments, HullOrder::random, 3);
  while (steps.next(false)) continue;
  EXPECT_LT(steps.made_so_far(), 10 * moments.size());
  EXPECT_EQ(steps.hull(), convex_hull(moments));
}

TEST(insertion_order, shuffles_by_the_seed_alone) {
  const std::vector<std::uint32_t> numbers = shuffled_numbers(1000, 5);
  EXPECT_EQ(numbers, shuffled_numbers(1000, 5));
  EXPECT_NE(numbers, shuffled_numbers(1000, 6));
  EXPECT_EQ(std::set(numbers.begin(), numbers.end()).size(), 1000u);
}

}  // namespace
}  // namespace ryosen
