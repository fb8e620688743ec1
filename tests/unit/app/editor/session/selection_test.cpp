#include "app/editor/session/selection.h"

#include <gtest/gtest.h>

#include <set>

namespace ryosen {
namespace {

TEST(selection, has_another_stamp_after_each_change_and_the_same_where_it_only_is_read_or_copied) {
  Selection selection;
  std::set<std::uint64_t> stamps{0, selection.stamp()};
  const auto is_new = [&] { return stamps.insert(selection.stamp()).second; };
  selection.clear();
  EXPECT_FALSE(is_new()) << "there was nothing";
  selection = {Vertex(3), Face(1)};
  EXPECT_TRUE(is_new());
  selection.push_back(Face(2));
  EXPECT_TRUE(is_new());
  selection.changed().pop_back();
  EXPECT_TRUE(is_new());
  const Selection copy = selection;
  EXPECT_EQ(copy.stamp(), selection.stamp());
  EXPECT_EQ(copy, (Elements{Vertex(3), Face(1)}));
  EXPECT_FALSE(is_new());
  const Selection moved = std::move(selection);
  EXPECT_EQ(moved, copy);
  EXPECT_TRUE(is_new()) << "nothing is left in what was moved";
  EXPECT_TRUE(selection.empty());  // NOLINT(bugprone-use-after-move): that is what is asked
  EXPECT_NE(moved.stamp(), selection.stamp());
}

TEST(selection, counts_by_kind_as_it_is_now) {
  Selection selection;
  EXPECT_EQ(selection.count(Element::Kind::face), 0u);
  selection = {Vertex(3), Face(1), Face(2)};
  EXPECT_EQ(selection.count(Element::Kind::face), 2u);
  EXPECT_EQ(selection.count(Element::Kind::edge), 0u);
  selection.changed().erase(selection.begin());
  EXPECT_EQ(selection.count(Element::Kind::vertex), 0u);
  EXPECT_EQ(selection.count(Element::Kind::face), 2u);
}

}  // namespace
}  // namespace ryosen
