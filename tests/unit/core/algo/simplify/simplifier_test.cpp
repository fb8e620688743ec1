// Simplification in hard places: far smaller parts, exact planes, hubs, effort, levels and cancelling.
#include "ryosen/algo/simplify/simplifier.h"
#include "ryosen/algo/algorithm_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <random>

#include "ryosen/algo/simplify/simplify.h"
#include "ryosen/analysis/measure/distance.h"
#include "ryosen/geometry/trees/primitive.h"
#include "ryosen/io/formats.h"
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
  EXPECT_EQ(result.goal_report->stopped, Stop::error);
}

TEST(simplifier, takes_shares_as_they_are_meant) {
  Mesh hundred = make_mesh(torus_grid(5, 10)), twice = sheet(12, wave), once = twice;
  simplified(hundred, "ratio=0.58 triangulate=on");
  EXPECT_EQ(hundred.live().faces, 58u) << "of a hundred triangles that its squares are cut into";
  const AlgorithmResult a = simplified(twice, "error=0.01 relative=on"), b = simplified(once, "error=1%");
  EXPECT_EQ(*a.goal_report->error_max, *b.goal_report->error_max) << "a percentage is a share already";
}

// Two cones on one rough circle of n places.
Mesh rough_cones(std::uint32_t n) {
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
  return from_indexed(source);
}

// Of two cones on one circle, every edge of which something blocks again and again.
TEST(simplifier, asks_few_edges_of_a_hub_for_each_collapse) {
  const auto asked_per_collapse = [](std::uint32_t n) {
    Mesh mesh = rough_cones(n);
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

// A circle of n places as one face, or as a fan around a hub that lies so high.
Mesh circle(std::uint32_t n, std::optional<double> height) {
  IndexedMesh source;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    source.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    if (!height) source.corners.push_back(i);
    if (height)
      for (const std::uint32_t corner : {n, i, (i + 1) % n}) source.corners.push_back(corner);
    if (height || i + 1 == n) source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
  }
  if (height) source.positions.emplace_back(0.0, 0.0, *height);
  return from_indexed(source);
}

// The edges that were asked, and the corners looked at for them and for the account of all that are left.
double work(Mesh mesh, const CollapseLimits& limits, const SimplifyGoal& goal) {
  Simplifier simplifier(mesh, limits, goal);
  Progress unheard;
  simplifier.run(unheard);
  find_remaining(mesh, simplifier, unheard);
  return static_cast<double>(simplifier.asked()) + static_cast<double>(simplifier.looked_at());
}

TEST(simplifier, work_on_large_faces_and_hubs_grows_no_faster_than_n_log_n) {
  struct Limited {
    const char* name;
    CollapseLimits limits;
    double share;
  };
  const std::vector<Limited> all{{"a half", {}, 0.5},
                                 {"none", {}, 0},
                                 {"locked", {.boundary = BoundaryMode::locked}, 0},
                                 {"error", {.error = 0}, 0},
                                 {"turn", {.turn_rad = 0.1}, 0},
                                 {"angle", {.smallest_angle_rad = 0.1}, 0}};
  for (const std::optional<double> height : {std::optional<double>(), std::optional(0.0), std::optional(1.0)})
    for (const Limited& limited : all) {
      const auto work_on = [&](std::uint32_t n) {
        Mesh mesh = circle(n, height);
        return work(std::move(mesh), limited.limits, {.faces = static_cast<std::size_t>(limited.share * n)});
      };
      const std::string name = std::string(limited.name) + " at " + (height ? std::to_string(*height) : "one face");
      const double one = work_on(2000), two = work_on(4000), four = work_on(8000);
      EXPECT_LT(two, 3 * one) << name << ": " << one << " " << two << " " << four;
      EXPECT_LT(four, 5 * one) << name << ": " << one << " " << two << " " << four;
    }
}

// That no collapse is within the error is told of each edge, though places of a hub are asked for it.
TEST(simplifier, account_of_two_hubs_grows_no_faster_than_n_log_n) {
  const auto work_on = [](std::uint32_t n) { return work(rough_cones(n), {.error = 0}, {.faces = 0}); };
  const double one = work_on(1000), two = work_on(2000), four = work_on(4000);
  EXPECT_LT(two, 2.4 * one) << one << " " << two << " " << four;
  EXPECT_LT(four, 2.4 * two) << one << " " << two << " " << four;
}

// Where the input alternates from spoke to spoke, half of what is left looks against it, and no mending helps.
TEST(simplifier, mending_at_two_hubs_grows_no_faster_than_n_log_n) {
  const auto looks = [](std::uint32_t n) {
    const Mesh input = rough_cones(n);
    Mesh mesh = input;
    const CollapseLimits limits;
    Simplifier simplifier(mesh, limits, {.faces = n / 5}, nullptr, &input);
    Progress unheard;
    simplifier.run(unheard);
    EXPECT_GT(simplifier.turned(), 20u) << "else there was nothing to mend";
    return static_cast<double>(simplifier.looked_at());
  };
  const double one = looks(625), two = looks(1250), four = looks(2500);
  EXPECT_LT(two, 3 * one) << one << " " << two << " " << four;
  EXPECT_LT(four, 5 * one) << one << " " << two << " " << four;
}

TEST(simplifier, keeping_two_hubs_free_of_crossings_grows_no_faster_than_n_log_n) {
  const auto looks = [](std::uint32_t n) {
    Polygons faces;
    for (std::uint32_t i = 0; i < n; ++i)
      for (const std::uint32_t hub : {n, n + 1})
        faces.push_back({hub, hub == n ? i : (i + 1) % n, hub == n ? (i + 1) % n : i});
    IndexedMesh source = indexed(faces);
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 6.283185307179586 * i / n;
      source.positions[i] = {std::cos(angle), std::sin(angle), 0};
    }
    source.positions[n] = {0, 0, 1};
    source.positions[n + 1] = {0, 0, -1};
    Mesh mesh = from_indexed(source);
    const CollapseLimits limits;
    Simplifier simplifier(mesh, limits, {.faces = 100, .no_self_intersections = true});
    Progress unheard;
    simplifier.run(unheard);
    EXPECT_TRUE(simplifier.is_at_goal());
    return static_cast<double>(simplifier.looked_at());
  };
  const double one = looks(500), two = looks(1000), four = looks(2000);
  EXPECT_LT(two, 2.4 * one) << one << " " << two << " " << four;
  EXPECT_LT(four, 2.4 * two) << one << " " << two << " " << four;
}

// A hub that moves would mark and prove every face around it, again for each of its spokes.
TEST(simplifier, keeping_two_hubs_within_a_distance_grows_no_faster_than_n_log_n) {
  for (const double most : {0.0005, 0.01}) {
    const auto work_on = [&](std::uint32_t n) { return work(rough_cones(n), {}, {.most_distance = most}); };
    const double one = work_on(1000), two = work_on(2000), four = work_on(4000);
    EXPECT_LT(two, 2.4 * one) << one << " " << two << " " << four;
    EXPECT_LT(four, 2.4 * two) << one << " " << two << " " << four;
  }
}

TEST(simplifier, is_as_sound_at_hubs_and_large_faces_as_elsewhere) {
  for (const double height : {0.0, 0.5}) go_all_the_way(circle(200, height), "a fan");
  go_all_the_way(circle(300, std::nullopt), "one face");
  const auto squeeze = [](Mesh mesh) {
    Edit edit(mesh, nullptr);
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
      const glm::dvec3 p = mesh.position(Vertex(i));
      edit.set_position(Vertex(i), p * (1 + 0.3 * (i * 7 % 5)) + glm::dvec3(0, 0, 0.1 * (i * 3 % 7)));
    }
    return mesh;
  };
  go_all_the_way(squeeze(circle(200, 0.5)), "a rough fan");
  go_all_the_way(squeeze(circle(300, std::nullopt)), "a rough face");
  // Two hubs on one circle, and two large faces with squares between.
  Polygons cones, prism(2);
  for (std::uint32_t i = 0; i < 150; ++i) {
    const std::uint32_t k = (i + 1) % 150;
    cones.push_back({150, i, k});
    cones.push_back({151, k, i});
    prism[0].push_back(149 - i);
    prism[1].push_back(150 + i);
    prism.push_back({i, k, 150 + k, 150 + i});
  }
  const auto round = [](const Polygons& faces, bool is_prism) {
    IndexedMesh source = indexed(faces);
    source.positions.clear();
    for (std::uint32_t i = 0; i < (is_prism ? 300 : 150); ++i) {
      const double angle = 6.283185307179586 * (i % 150) / 150;
      source.positions.emplace_back(std::cos(angle), std::sin(angle), i / 150);
    }
    if (!is_prism) source.positions.insert(source.positions.end(), {{0, 0, 1}, {0, 0, -1}});
    return from_indexed(source);
  };
  go_all_the_way(round(cones, false), "two cones");
  go_all_the_way(squeeze(round(cones, false)), "two rough cones");
  go_all_the_way(round(prism, true), "a prism");
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
  Simplifier simplifier(careful, {}, {.faces = 200, .effort = 2}, nullptr, &input);
  Progress unheard;
  simplifier.run(unheard);
  EXPECT_GT(simplifier.swaps(), 0u);
  EXPECT_FALSE(check_invariants(careful));
  const double q = mean_square_from(quick, input), u = mean_square_from(usual, input),
               c = mean_square_from(careful, input);
  EXPECT_LT(c, 0.97 * u) << q << " " << u << " " << c;
  EXPECT_LT(u, 0.9 * q);
  // As far as it goes it accounts for all edges all the same.
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SeededMesh seeded = seeded_mesh(seed);
    go_all_the_way(make_mesh(seeded.faces, seeded.points), "seed " + std::to_string(seed), true, " effort=2");
  }
}

// Where the input lies exactly on few planes a swap may bring the surface nearer to its points and yet span an edge.
TEST(simplifier, swaps_leave_no_face_across_a_sharp_edge) {
  const std::filesystem::path path = RYOSEN_SHARED_DIR "/meshes/cgal/data/meshes/fandisk.off";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "There is no " << path;
  const Mesh input = from_indexed(read_mesh_file(path)->mesh);
  const auto rms = [&](const char* effort) {
    Mesh mesh = input;
    simplified(mesh, std::string("ratio=0.5 effort=") + effort);
    Progress unheard;
    return surface_distance(input, mesh, {.gap = 1, .samples = 20000}, unheard)->rms;
  };
  EXPECT_LT(rms("2"), rms("1"));
}

// A sheet whose points are strewn about, so that it is folded here and there.
Mesh crumpled(std::uint32_t side) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-0.6, 0.6);
  Mesh mesh = sheet(side, wave);
  Edit edit(mesh, nullptr);
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    edit.set_position(Vertex(i), mesh.position(Vertex(i)) + glm::dvec3(unit(random), unit(random), unit(random)));
  edit.commit();
  return mesh;
}

std::size_t count_turned(const Mesh& input, const Mesh& mesh) {
  const InputSides sides(input, std::vector<std::uint8_t>(input.vertex_slots(), 1));
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    if (!mesh.is_alive(Face(i))) continue;
    const Halfedge h = mesh.halfedge(Face(i));
    count += sides.is_turned(
        {mesh.position(mesh.from(h)), mesh.position(mesh.to(h)), mesh.position(mesh.from(mesh.prev(h)))});
  }
  return count;
}

TEST(simplifier, mends_faces_that_look_against_the_input_where_it_is_folded) {
  const Mesh input = crumpled(60);
  Progress unheard;
  std::vector<std::size_t> turned;
  for (const Mesh* compared : {static_cast<const Mesh*>(nullptr), &input}) {
    Mesh work = input;
    const CollapseLimits limits;
    Simplifier simplifier(work, limits, {.faces = input.live().faces / 3}, nullptr, compared);
    EXPECT_TRUE(simplifier.run(unheard));
    EXPECT_TRUE(simplifier.is_at_goal());
    EXPECT_LE(simplifier.still_turned(), simplifier.turned());
    turned.push_back(count_turned(input, work));
    const auto broken = check_invariants(work);
    ASSERT_FALSE(broken) << broken->sentence;
    const Figures was = compute_figures(input), is = compute_figures(work);
    EXPECT_EQ(is.euler_characteristic, was.euler_characteristic);
    EXPECT_EQ(is[ProblemKind::nonmanifold_edge], 0u);
    EXPECT_EQ(simplifier.turned() > 0, compared != nullptr);
  }
  EXPECT_GT(turned[0], 20u) << "else there was nothing to mend";
  EXPECT_LT(2 * turned[1], turned[0]);
}

TEST(simplifier, has_levels_with_the_bytes_that_it_makes_itself) {
  const Mesh input = sheet(16, wave);
  const auto values = [&](std::string_view line) {
    return *read_values(find_algorithm("simplify")->parameters, split_words(line)).values->on(input).values;
  };
  Progress unheard;
  const BuiltLevels built = build_levels(input, {values("faces=0 boundary=locked")}, unheard);
  ASSERT_TRUE(built.levels);
  for (const std::size_t faces : {400u, 250u, 99u}) {
    Mesh mesh = input;
    simplified(mesh, "boundary=locked effort=0 faces=" + std::to_string(faces));
    built.levels->go_to(built.levels->level_of(faces));
    EXPECT_EQ(built.levels->mesh().columns(), mesh.columns()) << faces;
  }
  EXPECT_TRUE(build_levels(Mesh(), {values("faces=0")}, unheard).refused);
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
    if (result.goal_report && result.goal_report->stopped != Stop::cancelled) continue;
    ++cancelled;
    EXPECT_EQ(result.changed, 0u);
    EXPECT_EQ(mesh.columns(), before);
  }
  EXPECT_GT(cancelled, 4);
}

}  // namespace
}  // namespace ryosen::test
