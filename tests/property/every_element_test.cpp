// Every operator on every edge of small meshes: legal means a sound result and an exact undo, refused means no trace.

#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "core/analysis/euler_poincare.h"
#include "core/analysis/invariants.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/ops/remedy.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

std::vector<AnyOp> ops_on(Halfedge h) {
  return {CollapseEdge{h}, CollapseEdge{h, CollapseEdge::Place::middle}, SwapEdge{h, false}, SwapEdge{h, true},
          SplitEdge{h, 0.3}};
}

void prove(Mesh& mesh, const AnyOp& op) {
  const MeshColumns before = mesh.columns();
  const EulerPoincare terms = euler_poincare(mesh);
  const bool legal = check(mesh, op).legal();
  ASSERT_EQ(mesh.columns(), before);
  if (!legal) return;
  Journal journal;
  {
    Edit edit(mesh, &journal);
    apply(edit, op);
    edit.commit();
  }
  const auto broken = check_invariants(mesh);
  ASSERT_FALSE(broken) << command_of(mesh, op) << ": " << broken->sentence;
  const EulerPoincare after = euler_poincare(mesh);
  EXPECT_EQ(after.left(), after.right());
  if (!std::holds_alternative<SplitEdge>(op)) {
    EXPECT_EQ(after.boundaries, terms.boundaries);
    EXPECT_EQ(after.components, terms.components);
    EXPECT_EQ(after.genus, terms.genus);
  }
  journal.undo(mesh);
  ASSERT_EQ(mesh.columns(), before);
}

void prove_all(const Polygons& faces, std::size_t points) {
  Mesh mesh = make_mesh(faces, points);
  for (std::uint32_t h = 0; h < mesh.halfedge_slots(); ++h)
    for (const AnyOp& op : ops_on(Halfedge(h))) ASSERT_NO_FATAL_FAILURE(prove(mesh, op));
}

TEST(every_element, of_named_shapes) {
  for (const Polygons& faces : {tetrahedron(), cube(), torus_grid(4, 5), two_quads(), closed_fan(3), closed_fan(6),
                                bow_tie(), fin(), moebius_strip(), two_tetrahedra_on_an_edge(), Polygons{{0, 1, 2}},
                                Polygons{{0, 1, 2}, {0, 2, 1}}, Polygons{{0, 1, 2, 3, 4}}})
    prove_all(faces, 0);
}

TEST(every_element, of_random_meshes) {
  for (std::uint32_t seed = 1; seed <= 1500; ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    prove_all(random.faces, random.points);
  }
}

// Verdicts on a mesh alone and beside a bow-tie and a hanging pair elsewhere in the file.
TEST(every_element, a_defect_elsewhere_changes_no_verdict) {
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    const auto n = static_cast<std::uint32_t>(random.points);
    Polygons with_defects = random.faces;
    for (std::vector<std::uint32_t> face :
         {std::vector<std::uint32_t>{n, n + 1, n + 2}, {n, n + 3, n + 4}, {n + 5, n + 6, n + 7}, {n + 5, n + 7, n + 6}})
      with_defects.push_back(face);
    const Mesh alone = make_mesh(random.faces, random.points), beside = make_mesh(with_defects, n + 8);
    for (std::uint32_t f = 0; f < alone.face_slots(); ++f) {
      Halfedge other = beside.halfedge(Face(f));
      for (Halfedge h : halfedges_around(alone, Face(f))) {
        const std::vector<AnyOp> here = ops_on(h), there = ops_on(other);
        for (std::size_t i = 0; i < here.size(); ++i)
          EXPECT_EQ(check(alone, here[i]).legal(), check(beside, there[i]).legal()) << "seed " << seed;
        other = beside.next(other);
      }
    }
  }
}

TEST(every_element, a_named_remedy_helps) {
  std::map<std::string, std::size_t> helped, never;
  for (std::uint32_t seed = 1; seed <= 150; ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    Mesh mesh = make_mesh(random.faces, random.points);
    for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
      const AnyOp op = CollapseEdge{Halfedge(i)};
      const Verdict verdict = check(mesh, op);
      if (verdict.legal()) continue;
      const std::string rule(text_of(verdict.reasons[0].rule).id);
      const std::string line = command_of(mesh, op);
      const std::vector<std::string> remedy = find_remedy(mesh, op);
      ++(remedy.empty() ? never : helped)[rule];
      if (remedy.empty()) continue;
      Journal journal;
      for (const std::string& step : remedy) {
        const Parsed<AnyOp> parsed = parse_line(mesh, step);
        ASSERT_TRUE(parsed.op) << step;
        ASSERT_TRUE(check(mesh, *parsed.op).legal()) << step;
        Edit edit(mesh, &journal);
        apply(edit, *parsed.op);
        edit.commit();
      }
      const Parsed<AnyOp> again = parse_line(mesh, line);
      ASSERT_TRUE(again.op) << line;
      EXPECT_TRUE(check(mesh, *again.op).legal()) << line << " seed " << seed;
      while (journal.can_undo()) journal.undo(mesh);
    }
  }
  for (const auto& [rule, count] : helped)
    std::cout << rule << ": remedy " << count << ", never " << never[rule] << "\n";
  EXPECT_FALSE(helped.empty());
}

}  // namespace
}  // namespace ryosen
