// The laws that the oracle must obey, on random meshes.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/support/core/long_run.h"
#include "tests/support/core/oracle/comparison.h"
#include "tests/support/core/oracle/figures.h"
#include "tests/support/core/oracle/operators.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::oracle {
namespace {

PolygonList random_list(std::uint64_t seed) {
  const RandomMesh mesh = random_mesh(seed);
  return polygon_list(mesh.points, mesh.faces);
}

const std::uint64_t seeds = test::is_long_run() ? 3000 : 400;

TEST(oracle_laws, swap_and_swap_back_undo_each_other) {
  int swaps = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const PolygonList points = random_list(seed);
    const Judge judge(read_copies(points));
    const Sides sides(points);
    for (const Operation& operation : operations_of(points)) {
      const bool back = operation.kind == Kind::swap_back;
      if ((operation.kind != Kind::swap && !back) || !judge.legal(operation)) continue;
      const PolygonList after = points_of(*apply(judge.list(), operation));
      // The new edge is the one that the list did not have.
      std::set<std::pair<int, int>> old;
      for (const Side& side : sides.all()) old.emplace(side.lo, side.hi);
      const Sides sides_after(after);
      for (const Side& side : sides_after.all()) {
        if (old.count({side.lo, side.hi})) continue;
        const Operation inverse{back ? Kind::swap : Kind::swap_back, side.lo, side.hi};
        PolygonList again = points_of(apply(read_copies(after), inverse).value());
        again.live = points.live;  // the numbers of copies are gaps in it
        EXPECT_TRUE(same_list(again, points)) << seed << " " << to_text(operation) << " " << to_text(points);
        ++swaps;
      }
    }
  }
  EXPECT_GT(3 * swaps, 10 * static_cast<int>(seeds));
}

TEST(oracle_laws, legal_splits_read_back_and_count_as_stated) {
  for (std::uint64_t seed = 0; seed < (test::is_long_run() ? 2000u : 280u); ++seed) {
    const PolygonList points = random_list(seed);
    const Judge judge(read_copies(points));
    const Figures before = figures_of(points);
    const Sides sides_before(points);
    for (const Operation& operation : operations_of(points)) {
      if (operation.kind != Kind::split || !judge.legal(operation)) continue;
      const CopyList after = apply(judge.list(), operation).value();
      int triangles = 0, sides = 0;
      for (const Side& side : sides_before.all())
        if (std::minmax(operation.from, operation.to) == std::minmax(side.lo, side.hi)) {
          triangles += points.faces[side.face].size() == 3;
          ++sides;
        }
      const Figures figures = figures_of(points_of(after));
      EXPECT_EQ(figures.vertices, before.vertices + 1);
      EXPECT_EQ(figures.edges, before.edges + 1 + triangles) << seed << to_text(operation) << to_text(points);
      EXPECT_EQ(figures.faces, before.faces + triangles);
      EXPECT_EQ(figures.boundary_loops, before.boundary_loops);
      EXPECT_EQ(figures.nonmanifold_edges, before.nonmanifold_edges + (sides > 2)) << seed << to_text(operation);
      EXPECT_EQ(figures.isolated_vertices, before.isolated_vertices);
      const Facts facts = facts_of(after);
      EXPECT_TRUE(facts.reads_back && !facts.point_twice_in_face);
    }
  }
}

// Each rule must decide something on these meshes, else an error in it could not show.
TEST(oracle_laws, the_random_meshes_reach_every_rule) {
  std::map<std::string, int> seen, alone;
  int operations = 0, legal_ones = 0, with_copies = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const PolygonList points = random_list(seed);
    const Judge judge(read_copies(points));
    for (const Operation& operation : operations_of(points)) {
      const Reasons reasons = judge.reasons(operation);
      ++operations;
      legal_ones += reasons.empty();
      with_copies += reasons.empty() && judge.list().list.size() > points.size() && operation.kind != Kind::split;
      std::set<std::string> kinds;
      for (const std::string& reason : reasons)
        kinds.insert(reason.substr(0, reason.find_last_not_of("-0123456789 :") + 1));
      for (const std::string& rule : kinds) ++seen[rule];
      if (kinds.size() == 1) ++alone[*kinds.begin()];
    }
  }
  EXPECT_GT(legal_ones, operations / 5);
  EXPECT_GT(with_copies, operations / 100);
  for (const char* rule : {"1 corner twice in a face", "1 directed edge twice", "1 more than one fan",
                           "1 two faces on one vertex set", "2 E", "2 Euler characteristic", "2 boundary loops",
                           "2 components", "2 isolated vertices", "3 groups of copies change"})
    EXPECT_GT(30 * seen[rule], static_cast<int>(seeds)) << rule;
  for (const char* rule :
       {"3 face visits a point twice", "3 faces on equal point sets change", "3 misoriented edges change",
        "3 non-manifold edges change", "3 reading the points gives other fans", "both points have copies",
        "boundary edge", "the edge is non-manifold or misoriented on points",
        "two triangles with the same third point"})
    EXPECT_GT(300 * alone[rule], static_cast<int>(seeds)) << rule;
}

}  // namespace
}  // namespace ryosen::oracle
