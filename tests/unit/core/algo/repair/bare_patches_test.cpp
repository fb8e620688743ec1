// Patches of fill_holes without new vertices: they are told, and others have no slivers.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/algo/repair/find_holes.h"
#include "ryosen/algo/repair/hole_triangles.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/core/open_shapes.h"
#include "tests/support/core/run_algorithm.h"

namespace ryosen::test {
namespace {

// A cup whose rim goes up and down.
IndexedMesh wavy_cup(std::uint32_t corners, double height) {
  IndexedMesh list = cup(corners, 1, 1);
  for (std::uint32_t i = 0; i < corners; ++i)
    list.positions[corners + i].z += height * std::sin(2 * M_PI * 3 * i / corners);
  return list;
}

// With a small triangle close to each side of each triangle between the corners of the rim: no other patch fits
// between.
IndexedMesh with_guards(IndexedMesh list) {
  const Mesh mesh = from_indexed(list);
  Progress unheard;
  const std::vector<Hole> holes = find_holes(mesh, {}, unheard);
  const std::vector<std::uint32_t> first{0};
  const JoinedCorners joined = joined_corners(mesh, holes, first);
  NormalsOfFaces normals;
  const HoleLoop hole = read_hole(mesh, holes.at(0).start, joined, normals);
  for (const CornerTriangle& t : weigh_triangles(hole, unheard).triangles) {
    const glm::dvec3 &a = hole.places[t[0]], &b = hole.places[t[1]], &c = hole.places[t[2]];
    const glm::dvec3 middle = (a + b + c) / 3.0, up = glm::normalize(glm::cross(b - a, c - a)) * 1e-6;
    for (const double side : {-1.0, 1.0}) {
      for (const glm::dvec3& p : {a, b, c}) {
        list.corners.push_back(static_cast<std::uint32_t>(list.positions.size()));
        list.positions.push_back(middle + (p - middle) * 0.9 + side * up);
      }
      list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
    }
  }
  return list;
}

// The share of the angles of faces from this one on that are below 30 degrees.
double small_angles(const Mesh& mesh, std::uint32_t first) {
  std::size_t small = 0, all = 0;
  for (std::uint32_t i = first; i < mesh.face_slots(); ++i)
    for (const Halfedge h : halfedges_around(mesh, Face(i))) {
      const glm::dvec3& at = mesh.position(mesh.from(h));
      const glm::dvec3 u = mesh.position(mesh.to(h)) - at, v = mesh.position(mesh.from(mesh.prev(h))) - at;
      small += std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)) < M_PI / 6;
      ++all;
    }
  return static_cast<double>(small) / static_cast<double>(all);
}

struct BareCase {
  std::uint32_t corners;
  double height;
  const char* shape;
  bool is_turned;
};

TEST(bare_patches, are_told_and_others_have_no_slivers) {
  for (const BareCase& c : {BareCase{36, 0.1, "flat", false},
                            {36, 0.1, "flat", true},
                            {48, 0.25, "flat", false},
                            {48, 0.25, "flat", true},
                            {60, 0.2, "flat", true}}) {
    SCOPED_TRACE(std::to_string(c.corners) + " " + c.shape);
    const auto change = [&](IndexedMesh list) { return c.is_turned ? turned(std::move(list)) : list; };
    const std::string line = std::string("fill_holes most_edges=70 shape=") + c.shape;
    Journal journal;
    const IndexedMesh open = change(wavy_cup(c.corners, c.height));
    Mesh even = from_indexed(open);
    const AlgorithmResult finer = run_algorithm(even, journal, line);
    EXPECT_EQ(finer.text.en.find("bare"), std::string::npos) << finer.text.en;
    EXPECT_LT(small_angles(even, static_cast<std::uint32_t>(open.face_count())), 0.1);
    const IndexedMesh guarded = with_guards(open);
    Mesh bare = from_indexed(guarded);
    const AlgorithmResult result = run_algorithm(bare, journal, line);
    EXPECT_EQ(result.changed, 1u);
    EXPECT_NE(result.text.en.find(": bare since no finer patch is sound;"), std::string::npos) << result.text.en;
    EXPECT_EQ(bare.live().vertices, guarded.positions.size()) << "no vertex comes";
    EXPECT_EQ(bare.face_slots() - guarded.face_count(), c.corners - 2);
    EXPECT_GT(small_angles(bare, static_cast<std::uint32_t>(guarded.face_count())), 0.25);
    EXPECT_TRUE(find_self_intersections(bare).pairs.empty());
  }
}

}  // namespace
}  // namespace ryosen::test
