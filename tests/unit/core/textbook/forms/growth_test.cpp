// The growth of the forms' work: what is counted is judged by its slope, never what is timed.
#include "ryosen/textbook/forms/growth/growth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/growth/meshes.h"
#include "ryosen/textbook/forms/pairing.h"
#include "tests/support/core/shapes.h"

namespace ryosen::forms {
namespace {

using test::make_mesh;

std::vector<GrowthCurve> measured(std::span<const Mesh> meshes) {
  Progress progress;
  return measure_growth(meshes, {60'000, 2e7, 1e-6}, progress);
}

const std::vector<GrowthCurve>& on_tori() {
  static const std::vector<GrowthCurve> curves = measured(growing_tori(4000));
  return curves;
}

double count_slope(std::string_view id, GrowthOf of, std::optional<Relation> relation = {}) {
  for (const GrowthCurve& curve : on_tori())
    if (curve.of == of && curve.id == id && curve.relation == relation) return slope_of_count(curve).value_or(-1);
  ADD_FAILURE() << id;
  return -1;
}

TEST(growth, of_the_comparisons_is_the_square_for_all_pairs_alone) {
  for (const PairingMethod& method : pairing_methods()) {
    const double slope = count_slope(method.id, GrowthOf::pairing);
    if (method.id == "brute_force")
      EXPECT_NEAR(slope, 2, 0.01);
    else if (method.id == "sort")  // n log n
      EXPECT_NEAR(slope, 1.15, 0.1);
    else
      EXPECT_NEAR(slope, 1, 0.05) << method.id;
  }
}

TEST(growth, of_a_query_is_in_proportion_where_all_faces_are_looked_through_and_else_none) {
  const std::set<std::string_view> places{"triangle_soup", "polygon_set"};
  std::size_t curves = 0;
  for (const GrowthCurve& curve : on_tori()) {
    if (curve.of != GrowthOf::query) continue;
    ++curves;
    const bool is_own = curve.relation == Relation::face_vertices || curve.relation == Relation::face_edges;
    const bool is_about_vertex = relations()[static_cast<std::size_t>(*curve.relation)].asks == ElementOf::vertex;
    // Text 003's map leads from no vertex: it is searched through for that.
    const bool is_searched =
        !is_own && (curve.id == "indexed_face_set" || (curve.id == "opposite_map" && is_about_vertex));
    EXPECT_FALSE(places.contains(curve.id)) << "stores no vertex that could be asked about";
    const std::optional<double> slope = slope_of_count(curve);
    if (curve.relation == Relation::edge_vertices && (curve.id == "indexed_face_set" || curve.id == "face_adjacency")) {
      EXPECT_FALSE(slope) << "its ends are what it is asked by: nothing is read";
      continue;
    }
    ASSERT_TRUE(slope) << curve.id << static_cast<int>(*curve.relation);
    EXPECT_NEAR(*slope, is_searched ? 1 : 0, 0.02) << curve.id << static_cast<int>(*curve.relation);
  }
  EXPECT_EQ(curves, (all_forms().size() - places.size()) * relation_count);
}

TEST(growth, of_a_collapse_is_that_of_the_lists) {
  EXPECT_NEAR(count_slope("halfedge_lists", GrowthOf::collapse), 1, 0.1);
  EXPECT_NEAR(count_slope("halfedge", GrowthOf::collapse), 0, 0.02);
  EXPECT_NEAR(count_slope("ryosen", GrowthOf::collapse), 0, 0.05);
}

// The counted run of a method is the method: its partners are the same, and its comparisons those of the definition.
TEST(growth, counts_what_a_method_compares) {
  const IndexedMesh list = test::indexed(test::torus_grid(7, 9));
  std::map<std::string_view, std::uint64_t> comparisons;
  for (const PairingMethod& method : pairing_methods()) {
    std::uint64_t count = 0;
    EXPECT_EQ(method.pair_counting(list, count), method.pair(list)) << method.id;
    comparisons[method.id] = count;
  }
  const std::uint64_t sides = list.corners.size();
  EXPECT_EQ(comparisons["brute_force"], sides * sides);
  // Each side against all that leave its two ends: the valence is six everywhere.
  EXPECT_EQ(comparisons["vertex_lists"], sides * 12);
  for (const auto& [id, count] : comparisons) {
    EXPECT_GE(count, sides / 2) << id << ": each pair was compared";
    EXPECT_LE(count, sides * (id == "brute_force" ? sides : 40)) << id;
  }
}

TEST(growth, meshes_are_the_text_s_torus_and_sizes_around_it) {
  const std::vector<Mesh> tori = growing_tori(4000);
  std::vector<std::uint32_t> faces;
  for (const Mesh& torus : tori) {
    faces.push_back(torus.live().faces);
    EXPECT_EQ(torus.live().vertices + torus.live().faces, torus.live().edges) << "genus 1";
  }
  EXPECT_EQ(faces, (std::vector<std::uint32_t>{56, 112, 224, 448, 896, 1792, 3584}));
  auto figure = read_mesh_file(RYOSEN_SOURCE_DIR "/assets/figures/000-11.txt");
  ASSERT_TRUE(figure.ok());
  const IndexedMesh text = std::move(figure->mesh), made = to_indexed(tori[4]).mesh;
  EXPECT_EQ(made.corners, text.corners);
  for (std::size_t v = 0; v < made.positions.size(); ++v)
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(made.positions[v][axis], text.positions[v][axis], 1e-5) << v;
}

TEST(growth, parts_of_a_mesh_are_connected_and_have_no_copies) {
  const Mesh torus = make_mesh(test::torus_grid(20, 30));
  std::uint32_t before = 0;
  for (const Mesh& part : growing_parts(torus, 1000)) {
    EXPECT_GT(part.live().faces, before);
    before = part.live().faces;
    EXPECT_FALSE(part.has_copies());
    EXPECT_FALSE(why_unsuitable(part, *find_form("halfedge")));
  }
  EXPECT_EQ(before, 1000u);
  EXPECT_TRUE(growing_parts(Mesh(), 1000).empty());
  // Where corners meet, and on non-manifold edges, the part is cut.
  for (const auto& faces : {test::bow_tie(), test::fin()}) {
    const Mesh part = part_of(make_mesh(faces), 100);
    EXPECT_FALSE(part.has_copies());
    EXPECT_EQ(part.live().faces, make_mesh(faces).live().faces);
  }
  const std::vector<GrowthCurve> curves = measured(growing_parts(torus, 1000));
  ASSERT_EQ(curves[0].id, "brute_force");
  EXPECT_NEAR(*slope_of_count(curves[0]), 2, 0.01);
}

TEST(growth, slopes_are_those_of_powers) {
  for (const double power : {0.0, 1.0, 1.5, 2.0}) {
    GrowthCurve curve;
    for (const double faces : {10.0, 30.0, 500.0, 7000.0})
      curve.points.push_back({static_cast<std::size_t>(faces), 3 * std::pow(faces, power), 0});
    EXPECT_NEAR(*slope_of_count(curve), power, 1e-12);
    EXPECT_FALSE(slope_of_time(curve)) << "nothing but zeros";
  }
  EXPECT_FALSE(slope_of_count({}));
  EXPECT_EQ(slope_text({}), "-");
  EXPECT_EQ(slope_text(-0.001), "0.00");
  EXPECT_EQ(slope_text(1.996), "2.00");
}

TEST(growth, ends_when_it_is_cancelled) {
  const std::vector<Mesh> tori = growing_tori(4000);
  int asked = 0;
  Progress progress([&](double) { return ++asked < 5; }, {});
  EXPECT_TRUE(measure_growth(tori, {}, progress).empty());
  EXPECT_EQ(asked, 5);
}

}  // namespace
}  // namespace ryosen::forms
