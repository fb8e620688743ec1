#include "ryosen/indexed/to_indexed.h"

#include <gtest/gtest.h>

#include <limits>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/journal.h"
#include "ryosen/ops/collapse_edge.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

Polygons faces_of(const IndexedMesh& mesh) {
  Polygons faces;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
  return faces;
}

QuarantinedFace aside(std::uint32_t face, const std::vector<std::int64_t>& corners) {
  QuarantinedFace q;
  q.face = face;
  q.line = face + 1;
  q.corners = corners;
  return q;
}

void collapse(Mesh& mesh, std::uint32_t from, std::uint32_t to) {
  const CollapseEdge op{find_halfedge(mesh, Vertex(from), Vertex(to))};
  ASSERT_TRUE(op.check(mesh).legal());
  Edit edit(mesh, nullptr);
  op.apply(edit);
  edit.commit();
}

TEST(to_indexed, gives_the_polygons_back) {
  for (const Polygons& faces : {tetrahedron(), cube(), two_quads(), bow_tie(), fin(), moebius_strip(),
                                two_tetrahedra_on_an_edge(), torus_grid(4, 5)}) {
    const IndexedMesh source = indexed(faces);
    const CompactMesh compact = to_indexed(from_indexed(source));
    EXPECT_EQ(faces_of(compact.mesh), faces);
    EXPECT_EQ(compact.mesh.positions, source.positions);
  }
}

TEST(to_indexed, gives_random_meshes_back_and_again) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    const RandomMesh random = random_mesh(seed);
    Polygons faces;
    for (const auto& face : random.faces) faces.emplace_back(face.begin(), face.end());
    const IndexedMesh source = indexed(faces, static_cast<std::size_t>(random.points));
    const Mesh mesh = from_indexed(source);
    const CompactMesh compact = to_indexed(mesh);
    ASSERT_EQ(faces_of(compact.mesh), faces) << seed;
    ASSERT_EQ(compact.mesh.positions, source.positions) << seed;
    ASSERT_EQ(from_indexed(compact.mesh).columns(), mesh.columns()) << seed;
  }
}

TEST(to_indexed, closes_the_gaps_of_deleted_elements_and_keeps_isolated_vertices) {
  Mesh mesh = make_mesh(closed_fan(6), 9);
  collapse(mesh, 2, 3);
  const CompactMesh compact = to_indexed(mesh);
  EXPECT_EQ(compact.mesh.positions.size(), 8u);
  EXPECT_EQ(compact.vertex_number, (std::vector<std::uint32_t>{0, 1, no_index, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(compact.face_number, (std::vector<std::uint32_t>{0, no_index, 1, 2, 3, 4}));
  EXPECT_EQ(faces_of(compact.mesh), (Polygons{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}}));
}

TEST(to_indexed, numbers_copies_as_their_point) {
  const CompactMesh compact = to_indexed(make_mesh(bow_tie()));
  EXPECT_EQ(compact.vertex_number, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 0}));
}

// A strip of two triangles with one quarantined face of each cause between them.
IndexedMesh with_quarantine() {
  IndexedMesh source = indexed({{0, 1, 2}, {}, {2, 1, 3}, {}, {2, 3, 4}, {}, {}}, 6);
  source.quarantine = {aside(1, {2, 2, 4}), aside(3, {0, 7, -5}), aside(5, {3, 1}), aside(6, {6, 0, 1})};
  return source;
}

TEST(to_indexed, puts_quarantined_faces_back_in_their_place) {
  const IndexedMesh source = with_quarantine();
  const CompactMesh compact = to_indexed(from_indexed(source), file_tables(source));
  EXPECT_EQ(faces_of(compact.mesh), faces_of(source));
  ASSERT_EQ(compact.mesh.quarantine.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(compact.mesh.quarantine[i].face, source.quarantine[i].face);
    EXPECT_EQ(compact.mesh.quarantine[i].corners, source.quarantine[i].corners);
  }
}

TEST(to_indexed, quarantined_faces_follow_their_vertices) {
  const IndexedMesh source = with_quarantine();
  Mesh mesh = from_indexed(source);
  collapse(mesh, 4, 3);  // takes vertex 4 and face 4
  const CompactMesh compact = to_indexed(mesh, file_tables(source));
  EXPECT_EQ(compact.face_number, (std::vector<std::uint32_t>{0, 1, 2, 3, no_index, 4, 5}));
  EXPECT_EQ(faces_of(compact.mesh), (Polygons{{0, 1, 2}, {}, {2, 1, 3}, {}, {}, {}}));
  EXPECT_EQ(compact.kept_vertices, 1u);
  const std::vector<std::vector<std::int64_t>> expected{
      {2, 2, 4},  // 4 stays, as it stands here
      {0, 7, -5},
      {3, 1},
      {6, 0, 1},
  };
  ASSERT_EQ(compact.mesh.quarantine.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(compact.mesh.quarantine[i].corners, expected[i]);
    EXPECT_EQ(compact.face_number[source.quarantine[i].face], compact.mesh.quarantine[i].face);
  }
}

TEST(to_indexed, drops_the_quarantined_faces_that_it_is_not_given) {
  const IndexedMesh source = with_quarantine();
  FileTables tables = file_tables(source);
  tables.quarantine.erase(tables.quarantine.begin(), tables.quarantine.begin() + 2);
  const CompactMesh compact = to_indexed(from_indexed(source), tables);
  EXPECT_EQ(compact.mesh.face_count(), 5u);
  EXPECT_EQ(compact.face_number, (std::vector<std::uint32_t>{0, no_index, 1, no_index, 2, 3, 4}));
  EXPECT_EQ(compact.mesh.quarantine[0].face, 3u);
}

// A mesh that uses every attribute, with a bow-tie at 0 so that there are copies.
IndexedMesh with_attributes() {
  IndexedMesh source = indexed({{0, 1, 2}, {0, 3, 4}, {}, {4, 3, 5}}, 6);
  source.quarantine = {aside(2, {1, 1, 2})};
  source.quarantine[0].texcoords = {3, 2, 1};
  source.texcoords = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {0, 1, 2, 0, 3, no_index, no_index, 3, 1}, 2};
  source.normals = {{{0, 0, 1}, {0, 1, 0}}, {0, 0, 0, 1, 1, 1, 0, 1, 0}, 3};
  for (int i = 0; i < 6; ++i) source.vertex_colours.emplace_back(0.1 * i, 0.5, 1, 1);
  source.colour_components = 4;
  source.vertex_weights = {1, 2, 3, 4, 5, 6};
  source.face_colours = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0.5, 0, 0, 0}}, {3, 3, 4, 1}};
  source.materials = {{"red", "blue"}, {0, 1, no_index, 1}};
  source.groups = {{"a"}, {0, no_index, 0, 0}};
  source.objects = {{"o"}, {0, 0, 0, 0}};
  source.smoothing = {{"1", "2"}, {1, 1, 0, 0}};
  return source;
}

void expect_equal_names(const FaceNames& a, const FaceNames& b) {
  EXPECT_EQ(a.names, b.names);
  EXPECT_EQ(a.index, b.index);
}

void expect_equal_corner_values(const CornerValues& a, const CornerValues& b) {
  EXPECT_EQ(a.pool, b.pool);
  EXPECT_EQ(a.index, b.index);
  EXPECT_EQ(a.components, b.components);
}

TEST(to_indexed, gives_all_attributes_back) {
  const IndexedMesh source = with_attributes();
  const IndexedMesh back = to_indexed(from_indexed(source), file_tables(source)).mesh;
  EXPECT_EQ(faces_of(back), faces_of(source));
  expect_equal_corner_values(back.texcoords, source.texcoords);
  expect_equal_corner_values(back.normals, source.normals);
  EXPECT_EQ(back.vertex_colours, source.vertex_colours);
  EXPECT_EQ(back.colour_components, 4);
  EXPECT_EQ(back.vertex_weights, source.vertex_weights);
  EXPECT_EQ(back.face_colours.values, source.face_colours.values);
  EXPECT_EQ(back.face_colours.count, source.face_colours.count);
  expect_equal_names(back.materials, source.materials);
  expect_equal_names(back.groups, source.groups);
  expect_equal_names(back.objects, source.objects);
  expect_equal_names(back.smoothing, source.smoothing);
  EXPECT_EQ(back.quarantine[0].texcoords, source.quarantine[0].texcoords);
}

TEST(to_indexed, attributes_follow_their_elements) {
  const IndexedMesh source = with_attributes();
  Mesh mesh = from_indexed(source);
  collapse(mesh, 5, 3);  // takes face 3
  const IndexedMesh back = to_indexed(mesh, file_tables(source)).mesh;
  EXPECT_EQ(faces_of(back), (Polygons{{0, 1, 2}, {0, 3, 4}, {}}));
  EXPECT_EQ(back.materials.index, (std::vector<std::uint32_t>{0, 1, no_index}));
  EXPECT_EQ(back.face_colours.count, (std::vector<std::uint8_t>{3, 3, 4}));
  EXPECT_EQ(back.vertex_weights, (std::vector<double>{1, 2, 3, 4, 5}));
  EXPECT_EQ(back.texcoords.pool.size(), 4u);
  EXPECT_EQ(back.texcoords.index.size(), 6u);
  EXPECT_EQ(back.texcoords.index[3], 0u);
}

TEST(to_indexed, numbers_past_the_end_stay_as_far_past_it) {
  const IndexedMesh source = with_quarantine();
  Mesh mesh = from_indexed(source);
  Edit edit(mesh, nullptr);
  edit.drop(Vertex(5));  // which nothing uses
  edit.commit();
  const CompactMesh compact = to_indexed(mesh, file_tables(source));
  EXPECT_EQ(compact.mesh.positions.size(), 5u);
  EXPECT_EQ(compact.kept_vertices, 0u);
  EXPECT_EQ(compact.mesh.quarantine[1].corners, (CompactList<std::int64_t>{0, 6, -5}));
  EXPECT_EQ(compact.mesh.quarantine[3].corners, (CompactList<std::int64_t>{5, 0, 1}));
}

TEST(to_indexed, keeps_a_lost_vertex_that_is_used_beside_the_mesh) {
  // Vertex 0 goes with its face.
  IndexedMesh source = indexed({{0, 1, 2}, {2, 1, 3}, {}}, 6);
  for (std::size_t v = 0; v < 6; ++v) source.positions[v] = {v, v % 2, 0};
  source.vertex_weights = {1, 2, 3, 4, 5, 6};
  source.quarantine = {aside(2, {0, 0, 3})};
  Mesh mesh = from_indexed(source);
  collapse(mesh, 0, 1);
  CompactMesh compact = to_indexed(mesh, file_tables(source));
  EXPECT_EQ(compact.mesh.positions, source.positions);
  EXPECT_EQ(compact.mesh.vertex_weights, source.vertex_weights);
  EXPECT_EQ(compact.mesh.quarantine[0].corners, (CompactList<std::int64_t>{0, 0, 3}));
  EXPECT_EQ(compact.kept_vertices, 1u);

  FileTables without = file_tables(source);
  without.quarantine.clear();
  compact = to_indexed(mesh, without);
  EXPECT_EQ(compact.mesh.positions.size(), 5u);
  EXPECT_EQ(compact.kept_vertices, 0u);
  const Vertex used[] = {Vertex(0), Vertex(3)};
  compact = to_indexed(mesh, without, used);
  EXPECT_EQ(compact.mesh.positions, source.positions);
  EXPECT_EQ(compact.kept_vertices, 1u);
}

TEST(to_indexed, uses_a_live_point_at_the_very_place_of_a_lost_one) {
  IndexedMesh source = indexed({{0, 1, 2}, {2, 1, 3}, {}}, 6);
  for (std::size_t v = 0; v < 6; ++v) source.positions[v] = {v, v % 2, 0};
  source.positions[3] = source.positions[0];
  source.positions[4] = {std::numeric_limits<double>::quiet_NaN(), 0, 0};
  source.positions[5] = source.positions[1];
  source.quarantine = {aside(2, {3, 1, 3})};
  Mesh mesh = from_indexed(source);
  collapse(mesh, 3, 2);
  EXPECT_EQ(to_indexed(mesh, file_tables(source)).mesh.quarantine[0].corners, (CompactList<std::int64_t>{0, 1, 0}));
  EXPECT_EQ(to_indexed(mesh, file_tables(source)).kept_vertices, 0u);
}

TEST(to_indexed, leaves_its_row_to_a_live_point_that_comes_later) {
  IndexedMesh source = indexed({{0, 1, 2}, {2, 1, 3}, {}}, 5);
  for (std::size_t v = 0; v < 5; ++v) source.positions[v] = {v, v % 2, 0};
  source.positions[4] = source.positions[0];
  source.vertex_weights = {1, 2, 3, 4, 5};
  source.quarantine = {aside(2, {0, 1, 0})};
  Mesh mesh = from_indexed(source);
  collapse(mesh, 0, 1);
  const CompactMesh compact = to_indexed(mesh, file_tables(source));
  EXPECT_EQ(compact.mesh.quarantine[0].corners, (CompactList<std::int64_t>{0, 1, 0}));
  EXPECT_EQ(compact.kept_vertices, 1u);
  EXPECT_EQ(compact.mesh.vertex_weights, source.vertex_weights);
}

}  // namespace
}  // namespace ryosen
