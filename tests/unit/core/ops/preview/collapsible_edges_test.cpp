#include "ryosen/ops/preview/collapsible_edges.h"

#include <gtest/gtest.h>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/ops/collapse_edge.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// How many may collapse, each of which the judgement says too.
std::size_t count_and_compare(const Mesh& mesh) {
  const std::vector<std::uint8_t> legal = collapsible_edges(mesh);
  EXPECT_EQ(legal.size(), mesh.edge_slots());
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    const bool is_expected = mesh.is_alive(Edge(i)) && CollapseEdge{halfedge(Edge(i))}.judge(mesh).legal();
    EXPECT_EQ(legal[i] != 0, is_expected) << "edge " << i;
    count += legal[i] != 0;
  }
  return count;
}

TEST(collapsible_edges, are_those_that_the_judgement_finds_on_random_meshes) {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 2000 && !testing::Test::HasFailure(); ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    count += count_and_compare(make_mesh(random.faces, random.points));
  }
  EXPECT_GT(count, 0u);
}

TEST(collapsible_edges, are_those_that_the_judgement_finds_on_the_bunny) {
  Result<MeshFile> file = read_mesh_file(RYOSEN_SOURCE_DIR "/assets/stanford_bunny.obj");
  ASSERT_TRUE(file);
  EXPECT_GT(count_and_compare(from_indexed(std::move(file->mesh))), 100000u);
}

TEST(collapsible_edges, none_of_a_tetrahedron_all_of_a_torus) {
  EXPECT_EQ(count_and_compare(make_mesh(tetrahedron())), 0u);
  EXPECT_EQ(count_and_compare(make_mesh(torus_grid(5, 5))), 75u);
}

TEST(collapsible_edges, of_a_high_valence_and_after_deletions) {
  EXPECT_GT(count_and_compare(make_mesh(closed_fan(200))), 0u);
  Mesh mesh = make_mesh(torus_grid(6, 6));
  for (std::uint32_t i = 0; i < 40; ++i) {
    const CollapseEdge op{halfedge(Edge(i))};
    if (!op.is_legal(mesh)) continue;
    Edit edit(mesh, nullptr);
    op.apply(edit);
    edit.commit();
  }
  count_and_compare(mesh);
}

}  // namespace
}  // namespace ryosen
