// Solids that share edges and faces, among sheets, through the pairing of faces and the default repairs: none is torn.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "ryosen/algo/repair/pair_faces.h"
#include "ryosen/algo/repair/recipe.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/oracle/pairing_oracle.h"
#include "tests/support/core/recipe_checks.h"

namespace ryosen::test {
namespace {

const std::string usual_repairs = "give_places,remove_duplicates,weld_equal,orient,detach_nonmanifold";
const std::string default_repairs = "give_places,remove_duplicates,weld_equal,stitch,orient,detach_nonmanifold";

const std::uint64_t pairing_seeds = seed_count(400, 30000);

SolidBuilder soup(std::uint64_t seed) {
  return seed % 3 == 0 ? random_triangles(seed) : random_solids_and_sheets(seed);
}

TEST(pairing, is_the_rule_read_word_by_word) {
  std::size_t closed = 0, open = 0, is_free = 0;
  for (std::uint64_t seed = 1; seed <= pairing_seeds && !HasFailure(); ++seed) {
    const SolidBuilder built = soup(seed);
    const Mesh mesh = from_indexed(built.indexed());
    const PairedList truth = pair_by_asking_all(triangles_of(mesh));
    const FacePairing paired = pair_faces(mesh);
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

// A side of a face by the face and its places.
using PlacedSide = std::tuple<Face, Loop>;

// The boundary edges but for these sides.
std::size_t boundary_beside(const Mesh& m, const std::set<PlacedSide>& sides) {
  std::size_t found = 0;
  Neighbourhood around(m);
  for (std::uint32_t i = 0; i < m.face_slots(); ++i)
    if (m.is_alive(Face(i)))
      for (const Halfedge h : halfedges_around(m, Face(i))) {
        const glm::dvec3 a = m.position(m.from(h)), b = m.position(m.to(h));
        found +=
            around.edge(h).is_boundary() && !sides.contains({Face(i), canonical({{a.x, a.y, a.z}, {b.x, b.y, b.z}})});
      }
  return found;
}

// The law: no face of a closed part gets a boundary edge, and boundary edges become more only at sides set free: in the
// mesh as it is, or as it is without the duplicates that go. Two faces in one direction have no pair.
void expect_law(const Mesh& mesh, const std::string& kinds) {
  SCOPED_TRACE(kinds);
  const RecipeResult result = *run_recipe(mesh, recipe_of(kinds).steps, {});
  const TriangleList list = triangles_of(mesh);
  const PairedList truth = pair_by_asking_all(list);
  const std::map<Loop, int> whole = faces_without_boundary(result.mesh);
  TriangleList left{list.places, {}};
  std::vector<Face> faces;  // by face of those left
  std::size_t open = 0;
  for (std::uint32_t f = 0; f < list.faces.size(); ++f) {  // there are no dead ones
    if (truth.is_closed[f]) {
      EXPECT_GE(whole.at(loop_of(mesh, Face(f))), 1) << "a closed part is torn";
    }
    if (!result.mesh.is_alive(Face(f))) continue;
    left.faces.push_back(list.faces[f]);
    faces.emplace_back(f);
    open += truth.open_sides[f];
  }
  const PairedList after = pair_by_asking_all(left);
  std::set<PlacedSide> alike;
  for (const auto& [face, corner] : after.sides_alike) {
    const std::array<std::size_t, 3>& points = left.faces[face];
    alike.emplace(faces[face], loop_of({left.places[points[corner]], left.places[points[(corner + 1) % 3]]}));
  }
  open = std::max(open, std::accumulate(after.open_sides.begin(), after.open_sides.end(), std::size_t{0}));
  EXPECT_LE(boundary_beside(result.mesh, alike), open);
  EXPECT_TRUE(compute_figures(result.mesh).manifold);
  EXPECT_FALSE(run_recipe(result.mesh, recipe_of(kinds).steps, {})->is_changed) << "again";
}

TEST(pairing, no_closed_part_is_torn_and_nothing_opens_but_where_a_patch_is_set_free) {
  for (std::uint64_t seed = 1; seed <= pairing_seeds && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Mesh mesh = from_indexed(soup(seed).indexed());
    expect_law(mesh, "detach_nonmanifold");
    expect_law(mesh, usual_repairs);
  }
}

TEST(pairing, unions_of_solids_come_apart_closed_with_their_volume_merged_by_points_or_not) {
  const std::uint64_t seeds = seed_count(200, 5000);
  std::size_t parts = 0, shared = 0;
  for (std::uint64_t seed = 1; seed <= seeds && !HasFailure(); ++seed) {
    const SolidBuilder built = random_union(seed);
    shared += compute_figures(from_indexed(built.indexed()))[ProblemKind::nonmanifold_edge] > 0;
    for (const IndexedMesh& source : {built.indexed(), built.loose()}) {
      const std::string& repairs = seed % 2 == 0 ? default_repairs : usual_repairs;
      SCOPED_TRACE("seed " + std::to_string(seed) + ", points " + std::to_string(source.positions.size()));
      const RecipeResult result = *run_recipe(from_indexed(source), recipe_of(repairs).steps, {});
      const Figures figures = compute_figures(result.mesh);
      EXPECT_EQ(figures.faces, built.faces().size());
      EXPECT_TRUE(figures.manifold);
      EXPECT_FALSE(run_recipe(result.mesh, recipe_of(repairs).steps, {})->is_changed) << "again";
      parts += figures.components;
      EXPECT_EQ(figures[ProblemKind::boundary_loop], 0u);
      ASSERT_TRUE(figures.volume);
      EXPECT_NEAR(*figures.volume, static_cast<double>(built.volume_six()) / 6, 1e-9);
    }
  }
  EXPECT_GT(2 * shared, seeds) << "hardly any touch";
  EXPECT_GT(parts, 6 * seeds);
}

// Two faces back to back may be a pocket without room: two of their edges are paired with each other, and at the third,
// the mouth, each with a face beyond. Both edges of the mouth would join the same two vertices, which have one edge at
// most, so that the pocket becomes a part of its own.
TEST(pairing, closed_parts_of_loose_faces_close) {
  std::size_t closed = 0;
  for (std::uint64_t seed = 1; seed <= pairing_seeds && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SolidBuilder built = soup(seed);
    const PairedList truth = pair_by_asking_all(triangles_of(from_indexed(built.indexed())));
    const RecipeResult result = *run_recipe(from_indexed(built.loose()), recipe_of(usual_repairs).steps, {});
    const std::map<Loop, int> whole = faces_without_boundary(result.mesh);
    std::map<Loop, int> wanted;
    for (std::size_t f = 0; f < built.faces().size(); ++f) wanted[loop_of(built.faces()[f])] += truth.is_closed[f];
    for (const auto& [loop, faces] : wanted) {
      EXPECT_GE(whole.at(loop), faces);
      closed += static_cast<std::size_t>(faces);
    }
    EXPECT_TRUE(compute_figures(result.mesh).manifold);
    EXPECT_FALSE(run_recipe(result.mesh, recipe_of(usual_repairs).steps, {})->is_changed) << "again";
  }
  EXPECT_GT(closed, 5 * pairing_seeds);
}

}  // namespace
}  // namespace ryosen::test
