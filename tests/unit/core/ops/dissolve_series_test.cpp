#include "ryosen/ops/dissolve_series.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/all.h"
#include "ryosen/ops/each.h"
#include "ryosen/ops/rules/surgery.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/ugly_meshes.h"

namespace ryosen {
namespace {

using namespace test;

// The values at the corners of the live faces, in the order of their slots.
std::vector<std::uint32_t> corner_values(const Mesh& m) {
  std::vector<std::uint32_t> values;
  for (const CornerAttribute& attribute : corner_attributes(m))
    for (std::uint32_t i = 0; i < m.face_slots(); ++i)
      if (m.is_alive(Face(i)))
        for (const Halfedge h : halfedges_around(m, Face(i)))
          values.push_back(m.attributes()[attribute.index_column].data[h.index]);
  return values;
}

Mesh with_corner_values(const SeededMesh& seeded) {
  IndexedMesh source = indexed(seeded.faces, seeded.points);
  source.texcoords.components = 2;
  for (std::size_t i = 0; i < source.corners.size(); ++i) {
    const std::size_t face = i / 3;
    source.texcoords.pool.emplace_back(static_cast<double>(face), 0, 0);
    source.texcoords.index.push_back(static_cast<std::uint32_t>(i));
  }
  return from_indexed(std::move(source));
}

// Edges, and here and there or every other time a vertex, in a random order with repetitions: each judged and done as
// by itself. Where it is strict, warnings refuse too.
void expect_same_as_one_by_one(const Mesh& start, Dice& dice) {
  const bool is_strict = dice.one_in(2);
  const int of_vertices = dice.one_in(3) ? 2 : 20;
  Mesh single = start, many = start;
  Journal journal;
  {
    Edit edit(many, &journal);
    DissolveSeries series(edit);
    for (std::uint32_t call = 0; call < 4 * start.edge_slots(); ++call) {
      Dissolve op{random_halfedge(single, dice)};
      if (dice.one_in(of_vertices)) op = {{}, random_vertex(single, dice)};
      std::vector<Reason> reasons = op.check(single).reasons;
      if (is_strict && reasons.empty()) reasons = op.warnings(single);
      std::optional<Rule> rule = series.broken_rule(op);
      if (is_strict && !rule) rule = series.doubt(op);
      ASSERT_EQ(rule, reasons.empty() ? std::nullopt : std::optional(reasons[0].rule)) << command_of(single, op);
      if (rule) continue;
      series.apply(op);
      Edit once(single, nullptr);
      op.apply(once);
      once.commit();
    }
    series.finish();
    edit.commit();
  }
  EXPECT_EQ(many.hash(), single.hash());
  EXPECT_EQ(many.live(), single.live());
  EXPECT_EQ(corner_values(many), corner_values(single));
  const auto broken = check_invariants(many);
  EXPECT_FALSE(broken) << broken->sentence;
  journal.undo(many);
  EXPECT_EQ(many.hash(), start.hash());
}

TEST(dissolve_series, judges_and_does_what_one_call_after_the_other_does) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    expect_same_as_one_by_one(seed % 3 == 0 ? random_complex(seed) : with_corner_values(seeded_mesh(seed)), dice);
    if (HasFatalFailure()) return;
  }
}

TEST(dissolve_series, of_a_torus_whose_faces_come_together_from_all_sides) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Polygons faces = torus_grid(7, 8);
    for (std::size_t i = faces.size(); i > 1; --i)
      std::swap(faces[i - 1], faces[static_cast<std::size_t>(dice.below(static_cast<int>(i)))]);
    expect_same_as_one_by_one(with_corner_values({faces, 56}), dice);
    if (HasFatalFailure()) return;
  }
}

// All edges in ascending order, over and over while that does anything, as the editor asks for selected faces.
std::uint64_t looks_at(const Polygons& faces, std::size_t points) {
  Mesh mesh = make_mesh(faces, points);
  Journal journal;
  Edit edit(mesh, &journal);
  DissolveSeries series(edit);
  for (bool is_done = true; is_done;) {
    is_done = false;
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
      const Dissolve op{halfedge(Edge(i), 0)};
      if (!mesh.is_alive(Edge(i)) || series.broken_rule(op)) continue;
      series.apply(op);
      is_done = true;
    }
  }
  series.finish();
  EXPECT_LT(mesh.live().faces, 5u) << "else nothing has grown";
  return series.looks();
}

// Each face lower than the one before, so that the face that grows would change its number each time.
Polygons strip(std::uint32_t quads) {
  Polygons faces;
  for (std::uint32_t i = quads; i-- > 0;) faces.push_back({i, i + 1, quads + i + 2, quads + i + 1});
  return faces;
}

TEST(dissolve_series, cost_grows_with_what_is_near_the_edges) {
  const auto expect_growth = [](const char* what, std::uint64_t small, std::uint64_t large) {
    EXPECT_GT(small, 100u) << what;
    EXPECT_LE(large, 5 * small) << what << ": four times the faces";
  };
  expect_growth("strip", looks_at(strip(500), 1002), looks_at(strip(2000), 4002));
  expect_growth("fan", looks_at(closed_fan(500), 501), looks_at(closed_fan(2000), 2001));
  expect_growth("torus", looks_at(torus_grid(20, 25), 500), looks_at(torus_grid(40, 50), 2000));
}

// All vertices in ascending order.
std::uint64_t looks_at_vertices(const Mesh& start) {
  Mesh mesh = start;
  Edit edit(mesh, nullptr);
  DissolveSeries series(edit);
  std::size_t done = 0;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    if (!mesh.is_alive(Vertex(i)) || has_two_edges(mesh, Vertex(i))) continue;
    const Dissolve op{{}, Vertex(i)};
    if (series.broken_rule(op)) continue;
    series.apply(op);
    ++done;
  }
  series.finish();
  edit.commit();
  EXPECT_GT(done, 0u);
  return series.looks();
}

TEST(dissolve_series, cost_grows_with_what_is_near_the_vertices) {
  for (const auto family : {bipyramid, fan, sliver_fan, clean_grid}) {
    const std::uint64_t small = looks_at_vertices(from_indexed(family(500))),
                        large = looks_at_vertices(from_indexed(family(2000)));
    EXPECT_LE(large, 5 * small + 1000) << "four times the faces";
  }
}

// Two faces on one ring of points, at each edge of which the whole ring lies between them.
TEST(dissolve_series, of_two_faces_on_one_ring_is_refused_at_the_cost_of_one_look) {
  const auto looks = [](std::uint32_t n) {
    std::vector<std::uint32_t> front, back;
    for (std::uint32_t i = 0; i < n; ++i) front.push_back(i);
    back.assign(front.rbegin(), front.rend());
    Mesh mesh = make_mesh({front, back}, n);
    Edit edit(mesh, nullptr);
    DissolveSeries series(edit);
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) EXPECT_TRUE(series.broken_rule({halfedge(Edge(i), 0)}));
    return series.looks();
  };
  EXPECT_LE(looks(2000), 5 * looks(500));
}

TEST(dissolve_series, of_a_selection_leaves_the_lowest_number) {
  Mesh mesh = make_mesh(strip(5), 12);
  std::vector<Element> faces;
  for (std::uint32_t i = 0; i < 5; ++i) faces.push_back(Face(i));
  Edit edit(mesh, nullptr);
  Progress progress;
  const EachResult result = apply_to_each(edit, Dissolve::info, faces, {}, false, progress);
  edit.commit();
  EXPECT_EQ(result.done, 4u);
  EXPECT_EQ(mesh.live().faces, 1u);
  EXPECT_TRUE(mesh.is_alive(Face(0)));
}

}  // namespace
}  // namespace ryosen
