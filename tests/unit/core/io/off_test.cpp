#include "ryosen/io/off.h"

#include "ryosen/io/obj.h"

#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::difference_after_round_trip;
using io_test::find_message;
using io_test::read_refused;
using io_test::read_sound;

constexpr std::string_view tetrahedron = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

using Corners = std::vector<std::uint32_t>;

TEST(off_read, keeps_order_and_polygons) {
  const MeshFile file = read_sound("off", tetrahedron);
  EXPECT_EQ(file.mesh.positions[3], glm::dvec3(0, 0, 1));
  EXPECT_EQ(file.mesh.corners, (Corners{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}));
  EXPECT_EQ(file.mesh.face_lines, (Corners{7, 8, 9, 10}));
  EXPECT_TRUE(file.messages.empty());
  EXPECT_EQ(write_off(file), tetrahedron);
}

TEST(off_read, comments_blank_lines_and_forms_of_the_head) {
  const MeshFile plain = read_sound("off", tetrahedron);
  for (const char* head : {"OFF # c\n\n# d\n4 4 0\n", "OFF 4 4 0\n", "OFF\r\n4 4 0\r\n", "OFF\n4 4\n", "4 4 6\n",
                           "# a\n\tOFF\n  4\t4 -1 # x\n\n# y\n"}) {
    MeshFile file = read_sound("off", head + std::string(tetrahedron.substr(10)));
    EXPECT_TRUE(file.messages.empty()) << head;
    EXPECT_EQ(difference_after_round_trip(file, "off"), "") << head;
    file.head_comments.clear();
    EXPECT_EQ(io_test::difference(file, plain), "") << head;
  }
  const MeshFile file = read_sound("off", "# a\nOFF # b\n# c\n1 0 0 # d\n# e\n0 0 0 # f\n");
  EXPECT_EQ(file.head_comments, (std::vector<std::string>{"# a", "# b", "# c", "# d"}));
}

TEST(off_read, unusable_faces_are_quarantined) {
  const MeshFile file =
      read_sound("off", "OFF\n4 6 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 -1\n3 0 1 4\n0\n2 1 2\n3 0 1 2\n4 0 1 2 1\n");
  ASSERT_EQ(file.mesh.quarantine.size(), 5u);
  EXPECT_EQ(file.mesh.quarantine[0].corners, (std::vector<std::int64_t>{0, 1, -1}));
  EXPECT_EQ(file.mesh.quarantine[0].line, 7u);
  EXPECT_EQ(file.mesh.quarantine[1].code, "index_out_of_range");
  EXPECT_EQ(file.mesh.quarantine[2].code, "face_too_few_corners");
  EXPECT_EQ(file.mesh.quarantine[4].code, "repeated_corner");
  EXPECT_EQ(file.mesh.quarantine[4].face, 5u);
  EXPECT_EQ(difference_after_round_trip(file, "off"), "");
}

TEST(off_read, counts_are_claims) {
  struct Case {
    const char* text;
    const char* code;
    std::uint64_t line;
  };
  for (const Case& c :
       {Case{"OFF\n2000000000 1 0\n0 0 0\n", "count_too_large", 2},
        Case{"OFF\n1 99999999999999999999 0\n0 0 0\n", "count_too_large", 2},
        Case{"OFF\n-4 4 0\n0 0 0\n", "negative_count", 2}, Case{"OFF\n1 -1 0\n0 0 0\n", "negative_count", 2},
        Case{"OFF\nx 4 0\n", "unreadable_number", 2}, Case{"OFF\n4\n0 0 0\n1 1 1\n2 2 2\n3 3 3\n", "missing_number", 2},
        Case{"OFF\n", "unexpected_end", 2}, Case{"OFF\n2 0 0\n0 0 0\n# ......\n", "unexpected_end", 5},
        Case{"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "unexpected_end", 7},
        Case{"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "short_face", 6},
        Case{"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", "negative_count", 6},
        Case{"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2.5\n", "unreadable_index", 6},
        Case{"OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "missing_number", 4},
        Case{"OFF\n1 0 0\n0 zero 0\n", "unreadable_number", 3},
        Case{"4OFF\n1 0 0\n0 0 0 1\n", "unsupported_dimension", 1},
        Case{"nOFF\n4\n1 0 0\n0 0 0 1\n", "unsupported_dimension", 1}, Case{"PFF\n", "not_off", 1}}) {
    const Failure failure = read_refused("off", c.text);
    EXPECT_EQ(failure.message.code, c.code) << c.text;
    EXPECT_EQ(failure.message.line, c.line) << c.text;
    EXPECT_EQ(failure.exit_code, ExitCode::input_malformed);
  }
}

TEST(off_read, what_is_too_much_is_reported) {
  const MeshFile more = read_sound("off", std::string(tetrahedron) + "3 0 1 2\n\n# c\n3 0 1 2\n");
  const Message* extra = find_message(more, "extra_data");
  ASSERT_NE(extra, nullptr);
  EXPECT_EQ(extra->line, 11u);
  EXPECT_EQ(extra->text.en.substr(0, 7), "2 lines");
  EXPECT_EQ(more.mesh.face_count(), 4u);
  const MeshFile wide = read_sound("off", "OFF\n1 0 0\n0 0 0 7\n");
  EXPECT_NE(find_message(wide, "extra_values"), nullptr);
}

TEST(off_read, colours_of_vertices) {
  const MeshFile bytes = read_sound("off", "COFF\n3 1 0\n0 0 0 255 0 51 255\n1 0 0 255 0 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_TRUE(bytes.byte_colours);
  EXPECT_EQ(bytes.mesh.vertex_colours[0], glm::dvec4(1, 0, 0.2, 1));
  EXPECT_TRUE(std::isnan(bytes.mesh.vertex_colours[2].x));
  EXPECT_EQ(bytes.mesh.colour_components, 4);
  EXPECT_EQ(difference_after_round_trip(bytes, "off"), "");
  EXPECT_NE(write_off(bytes).find("0 0 0 255 0 51 255\n"), std::string::npos);
  const MeshFile reals = read_sound("off", "COFF\n1 0 0\n0 0 0 0.5 0 1\n");
  EXPECT_FALSE(reals.byte_colours);
  EXPECT_EQ(reals.mesh.vertex_colours[0], glm::dvec4(0.5, 0, 1, 1));
  EXPECT_EQ(difference_after_round_trip(reals, "off"), "");
}

TEST(off_read, colours_of_faces) {
  const MeshFile file = read_sound(
      "off", "OFF\n3 5 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2 255 0 0\n3 0 1 2 .1 .2 .3 1\n3 0 1 2 5\n3 0 1 2\n");
  EXPECT_TRUE(file.messages.empty());
  EXPECT_EQ(file.mesh.face_colours.count, (std::vector<std::uint8_t>{0, 3, 4, 1, 0}));
  EXPECT_EQ(file.mesh.face_colours.values[2], glm::dvec4(.1, .2, .3, 1));
  EXPECT_EQ(difference_after_round_trip(file, "off"), "");
  EXPECT_EQ(io_test::loss_codes(file, "obj"), "loses_face_colours");
}

TEST(off_read, colours_of_faces_say_what_their_numbers_are) {
  constexpr std::string_view text =
      "OFF\n3 6 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1.0 0.0 -0.0\n3 0 1 2 51 0 255\n3 0 1 2 1 0 0\n"
      "3 0 1 2 0.25 1e-05 0.5 1.0\n3 0 1 2 7\n3 0 1 2 382.5 0 12\n";
  const MeshFile file = read_sound("off", text);
  const std::vector<glm::dvec4>& values = file.mesh.face_colours.values;
  EXPECT_EQ(values[0], glm::dvec4(1, 0, 0, 0));
  EXPECT_EQ(values[1], glm::dvec4(0.2, 0, 1, 0));
  EXPECT_EQ(values[2], glm::dvec4(1 / 255.0, 0, 0, 0));
  EXPECT_EQ(values[4].x, 7);
  EXPECT_EQ(values[5].x, 1.5);
  EXPECT_EQ(write_off(file), text) << "written as it was";
  EXPECT_EQ(difference_after_round_trip(file, "off"), "");
  // Without bytes in the file, reals stay reals, white too.
  const MeshFile reals = read_sound("off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1.0 1.0 1.0\n");
  EXPECT_NE(write_off(reals).find("3 0 1 2 1.0 1.0 1.0\n"), std::string::npos);
  MeshFile huge = reals;
  huge.mesh.face_colours.values[0].x = 1e308;
  EXPECT_EQ(io_test::loss_codes(huge, "off"), "loses_exact_colours");
  EXPECT_EQ(io_test::loss_codes(huge, "ply"), "");
}

TEST(off_read, normals_and_texture_coordinates) {
  const MeshFile file = read_sound("off",
                                   "STCNOFF\n4 1 0\n0 0 0 0 0 1 .5 .5 .5 0 .25\n1 0 0 0 1 0 .5 .5 .5 1 0\n"
                                   "0 1 0 1 0 0 .5 .5 .5 0 1\n9 9 9 0 0 -1 .5 .5 .5 1 1\n3 0 2 1\n");
  EXPECT_TRUE(file.messages.empty());
  EXPECT_EQ(file.mesh.normals.pool[1], glm::dvec3(0, 1, 0));
  EXPECT_EQ(file.mesh.normals.index, (Corners{0, 2, 1}));
  EXPECT_EQ(file.mesh.texcoords.pool[0], glm::dvec3(0, .25, 0));
  EXPECT_EQ(file.mesh.texcoords.components, 2);
  EXPECT_EQ(difference_after_round_trip(file, "off"), "");
  const MeshFile points = read_sound("off", "NOFF\n1 0 0\n0 0 0 0 0 1\n");
  EXPECT_EQ(difference_after_round_trip(points, "off"), "");
}

void put(std::string& out, std::uint32_t word, bool big_endian) {
  for (int i = 0; i < 4; ++i) out += static_cast<char>(word >> (big_endian ? 24 - 8 * i : 8 * i) & 0xff);
}

std::string binary_triangle(bool big_endian, bool face_colours) {
  std::string out = "OFF BINARY\n";
  for (const std::uint32_t count : {3u, 1u, 3u}) put(out, count, big_endian);
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, .5f, 0.f})
    put(out, std::bit_cast<std::uint32_t>(x), big_endian);
  for (const std::uint32_t word : {3u, 0u, 1u, 2u}) put(out, word, big_endian);
  if (face_colours) put(out, 1, big_endian);
  if (face_colours) put(out, std::bit_cast<std::uint32_t>(7.f), big_endian);
  return out;
}

TEST(off_read, binary_in_either_byte_order) {
  for (const bool big_endian : {false, true}) {
    for (const bool face_colours : {false, true}) {
      const std::string bytes = binary_triangle(big_endian, face_colours);
      const MeshFile file = read_sound("off", bytes);
      EXPECT_EQ(file.mesh.positions, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, .5, 0}}));
      EXPECT_EQ(file.mesh.corners, (Corners{0, 1, 2}));
      EXPECT_EQ(file.mesh.face_colours.values.size(), face_colours ? 1u : 0u);
      EXPECT_TRUE(file.messages.empty());
      const MeshFile longer = read_sound("off", bytes + "abc");
      const Message* extra = find_message(longer, "extra_data");
      ASSERT_NE(extra, nullptr);
      EXPECT_EQ(extra->byte, bytes.size());
      const Failure cut = read_refused("off", bytes.substr(0, bytes.size() - 9));
      EXPECT_EQ(cut.message.byte, 11u);
    }
  }
}

TEST(off_write, values_that_differ_between_corners_are_a_loss) {
  const MeshFile file = read_sound("obj",
                                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nvn 0 1 0\nvt 0 0\nvt 1 1\ng a\nf "
                                   "1/1/1 2/2/1 3/1/1\nf 2/2/2 4/1/1 3/1/1\n");
  EXPECT_EQ(io_test::loss_codes(file, "off"), "loses_normals loses_groups");
  EXPECT_EQ(write_off(file).substr(0, 6), "STOFF\n");
}

}  // namespace
}  // namespace ryosen
