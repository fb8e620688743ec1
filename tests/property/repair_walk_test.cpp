// Deleting, filling, detaching, welding and reversing everything on many small random meshes, against the polygon list.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

const std::uint64_t repair_seeds = seed_count(is_sample() ? 160 : 80, 400);

template <class Visit>
void for_each_shape(Visit visit) {
  const std::vector<Polygons> shapes{tetrahedron(),
                                     cube(),
                                     torus_grid(3, 4),
                                     two_quads(),
                                     closed_fan(3),
                                     closed_fan(6),
                                     bow_tie(),
                                     fin(),
                                     moebius_strip(),
                                     two_tetrahedra_on_an_edge(),
                                     Polygons{{0, 1, 2}},
                                     Polygons{{0, 1, 2}, {0, 2, 1}},
                                     Polygons{{0, 1, 2, 3, 4}}};
  for (const Polygons& faces : shapes) visit(make_mesh(faces));
  for (std::uint32_t seed = 1; seed <= repair_seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SeededMesh random = seeded_mesh(seed);
    visit(make_mesh(random.faces, random.points));
    if (testing::Test::HasFailure()) return;
  }
}

TEST(repair_walk, delete_of_every_element) {
  for_each_shape([](const Mesh& start) {
    std::vector<Element> elements;
    for (std::uint32_t i = 0; i < start.vertex_slots(); ++i) elements.push_back(Vertex(i));
    for (std::uint32_t i = 0; i < start.edge_slots(); ++i) elements.push_back(Edge(i));
    for (std::uint32_t i = 0; i < start.face_slots(); ++i) elements.push_back(Face(i));
    for (Element element : elements) {
      Mesh mesh = start;
      Polygons expected;
      for (std::uint32_t f = 0; f < start.face_slots(); ++f) {
        std::vector<std::uint32_t> points;
        for (Vertex v : vertices_around(start, Face(f))) points.push_back(point(start, v).index);
        std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
        bool goes = element == Element(Face(f));
        for (std::size_t i = 0; i < points.size(); ++i) {
          const std::uint32_t a = points[i], b = points[(i + 1) % points.size()];
          if (element.kind == Element::Kind::vertex) goes |= a == point(start, element.vertex()).index;
          if (element.kind != Element::Kind::edge) continue;
          const auto [p, q] = ends(start, element.edge());
          const auto [low, high] = std::minmax({point(start, p).index, point(start, q).index});
          goes |= std::min(a, b) == low && std::max(a, b) == high;
        }
        if (!goes) expected.push_back(points);
      }
      std::sort(expected.begin(), expected.end());
      apply_and_prove(mesh, Delete{element});
      EXPECT_EQ(point_polygons(mesh), expected) << name_of(start, element);
      if (testing::Test::HasFailure()) return;
    }
  });
}

TEST(repair_walk, one_face_after_the_other_goes_and_comes_back) {
  for_each_shape([](Mesh mesh) {
    Dice dice(mesh.hash());
    std::vector<Face> faces;
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) faces.push_back(Face(i));
    while (!faces.empty()) {
      const auto at = static_cast<std::size_t>(dice.below(static_cast<int>(faces.size())));
      const Face f = faces[at];
      const Polygons with_face = point_polygons(mesh);
      std::string line = "make_face";
      for (Vertex v : vertices_around(mesh, f)) line += " v" + std::to_string(point(mesh, v).index);
      apply_and_prove(mesh, Delete{f});
      if (testing::Test::HasFailure()) return;
      const ParsedOp again = parse_line(mesh, line);
      if (again.op && check(mesh, *again.op).legal()) {
        Mesh copy = mesh;
        apply_and_prove(copy, *again.op);
        EXPECT_EQ(point_polygons(copy), with_face);
        if (testing::Test::HasFailure()) return;
      }
      faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(at));
    }
    EXPECT_EQ(mesh.live().edges, 0u);
  });
}

TEST(repair_walk, every_hole_is_filled) {
  for_each_shape([](Mesh mesh) {
    for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
      if (!mesh.is_alive(Halfedge(i)) || !mesh.is_outside(Halfedge(i)) || !check(mesh, Fill{Halfedge(i)}).legal())
        continue;
      const Change change = apply_and_prove(mesh, Fill{Halfedge(i)});
      EXPECT_EQ(change.f, 1);
      if (!mesh.has_copies()) {
        EXPECT_EQ(change, (Change{.f = 1, .b = -1}));
      }
      if (testing::Test::HasFailure()) return;
    }
  });
}

TEST(repair_walk, sheets_come_off_and_points_are_welded_back) {
  for_each_shape([](const Mesh& start) {
    for (std::uint32_t f = 0; f < start.face_slots(); ++f) {
      Mesh mesh = start;
      if (!check(mesh, Detach{{Face(f)}}).legal()) continue;
      const Polygons before = point_polygons(mesh);
      apply_and_prove(mesh, Detach{{Face(f)}});
      if (testing::Test::HasFailure()) return;
      for (Vertex v : vertices_around(mesh, Face(f)))
        EXPECT_GT(counts_on_points(mesh).vertices, counts_on_points(start).vertices) << v.index;
      // The new points lie where the old ones are.
      bool all = true;
      for (bool again = true; again;) {
        again = false;
        all = true;
        for (std::uint32_t i = 0; i < mesh.vertex_slots() && !again; ++i)
          for (std::uint32_t k = 0; k < i && !again; ++k) {
            const Vertex a(k), b(i);
            if (!mesh.is_alive(a) || !mesh.is_alive(b) || point(mesh, a) != a || point(mesh, b) != b) continue;
            if (mesh.position(a) != mesh.position(b)) continue;
            all = false;
            const Weld weld{a, b, Halfedge(), Halfedge()};
            if (!check(mesh, weld).legal()) continue;
            apply_and_prove(mesh, weld);
            again = true;
          }
        if (testing::Test::HasFailure()) return;
      }
      if (all) {
        EXPECT_EQ(point_polygons(mesh), before);
      }
    }
  });
}

TEST(repair_walk, all_pairs_are_welded) {
  for (std::uint32_t seed = 1; seed <= repair_seeds / 2; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SeededMesh random = seeded_mesh(seed);
    const Mesh start = make_mesh(random.faces, random.points);
    for (std::uint32_t a = 0; a < start.vertex_slots(); ++a)
      for (std::uint32_t b = 0; b < start.vertex_slots(); ++b) {
        const Weld weld{Vertex(a), Vertex(b), Halfedge(), Halfedge()};
        if (!check(start, weld).legal()) continue;
        Mesh mesh = start;
        const Vertex p = point(start, Vertex(a)), q = point(start, Vertex(b)), stays = std::min(p, q);
        Polygons expected = point_polygons(start);
        for (auto& face : expected) {
          for (std::uint32_t& corner : face)
            if (corner == p.index || corner == q.index) corner = stays.index;
          std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        }
        std::sort(expected.begin(), expected.end());
        apply_and_prove(mesh, weld);
        EXPECT_EQ(point_polygons(mesh), expected);
        EXPECT_EQ(mesh.position(stays), start.position(p));
        if (testing::Test::HasFailure()) return;
      }
  }
}

TEST(repair_walk, boundary_edges_are_welded) {
  for (std::uint32_t seed = 1; seed <= repair_seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SeededMesh random = seeded_mesh(seed);
    const Mesh start = make_mesh(random.faces, random.points);
    std::size_t done = 0;
    for (std::uint32_t a = 0; a < start.edge_slots() && done < 20; ++a)
      for (std::uint32_t b = 0; b < start.edge_slots(); ++b) {
        const Weld weld{Vertex(), Vertex(), halfedge(Edge(a)), halfedge(Edge(b))};
        if (!check(start, weld).legal()) continue;
        Mesh mesh = start;
        const ElementCounts before = counts_on_points(mesh);
        apply_and_prove(mesh, weld);
        EXPECT_EQ(counts_on_points(mesh).faces, before.faces);
        EXPECT_LT(counts_on_points(mesh).vertices, before.vertices);
        EXPECT_LT(counts_on_points(mesh).edges, before.edges);
        if (testing::Test::HasFailure()) return;
        ++done;
      }
  }
}

TEST(repair_walk, reversed_twice_is_as_before) {
  for_each_shape([](const Mesh& start) {
    for (std::uint32_t f = 0; f < start.face_slots(); ++f) {
      Mesh mesh = start;
      const Change there = apply_and_prove(mesh, Reverse{{Face(f)}});
      EXPECT_EQ(there, Change());
      EXPECT_EQ(counts_on_points(mesh), counts_on_points(start));
      apply_and_prove(mesh, Reverse{{Face(f)}});
      EXPECT_EQ(mesh.hash(), start.hash());
      if (testing::Test::HasFailure()) return;
    }
  });
}

TEST(repair_walk, orient_gives_what_reading_gives) {
  for_each_shape([](Mesh mesh) {
    if (check(mesh, Orient{}).legal()) apply_and_prove(mesh, Orient{});
    EXPECT_FALSE(check(mesh, Orient{}).legal());
  });
}

// Some operator on some elements of a mesh with wires, bridges, rings, isolated vertices and several fans.
std::string random_line(const Mesh& mesh, Dice& dice) {
  const auto vertex = [&] { return " v" + std::to_string(dice.below(static_cast<int>(mesh.vertex_slots()))); };
  const auto face = [&] { return " f" + std::to_string(dice.below(static_cast<int>(mesh.face_slots()) + 1)); };
  const auto half = [&] { return " h" + std::to_string(dice.below(static_cast<int>(mesh.halfedge_slots()) + 1)); };
  switch (dice.below(16)) {
    case 0:
      return "delete" + vertex();
    case 1:
      return "delete" + half();
    case 2:
    case 3:
      return "delete" + face();
    case 4:
    case 5:
      return "fill" + half();
    case 6:
      return "make_face" + vertex() + vertex() + vertex();
    case 7:
      return "make_face" + vertex() + vertex() + vertex() + vertex();
    case 8:
    case 9:
      return "weld" + vertex() + vertex();
    case 10:
      return "weld" + half() + half();
    case 11:
      return "detach" + face() + (dice.one_in(2) ? face() : "");
    case 12:
      return "separate_fans" + vertex();
    case 13:
      return "reverse" + face();
    case 14:
      return "orient";
    default:
      return "make_face" + vertex() + vertex() + vertex() + vertex() + vertex();
  }
}

// Euler operators in between make what files do not hold.
std::string random_euler_line(const Mesh& mesh, Dice& dice) {
  const auto vertex = [&] { return " v" + std::to_string(dice.below(static_cast<int>(mesh.vertex_slots()))); };
  const auto face = [&] { return " f" + std::to_string(dice.below(static_cast<int>(mesh.face_slots()) + 1)); };
  const auto half = [&] { return " h" + std::to_string(dice.below(static_cast<int>(mesh.halfedge_slots()) + 1)); };
  switch (dice.below(9)) {
    case 0:
      return "make_vertex " + std::to_string(dice.unit()) + ",0," + std::to_string(dice.unit());
    case 1:
    case 2:
      return "make_edge" + vertex() + vertex();
    case 3:
      return "make_edge" + vertex() + vertex() + half() + half();
    case 4:
      return "delete_edge" + half();
    case 5:
      return "make_loop" + half();
    case 6:
      return "delete_loop" + face();
    case 7:
      return "make_ring" + half();
    default:
      return "unite_loop" + half();
  }
}

TEST(repair_walk, among_wires_bridges_rings_and_several_fans) {
  const std::uint64_t walks = seed_count(is_sample() ? 900 : 450, 4000);
  std::map<std::string, std::size_t> done;
  for (std::uint32_t seed = 1; seed <= walks; ++seed) {
    SCOPED_TRACE("walk " + std::to_string(seed));
    const SeededMesh random = seeded_mesh(seed);
    Mesh mesh = make_mesh(random.faces, random.points + 2);
    Dice dice(seed);
    std::string story;
    for (int step = 0; step < 60; ++step) {
      const bool is_euler = dice.one_in(2);
      const std::string line = is_euler ? random_euler_line(mesh, dice) : random_line(mesh, dice);
      const ParsedOp op = parse_line(mesh, line);
      if (!op.op || !check(mesh, *op.op).legal()) continue;
      story += line + "\n";
      ++done[std::string(info_of(*op.op).id)];
      if (is_euler) {
        Edit edit(mesh, nullptr);
        apply(edit, *op.op);
        edit.commit();
      } else {
        apply_and_prove(mesh, *op.op);
      }
      ASSERT_FALSE(HasFailure()) << story;
    }
  }
  for (const char* id : {"delete", "fill", "make_face", "weld", "detach", "separate_fans", "reverse", "orient"})
    EXPECT_GT(done[id], walks / 45) << id;
}

}  // namespace
}  // namespace ryosen
