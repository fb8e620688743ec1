#include "ryosen/scene/selection/derived_selections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "ryosen/mesh/circulate.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using Kind = Element::Kind;

std::set<std::uint32_t> numbers(const Elements& elements) {
  std::set<std::uint32_t> all;
  for (const Element& e : elements) all.insert(e.index);
  EXPECT_EQ(all.size(), elements.size()) << "each once";
  return all;
}

std::set<std::uint32_t> corners_of(const Mesh& mesh, Face f) {
  std::set<std::uint32_t> corners;
  for (const Vertex v : vertices_around(mesh, f)) corners.insert(v.index);
  return corners;
}

TEST(conversion, of_a_face_is_its_sides_corners_and_halfedges) {
  const Mesh mesh = test::make_mesh(test::torus_grid(4, 4));
  const Elements face{Face(5)};
  EXPECT_EQ(numbers(converted(mesh, face, Kind::vertex)), corners_of(mesh, Face(5)));
  std::set<std::uint32_t> sides, inner;
  for (const Halfedge h : halfedges_around(mesh, Face(5))) {
    sides.insert(edge(h).index);
    inner.insert(h.index);
  }
  EXPECT_EQ(numbers(converted(mesh, face, Kind::edge)), sides);
  EXPECT_EQ(numbers(converted(mesh, face, Kind::halfedge)), inner);
  EXPECT_EQ(converted(mesh, face, Kind::face), face);
}

TEST(conversion, upwards_takes_what_lies_wholly_in_the_selection_and_else_what_meets_it) {
  const Mesh mesh = test::make_mesh(test::torus_grid(4, 4));
  Elements corners;
  for (const Vertex v : vertices_around(mesh, Face(5))) corners.push_back(v);
  EXPECT_EQ(converted(mesh, corners, Kind::face), Elements{Face(5)});
  EXPECT_EQ(converted(mesh, converted(mesh, corners, Kind::edge), Kind::face), Elements{Face(5)});
  const Elements one{corners[0]};
  std::set<std::uint32_t> around, edges;
  for (const Face f : faces_around(mesh, corners[0].vertex())) around.insert(f.index);
  for (const Edge e : edges_around(mesh, corners[0].vertex())) edges.insert(e.index);
  EXPECT_EQ(numbers(converted(mesh, one, Kind::face)), around);
  EXPECT_EQ(numbers(converted(mesh, one, Kind::edge)), edges);
  EXPECT_EQ(converted(mesh, one, Kind::vertex), one);
}

TEST(conversion, of_a_halfedge_keeps_its_side) {
  const Mesh mesh = test::make_mesh(test::torus_grid(4, 4));
  const Elements one{Halfedge(6)};
  EXPECT_EQ(converted(mesh, one, Kind::halfedge), one);
  EXPECT_EQ(numbers(converted(mesh, one, Kind::edge)), std::set<std::uint32_t>{3});
  EXPECT_EQ(converted(mesh, one, Kind::vertex).size(), 2u);
  EXPECT_EQ(converted(mesh, Elements{Edge(3)}, Kind::halfedge).size(), 2u);
}

TEST(conversion, of_nothing_is_nothing) {
  const Mesh mesh = test::make_mesh(test::torus_grid(3, 3));
  for (const Kind kind : {Kind::vertex, Kind::edge, Kind::halfedge, Kind::face})
    EXPECT_TRUE(converted(mesh, {}, kind).empty());
}

}  // namespace
}  // namespace ryosen
