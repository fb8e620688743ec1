#include "ryosen/analysis/figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/core/long_run.h"
#include "tests/support/core/oracle/figures.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

Figures figures_of(const Polygons& faces, std::size_t points = 0) { return compute_figures(make_mesh(faces, points)); }

// A cube with edges of length `size` between the origin and (size, size, size), faces outward.
Mesh cube_of(double size) {
  IndexedMesh source = indexed(cube());
  for (std::uint32_t i = 0; i < 8; ++i)
    source.positions[i] = {size * (i & 1u), size * (i >> 1u & 1u), size * (i >> 2u & 1u)};
  return from_indexed(std::move(source));
}

TEST(figures, of_a_cube) {
  const Figures f = compute_figures(cube_of(2));
  EXPECT_EQ(f.vertices, 8u);
  EXPECT_EQ(f.edges, 12u);
  EXPECT_EQ(f.faces, 6u);
  EXPECT_EQ(f.corners, 24u);
  EXPECT_EQ(f.triangles, 0u);
  EXPECT_EQ(f.quads, 6u);
  EXPECT_EQ(f.polygons, 0u);
  EXPECT_EQ(f.max_edge_faces, 2u);
  EXPECT_EQ(f.components, 1u);
  EXPECT_EQ(f.euler_characteristic, 2);
  EXPECT_EQ(f.genus, 0);
  EXPECT_TRUE(f.manifold && f.closed && f.orientable);
  EXPECT_EQ(f.bounds, (std::array{glm::dvec3(0.0), glm::dvec3(2.0)}));
  EXPECT_DOUBLE_EQ(f.area, 24);
  ASSERT_TRUE(f.volume);
  EXPECT_DOUBLE_EQ(*f.volume, 8);
}

TEST(figures, measure_very_small_and_very_large_meshes) {
  for (double size : {1e-100, 1e+100}) {
    const Figures f = compute_figures(cube_of(size));
    EXPECT_DOUBLE_EQ(f.area, 6 * size * size);
    EXPECT_NEAR(*f.volume / size / size / size, 1, 1e-12);
    EXPECT_EQ(f[ProblemKind::degenerate_area], 0u);
  }
}

TEST(figures, of_a_torus) {
  const Figures f = figures_of(torus_grid(5, 4));
  EXPECT_EQ(f.genus, 1);
  EXPECT_EQ(f.euler_characteristic, 0);
  EXPECT_EQ(f.boundary_loops, 0u);
}

TEST(figures, of_three_faces_on_an_edge) {
  const Figures f = figures_of(fin());
  EXPECT_EQ(f.vertices, 5u);
  EXPECT_EQ(f.edges, 7u);
  EXPECT_EQ(f[ProblemKind::nonmanifold_edge], 1u);
  EXPECT_EQ(f.max_edge_faces, 3u);
  EXPECT_EQ(f[ProblemKind::nonmanifold_vertex], 2u);
  EXPECT_EQ(f.bowtie_vertices, 0u);
  EXPECT_EQ(f[ProblemKind::misoriented_edge], 0u);
  EXPECT_EQ(f[ProblemKind::boundary_loop], 6u);
  EXPECT_EQ(f.boundary_loops, 0u) << "a chain that ends at a non-manifold edge is no loop";
  EXPECT_TRUE(f.open_boundary) << "so that there is no number of them";
  EXPECT_FALSE(f.manifold);
  EXPECT_FALSE(f.genus);
  EXPECT_FALSE(f.volume);
}

TEST(figures, of_a_bow_tie) {
  const Figures f = figures_of(bow_tie());
  EXPECT_EQ(f.vertices, 5u);
  EXPECT_EQ(f.edges, 6u);
  EXPECT_EQ(f.bowtie_vertices, 1u);
  EXPECT_EQ(f[ProblemKind::nonmanifold_vertex], 1u);
  EXPECT_EQ(f.components, 2u);
  EXPECT_EQ(f.boundary_loops, 2u);
  EXPECT_FALSE(f.manifold);
  EXPECT_TRUE(f.orientable);
}

TEST(figures, of_a_moebius_strip) {
  const Figures f = figures_of(moebius_strip());
  EXPECT_EQ(f.boundary_loops, 1u);
  EXPECT_EQ(f[ProblemKind::boundary_loop], 5u);
  EXPECT_GT(f[ProblemKind::misoriented_edge], 0u);
  EXPECT_FALSE(f.orientable);
  EXPECT_TRUE(f.manifold);
  EXPECT_FALSE(f.genus);
}

TEST(figures, of_two_tetrahedra_on_an_edge) {
  const Figures f = figures_of(two_tetrahedra_on_an_edge());
  EXPECT_EQ(f.vertices, 6u);
  EXPECT_EQ(f.edges, 11u);
  EXPECT_EQ(f[ProblemKind::nonmanifold_edge], 1u);
  EXPECT_EQ(f.max_edge_faces, 4u);
  EXPECT_EQ(f.components, 1u) << "faces are joined through any shared edge";
  EXPECT_EQ(f[ProblemKind::boundary_loop], 0u);
  EXPECT_FALSE(f.closed);
  EXPECT_TRUE(f.orientable);
}

TEST(figures, of_misoriented_neighbours) {
  const Figures f = figures_of({{0, 1, 2}, {0, 1, 3}});
  EXPECT_EQ(f.edges, 5u);
  EXPECT_EQ(f[ProblemKind::misoriented_edge], 1u);
  EXPECT_EQ(f[ProblemKind::nonmanifold_vertex], 0u);
  EXPECT_EQ(f[ProblemKind::boundary_loop], 4u);
  EXPECT_EQ(f.boundary_loops, 1u);
  EXPECT_TRUE(f.manifold && f.orientable);
  EXPECT_EQ(f.genus, 0);
}

TEST(figures, of_hanging_and_duplicate_triangles) {
  const Figures back_to_back = figures_of({{0, 1, 2}, {0, 2, 1}});
  EXPECT_EQ(back_to_back[ProblemKind::hanging_pair], 1u);
  EXPECT_EQ(back_to_back[ProblemKind::duplicate_face], 1u);
  EXPECT_TRUE(back_to_back.closed);
  const Figures same_direction = figures_of({{0, 1, 2}, {0, 1, 2}});
  EXPECT_EQ(same_direction[ProblemKind::hanging_pair], 0u);
  EXPECT_EQ(same_direction[ProblemKind::duplicate_face], 1u);
  EXPECT_EQ(same_direction[ProblemKind::misoriented_edge], 3u);
  const Figures on_one_edge = figures_of({{0, 1, 2}, {0, 2, 1}, {0, 1, 3}});
  EXPECT_EQ(on_one_edge[ProblemKind::hanging_pair], 1u);
  const Figures on_two_edges = figures_of({{0, 1, 2}, {0, 2, 1}, {0, 1, 3}, {1, 2, 4}});
  EXPECT_EQ(on_two_edges[ProblemKind::hanging_pair], 0u);
  EXPECT_EQ(on_two_edges[ProblemKind::duplicate_face], 1u);
}

TEST(figures, find_duplicates_that_share_no_edge) {
  const Figures pentagon_and_star = figures_of({{0, 1, 2, 3, 4}, {0, 2, 4, 1, 3}, {0, 1, 2, 3, 5}});
  EXPECT_EQ(pentagon_and_star[ProblemKind::duplicate_face], 1u);
  EXPECT_EQ(figures_of({{0, 1, 2, 3}, {0, 2, 1, 3}, {3, 2, 1, 0}})[ProblemKind::duplicate_face], 2u);
}

TEST(figures, count_isolated_and_nonfinite_vertices) {
  IndexedMesh source = indexed({{0, 1, 2}, {2, 1, 3}}, 6);
  source.positions[3].y = std::numeric_limits<double>::quiet_NaN();
  source.positions[5].z = std::numeric_limits<double>::infinity();
  source.positions[0] = {0, 0, 0};
  source.positions[1] = {3, 0, 0};
  source.positions[2] = {0, 4, 0};
  const Figures f = compute_figures(from_indexed(std::move(source)));
  EXPECT_EQ(f[ProblemKind::isolated_vertex], 2u);
  EXPECT_EQ(f[ProblemKind::nonfinite_vertex], 2u);
  EXPECT_EQ(f.edges, 5u) << "a face with such a corner is connected like any other";
  EXPECT_DOUBLE_EQ(f.area, 6) << "but not measured";
  EXPECT_EQ(f.bounds, (std::array{glm::dvec3(0.0), glm::dvec3(3, 4, 0)}));
  EXPECT_EQ(f[ProblemKind::degenerate_area], 0u);
}

TEST(figures, tell_exact_collinearity_from_nearly) {
  IndexedMesh source = indexed({{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11, 12}});
  source.positions = {
      {0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3},  // all three on the diagonal, whatever the decimals became
      {0, 0, 0},       {1, 1, 1},       {2, 2, std::nextafter(2.0, 3.0)},
      {5, 5, 5},       {5, 5, 5},       {5, 5, 5},
      {0, 0, 0},       {1, 0, 0},       {2, 0, 0},
      {1, 1e-300, 0}};
  const ProblemSets sets(from_indexed(std::move(source)));
  EXPECT_EQ(sets.of(ProblemKind::degenerate_area).to_vector(), (std::vector<std::uint32_t>{0, 2}));
}

TEST(figures, of_no_faces) {
  const Figures f = figures_of({}, 3);
  EXPECT_EQ(f.vertices, 3u);
  EXPECT_EQ(f[ProblemKind::isolated_vertex], 3u);
  EXPECT_EQ(f.euler_characteristic, 0);
  EXPECT_FALSE(f.closed);
  EXPECT_TRUE(f.manifold);
  EXPECT_FALSE(f.genus || f.bounds || f.volume);
}

TEST(figures, count_quarantined_faces_where_the_file_has_them) {
  IndexedMesh source = indexed({{0, 1, 2}, {}, {}, {}, {}}, 4);
  const auto aside = [&](std::uint32_t face, const std::vector<std::int64_t>& corners) {
    QuarantinedFace q;
    q.face = face;
    q.corners = corners;
    source.quarantine.push_back(std::move(q));
  };
  aside(1, {0, 1});
  aside(2, {0, 1, 1, 2});
  aside(3, {0, 1, 9});
  aside(4, {2, 2, 9, 1, 0});
  const std::vector<QuarantinedFace> quarantine = source.quarantine;
  const Figures f = compute_figures(from_indexed(std::move(source)), quarantine);
  EXPECT_EQ(f.faces, 5u);
  EXPECT_EQ(f[ProblemKind::quarantined_face], 4u);
  EXPECT_EQ(f.triangles, 2u);
  EXPECT_EQ(f.quads, 1u);
  EXPECT_EQ(f.polygons, 1u);
  EXPECT_EQ(f.corners, 17u);
  EXPECT_EQ(f[ProblemKind::degenerate_repeat], 1u);
  EXPECT_EQ(f.edges, 3u);
  EXPECT_EQ(f[ProblemKind::isolated_vertex], 1u);
  EXPECT_EQ(f.euler_characteristic, 1);
}

// What the oracle says of the same list.
void expect_as_oracle(const RandomMesh& mesh, const Figures& found) {
  const oracle::Figures truth = oracle::figures_of(oracle::polygon_list(mesh.points, mesh.faces));
  const auto as_int = [](std::uint64_t value) { return static_cast<int>(value); };
  oracle::Figures f;
  f.vertices = as_int(found.vertices);
  f.edges = as_int(found.edges);
  f.faces = as_int(found.faces);
  f.boundary_edges = as_int(found[ProblemKind::boundary_loop]);
  f.boundary_loops = as_int(found.boundary_loops);
  f.nonmanifold_edges = as_int(found[ProblemKind::nonmanifold_edge]);
  f.max_edge_faces = as_int(found.max_edge_faces);
  f.nonmanifold_vertices = as_int(found[ProblemKind::nonmanifold_vertex]);
  f.bowtie_vertices = as_int(found.bowtie_vertices);
  f.misoriented_edges = as_int(found[ProblemKind::misoriented_edge]);
  f.duplicate_faces = as_int(found[ProblemKind::duplicate_face]);
  f.hanging_pairs = as_int(found[ProblemKind::hanging_pair]);
  f.isolated_vertices = as_int(found[ProblemKind::isolated_vertex]);
  f.components = as_int(found.components);
  f.euler_characteristic = static_cast<int>(found.euler_characteristic);
  f.manifold = found.manifold;
  f.closed = found.closed;
  f.orientable = found.orientable;
  f.genus = static_cast<int>(found.genus.value_or(-1));
  EXPECT_TRUE(f == truth) << "seed " << mesh.seed << " " << mesh.story << ": edges " << f.edges << " " << truth.edges
                          << ", loops " << f.boundary_loops << " " << truth.boundary_loops << ", bow-ties "
                          << f.bowtie_vertices << " " << truth.bowtie_vertices << ", hanging " << f.hanging_pairs << " "
                          << truth.hanging_pairs << ", duplicates " << f.duplicate_faces << " " << truth.duplicate_faces
                          << ", components " << f.components << " " << truth.components << ", orientable "
                          << f.orientable << " " << truth.orientable << ", genus " << f.genus << " " << truth.genus;
}

Mesh mesh_of(const RandomMesh& mesh) {
  Polygons faces;
  for (const auto& face : mesh.faces) faces.emplace_back(face.begin(), face.end());
  return make_mesh(faces, static_cast<std::size_t>(mesh.points));
}

TEST(figures, agree_with_the_oracle_on_random_meshes) {
  for (std::uint64_t seed = 1; seed <= seed_count(7000, 20000) && !HasFailure(); ++seed) {
    const RandomMesh mesh = random_mesh(seed);
    expect_as_oracle(mesh, compute_figures(mesh_of(mesh)));
  }
}

// Without some faces: their edges stay, as wires where no face is left, and a vertex may keep several fans or none.
TEST(figures, are_the_same_for_any_number_of_threads) {
  for (std::uint64_t seed = 1; seed <= 600 && !HasFailure(); ++seed) {
    const Mesh mesh = mesh_of(random_mesh(seed));
    const ProblemSets sets(mesh);
    const Figures figures = compute_figures(mesh, sets, {}, 1);
    for (const unsigned threads : {2u, 5u}) EXPECT_EQ(figures, compute_figures(mesh, sets, {}, threads)) << seed;
  }
}

TEST(figures, see_only_faces_whatever_deleting_them_leaves) {
  for (std::uint64_t seed = 1; seed <= 5000 && !HasFailure(); ++seed) {
    RandomMesh mesh = random_mesh(seed);
    MeshColumns columns = mesh_of(mesh).columns();
    Dice dice(seed);
    for (std::uint32_t f = 0; f < columns.face_halfedge.size(); ++f) {
      if (!dice.one_in(3)) continue;
      const Halfedge start = columns.face_halfedge[f];
      Halfedge h = start;
      do {
        HalfedgeLinks& links = columns.halfedges[h.index];
        links.face = Face();
        columns.vertex_halfedge[links.from.index] = h;
        h = links.next;
      } while (h != start);
      columns.face_halfedge[f] = dead_halfedge;
      --columns.live.faces;
      mesh.faces[f].clear();
    }
    expect_as_oracle(mesh, compute_figures(Mesh(std::move(columns))));
  }
}

// Faces thrown together: nearly every edge and point is non-manifold.
TEST(figures, agree_with_the_oracle_on_soups) {
  for (std::uint64_t seed = 1; seed <= seed_count(2000, 5000) && !HasFailure(); ++seed) {
    Dice dice(seed);
    RandomMesh mesh{seed, "soup", 4 + dice.below(6), {}};
    for (int left = 1 + dice.below(25); left > 0; --left) {
      std::vector<int> face;
      for (const int corners = 3 + dice.below(3); static_cast<int>(face.size()) < std::min(corners, mesh.points);) {
        const int corner = dice.below(mesh.points);
        if (std::find(face.begin(), face.end(), corner) == face.end()) face.push_back(corner);
      }
      mesh.faces.push_back(face);
    }
    expect_as_oracle(mesh, compute_figures(mesh_of(mesh)));
  }
}

}  // namespace
}  // namespace ryosen
