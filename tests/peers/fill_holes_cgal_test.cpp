// Fair patches beside CGAL's: how even they are, in one table.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <glm/geometric.hpp>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/core/open_shapes.h"

namespace ryosen::test {
namespace {

using PeerMesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

// The angles of patches.
struct Evenness {
  std::size_t triangles = 0, small = 0;
  double least_deg = 180;

  void add(const std::array<glm::dvec3, 3>& t) {
    ++triangles;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 u = t[(k + 1) % 3] - t[k], v = t[(k + 2) % 3] - t[k];
      const double angle = std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)) * 180 / M_PI;
      small += angle < 30;
      least_deg = std::min(least_deg, angle);
    }
  }
  double share() const { return static_cast<double>(small) / static_cast<double>(3 * triangles); }
};

struct Filled {
  std::size_t holes = 0;
  Evenness evenness;
};

Filled fill(const IndexedMesh& list) {
  Mesh mesh = from_indexed(list);
  const std::uint32_t faces = mesh.face_slots();
  const AlgorithmRow& row = *find_algorithm("fill_holes");
  AlgorithmInput input{ParameterValues(row.parameters), {}, 0};
  EXPECT_FALSE(input.values.set("shape", "fair", "shape"));
  Edit edit(mesh, nullptr);
  Progress unheard;
  Filled filled{row.run(edit, input, unheard).changed, {}};
  edit.commit();
  for (std::uint32_t i = faces; i < mesh.face_slots(); ++i) {
    std::array<glm::dvec3, 3> places;
    std::size_t k = 0;
    for (const Vertex v : vertices_around(mesh, Face(i))) places[k++] = mesh.position(v);
    filled.evenness.add(places);
  }
  return filled;
}

Filled fill_as_peer(const IndexedMesh& list) {
  PeerMesh peer;
  for (const glm::dvec3& p : list.positions) peer.add_vertex({p.x, p.y, p.z});
  for (std::size_t f = 0; f < list.face_count(); ++f) {
    std::vector<PeerMesh::Vertex_index> corners;
    for (const std::uint32_t corner : list.face(f)) corners.emplace_back(corner);
    peer.add_face(corners);
  }
  Filled filled;
  std::vector<PeerMesh::Halfedge_index> borders;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(peer, std::back_inserter(borders));
  for (const auto border : borders) {
    std::vector<PeerMesh::Face_index> faces;
    std::vector<PeerMesh::Vertex_index> vertices;
    CGAL::Polygon_mesh_processing::triangulate_refine_and_fair_hole(peer, border, std::back_inserter(faces),
                                                                    std::back_inserter(vertices));
    filled.holes += !faces.empty();
    for (const auto face : faces) {
      std::array<glm::dvec3, 3> places;
      std::size_t k = 0;
      for (const auto v : peer.vertices_around_face(peer.halfedge(face)))
        places[k++] = {peer.point(v).x(), peer.point(v).y(), peer.point(v).z()};
      filled.evenness.add(places);
    }
  }
  return filled;
}

void compare(const std::string& name, const IndexedMesh& list) {
  const Filled ours = fill(list), theirs = fill_as_peer(list);
  std::printf("%-22s", name.c_str());
  for (const Filled* filled : {&ours, &theirs})
    std::printf(" | %4zu %6zu %6.2f %% %6.2f", filled->holes, filled->evenness.triangles,
                100 * filled->evenness.share(), filled->evenness.least_deg);
  std::printf("\n");
  ASSERT_GT(ours.evenness.triangles, 0u) << name;
  EXPECT_LE(ours.evenness.share(), 1.2 * theirs.evenness.share() + 0.02) << name;
}

TEST(fill_holes_cgal, fair_patches_are_as_even) {
  std::printf("%-22s | %4s %6s %8s %6s | %4s %6s %8s %6s\n", "", "ours", "faces", "< 30 deg", "least", "CGAL", "faces",
              "< 30 deg", "least");
  compare("bunny", read_mesh_file(RYOSEN_SOURCE_DIR "/assets/stanford_bunny.obj").value().mesh);
  compare("sphere, small cap", sphere_with_hole(24, 6));
  compare("half a sphere", sphere_with_hole(24, 12));
  compare("rim of 290, in a wave", sphere_with_hole(145, 40, [](std::uint32_t k) { return 0.5 * std::sin(1.7 * k); }));
  for (const char* path :
       {"cgal/data/meshes/mech-holes-shark.off", "cgal/data/meshes/elephant-with-holes.off",
        "cgal/data/meshes/head.off", "cgal/data/meshes/holes.off", "cgal/data/meshes/cylinder.off",
        "cgal/data/meshes/nefertiti.off", "pmp/data/off/fairing-cross.off", "gc/test/assets/cat_head.obj"}) {
    const std::filesystem::path file = std::filesystem::path(RYOSEN_SHARED_DIR "/meshes") / path;
    if (std::filesystem::exists(file)) compare(file.stem().string(), read_mesh_file(file).value().mesh);
  }
}

}  // namespace
}  // namespace ryosen::test
