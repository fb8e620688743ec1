#include "ryosen/ops/preview/tool_verdicts.h"

#include <gtest/gtest.h>

#include "tests/support/core/long_run.h"
#include "tests/support/core/random_edits.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

constexpr Element::Kind sorts[] = {Element::Kind::vertex, Element::Kind::edge, Element::Kind::face};

bool acts_on(const OpInfo& op, Element::Kind sort) {
  return op.target == OpTargetKind::any || (op.target == OpTargetKind::vertex && sort == Element::Kind::vertex) ||
         (op.target == OpTargetKind::edge && sort == Element::Kind::edge) ||
         (op.target == OpTargetKind::face && sort == Element::Kind::face);
}

// Each element asked alone, of the mesh as it is.
std::vector<ElementVerdict> asked_alone(const Mesh& mesh, const OpInfo& op, Element::Kind sort) {
  std::vector<ElementVerdict> verdicts;
  const auto ask = [&](bool is_there, const OpTarget& target) {
    verdicts.push_back(!is_there                                         ? ElementVerdict::none
                       : check(mesh, op_at(mesh, op.id, target)).legal() ? ElementVerdict::legal
                                                                         : ElementVerdict::refused);
  };
  if (sort == Element::Kind::vertex)
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
      ask(mesh.is_alive(Vertex(i)), {.halfedge = {}, .vertex = Vertex(i)});
  if (sort == Element::Kind::edge)
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) ask(mesh.is_alive(Edge(i)), {halfedge(Edge(i))});
  if (sort == Element::Kind::face)
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i)
      ask(mesh.is_alive(Face(i)), {.halfedge = {}, .face = Face(i)});
  return verdicts;
}

std::vector<ElementVerdict> all_of(const ToolVerdicts& verdicts) {
  return {verdicts.all().begin(), verdicts.all().end()};
}

TEST(tool_verdicts, are_those_of_each_element_asked_alone) {
  std::size_t legal = 0, refused = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Mesh mesh = test::random_kernel_mesh(seed);
    for (const OpInfo& op : all_ops())
      for (const Element::Kind sort : sorts) {
        if (!acts_on(op, sort)) continue;
        ToolVerdicts verdicts(mesh, op, sort);
        EXPECT_EQ(verdicts.is_complete(), verdicts.all().empty());
        verdicts.ask(mesh);
        EXPECT_TRUE(verdicts.is_complete());
        ASSERT_EQ(all_of(verdicts), asked_alone(mesh, op, sort)) << op.id << " seed " << seed;
        for (const ElementVerdict verdict : verdicts.all()) {
          legal += verdict == ElementVerdict::legal;
          refused += verdict == ElementVerdict::refused;
        }
      }
  }
  EXPECT_GT(legal, 100u);
  EXPECT_GT(refused, 100u);
}

// Edits, undos and redos, some while not all has been asked. What is not asked again has the verdict that it had.
TEST(tool_verdicts, follow_edits_as_if_all_were_asked_again) {
  int steps = 0;
  std::size_t again = 0, all = 0;
  const std::uint64_t seeds = test::seed_count(20, 40);
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    Mesh mesh = seed % 2 == 0 ? test::random_kernel_mesh(seed) : test::random_complex(seed);
    Journal journal;
    Dice dice(seed);
    std::vector<ToolVerdicts> followed;
    for (const OpInfo& op : all_ops())
      for (const Element::Kind sort : sorts)
        if (acts_on(op, sort)) followed.emplace_back(mesh, op, sort);
    for (ToolVerdicts& each : followed) {
      int patience = static_cast<int>(seed % 3);
      each.ask(mesh, [&] { return patience-- > 0; });
    }
    for (int step = 0; step < 12; ++step) {
      const auto done = test::random_step(mesh, journal, dice, 6, [&](int thrown) {
        return thrown < 4 ? test::edit_at_random(mesh, journal, dice)
                          : test::try_apply(mesh, &journal, test::random_op(mesh, dice));
      });
      if (!done) continue;
      ++steps;
      const TouchedElements touched = touched_elements(mesh, journal, *done);
      for (ToolVerdicts& each : followed) {
        if (touched.everything)
          each = ToolVerdicts(mesh, each.op(), each.sort());
        else
          each.follow(mesh, touched);
        each.ask(mesh);
        ASSERT_EQ(all_of(each), asked_alone(mesh, each.op(), each.sort()))
            << each.op().id << " seed " << seed << " step " << step;
        again += each.take_asked_again().size();
        all += each.all().size();
      }
    }
  }
  EXPECT_GT(steps, 5 * static_cast<int>(seeds));
  EXPECT_GT(again, 0u);
  EXPECT_LT(again, all);
}

TEST(tool_verdicts, ask_few_again_after_an_edit_of_a_large_mesh) {
  Mesh mesh = test::make_mesh(test::torus_grid(100, 100));
  Journal journal;
  ToolVerdicts verdicts(mesh, CollapseEdge::info, Element::Kind::edge);
  verdicts.ask(mesh);
  ASSERT_TRUE(test::try_apply(mesh, &journal, CollapseEdge{halfedge(Edge(mesh.edge_slots() / 2))}));
  verdicts.follow(mesh, touched_elements(mesh, journal, 0));
  EXPECT_FALSE(verdicts.is_complete());
  verdicts.ask(mesh);
  EXPECT_TRUE(verdicts.is_complete());
  const std::size_t again = verdicts.take_asked_again().size();
  EXPECT_GT(again, 20u);
  EXPECT_LT(again, 400u);
  EXPECT_TRUE(verdicts.take_asked_again().empty());
}

TEST(tool_verdicts, are_asked_a_part_at_a_time) {
  const Mesh mesh = test::make_mesh(test::torus_grid(30, 30));
  ToolVerdicts verdicts(mesh, CollapseEdge::info, Element::Kind::edge);
  int slices = 0;
  double share = -1;
  for (; !verdicts.is_complete(); ++slices) {
    EXPECT_GT(verdicts.share(), share);
    share = verdicts.share();
    verdicts.ask(mesh, [] { return false; });
  }
  EXPECT_GT(slices, 10);
  EXPECT_EQ(all_of(verdicts), asked_alone(mesh, CollapseEdge::info, Element::Kind::edge));
}

}  // namespace
}  // namespace ryosen
