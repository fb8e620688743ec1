// Solids that share edges and faces, among sheets, through the pairing of faces and the default repairs: none is torn.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/algo/repair/pair_faces.h"
#include "core/algo/repair/recipe.h"
#include "core/analysis/figures.h"
#include "core/indexed/from_indexed.h"
#include "core/indexed/to_indexed.h"
#include "core/mesh/circulate.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/oracle/pairing_oracle.h"
#include "tests/support/core/recipe_checks.h"

namespace ryosen::test {
namespace {

const std::string usual_repairs = "give_places,remove_duplicates,weld_equal,orient,detach_nonmanifold";

const std::uint64_t pairing_seeds = is_long_run() ? 20000 : 1200;

SolidBuilder soup(std::uint64_t seed) {
  return seed % 3 == 0 ? random_triangles(seed) : random_solids_and_sheets(seed);
}

TEST(pairing, is_the_rule_read_word_by_word) {
  std::size_t closed = 0, open = 0, is_free = 0;
  for (std::uint64_t seed = 1; seed <= pairing_seeds && !HasFailure(); ++seed) {
    const SolidBuilder built = soup(seed);
    const PairedList truth = pair_by_asking_all(built.faces());
    const FacePairing paired = pair_faces(from_indexed(built.indexed()));
    for (std::size_t f = 0; f < built.faces().size(); ++f) {
      EXPECT_EQ(paired.is_closed[f], truth.is_closed[f]) << "face " << f << " of seed " << seed;
      EXPECT_EQ(paired.is_free[f], truth.is_free[f]) << "face " << f << " of seed " << seed;
      closed += truth.is_closed[f];
      open += !truth.is_closed[f];
      is_free += truth.is_free[f];
    }
  }
  EXPECT_GT(closed, 5 * pairing_seeds);
  EXPECT_GT(open, pairing_seeds);
  EXPECT_GT(is_free, pairing_seeds);
}

using Loop = std::vector<std::array<double, 3>>;

// From the smallest place on, in the direction of the smaller list: repairs may turn a solid.
Loop canonical(Loop loop) {
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  Loop turned = loop;
  std::reverse(turned.begin() + 1, turned.end());
  return std::min(loop, turned);
}

Loop loop_of(const Mesh& m, Face f) {
  Loop loop;
  for (const Vertex v : vertices_around(m, f)) loop.push_back({m.position(v).x, m.position(v).y, m.position(v).z});
  return canonical(std::move(loop));
}

Loop loop_of(const std::vector<LatticePoint>& face) {
  Loop loop;
  for (const LatticePoint& p : face) loop.push_back({double(p[0]), double(p[1]), double(p[2])});
  return canonical(std::move(loop));
}

// By loop how many faces have it, without those that have a boundary edge.
std::map<Loop, int> faces_without_boundary(const Mesh& m) {
  std::map<Loop, int> found;
  Neighbourhood around(m);
  for (std::uint32_t i = 0; i < m.face_slots(); ++i) {
    if (!m.is_alive(Face(i))) continue;
    bool is_at_boundary = false;
    for (const Halfedge h : halfedges_around(m, Face(i))) is_at_boundary |= around.edge(h).is_boundary();
    found[loop_of(m, Face(i))] += !is_at_boundary;
  }
  return found;
}

// The law: no face of a closed part gets a boundary edge, and boundary edges become more only at sides set free. The
// two faces of an edge in one direction have no pair: they may come apart, and once they are turned others have pairs.
void expect_law(const SolidBuilder& built, const std::string& kinds, std::uint64_t seed) {
  const PairedList truth = pair_by_asking_all(built.faces());
  const RecipeResult result = *run_recipe(from_indexed(built.indexed()), recipe_of(kinds).steps, {});
  const std::map<Loop, int> whole = faces_without_boundary(result.mesh);
  std::map<Loop, int> wanted;
  for (std::size_t f = 0; f < built.faces().size(); ++f)
    if (truth.is_closed[f]) wanted[loop_of(built.faces()[f])] = 1;
  for (const auto& [loop, one] : wanted) {
    const auto found = whole.find(loop);
    EXPECT_TRUE(found != whole.end() && found->second >= one) << kinds << " tears a closed part of seed " << seed;
  }
  const Figures figures = compute_figures(result.mesh);
  if (kinds != usual_repairs || truth.misoriented == 0) {
    EXPECT_LE(figures[ProblemKind::boundary_loop], truth.boundary + truth.free_sides + 2 * truth.misoriented)
        << kinds << ", seed " << seed;
  }
  EXPECT_TRUE(figures.manifold) << kinds << ", seed " << seed;
  EXPECT_FALSE(run_recipe(result.mesh, recipe_of(kinds).steps, {})->is_changed) << kinds << " again, seed " << seed;
}

TEST(pairing, no_closed_part_is_torn_and_nothing_opens_but_where_a_patch_is_set_free) {
  for (std::uint64_t seed = 1; seed <= pairing_seeds && !HasFailure(); ++seed) {
    const SolidBuilder built = soup(seed);
    expect_law(built, "detach_nonmanifold", seed);
    expect_law(built, usual_repairs, seed);
  }
}

TEST(pairing, unions_of_solids_merged_by_points_come_apart_closed_with_their_volume) {
  std::size_t parts = 0, shared = 0;
  for (std::uint64_t seed = 1; seed <= (is_long_run() ? 5000u : 200u) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SolidBuilder built = random_union(seed);
    const Mesh mesh = from_indexed(built.indexed());
    shared += compute_figures(mesh)[ProblemKind::nonmanifold_edge] > 0;
    const RecipeResult result = *run_recipe(mesh, recipe_of(usual_repairs).steps, {});
    const Figures figures = compute_figures(result.mesh);
    EXPECT_EQ(figures[ProblemKind::boundary_loop], 0u);
    EXPECT_TRUE(figures.closed && figures.manifold);
    EXPECT_EQ(figures.faces, built.faces().size());
    ASSERT_TRUE(figures.volume);
    EXPECT_NEAR(*figures.volume, static_cast<double>(built.volume_six()) / 6, 1e-9);
    EXPECT_FALSE(run_recipe(result.mesh, recipe_of(usual_repairs).steps, {})->is_changed) << "again";
    parts += figures.components;
  }
  EXPECT_GT(shared, 150u) << "hardly any touch";
  EXPECT_GT(parts, 800u);
}

}  // namespace
}  // namespace ryosen::test
