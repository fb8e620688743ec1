// The local operators that build up, done on plain lists of copies and judged by the rules of a verdict: the kernel
// must allow what leaves no violation and nothing else, and come to the same list.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <set>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/kernel_lists.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/oracle/local_operators.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen {
namespace {

using namespace test;
using oracle::CopyList;
using oracle::Corners;
using oracle::Facts;
using oracle::LocalOutcome;
using oracle::LocalOutcomes;
using oracle::PolygonList;

struct LocalCount {
  int legal = 0, refused = 0;
};

class LocalComparison {
 public:
  LocalComparison(const PolygonList& points, std::uint64_t seed)
      : mesh_(kernel_mesh(points, seed)),
        copies_(oracle::read_copies(points)),
        facts_(oracle::facts_of(copies_)),
        name_("seed " + std::to_string(seed) + " " + to_text(points)) {}

  const Mesh& mesh() const { return mesh_; }
  const CopyList& copies() const { return copies_; }
  const Facts& facts() const { return facts_; }

  void compare(const AnyOp& op, const LocalOutcomes& outcomes, std::map<std::string, LocalCount>& counts) {
    LocalOutcomes good;
    for (const LocalOutcome& outcome : outcomes)
      if (is_legal(facts_, outcome)) good.push_back(outcome);
    const Verdict verdict = check(mesh_, op);
    LocalCount& count = counts[std::string(info_of(op).id)];
    ++(verdict.legal() ? count.legal : count.refused);
    const std::string line = command_of(mesh_, op);
    ASSERT_EQ(verdict.legal(), !good.empty())
        << line << " " << (verdict.legal() ? "" : text_of(verdict.reasons[0].rule).id) << "\n"
        << name_;
    if (!verdict.legal()) return;
    const MeshColumns before = mesh_.columns();
    Journal journal;
    {
      Edit edit(mesh_, &journal);
      apply(edit, op);
      edit.commit();
    }
    const auto broken = check_invariants(mesh_);
    ASSERT_FALSE(broken) << line << ": " << broken->sentence << "\n" << name_;
    const PolygonList found = list_of(mesh_, false);
    bool is_one_of_them = false;
    for (const LocalOutcome& outcome : good) is_one_of_them = is_one_of_them || is_same(outcome.list.list, found);
    ASSERT_TRUE(is_one_of_them) << line << "\n"
                                << name_ << "\ngives " << to_text(found) << "\nnot " << to_text(good[0].list.list);
    journal.undo(mesh_);
    ASSERT_EQ(mesh_.columns(), before) << line << "\n" << name_;
  }

 private:
  // Faces that were new in a triangulation may come in any order.
  static bool is_same(const PolygonList& one, const PolygonList& other) {
    if (one.live != other.live || one.faces.size() != other.faces.size()) return false;
    std::vector<Corners> a, b;
    for (const Corners& face : one.faces) a.push_back(oracle::rotated(face));
    for (const Corners& face : other.faces) b.push_back(oracle::rotated(face));
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    return a == b;
  }

  Mesh mesh_;
  CopyList copies_;
  Facts facts_;
  std::string name_;
};

void compare_all(LocalComparison& c, std::map<std::string, LocalCount>& counts) {
  const Mesh& mesh = c.mesh();
  const std::uint32_t faces = mesh.face_slots(), edges = mesh.edge_slots(), vertices = mesh.vertex_slots();
  for (std::uint32_t f = 0; f < faces; ++f) {
    const int face = static_cast<int>(f);
    ASSERT_NO_FATAL_FAILURE(c.compare(Poke{Face(f)}, oracle::poke(c.copies(), face), counts));
    ASSERT_NO_FATAL_FAILURE(c.compare(Extrude{{Face(f)}}, oracle::extrude(c.copies(), face), counts));
    ASSERT_NO_FATAL_FAILURE(c.compare(Triangulate{Face(f)}, oracle::triangulate(c.copies(), face), counts));
  }
  for (std::uint32_t e = 0; e < edges; ++e) {
    const auto [a, b] = ends(mesh, Edge(e));
    const LocalOutcomes outcomes =
        oracle::dissolve_edge(c.copies(), static_cast<int>(a.index), static_cast<int>(b.index));
    ASSERT_NO_FATAL_FAILURE(c.compare(Dissolve{halfedge(Edge(e))}, outcomes, counts));
  }
  for (std::uint32_t i = 0; i < vertices; ++i) {
    const Vertex v(i);
    const int number = static_cast<int>(i);
    ASSERT_NO_FATAL_FAILURE(c.compare(Dissolve{{}, v}, oracle::dissolve_vertex(c.copies(), number, c.facts()), counts));
    std::vector<Halfedge> around{Halfedge()};
    for (Halfedge h : outgoing(mesh, v)) around.push_back(h);
    for (Halfedge left : around) {
      for (Halfedge right : around) {
        if (left == right) continue;
        const auto end = [&](Halfedge h) { return h ? static_cast<int>(mesh.to(h).index) : -1; };
        const LocalOutcomes outcomes = oracle::vertex_split(c.copies(), number, end(left), end(right));
        ASSERT_NO_FATAL_FAILURE(c.compare(VertexSplit{v, left, right}, outcomes, counts));
      }
    }
  }
}

void report(const std::map<std::string, LocalCount>& counts) {
  for (const auto& [id, count] : counts) {
    std::cout << id << ": legal " << count.legal << ", refused " << count.refused << "\n";
    EXPECT_GT(count.legal, 0) << id;
    EXPECT_GT(count.refused, 0) << id;
  }
}

TEST(local_oracle, every_verdict_and_every_result_on_random_meshes) {
  std::map<std::string, LocalCount> counts;
  const std::uint64_t seeds = test::is_long_run() ? 6000 : 70;
  for (std::uint64_t seed = 0; seed < seeds && !HasFatalFailure(); ++seed) {
    RandomMesh random = random_mesh(seed);
    LocalComparison comparison(oracle::polygon_list(random.points, std::move(random.faces)), seed);
    compare_all(comparison, counts);
  }
  report(counts);
}

TEST(local_oracle, larger_manifolds) {
  std::map<std::string, LocalCount> counts;
  for (std::uint64_t seed = 0; seed < (test::is_long_run() ? 12u : 3u) && !HasFatalFailure(); ++seed) {
    RandomMesh random = random_manifold(seed, 20 + static_cast<int>(seed));
    LocalComparison comparison(oracle::polygon_list(random.points, std::move(random.faces)), seed);
    compare_all(comparison, counts);
  }
  EXPECT_FALSE(counts.empty());
}

}  // namespace
}  // namespace ryosen
