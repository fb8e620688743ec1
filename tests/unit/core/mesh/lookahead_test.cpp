#include "ryosen/mesh/prefetch.h"

#include <gtest/gtest.h>

#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/swap_edge.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

template <class Op>
std::uint64_t edited(Mesh mesh, Lookahead* (*make)(const Mesh&)) {
  const std::unique_ptr<Lookahead> ahead(make(mesh));
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    // Twice and out of order, so that dead edges are announced too.
    if (ahead) ahead->announce(Edge((i * 7 + 3) % mesh.edge_slots()));
    const Op op{halfedge(Edge((i * 5 + 1) % mesh.edge_slots()))};
    if (!op.is_legal(mesh)) continue;
    Edit edit(mesh, nullptr);
    op.apply(edit);
    edit.commit();
  }
  return mesh.hash();
}

TEST(lookahead, changes_no_result_whatever_is_announced) {
  const auto none = [](const Mesh&) -> Lookahead* { return nullptr; };
  const auto ends = [](const Mesh& m) { return new Lookahead(m, Lookahead::Around::ends); };
  const auto apexes = [](const Mesh& m) { return new Lookahead(m, Lookahead::Around::apexes); };
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    const Mesh mesh = make_mesh(random.faces, random.points);
    EXPECT_EQ(edited<CollapseEdge>(mesh, ends), edited<CollapseEdge>(mesh, none)) << "seed " << seed;
    EXPECT_EQ(edited<SwapEdge>(mesh, apexes), edited<SwapEdge>(mesh, none)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace ryosen
