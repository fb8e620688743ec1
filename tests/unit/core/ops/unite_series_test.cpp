#include "ryosen/ops/unite_series.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/euler/unite_edge.h"
#include "ryosen/ops/rules/surgery.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/ugly_meshes.h"

namespace ryosen {
namespace {

using namespace test;

// What dissolving leaves, so that there are many vertices with two edges.
Mesh with_edges_dissolved(Mesh mesh, Dice& dice) {
  Edit edit(mesh, nullptr);
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    const Dissolve op{random_halfedge(mesh, dice)};
    if (op.check(mesh).legal()) op.apply(edit);
  }
  edit.commit();
  return mesh;
}

TEST(unite_series, takes_out_what_one_call_after_the_other_does) {
  std::size_t taken = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const SeededMesh seeded = seeded_mesh(seed);
    Mesh single = seed % 3 == 0 ? random_complex(seed) : make_mesh(seeded.faces, seeded.points);
    single = with_edges_dissolved(std::move(single), dice);
    Mesh many = single;
    Edit once(single, nullptr), edit(many, nullptr);
    UniteSeries series(edit);
    for (std::uint32_t call = 0; call < 3 * many.vertex_slots(); ++call) {
      const UniteEdge op{random_vertex(many, dice)};
      const bool is_legal = op.check(single).legal();
      if (has_two_edges(many, op.vertex)) ++(is_legal ? taken : refused);
      ASSERT_EQ(series.unite(op.vertex), is_legal);
      if (is_legal) op.apply(once);
    }
    once.commit();
    edit.commit();
    EXPECT_EQ(many.hash(), single.hash());
    const auto broken = check_invariants(many);
    EXPECT_FALSE(broken) << broken->sentence;
  }
  EXPECT_GT(taken, 100u);
  EXPECT_GT(refused, 100u);
}

// All corners of one polygon but three, from one on.
std::uint64_t looks_at_polygon(std::uint32_t corners) {
  Mesh mesh = from_indexed(large_face(corners));
  Edit edit(mesh, nullptr);
  UniteSeries series(edit);
  for (std::uint32_t i = 0; i < corners; ++i) series.unite(Vertex(i));
  edit.commit();
  EXPECT_EQ(mesh.live().vertices, 3u);
  return series.looks();
}

TEST(unite_series, cost_grows_with_the_vertices_along_one_face) {
  const std::uint64_t small = looks_at_polygon(500), large = looks_at_polygon(2000);
  EXPECT_GT(small, 500u);
  EXPECT_LE(large, 5 * small) << "four times the corners";
}

}  // namespace
}  // namespace ryosen
