#include "ryosen/textbook/forms/comparison.h"

#include <gtest/gtest.h>

#include "tests/support/core/shapes.h"

namespace ryosen::forms {
namespace {

using test::make_mesh;

constexpr Effort quick{1e-5, 1e6};

TEST(forms_comparison, measures_everything_that_can_be_asked) {
  const Comparison comparison = compare_forms(make_mesh(test::torus_grid(6, 7)), quick);
  EXPECT_EQ(comparison.vertices, 42u);
  EXPECT_EQ(comparison.edges, 126u);
  EXPECT_EQ(comparison.faces, 84u);
  ASSERT_EQ(comparison.forms.size(), all_forms().size());
  for (const FormFigures& figures : comparison.forms) {
    EXPECT_FALSE(figures.unsuitable) << figures.row->id;
    EXPECT_GT(figures.bytes, 0u);
    for (const RelationRow& relation : relations()) {
      const auto& time = figures.query_seconds[static_cast<std::size_t>(relation.relation)];
      EXPECT_EQ(time.has_value(), figures.row->stores_vertices) << figures.row->id;
      if (time) {
        EXPECT_GT(*time, 0.0);
        EXPECT_LT(*time, 0.1);
      }
    }
  }
  EXPECT_EQ(comparison.pairing.size(), pairing_methods().size());
  EXPECT_EQ(comparison.texts.size(), 4u);
}

TEST(forms_comparison, measures_slow_methods_on_the_first_faces) {
  const IndexedMesh list = test::indexed(test::torus_grid(30, 30));  // 5400 sides
  for (const PairingMethod& method : pairing_methods()) {
    const PairingFigures figures = measure_pairing(list, method, quick);
    EXPECT_EQ(figures.is_whole(), method.id != "brute_force") << method.id;
    EXPECT_EQ(figures.faces, figures.is_whole() ? 1800u : 333u) << method.id;  // (3 * 333)^2 <= 10^6 < (3 * 334)^2
    EXPECT_GT(figures.seconds, 0.0);
  }
  const IndexedMesh fan = test::indexed(test::closed_fan(2000));
  EXPECT_LT(faces_within(fan, pairing_methods()[3], 1e6), 2000u);
}

TEST(forms_comparison, says_why_a_form_does_not_suit) {
  const Comparison comparison = compare_forms(make_mesh(test::fin()), quick);
  std::size_t unsuitable = 0;
  for (const FormFigures& figures : comparison.forms) unsuitable += figures.unsuitable.has_value();
  EXPECT_EQ(unsuitable, all_forms().size() - 4);  // soup, polygons, face set and this program hold it
  EXPECT_EQ(comparison.edges, 7u);
}

// Text 002, section 2.3: halfedges take less memory than a polygon set, and more than an indexed face set. Its own
// halfedge structure (section 3) and its own polygon set (section 2.1) are those to compare.
TEST(forms_comparison, of_memory_is_between_the_forms_that_text_002_compares) {
  const Comparison comparison = compare_forms(make_mesh(test::torus_grid(20, 20)), quick);
  const std::vector<ComparedClaim> claims = compare_claims(comparison);
  ASSERT_EQ(claims.size(), 2u);
  EXPECT_EQ(claims[0].claim->smaller, "halfedge_loop");
  EXPECT_EQ(claims[0].claim->larger, "polygon_set");
  EXPECT_EQ(claims[1].claim->smaller, "indexed_face_set");
  EXPECT_EQ(claims[1].claim->larger, "halfedge_loop");
  for (const ComparedClaim& claim : claims) EXPECT_TRUE(claim.holds) << claim.sentence.en;
  // Of a face: three sides with 5 numbers, half an edge's 2 and, by vertices half as many as faces, 16 bytes of a
  // vertex; one number of a loop. Of a polygon: a list's head of 24 bytes and three places.
  EXPECT_NE(claims[0].sentence.en.find("halfedge, loops and parent edges 92, polygon set 96"), std::string::npos)
      << claims[0].sentence.en;
  EXPECT_NE(claims[0].sentence.ja.find("92"), std::string::npos) << claims[0].sentence.ja;
  for (const ComparedClaim& claim : claims)
    for (const std::string& text : {claim.sentence.en, claim.sentence.ja})
      EXPECT_NE(text.find("002"), std::string::npos) << text;
}

// Of triangles there are half as many vertices as faces, of quads as many: the vertices of a grid of quads outweigh.
TEST(forms_comparison, says_where_text_002_is_not_right_and_why) {
  test::Polygons grid;
  constexpr std::uint32_t n = 20;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const auto at = [&](std::uint32_t a, std::uint32_t b) { return a % n * n + b % n; };
      grid.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  const std::vector<ComparedClaim> claims = compare_claims(compare_forms(make_mesh(grid), quick));
  ASSERT_EQ(claims.size(), 2u);
  EXPECT_FALSE(claims[0].holds);
  // 32 of a vertex, 4 sides of 24, 4 of a loop; against 24 and 4 places.
  EXPECT_NE(claims[0].sentence.en.find(" 132, polygon set 120"), std::string::npos) << claims[0].sentence.en;
  EXPECT_TRUE(claims[1].holds);
  // The words of the reason: what a vertex, a loop and a list's head take.
  for (const char* const bytes : {"24", "4", "32"})
    EXPECT_NE(claims[0].claim->why_en.find(bytes), std::string_view::npos) << bytes;
  EXPECT_TRUE(compare_claims(compare_forms(Mesh(), quick)).empty());
}

TEST(forms_comparison, writes_figures_shortly) {
  EXPECT_EQ(figure_text(66.094), "66.1");
  EXPECT_EQ(figure_text(8), "8");
  EXPECT_EQ(figure_text(509175.4), "509175");
  EXPECT_EQ(duration_text(3.41e-7), "341 ns");
  EXPECT_EQ(duration_text(2.5e-5), "25 \u00b5s");
  EXPECT_EQ(duration_text(0.1174), "117 ms");
}

TEST(forms_comparison, asks_nothing_of_an_empty_mesh) {
  const Comparison comparison = compare_forms(Mesh(), quick);
  for (const FormFigures& figures : comparison.forms)
    for (const auto& time : figures.query_seconds) EXPECT_FALSE(time);
}

}  // namespace
}  // namespace ryosen::forms
