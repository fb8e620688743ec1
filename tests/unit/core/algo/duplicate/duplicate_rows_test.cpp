// Duplicates and mirror images of elements.
#include "ryosen/algo/algorithm.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "ryosen/algo/duplicate/part.h"
#include "ryosen/analysis/euler_poincare.h"
#include "ryosen/analysis/problem_sets.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

// Cut in the middle of the plane x = 0, the boundary there.
Mesh open_box() {
  Mesh box = made_by("cube size=2 at=1,0,0");
  Edit edit(box, nullptr);
  for (std::uint32_t i = 0; i < box.face_slots(); ++i) {
    bool is_at_plane = true;
    for (const Vertex v : vertices_around(box, Face(i))) is_at_plane = is_at_plane && box.position(v).x == 0;
    if (is_at_plane) ryosen::apply(edit, *parse_line(box, "delete f" + std::to_string(i)).op);
  }
  edit.commit();
  return box;
}

std::vector<Mesh> meshes() {
  std::vector<Mesh> all;
  all.push_back(from_indexed(indexed(fin(), 6)));  // a non-manifold edge: copies
  all.push_back(made_by("torus"));
  all.push_back(open_box());
  all.push_back(made_by("grid columns=3 rows=2"));
  return all;
}

TEST(copying, of_everything_doubles_it_and_undo_is_exact) {
  for (Mesh& mesh : meshes())
    for (const char* const line : {"duplicate by=9,0,0", "mirror axis=y about=0,9,0", "mirror axis=x weld=0"}) {
      SCOPED_TRACE(line);
      const MeshColumns before = mesh.columns();
      const ElementCounts live = counts_on_points(mesh);
      const ProblemSets problems(mesh);
      Journal journal;
      const AlgorithmResult result = run_algorithm(mesh, journal, line);
      EXPECT_GT(result.changed, 0u);
      EXPECT_FALSE(check_invariants(mesh));
      EXPECT_EQ(mesh.live().faces, 2 * before.live.faces);
      if (std::string_view(line).find("weld") == std::string_view::npos) {
        EXPECT_EQ(counts_on_points(mesh).vertices, 2 * live.vertices);
        EXPECT_EQ(counts_on_points(mesh).edges, 2 * live.edges);
        const ProblemSets after(mesh);
        for (const ProblemRow& row : problem_table())
          if (row.kind != ProblemKind::coincident_points) {  // what lies in the plane is its own image
            EXPECT_EQ(after.count(row.kind), 2 * problems.count(row.kind)) << row.id;
          }
      }
      journal.undo(mesh);
      EXPECT_EQ(mesh.columns(), before);
    }
}

TEST(copying, takes_faces_by_their_names_their_vertices_or_their_edges) {
  for (const char* const elements : {"f0", "v0,v1,v4,v5"}) {
    Mesh mesh = made_by("grid columns=3 rows=1");
    Journal journal;
    run_algorithm(mesh, journal, std::string("duplicate elements=") + elements);
    EXPECT_EQ(mesh.live().faces, 4u) << elements;
    EXPECT_EQ(mesh.live().vertices, 12u) << elements;
    EXPECT_FALSE(check_invariants(mesh));
  }
}

TEST(copying, takes_edges_as_lines_and_vertices_alone) {
  Mesh mesh = made_by("grid columns=3 rows=1");
  Journal journal;
  run_algorithm(mesh, journal, "duplicate elements=0-1,1-2,v7");
  EXPECT_EQ(mesh.live().faces, 3u);
  EXPECT_EQ(mesh.live().vertices, 8u + 4u);
  EXPECT_EQ(mesh.live().edges, 10u + 2u);
  EXPECT_FALSE(check_invariants(mesh));
}

TEST(copying, keeps_the_values_of_corners_and_faces) {
  IndexedMesh source = indexed(fin(), 6);
  source.texcoords.pool = {{0, 0, 0}, {1, 0, 0}};
  source.texcoords.index.assign(source.corners.size(), 1);
  source.materials.names = {"red", "blue"};
  source.materials.index.assign(source.face_count(), 1);
  Mesh mesh = from_indexed(std::move(source));
  Journal journal;
  const std::uint32_t faces = mesh.face_slots();
  run_algorithm(mesh, journal, "duplicate by=0,0,5");
  const auto column = [&](std::string_view name) {
    return mesh.attributes()[static_cast<std::size_t>(mesh.find_attribute(name))];
  };
  for (std::uint32_t f = faces; f < mesh.face_slots(); ++f) {
    EXPECT_EQ(attribute_value<std::uint32_t>(column(attribute_names::material), f), 1u);
    EXPECT_EQ(attribute_value<std::uint32_t>(column(attribute_names::texcoord), mesh.halfedge(Face(f)).index), 1u);
  }
}

TEST(mirror, welds_a_half_into_a_whole_with_its_outside_outside) {
  Mesh mesh = open_box();
  const double half = 4;
  Journal journal;
  const AlgorithmResult result = run_algorithm(mesh, journal, "mirror weld=0.001");
  EXPECT_NE(result.text.en.find("4 vertices were welded"), std::string::npos) << result.text.en;
  EXPECT_FALSE(check_invariants(mesh));
  EXPECT_EQ(mesh.live().vertices, 12u);
  const ProblemSets problems(mesh);
  for (const ProblemRow& row : problem_table()) EXPECT_EQ(problems.count(row.kind), 0u) << row.id;
  double volume = 0;  // by the divergence theorem: outside is outside
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    if (!mesh.is_alive(Face(i))) continue;
    std::vector<glm::dvec3> p;
    for (const Vertex v : vertices_around(mesh, Face(i))) p.push_back(mesh.position(v));
    for (std::size_t k = 2; k < p.size(); ++k) volume += glm::dot(p[0], glm::cross(p[k - 1], p[k])) / 6;
  }
  EXPECT_NEAR(volume, 2 * 2 * half, 1e-12);
}

TEST(mirror, makes_no_bow_tie_where_a_corner_alone_touches_the_plane) {
  IndexedMesh triangle;
  triangle.positions = {{0, 0, 0}, {1, -1, 0}, {1, 1, 0}};
  triangle.corners = {0, 1, 2};
  triangle.face_offsets = {0, 3};
  Mesh mesh = from_indexed(std::move(triangle));
  Journal journal;
  run_algorithm(mesh, journal, "mirror weld=0.1");
  EXPECT_EQ(mesh.live().vertices, 6u);
  EXPECT_FALSE(check_invariants(mesh));
}

}  // namespace
}  // namespace ryosen::test
