// What is found in a mesh serves each of its views: what one shows of it takes nothing from another.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/editor/document/findings.h"
#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"
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

  // Whether the feed says more than what has changed, since it was asked last.
  bool is_all_anew() {
    const ChangeFeed::Changes changes = findings().changes().since(seen_);
    seen_ = changes.now;
    return changes.everything;
  }

  ViewState second_;
  Session session_{Document::open(test::asset("stanford_bunny.obj")).value()};
  ChangeFeed::Cursor seen_;
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
  EXPECT_NE(of_first, of_second);
  EXPECT_EQ(&findings().map_values(*session_.view.colouring), of_first) << "kept";
  is_all_anew();
  ASSERT_TRUE(session_.run("split e0").done());
  EXPECT_EQ(&findings().map_values(*session_.view.colouring), of_first) << "followed, not made anew";
  EXPECT_EQ(&findings().map_values(*second_.colouring), of_second);
  EXPECT_FALSE(is_all_anew());
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
  const auto cut = pick(session_.view);
  EXPECT_TRUE(!cut || cut->element != whole->element) << "what lay in front is cut off";
  ASSERT_TRUE(pick(second_));
  EXPECT_EQ(pick(second_)->element, whole->element);
}

TEST_F(FindingsOfViews, normals_are_kept_while_any_is_smooth) {
  second_.settings.shading = Shading::smooth;
  session_.view.settings.shading = Shading::flat;
  findings().corner_normals();
  is_all_anew();
  ASSERT_TRUE(session_.run("split e0").done());
  EXPECT_FALSE(is_all_anew()) << "followed";
  EXPECT_EQ(findings().corner_normals().packed().size(), findings().picker().triangles().slots());
  findings().remove_view(second_);
  ASSERT_TRUE(session_.run("split e1").done());
  EXPECT_TRUE(is_all_anew()) << "nobody wants them any more";
}

TEST_F(FindingsOfViews, another_document_serves_the_same_views) {
  const HighlightRow& row = *std::find_if(highlight_table().begin(), highlight_table().end(),
                                          [](const HighlightRow& each) { return each.has_predicate(); });
  session_.view.highlights.erase(std::string(row.id));
  second_.highlights.insert(std::string(row.id));
  ASSERT_TRUE(session_.run("open " + test::asset("cube.obj")).done());
  EXPECT_TRUE(findings().highlights().keeps(row));
}

// Nobody has asked for the triangles here.
TEST(findings, the_feed_tells_what_is_hidden_and_coloured_where_nothing_is_picked) {
  Session session(Document::open(test::asset("cube.obj")).value());
  ChangeFeed::Cursor seen = session.findings().changes().since({}).now;
  const auto faces = [&] {
    ChangeFeed::Changes changes = session.findings().changes().since(seen);
    seen = changes.now;
    EXPECT_FALSE(changes.everything);
    return changes.faces;
  };
  ASSERT_TRUE(session.run("hide f3").done());
  EXPECT_EQ(faces(), std::vector<std::uint32_t>{3});
  session.view.colouring = Colouring{find_colour_map("area"), {}};
  session.findings().map_values(*session.view.colouring);
  ASSERT_TRUE(session.run("move_vertex 0 5,5,5").done());
  const std::vector<std::uint32_t> changed = faces();
  for (const Face f : faces_around(session.mesh(), Vertex(0)))
    EXPECT_NE(std::find(changed.begin(), changed.end(), f.index), changed.end()) << f.index;
}

}  // namespace
}  // namespace ryosen
