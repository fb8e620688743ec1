#include "ryosen/algo/repair/pair_faces.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/algo/repair/recipe.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/recipe_checks.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/solids.h"

namespace ryosen::test {
namespace {

// What `ryosen repair` does unless it is told what to do.
std::string default_repairs() {
  std::string kinds;
  for (const AlgorithmRow& row : algorithm_table())
    if (row.is_repair() && row.keeps_geometry) kinds += (kinds.empty() ? "" : ",") + std::string(row.id);
  return kinds;
}

// The figures after the default repairs, which have nothing to do then.
Figures repaired(const Mesh& mesh) {
  const RecipeResult result = *run_recipe(mesh, recipe_of(default_repairs()).steps, {});
  EXPECT_FALSE(run_recipe(result.mesh, recipe_of(default_repairs()).steps, {})->is_changed) << "again";
  const Figures figures = compute_figures(result.mesh);
  EXPECT_TRUE(figures.manifold);
  return figures;
}

// The mesh as it is, its faces from the last to the first, each from another corner, mirrored, turned and scaled, and
// written to every format and read again.
std::vector<IndexedMesh> variations(const IndexedMesh& mesh) {
  std::vector<IndexedMesh> all{mesh};
  IndexedMesh backwards;
  backwards.positions = mesh.positions;
  for (std::size_t f = mesh.face_count(); f-- > 0;) {
    std::vector<std::uint32_t> face(mesh.face(f).begin(), mesh.face(f).end());
    std::rotate(face.begin(), face.begin() + 1, face.end());
    backwards.corners.insert(backwards.corners.end(), face.begin(), face.end());
    backwards.face_offsets.push_back(static_cast<std::uint32_t>(backwards.corners.size()));
  }
  all.push_back(backwards);
  IndexedMesh mirrored = mesh;
  for (glm::dvec3& p : mirrored.positions) p.x = -p.x;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    std::reverse(mirrored.corners.begin() + mesh.face_offsets[f], mirrored.corners.begin() + mesh.face_offsets[f + 1]);
  all.push_back(mirrored);
  for (const double size : {1e-3, 1e6}) {
    IndexedMesh turned = mesh;
    for (glm::dvec3& p : turned.positions)
      p = size * glm::dvec3(0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y, p.z) + glm::dvec3(0.1, 7, -3);
    all.push_back(turned);
  }
  for (const char* const id : {"obj", "ply", "off", "stl"}) {
    MeshFile file;
    file.mesh = mesh;
    all.push_back(read_mesh(bytes_of(file, *find_format(id)), *find_format(id))->mesh);
  }
  return all;
}

TEST(pair_faces, two_tetrahedra_on_a_wall_become_two_closed_ones) {
  const IndexedMesh source = report_list("touching_tets.off");
  const FacePairing paired = pair_faces(from_indexed(source));
  EXPECT_EQ(std::count(paired.is_closed.begin(), paired.is_closed.end(), true), 8);
  EXPECT_EQ(std::count(paired.part.begin(), paired.part.end(), 0u), 4);
  for (const IndexedMesh& mesh : variations(source)) {
    const Figures figures = repaired(from_indexed(mesh));
    EXPECT_EQ(figures[ProblemKind::boundary_loop], 0u);
    EXPECT_EQ(figures.components, 2u);
    EXPECT_EQ(figures.faces, 8u);
    EXPECT_EQ(figures.vertices, 8u);
    EXPECT_TRUE(figures.closed);
  }
  EXPECT_NEAR(*repaired(from_indexed(source)).volume, 1.0 / 6 + 1.0 / 3, 1e-15);
}

TEST(pair_faces, fins_come_off_a_solid_that_stays_closed) {
  const IndexedMesh source = report_list("two_fins.off");
  const FacePairing paired = pair_faces(from_indexed(source));
  for (std::size_t f = 0; f < 6; ++f) {
    EXPECT_EQ(paired.is_closed[f], f < 4) << f;
    EXPECT_EQ(paired.is_free[f], f >= 4) << f;
  }
  for (const IndexedMesh& mesh : variations(source)) {
    const Figures figures = repaired(from_indexed(mesh));
    EXPECT_EQ(figures[ProblemKind::boundary_loop], 6u);
    EXPECT_EQ(figures.components, 3u);
    EXPECT_EQ(figures.faces, 6u);
  }
}

SolidBuilder block(const LatticePoint& size, bool triangles) {
  SolidBuilder built;
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z) built.add_cube({x, y, z}, triangles);
  return built;
}

TEST(pair_faces, cubes_that_share_faces_stay_closed_each) {
  for (const LatticePoint& size : {LatticePoint{2, 1, 1}, {1, 1, 3}, {2, 2, 1}, {2, 2, 2}, {3, 2, 2}})
    for (const bool triangles : {false, true})
      for (const IndexedMesh& mesh : variations(block(size, triangles).indexed())) {
        const auto cubes = static_cast<std::uint64_t>(size[0]) * static_cast<std::uint64_t>(size[1] * size[2]);
        const Figures figures = repaired(from_indexed(mesh));
        EXPECT_EQ(figures[ProblemKind::boundary_loop], 0u);
        EXPECT_EQ(figures.components, cubes);
        EXPECT_EQ(figures.vertices, 8 * cubes);
        EXPECT_TRUE(figures.closed);
      }
}

TEST(pair_faces, a_solid_that_comes_back_to_itself_in_a_face_keeps_the_wall) {
  // Eight cubes around the middle of a square, without the walls between them but for one: a bar bent to a ring.
  SolidBuilder ring;
  const std::vector<LatticePoint> cells{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},
                                        {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  for (const LatticePoint& cell : cells) ring.add_cube(cell);
  const auto key = [](std::vector<LatticePoint> face) {
    std::sort(face.begin(), face.end());
    return face;
  };
  const std::vector<LatticePoint> kept{
      {0, 1, 0}, {0, 1, 1}, {1, 1, 0}, {1, 1, 1}};  // between the first cube and the last
  SolidBuilder c;
  for (const auto& face : ring.faces()) {
    const auto walls = std::count_if(ring.faces().begin(), ring.faces().end(),
                                     [&](const auto& other) { return key(other) == key(face); });
    if (walls == 1 || key(face) == kept) c.add_face(face);
  }
  for (const IndexedMesh& mesh : variations(c.indexed())) {
    const Figures figures = repaired(from_indexed(mesh));
    EXPECT_TRUE(figures.closed && figures.manifold);
    EXPECT_EQ(figures.components, 1u);
    EXPECT_EQ(figures.genus, 0);
  }
}

TEST(pair_faces, a_bar_whose_middle_is_a_chequerboard_stays_closed) {
  // Two cubes touch along an edge between layers of four: pairs through the inside would give two points two edges.
  SolidBuilder bar;
  for (int z : {0, 2})
    for (int x : {0, 1})
      for (int y : {0, 1}) bar.add_cube({x, y, z});
  bar.add_cube({0, 0, 1});
  bar.add_cube({1, 1, 1});
  const auto key = [](std::vector<LatticePoint> face) {
    std::sort(face.begin(), face.end());
    return face;
  };
  SolidBuilder outside;
  for (const auto& face : bar.faces())
    if (std::count_if(bar.faces().begin(), bar.faces().end(),
                      [&](const auto& other) { return key(other) == key(face); }) == 1)
      outside.add_face(face);
  for (const IndexedMesh& mesh : variations(outside.indexed())) {
    const Figures figures = repaired(from_indexed(mesh));
    EXPECT_TRUE(figures.closed && figures.manifold);
    EXPECT_EQ(figures[ProblemKind::nonmanifold_edge], 0u);
  }
  EXPECT_NEAR(*repaired(from_indexed(outside.indexed())).volume, 10, 1e-12);
}

TEST(pair_faces, shells_nested_three_deep_beside_an_open_part_stay_as_they_are) {
  IndexedMesh source;
  const auto add = [&](const IndexedMesh& part, double size, bool turned) {
    const std::uint32_t first = static_cast<std::uint32_t>(source.positions.size());
    for (const glm::dvec3& p : part.positions) source.positions.push_back((p - 0.5) * size);
    for (std::size_t f = 0; f < part.face_count(); ++f) {
      std::vector<std::uint32_t> face(part.face(f).begin(), part.face(f).end());
      if (turned) std::reverse(face.begin(), face.end());
      for (const std::uint32_t corner : face) source.corners.push_back(first + corner);
      source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
    }
  };
  SolidBuilder cube;
  cube.add_cube({0, 0, 0});
  for (int depth = 0; depth < 3; ++depth) add(cube.indexed(), 8 >> depth, depth % 2 == 1);
  // A fin on an edge of the outermost shell.
  source.positions.push_back({9, 9, 9});
  for (const std::uint32_t corner : {6u, 7u, 24u}) source.corners.push_back(corner);
  source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
  for (const IndexedMesh& mesh : variations(source)) {
    const FacePairing paired = pair_faces(from_indexed(mesh));
    EXPECT_EQ(std::count(paired.is_free.begin(), paired.is_free.end(), true), 1);
    const Figures figures = repaired(from_indexed(mesh));
    EXPECT_EQ(figures.components, 4u);
    EXPECT_EQ(figures[ProblemKind::boundary_loop], 3u);
  }
}

TEST(pair_faces, of_two_solids_on_the_same_points_one_goes) {
  SolidBuilder built;
  for (int i = 0; i < 3; ++i) built.add_cube({0, 0, 0}, true);
  const Figures figures = repaired(from_indexed(built.indexed()));
  EXPECT_EQ(figures.faces, 12u);
  EXPECT_NEAR(*figures.volume, 1, 1e-15);
}

TEST(pair_faces, a_face_that_is_there_twice_goes_without_a_hole) {
  for (const bool turned : {false, true}) {
    SolidBuilder built;
    built.add_cube({0, 0, 0}, true);
    for (const std::size_t i : {0u, 5u, 6u}) {
      const std::size_t first = built.faces().size();
      built.add_face(std::vector<LatticePoint>(built.faces()[i]));
      if (turned) built.turn(first);
    }
    for (const IndexedMesh& mesh : variations(built.indexed())) {
      const Figures figures = repaired(from_indexed(mesh));
      EXPECT_EQ(figures.faces, 12u);
      EXPECT_TRUE(figures.closed);
    }
  }
}

TEST(pair_faces, nothing_is_done_to_nothing) {
  EXPECT_EQ(repaired(Mesh()).faces, 0u);
  EXPECT_FALSE(pair_faces(make_mesh(cube())).has_nonmanifold_edges);
}

}  // namespace
}  // namespace ryosen::test
