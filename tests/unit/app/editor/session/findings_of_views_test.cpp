// What is found in a mesh serves each of its views: what one shows of it takes nothing from another.
#include <gtest/gtest.h>

#include "app/editor/session/findings.h"
#include "app/editor/session/session.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class FindingsOfViews : public testing::Test {
 protected:
  FindingsOfViews() {
    second_.camera = session_.view.camera;
    second_.size = session_.view.size;
    session_.findings().add_view(second_);
  }
  Findings& findings() { return session_.findings(); }

  Session session_{Document::open(test::asset("stanford_bunny.obj")).value()};
  ViewState second_;
};

TEST_F(FindingsOfViews, highlights_are_kept_while_any_shows_them) {
  const HighlightRow& row = *std::find_if(highlight_table().begin(), highlight_table().end(),
                                          [](const HighlightRow& each) { return each.has_predicate(); });
  const std::string id(row.id);
  session_.view.highlights.erase(id);
  EXPECT_FALSE(findings().highlights().keeps(row));
  second_.highlights.insert(id);
  EXPECT_TRUE(findings().highlights().keeps(row));
  session_.view.highlights.insert(id);
  second_.highlights.clear();
  EXPECT_TRUE(findings().highlights().keeps(row));
  session_.view.highlights.erase(id);
  EXPECT_FALSE(findings().highlights().keeps(row));
}

TEST_F(FindingsOfViews, each_is_coloured_by_its_own_map_and_both_follow_edits) {
  const ColourMap* const area = find_colour_map("area");
  const ColourMap* const valence = find_colour_map("valence");
  ASSERT_TRUE(area && valence);
  session_.view.colouring = Colouring{area, {}};
  second_.colouring = Colouring{valence, {}};
  const MapValues* const of_first = &findings().map_values(*session_.view.colouring);
  const MapValues* const of_second = &findings().map_values(*second_.colouring);
  EXPECT_EQ(&findings().map_values(*session_.view.colouring), of_first) << "kept";
  ASSERT_TRUE(session_.run("split e0").done());
  EXPECT_EQ(&findings().map_values(*session_.view.colouring), of_first) << "followed, not made anew";
  EXPECT_EQ(&findings().map_values(*second_.colouring), of_second);
  for (const ColourMap* const map : {area, valence}) {
    const MapValues anew(session_.mesh(), *map, 0, nullptr);
    const Colouring colouring{map, {}};
    const MapFigures kept = figures_of(findings().map_values(colouring).all()), right = figures_of(anew.all());
    EXPECT_EQ(kept.count, right.count);
    EXPECT_EQ(kept.lowest, right.lowest);
    EXPECT_EQ(kept.highest, right.highest);
    EXPECT_EQ(findings().map_extent(colouring), (MapRange{right.lowest, right.highest}));
  }
}

TEST_F(FindingsOfViews, each_picks_where_it_is_cut_itself) {
  const glm::dvec2 middle(session_.view.size.width / 2.0, session_.view.size.height / 2.0);
  const auto pick = [&](const ViewState& view) {
    return findings().picker(view).pick(session_.mesh(), view.camera, view.size, middle, PickMode::face);
  };
  const auto whole = pick(session_.view);
  ASSERT_TRUE(whole);
  ASSERT_TRUE(session_.run("clip view").done());
  second_.cut.reset();
  const auto cut = pick(session_.view);
  EXPECT_TRUE(!cut || cut->element != whole->element) << "what lay in front is cut off";
  ASSERT_TRUE(pick(second_));
  EXPECT_EQ(pick(second_)->element, whole->element);
}

TEST_F(FindingsOfViews, normals_are_kept_while_any_is_smooth) {
  second_.settings.shading = Shading::smooth;
  session_.view.settings.shading = Shading::flat;
  const CornerNormals* const normals = &findings().corner_normals();
  ASSERT_TRUE(session_.run("split e0").done());
  EXPECT_EQ(&findings().corner_normals(), normals);
  EXPECT_EQ(normals->packed().size(), findings().picker().triangles().slots());
}

}  // namespace
}  // namespace ryosen
