#include "ryosen/base/count_text.h"

#include <gtest/gtest.h>

namespace ryosen {
namespace {

TEST(count_text, one_thing_has_a_sentence_of_its_own_in_english) {
  const auto said = [](std::uint64_t count) { return count_text(count, "One face goes.", "# faces go.", "面 # 個"); };
  EXPECT_EQ(said(1).en, "One face goes.");
  EXPECT_EQ(said(1).ja, "面 1 個");
  EXPECT_EQ(said(0).en, "0 faces go.");
  EXPECT_EQ(said(34834).en, "34834 faces go.");
  EXPECT_EQ(said(34834).ja, "面 34834 個");
}

TEST(count_text, a_number_stands_in_the_place_of_the_first_mark) {
  EXPECT_EQ(with_number("# of #", 3), "3 of #");
  EXPECT_EQ(with_number("none", 3), "none");
}

}  // namespace
}  // namespace ryosen
