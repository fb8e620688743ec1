// What every operator says of itself, on random meshes: by how much the terms of V - E + F + B - H = 2(S - G) change,
// and which operator takes it back. A refused operator changes no byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <optional>
#include <set>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/rules/face_lists.h"
#include "tests/support/core/kernel_lists.h"
#include "tests/support/core/kernel_sum.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/stated_changes.h"

namespace ryosen {
namespace {

using namespace test;

// Enough that every operator is done many times.
const std::uint64_t law_seeds = seed_count(150, 400);
constexpr int tries = 12;  // per operator and mesh

Change difference(const KernelSum& was, const KernelSum& is) {
  return {is.vertices - was.vertices,     is.edges - was.edges, is.faces - was.faces,          is.rings - was.rings,
          is.components - was.components, is.genus - was.genus, is.boundaries - was.boundaries};
}

TEST(laws, the_terms_of_the_sum_change_as_stated) {
  std::map<std::string, std::size_t> compared, refused;
  for (std::uint64_t seed = 0; seed < law_seeds && !HasFailure(); ++seed) {
    const Mesh mesh = random_complex(seed);
    const KernelSum was = kernel_sum(mesh);
    Dice dice(seed);
    for (std::size_t place = 0; place < all_ops().size(); ++place)
      for (int i = 0; i < tries; ++i) {
        const AnyOp op = random_op(mesh, place, dice);
        Mesh after = mesh;
        if (!try_apply(after, nullptr, op)) {
          ++refused[std::string(info_of(op).id)];
          ASSERT_EQ(after.columns(), mesh.columns());
          continue;
        }
        const KernelSum is = kernel_sum(after);
        ASSERT_EQ(is.left(), is.right()) << command_of(mesh, op);
        ASSERT_GE(is.genus, 0) << command_of(mesh, op);
        const auto stated = law_of(Stated{mesh}, op);
        if (stated.empty()) continue;
        ++compared[std::string(info_of(op).id)];
        const Change change = difference(was, is);
        EXPECT_TRUE(std::count(stated.begin(), stated.end(), change))
            << "seed " << seed << ": " << command_of(mesh, op) << " changes " << testing::PrintToString(change)
            << ", stated " << testing::PrintToString(stated[0]) << " on " << to_text(complex_of(mesh));
      }
  }
  for (const auto& [id, count] : compared)
    std::cout << "  " << id << ": " << count << ", refused " << refused[id] << "\n";
  EXPECT_EQ(compared.size(), law_count<Stated>) << "each law was tried";
  EXPECT_GE(compared.size(), 21u) << "none of those that there were";
}

// The operator that takes one back, asked after it; none where the header names none or none in this case.
struct Inverse {
  const Mesh& before;
  const Mesh& after;

  Vertex new_vertex() const { return Vertex(after.vertex_slots() - 1); }
  bool is_plain(Vertex v) const { return !has_copies(before, v); }

  std::optional<AnyOp> of(const SwapEdge& op) const { return SwapEdge{op.halfedge, !op.back}; }
  std::optional<AnyOp> of(const SplitEdge& op) const {
    if (is_cut_on_points(before, op.halfedge)) return {};
    const Halfedge h = find_halfedge(after, new_vertex(), before.to(op.halfedge));
    return CollapseEdge{h, CollapseEdge::Place::end};
  }
  std::optional<AnyOp> of(const Poke&) const { return Dissolve{{}, new_vertex()}; }
  std::optional<AnyOp> of(const VertexSplit& op) const {
    return CollapseEdge{find_halfedge(after, new_vertex(), op.vertex), CollapseEdge::Place::end};
  }
  std::optional<AnyOp> of(const Reverse& op) const { return op; }
  std::optional<AnyOp> of(const MakeVertex&) const { return RemoveVertex{new_vertex()}; }
  std::optional<AnyOp> of(const MakeEdge& op) const { return DeleteEdge{find_halfedge(after, op.a, op.b)}; }
  std::optional<AnyOp> of(const DeleteEdge& op) const {
    const Halfedge h = op.halfedge;
    const auto into = [&](Halfedge side) { return before.prev(side) == twin(side) ? Halfedge() : before.prev(side); };
    return MakeEdge{before.from(h), before.to(h), into(h), into(twin(h))};
  }
  std::optional<AnyOp> of(const MakeLoop& op) const { return DeleteLoop{after.face(op.halfedge)}; }
  std::optional<AnyOp> of(const DeleteLoop& op) const {
    if (before.has_rings(op.face) || equal_face(before, op.face)) return {};
    for (Halfedge h : halfedges_around(before, op.face))
      if (is_cut_on_points(before, h)) return {};
    return MakeLoop{before.halfedge(op.face)};
  }
  std::optional<AnyOp> of(const SeparateLoop& op) const {
    // A bridge may lie between the two parts; then they share more than the new edge.
    if (bridges_of(loops_of(before, before.face(op.into_a))) > 0) return {};
    return UniteLoop{halfedge(Edge(after.edge_slots() - 1))};
  }
  std::optional<AnyOp> of(const SeparateEdge& op) const {
    if (is_cut_on_points(before, op.halfedge)) return {};
    return UniteEdge{new_vertex()};
  }
  std::optional<AnyOp> of(const UniteRing&) const { return MakeRing{halfedge(Edge(after.edge_slots() - 1))}; }
  std::optional<AnyOp> of(const MakeRing& op) const {
    const Halfedge h = op.halfedge;
    return UniteRing{before.prev(h), before.prev(twin(h))};
  }
  std::optional<AnyOp> of(const Fill& op) const { return DeleteLoop{after.face(op.halfedge)}; }
};

TEST(laws, the_inverse_gives_the_list_before) {
  std::map<std::string, std::size_t> proved;
  for (std::uint64_t seed = 0; seed < law_seeds && !HasFailure(); ++seed) {
    const Mesh mesh = random_complex(seed);
    // Turning separates fans; then copies stand where one vertex stood.
    const oracle::Shape shape = shape_of(oracle::on_points(complex_of(mesh)));
    Dice dice(seed + 1);
    for (std::size_t place = 0; place < all_ops().size(); ++place)
      for (int i = 0; i < tries; ++i) {
        const AnyOp op = random_op(mesh, place, dice);
        Mesh after = mesh;
        if (!try_apply(after, nullptr, op)) continue;
        const auto inverse = law_of(Inverse{mesh, after}, op);
        if (!inverse) continue;
        const std::string line = command_of(mesh, op) + ", " + command_of(after, *inverse);
        ASSERT_TRUE(try_apply(after, nullptr, *inverse))
            << "seed " << seed << ": " << line << ": " << text_of(check(after, *inverse).reasons[0].rule).id << " on "
            << to_text(complex_of(mesh));
        EXPECT_TRUE(shape_of(oracle::on_points(complex_of(after))) == shape)
            << "seed " << seed << ": " << line << " gives " << to_text(complex_of(after)) << "\nnot "
            << to_text(complex_of(mesh));
        ++proved[std::string(info_of(op).id)];
      }
  }
  for (const auto& [id, count] : proved) std::cout << "  " << id << ": " << count << "\n";
  EXPECT_EQ(proved.size(), law_count<Inverse>) << "each law was tried";
  EXPECT_GE(proved.size(), 15u) << "none of those that there were";
}

}  // namespace
}  // namespace ryosen
