// The types and digits in which PLY columns are written.
#include "ryosen/io/ply_columns.h"

#include <bit>
#include <charconv>

#include "ryosen/io/byte_colours.h"
#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::loss_codes;
using io_test::read_sound;

std::string as_ascii(const MeshFile& file) { return bytes_of(file, *find_format("ply"), Encoding::ascii); }

std::string obj_with(std::initializer_list<const char*> colours) {
  std::string text;
  int x = 0;
  for (const char* colour : colours)
    text += "v " + std::to_string(x) + " " + std::to_string(x * x) + " 0 " + colour + "\n", ++x;
  return text + "f 1 2 3\n";
}

// The declared type of red and the numbers of the first vertex.
std::string colours_written(std::initializer_list<const char*> colours) {
  const std::string text = as_ascii(read_sound("obj", obj_with(colours)));
  const std::size_t red = text.find(" red");
  const std::size_t type = text.rfind(' ', red - 1) + 1, row = text.find("end_header\n") + 11 + 6;
  return text.substr(type, red - type) + " " + text.substr(row, text.find('\n', row) - row);
}

TEST(ply_columns, colours_that_mean_bytes_are_uchar) {
  EXPECT_EQ(colours_written({"0.501961 0.250980 1.000000", "0 0 0", "1 1 1"}), "uchar 128 64 255");
  EXPECT_EQ(colours_written({"0.5020 0.2510 1", "0.0039 0 0", "1 1 1"}), "uchar 128 64 255");
  EXPECT_EQ(colours_written({"0.5019607843137255 0.25098 0.2", "0 0 0", "1 1 1"}), "uchar 128 64 51");
  EXPECT_EQ(colours_written({"1 0 1", "0.0 1.0 0", "1 1 1"}), "uchar 255 0 255");
  EXPECT_EQ(colours_written({"0.502 0.251 0.6", "0 0 0", "1 1 1"}), "uchar 128 64 153") << "0.5020 is 0.502";
  for (int n = 0; n < 256; ++n) {
    for (const int decimals : {4, 5, 6, 7, 9, 12, 17}) {
      char text[32];
      *std::to_chars(text, text + 31, n / 255.0, std::chars_format::fixed, decimals).ptr = '\0';
      EXPECT_EQ(byte_meant(std::stod(text)), n) << text;
    }
  }
}

TEST(ply_columns, colours_that_do_not_mean_bytes_keep_their_values) {
  EXPECT_EQ(colours_written({"0.5 0.25 1", "0 0 0", "1 1 1"}), "float 0.5 0.25 1");
  EXPECT_EQ(colours_written({"0.501961 0.250980 1", "0 0 0", "0.1 1 1"}), "double 0.501961 0.25098 1") << "one is not";
  EXPECT_EQ(colours_written({"0.50 0.25 1", "0.501961 0 0", "1 1 1"}), "double 0.5 0.25 1");
  EXPECT_EQ(colours_written({"0.501962 0 0", "0 0 0", "1 1 1"}), "double 0.501962 0 0");
  EXPECT_EQ(colours_written({"1.5 0 0", "0 0 0", "1 1 1"}), "float 1.5 0 0");
  EXPECT_EQ(colours_written({"-0.25 0 0", "0 0 0", "1 1 1"}), "float -0.25 0 0");
  EXPECT_EQ(colours_written({"1e-300 0 0", "0 0 0", "1 1 1"}), "double 1e-300 0 0");
  for (const double odd : {0.5, 0.1, 0.0001, 0.501962, 1.00001, -0.0039, 1e-300, 5e-324})
    EXPECT_FALSE(byte_meant(odd).has_value()) << odd;
}

constexpr std::string_view byte_coloured =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face 1\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
    "property uchar blue\nend_header\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 1 2 3\n3 0 1 2 9 8 7\n";

TEST(ply_columns, uchar_of_the_file_stays_and_rounding_is_said) {
  MeshFile file = read_sound("ply", byte_coloured);
  EXPECT_EQ(loss_codes(file, "ply-ascii"), "");
  file.mesh.vertex_colours[0] = glm::dvec4(0.123, 0.5, 1.001, 1);
  file.mesh.vertex_colours[1].x = -0.001;
  file.mesh.face_colours.values[0].y = 0.5;
  for (const FormatVariant& variant : find_format("ply")->variants) {
    EXPECT_EQ(loss_codes(file, variant.id), "loses_exact_colours") << variant.id;
    EXPECT_EQ(losses_of(file, *find_format("ply"), variant.encoding)[0].count, 3u) << variant.id;
    const std::string text = as_ascii(read_sound("ply", bytes_of(file, *find_format("ply"), variant.encoding)));
    EXPECT_EQ(text.find("double"), std::string::npos) << text;
    EXPECT_NE(text.find("0 0 0 31 128 255\n1 0 0 0 255 0\n0 1 0 1 2 3\n3 0 1 2 9 128 7\n"), std::string::npos) << text;
  }
  file.mesh.vertex_colours[0].x = 1.5;
  EXPECT_NE(as_ascii(file).find("property double red"), std::string::npos) << "no byte is near";
}

TEST(ply_columns, numbers_that_are_no_bytes_where_a_text_announces_them_stay) {
  for (const char* odd : {"12.5 0 0", "300 0 0", "-1 0 0", "0 1e-9 0"}) {
    std::string text(byte_coloured);
    text.replace(text.find("255 0 0"), 7, odd);
    const MeshFile file = read_sound("ply", text);
    EXPECT_EQ(loss_codes(file, "ply-ascii"), "") << odd;
    EXPECT_EQ(io_test::difference_after_round_trip(file, "ply"), "") << odd;
  }
}

// A file of these places as floats, in ascii or binary.
MeshFile floats_in(Encoding encoding, std::initializer_list<float> numbers) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(numbers.size() / 3) +
                     "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (const float number : numbers) {
    char digits[32];
    text.append(digits, std::to_chars(digits, digits + 32, number).ptr).append("\n");
  }
  const MeshFile ascii = read_sound("ply", text);
  return encoding == Encoding::ascii ? ascii : read_sound("ply", bytes_of(ascii, *find_format("ply"), encoding));
}

constexpr float awkward = 0.1f, third = 1.f / 3, large = 16777217.f, tiny = 1e-42f, golden = 1.6180339887f,
                small = 0.264218f;

TEST(ply_columns, floats_have_the_shortest_digits_of_one) {
  const MeshFile file = floats_in(Encoding::binary_little, {awkward, third, large, tiny, golden, small});
  EXPECT_EQ(file.mesh.positions[0].x, double{awkward}) << "text to binary keeps the type float";
  const std::string text = as_ascii(file);
  EXPECT_NE(text.find("end_header\n0.1 0.33333334 16777216\n1e-42 1.618034 0.264218\n"), std::string::npos) << text;
  EXPECT_NE(text.find("property float x"), std::string::npos);
}

TEST(ply_columns, binary_to_text_and_back_gives_the_same_bytes) {
  for (const Encoding encoding : {Encoding::binary_little, Encoding::binary_big}) {
    const MeshFile file = floats_in(encoding, {awkward, third, large, tiny, golden, small});
    const std::string bytes = bytes_of(file, *find_format("ply"), encoding);
    const std::string text = as_ascii(file);
    const MeshFile again = read_sound("ply", text);
    EXPECT_EQ(bytes_of(again, *find_format("ply"), encoding), bytes);
    EXPECT_EQ(as_ascii(again), text);
  }
}

TEST(ply_columns, text_stays_as_it_is) {
  constexpr std::string_view text =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
      "0.264218003 0.1 1e+30\n-1234.567871 3 4\n";
  const MeshFile file = read_sound("ply", text);
  EXPECT_EQ(as_ascii(file), text) << "floats may have been printed so";
  EXPECT_EQ(file.mesh.positions[0].x, 0.264218003);
  for (const char* finer : {"-0.123456789", "0.30000000000000004", "1234.567890123", "1e-60", "1e300"}) {
    std::string fine(text);
    fine.replace(fine.find("0.264218003"), 11, finer);
    const std::string written = as_ascii(read_sound("ply", fine));
    EXPECT_NE(written.find("property double x"), std::string::npos) << finer << " is no float";
    EXPECT_EQ(as_ascii(read_sound("ply", written)), written);
  }
}

TEST(ply_columns, values_that_no_float_has_make_the_column_double) {
  MeshFile file = floats_in(Encoding::ascii, {awkward, 1, 2, 3, 4, 5});
  file.mesh.positions[1].y = 0.1 + 0.2;
  const std::string text = as_ascii(file);
  EXPECT_NE(text.find("property double x\nproperty double y\nproperty double z\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n3 0.30000000000000004 5\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n0.1 1 2\n"), std::string::npos) << "decimals of the text stay";
  EXPECT_EQ(io_test::difference(read_sound("ply", text), file), "");
}

// Normals, texture coordinates of vertices and of corners, and a further property.
TEST(ply_columns, all_float_properties_and_lists_are_printed_alike) {
  constexpr std::string_view text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\nproperty float quality\nelement face 1\n"
      "property list uchar int vertex_indices\nproperty list uchar float texcoord\nproperty list uchar float more\n"
      "end_header\n0 0 0 0.6 0.8 0 0.7\n1 0 0 0.36 0.48 0.8 0.1\n0 1 0 0.264218 0.55014 0.3 0.2\n"
      "3 0 1 2 6 0.264218 0.55014 0.1 0.2 0.3 0.7 2 0.1 0.3\n";
  EXPECT_EQ(as_ascii(read_sound("ply", text)), text);
  for (const FormatVariant& variant : find_format("ply")->variants) {
    const MeshFile file = read_sound("ply", bytes_of(read_sound("ply", text), *find_format("ply"), variant.encoding));
    EXPECT_EQ(as_ascii(file), text) << variant.id;
  }
}

TEST(ply_columns, texture_coordinates_that_move_to_corners_are_written_as_they_are_read) {
  for (const char* number : {"0.264218", "0.264218003", "0.123456789", "1e-07", "0.33333334"}) {
    MeshFile file = read_sound("ply",
                               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                               "property float z\nproperty float s\nproperty float t\nelement face 2\n"
                               "property list uchar int vertex_indices\nend_header\n0 0 0 " +
                                   std::string(number) + " 0.1\n1 0 0 0.2 0.3\n0 1 0 0.7 0.9\n3 0 1 2\n3 0 2 1\n");
    file.mesh.texcoords.index[3] = 2;  // the corners of a vertex differ
    const std::string first = as_ascii(file);
    const bool is_float = std::string_view(number).size() < 11;
    EXPECT_EQ(first.find("property list uchar float texcoord") != std::string::npos, is_float) << first;
    EXPECT_EQ(as_ascii(read_sound("ply", first)), first) << number;
  }
}

}  // namespace
}  // namespace ryosen
