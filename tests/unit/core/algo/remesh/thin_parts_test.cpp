// Remeshing of what is thinner than the length: nothing is torn, eaten or made to cross.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>

#include "ryosen/algo/crossings/crossing_guard.h"
#include "ryosen/algo/remesh/remesh.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/measure/distance.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/triangulate.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/ugly_meshes.h"

namespace ryosen::test {
namespace {

double mean_edge(const Mesh& mesh) {
  double sum = 0;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (!mesh.is_alive(Edge(i))) continue;
    const auto [a, b] = ends(mesh, Edge(i));
    sum += glm::distance(mesh.position(a), mesh.position(b));
  }
  return sum / mesh.live().edges;
}

Mesh made_by_lines(std::initializer_list<const char*> lines) {
  Mesh mesh;
  Journal journal;
  for (const char* const line : lines) EXPECT_GT(run_algorithm(mesh, journal, line).changed, 0u) << line;
  return mesh;
}

Mesh read(const std::filesystem::path& path) {
  auto file = read_mesh_file(path);
  EXPECT_TRUE(file) << path;
  return file ? from_indexed(file->mesh) : Mesh();
}

// How far the surfaces may be from each other, in lengths. Where edges are to be longer than a part is thick, it is
// left so that none stays short.
struct Near {
  double eaten = 0.4, torn = 0.6;
};
constexpr Near around_long_edges{0.6, 1.7};

// What is the same whatever the length, and how near the surfaces are.
void expect_same_surface(const Mesh& before, const Mesh& after, double length, const Near& near = {}) {
  const auto broken = check_invariants(after);
  ASSERT_FALSE(broken) << broken->sentence;
  const Figures old = compute_figures(before), now = compute_figures(after);
  EXPECT_EQ(now.euler_characteristic, old.euler_characteristic);
  EXPECT_EQ(now.components, old.components);
  EXPECT_EQ(now.boundary_loops, old.boundary_loops);
  EXPECT_EQ(now.manifold, old.manifold);
  EXPECT_EQ(now.closed, old.closed);
  // Where sheets cross, nearest places may be on either.
  const bool was_free = find_self_intersections(before, 1).count == 0;
  if (was_free) {
    EXPECT_EQ(find_self_intersections(after, 1).count, 0u);
  }
  Progress unheard;
  const auto distance = surface_distance(before, after, {.gap = 0.05, .samples = 2000}, unheard);
  EXPECT_LT(distance->forward.hausdorff, (was_free ? near.eaten : 1.2) * length) << "eaten";
  EXPECT_LT(distance->backward.hausdorff, (was_free ? near.torn : 1.2) * length) << "torn";
}

void expect_any_length_is_fine(const Mesh& mesh, const std::string& name) {
  for (const double times : {0.2, 0.5, 1.0, 2.0, 5.0})
    for (const bool adaptive : {false, true}) {
      if (times < 0.5 && !is_long_run() && mesh.live().faces > 200) continue;
      SCOPED_TRACE(name + ", " + std::to_string(times) + " times the mean edge" + (adaptive ? ", adaptive" : ""));
      if (adaptive && times < 2) continue;
      if (!is_long_run() && (times == 1.0 || (times >= 2 && adaptive == (times > 2)))) continue;
      const double length = times * mean_edge(mesh);
      Progress unheard;
      remesh::Remeshed made = remesh::remeshed(
          mesh, {.length = length, .adaptive = adaptive, .tolerance = length / 20, .feature_angle_rad = 0.785},
          unheard);
      ASSERT_FALSE(made.fault);
      expect_same_surface(mesh, Mesh(std::move(made.columns)), length, times >= 2 ? around_long_edges : Near{});
    }
}

TEST(RemeshThin, parts_thinner_than_the_length_stay) {
  expect_any_length_is_fine(
      made_by_lines({"cube", "scale axis=0,0,1 factor=0.02", "subdivide scheme=midpoint steps=3"}),
      "a plate with edges");
  expect_any_length_is_fine(made_by_lines({"torus radius=1 tube=0.03"}), "a thin torus");
  if (is_long_run())
    expect_any_length_is_fine(made_by_lines({"sphere", "scale axis=0,0,1 factor=0.02"}), "a smooth plate");
  expect_any_length_is_fine(made_by_lines({"cone radius=0.1 height=1", "subdivide scheme=midpoint steps=1"}), "a cone");
}

TEST(RemeshThin, sheets_nearer_than_the_length_do_not_meet) {
  expect_any_length_is_fine(made_by_lines({"sphere radius=1", "sphere radius=1.01"}), "two spheres");
  if (!is_long_run()) return;
  expect_any_length_is_fine(made_by_lines({"sphere radius=1", "scale axis=0,0,1 factor=0.02", "sphere radius=1.05"}),
                            "a plate in a sphere");
}

// Two large triangles that cross, with two spheres in their boxes but away from where they do: that they meet excuses
// no others.
TEST(RemeshThin, faces_that_met_before_excuse_none_elsewhere) {
  IndexedMesh indexed = to_indexed(made_by_lines({"sphere radius=1", "sphere radius=1.01"})).mesh;
  constexpr glm::dvec3 corner(-1.2);
  for (const glm::dvec3& sides : {glm::dvec3(6, 6, 6), glm::dvec3(6.5, 6.5, 5)}) {
    for (int axis = 0; axis < 3; ++axis) {
      indexed.corners.push_back(static_cast<std::uint32_t>(indexed.positions.size()));
      indexed.positions.push_back(corner);
      indexed.positions.back()[axis] += sides[axis];
    }
    indexed.face_offsets.push_back(static_cast<std::uint32_t>(indexed.corners.size()));
  }
  const Mesh mesh = from_indexed(std::move(indexed));
  ASSERT_EQ(find_self_intersections(mesh, 10).count, 1u);
  const std::vector<double> few{0.3}, many{0.2, 0.3, 0.5};
  for (const double length : is_long_run() ? many : few) {
    Progress unheard;
    remesh::Remeshed made = remesh::remeshed(mesh, {.length = length, .feature_angle_rad = 0.785}, unheard);
    const Mesh after(std::move(made.columns));
    for (const FacePair& pair : find_self_intersections(after, 10000).pairs)
      for (const Face f : {pair.first, pair.second}) EXPECT_GT(glm::length(middle_of(after, f)), 1.2) << length;
  }
}

TEST(RemeshThin, meshes_of_files_stay_what_they_are) {
  namespace fs = std::filesystem;
  for (const char* const name :
       {"ball.off", "torus.off", "tetrahedron.off", "cube.obj", "moebius.off", "klein_bottle.off"})
    expect_any_length_is_fine(read(fs::path(RYOSEN_SOURCE_DIR "/assets") / name), name);
  const fs::path known = RYOSEN_SHARED_DIR "/meshes/known";
  if (!fs::exists(known)) return;
  for (const char* const name :
       {"annulus.off", "cube_quad.off", "cube_tri.off", "moebius5.off", "two_tets_disjoint.off"})
    expect_any_length_is_fine(read(known / name), name);
}

Mesh triangles_made_by(const std::vector<std::string>& lines) {
  Mesh mesh;
  Journal journal;
  for (const std::string& line : lines) EXPECT_GT(run_algorithm(mesh, journal, line).changed, 0u) << line;
  Edit edit(mesh, nullptr);
  Triangulate{}.apply(edit);
  edit.commit();
  return mesh;
}

std::vector<std::array<TriangleCorners, 2>> pairs_that_meet(const Mesh& mesh) {
  std::vector<std::array<TriangleCorners, 2>> pairs;
  for (const FacePair& pair : find_self_intersections(mesh, 100000).pairs)
    pairs.push_back({corners_of(mesh, mesh.halfedge(pair.first)), corners_of(mesh, mesh.halfedge(pair.second))});
  return pairs;
}

// Parts that lie over one another nearly everywhere meet in thousands of pairs.
TEST(RemeshThin, overlapping_parts_meet_where_they_met) {
  const std::string parts = is_long_run() ? "" : " segments=16 bands=8";
  const std::vector<std::vector<std::string>> all{
      {"cone radius=4 height=4", "cone radius=4 height=4 at=0.001,0.0005,-0.0007", "torus radius=3 tube=1"},
      {"torus radius=3 tube=1", "torus radius=3 tube=1 at=0.02,0,0.01", "torus radius=3 tube=1 at=0,0.02,0"},
      {"sphere radius=1" + parts, "sphere radius=1.001 at=0.002,0,0" + parts, "cylinder at=0.5,0,0"},
      {"cube size=2", "cube size=2 at=0.001,0.002,0.003", "cube size=2 at=-0.002,0.001,-0.001"},
      {"cylinder radius=1 height=2", "cylinder radius=1.0005 height=2 at=0,0.001,0.3", "cone radius=1 height=2"}};
  for (std::size_t i = 0; i < all.size(); i += is_long_run() ? 1 : 2) {
    SCOPED_TRACE(i);
    const Mesh mesh = triangles_made_by(all[i]);
    Progress unheard;
    const double length = mean_edge(mesh);
    remesh::Remeshed made = remesh::remeshed(mesh, {.length = length, .feature_angle_rad = 0.785}, unheard);
    const Mesh after(std::move(made.columns));
    std::vector<MetPlaces::Place> places;
    for (const auto& [a, b] : pairs_that_meet(mesh)) {
      const Box common = common_box(a, b);
      places.push_back({{common.lowest - length, common.highest + length}, 0, 0});
    }
    const MetPlaces met({}, places);
    const auto now = pairs_that_meet(after);
    EXPECT_EQ(std::count_if(now.begin(), now.end(), [&](const auto& pair) { return !met.hold(pair[0], pair[1]); }), 0);
  }
}

// A tongue with a smooth rim whose sheets lie nearer to each other than the length: what projecting to the nearest
// point of the surface, or collapsing into middles, ate from the tip. Were a point of one page put on the next one,
// they would meet, and steps would be refused since.
TEST(RemeshThin, points_of_a_page_stay_on_it) {
  const std::vector<std::uint32_t> few{100}, many{60, 100, 150, 300};
  for (const std::uint32_t pages : is_long_run() ? many : few)
    for (const double length : {0.11, 0.2})
      for (const IndexedMesh& sheets : {test::book(pages), book_of_squares(pages)}) {
        Progress progress;
        const remesh::Remeshed made = remesh::remeshed(from_indexed(sheets), {.length = length}, progress);
        EXPECT_EQ(made.refused, 0u) << pages << " " << length;
        EXPECT_EQ(find_self_intersections(Mesh(made.columns)).count, 0u) << pages << " " << length;
      }
}

TEST(RemeshThin, a_tongue_keeps_its_tip) {
  const Mesh tongue = made_by_lines({"sphere radius=1", "subdivide scheme=loop steps=1", "scale axis=0,1,0 factor=0.3",
                                     "scale axis=0,0,1 factor=0.03"});
  for (const double length : {0.1, 0.2, 0.3}) {
    Progress unheard;
    remesh::Remeshed made = remesh::remeshed(tongue, {.length = length, .feature_angle_rad = 3.2}, unheard);
    const Mesh mesh(std::move(made.columns));
    expect_same_surface(tongue, mesh, length);
    double reach = 0;
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
      if (mesh.is_alive(Vertex(i))) reach = std::max(reach, mesh.position(Vertex(i)).x);
    EXPECT_GT(reach, 1 - 0.3 * length);
  }
}

}  // namespace
}  // namespace ryosen::test
