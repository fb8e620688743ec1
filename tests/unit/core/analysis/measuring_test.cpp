#include "ryosen/analysis/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// 2 by 3 by 6; vertex 4 k + i stands above vertex i.
Mesh measured_box() {
  IndexedMesh source = indexed({{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
  source.positions = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}, {0, 0, 6}, {2, 0, 6}, {2, 3, 6}, {0, 3, 6}};
  return from_indexed(std::move(source));
}

Edge edge_between(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  return edge(find_halfedge(mesh, Vertex(a), Vertex(b)));
}

// The names and values, one after the other.
std::string measured_list(const Mesh& mesh, const std::vector<Element>& elements) {
  std::string all;
  for (const MeasuredValue& each : measure(mesh, elements).values) {
    char value[40];
    std::snprintf(value, sizeof value, " %.10g", each.value);
    all += (all.empty() ? "" : ", ") + each.name.en + value;
  }
  return all;
}

TEST(measuring, of_a_box_is_what_one_computes_by_hand) {
  const Mesh box = measured_box();
  EXPECT_EQ(measured_list(box, {Vertex(0), Vertex(6)}), "distance 7");
  EXPECT_EQ(measured_list(box, {edge_between(box, 0, 4)}), "length 6");
  EXPECT_EQ(measured_list(box, {Face(0)}), "area 6, perimeter 10");
  EXPECT_EQ(measured_list(box, {Vertex(0), edge_between(box, 2, 6)}), "distance 3.605551275");
  EXPECT_EQ(measured_list(box, {Vertex(0), Face(1)}), "distance 6");
  EXPECT_EQ(measured_list(box, {Face(0), Face(1)}), "distance 6, angle 180");
  EXPECT_EQ(measured_list(box, {Face(0), Face(2)}), "distance 0, angle 90");
  EXPECT_EQ(measured_list(box, {edge_between(box, 0, 1), edge_between(box, 2, 6)}), "distance 3, angle 90");
  EXPECT_EQ(measured_list(box, {edge_between(box, 0, 1), edge_between(box, 3, 2)}), "distance 3, angle 0");
  EXPECT_EQ(measured_list(box, {Vertex(1), Vertex(0), Vertex(3)}), "angle 90, distance 2, distance 3");
  EXPECT_EQ(measured_list(box, {Face(0), Face(1), Face(2), Face(3), Face(4), Face(5)}), "area 72, volume 36");
  EXPECT_EQ(measured_list(box, {Face(0), Face(2), Face(3)}), "area 36, perimeter 22");
  EXPECT_EQ(measured_list(box, {Vertex(0)}), "");
}

TEST(measuring, says_nothing_where_a_place_is_not_finite) {
  IndexedMesh source = indexed({{0, 1, 2}});
  source.positions = {{0, 0, 0}, {std::numeric_limits<double>::infinity(), 0, 0}, {0, 1, 0}};
  const Mesh mesh = from_indexed(std::move(source));
  EXPECT_EQ(measured_list(mesh, {Vertex(0), Vertex(1)}), "");
  EXPECT_EQ(measured_list(mesh, {Face(0)}), "");
  EXPECT_EQ(measured_list(mesh, {Vertex(0), Vertex(1), Vertex(2)}), "");
  EXPECT_EQ(measured_list(mesh, {Vertex(0), Vertex(2)}), "distance 1");
}

TEST(measures, of_faces_and_edges_are_what_one_computes_by_hand) {
  const Mesh box = measured_box();
  Neighbourhood around(box);
  for (std::uint32_t e = 0; e < box.edge_slots(); ++e) EXPECT_NEAR(dihedral_angle_deg(around, Edge(e)), 90, 1e-12);
  const CornerAngles angles = corner_angles(around, Face(0));
  EXPECT_NEAR(angles.smallest_deg, 90, 1e-12);
  EXPECT_NEAR(angles.largest_deg, 90, 1e-12);
  EXPECT_NEAR(aspect_ratio(box, Face(0)), 3 * 5 / (2 * 6.0), 1e-12) << "longest side times half perimeter over area";
  EXPECT_EQ(distance_from_plane(around, Face(0)), 0);
}

TEST(measures, of_special_faces_are_what_one_computes_by_hand) {
  IndexedMesh source = indexed({{0, 1, 2}, {3, 4, 5, 6}, {7, 8, 9, 10}});
  const double high = std::sqrt(3.0) / 2;
  source.positions = {{0, 0, 0}, {1, 0, 0},  {0.5, high, 0},              // regular
                      {0, 0, 0}, {1, 0, 0},  {1, 1, 1},      {0, 1, 0},   // one corner lifted
                      {0, 0, 0}, {2, -2, 0}, {1, 0, 0},      {2, 2, 0}};  // a dart that points inwards at (1, 0)
  const Mesh mesh = from_indexed(std::move(source));
  Neighbourhood around(mesh);
  EXPECT_NEAR(aspect_ratio(mesh, Face(0)), 1, 1e-12);
  EXPECT_NEAR(corner_angles(around, Face(0)).largest_deg, 60, 1e-12);
  EXPECT_NEAR(face_area(mesh, Face(0)), high / 2, 1e-12);
  EXPECT_NEAR(corner_angles(around, Face(2)).largest_deg, 360 - 2 * std::atan(2.0) * 180 / 3.14159265358979, 1e-9);
  // The normal of the lifted square is along (-1, -1, 2), its corners are 1, -1, 1, -1 quarters of (0, 0, 1) off.
  EXPECT_NEAR(distance_from_plane(around, Face(1)), 0.25 * 2 / std::sqrt(6.0), 1e-12);
  EXPECT_TRUE(std::isnan(dihedral_angle_deg(around, Edge(0)))) << "a boundary";
}

}  // namespace
}  // namespace ryosen
