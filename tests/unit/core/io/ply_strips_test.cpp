// Strips of triangles in PLY become faces.
#include "ryosen/io/ply_builder.h"

#include <bit>

#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::find_message;
using io_test::read_refused;
using io_test::read_sound;
using Corners = std::vector<std::uint32_t>;

constexpr std::string_view vertices_and_strips =
    "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
constexpr std::string_view six_places = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";

std::string ascii_strips(const std::string& rows, std::size_t count = 1) {
  std::string head(vertices_and_strips);
  head.replace(head.find("tristrips 1"), 11, "tristrips " + std::to_string(count));
  return "ply\nformat ascii 1.0\n" + head + std::string(six_places) + rows;
}

void append_number(std::string& out, std::uint32_t number, bool is_big) {
  for (int i = 0; i < 4; ++i) out += static_cast<char>(number >> 8 * (is_big ? 3 - i : i) & 0xff);
}

std::string binary_strips(std::initializer_list<std::int32_t> numbers, bool is_big, std::string_view type = "int") {
  std::string out = std::string("ply\nformat binary_") + (is_big ? "big" : "little") + "_endian 1.0\n" +
                    std::string(vertices_and_strips);
  out.replace(out.find("list int int"), 12, "list int " + std::string(type));
  for (int v = 0; v < 6; ++v)
    for (const int coordinate : {v % 2, v / 2, 0})
      append_number(out, std::bit_cast<std::uint32_t>(static_cast<float>(coordinate)), is_big);
  append_number(out, static_cast<std::uint32_t>(numbers.size()), is_big);
  for (const std::int32_t number : numbers) append_number(out, static_cast<std::uint32_t>(number), is_big);
  return out;
}

TEST(ply_strips, every_second_triangle_is_turned_over) {
  const MeshFile file = read_sound("ply", ascii_strips("6 0 1 2 3 4 5\n"));
  EXPECT_EQ(file.mesh.corners, (Corners{0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5}));
  EXPECT_EQ(file.mesh.face_lines, (Corners{16, 16, 16, 16}));
  EXPECT_TRUE(file.messages.empty());
  ASSERT_EQ(file.properties.tables.size(), 2u);
  EXPECT_EQ(file.properties.tables[1].name, "face") << "strips would say the same again";
}

TEST(ply_strips, minus_one_ends_a_strip_and_begins_the_next_unturned) {
  const Corners two = {0, 1, 2, 3, 4, 5};
  for (const char* row : {"7 0 1 2 -1 3 4 5\n", "8 0 1 2 -1 3 4 5 -1\n", "9 -1 0 1 2 -1 -1 3 4 5\n"}) {
    const MeshFile file = read_sound("ply", ascii_strips(row));
    EXPECT_EQ(file.mesh.corners, two) << row;
    EXPECT_TRUE(file.messages.empty()) << row;
  }
  EXPECT_EQ(read_sound("ply", ascii_strips("3 0 1 2\n0\n3 3 4 5\n", 3)).mesh.corners, two);
}

TEST(ply_strips, binary_files_of_both_byte_orders) {
  for (const bool is_big : {false, true}) {
    const MeshFile file = read_sound("ply", binary_strips({0, 1, 2, 3, -1, 3, 4, 5}, is_big));
    EXPECT_EQ(file.mesh.corners, (Corners{0, 1, 2, 2, 1, 3, 3, 4, 5})) << is_big;
    EXPECT_TRUE(file.mesh.face_lines.empty());
    EXPECT_TRUE(file.messages.empty());
    EXPECT_EQ(read_sound("ply", binary_strips({0, 1, 2, -1, 3, 4, 5}, is_big, "uint")).mesh.corners,
              (Corners{0, 1, 2, 3, 4, 5}))
        << "the largest number of an unsigned type is -1";
  }
}

TEST(ply_strips, a_strip_of_one_or_two_vertices_is_said_with_its_place) {
  const MeshFile file = read_sound("ply", ascii_strips("4 0 1 2 3\n5 0 1 -1 2 3\n5 0 1 2 -1 3\n", 3));
  EXPECT_EQ(file.mesh.face_count(), 3u);
  std::vector<std::uint64_t> lines;
  for (const Message& message : file.messages) {
    EXPECT_EQ(message.code, "face_too_few_corners");
    lines.push_back(message.line.value_or(0));
  }
  EXPECT_EQ(lines, (std::vector<std::uint64_t>{17, 17, 18}));
  const std::string binary = binary_strips({0, 1, 2, -1, 3}, false);
  EXPECT_EQ(find_message(read_sound("ply", binary), "face_too_few_corners")->byte, binary.size() - 24);
}

TEST(ply_strips, a_triangle_with_a_vertex_twice_only_joins_strips) {
  const MeshFile file = read_sound("ply", ascii_strips("8 0 1 2 2 3 3 4 5\n"));
  EXPECT_EQ(file.mesh.corners, (Corners{0, 1, 2, 4, 3, 5}));
  EXPECT_TRUE(file.mesh.quarantine.empty());
  EXPECT_TRUE(file.messages.empty());
}

TEST(ply_strips, numbers_that_are_no_vertices_are_set_aside_with_their_triangles) {
  const MeshFile file = read_sound("ply", ascii_strips("4 0 1 2 9\n"));
  ASSERT_EQ(file.mesh.quarantine.size(), 1u);
  EXPECT_EQ(file.mesh.quarantine[0].code, "index_out_of_range");
  EXPECT_EQ(file.mesh.quarantine[0].line, 16u);
  EXPECT_EQ(read_sound("ply", ascii_strips("4 0 1 2 -2\n")).mesh.quarantine[0].corners.size(), 3u)
      << "-1 alone ends one";
}

TEST(ply_strips, stand_behind_the_faces_of_the_file_and_get_their_columns) {
  std::string text = ascii_strips("3 3 4 5\n");
  const std::string faces =
      "element face 1\nproperty list uchar int vertex_indices\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\nproperty int part\n"
      "property list uchar float texcoord\n";
  text.insert(text.find("end_header"), faces);
  text += "3 0 1 2 255 0 0 7 6 0 0 1 0 0 1\n";
  const MeshFile file = read_sound("ply", text);
  EXPECT_EQ(file.mesh.corners, (Corners{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(file.mesh.face_colours.count, (std::vector<std::uint8_t>{3, 0}));
  EXPECT_EQ(file.mesh.texcoords.index, (Corners{0, 1, 2, no_index, no_index, no_index}));
  EXPECT_EQ(file.properties.tables[1].rows, 2u);
  ASSERT_EQ(file.mesh.attributes.size(), 1u);
  EXPECT_EQ(file.mesh.attributes[0].data, (std::vector<std::uint32_t>{7, 0}));
  const MeshFile again = read_sound("ply", bytes_of(file, *find_format("ply")));
  EXPECT_EQ(again.mesh.corners, file.mesh.corners);
}

TEST(ply_strips, are_written_as_faces_and_come_back) {
  const MeshFile file = read_sound("ply", ascii_strips("7 0 1 2 3 -1 3 5\n"));
  const std::string text = bytes_of(file, *find_format("ply"));
  EXPECT_EQ(text.find("tristrips"), std::string::npos) << text;
  EXPECT_NE(text.find("element face 2\n"), std::string::npos) << text;
  EXPECT_EQ(io_test::difference_after_round_trip(file, "ply"), "");
}

TEST(ply_strips, further_properties_are_named) {
  std::string text = ascii_strips("7 3 0 1 2\n");
  text.insert(text.find("property list int"), "property int material\n");
  const MeshFile file = read_sound("ply", text);
  EXPECT_EQ(file.mesh.face_count(), 1u);
  EXPECT_EQ(find_message(file, "extra_values")->line, 17u);
}

TEST(ply_strips, lists_that_are_not_read_as_faces_are_said_with_their_place) {
  for (const auto& [from, to] : {std::pair{"tristrips", "trifans"},
                                 {"tristrips", "polygon"},
                                 {"list int int vertex_indices", "list int float vertex_indices"},
                                 {"list int int vertex_indices", "list int int corners"}}) {
    std::string text = ascii_strips("4 0 1 2 3\n");
    text.replace(text.find(from), std::string_view(from).size(), to);
    const MeshFile file = read_sound("ply", text);
    EXPECT_EQ(file.mesh.face_count(), 0u);
    EXPECT_EQ(find_message(file, "tristrips_kept")->line, 16u) << to;
    EXPECT_EQ(bytes_of(file, *find_format("ply")), text) << "kept and written back";
  }
}

TEST(ply_strips, cut_or_unreadable_ones_are_errors) {
  EXPECT_EQ(read_refused("ply", ascii_strips("5 0 1 2\n")).message.code, "short_face");
  EXPECT_EQ(read_refused("ply", ascii_strips("3 0 1 x\n")).message.code, "unreadable_number");
  const std::string whole = binary_strips({0, 1, 2}, true);
  EXPECT_EQ(read_refused("ply", whole.substr(0, whole.size() - 1)).message.code, "unexpected_end");
}

TEST(ply_strips, a_long_strip_of_the_other_byte_order_is_refused) {
  std::string text = binary_strips({0, 1, 2, 3, 4, 5}, false);
  text.replace(text.find("little"), 6, "big");
  EXPECT_FALSE(io_test::read_text("ply", text).ok());
}

}  // namespace
}  // namespace ryosen
