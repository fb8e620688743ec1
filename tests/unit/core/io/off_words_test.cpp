// OFF whose numbers do not stand line by line, and what only looks so.
#include "ryosen/io/off_builder.h"

#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::find_message;
using io_test::read_refused;
using io_test::read_sound;

constexpr std::string_view laid_out = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

// Reads a text, which must be read by words, and tells what differs from the same mesh laid out in lines.
std::string difference_from(std::string_view lines, const std::string& text, std::uint64_t line) {
  MeshFile file = read_sound("off", text);
  const Message* const message = find_message(file, "read_by_words");
  EXPECT_TRUE(message && message->line == line) << text;
  EXPECT_EQ(file.messages.size(), 1u) << text;
  const MeshFile wanted = read_sound("off", lines);
  file.head_comments.clear();
  return io_test::difference(file, wanted);
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

TEST(off_words, any_layout_is_read) {
  const std::string text(laid_out);
  EXPECT_EQ(difference_from(laid_out, replaced(text, " ", "\n"), 2), "") << "a word a line";
  EXPECT_EQ(difference_from(laid_out, replaced(text, "\n", " "), 1), "") << "all on one line";
  EXPECT_EQ(difference_from(laid_out, replaced(replaced(text, " ", "\n"), "\n", "\r\n"), 2), "");
  EXPECT_EQ(difference_from(laid_out, replaced(replaced(text, " ", "\n"), "\n", "\r"), 2), "");
  EXPECT_EQ(difference_from(laid_out, "OFF4 4 6" + replaced(text.substr(9), "\n", " "), 1), "");
  EXPECT_EQ(difference_from(laid_out, replaced(text.substr(4), " ", "\t\n"), 1), "") << "without the word";
  EXPECT_EQ(difference_from(laid_out, "OFF\n4 4 6\n0 0 0 1 0 0 0 1 0\n0 0 1\n" + text.substr(34), 8), "")
      << "three vertices on a line";
  EXPECT_EQ(difference_from(laid_out, replaced(text, "3 1 2 3\n", "3 1\n2 3\n"), 9), "") << "one face on two lines";
  EXPECT_EQ(difference_from(laid_out, "# a\nOFF # b\n" + replaced(text.substr(4), " ", " # 9 9\n"), 3), "");
}

TEST(off_words, a_count_behind_the_word_is_all_that_is_unusual_where_the_rest_is_laid_out) {
  MeshFile file = read_sound("off", "OFF4 4 6\n" + std::string(laid_out.substr(10)));
  ASSERT_EQ(file.messages.size(), 1u);
  EXPECT_EQ(file.messages[0].code, "count_behind_word");
  EXPECT_EQ(file.messages[0].line, 1u);
  EXPECT_EQ(file.messages[0].text.en,
            "\"OFF4\" is read as the word OFF and the count of vertices: a blank is missing.");
  EXPECT_EQ(io_test::difference(file, read_sound("off", std::string(laid_out))), "");
}

TEST(off_words, comments_before_the_numbers_are_kept) {
  const MeshFile file = read_sound("off", "# a\nOFF4 4 6 # b\n# c\n" + std::string(laid_out.substr(10)));
  EXPECT_EQ(file.head_comments, (std::vector<std::string>{"# a", "# b"}));
}

TEST(off_words, values_of_vertices_are_read_by_the_kind) {
  for (const std::string text :
       {"COFF\n3 1 0\n0 0 0 255 0 51 255\n1 0 0 255 0 0 0\n0 1 0 1 2 3 4\n3 0 1 2\n",
        "COFF\n3 1 0\n0 0 0 255 0 51\n1 0 0 255 0 0\n0 1 0 1 2 3\n3 0 1 2\n",
        "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 1 0\n0 1 0 1 0 0\n3 0 1 2\n",
        "STCNOFF\n3 1 0\n0 0 0 0 0 1 .5 .5 .5 1 0 .25\n1 0 0 0 1 0 .5 .5 .5 1 1 0\n0 1 0 1 0 0 .5 .5 .5 1 0 1\n3 0 2 "
        "1\n"}) {
    EXPECT_EQ(difference_from(text, replaced(text, " ", "\n"), 2), "");
    EXPECT_EQ(difference_from(text, replaced(text, "\n", "  "), 1), "");
  }
}

TEST(off_words, lines_come_first) {
  const MeshFile file = read_sound("off", "OFF\n3 1 0\n0 0 0 5\n1 0 0\n0 1 0\n3 0 1 2 9 9 9\n");
  EXPECT_EQ(find_message(file, "read_by_words"), nullptr);
  EXPECT_NE(find_message(file, "extra_values"), nullptr);
  EXPECT_EQ(file.mesh.face_colours.count.size(), 1u);
}

TEST(off_words, what_does_not_come_out_keeps_the_refusal_by_lines) {
  struct Case {
    const char *text, *code;
    std::uint64_t line;
  };
  for (const Case& c :
       {Case{"OFF\n4 2 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1\n3 1 2 3\n", "short_face", 7},
        Case{"OFF\n3 1 0\n0 0\n0 1 0 0\n0 1 0\n3 0 1 2 7\n", "missing_number", 3},        // a word too many
        Case{"OFF\n3 1 0\n0 0\n0 1 0 0\n0 1 0\n3 0 1\n", "missing_number", 3},            // and one too few
        Case{"OFF\n3 1 0\n0 0\n0 1 0 0\n0 1 0\n3 0 1 3\n", "missing_number", 3},          // a vertex that is not there
        Case{"OFF\n3 1 0\n0 0\n0 1 0 0\n0 1 0\n3 0 1 -1\n", "missing_number", 3},         // nor is this
        Case{"OFF\n3 2 0\n0 0\n0 1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n", "missing_number", 3},   // a face of two corners
        Case{"OFF\n3 1 0\n0 0\n0 1 0 0\n0 1 0\n3 0 1 2 255 0 0\n", "missing_number", 3},  // a colour
        Case{"OFF\n3 1 0\n0 0\n0 1 0 x\n0 1 0\n3 0 1 2\n", "missing_number", 3},          // a word that is no number
        Case{"OFF\n3 1\n0 0\n0 1 0 0\n0 1 0\n3 0 1 2\n", "missing_number", 3},            // no third count
        Case{"OFF\n3 1.0 0\n0 0 0 1 0 0 0 1 0 3 0 1 2\n", "unreadable_number", 2},        // a count with a fraction
        Case{"OFFx 3 1 0\n0 0 0 1 0 0 0 1 0 3 0 1 2\n", "not_off", 1},
        Case{"4OFF 3 1 0 0 0 0 1 1 0 0 1 0 1 0 1 3 0 1 2\n", "unsupported_dimension", 1},
        Case{"OFF -3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2\n", "negative_count", 1}}) {
    const Failure failure = read_refused("off", c.text);
    EXPECT_EQ(failure.message.code, c.code) << c.text;
    EXPECT_EQ(failure.message.line, c.line) << c.text;
  }
  const std::string nul("OFF\n3 1 0\n0 0\n0 1 0 0\n0 1 0\n3 0 1 2\n# \0\n", 40);
  EXPECT_EQ(read_refused("off", nul).message.code, "nul_byte") << "no text";
}

TEST(off_words, a_number_that_slipped_to_the_next_line_is_damage) {
  const Message refusal = read_refused("off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1\n0 0 1 5\n3 0 1 2\n3 0 1 3\n").message;
  EXPECT_EQ(refusal.code, "missing_number");
  EXPECT_EQ(refusal.line, 5u);
}

TEST(off_words, a_file_is_known_by_its_first_word) {
  EXPECT_EQ((*recognise("# c\nOFF8 6 12\n", "a"))->id, "off");
  EXPECT_EQ((*recognise("STCNOFF8 6 12\n", "a"))->id, "off");
  EXPECT_FALSE(recognise("OFF8x 6 12\n", "a").ok());
}

TEST(off_words, numbers_without_a_limit_stay_and_are_reported) {
  const MeshFile file = read_sound("off", "OFF 3 1 0 0 0 nan 1 0 0 0 1 0 3 0 1 2");
  EXPECT_NE(find_message(file, "nonfinite_number"), nullptr);
  EXPECT_NE(find_message(file, "read_by_words"), nullptr);
}

TEST(off_words, a_large_file_is_read_in_linear_time) {
  std::string text = "OFF 400000 400000 0";
  for (int i = 0; i < 400000; ++i) text += " 0 1 2\n3 4";
  for (int i = 0; i < 400000; ++i) text += "\n3 0 1 2";
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(read_refused("off", text).message.code, "missing_number")
      << "not by words either: two words a row too many";
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

}  // namespace
}  // namespace ryosen
