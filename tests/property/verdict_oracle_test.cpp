// The kernel's verdicts and results held against the brute-force oracle on many small random meshes.
#include <gtest/gtest.h>

#include <algorithm>

#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/mesh/journal.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/split_edge.h"
#include "ryosen/ops/swap_edge.h"
#include "tests/support/core/kernel_lists.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/oracle/comparison.h"
#include "tests/support/core/oracle/figures.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen {
namespace {

using namespace test;
using oracle::Kind;
using oracle::Operation;
using oracle::PolygonList;

constexpr int max_oracle_reports = 10;

template <class Visit>
auto with_operator(const Mesh& mesh, const Operation& operation, Visit visit) {
  const Halfedge h = halfedge_of(mesh, operation);
  if (operation.kind == Kind::collapse) return visit(CollapseEdge{h});
  if (operation.kind == Kind::split) return visit(SplitEdge{h});
  return visit(SwapEdge{h, operation.kind == Kind::swap_back});
}

bool kernel_verdict(const Mesh& mesh, const Operation& operation) {
  return with_operator(mesh, operation, [&](const auto& op) { return op.check(mesh).legal(); });
}

void kernel_apply(Mesh& mesh, Journal& journal, const Operation& operation, bool commit) {
  with_operator(mesh, operation, [&](const auto& op) {
    Edit edit(mesh, &journal);
    op.apply(edit);
    if (commit) edit.commit();
  });
}

// Faces up to where they start. New faces of a split of several sheets may come in any order; where the kernel numbers
// the new point is its own affair as long as the number was free.
bool same_result(PolygonList expected, const PolygonList& found, const PolygonList& before, bool any_order) {
  const auto point_number = [&](const PolygonList& list) {
    for (int p = 0; p < list.size(); ++p)
      if (list.live[p] && (p >= before.size() || !before.live[p])) return p;
    return -1;
  };
  const int expected_number = point_number(expected), found_number = point_number(found);
  for (oracle::Corners& face : expected.faces) std::replace(face.begin(), face.end(), expected_number, found_number);
  for (int p = 0; p < before.size(); ++p)
    if (expected.live[p] != found.live[p]) return false;
  if (std::count(expected.live.begin(), expected.live.end(), 1) != std::count(found.live.begin(), found.live.end(), 1))
    return false;
  if (expected.faces.size() != found.faces.size()) return false;
  std::vector<oracle::Corners> one, other;
  for (const oracle::Corners& face : expected.faces) one.push_back(oracle::rotated(face));
  for (const oracle::Corners& face : found.faces) other.push_back(oracle::rotated(face));
  if (any_order) {
    const auto new_faces = static_cast<std::ptrdiff_t>(before.faces.size());
    std::sort(one.begin() + new_faces, one.end());
    std::sort(other.begin() + new_faces, other.end());
  }
  return one == other;
}

// What is wrong with the kernel after doing one legal operation, empty if nothing. The mesh is left as it was.
std::string judge_result(Mesh& mesh, const oracle::Judge& judge, const PolygonList& points,
                         const Operation& operation) {
  const MeshColumns before = mesh.columns();
  Journal journal;
  kernel_apply(mesh, journal, operation, false);
  if (!(mesh.columns() == before)) return "an edit without commit leaves a trace";
  kernel_apply(mesh, journal, operation, true);
  if (const auto broken = check_invariants(mesh)) return "invariant " + broken->sentence;
  const PolygonList found = list_of(mesh, true);
  const PolygonList expected = oracle::points_of(*oracle::apply(judge.list(), operation));
  const bool cut = judge.reasons({Kind::swap, operation.from, operation.to}) == oracle::Reasons{oracle::not_one_edge};
  std::string wrong;
  if (!same_result(expected, found, points, cut)) {
    wrong = "result " + to_text(found) + "\n    expected " + to_text(expected);
  } else if (oracle::fans_as_listed(list_of(mesh, false)) != oracle::fans_as_read(found)) {
    wrong = "reading the points of the result gives other fans: " + to_text(list_of(mesh, false));
  }
  const MeshColumns after = mesh.columns();
  journal.undo(mesh);
  if (!(mesh.columns() == before)) return "undo is not exact";
  journal.redo(mesh);
  if (!(mesh.columns() == after)) return "redo is not exact";
  journal.undo(mesh);
  return wrong;
}

PolygonList random_list(std::uint64_t seed) {
  RandomMesh mesh = random_mesh(seed);
  return oracle::polygon_list(mesh.points, std::move(mesh.faces));
}

TEST(verdict_oracle, reading_gives_the_same_copies) {
  for (std::uint64_t seed = 0; seed < (test::is_long_run() ? 20000u : 1500u); ++seed) {
    const PolygonList points = random_list(seed);
    const oracle::CopyList expected = oracle::read_copies(points);
    const Mesh mesh = kernel_mesh(points, seed);
    ASSERT_TRUE(same_list(list_of(mesh, false), expected.list)) << "seed " << seed << " " << to_text(points);
    for (int v = 0; v < expected.list.size(); ++v)
      ASSERT_EQ(static_cast<int>(point(mesh, Vertex(static_cast<std::uint32_t>(v))).index), expected.point_of[v]);
    ASSERT_FALSE(check_invariants(mesh)) << "seed " << seed;
  }
}

TEST(verdict_oracle, every_operation_on_every_edge) {
  std::uint64_t meshes = 0;
  int verdicts = 0, reports = 0;
  const std::uint64_t seeds = test::is_long_run() ? 20000 : 250;
  for (std::uint64_t seed = 0; seed < seeds && reports < max_oracle_reports; ++seed) {
    const PolygonList points = random_list(seed);
    const Mesh mesh = kernel_mesh(points, seed);
    const auto kernel = [&](const Operation& operation) {
      ++verdicts;
      return kernel_verdict(mesh, operation);
    };
    for (const oracle::Disagreement& disagreement : compare(points, kernel)) {
      if (++reports > max_oracle_reports) break;
      ADD_FAILURE() << "seed " << seed << ": " << to_text(disagreement);
    }
    ++meshes;
  }
  EXPECT_EQ(meshes, seeds);
  EXPECT_GT(verdicts, 50 * static_cast<int>(seeds));
}

TEST(verdict_oracle, larger_manifolds) {
  int reports = 0;
  for (std::uint64_t seed = 0; seed < (test::is_long_run() ? 30u : 5u) && reports < max_oracle_reports; ++seed) {
    RandomMesh random = random_manifold(seed, 30 + static_cast<int>(seed));
    const PolygonList points = oracle::polygon_list(random.points, std::move(random.faces));
    const oracle::Figures figures = oracle::figures_of(points);
    ASSERT_TRUE(figures.manifold && figures.misoriented_edges == 0 && figures.faces >= 30 + static_cast<int>(seed) - 1);
    const Mesh mesh = kernel_mesh(points, seed);
    const auto found = compare(points, [&](const Operation& operation) { return kernel_verdict(mesh, operation); });
    for (const oracle::Disagreement& disagreement : found) {
      if (++reports > max_oracle_reports) break;
      ADD_FAILURE() << "seed " << seed << ": " << to_text(disagreement);
    }
  }
}

TEST(verdict_oracle, legal_operations_give_the_list_of_the_oracle) {
  int reports = 0, applied = 0;
  const std::uint64_t seeds = test::is_long_run() ? 5000 : 120;
  for (std::uint64_t seed = 0; seed < seeds && reports < max_oracle_reports; ++seed) {
    const PolygonList points = random_list(seed);
    Mesh mesh = kernel_mesh(points, seed);
    const oracle::Judge judge(oracle::read_copies(points));
    for (const Operation& operation : oracle::operations_of(points)) {
      if (!kernel_verdict(mesh, operation) || !judge.legal(operation)) continue;
      ++applied;
      const std::string wrong = judge_result(mesh, judge, points, operation);
      if (wrong.empty()) continue;
      if (++reports > max_oracle_reports) break;
      ADD_FAILURE() << "seed " << seed << ": " << to_text(operation) << " on " << to_text(points) << "\n    " << wrong;
    }
  }
  EXPECT_GT(applied, 10 * static_cast<int>(seeds));
}

// After edits the mesh has dead slots and copies in other slots than a reader gives them; verdicts depend on the points
// alone.
TEST(verdict_oracle, verdicts_after_edits_are_those_of_the_saved_mesh) {
  int reports = 0, steps = 0;
  const std::uint64_t seeds = test::is_long_run() ? 400 : 20;
  for (std::uint64_t seed = 0; seed < seeds && reports < max_oracle_reports; ++seed) {
    Mesh mesh = kernel_mesh(random_list(seed), seed);
    Journal journal;
    Dice dice(seed);
    for (int step = 0; step < 12 && reports < max_oracle_reports; ++step) {
      const PolygonList points = list_of(mesh, true);
      const auto found = compare(points, [&](const Operation& operation) { return kernel_verdict(mesh, operation); });
      for (const oracle::Disagreement& disagreement : found) {
        if (++reports > max_oracle_reports) break;
        ADD_FAILURE() << "seed " << seed << " step " << step << ": " << to_text(disagreement);
      }
      std::vector<Operation> legal;
      for (const Operation& operation : oracle::operations_of(points))
        if (kernel_verdict(mesh, operation)) legal.push_back(operation);
      if (legal.empty()) break;
      kernel_apply(mesh, journal, legal[dice.below(static_cast<int>(legal.size()))], true);
      ++steps;
    }
  }
  EXPECT_GT(steps, 5 * static_cast<int>(seeds));
}

}  // namespace
}  // namespace ryosen
