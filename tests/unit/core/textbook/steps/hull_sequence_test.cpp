#include "ryosen/textbook/steps/hull_sequence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "ryosen/geometry/predicates.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/names.h"
#include "tests/support/core/step_checks.h"

namespace ryosen {
namespace {

using steps::HullSequence;
using steps::Role;
using steps::Step;

enum class Places { ball, lattice, plane, grid };

std::vector<glm::dvec3> places_of(Places kind, std::size_t count) {
  std::mt19937 random(static_cast<unsigned>(count));
  std::normal_distribution<double> normal;
  std::uniform_int_distribution<int> small(-2, 2);
  std::vector<glm::dvec3> points;
  while (points.size() < count) {
    if (kind == Places::ball) points.emplace_back(normal(random), normal(random), normal(random));
    if (kind == Places::lattice) points.emplace_back(small(random), small(random), small(random));
    if (kind == Places::plane) points.emplace_back(normal(random), 0, normal(random));
    if (kind == Places::grid) points.emplace_back(small(random), 1, small(random));
  }
  return points;
}

std::set<Element> marked(const Step& step, Role role) {
  std::set<Element> all;
  for (const steps::Mark& mark : step.marks)
    if (mark.role == role) all.insert(mark.element);
  return all;
}

bool sees(const Mesh& mesh, Face f, const glm::dvec3& p) {
  const Halfedge h = mesh.halfedge(f);
  return orient3d(mesh.position(mesh.from(h)), mesh.position(mesh.to(h)), mesh.position(mesh.to(mesh.next(h))), p) > 0;
}

// In space: every face of the mesh before is asked; what lies between one that is seen and one that is not.
void expect_horizon_in_space(const Mesh& before, const Step& step, const glm::dvec3& p) {
  std::set<Element> seen, horizon;
  for (std::uint32_t f = 0; f < before.face_slots(); ++f)
    if (before.is_alive(Face(f)) && sees(before, Face(f), p)) seen.insert(Face(f));
  for (std::uint32_t e = 0; e < before.edge_slots(); ++e) {
    if (!before.is_alive(Edge(e))) continue;
    const bool one = sees(before, before.face(halfedge(Edge(e), 0)), p),
               other = sees(before, before.face(halfedge(Edge(e), 1)), p);
    if (one != other) horizon.insert(Edge(e));
  }
  ASSERT_EQ(marked(step, Role::visible), seen);
  ASSERT_EQ(marked(step, Role::horizon), horizon);
  ASSERT_EQ(step.gone.size(), seen.size());
}

// In the plane of y: every edge of the face before; the edges that are not seen beside those that are.
void expect_horizon_in_plane(const Mesh& before, const Step& step, const glm::dvec3& p) {
  std::set<Element> seen, horizon;
  const auto is_seen = [&](Halfedge h) {
    // Counter-clockwise seen from the side of +y, that is from the tip of that axis.
    return orient2d(seen_along(before.position(before.from(h)), 1), seen_along(before.position(before.to(h)), 1),
                    seen_along(p, 1)) < 0;
  };
  for (std::uint32_t f = 0; f < before.face_slots(); ++f) {
    const Halfedge start = before.halfedge(Face(f));
    Halfedge h = start;
    do {
      if (is_seen(h)) seen.insert(edge(h));
      if (!is_seen(h) && (is_seen(before.next(h)) || is_seen(before.prev(h)))) horizon.insert(edge(h));
    } while ((h = before.next(h)) != start);
  }
  ASSERT_EQ(marked(step, Role::visible), seen);
  ASSERT_EQ(marked(step, Role::horizon), horizon);
}

class HullSequenceOf : public testing::TestWithParam<std::tuple<Places, HullOrder>> {};

TEST_P(HullSequenceOf, plays_and_its_horizon_is_the_border_of_what_is_seen) {
  const auto [kind, order] = GetParam();
  const bool is_flat = kind == Places::plane || kind == Places::grid;
  const std::vector<glm::dvec3> points = places_of(kind, 60);
  HullSequence sequence(points, order, 5);
  ASSERT_EQ(sequence.size(), points.size() - (is_flat ? 2 : 3));
  test::expect_plays(sequence);
  for (std::size_t i = 2; i <= sequence.size(); ++i) {
    const Step step = sequence.at(i);
    SCOPED_TRACE(step.caption.en);
    ASSERT_EQ(step.marks[0].role, Role::asked);
    for (const Element& beside : marked(step, Role::compared))
      ASSERT_NE(step.caption.en.find(" " + slot_name(beside)), std::string::npos) << "called as it is marked";
    const glm::dvec3 p = points[step.marks[0].element.index];
    if (is_flat)
      expect_horizon_in_plane(sequence.mesh_at(i - 1), step, p);
    else
      expect_horizon_in_space(sequence.mesh_at(i - 1), step, p);
  }
  std::size_t corners = 0;
  const ConvexHull hull = convex_hull(points);
  for (std::uint32_t v = 0; v < points.size(); ++v)
    corners += !sequence.mesh_at(sequence.size()).is_isolated(Vertex(v));
  EXPECT_GE(corners, hull.vertices.size()) << "some may lie within facets";
  if (kind == Places::lattice || kind == Places::grid) {
    std::size_t united = 0;
    for (std::size_t i = 1; i <= sequence.size(); ++i) united += marked(sequence.at(i), Role::united).size();
    EXPECT_GT(united, 0u);
  } else {
    EXPECT_EQ(corners, hull.vertices.size());
  }
}

INSTANTIATE_TEST_SUITE_P(, HullSequenceOf,
                         testing::Combine(testing::Values(Places::ball, Places::lattice, Places::plane, Places::grid),
                                          testing::Values(HullOrder::as_given, HullOrder::random,
                                                          HullOrder::farthest)));

TEST(hull_sequence, of_several_stretches_is_the_same_forth_and_back) {
  const std::vector<glm::dvec3> points = places_of(Places::ball, 1500);
  HullSequence sequence(points, HullOrder::random, 1);
  const auto curve = sequence.curve();
  ASSERT_TRUE(curve);
  ASSERT_EQ(curve->values.size(), sequence.size());
  EXPECT_TRUE(std::is_sorted(curve->values.begin(), curve->values.end()));
  HullSteps steps(points, HullOrder::random, 1);
  for (std::size_t i = 0; steps.next(false); ++i) ASSERT_EQ(curve->values[i], steps.made_so_far());
  std::vector<std::pair<std::size_t, std::string>> captions;
  for (const std::size_t i : {1u, 512u, 513u, 1024u, 1025u, 1497u}) {
    captions.emplace_back(i, sequence.at(i).caption.en);
    const Mesh& mesh = sequence.mesh_at(i);
    EXPECT_EQ(3 * mesh.live().faces, 2 * mesh.live().edges) << i;
  }
  for (auto at = captions.rbegin(); at != captions.rend(); ++at)
    EXPECT_EQ(sequence.at(at->first).caption.en, at->second);
  EXPECT_EQ(sequence.mesh_at(0).live().faces, 0u);
}

TEST(hull_sequence, of_very_many_points_is_made_where_it_is_asked_for) {
  const std::vector<glm::dvec3> points = places_of(Places::ball, HullSequence::most_made + 10);
  HullSequence sequence(points, HullOrder::random, 1);
  EXPECT_GT(sequence.size(), HullSequence::most_made);
  EXPECT_TRUE(sequence.curve()->values.empty());
  EXPECT_EQ(sequence.at(3).delta->f, 2);
  EXPECT_LT(sequence.curve()->values.size(), 1000u);
  const Step later = sequence.at(20000);
  EXPECT_NE(later.caption.en, "");
  const std::size_t made = sequence.curve()->values.size();
  EXPECT_GE(made, 20000u);
  EXPECT_LT(made, 21000u);
  EXPECT_EQ(sequence.at(4).marks[0].role, Role::asked);
  EXPECT_EQ(sequence.at(20000).caption.en, later.caption.en);
}

}  // namespace
}  // namespace ryosen
