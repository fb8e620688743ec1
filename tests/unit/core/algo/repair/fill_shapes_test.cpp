// Patches of fill_holes: flat or fair, even, and alike where rims are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/algo/repair/fill_holes.h"
#include "ryosen/algo/repair/fill_report.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/geometry/single_precision.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/open_shapes.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

using Values = std::vector<std::pair<std::string_view, std::string_view>>;

AlgorithmResult filled_by(Mesh& mesh, const Values& values = {}) {
  const AlgorithmRow& row = *find_algorithm("fill_holes");
  AlgorithmInput input{ParameterValues(row.parameters), {}, 0};
  for (const auto& [id, text] : values) EXPECT_FALSE(input.values.set(id, text, id));
  Edit edit(mesh, nullptr);
  Progress unheard;
  const AlgorithmResult result = row.run(edit, input, unheard);
  edit.commit();
  return result;
}

bool is_told(const AlgorithmResult& result, std::string_view en) {
  return result.text.en.find(en) != std::string::npos;
}

// The triangles that filling has added.
std::vector<Face> added(const Mesh& mesh, std::size_t faces_before) {
  std::vector<Face> faces;
  for (auto i = static_cast<std::uint32_t>(faces_before); i < mesh.face_slots(); ++i) faces.emplace_back(i);
  return faces;
}

// The share of their angles that are below 30 degrees.
double share_of_small_angles(const Mesh& mesh, const std::vector<Face>& faces) {
  std::size_t small = 0;
  for (const Face f : faces)
    for (const Halfedge h : halfedges_around(mesh, f)) {
      const glm::dvec3& at = mesh.position(mesh.from(h));
      const glm::dvec3 u = mesh.position(mesh.to(h)) - at, v = mesh.position(mesh.from(mesh.prev(h))) - at;
      small += std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)) < M_PI / 6;
    }
  return static_cast<double>(small) / static_cast<double>(3 * faces.size());
}

struct RimCase {
  std::uint32_t corners;
  double radius;
  bool is_turned, is_single;
};

// The height of each new vertex over the plane z = 1 of the rim before it was turned, in units in the last place.
void expect_flat_lid(const RimCase& rim) {
  SCOPED_TRACE(std::to_string(rim.corners) + " corners, radius " + std::to_string(rim.radius) +
               (rim.is_turned ? ", turned" : "") + (rim.is_single ? ", single" : ""));
  IndexedMesh list = cup(rim.corners, rim.radius, 1);
  IndexedMesh up;
  up.positions = {{0, 0, 1}};
  if (rim.is_turned) list = turned(std::move(list));
  if (rim.is_turned) up = turned(std::move(up));
  if (rim.is_single) list = as_floats(std::move(list));
  Mesh mesh = from_indexed(list);
  const AlgorithmResult result = filled_by(mesh);
  EXPECT_EQ(result.changed, 1u);
  EXPECT_TRUE(is_told(result, ": flat (shape=fair continues the surface)")) << result.text.en;
  double largest = 0;
  for (const glm::dvec3& p : list.positions) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const double unit = std::ldexp(rim.is_single ? 0x1p-23 : 0x1p-52, std::ilogb(largest));
  for (auto i = static_cast<std::uint32_t>(list.positions.size()); i < mesh.vertex_slots(); ++i) {
    const glm::dvec3& p = mesh.position(Vertex(i));
    EXPECT_LE(std::abs(glm::dot(up.positions[0], p) - 1), 4 * unit) << i;
    if (!rim.is_turned) {
      EXPECT_EQ(p.z, 1.0) << "to the bit";
    }
    if (rim.is_single) {
      EXPECT_EQ(p, to_single(p));
    }
  }
  const Figures figures = compute_figures(mesh);
  EXPECT_TRUE(figures.closed && figures.manifold);
  EXPECT_EQ(figures[ProblemKind::degenerate_area], 0u);
  EXPECT_TRUE(find_self_intersections(mesh).pairs.empty());
  const double base = rim.corners * std::sin(2 * M_PI / rim.corners) / 2, r = rim.radius;
  EXPECT_NEAR(std::abs(figures.volume.value_or(0)), base * (1 + r + r * r) / 3, 1e-6);
}

TEST(fill_shapes, cups_are_closed_flat) {
  for (std::uint32_t corners = 5; corners <= 48; ++corners)
    for (const double radius : {0.6, 1.0, 1.7})
      for (const bool is_turned : {false, true})
        for (const bool is_single : {false, true}) expect_flat_lid({corners, radius, is_turned, is_single});
}

TEST(fill_shapes, the_cup_of_the_report_gets_a_flat_lid) {
  Mesh mesh = from_indexed(report_list("planar_hole.off"));
  EXPECT_EQ(filled_by(mesh).changed, 1u);
  EXPECT_NEAR(compute_figures(mesh).volume.value_or(0), 2.3776, 1e-4);
  for (std::uint32_t i = 10; i < mesh.vertex_slots(); ++i) EXPECT_EQ(mesh.position(Vertex(i)).z, 1.0);
}

// A box of 10 whose open top has so many corners on each of its sides; the walls are triangles.
IndexedMesh box_with_a_fine_rim(std::uint32_t parts) {
  IndexedMesh list;
  const glm::dvec3 corners[] = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  for (const glm::dvec3& p : corners) list.positions.push_back(p);
  for (std::uint32_t side = 0; side < 4; ++side)
    for (std::uint32_t i = 0; i < parts; ++i)
      list.positions.push_back(corners[side] + (corners[(side + 1) % 4] - corners[side]) * (i / double(parts)) +
                               glm::dvec3(0, 0, 10));
  const auto add = [&](std::initializer_list<std::uint32_t> face) {
    list.corners.insert(list.corners.end(), face);
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  };
  add({3, 2, 1, 0});
  for (std::uint32_t side = 0; side < 4; ++side) {
    const std::uint32_t next = (side + 1) % 4, first = 4 + side * parts, last = 4 + next * parts;
    add({side, next, last});
    for (std::uint32_t i = 0; i < parts; ++i) add({side, i + 1 == parts ? last : first + i + 1, first + i});
  }
  return list;
}

TEST(fill_shapes, a_box_keeps_its_volume_however_fine_its_rim_is) {
  for (const std::uint32_t parts : {1u, 2u, 3u, 7u, 20u, 90u}) {
    SCOPED_TRACE(parts);
    for (const bool is_turned : {false, true}) {
      const IndexedMesh list = box_with_a_fine_rim(parts);
      Mesh mesh = from_indexed(is_turned ? as_floats(turned(list)) : list);
      const AlgorithmResult result = filled_by(mesh);
      EXPECT_EQ(result.changed, 1u) << result.text.en;
      const Figures figures = compute_figures(mesh);
      EXPECT_TRUE(figures.closed);
      EXPECT_NEAR(std::abs(figures.volume.value_or(0)), 1000, is_turned ? 1e-3 : 1e-9);
      EXPECT_EQ(figures[ProblemKind::degenerate_area], 0u);
    }
  }
}

TEST(fill_shapes, the_shape_that_is_asked_for_is_made) {
  const IndexedMesh sphere = sphere_with_hole(12, 3),
                    bent = sphere_with_hole(12, 3, [](std::uint32_t k) { return 0.4 * std::sin(M_PI * k / 6); });
  const auto told_on = [](const IndexedMesh& list, std::string_view shape) {
    Mesh mesh = from_indexed(list);
    return filled_by(mesh, {{"shape", shape}}).text.en;
  };
  for (const auto& [list, shape, told] :
       {std::tuple(&sphere, "auto", ": flat (shape=fair continues the surface)."),
        std::tuple(&sphere, "flat", ": flat (shape=fair continues the surface)."),
        std::tuple(&sphere, "fair", ": fair."), std::tuple(&bent, "auto", ": fair."),
        std::tuple(&bent, "flat", ": flat (shape=fair continues the surface)."), std::tuple(&bent, "fair", ": fair.")})
    EXPECT_TRUE(told_on(*list, shape).ends_with(told)) << shape << " " << told_on(*list, shape);
  IndexedMesh both = sphere;
  for (const glm::dvec3& p : bent.positions) both.positions.push_back(p + glm::dvec3(3, 0, 0));
  for (const std::uint32_t corner : bent.corners)
    both.corners.push_back(corner + static_cast<std::uint32_t>(sphere.positions.size()));
  for (std::size_t i = 1; i < bent.face_offsets.size(); ++i)
    both.face_offsets.push_back(bent.face_offsets[i] + static_cast<std::uint32_t>(sphere.corners.size()));
  EXPECT_TRUE(told_on(both, "auto").ends_with(": 1 flat, 1 fair (shape=fair continues the surface)."));
}

struct CapCase {
  std::uint32_t n, missing;
  double lowest;  // radius of the patch
};

TEST(fill_shapes, a_fair_patch_continues_a_sphere) {
  for (const CapCase& cap : {CapCase{12, 2, 0.97}, {24, 4, 0.98}, {24, 6, 0.95}, {40, 10, 0.95}, {60, 12, 0.96}})
    for (const bool is_turned : {false, true})
      for (const bool is_single : {false, true}) {
        SCOPED_TRACE(std::to_string(cap.n) + " rows, missing " + std::to_string(cap.missing));
        IndexedMesh list = sphere_with_hole(cap.n, cap.missing);
        if (is_turned) list = turned(std::move(list));
        if (is_single) list = as_floats(std::move(list));
        Mesh mesh = from_indexed(list);
        const std::size_t faces = mesh.face_slots();
        EXPECT_EQ(filled_by(mesh, {{"shape", "fair"}}).changed, 1u);
        const Figures figures = compute_figures(mesh);
        EXPECT_TRUE(figures.closed && figures.manifold);
        EXPECT_EQ(figures[ProblemKind::degenerate_area], 0u);
        EXPECT_TRUE(find_self_intersections(mesh).pairs.empty());
        for (auto i = static_cast<std::uint32_t>(list.positions.size()); i < mesh.vertex_slots(); ++i) {
          EXPECT_GT(glm::length(mesh.position(Vertex(i))), cap.lowest) << i;
          EXPECT_LT(glm::length(mesh.position(Vertex(i))), 1.01) << i;
        }
        EXPECT_LT(share_of_small_angles(mesh, added(mesh, faces)), 0.04);
      }
}

TEST(fill_shapes, a_rim_of_hundreds_of_edges_gets_an_even_patch) {
  const std::vector<std::uint32_t> few{140, 160}, many{140, 145, 150, 160};  // some are weighed, some are projected
  for (const std::uint32_t n : is_long_run() ? many : few)
    for (const double height : {0.0, 0.3}) {
      if (!is_long_run() && (n == few[0]) != (height > 0)) continue;
      SCOPED_TRACE(2 * n);
      Mesh mesh = from_indexed(
          sphere_with_hole(n, n / 4, [&](std::uint32_t k) { return height * std::sin(2 * M_PI * k / n); }));
      const std::size_t faces = mesh.face_slots();
      const AlgorithmResult result = filled_by(mesh, {{"shape", "fair"}});
      EXPECT_TRUE(result.text.en.ends_with(": fair.")) << result.text.en;
      EXPECT_LT(share_of_small_angles(mesh, added(mesh, faces)), 0.06);
      EXPECT_TRUE(find_self_intersections(mesh).pairs.empty());
    }
}

TEST(fill_shapes, a_patch_that_could_not_be_fair_is_told) {
  // A cup whose rim goes up and down, under a triangle through which a fair patch would rise.
  IndexedMesh list = cup(24, 1, 1);
  for (std::uint32_t i = 24; i < 48; ++i) list.positions[i].z += i % 2 == 0 ? 0.02 : -0.02;
  for (const glm::dvec3& p : {glm::dvec3(-9, -9, 1.15), glm::dvec3(9, -9, 1.15), glm::dvec3(0, 9, 1.15)})
    list.positions.push_back(p);
  for (const std::uint32_t corner : {48u, 49u, 50u}) list.corners.push_back(corner);
  list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  Mesh mesh = from_indexed(list);
  const AlgorithmResult result = filled_by(mesh);
  EXPECT_EQ(result.changed, 1u);
  EXPECT_TRUE(is_told(result, ": not fair since no fair patch is sound;")) << result.text.en;
  EXPECT_TRUE(find_self_intersections(mesh).pairs.empty());
}

TEST(fill_shapes, every_kind_of_patch_is_counted) {
  const FilledHoles filled{.flat = 1, .fair = 2, .unfaired = 3, .bare = 4, .crossing = 5, .faces = 60, .vertices = 7};
  const Text text = fill_report(Mesh(), filled, {}).text;
  EXPECT_EQ(
      text.en,
      "10 holes were filled by 60 triangles and 7 new vertices: 1 flat, 2 fair, 3 not fair since no fair patch is "
      "sound, 4 bare since no finer patch is sound (shape=fair continues the surface); 5 patches cross something.");
  EXPECT_EQ(text.ja,
            "穴を 10 個ふさぎました（三角形 60、新しい頂点 7）：1 平ら、2 滑らか、3 滑らかにすると不健全、4 "
            "細かくすると不健全（shape=fair で曲面を滑らかに続けます）。5 個は何かと交わります。");
}

// By patch how many triangles it has.
std::vector<std::size_t> sizes_of_patches(const Mesh& mesh, std::size_t faces_before) {
  std::vector<std::size_t> sizes;
  std::vector<bool> seen(mesh.face_slots(), false);
  for (const Face start : added(mesh, faces_before)) {
    if (seen[start.index]) continue;
    std::vector<Face> open{start};
    seen[start.index] = true;
    std::size_t size = 0;
    for (; !open.empty(); ++size) {
      const Face f = open.back();
      open.pop_back();
      for (const Halfedge h : halfedges_around(mesh, f)) {
        const Face g = mesh.face(twin(h));
        if (g.index < faces_before || seen[g.index]) continue;
        seen[g.index] = true;
        open.push_back(g);
      }
    }
    sizes.push_back(size);
  }
  return sizes;
}

TEST(fill_shapes, both_ends_of_a_tube_get_as_many_triangles) {
  for (const std::uint32_t corners : {3u, 4u, 5u, 6u, 12u, 13u, 24u, 48u, 97u, 310u})
    for (const bool is_turned : {false, true})
      for (const bool is_single : {false, true})
        for (const std::string_view shape : {"auto", "fair"}) {
          if (shape == "fair" && corners > 60) continue;
          SCOPED_TRACE(std::to_string(corners) + " " + std::string(shape));
          IndexedMesh list = tube(corners, 1, 3);
          for (std::uint32_t i = 0; i < corners; ++i)
            if (corners % 2 == 1)  // without symmetry
              for (glm::dvec3* p : {&list.positions[i], &list.positions[i + corners]})
                *p = {p->x * (1 + 0.2 * std::sin(1.3 * i * i)), p->y * (1 + 0.2 * std::sin(1.3 * i * i)), p->z};
          if (is_turned) list = turned(std::move(list));
          if (is_single) list = as_floats(std::move(list));
          Mesh mesh = from_indexed(list);
          const std::size_t faces = mesh.face_slots();
          EXPECT_EQ(filled_by(mesh, {{"shape", shape}}).changed, 2u);
          const std::vector<std::size_t> sizes = sizes_of_patches(mesh, faces);
          ASSERT_EQ(sizes.size(), 2u);
          EXPECT_EQ(sizes[0], sizes[1]);
        }
}

// A wheel with a hollow on both sides, each with a hole in its middle; the holes are `height` apart.
IndexedMesh wheel(double height) {
  IndexedMesh list = tube(16, 1, 0);
  list.positions.clear();
  const double high = height / 2;
  for (const auto& [radius, z] : {std::pair(1.0, -high), {1.6, -high - 0.5}, {1.6, high + 0.5}, {1.0, high}})
    for (std::uint32_t i = 0; i < 16; ++i)
      list.positions.push_back({radius * std::cos(M_PI * i / 8), radius * std::sin(M_PI * i / 8), z});
  const std::vector<std::uint32_t> corners = list.corners;
  for (const std::uint32_t ring : {16u, 32u})
    for (const std::uint32_t corner : corners) list.corners.push_back(corner + ring);
  for (std::uint32_t f = 17; f <= 48; ++f) list.face_offsets.push_back(4 * f);
  return list;
}

TEST(fill_shapes, equal_rims_whose_fair_patches_would_meet_both_get_others) {
  for (const double height : {0.02, 0.1, 0.3}) {
    Mesh mesh = from_indexed(wheel(height));
    const std::size_t faces = mesh.face_slots();
    const AlgorithmResult result = filled_by(mesh, {{"shape", "fair"}});
    EXPECT_TRUE(is_told(result, ": not fair since no fair patch is sound.")) << result.text.en;
    const std::vector<std::size_t> sizes = sizes_of_patches(mesh, faces);
    ASSERT_EQ(sizes.size(), 2u);
    EXPECT_EQ(sizes[0], sizes[1]);
    EXPECT_TRUE(find_self_intersections(mesh).pairs.empty());
  }
  Mesh mesh = from_indexed(wheel(4));
  EXPECT_TRUE(is_told(filled_by(mesh, {{"shape", "fair"}}), ": fair.")) << "far enough apart";
}

}  // namespace
}  // namespace ryosen::test
