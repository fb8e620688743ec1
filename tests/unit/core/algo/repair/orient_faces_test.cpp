#include "ryosen/algo/repair/orient_faces.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <numbers>

#include "ryosen/algo/repair/recipe.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/mesh_kind.h"
#include "ryosen/analysis/shells.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/core/boxes.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/recipe_checks.h"
#include "tests/support/core/run_algorithm.h"

namespace ryosen::test {
namespace {

AlgorithmResult oriented(Mesh& mesh) {
  Journal journal;
  const AlgorithmResult result = run_algorithm(mesh, journal, "orient");
  Mesh twice = mesh;
  Journal again;
  EXPECT_EQ(run_algorithm(twice, again, "orient").changed, 0u) << "twice does more than once";
  return result;
}

std::string kind_of(const Mesh& mesh) { return std::string(row_of(find_kind(mesh, ProblemSets(mesh)).kind).id); }

// Six times the volume enclosed by the faces of one component, the one of this face.
double volume_at(const Mesh& mesh, Face f) {
  Neighbourhood around(mesh, Neighbourhood::Reach::whole);
  const FaceComponents components = find_face_components(around);
  double volume = 0;
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    if (!mesh.is_alive(Face(i)) || components.of_face[i] != components.of_face[f.index]) continue;
    std::vector<glm::dvec3> p;
    for (const Vertex v : vertices_around(mesh, Face(i))) p.push_back(mesh.position(v));
    for (std::size_t k = 2; k < p.size(); ++k) volume += glm::dot(p[0], glm::cross(p[k - 1], p[k]));
  }
  return volume;
}

TEST(orient_faces, the_reported_cube_looks_outwards) {
  const std::filesystem::path path = std::filesystem::path(RYOSEN_SOURCE_DIR) / "tests/data/reports/inside_out.off";
  const Mesh mesh = from_indexed(read_mesh_file(path)->mesh);
  for (const std::string kinds : {"orient", "remove_duplicates,weld_equal,stitch,orient,detach_nonmanifold"}) {
    const RecipeResult result = *run_recipe(mesh, recipe_of(kinds).steps, {});
    EXPECT_EQ(result.rounds, 1u) << kinds;
    EXPECT_EQ(compute_figures(result.mesh).volume, 1.0) << kinds;
    EXPECT_EQ(run_recipe(result.mesh, recipe_of(kinds).steps, {})->rounds, 0u) << kinds;
  }
}

TEST(orient_faces, what_is_right_stays) {
  for (const Mesh& mesh : {Boxes().cube(0, 1).mesh(), Boxes().cube(0, 9).cube(1, 8, true).cube(2, 7).mesh(), Mesh(),
                           Boxes().cube(0, 9).cube(1, 8, true).cube(2, 4).cube(5, 7).cube(20, 21).mesh()}) {
    Mesh turned = mesh;
    EXPECT_EQ(oriented(turned).changed, 0u);
    EXPECT_EQ(turned.hash(), mesh.hash());
  }
}

// All ways of turning three shells in each other and one beside them, near an open sheet and around another.
TEST(orient_faces, shells_three_deep_look_out_of_the_solid_beside_open_parts) {
  for (int ways = 0; ways < 16; ++ways)
    for (const bool has_open : {false, true}) {
      Boxes boxes;
      boxes.cube(0, 9, (ways & 1) != 0).cube(1, 8, (ways & 2) == 0).cube(2, 7, (ways & 4) != 0);
      boxes.cube(20, 21, (ways & 8) != 0);
      IndexedMesh list = boxes.source();
      if (has_open)
        for (const double at : {4.0, 12.0}) {  // one in the innermost, one outside
          for (const glm::dvec3 p : {glm::dvec3(at, at, at), glm::dvec3(at + 1, at, at), glm::dvec3(at, at + 1, at)}) {
            list.corners.push_back(static_cast<std::uint32_t>(list.positions.size()));
            list.positions.push_back(p);
          }
          list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
        }
      Mesh mesh = from_indexed(list);
      oriented(mesh);
      EXPECT_GT(volume_at(mesh, Face(0)), 0) << ways;
      EXPECT_LT(volume_at(mesh, Face(6)), 0) << ways;
      EXPECT_GT(volume_at(mesh, Face(12)), 0) << ways;
      EXPECT_GT(volume_at(mesh, Face(18)), 0) << ways;
      if (!has_open) {
        EXPECT_EQ(kind_of(mesh), "solid") << ways;
      } else {
        EXPECT_EQ(compute_figures(mesh)[ProblemKind::boundary_loop], 6u);
      }
    }
}

TEST(orient_faces, shells_that_cross_turn_one_by_one) {
  for (int ways = 0; ways < 16; ++ways) {
    // Two that cross, in a third; and a cavity where both overlap.
    Mesh mesh = Boxes()
                    .cube(2, 5, (ways & 1) != 0)
                    .cube(3, 6, (ways & 2) != 0)
                    .cube(0, 9, (ways & 4) != 0)
                    .cube(3.5, 4.5, (ways & 8) != 0)
                    .mesh();
    oriented(mesh);
    EXPECT_LT(volume_at(mesh, Face(0)), 0) << ways;
    EXPECT_LT(volume_at(mesh, Face(6)), 0) << ways;
    EXPECT_GT(volume_at(mesh, Face(12)), 0) << ways;
    EXPECT_GT(volume_at(mesh, Face(18)), 0) << ways;
    Mesh alone = Boxes().cube(0, 2, (ways & 1) != 0).cube(1, 3, (ways & 2) != 0).cube(2, 4, (ways & 4) != 0).mesh();
    oriented(alone);
    for (const std::uint32_t f : {0u, 6u, 12u}) EXPECT_GT(volume_at(alone, Face(f)), 0) << ways;
  }
}

TEST(orient_faces, solids_that_share_an_edge_are_each_judged) {
  for (int ways = 0; ways < 4; ++ways) {
    const Boxes boxes = Boxes().add({0, 0, 0}, {1, 1, 1}, (ways & 1) != 0).add({1, 1, 0}, {2, 2, 1}, (ways & 2) != 0);
    IndexedMesh list = boxes.source();
    for (std::uint32_t& corner : list.corners)
      for (std::uint32_t i = 0; i < corner; ++i)
        if (list.positions[i] == list.positions[corner]) corner = i;
    Mesh mesh = from_indexed(list);
    ASSERT_EQ(compute_figures(mesh)[ProblemKind::nonmanifold_edge], 1u);
    oriented(mesh);
    double volume = 0;
    for (std::uint32_t f = 0; f < 12; f += 6) volume += volume_at(mesh, Face(f));
    EXPECT_EQ(volume, 2 * 12.0) << "both shells are in one component: " << ways;
  }
}

TEST(orient_faces, a_shell_without_volume_counts_for_nothing) {
  IndexedMesh list = Boxes().cube(0, 9).cube(3, 6).source();
  const auto first = static_cast<std::uint32_t>(list.positions.size());
  for (const glm::dvec3 p : {glm::dvec3(-1, -1, 4), glm::dvec3(30, -1, 4), glm::dvec3(-1, 30, 4)})
    list.positions.push_back(p);
  for (const std::uint32_t corner : {0u, 1u, 2u, 2u, 1u, 0u}) list.corners.push_back(first + corner);
  for (int k = 0; k < 2; ++k) list.face_offsets.push_back(list.face_offsets.back() + 3);
  Mesh mesh = from_indexed(list);
  oriented(mesh);
  EXPECT_GT(volume_at(mesh, Face(0)), 0);
  EXPECT_LT(volume_at(mesh, Face(6)), 0);
}

// A cup of this depth, its wall and floor seen from outside or, turned, from within.
Mesh cup(double depth, bool turned, std::uint32_t sides = 24) {
  IndexedMesh list;
  for (const double z : {0.0, depth})
    for (std::uint32_t i = 0; i < sides; ++i)
      list.positions.emplace_back(std::cos(2 * std::numbers::pi * i / sides),
                                  std::sin(2 * std::numbers::pi * i / sides), z);
  const auto add = [&](std::vector<std::uint32_t> face) {
    if (turned) std::reverse(face.begin(), face.end());
    list.corners.insert(list.corners.end(), face.begin(), face.end());
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  };
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t j = (i + 1) % sides;
    add({i, j, sides + j, sides + i});
  }
  std::vector<std::uint32_t> floor;
  for (std::uint32_t i = sides; i-- > 0;) floor.push_back(i);
  add(floor);
  return from_indexed(list);
}

TEST(orient_faces, an_open_part_turns_where_it_is_mostly_seen_from_behind) {
  for (const double depth : {1.0, 3.0, 20.0}) {
    Mesh right = cup(depth, false), wrong = cup(depth, true);
    EXPECT_EQ(oriented(right).changed, 0u) << depth;
    EXPECT_EQ(oriented(wrong).changed, 25u) << depth;
    const auto [a, b] = std::pair(volume_at(right, Face(0)), volume_at(wrong, Face(0)));
    EXPECT_NEAR(a, b, 1e-12 * std::abs(a)) << depth;
    const RecipeResult result = *run_recipe(cup(depth, true), recipe_of("orient").steps, {});
    EXPECT_EQ(result.rounds, 1u);
  }
}

// Copies on points of their own, of cups that are right and wrong.
TEST(orient_faces, copies_of_an_open_part_are_each_judged) {
  for (const std::vector<bool>& wrong : {std::vector<bool>{true, true}, {false, true}, {true, false, true}}) {
    IndexedMesh all;
    for (const bool is_wrong : wrong) {
      const IndexedMesh part = to_indexed(cup(3, is_wrong)).mesh;
      const auto first = static_cast<std::uint32_t>(all.positions.size());
      all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
      for (const std::uint32_t corner : part.corners) all.corners.push_back(first + corner);
      for (std::size_t f = 1; f < part.face_offsets.size(); ++f)
        all.face_offsets.push_back(static_cast<std::uint32_t>(all.corners.size()) - part.face_offsets.back() +
                                   part.face_offsets[f]);
    }
    Mesh mesh = from_indexed(all);
    oriented(mesh);
    for (std::uint32_t copy = 0; copy < wrong.size(); ++copy)
      EXPECT_GT(volume_at(mesh, Face(25 * copy)), 0) << copy << " of " << wrong.size();
  }
}

// So many triangles in one place or one plane; a ray went through the boxes of all of them.
TEST(orient_faces, takes_little_longer_for_faces_on_each_other) {
  using Place = glm::dvec3 (*)(const glm::dvec3&, double);
  const Place places[] = {[](const glm::dvec3& p, double) { return p; },
                          [](const glm::dvec3& p, double) { return glm::dvec3(0.3 * p.x + p.y, p.y, 0.7 * p.x); },
                          [](const glm::dvec3& p, double by) { return p + glm::dvec3(1e-6 * by, 0, 0); },
                          [](const glm::dvec3& p, double by) { return glm::dvec3(p.z, 1e-6 * by + p.x, p.y); },
                          [](const glm::dvec3& p, double by) { return (1 + 1e-6 * by) * p; }};
  for (std::size_t k = 0; k < std::size(places); ++k)
    for (const bool turns_every_second : {false, true}) {
      IndexedMesh list;
      for (std::uint32_t i = 0; i < 10000; ++i) {
        for (const glm::dvec3& p : {glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)})
          list.positions.push_back(places[k](p, i));
        const bool is_turned = turns_every_second && i % 2 == 1;
        for (const std::uint32_t corner : {0u, is_turned ? 2u : 1u, is_turned ? 1u : 2u})
          list.corners.push_back(3 * i + corner);
        list.face_offsets.push_back(3 * (i + 1));
      }
      Mesh mesh = from_indexed(list);
      const auto start = std::chrono::steady_clock::now();
      EXPECT_EQ(oriented(mesh).changed, 0u) << k << ": both sides are seen";
      EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(3)) << k;
    }
}

TEST(orient_faces, an_open_part_stays_where_both_sides_are_seen) {
  IndexedMesh square;
  square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.corners = {0, 3, 2, 1};
  square.face_offsets = {0, 4};
  Mesh sheet = from_indexed(square);
  EXPECT_EQ(oriented(sheet).changed, 0u);
  for (const bool turned : {false, true}) {  // 1 from the floor and 0.2 pi from the wall: under one and a half
    Mesh flat = cup(0.05, turned);
    EXPECT_EQ(oriented(flat).changed, 0u);
  }
}

// Nothing of it is seen from outside, from either side.
TEST(orient_faces, an_open_part_in_a_shell_stays) {
  IndexedMesh list = Boxes().cube(-50, 50).source();
  const Mesh inner = cup(3, true);
  const auto first = static_cast<std::uint32_t>(list.positions.size());
  for (std::uint32_t i = 0; i < inner.vertex_slots(); ++i) list.positions.push_back(inner.position(Vertex(i)));
  for (std::uint32_t f = 0; f < inner.face_slots(); ++f) {
    for (const Vertex v : vertices_around(inner, Face(f))) list.corners.push_back(first + v.index);
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  Mesh mesh = from_indexed(list);
  EXPECT_EQ(oriented(mesh).changed, 0u);
}

TEST(orient_faces, neighbours_agree_first_and_then_the_shell_turns) {
  for (std::uint32_t ways = 0; ways < 64; ++ways) {
    const IndexedMesh source = Boxes().cube(0, 2).source();
    IndexedMesh list = source;
    for (std::uint32_t f = 0; f < 6; ++f)
      if ((ways >> f & 1u) != 0)
        std::reverse(list.corners.begin() + list.face_offsets[f], list.corners.begin() + list.face_offsets[f + 1]);
    Mesh mesh = from_indexed(list);
    oriented(mesh);
    EXPECT_EQ(compute_figures(mesh).volume, 8.0) << ways;
  }
}

// Boxes in and through each other: a shell looks outwards where an even number of bodies is around it.
TEST(orient_faces, random_boxes_look_out_of_what_is_around_them) {
  Dice dice(23);
  for (int round = 0; round < 200; ++round) {
    Boxes boxes;
    struct Span {
      double from, to;
    };
    std::vector<Span> all;
    for (int i = 0, count = 2 + dice.below(5); i < count; ++i) {
      const double from = dice.below(12);
      all.push_back({from, from + 1 + dice.below(9)});
      boxes.cube(all.back().from, all.back().to, dice.one_in(2));
    }
    const std::size_t n = all.size();
    std::vector<std::size_t> body(n);
    for (std::size_t i = 0; i < n; ++i) body[i] = i;
    const auto is_in = [&](std::size_t i, std::size_t k) { return all[k].from < all[i].from && all[i].to < all[k].to; };
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const bool apart = all[i].to < all[k].from || all[k].to < all[i].from;
        if (apart || is_in(i, k) || is_in(k, i)) continue;
        const std::size_t from = body[i], to = body[k];
        for (std::size_t& b : body)
          if (b == from) b = to;
      }
    Mesh mesh = boxes.mesh();
    oriented(mesh);
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<std::size_t> around;
      for (std::size_t k = 0; k < n; ++k)
        if (body[k] != body[i] && is_in(i, k)) around.push_back(body[k]);
      std::sort(around.begin(), around.end());
      around.erase(std::unique(around.begin(), around.end()), around.end());
      const double volume = volume_at(mesh, Face(6 * i));
      EXPECT_EQ(volume > 0, around.size() % 2 == 0) << round << " " << i;
    }
  }
}

}  // namespace
}  // namespace ryosen::test
