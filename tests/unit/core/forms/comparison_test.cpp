#include "core/forms/comparison.h"

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
      const bool map_about_vertex = figures.row->id == "opposite_map" && relation.asks == ElementOf::vertex;
      EXPECT_EQ(time.has_value(), figures.row->id != "triangle_soup" && !map_about_vertex) << figures.row->id;
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
  EXPECT_EQ(unsuitable, all_forms().size() - 3);  // soup, face set and this program hold it
  EXPECT_EQ(comparison.edges, 7u);
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
