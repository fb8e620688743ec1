#include "ryosen/ops/rules/corner_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// A texture coordinate of its own at each corner, numbered as the corners are listed, and a normal numbered backwards.
Mesh with_corner_values(const Polygons& faces, std::size_t points = 0) {
  IndexedMesh source = indexed(faces, points);
  source.texcoords.components = 2;
  for (std::size_t i = 0; i < source.corners.size(); ++i) {
    const auto x = static_cast<double>(i);
    source.texcoords.pool.emplace_back(x, 0, 0);
    source.texcoords.index.push_back(static_cast<std::uint32_t>(i));
    source.normals.pool.emplace_back(x, 1, 0);
    source.normals.index.push_back(static_cast<std::uint32_t>(source.corners.size() - 1 - i));
  }
  return from_indexed(std::move(source));
}

std::uint32_t value_at(const Mesh& m, std::size_t attribute, Halfedge corner) {
  return m.attributes()[corner_attributes(m)[attribute].index_column].data[corner.index];
}

// "point/texcoord/normal ..." around a face from its first corner.
std::string corners_of(const Mesh& m, Face f) {
  std::string text;
  for (Halfedge h : halfedges_around(m, f)) {
    text += (text.empty() ? "" : " ") + std::to_string(point(m, m.from(h)).index);
    for (std::size_t k = 0; k < corner_attributes(m).size(); ++k) text += "/" + std::to_string(value_at(m, k, h));
  }
  return text;
}

TEST(merge_corner_values, the_face_that_stays_keeps_its_corners) {
  for (const char* op : {"unite_loop", "dissolve"}) {
    for (const char* edge : {" 1-2", " 2-1"}) {
      Mesh mesh = with_corner_values({{0, 1, 2, 3}, {1, 4, 5, 2}});
      apply_and_prove(mesh, op + std::string(edge));
      EXPECT_EQ(corners_of(mesh, Face(0)), "0/0/7 1/1/6 4/5/2 5/6/1 2/2/5 3/3/4") << op << edge;
    }
    Mesh turned = with_corner_values({{1, 4, 5, 2}, {0, 1, 2, 3}});
    apply_and_prove(turned, op + std::string(" 1-2"));
    EXPECT_EQ(corners_of(turned, Face(0)), "1/0/7 4/1/6 5/2/5 2/3/4 3/7/0 0/4/3") << op;
  }
}

TEST(merge_corner_values, a_chain_ends_with_the_values_of_the_face_that_stays) {
  for (const char* line : {"dissolve 1-2", "dissolve 2-3", "dissolve 3-2"}) {
    Mesh mesh = with_corner_values({{0, 1, 2, 3}, {3, 2, 1, 4}});
    apply_and_prove(mesh, line);
    EXPECT_EQ(corners_of(mesh, Face(0)), "0/0/7 1/1/6 4/7/0 3/3/4") << line;
    Mesh turned = with_corner_values({{3, 2, 1, 4}, {0, 1, 2, 3}});
    apply_and_prove(turned, line);
    EXPECT_EQ(corners_of(turned, Face(0)), "3/0/7 0/4/3 1/2/5 4/3/4") << line;
  }
}

TEST(merge_corner_values, around_a_vertex_the_lower_number_of_two_faces_wins) {
  Mesh inside = with_corner_values({{0, 1, 2}, {0, 3, 4}, {0, 4, 1}, {0, 2, 3}});
  apply_and_prove(inside, "dissolve v0");
  EXPECT_EQ(corners_of(inside, Face(0)).find("1/1/10 2/2/9 3/4/7 4/5/6"), 0u) << corners_of(inside, Face(0));
  // On the boundary, where 1-4 is an edge elsewhere, the vertex stays with the corner of the lowest face.
  for (const Polygons& faces :
       {Polygons{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {4, 1, 5}}, Polygons{{0, 2, 3}, {0, 1, 2}, {0, 3, 4}, {4, 1, 5}}}) {
    Mesh boundary = with_corner_values(faces);
    apply_and_prove(boundary, "dissolve v0");
    EXPECT_NE(corners_of(boundary, Face(0)).find("0/0/11"), std::string::npos) << corners_of(boundary, Face(0));
  }
}

TEST(merge_corner_values, a_chain_that_ends_where_it_began_is_none) {
  // The inner triangle 4-6-5 hangs on a bridge 0-4 of the outer face; without it a spike would be left.
  const Mesh mesh = with_corner_values({{0, 1, 2, 3, 0, 4, 5, 6, 4}, {4, 6, 5}});
  EXPECT_EQ(rules_against(mesh, "dissolve 5-6"), "loop");
}

// Every edge of many meshes: each corner of the face that is made has what the lowest-numbered of the two had there.
TEST(merge_corner_values, corners_belong_to_face_and_vertex_on_many_meshes) {
  std::size_t united = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const SeededMesh random = seeded_mesh(seed);
    const Mesh before = with_corner_values(random.faces, random.points);
    for (std::uint32_t e = 0; e < before.edge_slots(); ++e)
      for (const AnyOp& op : {AnyOp(UniteLoop{halfedge(Edge(e))}), AnyOp(Dissolve{halfedge(Edge(e)), {}})}) {
        if (!check(before, op).legal()) continue;
        const Halfedge h = halfedge(Edge(e));
        const auto [low, high] = std::minmax({before.face(h), before.face(twin(h))});
        std::map<Vertex, std::vector<Halfedge>> had;
        for (Face f : {low, high})
          for (Halfedge corner : halfedges_around(before, f)) had[before.from(corner)].push_back(corner);
        Mesh after = before;
        apply_and_prove(after, op);
        ++united;
        for (Halfedge corner : halfedges_around(after, low))
          for (std::size_t k = 0; k < 2; ++k)
            EXPECT_EQ(value_at(after, k, corner), value_at(before, k, had.at(after.from(corner)).front()))
                << "seed " << seed << " " << command_of(before, op);
      }
  }
  EXPECT_GT(united, 100u);
}

TEST(corner_values_of_walls, each_wall_has_the_texture_coordinates_of_its_face_and_no_normals) {
  Mesh mesh = with_corner_values({{0, 1, 2, 3}, {1, 4, 5, 2}});
  apply_and_prove(mesh, "extrude f0 f1 0,0,1");
  EXPECT_EQ(corners_of(mesh, Face(0)), "6/0/7 9/1/6 7/2/5 8/3/4");
  EXPECT_EQ(corners_of(mesh, Face(1)), "9/4/3 10/5/2 11/6/1 7/7/0");
  const std::string none = "/" + std::to_string(no_index);
  const auto wall = [&](const char* a, const char* b, const char* c, const char* d) {
    return a + none + " " + b + none + " " + c + none + " " + d + none;
  };
  EXPECT_EQ(corners_of(mesh, Face(2)), wall("0/0", "1/1", "9/1", "6/0"));
  EXPECT_EQ(corners_of(mesh, Face(3)), wall("2/2", "3/3", "8/3", "7/2"));
  EXPECT_EQ(corners_of(mesh, Face(5)), wall("1/4", "4/5", "10/5", "9/4"));
  EXPECT_EQ(corners_of(mesh, Face(7)), wall("5/6", "2/7", "7/7", "11/6"));
}

TEST(corner_values_of_walls, each_quad_at_an_edge_has_the_texture_coordinates_of_its_face_and_no_normals) {
  Mesh mesh = with_corner_values({{0, 1, 2, 3}, {1, 4, 5, 2}});
  apply_and_prove(mesh, "extrude_edges 0-1 1-4 0,0,1");
  const std::string none = "/" + std::to_string(no_index);
  EXPECT_EQ(corners_of(mesh, Face(2)), "1/1" + none + " 0/0" + none + " 6/0" + none + " 7/1" + none);
  EXPECT_EQ(corners_of(mesh, Face(3)), "4/5" + none + " 1/4" + none + " 7/4" + none + " 8/5" + none);
}

}  // namespace
}  // namespace ryosen
