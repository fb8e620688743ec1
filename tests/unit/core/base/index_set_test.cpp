#include "ryosen/base/index_set.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/core/random_meshes.h"

namespace ryosen {
namespace {

TEST(index_set, behaves_like_a_set_of_numbers) {
  IndexSet set;
  std::set<std::uint32_t> truth;
  Dice dice(7);
  for (int step = 0; step < 20000; ++step) {
    const auto i = static_cast<std::uint32_t>(dice.below(step % 2 == 0 ? 300 : 100000));
    if (dice.one_in(3)) {
      EXPECT_EQ(set.erase(i), truth.erase(i) == 1);
    } else {
      EXPECT_EQ(set.insert(i), truth.insert(i).second);
    }
    EXPECT_EQ(set.contains(i), truth.contains(i));
    EXPECT_EQ(set.size(), truth.size());
  }
  EXPECT_EQ(set.to_vector(), std::vector<std::uint32_t>(truth.begin(), truth.end()));
  std::uint32_t n = 0;
  for (std::uint32_t member : truth) ASSERT_EQ(set.nth(n++), member);
  for (std::uint32_t first : {0u, 1u, 63u, 64u, 299u, 4095u, 4096u, 4100u, 99999u, 200000u}) {
    std::vector<std::uint32_t> rest;
    set.for_each_from(first, [&](std::uint32_t i) { rest.push_back(i); });
    EXPECT_EQ(rest, std::vector<std::uint32_t>(truth.lower_bound(first), truth.end()));
    std::vector<std::uint32_t> some;
    set.for_each_in(first, first + 200, [&](std::uint32_t i) { some.push_back(i); });
    EXPECT_EQ(some, std::vector<std::uint32_t>(truth.lower_bound(first), truth.lower_bound(first + 200)));
  }
}

TEST(index_set, is_equal_by_members_whatever_came_before) {
  IndexSet a, b;
  a.insert(5);
  b.insert(5);
  b.insert(70000);
  EXPECT_FALSE(a == b);
  b.erase(70000);
  EXPECT_TRUE(a == b);
  b.clear();
  EXPECT_TRUE(b.empty());
  EXPECT_FALSE(b.contains(5));
}

}  // namespace
}  // namespace ryosen
