#include "ryosen/indexed/pair_regular.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "ryosen/indexed/pair_corners.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// For each corner the corner whose side it is joined with.
template <class Halfedges>
std::vector<std::uint32_t> partners(const Halfedges& halfedge, std::uint32_t edges) {
  std::vector<std::uint32_t> corner(2 * std::size_t{edges}, no_index), result;
  for (std::uint32_t c = 0; c < halfedge.size(); ++c) {
    EXPECT_EQ(corner[halfedge[c].index], no_index) << "two sides on one half";
    corner[halfedge[c].index] = c;
  }
  for (std::uint32_t c = 0; c < halfedge.size(); ++c) result.push_back(corner[twin(halfedge[c]).index]);
  return result;
}

// Expects the pairing to be regular exactly where nothing is cut, to join the same sides, and not to depend on the
// number of threads. Returns whether it is regular.
bool compare(const IndexedMesh& mesh) {
  const CornerPairing expected = pair_with_cuts(mesh);
  const auto one = pair_regular(mesh, 1);
  EXPECT_EQ(one.has_value(), !expected.has_cuts);
  for (unsigned threads : {2u, 3u, 4u}) {
    const auto more = pair_regular(mesh, threads);
    EXPECT_EQ(more.has_value(), one.has_value());
    if (!one || !more) continue;
    EXPECT_EQ(more->halfedge, one->halfedge);
    EXPECT_EQ(more->down_only, one->down_only);
    for (std::size_t p = 0; p < mesh.positions.size(); ++p) {
      EXPECT_EQ(more->points[p].edge_end, one->points[p].edge_end);
      EXPECT_EQ(more->points[p].last_corner, one->points[p].last_corner);
    }
  }
  if (!one) return false;
  EXPECT_EQ(one->edges(), expected.edges);
  EXPECT_EQ(partners(one->halfedge, one->edges()), partners(expected.halfedge, expected.edges));
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    for (std::size_t k = 0; k < corners.size(); ++k)
      EXPECT_EQ(one->halfedge[mesh.face_offsets[f] + k].index & 1u,
                corners[k] > corners[(k + 1) % corners.size()] ? 1u : 0u);
  }
  return true;
}

TEST(pair_regular, agrees_with_the_general_pairing) {
  std::size_t regular = 0, cut = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    ++(compare(indexed(random.faces, random.points)) ? regular : cut);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
  EXPECT_GT(regular, 100u);
  EXPECT_GT(cut, 100u);
}

// A hub smaller than all its neighbours, one larger than all, one in between, and each with its faces in random order.
TEST(pair_regular, hubs) {
  std::mt19937 random(1);
  for (std::uint32_t spokes : {4u, 5u, 33u, 34u, 37u, 2000u}) {
    for (std::uint32_t hub : {0u, spokes / 2, spokes}) {
      Polygons faces = closed_fan(spokes);
      for (auto& face : faces) {
        for (std::uint32_t& v : face) v = (v + hub) % (spokes + 1);
      }
      std::shuffle(faces.begin(), faces.end(), random);
      EXPECT_TRUE(compare(indexed(faces)));
      faces.push_back(faces.front());  // twice the same
      EXPECT_FALSE(compare(indexed(faces)));
      std::swap(faces.back()[0], faces.back()[1]);  // back to back with it: three on an edge
      EXPECT_FALSE(compare(indexed(faces)));
    }
  }
}

// Enough faces for threads of their own; the mesh is sound and holds at each vertex what the face list says last.
TEST(pair_regular, large_meshes_are_linked_soundly) {
  for (const bool quads : {false, true}) {
    Polygons faces = torus_grid(220, 220);
    if (quads) {
      Polygons whole;
      for (std::size_t i = 0; i < faces.size(); i += 2)
        whole.push_back({faces[i][0], faces[i][1], faces[i][2], faces[i + 1][2]});
      faces = whole;
    }
    for (const bool open : {false, true}) {
      if (open) faces.resize(faces.size() - 1000);
      const IndexedMesh source = indexed(faces);
      EXPECT_TRUE(compare(source));
      const Mesh mesh = from_indexed(source);
      const auto broken = check_invariants(mesh);
      ASSERT_FALSE(broken) << broken->sentence;
      EXPECT_EQ(polygons_of(mesh), faces);
      std::vector<std::uint32_t> last(source.positions.size());
      for (std::uint32_t f = 0; f < faces.size(); ++f)
        for (std::uint32_t v : faces[f]) last[v] = f;
      for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v)
        EXPECT_TRUE(mesh.is_boundary(Vertex(v)) || mesh.face(mesh.halfedge(Vertex(v))) == Face(last[v]));
    }
  }
}

TEST(pair_regular, empty_lists) {
  EXPECT_TRUE(pair_regular(IndexedMesh(), 1));
  IndexedMesh points;
  points.positions.resize(5);
  EXPECT_TRUE(pair_regular(points, 2));
  EXPECT_EQ(from_indexed(points).live().vertices, 5u);
}

}  // namespace
}  // namespace ryosen
