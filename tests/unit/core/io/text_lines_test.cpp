#include "ryosen/io/text_lines.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ryosen {
namespace {

std::vector<std::string> lines_of(std::string_view text, bool join) {
  std::vector<std::string> out;
  TextLines lines(text, join);
  TextLine line;
  while (lines.next(line)) {
    const char end = *(line.text.data() + line.text.size());
    EXPECT_TRUE(end == '\n' || end == '\r');
    out.push_back(std::to_string(line.number) + ":" + std::string(line.text));
  }
  return out;
}

using Lines = std::vector<std::string>;

TEST(text_lines, every_line_end) {
  EXPECT_EQ(lines_of("a\nb\n", true), (Lines{"1:a", "2:b"}));
  EXPECT_EQ(lines_of("a\r\nb\r\n", true), (Lines{"1:a", "2:b"}));
  EXPECT_EQ(lines_of("a\rb\r", true), (Lines{"1:a", "2:b"}));
  EXPECT_EQ(lines_of("a\rb\nc\r\n\r\rd", true), (Lines{"1:a", "2:b", "3:c", "4:", "5:", "6:d"}));
  EXPECT_EQ(lines_of("", true), Lines{});
  EXPECT_EQ(lines_of("\n", true), Lines{"1:"});
}

TEST(text_lines, byte_order_mark_is_no_text) { EXPECT_EQ(lines_of("\xef\xbb\xbfv 1", true), Lines{"1:v 1"}); }

TEST(text_lines, joins_continuations_except_comments) {
  EXPECT_EQ(lines_of("f 1 \\\n 2\\\r\n3\nv", true), (Lines{"1:f 1   2 3", "4:v"}));
  EXPECT_EQ(lines_of("# a \\\nv\n", true), (Lines{"1:# a \\", "2:v"}));
  EXPECT_EQ(lines_of("f 1\\", true), Lines{"1:f 1"});
  EXPECT_EQ(lines_of("f \\\nv\n", false), (Lines{"1:f \\", "2:v"}));
}

TEST(text_lines, blanks_may_stand_behind_the_backslash_of_numbers) {
  EXPECT_EQ(lines_of("f 1 2 \\ \n3\nv", true), (Lines{"1:f 1 2  3", "3:v"}));
  EXPECT_EQ(lines_of("v 1\\\t \r\n2 \\ \r\n3\n", true), (Lines{"1:v 1 2  3"}));
  EXPECT_EQ(lines_of("usemtl a\\ \nf\n", true), (Lines{"1:usemtl a\\ ", "2:f"})) << "the end of a name";
  EXPECT_EQ(lines_of("# f \\ \nv\n", true), (Lines{"1:# f \\ ", "2:v"}));
  EXPECT_EQ(lines_of("  \\ \nv\n", true), (Lines{"1:  \\ ", "2:v"}));
  EXPECT_EQ(lines_of("f 1 \\ ", true), Lines{"1:f 1 "});
}

TEST(text_lines, continuations_are_told_with_their_lines) {
  TextLines lines("a\\\nf 1\nb\nc\\\n\\\nd", true);
  TextLine line;
  const auto continuations = [&] {
    EXPECT_TRUE(lines.next(line));
    Lines out;
    lines.for_each_continuation([&](std::string_view text, std::uint64_t number) {
      out.push_back(std::to_string(number) + ":" + std::string(text));
    });
    return out;
  };
  EXPECT_EQ(continuations(), Lines{"2:f 1"});
  EXPECT_EQ(continuations(), Lines{});
  EXPECT_EQ(continuations(), (Lines{"5:", "6:d"}));
}

TEST(text_lines, places_lie_in_the_physical_line) {
  TextLines lines("x\nf 1 \\\n  2 zz\n", true);
  TextLine line;
  ASSERT_TRUE(lines.next(line));
  ASSERT_TRUE(lines.next(line));
  const auto place = [&](char c) { return lines.place(line.text.data() + line.text.find(c)); };
  EXPECT_EQ(place('1').line, 2u);
  EXPECT_EQ(place('1').column, 3u);
  EXPECT_EQ(place('z').line, 3u);
  EXPECT_EQ(place('z').column, 5u);
  EXPECT_EQ(lines.first_line(), 2u);
  EXPECT_EQ(lines.count(), 3u);
}

TEST(text_lines, words) {
  std::string_view text = "  ab\tc  ";
  EXPECT_EQ(take_word(text), "ab");
  EXPECT_EQ(take_word(text), "c");
  EXPECT_EQ(take_word(text), "");
  EXPECT_EQ(trimmed(" \ta b\t "), "a b");
  EXPECT_EQ(trimmed(" \t "), "");
}

}  // namespace
}  // namespace ryosen
