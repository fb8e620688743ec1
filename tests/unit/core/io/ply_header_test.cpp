// How the lines of PLY headers end, and what a header says of numbers that cannot be.
#include "ryosen/io/ply_header.h"

#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::read_refused;
using io_test::read_sound;
using Corners = std::vector<std::uint32_t>;

constexpr std::string_view triangle_head =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string with_line_ends(std::string_view text, std::string_view end) {
  std::string out;
  for (const char c : text) {
    if (c == '\n')
      out += end;
    else
      out += c;
  }
  return out;
}

// The first bytes of the data are those of line ends.
std::string binary_triangle(std::string_view line_end) {
  std::string out = with_line_ends("ply\nformat binary_little_endian 1.0\n" + std::string(triangle_head), line_end);
  out += std::string("\n\r\n\0", 4) + std::string(8, '\0');
  out += std::string("\0\0\200\77\0\0\0\0\0\0\0\0", 12) + std::string("\0\0\0\0\0\0\200\77\0\0\0\0", 12);
  return out + std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
}

TEST(ply_header, the_first_line_says_how_the_others_end) {
  for (const std::string_view end : {"\n", "\r\n", "\r", "\n\r"}) {
    const MeshFile file = read_sound("ply", binary_triangle(end));
    EXPECT_TRUE(file.messages.empty());
    EXPECT_GT(file.mesh.positions[0].x, 0) << "the first byte of the data looks like a line end";
    EXPECT_LT(file.mesh.positions[0].x, 1e-30);
    EXPECT_EQ(file.mesh.positions[2], glm::dvec3(0, 1, 0));
    EXPECT_EQ(file.mesh.corners, (Corners{0, 1, 2}));
  }
}

TEST(ply_header, lines_of_text_are_counted_whatever_ends_them) {
  const std::string text =
      "ply\nformat ascii 1.0\ncomment c\n" + std::string(triangle_head) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n";
  for (const std::string_view end : {"\n", "\r\n", "\r", "\n\r"}) {
    const MeshFile file = read_sound("ply", with_line_ends(text, end));
    EXPECT_EQ(file.head_comments, std::vector<std::string>{"c"});
    EXPECT_EQ(io_test::find_message(file, "index_out_of_range")->line, 14u);
    const std::string damaged = with_line_ends(text.substr(0, text.size() - 8), end);
    EXPECT_EQ(read_refused("ply", damaged).message.line, 14u);
  }
}

TEST(ply_header, a_blank_line_is_no_other_line_end) {
  const std::string text =
      "ply\n\r\nformat ascii 1.0\n" + std::string(triangle_head) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n";
  EXPECT_EQ(io_test::find_message(read_sound("ply", text), "index_out_of_range")->line, 14u);
}

TEST(ply_header, files_of_one_line_end_lack_an_end_of_the_header) {
  for (const std::string_view end : {"\r", "\n\r"}) {
    const std::string text = with_line_ends("ply\nformat ascii 1.0\nelement vertex 1\n", end);
    EXPECT_EQ(read_refused("ply", text).message.code, "unexpected_end");
  }
  EXPECT_EQ(read_refused("ply", "ply\r").message.code, "unexpected_end");
  EXPECT_EQ(read_refused("ply", "ply\n\r").message.code, "unexpected_end");
}

// A line that ends in CR is copied, so that what is kept of it must be a copy, too.
TEST(ply_header, names_of_elements_are_known_whatever_ends_their_lines) {
  const std::string others =
      "element a 0\nelement a_name_of_more_than_15_letters 0\nelement b_name_of_more_than_15_letters 0\nelement b 0\n";
  for (const std::string_view end : {"\n", "\r\n", "\r", "\n\r"}) {
    SCOPED_TRACE(testing::PrintToString(end));
    const std::string head = "ply\nformat ascii 1.0\n" + others + std::string(triangle_head);
    const std::string data = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    const MeshFile file = read_sound("ply", with_line_ends(head + data, end));
    EXPECT_EQ(file.properties.tables.size(), 6u);
    for (const std::string_view name :
         {"a", "a_name_of_more_than_15_letters", "b_name_of_more_than_15_letters", "vertex", "face"}) {
      const std::string again = head.substr(0, head.size() - 11) + "element " + std::string(name) + " 0\nend_header\n";
      const Failure failure = read_refused("ply", with_line_ends(again + data, end));
      EXPECT_EQ(failure.message.code, "repeated_element") << name;
      EXPECT_EQ(failure.message.line, 13u) << name;
    }
  }
}

TEST(ply_header, a_count_beyond_64_bits_is_said_as_it_is_written) {
  for (const char* count : {"18446744073709551616", "9223372036854775808", "2000000000", "99999999999999999999999"}) {
    for (const char* format : {"ascii", "binary_little_endian"}) {
      std::string text = "ply\nformat " + std::string(format) + " 1.0\n" + std::string(triangle_head) + "0 0 0\n";
      text.replace(text.find("vertex 3") + 7, 1, count);
      const Message message = read_refused("ply", text).message;
      EXPECT_EQ(message.code, "count_too_large");
      EXPECT_NE(message.text.en.find("The count " + std::string(count) + " of"), std::string::npos) << message.text.en;
      EXPECT_NE(message.text.ja.find(count), std::string::npos) << message.text.ja;
    }
  }
  std::string text = "ply\nformat ascii 1.0\n" + std::string(triangle_head);
  text.replace(text.find("vertex 3") + 7, 1, std::string(5000, '9'));
  EXPECT_LT(read_refused("ply", text).message.text.en.size(), 200u) << "a sentence stays one";
}

}  // namespace
}  // namespace ryosen
