#include "ryosen/io/ply.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstring>

#include "ryosen/mesh/attribute.h"
#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::difference_after_round_trip;
using io_test::expect_refusals;
using io_test::find_message;
using io_test::read_refused;
using io_test::read_sound;
using Corners = std::vector<std::uint32_t>;

constexpr std::string_view ply_tetrahedron =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

// A file with a bit of everything, in ascii.
constexpr std::string_view rich_ply =
    "ply\nformat ascii 1.0\ncomment made by hand\ncomment # twice marked\nobj_info scanned 1999\n"
    "element camera 1\nproperty float view\nproperty list uchar short tags\n"
    "element vertex 5\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty double x\n"
    "property double y\nproperty double z\nproperty float quality\nproperty list uchar int near\nproperty float nx\n"
    "property float ny\nproperty float nz\nproperty float s\nproperty float t\nproperty uchar alpha\n"
    "element face 3\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
    "property list uchar uint vertex_index\nproperty int label\n"
    "element edge 2\nproperty int vertex1\nproperty int vertex2\nproperty float crease\n"
    "end_header\n"
    "1.5 2 -3 4\n"
    "255 0 51 0.1 0 0 0.25 0 0 0 1 0 0 255\n"
    "0 0 0 1 0 0 0.5 2 7 8 0 0 1 1 0 0\n"
    "1 2 3 1 1 0 -1 1 -9 0 0 1 1 1 128\n"
    "4 5 6 0 1 0 1e+30 0 0 0 1 0 1 255\n"
    "7 8 9 9 9 9 3 0 1 0 0 0.5 0.5 255\n"
    "255 0 0 4 0 1 2 3 -1\n"
    "0 255 0 3 0 1 9 2147483647\n"
    "0 0 255 2 0 1 0\n"
    "0 1 0.5\n"
    "4 2 1\n";

std::string big_endian(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  std::string out;
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(bits >> shift & 0xff);
  return out;
}

// More vertices are announced than the rest of the file could hold; blank lines are no rows.
TEST(ply_read, rows_behind_very_many_blank_lines) {
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 300000\nproperty float x\nproperty float y\nproperty float z\n"
      "end_header\n0 0 0\n";
  ply.append(262144, '\n');
  for (int i = 0; i < 31309; ++i) ply += "1 1 1\n";
  read_refused("ply", ply);
}

TEST(ply_read, four_faces) {
  const MeshFile file = read_sound("ply", ply_tetrahedron);
  EXPECT_TRUE(file.messages.empty());
  EXPECT_EQ(file.encoding, Encoding::ascii);
  EXPECT_EQ(file.mesh.positions[3], glm::dvec3(0, 0, 1));
  EXPECT_EQ(file.mesh.corners, (Corners{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}));
  EXPECT_EQ(file.mesh.face_lines, (Corners{14, 15, 16, 17}));
  EXPECT_EQ(bytes_of(file, *find_format("ply")), ply_tetrahedron);
}

TEST(ply_read, a_header_line_may_begin_like_its_end) {
  const MeshFile file = io_test::read_sound(
      "ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header_later on\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(file.mesh.positions.size(), 3u);
  EXPECT_TRUE(io_test::find_message(file, "unknown_keyword"));
}

TEST(ply_read, every_property_goes_where_it_belongs) {
  const MeshFile file = read_sound("ply", rich_ply);
  const IndexedMesh& mesh = file.mesh;
  EXPECT_EQ(file.head_comments, (std::vector<std::string>{"made by hand", "# twice marked"}));
  EXPECT_EQ(file.properties.obj_info, std::vector<std::string>{"scanned 1999"});
  EXPECT_EQ(mesh.positions[0], glm::dvec3(0.1, 0, 0));
  EXPECT_EQ(mesh.vertex_colours[0], glm::dvec4(1, 0, 0.2, 1));
  EXPECT_EQ(mesh.vertex_colours[2].w, 128 / 255.0);
  EXPECT_EQ(mesh.colour_components, 4);
  EXPECT_EQ(mesh.normals.pool[4], glm::dvec3(1, 0, 0));
  EXPECT_EQ(mesh.texcoords.pool[1], glm::dvec3(1, 0, 0));
  EXPECT_EQ(mesh.face_colours.values[1], glm::dvec4(0, 1, 0, 0));
  EXPECT_EQ(mesh.face_colours.count, (std::vector<std::uint8_t>{3, 3, 3}));
  ASSERT_EQ(mesh.quarantine.size(), 2u);
  EXPECT_EQ(mesh.quarantine[0].code, "index_out_of_range");
  EXPECT_EQ(mesh.quarantine[0].line, 42u);
  EXPECT_EQ(mesh.quarantine[1].code, "face_too_few_corners");
  ASSERT_EQ(file.properties.tables.size(), 4u);
  const PropertyTable &camera = file.properties.tables[0], &edges = file.properties.tables[3];
  EXPECT_EQ(camera.properties[0].real(0), 1.5);
  EXPECT_EQ(camera.properties[1].integer(0), -3);
  EXPECT_EQ(camera.properties[1].integer(1), 4);
  ASSERT_EQ(edges.rows, 1u) << "the other row is an edge of a face";
  EXPECT_EQ(edges.properties[1].integer(0), 2);
  EXPECT_EQ(edges.properties[2].real(0), 1);
  ASSERT_EQ(mesh.edges.size(), 1u);
  EXPECT_EQ(mesh.edges[0].to, 1u);
  ASSERT_EQ(mesh.attributes.size(), 3u);
  EXPECT_EQ(mesh.attributes[0].name, "vertex.quality");
  EXPECT_EQ(attribute_value<float>(mesh.attributes[0], 2), -1.0f);
  EXPECT_EQ(mesh.attributes[1].name, "face.label");
  EXPECT_EQ(attribute_values<std::int32_t>(mesh.attributes[1]), (std::vector<std::int32_t>{-1, 2147483647, 0}));
  EXPECT_EQ(mesh.attributes[2].name, "edge.crease");
  EXPECT_EQ(attribute_values<float>(mesh.attributes[2]), (std::vector<float>{0.5f}));
  EXPECT_EQ(file.messages.size(), 2u) << "the faces that were set aside";
}

TEST(ply_write, gives_back_everything_in_every_encoding) {
  const MeshFile file = read_sound("ply", rich_ply);
  const Format& ply = *find_format("ply");
  EXPECT_EQ(bytes_of(file, ply), rich_ply);
  for (const FormatVariant& variant : ply.variants) {
    SCOPED_TRACE(variant.id);
    const MeshFile again = read_sound("ply", bytes_of(file, ply, variant.encoding));
    EXPECT_EQ(again.encoding, variant.encoding);
    EXPECT_EQ(io_test::difference(file, again), "");
    EXPECT_EQ(difference_after_round_trip(again, "ply"), "");
    EXPECT_EQ(io_test::loss_codes(file, variant.id), "");
  }
}

TEST(ply_write, widens_a_type_that_does_not_hold_the_values) {
  MeshFile file = read_sound("ply", rich_ply);
  const Format& ply = *find_format("ply");
  file = read_sound("ply", bytes_of(file, ply, Encoding::binary_big));
  file.mesh.vertex_colours[0] = glm::dvec4(1.5, 0, 0, 1);
  file.mesh.face_colours.values[0].x = -0.5;
  file.mesh.face_colours.values[1].x = 0.1;
  file.mesh.normals.pool[0].x = 0.1;
  EXPECT_EQ(difference_after_round_trip(file, "ply"), "");
  const std::string text = bytes_of(file, ply);
  for (const char* name : {"red", "green", "blue", "nx", "ny", "nz"})
    EXPECT_NE(text.find("property double " + std::string(name)), std::string::npos) << name << text;
  EXPECT_NE(text.find("property float s"), std::string::npos) << "others keep their type";
}

TEST(ply_write, components_of_one_thing_have_one_type) {
  const MeshFile file = read_sound("obj", "v 0 0 0 1 0 0\nv 0.1 0 0 0 0.5 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
  const std::string text = bytes_of(file, *find_format("ply"), Encoding::ascii);
  EXPECT_NE(text.find("property double x\nproperty double y\nproperty double z\n"
                      "property float red\nproperty float green\nproperty float blue\n"),
            std::string::npos)
      << text;
  // A file that mixes types itself keeps them.
  constexpr std::string_view mixed =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty double x\nproperty float y\nproperty char z\n"
      "property uchar red\nproperty float green\nproperty uchar blue\nend_header\n";
  const std::string bytes = std::string(mixed) + std::string(19, '\0');
  MeshFile kept = read_sound("ply", bytes);
  EXPECT_EQ(bytes_of(kept, *find_format("ply")), bytes);
  kept.mesh.positions[0].z = 0.5;
  EXPECT_NE(bytes_of(kept, *find_format("ply")).find("property double x\nproperty double y\nproperty double z\n"),
            std::string::npos)
      << "never narrower than it was";
  kept.mesh.colour_components = 4;
  EXPECT_NE(bytes_of(kept, *find_format("ply")).find("property uchar alpha\n"), std::string::npos);
}

TEST(ply_write, colours_of_faces_keep_their_meaning) {
  const auto face_of = [](const char* colour) {
    const MeshFile file = read_sound("off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 " + std::string(colour) + "\n");
    EXPECT_EQ(io_test::loss_codes(file, "ply"), "");
    const std::string text = bytes_of(file, *find_format("ply"), Encoding::ascii);
    EXPECT_TRUE(io_test::same_bits(read_sound("ply", text).mesh.face_colours.values, file.mesh.face_colours.values));
    const std::size_t red = text.find("property ", text.find("vertex_indices"));
    const std::size_t face = text.find("\n3 0 1 2");
    return text.substr(red + 9, text.find(' ', red + 9) - red - 9) + text.substr(face + 8, text.size() - face - 9);
  };
  EXPECT_EQ(face_of("1.0 0.0 0.0"), "uchar 255 0 0");
  EXPECT_EQ(face_of("1 0 0"), "uchar 1 0 0");
  EXPECT_EQ(face_of("255 0 51 128"), "uchar 255 0 51 128");
  EXPECT_EQ(face_of("1.0 0.5 0.0"), "float 1 0.5 0");
  EXPECT_EQ(face_of("1.0 0.1 0.0"), "double 1 0.1 0");
  // And back.
  MeshFile reals = read_sound("off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1.0 0.5 0.0\n");
  reals = read_sound("ply", bytes_of(reals, *find_format("ply")));
  EXPECT_NE(bytes_of(reals, *find_format("off")).find("3 0 1 2 1.0 0.5 0.0\n"), std::string::npos);
}

TEST(ply_write, long_faces_widen_the_length_of_the_list) {
  std::string text = "OFF\n300 1 0\n";
  for (int i = 0; i < 300; ++i) text += std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
  text += "300";
  for (int i = 0; i < 300; ++i) text += " " + std::to_string(i);
  const MeshFile file = read_sound("off", text);
  for (const FormatVariant& variant : find_format("ply")->variants) {
    const MeshFile again = read_sound("ply", bytes_of(file, *find_format("ply"), variant.encoding));
    EXPECT_EQ(again.mesh.corners, file.mesh.corners) << variant.id;
  }
}

TEST(ply_read, texture_coordinates_of_corners) {
  const MeshFile file = read_sound(
      "ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 3\nproperty list uchar float texcoord\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n0 0 1\n6 0 0 1 0 0 1 3 0 1 2\n0 3 0 2 3\n6 .5 .5 1 0 0 1 3 0 3 7\n");
  EXPECT_EQ(file.mesh.texcoords.pool.size(), 6u);
  EXPECT_EQ(file.mesh.texcoords.components, 2);
  EXPECT_EQ(file.mesh.texcoords.index, (Corners{0, 1, 2, no_index, no_index, no_index}));
  EXPECT_EQ(file.mesh.quarantine[0].texcoords, (Corners{3, 4, 5}));
  EXPECT_EQ(difference_after_round_trip(file, "ply"), "");
  // Lists of another length are kept as they are.
  const MeshFile odd = read_sound(
      "ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar float texcoord\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n2 0 0 3 0 1 2\n");
  EXPECT_TRUE(odd.mesh.texcoords.pool.empty());
  EXPECT_EQ(odd.properties.tables[1].properties[0].value_count(0), 2u);
  EXPECT_EQ(difference_after_round_trip(odd, "ply"), "");
}

TEST(ply_read, values_per_corner_of_other_formats_are_held_or_named) {
  const MeshFile file = read_sound("obj",
                                   "# c\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\n"
                                   "f 1/1/1 2/2/1 3/1/1\nf 2/1/2 4/1/2 3/2/2\n");
  EXPECT_EQ(io_test::loss_codes(file, "ply"), "loses_normals");
  const MeshFile again = read_sound("ply", bytes_of(file, *find_format("ply"), Encoding::ascii));
  EXPECT_EQ(again.head_comments, std::vector<std::string>{"c"});
  EXPECT_TRUE(io_test::same_values(io_test::by_corner(again.mesh.texcoords), io_test::by_corner(file.mesh.texcoords)));
}

TEST(ply_read, binary_of_either_byte_order) {
  std::string text =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::size_t header = text.size();
  for (const float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, std::numeric_limits<float>::infinity(), 0.f})
    text += big_endian(value);
  text += std::string("\3\0\0\0\0\0\0\0\1\0\0\0\2", 13);
  const MeshFile file = read_sound("ply", text);
  EXPECT_EQ(file.mesh.positions[1], glm::dvec3(1, 0, 0));
  EXPECT_EQ(file.mesh.corners, (Corners{0, 1, 2}));
  ASSERT_EQ(file.messages.size(), 1u);
  EXPECT_EQ(file.messages[0].code, "nonfinite_number");
  EXPECT_EQ(file.messages[0].byte, header + 28);
  EXPECT_EQ(bytes_of(file, *find_format("ply")), text);

  const MeshFile more = read_sound("ply", text + "ab");
  EXPECT_EQ(find_message(more, "extra_data")->byte, text.size());
  for (std::size_t cut = header; cut < text.size(); ++cut) {
    const Failure failure = read_refused("ply", text.substr(0, cut));
    EXPECT_EQ(failure.message.code, "unexpected_end") << cut;
    EXPECT_EQ(failure.message.byte, cut);
  }
}

TEST(ply_read, indices_that_cannot_be) {
  std::string text =
      "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty list uchar TYPE vertex_indices\nend_header\n";
  const auto with_type = [&](std::string_view type) {
    std::string out = text;
    out.replace(out.find("TYPE"), 4, type);
    return out + std::string("\3\xff\xff\xff\xff\0\0\0\0\1\0\0\0\0", 14);
  };
  EXPECT_EQ(read_sound("ply", with_type("int")).mesh.quarantine[0].corners, (std::vector<std::int64_t>{-1, 0, 1}));
  const MeshFile file = read_sound("ply", with_type("uint"));
  EXPECT_EQ(file.mesh.quarantine[0].corners, (std::vector<std::int64_t>{0xffffffff, 0, 1}));
  EXPECT_EQ(find_message(file, "index_out_of_range")->face, 0u);
  EXPECT_EQ(find_message(file, "face_too_few_corners")->face, 1u);
  EXPECT_EQ(difference_after_round_trip(file, "ply"), "");
}

TEST(ply_read, headers_that_cannot_be) {
  expect_refusals(
      "ply", ply_tetrahedron,
      {
          {"ply\n", "plyx\n", "not_ply", 1},
          {"ascii", "asci", "unknown_encoding", 2},
          {"1.0", "2.0", "unsupported_version", 2},
          {"format ascii 1.0\n", "", "missing_format", 8},
          {"vertex 4", "vertex four", "unreadable_number", 3},
          {"vertex 4", "vertex -4", "negative_count", 3},
          {"vertex 4", "vertex 2000000000", "count_too_large", 3},
          {"vertex 4", "vertex 99999999999999999999", "count_too_large", 3},
          {"element vertex 4", "element vertx 4", "missing_element", 9},
          {"element face 4", "element vertex 4", "repeated_element", 7},
          {"element vertex 4\n", "", "property_without_element", 3},
          {"float x", "flout x", "unknown_type", 4},
          {"float x", "list float int x", "unknown_type", 4},
          {"float x", "list uchar int x", "missing_property", 3},
          {"float x", "float", "missing_name", 4},
          {"uchar int", "uchar float", "missing_property", 7},
          {"vertex_indices", "indices", "missing_property", 7},
          {"end_header\n", "", "unknown_keyword", 9},
          {"end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n", "", "unexpected_end", 9},
      });
}

TEST(ply_read, unknown_lines_of_the_header_keep_their_place) {
  const std::string text =
      "ply\nformat ascii 1.0\ncomment c\nobj_info o\nsoftware of 1999\nunits\tmm\nelement vertex 3\nnote first\n"
      "property float x\nproperty float y\nnote in between\nproperty float z\nnote behind\nelement face 1\n"
      "property list uchar int vertex_indices\n_end\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const Failure refused = read_refused("ply", text);
  EXPECT_EQ(refused.message.code, "unknown_keyword") << "begins with no letter";
  std::string sound = text;
  sound.replace(sound.find("_end\n"), 5, "zend\n");
  const MeshFile file = read_sound("ply", sound);
  EXPECT_EQ(bytes_of(file, *find_format("ply")), sound);
  std::vector<std::uint64_t> lines;
  for (const Message& message : file.messages) {
    EXPECT_EQ(message.code, "unknown_keyword");
    lines.push_back(message.line.value_or(0));
  }
  EXPECT_EQ(lines, (std::vector<std::uint64_t>{5, 6, 8, 11, 13, 16}));
  EXPECT_EQ(io_test::loss_codes(file, "ply"), "");
  EXPECT_EQ(io_test::loss_codes(file, "off"), "loses_extra_elements");
  EXPECT_EQ(losses_of(file, *find_format("off"))[0].count, 7u);
  for (const FormatVariant& variant : find_format("ply")->variants) {
    const MeshFile again = read_sound("ply", bytes_of(file, *find_format("ply"), variant.encoding));
    EXPECT_EQ(again.properties.unknown_lines, file.properties.unknown_lines) << variant.id;
  }
}

TEST(ply_read, damage_in_comments_is_read_as_it_is_written) {
  const std::string text(
      "ply\nformat ascii 1.0\ncomment a\0b\nobj_info c\0\nelement vertex 1\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n0 0 0\n",
      130);
  const MeshFile file = read_sound("ply", text);
  EXPECT_EQ(file.head_comments, std::vector<std::string>{"a b"});
  EXPECT_EQ(difference_after_round_trip(file, "ply"), "");
}

TEST(ply_read, a_refusal_names_the_unknown_word_that_may_have_led_to_it) {
  const Failure failure =
      read_refused("ply",
                   "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproprety float z\n"
                   "end_header\n0 0 0\n");
  EXPECT_EQ(failure.message.code, "missing_property");
  EXPECT_NE(failure.message.text.en.find("Line 6 begins with \"proprety\""), std::string::npos)
      << failure.message.text.en;
}

TEST(ply_read, rows_that_cannot_be) {
  expect_refusals("ply", ply_tetrahedron,
                  {
                      {"1 0 0\n", "1 0\n", "missing_number", 11},
                      {"1 0 0\n", "1 x 0\n", "unreadable_number", 11},
                      {"3 0 1 3", "3 0 1", "short_face", 15},
                      {"3 0 1 3", "3 0 1.5 3", "unreadable_index", 15},
                      {"3 0 1 3", "-3 0 1 3", "negative_count", 15},
                      {"3 0 3 2\n", "", "unexpected_end", 17},
                  });
  std::string text(rich_ply);
  text.replace(text.find("-3 4\n"), 5, "-3 40000\n");
  EXPECT_EQ(read_refused("ply", text).message.code, "number_out_of_type");
}

TEST(ply_read, rows_that_are_odd) {
  std::string text(ply_tetrahedron);
  text.replace(text.find("1 0 0\n"), 6, "\n\t1 1e999 0 7\r\n");
  const MeshFile file = read_sound("ply", text + "9 9\n\n8\n");
  EXPECT_EQ(find_message(file, "nonfinite_number")->line, 12u);
  EXPECT_EQ(find_message(file, "extra_values")->line, 12u);
  EXPECT_EQ(find_message(file, "extra_data")->line, 19u);
  EXPECT_EQ(file.mesh.corners.size(), 12u);
}

TEST(ply_read, the_other_byte_order_shows_by_every_face) {
  std::string text = bytes_of(read_sound("ply", ply_tetrahedron), *find_format("ply"), Encoding::binary_little);
  const std::size_t first_face = text.find("end_header\n") + 11 + 48;
  text.replace(text.find("little"), 6, "big");
  const Failure failure = read_refused("ply", text);
  EXPECT_EQ(failure.message.code, "wrong_byte_order");
  EXPECT_EQ(failure.message.byte, first_face - 3);
}

// A strip of triangles that is long enough to be read in parts, in an encoding.
std::string long_strip(const MeshFile& changed, std::string_view encoding) {
  return bytes_of(changed, *find_format("ply"), find_target(encoding)->encoding);
}

TEST(ply_read, long_files_are_read_in_parts_as_if_in_one) {
  MeshFile file;
  constexpr std::uint32_t faces = 60000;
  for (std::uint32_t i = 0; i < faces + 2; ++i) file.mesh.positions.emplace_back(i / 2, i % 2, 0.25 * (i % 7));
  for (std::uint32_t i = 0; i < faces; ++i) {
    file.mesh.corners.insert(file.mesh.corners.end(), {i, i + 1, i + 2});
    file.mesh.face_offsets.push_back(3 * (i + 1));
  }
  const auto all_read_alike = [](const MeshFile& changed) {
    const MeshFile text = read_sound("ply", long_strip(changed, "ply-ascii"));
    for (const char* encoding : {"ply-little", "ply-big"}) {
      const MeshFile binary = read_sound("ply", long_strip(changed, encoding));
      EXPECT_EQ(io_test::difference(text, binary), "");
      EXPECT_EQ(text.messages.size(), binary.messages.size());
    }
  };
  // Flaws at both ends and where the parts meet; then a face of four corners in each of these places.
  for (const std::uint32_t face : {0u, faces / 2 - 1, faces / 2, faces - 1})
    file.mesh.corners[3 * face + 1] = 3000000000u;
  for (const std::uint32_t vertex : {7u, faces / 2 + 1, faces + 1}) file.mesh.positions[vertex].y = HUGE_VAL;
  all_read_alike(file);
  for (const std::uint32_t face : {faces - 1, faces / 2, faces / 2 - 1, 0u}) {
    MeshFile with_quad = file;
    with_quad.mesh.corners.insert(with_quad.mesh.corners.begin() + 3 * face, face + 5);
    for (std::uint32_t f = face; f < faces; ++f) ++with_quad.mesh.face_offsets[f + 1];
    all_read_alike(with_quad);
  }
}

// Lines of plain numbers are read in blocks; anything else, from where it stands on, line by line.
TEST(ply_read, long_text_is_read_in_blocks_as_if_line_by_line) {
  constexpr std::uint32_t rows = 40000;
  const auto text_with = [&](const auto& vertex, const auto& face) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(rows) +
                       "\nproperty float x\nproperty float y\nproperty double z\nproperty uchar red\n"
                       "property uchar green\nproperty uchar blue\nelement face " +
                       std::to_string(rows) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (std::uint32_t i = 0; i < rows; ++i) text += vertex(i);
    for (std::uint32_t i = 0; i < rows; ++i) text += face(i);
    return text;
  };
  const auto plain_vertex = [](std::uint32_t i) {
    return std::to_string(i) + ".25 -1e-3\t" + std::to_string(i % 7) + " 255 " + std::to_string(i % 256) + " 0 \r\n";
  };
  const auto plain_face = [](std::uint32_t i) {
    return "3 " + std::to_string(i) + " " + std::to_string((i + 1) % rows) + "  " + std::to_string((i + 2) % rows) +
           "\n";
  };
  const MeshFile in_blocks = read_sound("ply", text_with(plain_vertex, plain_face));
  EXPECT_TRUE(in_blocks.messages.empty());
  EXPECT_EQ(in_blocks.mesh.vertex_lines.line(rows - 1), 12u + rows);
  EXPECT_EQ(in_blocks.mesh.face_lines[rows - 1], 12u + 2 * rows);
  EXPECT_EQ(in_blocks.mesh.positions[rows - 1], glm::dvec3(rows - 0.75, -1e-3, (rows - 1) % 7));
  for (const std::uint32_t odd : {0u, 1u, 2u, 12345u, rows - 1}) {  // a sign, zeros before: the same, but not plain
    const MeshFile by_line = read_sound(
        "ply", text_with([&](std::uint32_t i) { return (i == odd ? "+" : "") + plain_vertex(i); },
                         [&](std::uint32_t i) { return i == odd ? "0000000000" + plain_face(i) : plain_face(i); }));
    EXPECT_EQ(io_test::difference(in_blocks, by_line), "") << odd;
    EXPECT_EQ(by_line.mesh.face_lines, in_blocks.mesh.face_lines);
    EXPECT_EQ(by_line.mesh.vertex_lines, in_blocks.mesh.vertex_lines);
  }
  const MeshFile flawed =
      read_sound("ply", text_with([&](std::uint32_t i) { return i == 20000 ? "nan 0 0 0 0 0\n\n" : plain_vertex(i); },
                                  [&](std::uint32_t i) { return i == 30000 ? "4 1 2 3 4 5\n" : plain_face(i); }));
  ASSERT_EQ(flawed.messages.size(), 2u);
  EXPECT_EQ(flawed.messages[0].line, 13u + 20000);
  EXPECT_EQ(flawed.messages[1].line, 13u + rows + 1 + 30000);
  EXPECT_EQ(flawed.mesh.face_lines.back(), 12u + 2 * rows + 1);
}

TEST(ply_read, many_elements_are_read_in_time_that_grows_with_their_number) {
  std::string header =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
  constexpr std::size_t count = 50000;
  for (std::size_t i = 0; i < count; ++i) header += "element e" + std::to_string(i) + " 0\n";
  const auto begin = std::chrono::steady_clock::now();
  const MeshFile file = io_test::read_sound("ply", header + "end_header\n0 0 0\n");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2)) << "comparing all with all takes longer";
  EXPECT_EQ(file.properties.tables.size(), count + 1);
  const Failure failure = io_test::read_refused("ply", header + "element e0 0\nend_header\n0 0 0\n");
  EXPECT_EQ(failure.message.code, "repeated_element");
  EXPECT_EQ(failure.message.line, count + 7);
}

// Whole numbers that no double holds, as coordinates and as further properties.
constexpr std::string_view wide_numbers =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty int64 x\nproperty float y\nproperty float z\n"
    "property int64 id\nproperty uint64 key\nproperty list uchar uint64 keys\nelement face 1\n"
    "property list uchar int vertex_indices\nproperty int64 part\nend_header\n"
    "9007199254740993 0 0 9007199254740993 18446744073709551615 1 9007199254740995\n"
    "-9007199254740994 0 0 -9223372036854775807 9223372036854775809 0\n"
    "0 1 0 3 4 2 1 18446744073709551613\n3 0 1 2 -9007199254740993\n";

TEST(ply_read, whole_numbers_of64_bits_are_kept_and_rounded_coordinates_named) {
  const MeshFile file = io_test::read_sound("ply", wide_numbers);
  const Message* const message = io_test::find_message(file, "rounded_number");
  ASSERT_NE(message, nullptr);
  EXPECT_EQ(message->line, 14u);
  EXPECT_EQ(message->column, 1u);
  EXPECT_EQ(file.messages.size(), 1u) << "the second coordinate is even, so a double holds it";
  for (const char* id : {"ply-ascii", "ply-little", "ply-big"}) {
    SCOPED_TRACE(id);
    const WriteOptions target = *find_target(id);
    const std::string bytes = bytes_of(file, *target.format, target.encoding);
    const MeshFile again = io_test::read_sound("ply", bytes);
    EXPECT_EQ(io_test::difference(file, again), "");
    EXPECT_TRUE(again.messages.empty()) << "what is written is what the mesh has";
    const std::string text = bytes_of(again, *target.format, Encoding::ascii);
    for (const char* word :
         {"property int64 id\n", "property uint64 key\n", " 9007199254740993 18446744073709551615 1 9007199254740995\n",
          " -9223372036854775807 9223372036854775809 0\n", " 3 4 2 1 18446744073709551613\n",
          "3 0 1 2 -9007199254740993\n"}) {
      EXPECT_NE(text.find(word), std::string::npos) << word << text;
    }
  }
}

// Rows in either byte order, alone and beside lists.
TEST(ply_read, binary_coordinates_that_are_rounded_are_named) {
  for (const bool has_list : {false, true}) {
    for (const char* order : {"binary_little_endian", "binary_big_endian"}) {
      const bool swaps =
          (order == std::string_view("binary_big_endian")) == (std::endian::native == std::endian::little);
      std::string bytes = "ply\nformat " + std::string(order) +
                          " 1.0\nelement vertex 2\nproperty uint64 x\nproperty uint64 y\nproperty uint64 z\n" +
                          (has_list ? "property list uchar int more\n" : "") + "end_header\n";
      const std::size_t head = bytes.size();
      for (const std::uint64_t value : {1ull << 60, 5ull, 18446744073709551615ull, 7ull, 8ull, 9ull}) {
        std::string word(8, '\0');
        std::memcpy(word.data(), &value, 8);
        if (swaps) std::reverse(word.begin(), word.end());
        bytes += word;
        if (has_list && (value == 18446744073709551615ull || value == 9)) bytes += '\0';
      }
      const MeshFile file = io_test::read_sound("ply", bytes);
      const Message* const message = io_test::find_message(file, "rounded_number");
      ASSERT_NE(message, nullptr) << order;
      EXPECT_EQ(message->byte, head + 16) << order;
      EXPECT_EQ(file.mesh.positions[0], glm::dvec3(1152921504606846976.0, 5, 18446744073709551616.0));
    }
  }
}

TEST(ply_read, points_without_faces) {
  const std::string_view points =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 "
      "3\n";
  const MeshFile cloud = read_sound("ply", points);
  EXPECT_NE(find_message(cloud, "no_faces"), nullptr);
  EXPECT_EQ(bytes_of(cloud, *find_format("ply")), points);
}

TEST(ply_read, points_without_z_are_told_once) {
  struct Case {
    const char *properties, *rows;
    std::size_t told;
  };
  const Case cases[] = {
      {"property float x\nproperty float y\n", "0 0\n1 0\n0 1\n", 1},
      {"property double y\nproperty uchar red\nproperty double x\n", "0 5 0\n0 5 1\n1 5 0\n", 1},
      {"property float x\nproperty float y\nproperty float z\n", "0 0 0\n1 0 0\n0 1 0\n", 0},
      {"property float z\nproperty float x\nproperty float y\n", "0 0 0\n0 1 0\n0 0 1\n", 0},
      {"property float x\nproperty float y\nproperty list uchar float z\n", "0 0 0\n1 0 0\n0 1 0\n", 1},
  };
  for (const Case& one : cases) {
    const std::string text = "ply\nformat ascii 1.0\nelement vertex 3\n" + std::string(one.properties) +
                             "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + one.rows +
                             "3 0 1 2\n";
    const MeshFile file = read_sound("ply", text);
    ASSERT_EQ(file.messages.size(), one.told) << text;
    if (one.told == 0) continue;
    EXPECT_EQ(file.messages[0].code, "points_without_z");
    EXPECT_EQ(file.messages[0].severity, Severity::info);
    EXPECT_GT(file.messages[0].line, 0u);
    EXPECT_FALSE(file.messages[0].text.ja.empty());
    EXPECT_EQ(file.mesh.positions[1], glm::dvec3(1, 0, 0));
    const MeshFile again = read_sound("ply", bytes_of(file, *find_format("ply")));
    EXPECT_EQ(again.mesh.positions, file.mesh.positions);
    EXPECT_TRUE(again.messages.empty()) << "what is written has z";
  }
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\nend_header\n";
  const std::size_t head = bytes.size();
  bytes += std::string(2, '\1');
  const MeshFile binary = read_sound("ply", bytes);
  ASSERT_NE(find_message(binary, "points_without_z"), nullptr);
  EXPECT_EQ(find_message(binary, "points_without_z")->byte, head);
  const MeshFile empty =
      read_sound("ply", "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nend_header\n");
  EXPECT_EQ(find_message(empty, "points_without_z"), nullptr) << "there are no points";
}

}  // namespace
}  // namespace ryosen
