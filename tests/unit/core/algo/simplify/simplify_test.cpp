// Simplification: what it promises of every mesh, judged by the plain verdicts and warnings of the kernel's collapse.
#include "ryosen/algo/simplify/simplify.h"
#include "ryosen/algo/algorithm_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "ryosen/algo/simplify/plain_collapse.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/plain_check.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/simplified.h"

namespace ryosen::test {
namespace {

TEST(simplify, collapses_plain_edges_as_the_kernel_does) {
  Mesh plain = sheet(24, wave), kernel = plain;
  Edit plain_edit(plain, nullptr), kernel_edit(kernel, nullptr);
  Dice dice(3);
  std::size_t done = 0;
  for (int i = 0; i < 6000; ++i) {
    const Halfedge h(static_cast<std::uint32_t>(dice.below(static_cast<int>(plain.halfedge_slots()))));
    if (!plain.is_alive(h)) continue;
    const QuickAnswer answer = quick_collapse(plain, h);
    const bool is_legal = CollapseEdge{h}.judge(plain).legal();
    ASSERT_TRUE(answer == QuickAnswer::unknown || (answer == QuickAnswer::legal) == is_legal);
    if (answer != QuickAnswer::legal) continue;
    CollapseEdge{h}.apply(kernel_edit);
    plain_collapse(plain_edit, h, [](Edge, Edge) {});
    ++done;
    ASSERT_EQ(plain.hash(), kernel.hash());
    ASSERT_EQ(plain.columns().vertex_halfedge, kernel.columns().vertex_halfedge);
    ASSERT_EQ(plain.columns().face_halfedge, kernel.columns().face_halfedge);
  }
  EXPECT_GT(done, 500u);
  EXPECT_FALSE(check_invariants(plain));
}

TEST(simplify, goes_as_far_as_the_kernel_lets_it_on_any_mesh) {
  for (std::uint64_t seed = 1; seed <= 400 && !testing::Test::HasFailure(); ++seed) {
    const SeededMesh seeded = seeded_mesh(seed);
    go_all_the_way(make_mesh(seeded.faces, seeded.points), "seed " + std::to_string(seed));
  }
}

TEST(simplify, goes_as_far_on_named_shapes) {
  go_all_the_way(make_mesh({{0, 1, 2}}), "a single face");
  go_all_the_way(make_mesh(tetrahedron()), "tetrahedron");
  go_all_the_way(make_mesh(cube()), "cube");
  go_all_the_way(make_mesh(torus_grid(6, 8)), "torus");
  go_all_the_way(make_mesh(bow_tie()), "bow-tie");
  go_all_the_way(make_mesh(fin()), "fin");
  go_all_the_way(make_mesh(moebius_strip()), "strip");
  go_all_the_way(make_mesh(two_tetrahedra_on_an_edge()), "two tetrahedra");
  go_all_the_way(sheet(9, wave), "sheet");
  Mesh empty;
  EXPECT_TRUE(simplified(empty, "faces=0").refused);
}

TEST(simplify, of_a_flat_sheet_loses_nothing) {
  Mesh mesh = sheet(20, [](std::uint32_t, std::uint32_t) { return 3.0; });
  const AlgorithmResult result = simplified(mesh, "faces=2");
  EXPECT_EQ(mesh.live().faces, 2u);
  EXPECT_TRUE(result.goal_report->is_reached);
  EXPECT_LT(*result.goal_report->error_max, 1e-6);
  const Figures figures = compute_figures(mesh);
  EXPECT_NEAR(figures.area, 400, 1e-4) << "the corners are where they were";
}

TEST(simplify, reaches_a_number_a_ratio_or_an_error) {
  Mesh number = sheet(20, wave), ratio = number, error = number, relative = number, both = number;
  EXPECT_TRUE(simplified(number, "faces=300").goal_report->is_reached);
  EXPECT_EQ(number.live().faces / 2, 150u);
  EXPECT_TRUE(simplified(ratio, "ratio=0.25").goal_report->is_reached);
  EXPECT_LE(ratio.live().faces, 200u);
  EXPECT_GE(ratio.live().faces, 198u);
  const AlgorithmResult by_error = simplified(error, "error=0.05");
  EXPECT_EQ(by_error.goal_report->stopped, Stop::error);
  EXPECT_TRUE(by_error.goal_report->is_reached) << "it is the only goal";
  EXPECT_LE(*by_error.goal_report->error_max, 0.05);
  EXPECT_GT(count_of(by_error, EdgeRule::error), 0u);
  EXPECT_EQ(count_of(by_error, EdgeRule::free), 0u);
  EXPECT_LT(error.live().faces, 800u);
  const AlgorithmResult by_share = simplified(relative, "error=0.05 relative=on");
  EXPECT_GT(*by_share.goal_report->error_max, 0.05) << "a share of a diagonal of 28";
  EXPECT_LT(relative.live().faces, error.live().faces);
  const AlgorithmResult by_both = simplified(both, "faces=10 error=0.05");
  EXPECT_EQ(by_both.goal_report->stopped, Stop::error);
  EXPECT_FALSE(by_both.goal_report->is_reached);
  EXPECT_EQ(both.columns(), error.columns()) << "the error comes first";
}

TEST(simplify, keeps_what_is_locked_and_changes_what_is_selected_alone) {
  const auto boundary_of = [](const Mesh& mesh) {
    std::vector<std::pair<std::uint32_t, glm::dvec3>> all;
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
      if (const Vertex v(i); mesh.is_alive(v) && mesh.is_boundary(v)) all.emplace_back(i, mesh.position(v));
    return all;
  };
  const Mesh before = sheet(12, wave);
  Mesh locked = before, some = before, selected = before;
  const AlgorithmResult result = simplified(locked, "faces=0 boundary=locked");
  EXPECT_EQ(boundary_of(locked), boundary_of(before));
  EXPECT_GT(count_of(result, EdgeRule::boundary), 0u);
  EXPECT_LT(locked.live().faces, before.live().faces / 2);
  simplified(some, "faces=0 lock=v0,v84,f100");
  std::vector<Vertex> kept{Vertex(0), Vertex(84)};
  for (Vertex v : vertices_around(before, Face(100))) kept.push_back(v);
  for (Vertex v : kept) {
    ASSERT_TRUE(some.is_alive(v));
    EXPECT_EQ(some.position(v), before.position(v));
  }
  const AlgorithmResult alone = simplified(selected, "faces=0 select=f100,f101,f102,f103");
  EXPECT_GT(count_of(alone, EdgeRule::selection), 0u);
  std::set<std::uint32_t> meant;
  for (const std::uint32_t f : {100u, 101u, 102u, 103u})
    for (Vertex v : vertices_around(before, Face(f))) meant.insert(v.index);
  std::size_t gone = 0;
  for (std::uint32_t i = 0; i < before.vertex_slots(); ++i) {
    const Vertex v(i);
    if (selected.is_alive(v) && selected.position(v) == before.position(v)) continue;
    EXPECT_TRUE(meant.contains(i)) << i;
    ++gone;
  }
  EXPECT_GT(gone, 0u);
}

double smallest_angle_deg(const Mesh& mesh) {
  double smallest = 180;
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    const Halfedge h(i);
    if (!mesh.is_alive(h) || mesh.is_outside(h)) continue;
    const glm::dvec3 p = mesh.position(mesh.from(h)), a = mesh.position(mesh.to(h)) - p,
                     b = mesh.position(mesh.from(mesh.prev(h))) - p;
    const double cosine = glm::dot(a, b) / std::sqrt(glm::dot(a, a) * glm::dot(b, b));
    smallest = std::min(smallest, std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / 3.141592653589793);
  }
  return smallest;
}

TEST(simplify, keeps_angles_and_turns_within_their_limits) {
  const Mesh before = sheet(16, wave);
  ASSERT_GT(smallest_angle_deg(before), 20);
  Mesh narrow = before, turn = before, any = before;
  simplified(any, "faces=60");
  EXPECT_LT(smallest_angle_deg(any), 19);
  simplified(narrow, "faces=60 min_angle=20");
  EXPECT_GT(smallest_angle_deg(narrow), 20 - 1e-9);
  const AlgorithmResult by_turn = simplified(turn, "faces=0 boundary=locked max_turn=1");
  EXPECT_GT(count_of(by_turn, EdgeRule::normal), 0u);
  EXPECT_GT(turn.live().faces, any.live().faces);
}

TEST(simplify, does_the_same_to_a_mesh_that_is_huge_tiny_or_far_away) {
  const Mesh before = sheet(12, wave);
  Mesh plain = before;
  simplified(plain, "faces=60");
  for (const double factor : {0x1p900, 0x1p-900}) {
    MeshColumns columns = before.columns();
    for (glm::dvec3& p : columns.positions) p *= factor;
    Mesh mesh{columns};
    simplified(mesh, "faces=60");
    EXPECT_EQ(polygons_of(mesh), polygons_of(plain)) << factor;
  }
  MeshColumns columns = before.columns();
  for (glm::dvec3& p : columns.positions) p += glm::dvec3(1e9, -1e9, 1e9);
  Mesh away{columns};
  EXPECT_TRUE(simplified(away, "faces=60").goal_report->is_reached);
  EXPECT_FALSE(check_invariants(away));
}

TEST(simplify, leaves_what_is_not_finite_alone) {
  MeshColumns columns = sheet(8, wave).columns();
  columns.positions[40].x = std::numeric_limits<double>::infinity();
  columns.positions[10].y = std::numeric_limits<double>::quiet_NaN();
  Mesh mesh{columns};
  EXPECT_GT(simplified(mesh, "faces=0").changed, 0u);
  EXPECT_FALSE(check_invariants(mesh));
  EXPECT_TRUE(mesh.is_alive(Vertex(40)) && mesh.is_alive(Vertex(10)));
}

TEST(simplify, turns_polygons_into_fewer_or_triangulates_them_first) {
  Mesh squares = make_mesh(torus_grid(10, 12)), triangles = squares;
  const AlgorithmResult kept = simplified(squares, "faces=60");
  EXPECT_FALSE(check_invariants(squares));
  EXPECT_EQ(squares.live().faces <= 60, kept.goal_report->is_reached);
  const AlgorithmResult cut = simplified(triangles, "faces=60 triangulate=on");
  EXPECT_FALSE(check_invariants(triangles));
  EXPECT_TRUE(cut.goal_report->is_reached);
  for (std::uint32_t i = 0; i < triangles.face_slots(); ++i)
    EXPECT_TRUE(!triangles.is_alive(Face(i)) || is_triangle(triangles, triangles.halfedge(Face(i)))) << i;
}

// Two sheets close over each other, that do not touch but would if each was straightened in its own way.
TEST(simplify, keeps_faces_apart_where_it_is_asked_to) {
  Mesh plain = sheet(14, [](std::uint32_t x, std::uint32_t y) { return 2.0 * ((x / 2 + y / 3) % 2); });
  Mesh above = plain;
  {
    MeshColumns columns = above.columns();
    for (glm::dvec3& p : columns.positions) p.z += 0.05 + 0.1 * (static_cast<int>(5 * p.x + 3 * p.y) % 4);
    above = Mesh(columns);
  }
  IndexedMesh both;
  for (const Mesh* mesh : {&plain, &above}) {
    const auto first = static_cast<std::uint32_t>(both.positions.size());
    both.positions.insert(both.positions.end(), mesh->positions().begin(), mesh->positions().end());
    for (const auto& face : polygons_of(*mesh)) {
      for (const std::uint32_t corner : face) both.corners.push_back(first + corner);
      both.face_offsets.push_back(static_cast<std::uint32_t>(both.corners.size()));
    }
  }
  const Mesh before = from_indexed(both);
  ASSERT_EQ(find_self_intersections(before).count, 0u);
  Mesh free = before, kept = before;
  simplified(free, "faces=60");
  const AlgorithmResult result = simplified(kept, "faces=60 no_self_intersections=on");
  EXPECT_GT(find_self_intersections(free).count, 0u) << "or the test asks nothing";
  EXPECT_EQ(find_self_intersections(kept).count, 0u);
  EXPECT_LT(kept.live().faces, before.live().faces / 2);
  EXPECT_TRUE(result.goal_report->is_reached || count_of(result, EdgeRule::self_intersection) > 0);
  Mesh squares = made_by("cube");
  EXPECT_TRUE(simplified(squares, "faces=9 no_self_intersections=on").refused);
}

// Texture coordinates are the places, but from x = 8 on they lie 100 further: there is a seam along that column.
TEST(simplify, keeps_seams_and_carries_values_along) {
  constexpr std::uint32_t side = 16;
  const Mesh plain = sheet(side, wave);
  IndexedMesh source;
  source.positions.assign(plain.positions().begin(), plain.positions().end());
  source.texcoords.components = 2;
  for (const auto& face : polygons_of(plain)) {
    double right = 0;
    for (const std::uint32_t corner : face) right = std::max(right, plain.position(Vertex(corner)).x);
    for (const std::uint32_t corner : face) {
      const glm::dvec3 p = plain.position(Vertex(corner));
      source.corners.push_back(corner);
      source.texcoords.index.push_back(static_cast<std::uint32_t>(source.texcoords.pool.size()));
      source.texcoords.pool.emplace_back(p.x + (right > 8 ? 100 : 0), p.y, 0);
    }
    source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
  }
  Mesh mesh = from_indexed(source);
  const AlgorithmResult result = simplified(mesh, "faces=80");
  EXPECT_TRUE(result.goal_report->is_reached);
  EXPECT_FALSE(check_invariants(mesh));
  const CornerAttribute values = corner_attributes(mesh).front();
  const auto value = [&](Halfedge h) {
    return attribute_value<glm::dvec3>(mesh.attributes()[values.pool_column],
                                       mesh.attributes()[values.index_column].data[h.index]);
  };
  std::size_t seam_edges = 0;
  double seam_length = 0;
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    const Halfedge h(i);
    if (!mesh.is_alive(h) || mesh.is_outside(h)) continue;
    const glm::dvec3 p = mesh.position(mesh.from(h));
    // A chart does not mix with the other one, and its values stay near their places.
    const double across = value(h).x - p.x;
    EXPECT_TRUE(std::abs(across) < 2 || std::abs(across - 100) < 2) << across;
    EXPECT_LT(std::abs(value(h).y - p.y), 2);
    if (h > twin(h) || mesh.is_outside(twin(h)) || !is_seam(mesh, h)) continue;
    ++seam_edges;
    seam_length += std::abs(mesh.position(mesh.to(h)).y - p.y);
    EXPECT_LT(std::abs(p.x - 8), 0.5);
  }
  EXPECT_GT(seam_edges, 0u);
  EXPECT_LT(seam_edges, side) << "it loses vertices too";
  EXPECT_NEAR(seam_length, side, 0.05)
      << "and goes from end to end, whose points keep to the boundary but for its weight";
}

// A sheet with a crowd of tetrahedra above it, which cannot collapse.
TEST(simplify, removes_parts_smaller_than_the_error_where_it_is_asked_to) {
  const Mesh ground = sheet(6, wave);
  IndexedMesh source;
  source.positions.assign(ground.positions().begin(), ground.positions().end());
  const auto add = [&](const Polygons& faces, std::uint32_t first) {
    for (const auto& face : faces) {
      for (const std::uint32_t corner : face) source.corners.push_back(first + corner);
      source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
    }
  };
  add(polygons_of(ground), 0);
  for (int i = 0; i < 5; ++i) {
    const auto first = static_cast<std::uint32_t>(source.positions.size());
    const double size = i == 4 ? 2 : 0.01;
    for (const glm::dvec3& p : {glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
      source.positions.push_back(glm::dvec3(i, i, 9) + size * p);
    add({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, first);
  }
  const Mesh before = from_indexed(source);
  Mesh kept = before, removed = before, locked = before;
  EXPECT_FALSE(simplified(kept, "faces=6 error=0.1").goal_report->is_reached);
  EXPECT_EQ(compute_figures(kept).components, 6u);
  simplified(removed, "faces=6 error=0.1 remove_small=on");
  EXPECT_EQ(compute_figures(removed).components, 2u) << "the ground and the large one";
  EXPECT_FALSE(check_invariants(removed));
  simplified(locked, "faces=6 error=0.1 remove_small=on lock=v49");
  EXPECT_EQ(compute_figures(locked).components, 3u) << "one with a locked vertex stays";
}

TEST(simplify, refuses_values_with_a_sentence) {
  const AlgorithmRow& row = *find_algorithm("simplify");
  for (const char* line : {"", "faces=-1", "faces=1.5", "faces=nan", "faces=1e300", "ratio=2", "ratio=-1", "error=-1",
                           "error=nan", "ratio=0.5 max_turn=0", "ratio=0.5 max_turn=91", "ratio=0.5 min_angle=61",
                           "ratio=0.5 effort=3", "ratio=0.5 boundary=none"}) {
    const ReadValues read = read_values(row.parameters, split_words(line));
    EXPECT_FALSE(read.values) << line;
    EXPECT_FALSE(read.sentence.en.empty() || read.sentence.ja.empty()) << line;
  }
  Mesh mesh = sheet(3, wave);
  EXPECT_TRUE(simplified(mesh, "error=1e300").goal_report->is_reached == false)
      << "nothing is left that the error holds";
  EXPECT_EQ(simplified(mesh, "faces=1000000").changed, 0u);
}

}  // namespace
}  // namespace ryosen::test
