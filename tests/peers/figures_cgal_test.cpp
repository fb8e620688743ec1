// Figures and self-intersections of clean meshes held against CGAL's.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <glm/geometric.hpp>
#include <random>

#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"

namespace ryosen {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Peer = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

// None where CGAL refuses a face.
std::optional<Peer> peer_of(const IndexedMesh& mesh) {
  Peer peer;
  for (const glm::dvec3& p : mesh.positions) peer.add_vertex({p.x, p.y, p.z});
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<Peer::Vertex_index> corners;
    for (const std::uint32_t corner : mesh.face(f)) corners.emplace_back(corner);
    if (peer.add_face(corners) == Peer::null_face()) return std::nullopt;
  }
  return peer;
}

struct NamedMesh {
  std::string name;
  IndexedMesh mesh;
};

// Every mesh there is that is manifold and one-sided nowhere, with nothing set aside.
std::vector<NamedMesh> clean_meshes() {
  std::vector<NamedMesh> meshes;
  for (const char* folder : {RYOSEN_SOURCE_DIR "/assets", RYOSEN_SHARED_DIR "/meshes"}) {
    if (!std::filesystem::exists(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (!format_of_extension(entry.path())) continue;
      Result<MeshFile> file = read_mesh_file(entry.path());
      if (!file.ok() || !file->mesh.quarantine.empty() || file->mesh.face_count() == 0) continue;
      const Figures figures = compute_figures(from_indexed(file->mesh));
      const bool is_clean = figures.manifold && figures.orientable && figures[ProblemKind::misoriented_edge] == 0 &&
                            figures[ProblemKind::isolated_vertex] == 0 && figures[ProblemKind::nonfinite_vertex] == 0 &&
                            figures.rings == 0;
      if (is_clean) meshes.push_back({entry.path().filename().string(), std::move(file->mesh)});
    }
  }
  return meshes;
}

bool is_triangular(const IndexedMesh& mesh) { return mesh.corners.size() == 3 * mesh.face_count(); }

// Every vertex a little away from its place, by the seed: near faces then cut each other.
IndexedMesh jittered(IndexedMesh mesh, double length, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(-length, length);
  for (glm::dvec3& p : mesh.positions) p += glm::dvec3(step(random), step(random), step(random));
  return mesh;
}

double mean_edge_length(const IndexedMesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < mesh.corners.size(); ++i)
    sum += glm::distance(mesh.positions[mesh.corners[i]], mesh.positions[mesh.corners[i + 1]]);
  return sum / static_cast<double>(mesh.corners.size());
}

std::vector<FacePair> peer_pairs(const Peer& peer) {
  std::vector<std::pair<Peer::Face_index, Peer::Face_index>> found;
  pmp::self_intersections(peer, std::back_inserter(found));
  std::vector<FacePair> pairs;
  for (const std::pair<std::uint32_t, std::uint32_t> pair : found)
    pairs.push_back({Face(std::min(pair.first, pair.second)), Face(std::max(pair.first, pair.second))});
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(figures_against_cgal, of_clean_meshes) {
  std::size_t closed = 0, open = 0;
  for (const NamedMesh& clean : clean_meshes()) {
    SCOPED_TRACE(clean.name);
    const std::optional<Peer> peer = peer_of(clean.mesh);
    ASSERT_TRUE(peer.has_value());
    const Figures figures = compute_figures(from_indexed(clean.mesh));
    EXPECT_EQ(figures.vertices, peer->number_of_vertices());
    EXPECT_EQ(figures.edges, peer->number_of_edges());
    EXPECT_EQ(figures.faces, peer->number_of_faces());
    EXPECT_EQ(figures.closed, CGAL::is_closed(*peer));
    (figures.closed ? closed : open) += 1;
    std::vector<Peer::Halfedge_index> loops;
    pmp::extract_boundary_cycles(*peer, std::back_inserter(loops));
    EXPECT_EQ(figures.boundary_loops, loops.size());
    std::map<Peer::Face_index, std::size_t> component;
    EXPECT_EQ(figures.components, pmp::connected_components(*peer, boost::make_assoc_property_map(component)));
    const CGAL::Bbox_3 box = pmp::bbox(*peer);
    ASSERT_TRUE(figures.bounds.has_value());
    const auto& [low, high] = *figures.bounds;
    EXPECT_EQ(low, glm::dvec3(box.xmin(), box.ymin(), box.zmin()));
    EXPECT_EQ(high, glm::dvec3(box.xmax(), box.ymax(), box.zmax()));
    if (!is_triangular(clean.mesh)) continue;
    EXPECT_NEAR(figures.area, pmp::area(*peer), 1e-9 * figures.area);
    ASSERT_EQ(figures.volume.has_value(), figures.closed);
    if (figures.volume) {
      EXPECT_NEAR(*figures.volume, pmp::volume(*peer), 1e-9 * std::abs(*figures.volume));
    }
    const auto is_flat = [&](Peer::Face_index face) { return pmp::is_degenerate_triangle_face(face, *peer); };
    EXPECT_EQ(figures[ProblemKind::degenerate_area], std::count_if(peer->faces_begin(), peer->faces_end(), is_flat));
  }
  EXPECT_GE(closed, 2u);
  EXPECT_GE(open, 2u);
}

TEST(self_intersections_against_cgal, of_meshes_with_vertices_out_of_place) {
  std::size_t meshes = 0, pairs = 0;
  for (const NamedMesh& clean : clean_meshes()) {
    if (!is_triangular(clean.mesh)) continue;
    const double length = mean_edge_length(clean.mesh);
    const bool is_small = clean.mesh.face_count() < 1000;
    for (std::uint32_t seed = 0; seed < (is_small ? 60u : 2u); ++seed) {
      SCOPED_TRACE(clean.name + " seed " + std::to_string(seed));
      const IndexedMesh mesh = jittered(clean.mesh, length * (is_small ? 0.02 * (seed + 1) : 0.3 * (seed + 1)), seed);
      const std::optional<Peer> peer = peer_of(mesh);
      ASSERT_TRUE(peer.has_value());
      const std::vector<FacePair> found = find_self_intersections(from_indexed(mesh)).pairs;
      EXPECT_EQ(found, peer_pairs(*peer));
      pairs += found.size();
      ++meshes;
    }
  }
  EXPECT_GT(meshes, 100u);
  EXPECT_GT(pairs, 5000u);
}

}  // namespace
}  // namespace ryosen
