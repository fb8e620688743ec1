#include "ryosen/scene/view/named_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>

namespace ryosen {
namespace {

TEST(named_views, look_along_their_axes_at_all_of_the_points) {
  struct Row {
    const char* id;
    glm::dvec3 forward, up;
  };
  const double third = 1 / std::sqrt(3.0);
  const Row rows[] = {{"front", {0, 0, -1}, {0, 1, 0}},     {"back", {0, 0, 1}, {0, 1, 0}},
                      {"right", {-1, 0, 0}, {0, 1, 0}},     {"left", {1, 0, 0}, {0, 1, 0}},
                      {"top", {0, -1, 0}, {0, 0, -1}},      {"bottom", {0, 1, 0}, {0, 0, 1}},
                      {"iso", {-third, -third, -third}, {}}};
  ASSERT_EQ(named_views().size(), std::size(rows));
  const glm::dvec3 points[] = {{5, -3, 2}, {7, -2, 2}, {6, -3, 4}};
  for (const Row& row : rows) {
    const NamedView* const named = find_named_view(row.id);
    ASSERT_TRUE(named) << row.id;
    const Camera camera = fitted(camera_along(*named), points, 16.0 / 9);
    EXPECT_LT(glm::length(axes(camera).forward - row.forward), 1e-12) << row.id;
    if (row.up != glm::dvec3(0)) {
      EXPECT_LT(glm::length(axes(camera).up - row.up), 1e-12) << row.id;
    }
    for (const glm::dvec3& point : points) {
      const auto seen = project(camera, {1600, 900}, point);
      ASSERT_TRUE(seen) << row.id;
      EXPECT_TRUE(seen->pixel.x > 0 && seen->pixel.x < 1600 && seen->pixel.y > 0 && seen->pixel.y < 900) << row.id;
    }
  }
  EXPECT_FALSE(find_named_view("sideways"));
}

TEST(named_views, have_ids_names_and_keys_of_their_own) {
  std::set<std::string_view> ids, names, chords;
  std::string all;
  for (const NamedView& row : named_views()) {
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_TRUE(names.insert(row.name_en).second && names.insert(row.name_ja).second) << row.id;
    EXPECT_TRUE(row.chord.empty() || chords.insert(row.chord).second) << row.id;
    EXPECT_EQ(row.chord.empty(), row.key_en.empty() && row.key_ja.empty()) << row.id;
    all += (all.empty() ? "" : "|") + std::string(row.id);
  }
  EXPECT_EQ(named_view_ids(), all);
}

}  // namespace
}  // namespace ryosen
