// The quick answers of the checks against the judgement rule for rule.
#include "ryosen/ops/rules/plain_check.h"

#include <gtest/gtest.h>

#include <random>

#include "ryosen/io/formats.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

struct Count {
  std::size_t quick = 0;  // legal beyond doubt
  std::size_t quickly_refused = 0;
  std::size_t legal = 0;  // legal by the judgement
  std::size_t refused = 0;
};

template <class Op>
void compare(const Mesh& mesh, const Op& op, QuickAnswer quick, Count& count) {
  const Verdict judged = op.judge(mesh);
  ASSERT_EQ(op.check(mesh).reasons, judged.reasons) << command_of(mesh, op);
  ASSERT_EQ(op.is_legal(mesh), judged.legal()) << command_of(mesh, op);
  ASSERT_TRUE(judged.legal() || quick != QuickAnswer::legal)
      << command_of(mesh, op) << ": " << text_of(judged.reasons[0].rule).id;
  ASSERT_TRUE(!judged.legal() || quick != QuickAnswer::refused) << command_of(mesh, op);
  count.quick += quick == QuickAnswer::legal;
  count.quickly_refused += quick == QuickAnswer::refused;
  ++(judged.legal() ? count.legal : count.refused);
}

void compare_all(const Mesh& mesh, Count& collapse, Count& swap, std::uint32_t step = 1) {
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); i += step) {
    const Halfedge h(i);
    if (!mesh.is_alive(h)) continue;
    ASSERT_NO_FATAL_FAILURE(compare(mesh, CollapseEdge{h}, quick_collapse(mesh, h), collapse));
    for (bool back : {false, true})
      ASSERT_NO_FATAL_FAILURE(compare(mesh, SwapEdge{h, back}, quick_swap(mesh, h), swap));
  }
}

void expect_all_kinds(const Count& count) {
  EXPECT_GT(count.quick, 0u);
  EXPECT_GT(count.legal, count.quick);
  EXPECT_GT(count.refused, count.quickly_refused);
  EXPECT_GT(count.quickly_refused, 0u);
}

TEST(plain_check, agrees_on_random_meshes) {
  Count collapse, swap;
  for (std::uint64_t seed = 1; seed <= seed_count(800, 4000); ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    ASSERT_NO_FATAL_FAILURE(compare_all(make_mesh(random.faces, random.points), collapse, swap)) << "seed " << seed;
  }
  expect_all_kinds(collapse);
  expect_all_kinds(swap);
}

// Each of the ten triangles on five points is there, there the other way round, or not there; in a short run every
// seventh of these sets.
TEST(plain_check, agrees_on_all_triangle_sets_on_five_points) {
  Polygons triangles;
  for (std::uint32_t a = 0; a < 5; ++a)
    for (std::uint32_t b = a + 1; b < 5; ++b)
      for (std::uint32_t c = b + 1; c < 5; ++c) triangles.push_back({a, b, c});
  Count collapse, swap;
  for (std::uint32_t code = 0; code < 59049; code += is_long_run() ? 1 : 23) {
    Polygons faces;
    std::uint32_t rest = code;
    for (const auto& t : triangles) {
      if (rest % 3 == 1) faces.push_back(t);
      if (rest % 3 == 2) faces.push_back({t[0], t[2], t[1]});
      rest /= 3;
    }
    ASSERT_NO_FATAL_FAILURE(compare_all(make_mesh(faces, 5), collapse, swap)) << "code " << code;
  }
  expect_all_kinds(collapse);
  expect_all_kinds(swap);
}

TEST(plain_check, agrees_on_a_torus_under_random_edits) {
  std::mt19937 random(5);
  Count collapse, swap;
  for (int round = 0; round < (is_long_run() ? 20 : 8); ++round) {
    Mesh mesh = make_mesh(torus_grid(5, 5));
    for (int step = 0; step < 60; ++step) {
      Halfedge h;
      do h = Halfedge(random() % mesh.halfedge_slots());
      while (!mesh.is_alive(h));
      const AnyOp op = step % 3 == 0 ? AnyOp(CollapseEdge{h}) : AnyOp(SwapEdge{h});
      if (!check(mesh, op).legal()) continue;
      Edit edit(mesh, nullptr);
      apply(edit, op);
      edit.commit();
      ASSERT_NO_FATAL_FAILURE(compare_all(mesh, collapse, swap));
    }
  }
  EXPECT_GT(collapse.quick, 0u);
  EXPECT_GT(swap.refused, 0u);
}

// On a mesh of triangles nearly every legal edge gets the quick answer, at the boundary too.
TEST(plain_check, answers_for_the_bunny) {
  Result<MeshFile> file = read_mesh_file(RYOSEN_SOURCE_DIR "/assets/stanford_bunny.obj");
  ASSERT_TRUE(file);
  const Mesh mesh = from_indexed(std::move(file->mesh));
  Count collapse, swap;
  ASSERT_NO_FATAL_FAILURE(compare_all(mesh, collapse, swap, is_long_run() ? 1 : 3));
  EXPECT_EQ(collapse.quick, collapse.legal);
  EXPECT_EQ(swap.quick, swap.legal);
  EXPECT_GT(collapse.refused, 0u);
}

TEST(plain_check, leaves_high_valence_to_the_judgement) {
  const Mesh mesh = make_mesh(closed_fan(100));
  const CollapseEdge op{find_halfedge(mesh, Vertex(0), Vertex(1))};
  EXPECT_EQ(quick_collapse(mesh, op.halfedge), QuickAnswer::unknown);
  EXPECT_TRUE(op.check(mesh).legal());
}

}  // namespace
}  // namespace ryosen
