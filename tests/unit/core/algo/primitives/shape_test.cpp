// How primitives come into a mesh: as one entry of the history, beside what is there, or not at all.
#include "ryosen/algo/primitives/shape.h"
#include "ryosen/algo/algorithm_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "ryosen/algo/algorithm_rows.h"
#include "ryosen/analysis/euler_poincare.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/invariants.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

// A fin, which has copies, with values of vertices, corners and faces, and a removed face.
Mesh mesh_with_everything() {
  IndexedMesh source = indexed(fin(), 6);
  source.texcoords.pool = {{0, 0, 0}, {1, 0, 0}};
  source.texcoords.index.assign(source.corners.size(), 1);
  source.materials.names = {"red"};
  source.materials.index.assign(source.face_count(), 0);
  source.vertex_colours.assign(source.positions.size(), {1, 0.5, 0, 1});
  Mesh mesh = from_indexed(std::move(source));
  Edit edit(mesh, nullptr);
  ryosen::apply(edit, *parse_line(mesh, "delete f0").op);
  edit.commit();
  return mesh;
}

template <class List>
bool begins_with(const List& longer, const List& shorter) {
  return longer.size() >= shorter.size() &&
         std::memcmp(longer.data(), shorter.data(), shorter.size() * sizeof(shorter[0])) == 0;
}

void expect_kept(const MeshColumns& before, const MeshColumns& after) {
  EXPECT_TRUE(begins_with(after.positions, before.positions));
  EXPECT_TRUE(begins_with(after.vertex_halfedge, before.vertex_halfedge));
  EXPECT_TRUE(begins_with(after.halfedges, before.halfedges));
  EXPECT_TRUE(begins_with(after.face_halfedge, before.face_halfedge));
  EXPECT_TRUE(begins_with(after.next_copy, before.next_copy));
  ASSERT_EQ(after.attributes.size(), before.attributes.size());
  for (std::size_t i = 0; i < before.attributes.size(); ++i) {
    SCOPED_TRACE(before.attributes[i].name);
    const AttributeColumn& column = after.attributes[i];
    EXPECT_TRUE(begins_with(column.data, before.attributes[i].data));
    for (std::size_t k = before.attributes[i].data.size(); k < column.data.size(); ++k)
      EXPECT_EQ(column.data[k], column.fill[k % column.words()]) << "new elements have no value";
  }
}

TEST(shapes, leave_what_is_there_as_it_is_and_undo_is_exact) {
  for (const AlgorithmRow& row : primitive_rows()) {
    SCOPED_TRACE(row.id);
    Mesh mesh = mesh_with_everything();
    const MeshColumns before = mesh.columns();
    const std::int64_t parts = euler_poincare(mesh).parts;
    Journal journal;
    EXPECT_GT(run_algorithm(mesh, journal, row.id).changed, 0u);
    const auto broken = check_invariants(mesh);
    EXPECT_FALSE(broken) << broken->sentence;
    expect_kept(before, mesh.columns());
    EXPECT_EQ(euler_poincare(mesh).parts, parts + 1);
    const MeshColumns after = mesh.columns();
    journal.undo(mesh);
    EXPECT_EQ(mesh.columns(), before);
    journal.redo(mesh);
    EXPECT_EQ(mesh.columns(), after);
  }
}

TEST(shapes, that_are_added_twice_are_two_components) {
  for (const AlgorithmRow& row : primitive_rows()) {
    SCOPED_TRACE(row.id);
    Mesh mesh;
    Journal journal;
    const std::string id(row.id);
    const AlgorithmResult first = run_algorithm(mesh, journal, id);
    const AlgorithmResult second = run_algorithm(mesh, journal, id + " at=9,0,0");
    EXPECT_EQ(first.changed, second.changed);
    EXPECT_EQ(mesh.live().faces, first.changed + second.changed);
    EXPECT_EQ(euler_poincare(mesh).parts, 2);
    EXPECT_EQ(mesh.position(Vertex(mesh.vertex_slots() / 2)) - mesh.position(Vertex(0)), glm::dvec3(9, 0, 0));
    journal.undo(mesh);
    EXPECT_EQ(mesh.live().faces, first.changed);
    journal.undo(mesh);
    EXPECT_EQ(mesh.columns(), MeshColumns());
  }
}

TEST(shapes, say_what_was_added) {
  Mesh mesh;
  Journal journal;
  const AlgorithmResult one = run_algorithm(mesh, journal, "grid columns=1 rows=1");
  EXPECT_EQ(one.text.en, "4 vertices, 4 edges and 1 face were added.");
  EXPECT_EQ(one.text.ja, "頂点 4、稜線 4、面 1 を追加しました。");
  EXPECT_EQ(run_algorithm(mesh, journal, "cube").text.en, "8 vertices, 12 edges and 6 faces were added.");
}

TEST(shapes, whose_values_do_not_go_together_are_not_added_and_it_is_said_why) {
  const std::pair<const char*, Text> cases[]{
      {"torus radius=1 tube=1",
       {"the radius of the tube (1) must be less than that of the circle it follows (1)",
        "管の半径（1）は中心円の半径（1）より小さくしてください"}},
      {"cube at=1e17,0,0",
       {"the values are too far apart, the shape would have 4 of the kind degenerate_area",
        "値の差が大きすぎます（形状に「面積ゼロの面」が 4 できるため）"}},
      {"cube size=1e308 at=1.7e308,0,0",
       {"the values are too far apart, the shape would have 4 of the kind nonfinite_vertex",
        "値の差が大きすぎます（形状に「座標が有限でない頂点」が 4 できるため）"}},
  };
  for (const auto& [line, fault] : cases) {
    SCOPED_TRACE(line);
    Mesh mesh = make_mesh(cube());
    const MeshColumns before = mesh.columns();
    Journal journal;
    const AlgorithmResult result = run_algorithm(mesh, journal, line);
    ASSERT_TRUE(result.fault);
    EXPECT_EQ(result.fault->en, fault.en);
    EXPECT_EQ(result.fault->ja, fault.ja);
    EXPECT_EQ(result.changed, 0u);
    EXPECT_EQ(mesh.columns(), before);
    EXPECT_FALSE(journal.can_undo());
  }
}

TEST(shapes, refuse_values_out_of_their_range_in_both_languages) {
  const std::pair<const char*, Text> cases[]{
      {"cube size=0",
       {"size is a length above 0, in units of the mesh or with % of its diagonal, not '0'",
        "size は長さ（0 より大きく、メッシュの単位、% を付けると対角線に対する割合）です（「0」は使えません）"}},
      {"sphere segments=2",
       {"segments is a whole number from 3 to 1000, not '2'",
        "segments は整数（3 以上 1000 以下）です（「2」は使えません）"}},
      {"sphere bands=1001",
       {"bands is a whole number from 2 to 1000, not '1001'",
        "bands は整数（2 以上 1000 以下）です（「1001」は使えません）"}},
      {"cone caps=quads",
       {"caps is one of polygon, fan, none, not 'quads'",
        "caps は polygon、fan、none のいずれかです（「quads」は使えません）"}},
      {"grid at=1,2",
       {"at is a place X,Y,Z, in units of the mesh, not '1,2'",
        "at は座標 X,Y,Z（メッシュの単位）です（「1,2」は使えません）"}},
  };
  for (const auto& [line, fault] : cases) {
    const std::vector<std::string_view> words = split_words(line);
    const ReadValues read = read_values(find_algorithm(words[0])->parameters, std::span(words).subspan(1));
    EXPECT_FALSE(read.values) << line;
    EXPECT_EQ(read.sentence.en, fault.en);
    EXPECT_EQ(read.sentence.ja, fault.ja);
  }
}

TEST(shapes, take_points_on_a_circle_that_mirror_each_other_exactly) {
  for (const std::size_t count : {3u, 4u, 6u, 8u, 12u, 100u, 1000u}) {
    const std::vector<glm::dvec2> points = points_on_circle(count);
    ASSERT_EQ(points.size(), count);
    EXPECT_EQ(points[0], glm::dvec2(1, 0));
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
      EXPECT_NEAR(points[i].x, std::cos(angle), 2e-15);
      EXPECT_NEAR(points[i].y, std::sin(angle), 2e-15);
      EXPECT_EQ(points[i], glm::dvec2(1, -1) * points[(count - i) % count]) << i << " of " << count;
    }
  }
}

}  // namespace
}  // namespace ryosen::test
