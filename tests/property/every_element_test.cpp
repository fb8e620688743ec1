// Every operator on every edge of small meshes: legal means a sound result and an exact undo, refused means no trace.

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <set>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/preview/remedy.h"
#include "tests/support/core/kernel_sum.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/proof.h"
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
  const KernelSum terms = kernel_sum(mesh);
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
  const KernelSum after = kernel_sum(mesh);
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
  for (std::uint32_t seed = 1; seed <= seed_count(350, 1500); ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    prove_all(random.faces, random.points);
  }
}

// Verdicts on a mesh alone and beside a bow-tie and a hanging pair elsewhere in the file.
TEST(every_element, a_defect_elsewhere_changes_no_verdict) {
  for (std::uint32_t seed = 1; seed <= seed_count(300); ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    const auto n = static_cast<std::uint32_t>(random.points);
    Polygons with_defects = random.faces;
    for (const std::vector<std::uint32_t>& face :
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

// The operators of the list on everything that they can be clicked on, and on lists of up to three points.
std::vector<AnyOp> all_ops_on(const Mesh& mesh) {
  std::vector<AnyOp> ops;
  std::vector<std::string> points;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    if (mesh.is_alive(Vertex(i)) && point(mesh, Vertex(i)) == Vertex(i)) points.push_back(name_of(mesh, Vertex(i)));
  const auto add_line = [&](std::string_view id, std::vector<std::string_view> arguments) {
    const ParsedOp parsed = parse_op(mesh, id, op_arguments(arguments));
    if (parsed.op) ops.push_back(*parsed.op);
  };
  for (const OpInfo& info : all_ops()) {
    const auto is_for = [&](OpTargetKind kind) { return info.target == kind || info.target == OpTargetKind::any; };
    if (is_for(OpTargetKind::none)) add_line(info.id, {});
    for (std::uint32_t i = 0; is_for(OpTargetKind::vertex) && i < mesh.vertex_slots(); ++i)
      if (mesh.is_alive(Vertex(i))) ops.push_back(op_at(mesh, info.id, {.halfedge = {}, .vertex = Vertex(i)}));
    for (std::uint32_t i = 0; is_for(OpTargetKind::edge) && i < mesh.halfedge_slots(); ++i)
      if (mesh.is_alive(Halfedge(i))) ops.push_back(op_at(mesh, info.id, {.halfedge = Halfedge(i)}));
    for (std::uint32_t i = 0; is_for(OpTargetKind::face) && i < mesh.face_slots(); ++i)
      if (mesh.is_alive(Face(i))) ops.push_back(op_at(mesh, info.id, {.halfedge = {}, .face = Face(i)}));
    for (const std::string& a : points) {
      add_line(info.id, {a});
      for (const std::string& b : points) {
        if (info.target != OpTargetKind::selection || a == b) continue;
        add_line(info.id, {a, b});
        add_line(info.id, {a, b, "-"});
        for (const std::string& c : points)
          if (c != a && c != b) add_line(info.id, {a, b, c});
      }
    }
  }
  return ops;
}

struct Counts {
  std::size_t legal = 0, refused = 0;
};

// The operators of the texts are about the columns: what they leave at a point need not be what reading makes of it.
bool is_of_the_texts(const AnyOp& op) {
  static const std::set<std::string_view> ids{
      "make_vertex", "remove_vertex", "move_vertex",   "make_edge",  "delete_edge", "make_loop", "delete_loop",
      "unite_loop",  "separate_loop", "separate_edge", "unite_edge", "make_ring",   "unite_ring"};
  return ids.contains(info_of(op).id);
}

void prove_on_columns(Mesh& mesh, const AnyOp& op) {
  const std::string line = command_of(mesh, op);
  const MeshColumns before = mesh.columns();
  Journal journal;
  {
    Edit edit(mesh, &journal);
    apply(edit, op);
    edit.commit();
  }
  const auto broken = check_invariants(mesh);
  ASSERT_FALSE(broken) << line << ": " << broken->sentence;
  const KernelSum terms = kernel_sum(mesh);
  EXPECT_EQ(terms.left(), terms.right()) << line;
  const MeshColumns after = mesh.columns();
  journal.undo(mesh);
  ASSERT_EQ(mesh.columns(), before) << line;
  journal.redo(mesh);
  ASSERT_EQ(mesh.columns(), after) << line;
}

void prove_every_op(const Mesh& mesh, std::map<std::string, Counts>& counts) {
  std::size_t asked = 0;
  for (const AnyOp& op : all_ops_on(mesh)) {
    if (is_sample() && asked++ % 3 != 0) continue;
    Mesh copy = mesh;
    Counts& count = counts[std::string(info_of(op).id)];
    if (check(copy, op).legal()) {
      ++count.legal;
      is_of_the_texts(op) ? prove_on_columns(copy, op) : static_cast<void>(apply_and_prove(copy, op));
    } else {
      ++count.refused;
      ASSERT_EQ(copy.columns(), mesh.columns());
    }
    if (testing::Test::HasFailure()) return;
  }
}

// A mesh by the lines that make it of another one.
Mesh mesh_by(const Polygons& faces, std::initializer_list<const char*> lines) {
  Mesh mesh = make_mesh(faces);
  for (const char* line : lines) {
    const AnyOp op = op_of(mesh, line);
    EXPECT_TRUE(check(mesh, op).legal()) << line;
    Edit edit(mesh, nullptr);
    apply(edit, op);
    edit.commit();
  }
  return mesh;
}

TEST(every_element, every_operator_leaves_sound_columns_and_no_other_trace) {
  const std::vector<Mesh> meshes{
      make_mesh(tetrahedron()),
      make_mesh(cube()),
      make_mesh(two_quads()),
      make_mesh(closed_fan(4)),
      make_mesh(bow_tie()),
      make_mesh(fin()),
      make_mesh(moebius_strip()),
      make_mesh(two_tetrahedra_on_an_edge()),
      make_mesh({{0, 1, 2}, {0, 2, 1}}),
      // A ring with a face in it, the same ring by a bridge, wires at a face and between two, a vertex with two fans.
      mesh_by({{0, 1, 2, 3}, {4, 5, 6}},
              {"move_vertex 0 0,0,0", "move_vertex 1 9,0,0", "move_vertex 2 9,9,0", "move_vertex 3 0,9,0",
               "move_vertex 4 4,4,0", "move_vertex 5 5,4,0", "move_vertex 6 4,5,0"}),
      mesh_by({{0, 1, 2, 3, 0, 4, 6, 5, 4}, {4, 5, 6}}, {}),
      mesh_by({{0, 1, 2, 3, 0, 4, 6, 5, 4}, {4, 5, 6}}, {"make_ring 0-4"}),
      mesh_by({{0, 1, 2}, {3, 4, 5}}, {"make_edge 0 3", "make_vertex 1,2,3", "make_edge 1 6"}),
  };
  std::map<std::string, Counts> counts;
  for (std::size_t i = 0; i < meshes.size(); i += is_sample() ? 6 : 1) {
    SCOPED_TRACE("mesh " + std::to_string(i));
    ASSERT_NO_FATAL_FAILURE(prove_every_op(meshes[i], counts));
    if (HasFailure()) return;
  }
  for (std::uint32_t seed = 1; seed <= seed_count(10, 40); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SeededMesh random = seeded_mesh(seed);
    if (random.points > 9) continue;
    ASSERT_NO_FATAL_FAILURE(prove_every_op(make_mesh(random.faces, random.points), counts));
    if (HasFailure()) return;
  }
  for (const auto& [id, count] : counts)
    std::cout << id << ": legal " << count.legal << ", refused " << count.refused << "\n";
}

TEST(every_element, a_named_remedy_helps) {
  std::map<std::string, std::size_t> helped, never;
  for (std::uint32_t seed = 1; seed <= seed_count(150); ++seed) {
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
        const ParsedOp parsed = parse_line(mesh, step);
        ASSERT_TRUE(parsed.op) << step;
        ASSERT_TRUE(check(mesh, *parsed.op).legal()) << step;
        Edit edit(mesh, &journal);
        apply(edit, *parsed.op);
        edit.commit();
      }
      const ParsedOp again = parse_line(mesh, line);
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
