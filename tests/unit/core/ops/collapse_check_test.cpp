// Duplicates that a collapse would make, beside high valences.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/ops/collapse_edge.h"
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
  for (std::uint64_t seed = 1; seed <= 6000; ++seed) {
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
  EXPECT_GT(found, 100u);
}

}  // namespace
}  // namespace ryosen
