// The terms of V - E + F + (B + W + I) - H = 2(S - G) on points, against an oracle that counts handles by the ranks of
// boundary matrices, on random meshes, small surfaces, and after random operators.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "ryosen/analysis/boundary_loops.h"
#include "ryosen/analysis/euler_poincare.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/problems.h"
#include "tests/support/core/kernel_lists.h"
#include "tests/support/core/kernel_sum.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/oracle/homology.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/small_surfaces.h"

namespace ryosen {
namespace {

using namespace test;

struct Seen {
  std::size_t meshes = 0, with_genus = 0, with_handles = 0, without = 0, with_wires = 0;
};

// The oracle says whether there is a G and, where there are no wires, which.
void compare(const Mesh& mesh, Seen& seen) {
  const EulerPoincare terms = euler_poincare(mesh);
  const oracle::Homology homology = oracle::homology_of(oracle::on_points(complex_of(mesh)));
  ++seen.meshes;
  ASSERT_EQ(terms.parts, homology.parts);
  ASSERT_EQ(terms.no_genus == NoGenus::none, terms.genus.has_value());
  expect_terms(mesh);
  const bool is_hindered_by_wires = terms.no_genus == NoGenus::unturned || terms.no_genus == NoGenus::wire_at_copies;
  ASSERT_EQ(terms.genus.has_value() || is_hindered_by_wires, homology.is_surface);
  seen.with_wires += terms.wire_cycles != 0 && terms.genus;
  if (!terms.genus) {
    ++seen.without;
    EXPECT_NE(why_no_genus(mesh, terms).en.find(name_on_points(mesh, terms.at)), std::string::npos);
    return;
  }
  ++seen.with_genus;
  seen.with_handles += *terms.genus > 0;
  ASSERT_TRUE(terms.holds());
  if (homology.genus) {
    ASSERT_EQ(*terms.genus, *homology.genus);
    const Figures figures = compute_figures(mesh);
    ASSERT_EQ(static_cast<std::uint64_t>(terms.boundary_loops), figures.boundary_loops);
    if (figures.genus) {
      ASSERT_EQ(terms.genus, figures.genus);
    }
  }
}

TEST(terms, of_random_polygon_meshes_are_those_of_the_oracle) {
  const std::uint64_t seeds = seed_count(2000);
  Seen seen;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE(seed);
    const SeededMesh mesh = seeded_mesh(seed);
    compare(make_mesh(mesh.faces, mesh.points), seen);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(seen.with_genus, seeds / 8);
  EXPECT_GT(seen.with_handles, seeds / 300);
  EXPECT_GT(seen.without, seeds / 8);
}

TEST(terms, of_small_surfaces_are_those_of_the_oracle) {
  Seen seen;
  for (int n = 4; n <= 7; ++n)
    for (const Surface& surface : closed_surfaces(n)) {
      SCOPED_TRACE(n);
      const Mesh mesh = kernel_mesh(oracle::polygon_list(n, surface.triangles), 1);
      compare(mesh, seen);
      if (HasFatalFailure()) return;
      ASSERT_EQ(euler_poincare(mesh).genus.has_value(), surface.orientable);
    }
  EXPECT_GT(seen.with_handles, 0u);
}

// A session keeps the terms through operators that say that they keep the topology.
TEST(terms, after_random_operators_are_those_of_the_oracle_and_kept_where_an_operator_says_so) {
  const std::uint64_t seeds = seed_count(100, 250);
  Seen seen;
  std::map<std::string, std::uint64_t> kept;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Mesh mesh = random_complex(seed);
    compare(mesh, seen);
    const EulerPoincare before = euler_poincare(mesh);
    Dice dice(seed);
    for (std::size_t place = 0; place < all_ops().size(); ++place)
      for (int i = 0; i < 4; ++i) {
        const AnyOp op = random_op(mesh, place, dice);
        SCOPED_TRACE(std::to_string(seed) + " " + command_of(mesh, op));
        Mesh after = mesh;
        if (!try_apply(after, nullptr, op)) continue;
        compare(after, seen);
        if (HasFatalFailure()) return;
        if (info_of(op).topology != Topology::kept) continue;
        ++kept[std::string(info_of(op).id)];
        const ProblemSets sets(after);
        const EulerPoincare anew = euler_poincare(after, sets);
        ASSERT_EQ(anew.genus, before.genus);
        ASSERT_EQ(anew.parts, before.parts);
        ASSERT_EQ(anew.outside(), before.outside());
        EulerPoincare followed = before;
        BoundaryLoopCount loops;
        Neighbourhood around(after);
        loops.search(around, sets.of(ProblemKind::boundary_loop));
        ASSERT_EQ(loops.has_open_chain(), anew.open_chain);
        if (follow_operator(followed, after, sets, loops)) {
          ASSERT_EQ(followed, anew);
        }
      }
  }
  for (const OpInfo& info : all_ops())
    if (info.topology == Topology::kept) {
      EXPECT_GT(kept[std::string(info.id)], seeds / 70) << info.id;
    }
  EXPECT_GT(seen.with_handles, seeds);
  EXPECT_GT(seen.with_wires, seeds / 3);
  EXPECT_GT(seen.without, seeds / 3);
}

// Where `check` and the window say "isolated vertex", remove_vertex works.
TEST(terms, isolated_vertices_are_those_that_can_be_removed) {
  const std::uint64_t seeds = seed_count(400);
  std::size_t listed = 0, ends_of_wires = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Mesh mesh = random_complex(seed);
    const ProblemSets sets(mesh);
    ends_of_wires += sets.count(ProblemKind::wire);
    sets.of(ProblemKind::isolated_vertex).for_each([&](std::uint32_t i) {
      ++listed;
      const std::string line = "remove_vertex " + name_on_points(mesh, Vertex(i));
      EXPECT_TRUE(check(mesh, op_of(mesh, line)).legal()) << seed << " " << line;
    });
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
      if (!mesh.is_alive(Vertex(i)) || has_copies(mesh, Vertex(i))) continue;
      EXPECT_EQ(RemoveVertex{Vertex(i)}.check(mesh).legal(), sets.of(ProblemKind::isolated_vertex).contains(i)) << seed;
    }
  }
  if (is_sample()) return;
  EXPECT_GT(listed, 50u);
  EXPECT_GT(ends_of_wires, 50u);
}

}  // namespace
}  // namespace ryosen
