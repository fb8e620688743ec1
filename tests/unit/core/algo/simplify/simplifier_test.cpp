// Simplification in hard places: far smaller parts, exact planes, hubs, effort, levels and cancelling.
#include "core/algo/simplify/simplifier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/algo/simplify/simplify.h"
#include "core/pick/nearest.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/simplified.h"

namespace ryosen::test {
namespace {

// A part that is much smaller than the mesh is not lost to the places of the rest.
TEST(simplifier, turns_no_face_of_a_part_that_is_far_smaller_than_the_mesh) {
  const Mesh flat = sheet(12, [](std::uint32_t, std::uint32_t) { return 0.0; });
  for (const double size : {1e-9, 1e-14, 1e-15}) {
    IndexedMesh source;
    for (const glm::dvec3& p : flat.positions()) source.positions.push_back(size / 12 * p);
    for (const auto& face : polygons_of(flat)) {
      source.corners.insert(source.corners.end(), face.begin(), face.end());
      source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
    }
    const auto first = static_cast<std::uint32_t>(source.positions.size());
    for (const glm::dvec3& p : {glm::dvec3(1, 1, 0), glm::dvec3(2, 1, 0), glm::dvec3(1, 2, 0)})
      source.positions.push_back(p);
    source.corners.insert(source.corners.end(), {first, first + 1, first + 2});
    source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
    Mesh mesh = from_indexed(source);
    simplified(mesh, "ratio=0.4");
    EXPECT_LT(mesh.live().faces, 130u);
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
      if (!mesh.is_alive(Face(i))) continue;
      const Halfedge h = mesh.halfedge(Face(i));
      const auto at = [&](Vertex v) { return mesh.position(v) / size; };
      const glm::dvec3 a = at(mesh.from(h)), n = glm::cross(at(mesh.to(h)) - a, at(mesh.from(mesh.prev(h))) - a);
      EXPECT_GT(n.z, 0) << size << " f" << i;
    }
  }
}

// A plane that is not along the axes has no place without any error, but for those of its vertices.
TEST(simplifier, blocks_no_edge_by_an_error_that_one_of_its_ends_does_not_have) {
  Mesh mesh = sheet(20, [](std::uint32_t x, std::uint32_t y) { return 0.3 * x + 0.7 * y; });
  const AlgorithmResult result = simplified(mesh, "error=0");
  EXPECT_EQ(count_of(result, EdgeRule::free), 0u);
  EXPECT_EQ(result.account->stopped, Stop::error);
}

TEST(simplifier, takes_shares_as_they_are_meant) {
  Mesh hundred = make_mesh(torus_grid(5, 10)), twice = sheet(12, wave), once = twice;
  simplified(hundred, "ratio=0.58 triangulate=on");
  EXPECT_EQ(hundred.live().faces, 58u) << "of a hundred triangles that its squares are cut into";
  const AlgorithmResult a = simplified(twice, "error=0.01 relative=on"), b = simplified(once, "error=1%");
  EXPECT_EQ(*a.account->error_max, *b.account->error_max) << "a percentage is a share already";
}

// Of two cones on one circle, every edge of which something blocks again and again.
TEST(simplifier, asks_few_edges_of_a_hub_for_each_collapse) {
  const auto asked_per_collapse = [](std::uint32_t n) {
    Polygons faces;
    std::vector<glm::dvec3> places{{0, 0, 1}, {0, 0, -1}};
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 6.283185307179586 * i / n, radius = 1 + 0.05 * ((i * 7) % 5);
      places.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.02 * ((i * 3) % 7));
      faces.push_back({0, 2 + i, 2 + (i + 1) % n});
      faces.push_back({1, 2 + (i + 1) % n, 2 + i});
    }
    IndexedMesh source = indexed(faces);
    source.positions.assign(places.begin(), places.end());
    Mesh mesh = from_indexed(source);
    CollapseLimits limits;
    limits.turn_rad = 0.1;
    Simplifier simplifier(mesh, limits, {.faces = n / 50});
    Progress unheard;
    simplifier.run(unheard);
    return static_cast<double>(simplifier.asked()) / static_cast<double>(n);
  };
  EXPECT_LT(asked_per_collapse(1000), 40);
  EXPECT_LT(asked_per_collapse(2000), 40);
}

// By brute force over the places of the input.
double mean_square_from(const Mesh& mesh, const Mesh& input) {
  std::vector<Primitive> triangles;
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    if (!mesh.is_alive(Face(i))) continue;
    const Halfedge h = mesh.halfedge(Face(i));
    triangles.push_back(Primitive::triangle(mesh.from(h).index, mesh.to(h).index, mesh.from(mesh.prev(h)).index, i));
  }
  double sum = 0;
  for (const glm::dvec3& p : input.positions()) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Primitive& triangle : triangles)
      nearest = std::min(nearest, nearest_place(mesh.positions(), triangle, p).distance);
    sum += nearest * nearest;
  }
  return sum / static_cast<double>(input.positions().size());
}

TEST(simplifier, loses_less_with_more_effort_and_swaps_soundly) {
  const Mesh input = sheet(
      40, [](std::uint32_t x, std::uint32_t y) { return 3 * std::sin(0.31 * x) * std::cos(0.23 * y) + 0.02 * x * y; });
  Mesh quick = input, usual = input, careful = input;
  simplified(quick, "faces=200 effort=0");
  simplified(usual, "faces=200");
  Simplifier simplifier(careful, {}, {.faces = 200, .effort = 2});
  Progress unheard;
  simplifier.run(unheard);
  EXPECT_GT(simplifier.swaps(), 0u);
  EXPECT_FALSE(check_invariants(careful));
  const double q = mean_square_from(quick, input), u = mean_square_from(usual, input),
               c = mean_square_from(careful, input);
  EXPECT_LT(c, 0.97 * u) << q << " " << u << " " << c;
  EXPECT_LT(u, 1.2 * q);
  // As far as it goes it accounts for all edges all the same.
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const SeededMesh seeded = seeded_mesh(seed);
    go_all_the_way(make_mesh(seeded.faces, seeded.points), "seed " + std::to_string(seed), true, " effort=2");
  }
}

TEST(simplifier, has_levels_with_the_bytes_that_it_makes_itself) {
  const Mesh input = sheet(16, wave);
  const auto values = [&](std::string_view line) {
    return *read_values(find_algorithm("simplify")->parameters, split_words(line)).values->on(input).values;
  };
  Progress unheard;
  const BuiltLevels built = build_levels(input, values("faces=0 boundary=locked"), unheard);
  ASSERT_TRUE(built.levels);
  for (const std::size_t faces : {400u, 250u, 99u}) {
    Mesh mesh = input;
    simplified(mesh, "boundary=locked faces=" + std::to_string(faces));
    built.levels->go_to(built.levels->level_of(faces));
    EXPECT_EQ(built.levels->mesh().columns(), mesh.columns()) << faces;
  }
  EXPECT_TRUE(build_levels(Mesh(), values("faces=0"), unheard).refused);
}

TEST(simplifier, leaves_the_mesh_as_it_is_wherever_it_is_cancelled) {
  Mesh mesh = sheet(48, wave);
  const MeshColumns before = mesh.columns();
  Dice dice(5);
  int cancelled = 0;
  for (int i = 0; i < 24; ++i) {
    int left = dice.below(60);
    Progress cancelling([&](double) { return left-- > 0; }, Progress::Clock::duration::zero());
    Journal journal;
    Edit edit(mesh, &journal);
    const AlgorithmRow& row = *find_algorithm("simplify");
    const std::string line = i % 2 ? "faces=3 effort=2" : "error=0.2 no_self_intersections=on";
    const ParameterValues values = *read_values(row.parameters, split_words(line)).values->on(mesh).values;
    const AlgorithmResult result = row.run(edit, {values}, cancelling);
    if (result.account && result.account->stopped != Stop::cancelled) continue;
    ++cancelled;
    EXPECT_EQ(result.changed, 0u);
    EXPECT_EQ(mesh.columns(), before);
  }
  EXPECT_GT(cancelled, 4);
}

}  // namespace
}  // namespace ryosen::test
