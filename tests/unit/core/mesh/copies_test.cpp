#include "ryosen/mesh/copies.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/ugly_meshes.h"

namespace ryosen {
namespace {

TEST(copies, points_are_joined_where_there_is_a_sheet_between_them) {
  std::size_t joined = 0, pairs = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Mesh mesh = test::random_complex(seed);
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
      for (std::uint32_t k = 0; k < mesh.vertex_slots(); ++k) {
        const Vertex a(i), b(k);
        if (!mesh.is_alive(a) || !mesh.is_alive(b) || same_point(mesh, a, b)) continue;
        ASSERT_EQ(are_joined(mesh, a, b), !sheets_between(mesh, a, b).empty())
            << "seed " << seed << " " << i << " " << k;
        joined += are_joined(mesh, a, b);
        ++pairs;
      }
  }
  EXPECT_GT(joined, 1000u);
  EXPECT_GT(pairs, 2 * joined);
}

// Walks around all copies, in their order.
std::vector<Halfedge> all_sheets(const Mesh& mesh, Vertex a, Vertex b) {
  std::vector<Halfedge> sheets;
  for_each_copy(mesh, a, [&](Vertex copy) {
    for (Halfedge h : outgoing(mesh, copy))
      if (same_point(mesh, mesh.to(h), b)) sheets.push_back(h);
  });
  return sheets;
}

TEST(copies, queries_of_two_points_answer_as_a_walk_around_one) {
  std::size_t several = 0, nonmanifold = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Mesh mesh = test::random_complex(seed);
    for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
      const Halfedge h(i);
      if (!mesh.is_alive(h)) continue;
      const std::vector<Halfedge> sheets = all_sheets(mesh, mesh.from(h), mesh.to(h));
      ASSERT_EQ(sheets_between(mesh, mesh.from(h), mesh.to(h)), sheets) << "seed " << seed << " h" << i;
      PointEdge all;
      for (Halfedge sheet : sheets) {
        all.forward += !mesh.is_outside(sheet);
        all.backward += !mesh.is_outside(twin(sheet));
      }
      const PointEdge found = point_edge(mesh, h);
      ASSERT_EQ(found.is_nonmanifold(), all.is_nonmanifold());
      const auto counts = [](const PointEdge& edge) { return std::pair(edge.forward, edge.backward); };
      ASSERT_TRUE(all.is_nonmanifold() || counts(found) == counts(all));
      ASSERT_EQ(has_several_sheets(mesh, h), sheets.size() > 1);
      several += sheets.size() > 1;
      nonmanifold += all.is_nonmanifold();
    }
  }
  EXPECT_GT(several, 500u);
  EXPECT_GT(nonmanifold, 500u);
}

TEST(copies, the_smallest_is_the_point_however_they_come_and_go) {
  Mesh mesh = test::make_mesh(test::Polygons{}, 6);
  const MeshColumns apart = mesh.columns();
  Journal journal;
  {
    Edit edit(mesh, &journal);
    for (std::uint32_t i = 0; i < 6; ++i) edit.set_position(Vertex(i), {});
    link_copies(edit, std::array{Vertex(4), Vertex(1), Vertex(5)});
    EXPECT_EQ(point(mesh, Vertex(5)), Vertex(1));
    link_copies(edit, std::array{Vertex(3), Vertex(2)});
    join_copies(edit, Vertex(5), Vertex(3));
    EXPECT_FALSE(check_invariants(mesh));
    EXPECT_EQ(point(mesh, Vertex(2)), Vertex(1));
    EXPECT_EQ(mesh.next_copy(Vertex(5)), Vertex(2));
    join_copies(edit, Vertex(0), Vertex(4));
    EXPECT_FALSE(check_invariants(mesh));
    edit.commit();
  }
  const MeshColumns together = mesh.columns();
  for (std::uint32_t i = 0; i < 6; ++i) {
    Edit edit(mesh, &journal);
    leave_copies(edit, Vertex(i));
    EXPECT_EQ(point(mesh, Vertex(i)), Vertex(i));
    EXPECT_EQ(point(mesh, Vertex(5)), Vertex(std::min(i + 1, 5u)));
    EXPECT_FALSE(check_invariants(mesh));
    edit.commit();
  }
  while (journal.position() > 1) journal.undo(mesh);
  EXPECT_EQ(mesh.columns(), together);
  journal.undo(mesh);
  EXPECT_EQ(mesh.columns(), apart);
}

TEST(copies, an_edge_of_many_sheets_is_known_from_three_faces) {
  const Mesh mesh = from_indexed(test::book(20000));
  const auto begin = std::chrono::steady_clock::now();
  std::size_t cut = 0;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    cut += is_cut_on_points(mesh, halfedge(Edge(i)));
    EXPECT_EQ(has_several_sheets(mesh, halfedge(Edge(i))), is_cut_on_points(mesh, halfedge(Edge(i))));
  }
  EXPECT_EQ(cut, 20000u);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

TEST(copies, many_fans_at_one_point_are_counted_in_no_time) {
  constexpr std::uint32_t fans = 20000;
  test::Polygons faces;
  for (std::uint32_t i = 0; i < fans; ++i) faces.push_back({0, 2 * i + 1, 2 * i + 2});
  const Mesh mesh = test::make_mesh(faces);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(counts_on_points(mesh), (ElementCounts{2 * fans + 1, 3 * fans, fans, 0}));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

}  // namespace
}  // namespace ryosen
