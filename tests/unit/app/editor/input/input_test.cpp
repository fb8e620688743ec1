#include "app/editor/input/input.h"

#include <gtest/gtest.h>

#include "app/editor/preferences/keys.h"

namespace ryosen {
namespace {

TEST(input, takes_a_chord_apart) {
  EXPECT_EQ(key_of("Ctrl+Shift+Z"), "Z");
  EXPECT_EQ(key_of("Ctrl++"), "+");
  EXPECT_EQ(key_of("+"), "+");
  EXPECT_EQ(key_of("F1"), "F1");
  EXPECT_TRUE(modifiers_of("Ctrl+Shift+Z").ctrl && modifiers_of("Ctrl+Shift+Z").shift);
  EXPECT_FALSE(modifiers_of("Ctrl+Shift+Z").alt);
  EXPECT_TRUE(modifiers_of("Ctrl++").ctrl);
  EXPECT_FALSE(modifiers_of("Z").ctrl || modifiers_of("+").ctrl);
}

TEST(input, knows_modifiers_and_buttons_by_their_words) {
  ASSERT_TRUE(find_modifiers("Shift+Alt"));
  EXPECT_TRUE(find_modifiers("Shift+Alt")->alt);
  for (const char* word : {"", "shift", "Shift+", "Ctrl+Z"}) EXPECT_FALSE(find_modifiers(word)) << word;
  EXPECT_EQ(find_button("middle"), MouseButton::middle);
  EXPECT_FALSE(find_button("Left"));
}

TEST(input, modifiers_of_every_chord_are_known) {
  for (const KeyRow& row : key_table()) {
    const std::size_t length = row.chord.size() - key_of(row.chord).size();
    EXPECT_TRUE(length == 0 || find_modifiers(row.chord.substr(0, length - 1))) << row.chord;
  }
}

}  // namespace
}  // namespace ryosen
