#include "core/ops/outlook/edge_verdicts.h"

#include <gtest/gtest.h>

#include "tests/support/core/random_edits.h"

namespace ryosen {
namespace {

TEST(edge_verdicts, are_those_of_each_edge_asked_alone) {
  std::size_t legal = 0, refused = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Mesh mesh = test::random_kernel_mesh(seed);
    for (const OpInfo& op : all_ops()) {
      const std::vector<EdgeVerdict> verdicts = edge_verdicts(mesh, op);
      ASSERT_EQ(verdicts.size(), mesh.edge_slots());
      for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
        const bool is_asked = op.target == OpTargetKind::edge && mesh.is_alive(Edge(i));
        const bool is_legal = is_asked && check(mesh, op_at(mesh, op.id, {halfedge(Edge(i))})).legal();
        const EdgeVerdict expected = !is_asked  ? EdgeVerdict::none
                                     : is_legal ? EdgeVerdict::legal
                                                : EdgeVerdict::refused;
        ASSERT_EQ(verdicts[i], expected) << op.id << " seed " << seed << " edge " << i;
        legal += verdicts[i] == EdgeVerdict::legal;
        refused += verdicts[i] == EdgeVerdict::refused;
      }
    }
  }
  EXPECT_GT(legal, 100u);
  EXPECT_GT(refused, 100u);
}

}  // namespace
}  // namespace ryosen
