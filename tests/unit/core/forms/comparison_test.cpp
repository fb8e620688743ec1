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
      EXPECT_EQ(time.has_value(), figures.row->keeps_numbers && !map_about_vertex) << figures.row->id;
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

// The records of the listings of the source texts, and a node of the lists that hold them.
struct ListedVertex {
  double x, y, z;
  void* halfedge;
};
struct ListedHalfedge {
  void *vertex, *face, *pair, *next, *prev;
};
struct ListedFace {
  void* halfedge;
};
struct ListedTriangle {
  double corners[9];
};
struct ListNode {
  void *before, *behind, *element;
};

TEST(forms_comparison, tells_where_the_texts_order_two_forms_by_memory_the_other_way) {
  const Comparison comparison = compare_forms(make_mesh(test::torus_grid(20, 20)), quick);
  const std::vector<SizeClaim> claims = contradicted_claims(comparison);
  ASSERT_EQ(claims.size(), 1u);
  EXPECT_EQ(claims[0].smaller, "halfedge");
  EXPECT_EQ(claims[0].larger, "triangle_soup");
  const auto bytes = [&](std::string_view id) {
    for (const FormFigures& figures : comparison.forms)
      if (figures.row->id == id) return figures.bytes;
    return std::size_t{0};
  };
  EXPECT_GT(bytes("halfedge"), bytes("triangle_soup"));
  // With a normal at each point, which the soup holds at each corner, it is as the texts say.
  constexpr std::size_t normal = 3 * sizeof(double);
  EXPECT_LT(bytes("halfedge") + comparison.vertices * normal, bytes("triangle_soup") + 3 * comparison.faces * normal);
  // What else the texts say of memory holds.
  EXPECT_LT(bytes("indexed_face_set"), bytes("halfedge"));
  EXPECT_LT(bytes("indexed_face_set"), bytes("triangle_soup"));
  // Half as many vertices as faces.
  constexpr std::size_t listed_halfedges = (sizeof(ListedVertex) + sizeof(ListNode)) / 2 + 3 * sizeof(ListedHalfedge) +
                                           sizeof(ListedFace) + sizeof(ListNode);
  for (const std::string_view why : {claims[0].why_en, claims[0].why_ja}) {
    EXPECT_NE(why.find(std::to_string(listed_halfedges)), why.npos) << why;
    EXPECT_NE(why.find(std::to_string(sizeof(ListedTriangle) + sizeof(ListNode))), why.npos) << why;
  }
  EXPECT_TRUE(contradicted_claims(compare_forms(make_mesh(test::cube()), quick)).empty()) << "a soup holds no quads";
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
