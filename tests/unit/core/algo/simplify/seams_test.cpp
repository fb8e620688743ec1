// Seams of corner values in simplification: weighed, kept or dropped; normals of flat faces are none but where seams
// are kept.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "ryosen/algo/edge_rules.h"
#include "ryosen/algo/preparation.h"
#include "ryosen/algo/seams/flat_normals.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/triangle_corners.h"
#include "ryosen/ops/rules/corner_values.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/seamed_meshes.h"
#include "tests/support/core/simplified.h"
#include "tests/support/core/valued_sheet.h"

namespace ryosen::test {
namespace {

TEST(SimplifySeams, flat_normals_are_no_seams_and_stay_flat) {
  Mesh octahedron = report_mesh("flat_normals.obj");
  Journal journal;
  run_algorithm(octahedron, journal, "simplify faces=4");
  EXPECT_EQ(octahedron.live().faces, 4u);
  expect_flat_normals(octahedron);
}

TEST(SimplifySeams, flat_normals_change_no_result) {
  for (const char* const shape : {"sphere", "icosahedron", "torus", "cylinder"})
    for (const double rounding : {0.0, 0.01}) {
      SCOPED_TRACE(shape);
      Journal journal;
      Mesh plain = made_by(shape);
      run_algorithm(plain, journal, "simplify ratio=1 faces=100000 triangulate=on");
      Mesh flat = with_flat_normals(plain, rounding);
      plain = from_indexed(to_indexed(plain).mesh);
      run_algorithm(plain, journal, "simplify ratio=0.4");
      run_algorithm(flat, journal, "simplify ratio=0.4");
      EXPECT_EQ(to_indexed(flat).mesh.corners, to_indexed(plain).mesh.corners);
      expect_flat_normals(flat);
    }
}

TEST(SimplifySeams, kept_they_hold_under_their_rule) {
  for (const bool is_report : {true, false}) {
    Mesh mesh = is_report ? report_mesh("flat_normals.obj") : with_flat_normals(made_by("icosahedron"));
    const std::uint32_t faces = mesh.live().faces, edges = mesh.live().edges;
    Journal journal;
    const AlgorithmResult result = run_algorithm(mesh, journal, "simplify faces=4 seams=keep");
    EXPECT_EQ(mesh.live().faces, faces);
    ASSERT_TRUE(result.goal_report);
    EXPECT_EQ(result.goal_report->remaining[static_cast<std::size_t>(EdgeRule::seam)], edges);
  }
}

std::size_t remaining_seams(const AlgorithmResult& result) {
  return result.goal_report->remaining[static_cast<std::size_t>(EdgeRule::seam)];
}

TEST(SimplifySeams, kept_those_of_texture_stay_and_are_named) {
  const Mesh mesh = with_islands(made_by("icosahedron"));
  Journal journal;
  for (const char* const words : {"faces=8", "faces=8 effort=2"}) {
    Mesh made = mesh;
    const AlgorithmResult result = run_algorithm(made, journal, std::string("simplify seams=keep ") + words);
    EXPECT_EQ(made.live().faces, 20u) << words;
    EXPECT_EQ(remaining_seams(result), 30u) << words;
    EXPECT_EQ(result.text.en, "From 20 to 20 faces; no edge that is left can collapse (seam 30).");
  }
}

TEST(SimplifySeams, weighed_they_hold_nothing) {
  Journal journal;
  for (const char* const shape : {"icosahedron", "sphere", "torus"})
    for (const char* const words :
         {"ratio=0.4", "ratio=0.4 effort=0", "ratio=0.4 effort=2", "ratio=0.4 boundary=locked"}) {
      SCOPED_TRACE(std::string(shape) + " " + words);
      Mesh mesh = made_by(shape);
      run_algorithm(mesh, journal, "simplify ratio=1 faces=100000 triangulate=on");
      mesh = with_islands(from_indexed(to_indexed(mesh).mesh));
      const std::uint32_t before = mesh.live().faces;
      const AlgorithmResult result = run_algorithm(mesh, journal, std::string("simplify ") + words);
      EXPECT_LE(mesh.live().faces, before * 2 / 5);
      EXPECT_FALSE(check_invariants(mesh));
      EXPECT_TRUE(result.goal_report->is_reached);
      // A face keeps its island, however it is stretched.
      const CornerAttribute texture = corner_attributes(mesh).front();
      for (const Face f : live_faces(mesh)) {
        std::vector<double> islands;
        for (const Halfedge h : halfedges_around(mesh, f)) {
          const std::uint32_t value = mesh.attributes()[texture.index_column].data[h.index];
          ASSERT_NE(value, no_index);
          islands.push_back(
              std::floor(attribute_value<glm::dvec3>(mesh.attributes()[texture.pool_column], value).x + 1e-9));
        }
        EXPECT_TRUE(islands[0] == islands[1] && islands[1] == islands[2]);
      }
    }
}

TEST(SimplifySeams, dropped_they_take_texture_and_normals_along_but_not_colours) {
  Journal journal;
  Mesh mesh = valued_sheet(8, 0.5);
  const AlgorithmResult result = run_algorithm(mesh, journal, "simplify faces=20 seams=drop");
  EXPECT_TRUE(result.text.en.ends_with(" Texture was dropped.")) << result.text.en;
  EXPECT_LE(mesh.live().faces, 20u);
  EXPECT_TRUE(corner_attributes(mesh).empty());
  EXPECT_TRUE(find_column(mesh, attribute_names::colour));
  journal.undo(mesh);
  EXPECT_EQ(corner_attributes(mesh).size(), 1u);
}

// The cap of a drum is flat and its side is smooth: they meet in a seam, which stays.
TEST(SimplifySeams, flat_faces_beside_smooth_ones_stay_flat) {
  Mesh drum = made_by("cylinder");
  Journal journal;
  run_algorithm(drum, journal, "simplify ratio=1 faces=100000 triangulate=on");
  IndexedMesh source = to_indexed(drum).mesh;
  source.normals.components = 3;
  const auto is_on_cap = [&](std::size_t f) {
    const auto corners = source.face(f);
    const glm::dvec3 &a = source.positions[corners[0]], &b = source.positions[corners[1]],
                     &c = source.positions[corners[2]];
    return std::abs(glm::normalize(glm::cross(b - a, c - a)).y) > 0.9;
  };
  for (std::size_t f = 0; f < source.face_count(); ++f)
    for (const std::uint32_t corner : source.face(f)) {
      const glm::dvec3 p = source.positions[corner];
      source.normals.index.push_back(static_cast<std::uint32_t>(source.normals.pool.size()));
      source.normals.pool.push_back(is_on_cap(f) ? glm::dvec3(0, p.y > 0 ? 1 : -1, 0)
                                                 : glm::normalize(glm::dvec3(p.x, 0, p.z)));
    }
  Mesh mesh = from_indexed(std::move(source));
  run_algorithm(mesh, journal, "simplify ratio=0.5");
  EXPECT_LE(mesh.live().faces, drum.live().faces / 2);
  const CornerAttribute normals = corner_attributes(mesh).front();
  std::size_t caps = 0;
  for (const Face f : live_faces(mesh)) {
    const glm::dvec3 own = glm::normalize(area_normal(corners_of(mesh, mesh.halfedge(f))));
    for (const Halfedge h : halfedges_around(mesh, f)) {
      const auto value = attribute_value<glm::dvec3>(mesh.attributes()[normals.pool_column],
                                                     mesh.attributes()[normals.index_column].data[h.index]);
      if (std::abs(own.y) > 0.9) {
        ++caps;
        EXPECT_NEAR(glm::distance(value, own), 0, 1e-12);
      } else {
        EXPECT_NEAR(value.y, 0, 1e-9) << "no value of the cap comes along";
      }
    }
  }
  EXPECT_GT(caps, 0u);
}

TEST(SimplifySeams, normals_of_smooth_faces_are_no_flat_ones) {
  Mesh smooth = made_by("sphere");
  EXPECT_TRUE(take_flat_normals(smooth).empty()) << "there are none";
  IndexedMesh source = to_indexed(smooth).mesh;
  source.normals.components = 3;
  source.normals.index = source.corners;
  for (const glm::dvec3& p : source.positions) source.normals.pool.push_back(glm::normalize(p));
  Mesh mesh = from_indexed(std::move(source));
  EXPECT_TRUE(take_flat_normals(mesh).empty());
  EXPECT_EQ(corner_attributes(mesh).size(), 1u);
}

// A flat face within a smooth surface has the normals of its neighbours, which are no values of its own.
TEST(SimplifySeams, a_flat_face_of_a_smooth_surface_is_no_flat_one) {
  IndexedMesh source = to_indexed(valued_sheet(4)).mesh;
  source.normals.components = 3;
  source.normals.index = source.corners;
  for (std::size_t i = 0; i < source.positions.size(); ++i)
    source.normals.pool.push_back(i == 0 ? glm::normalize(glm::dvec3(1, 0, 1)) : glm::dvec3(0, 0, 1));
  Mesh mesh = from_indexed(std::move(source));
  Edit batch(mesh, nullptr);
  share_equal_values(batch);
  batch.commit();
  EXPECT_TRUE(take_flat_normals(mesh).empty());
}

// Texture of three numbers, as its place of islands: the number of the island times what the others add up to.
TEST(SimplifySeams, islands_with_a_common_value_do_not_mix) {
  for (const char* const words : {"faces=400", "faces=100", "faces=400 effort=0", "faces=100 effort=2"}) {
    IndexedMesh source = to_indexed(sheet(20, wave)).mesh;
    source.texcoords.components = 3;
    source.texcoords.pool.emplace_back(0, 0, 0);
    for (std::size_t f = 0; f < source.face_count(); ++f) {
      const double island = double(f + 1);
      const auto first = static_cast<std::uint32_t>(source.texcoords.pool.size());
      source.texcoords.pool.emplace_back(1, 0, island);
      source.texcoords.pool.emplace_back(0, 1, island);
      for (const std::uint32_t value : {0u, first, first + 1}) source.texcoords.index.push_back(value);
    }
    Mesh mesh = from_indexed(std::move(source));
    ASSERT_GT(simplified(mesh, words).changed, 0u);
    const CornerAttribute texture = corner_attributes(mesh).front();
    for (const Face f : live_faces(mesh)) {
      std::optional<double> island;
      for (const Halfedge h : halfedges_around(mesh, f)) {
        const auto value = attribute_value<glm::dvec3>(mesh.attributes()[texture.pool_column],
                                                       mesh.attributes()[texture.index_column].data[h.index]);
        if (value.x + value.y < 1e-9) continue;
        const double here = value.z / (value.x + value.y);
        EXPECT_NEAR(island.value_or(here), here, 1e-6) << words;
        island = here;
      }
    }
  }
}

// A seam that ends amid the sheet: beside its tip the values of both sides are one.
TEST(SimplifySeams, the_tip_of_a_seam_stays_and_values_with_it) {
  for (const char* const words :
       {"faces=600", "faces=300", "faces=100", "faces=300 effort=0", "faces=300 effort=2", "faces=300 seams=keep"}) {
    IndexedMesh source = to_indexed(sheet(20, [](auto, auto) { return 0.0; })).mesh;
    source.texcoords.components = 3;
    for (std::size_t f = 0; f < source.face_count(); ++f) {
      const auto corners = source.face(f);
      double right = 0;
      for (const std::uint32_t corner : corners) right = std::max(right, source.positions[corner].x);
      for (const std::uint32_t corner : corners) {
        const glm::dvec3 p = source.positions[corner];
        const bool is_torn = p.x == 10 && p.y < 10 && right > 10;
        source.texcoords.index.push_back(static_cast<std::uint32_t>(source.texcoords.pool.size()));
        source.texcoords.pool.emplace_back(p.x, p.y, is_torn ? 10 - p.y : 0);
      }
    }
    Mesh mesh = from_indexed(std::move(source));
    ASSERT_GT(simplified(mesh, words).changed, 0u);
    const CornerAttribute texture = corner_attributes(mesh).front();
    double length = 0;
    for (const Halfedge h : live_halfedges(mesh)) {
      if (mesh.is_outside(h)) continue;
      const glm::dvec3 p = mesh.position(mesh.from(h));
      const auto value = attribute_value<glm::dvec3>(mesh.attributes()[texture.pool_column],
                                                     mesh.attributes()[texture.index_column].data[h.index]);
      EXPECT_NEAR(glm::distance(glm::dvec2(value), glm::dvec2(p)), 0, 1e-9) << words;
      EXPECT_TRUE(value.z <= 0 || std::abs(p.x - 10) <= 1e-9) << words;
      if (h < twin(h) && is_seam(mesh, h)) length += glm::distance(p, mesh.position(mesh.to(h)));
    }
    EXPECT_NEAR(length, 10, 1e-9) << words;
  }
}

// Where a corner has no value, its face is in no chart.
TEST(SimplifySeams, corners_without_values_stay_so) {
  for (const char* const words : {"faces=30", "faces=10", "faces=30 seams=keep", "faces=30 effort=0"}) {
    Mesh mesh = valued_sheet(6);
    const CornerAttribute texture = corner_attributes(mesh).front();
    Edit batch(mesh, nullptr);
    for (std::uint32_t i = 0; i < mesh.face_slots(); i += 7)
      batch.set_attribute(texture.index_column, mesh.halfedge(Face(i)).index, std::span(&no_index, 1));
    batch.commit();
    ASSERT_GT(simplified(mesh, words).changed, 0u);
    EXPECT_FALSE(check_invariants(mesh));
    for (const Halfedge h : live_halfedges(mesh)) {
      const std::uint32_t value = mesh.attributes()[texture.index_column].data[h.index];
      if (mesh.is_outside(h) || value == no_index) continue;
      const auto given = attribute_value<glm::dvec3>(mesh.attributes()[texture.pool_column], value);
      EXPECT_LT(glm::distance(given, mesh.position(mesh.from(h))), 1.0 / 3) << "two edges are that long";
    }
  }
}

// Squares that bend, each with its own normal: the halves that they are cut into have normals of their own.
TEST(SimplifySeams, parts_of_flat_polygons_are_flat) {
  IndexedMesh source;
  constexpr std::uint32_t side = 12;
  for (std::uint32_t y = 0; y <= side; ++y)
    for (std::uint32_t x = 0; x <= side; ++x) source.positions.emplace_back(x, y, wave(x, y));
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t a = y * (side + 1) + x, b = a + 1, d = a + side + 1, c = d + 1;
      for (const std::uint32_t corner : {a, b, c, d}) source.corners.push_back(corner);
      source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
    }
  source.normals.components = 3;
  for (std::size_t f = 0; f < source.face_count(); ++f) {
    const auto corners = source.face(f);
    const auto at = [&](std::size_t i) { return source.positions[corners[i]]; };
    source.normals.pool.push_back(glm::normalize(glm::cross(at(2) - at(0), at(3) - at(1))));
    for (std::size_t i = 0; i < 4; ++i) source.normals.index.push_back(static_cast<std::uint32_t>(f));
  }
  Mesh mesh = from_indexed(std::move(source));
  Journal journal;
  run_algorithm(mesh, journal, "simplify ratio=0.5 triangulate=on");
  EXPECT_EQ(mesh.live().faces, side * side);
  expect_flat_normals(mesh);
}

TEST(SimplifySeams, flat_faces_that_stay_keep_their_normals) {
  Mesh mesh = with_flat_normals(made_by("torus"));
  Journal journal;
  run_algorithm(mesh, journal, "simplify ratio=1 faces=100000 triangulate=on");
  mesh = with_flat_normals(from_indexed(to_indexed(mesh).mesh), 0.001);
  const Mesh before = mesh;
  run_algorithm(mesh, journal, "simplify ratio=0.95 effort=0");
  const CornerAttribute normals = corner_attributes(mesh).front(), old = corner_attributes(before).front();
  std::size_t kept = 0;
  for (const Face f : live_faces(mesh)) {
    bool is_same = true;
    for (const Halfedge h : halfedges_around(mesh, f))
      is_same = is_same && before.face(h) == f && before.position(before.from(h)) == mesh.position(mesh.from(h)) &&
                before.next(h) == mesh.next(h);
    if (!is_same) continue;
    ++kept;
    for (const Halfedge h : halfedges_around(mesh, f))
      EXPECT_EQ(mesh.attributes()[normals.index_column].data[h.index],
                before.attributes()[old.index_column].data[h.index]);
  }
  EXPECT_GT(kept, mesh.live().faces / 2);
}

// The corners of the box are where three seams meet.
TEST(SimplifySeams, boxes_with_an_island_per_side_keep_their_corners) {
  for (const std::uint32_t n : {2u, 3u, 4u, 5u, 6u, 8u, 10u})
    for (const char* const words :
         {"faces=12", "faces=12 effort=0", "faces=12 effort=2", "faces=16", "faces=12 seams=keep"}) {
      const auto is_at = [](double x, double y) { return std::abs(x - y) < 1e-9; };
      Mesh mesh = island_box(n);
      ASSERT_EQ(compute_figures(mesh)[ProblemKind::boundary_loop], 0u);
      simplified(mesh, words);
      std::size_t corners = 0;
      for (const Vertex v : live_vertices(mesh)) {
        bool is_corner = true;
        for (int axis = 0; axis < 3; ++axis)
          is_corner = is_corner && (is_at(mesh.position(v)[axis], 0) || is_at(mesh.position(v)[axis], 1));
        corners += is_corner;
      }
      EXPECT_EQ(corners, 8u) << n << " " << words;
    }
}

TEST(SimplifySeams, dropped_values_are_a_change_where_nothing_collapses) {
  Mesh mesh = valued_sheet(4);
  Journal journal;
  EXPECT_EQ(run_algorithm(mesh, journal, "simplify ratio=1 seams=drop").changed, 1u);
  EXPECT_TRUE(corner_attributes(mesh).empty());
  EXPECT_EQ(run_algorithm(mesh, journal, "simplify ratio=1 seams=drop").changed, 0u) << "again";
}

TEST(SimplifySeams, what_seams_hold_is_named_beside_the_error) {
  Mesh mesh = with_islands(made_by("icosahedron"));
  Journal journal;
  const AlgorithmResult result = run_algorithm(mesh, journal, "simplify error=100 seams=keep");
  EXPECT_EQ(result.text.en, "From 20 to 20 faces; no edge that is left can collapse (seam 30).");
  EXPECT_EQ(result.text.ja, "面 20 個から 20 個へ（残りの稜線はどれも稜線削除できません：シーム 30）。");
}

}  // namespace
}  // namespace ryosen::test
