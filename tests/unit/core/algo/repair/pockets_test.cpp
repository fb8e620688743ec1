// Two faces back to back that are a closed part: welding closes them, and no repair counts them as its own doing.
#include "ryosen/algo/repair/pockets.h"

#include <gtest/gtest.h>

#include "ryosen/algo/repair/recipe.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/indexed/from_indexed.h"
#include "tests/support/core/recipe_checks.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/solids.h"

namespace ryosen::test {
namespace {

const std::string usual_repairs = "give_places,remove_duplicates,weld_equal,orient,detach_nonmanifold";

constexpr LatticePoint a{0, 0, 0}, b{2, 0, 0}, c{2, 2, 0}, d{0, 2, 0}, top{1, 1, 2};

SolidBuilder built_of(const std::vector<std::vector<LatticePoint>>& faces) {
  SolidBuilder built;
  for (const auto& face : faces) built.add_face(face);
  return built;
}

struct PocketCase {
  const char* name;
  SolidBuilder built;
  std::size_t pockets, components;
};

std::vector<PocketCase> cases() {
  std::vector<PocketCase> all;
  all.push_back({"a triangle back to back", built_of({{a, b, c}, {c, b, a}}), 1, 1});
  all.push_back({"a square back to back", built_of({{a, b, c, d}, {d, c, b, a}}), 1, 1});
  all.push_back(
      {"two triangles back to back at a diagonal", built_of({{a, b, c}, {c, b, a}, {a, c, d}, {d, c, a}}), 2, 2});
  SolidBuilder with_fin;
  with_fin.add_tetrahedron({a, b, c, top});
  with_fin.add_face({a, c, d});
  with_fin.add_face({d, c, a});
  all.push_back({"a fin back to back on a tetrahedron", with_fin, 1, 2});
  all.push_back({"a solid of 40 triangles with a pocket at an edge", random_union(646), 1, 6});
  return all;
}

TEST(pockets, close_where_points_are_shared_and_where_each_face_has_its_own) {
  for (const PocketCase& one : cases())
    for (const IndexedMesh& source : {one.built.indexed(), one.built.loose()}) {
      SCOPED_TRACE(std::string(one.name) + ", points " + std::to_string(source.positions.size()));
      const RecipeResult result = *run_recipe(from_indexed(source), recipe_of(usual_repairs).steps, {});
      const Figures figures = compute_figures(result.mesh);
      EXPECT_EQ(figures.faces, one.built.faces().size());
      EXPECT_EQ(figures[ProblemKind::boundary_loop], 0u);
      EXPECT_EQ(figures.components, one.components);
      EXPECT_TRUE(figures.manifold);
      EXPECT_EQ(pockets_of(result.mesh).size(), one.pockets);
      EXPECT_FALSE(run_recipe(result.mesh, recipe_of(usual_repairs).steps, {})->is_changed) << "again";
    }
}

TEST(pockets, are_pairs_of_faces_joined_at_all_their_sides) {
  EXPECT_TRUE(pockets_of(from_indexed(built_of({{a, b, c}, {a, c, d}}).indexed())).empty()) << "at one side";
  EXPECT_TRUE(pockets_of(from_indexed(built_of({{a, b, c}, {c, b, a}}).loose())).empty()) << "at none";
  SolidBuilder tetrahedron;
  tetrahedron.add_tetrahedron({a, b, c, top});
  EXPECT_TRUE(pockets_of(from_indexed(tetrahedron.indexed())).empty());
  const auto found = pockets_of(from_indexed(built_of({{a, b, c}, {c, b, a}}).indexed()));
  EXPECT_EQ(found, (std::vector<std::pair<Face, Face>>{{Face(0), Face(1)}}));
}

// Further faces meet at their sides, which stay cut apart: the two would be duplicates and no pocket.
TEST(pockets, do_not_close_where_a_side_stays_cut) {
  for (const std::uint32_t further : {1u, 2u}) {
    // A quadrilateral back to back, whose last corners are two points at one place; the further faces run along a-b.
    Polygons faces{{0, 1, 2, 3}, {4, 2, 1, 0}};
    for (std::uint32_t i = 0; i < further; ++i) faces.push_back({0, 1, 5 + i});
    IndexedMesh list = indexed(faces, 7);
    list.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 2, 0}, {1, 1, 1}, {1, 1, 2}};
    const Mesh mesh = from_indexed(std::move(list));
    ASSERT_EQ(compute_figures(mesh)[ProblemKind::duplicate_face], 0u);
    const RecipeResult result = *run_recipe(mesh, recipe_of("weld_equal").steps, {});
    EXPECT_EQ(compute_figures(result.mesh)[ProblemKind::duplicate_face], pockets_of(result.mesh).size()) << further;
  }
}

// Faces near each other are no faces back to back.
TEST(pockets, do_not_close_within_a_distance) {
  IndexedMesh plate = built_of({{a, b, c}, {c, b, a}}).loose();
  for (std::size_t i = 3; i < 6; ++i) plate.positions[i].z = 1e-3;
  const RecipeResult result = *run_recipe(from_indexed(plate), recipe_of("weld_close=1%").steps, {});
  EXPECT_TRUE(pockets_of(result.mesh).empty());
  EXPECT_EQ(compute_figures(result.mesh)[ProblemKind::duplicate_face], 0u);
}

}  // namespace
}  // namespace ryosen::test
