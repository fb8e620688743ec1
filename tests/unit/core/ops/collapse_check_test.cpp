// Duplicates that a collapse would make, beside high valences.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// Two vertices 0 and 1, joined by an edge, each the hub of `quads` quads that lie side by side around it. Around 0 they
// close; around 1 they leave a gap.
Polygons two_hubs(std::uint32_t quads) {
  Polygons faces;
  std::uint32_t next = 2;
  const std::uint32_t last_of_1 = next++;
  std::uint32_t spoke = last_of_1;
  for (std::uint32_t i = 0; i < quads; ++i) {
    const std::uint32_t tip = next++, end = i + 1 < quads ? next++ : 1;
    faces.push_back({0, spoke, tip, end});
    spoke = end;
  }
  spoke = next++;
  for (std::uint32_t i = 0; i + 1 < quads; ++i) {
    const std::uint32_t tip = next++, end = next++;
    faces.push_back({1, spoke, tip, end});
    spoke = end;
  }
  faces.push_back({1, spoke, last_of_1, 0});
  return faces;
}

TEST(collapse_check, two_hubs_of_quads) {
  const Mesh mesh = make_mesh(two_hubs(1500));
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 0)})
    EXPECT_TRUE((CollapseEdge{find_halfedge(mesh, Vertex(a), Vertex(b))}).check(mesh).legal());
}

// The points of a face before (gone == kept) or after the collapse, each once.
std::set<std::uint32_t> points_of(const Mesh& mesh, Face f, Vertex gone, Vertex kept) {
  std::set<std::uint32_t> points;
  for (Vertex v : vertices_around(mesh, f)) points.insert(point(mesh, v == gone ? kept : v).index);
  return points;
}

// Every pair of faces that would lie on the same points and did not before, in the order around the two ends.
std::vector<Reason> duplicates_by_pairs(const Mesh& mesh, Halfedge h) {
  const Vertex gone = mesh.from(h), kept = mesh.to(h);
  const auto at_edge = [&](Face f) { return f == mesh.face(h) || f == mesh.face(twin(h)); };
  std::vector<Reason> reasons;
  for (Halfedge g : outgoing(mesh, gone)) {
    for_each_copy(mesh, kept, [&](Vertex copy) {
      for (Halfedge k : outgoing(mesh, copy)) {
        if (mesh.is_outside(g) || mesh.is_outside(k)) continue;
        const Face a = mesh.face(g), b = mesh.face(k);
        const auto after = points_of(mesh, a, gone, kept);
        if (a == b || (at_edge(a) && at_edge(b) && a < b) || after.size() < 3) continue;
        if (after == points_of(mesh, b, gone, kept) && points_of(mesh, a, kept, kept) != points_of(mesh, b, kept, kept))
          reasons.push_back({Rule::duplicate_face, {std::min(a, b), std::max(a, b)}});
      }
    });
  }
  return reasons;
}

TEST(collapse_check, names_each_pair_of_duplicates) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= seed_count(800, 6000); ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    const Mesh mesh = make_mesh(random.faces, random.points);
    for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
      const CollapseEdge op{Halfedge(i)};
      const std::vector<Reason> reasons = op.judge(mesh).reasons;
      if (!reasons.empty() && reasons[0].rule != Rule::duplicate_face) continue;  // judged only where all else is right
      ASSERT_EQ(reasons, duplicates_by_pairs(mesh, op.directed(mesh))) << "seed " << seed << " h" << i;
      found += reasons.size();
    }
  }
  EXPECT_GT(found, is_long_run() ? 100u : 13u);
}

void do_line(Mesh& mesh, std::string_view line) {
  const ParsedOp parsed = parse_line(mesh, line);
  ASSERT_TRUE(parsed.op) << line << ": " << parsed.sentence.en;
  ASSERT_TRUE(check(mesh, *parsed.op).legal()) << line;
  Edit edit(mesh, nullptr);
  apply(edit, *parsed.op);
  edit.commit();
}

// Face 2 has a ring that a bridge joins to its outer loop: eight corners on the six points that face 0 would lie on.
TEST(collapse_check, finds_a_duplicate_among_faces_with_a_bridge) {
  IndexedMesh source = indexed({{0, 2, 3, 4, 5, 6}, {0, 1, 9, 8, 2}, {1, 3, 5, 1, 4, 2, 6, 4}});
  source.bridged = {2};
  Mesh mesh = from_indexed(source);
  ASSERT_TRUE(mesh.has_rings(Face(2)));
  const auto reasons = [&] { return CollapseEdge{find_halfedge(mesh, Vertex(0), Vertex(1))}.judge(mesh).reasons; };
  const std::vector<Reason> expected{{Rule::duplicate_face, {Face(0), Face(2)}}};
  EXPECT_EQ(reasons(), expected);
  do_line(mesh, "unite_ring 1 4 f2");
  ASSERT_FALSE(mesh.has_rings(Face(2)));
  EXPECT_EQ(reasons(), expected);
}

// The wire ends at a copy of point 2 without a face; the fan of point 2 is at another copy.
TEST(collapse_check, a_wire_to_a_bare_copy_joins_the_fans_of_the_points) {
  Mesh mesh = make_mesh({{0, 1, 2}, {2, 3, 4}, {5, 6, 7}});
  const Vertex copy(8);
  ASSERT_EQ(point(mesh, copy), Vertex(2));
  do_line(mesh, "delete_loop f1");
  ASSERT_EQ(count_fans(mesh, copy), 0u);
  const MakeEdge wire{Vertex(5), copy, mesh.prev(mesh.halfedge(Vertex(5))), mesh.prev(mesh.halfedge(copy))};
  const Halfedge into = Halfedge(mesh.halfedge_slots());
  ASSERT_TRUE(wire.check(mesh).legal());
  Edit edit(mesh, nullptr);
  wire.apply(edit);
  edit.commit();
  for (Halfedge h : {into, twin(into)}) EXPECT_TRUE(CollapseEdge{h}.check(mesh).has(Rule::joins_fans));
}

}  // namespace
}  // namespace ryosen
