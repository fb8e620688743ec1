// Ascii PLY whose rows are not one a line, and points without z: read where the count of numbers comes out exactly.
#include <algorithm>

#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::find_message;
using io_test::read_refused;
using io_test::read_sound;
using Corners = std::vector<std::uint32_t>;

constexpr std::string_view coloured_head =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float weights\nend_header\n";
constexpr std::string_view coloured_rows =
    "0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n0 1 0 9 9 9\n3 0 1 2 1 0.5\n3 0 2 3 2 1 2\n";

std::string coloured(std::string_view rows) { return std::string(coloured_head) + std::string(rows); }

// The same numbers with a line end behind every `each`-th, or blanks alone.
std::string spread_rows(std::string_view rows, int each) {
  std::string out;
  int count = 0;
  for (const char c : rows) {
    const bool is_blank = c == ' ' || c == '\n';
    out += !is_blank ? c : each > 0 && ++count % each == 0 ? '\n' : ' ';
  }
  return out;
}

TEST(ply_text, rows_may_be_spread_over_lines_in_any_way) {
  const MeshFile by_lines = read_sound("ply", coloured(coloured_rows));
  EXPECT_TRUE(by_lines.messages.empty());
  for (const int each : {0, 1, 2, 3, 4, 5, 7, 11, 100}) {
    const MeshFile file = read_sound("ply", coloured(spread_rows(coloured_rows, each)));
    EXPECT_EQ(io_test::difference(by_lines, file), "") << each;
    ASSERT_EQ(file.messages.size(), 1u) << each;
    EXPECT_EQ(file.messages[0].code, "read_by_words");
  }
  const MeshFile file = read_sound("ply", coloured(spread_rows(coloured_rows, 3)));
  EXPECT_EQ(file.messages[0].line, 14u) << "the first row without a line for itself";
  EXPECT_EQ(file.mesh.vertex_lines.line(1), 16u);
  EXPECT_EQ(file.mesh.face_lines[0], 22u);
}

TEST(ply_text, a_vertex_or_face_on_two_lines_among_others_on_one) {
  for (const auto& [from, to] : {std::pair{"1 0 0 0 255", "1 0 0\n0 255"},
                                 {"3 0 2 3 2", "3 0 2 3\n2"},
                                 {"3 0 1 2 1", "3\n0 1 2 1"},
                                 {"9 9 9\n3", "9 9 9 3"}}) {
    std::string rows(coloured_rows);
    rows.replace(rows.find(from), std::string_view(from).size(), to);
    const MeshFile file = read_sound("ply", coloured(rows));
    EXPECT_EQ(io_test::difference(read_sound("ply", coloured(coloured_rows)), file), "") << from;
    EXPECT_NE(find_message(file, "read_by_words"), nullptr) << from;
  }
}

TEST(ply_text, one_number_more_or_less_leaves_the_error_of_the_line) {
  const std::string spread = spread_rows(coloured_rows, 3);
  EXPECT_EQ(read_refused("ply", coloured(spread + "0\n")).message.code, "missing_number");
  EXPECT_EQ(read_refused("ply", coloured(spread.substr(0, spread.size() - 2))).message.code, "missing_number");
  EXPECT_EQ(read_refused("ply", coloured(spread) + "0").message.line, 14u);
  for (const auto& [from, to, code] : {std::tuple{"1 0 0 0 255 0", "1 0 0 0 255", "missing_number"},
                                       {"1 0 0 0", "1 x 0 0", "unreadable_number"},
                                       {"3 0 2 3 2 1 2\n", "3 0 2 3 2 1\n", "short_face"},
                                       {"3 0 2 3 2", "9 0 2 3 2", "short_face"},
                                       {"3 0 1 2 1 0.5\n", "", "unexpected_end"}}) {
    std::string rows(coloured_rows);
    rows.replace(rows.find(from), std::string_view(from).size(), to);
    EXPECT_EQ(read_refused("ply", coloured(rows)).message.code, code) << from;
  }
}

TEST(ply_text, damage_that_numbers_betray_is_not_taken_for_spread_rows) {
  // A number moved from one place to another: as many as are announced, but faces that cannot be.
  std::string rows(coloured_rows);
  rows.replace(rows.find("1 0 0 0 255 0\n"), 14, "1 0 0 0 255\n");
  rows += "2\n";
  EXPECT_EQ(read_refused("ply", coloured(rows)).message.code, "missing_number");
}

constexpr std::string_view flat_head =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
constexpr std::string_view flat_rows = "0 0\n1 0\n1 1\n0 1\n3 0 1 2\n3 0 2 3\n";

TEST(ply_text, points_without_z_lie_in_a_plane) {
  const MeshFile file = read_sound("ply", std::string(flat_head) + std::string(flat_rows));
  EXPECT_EQ(file.mesh.positions[2], glm::dvec3(1, 1, 0));
  EXPECT_EQ(file.mesh.corners, (Corners{0, 1, 2, 0, 2, 3}));
  ASSERT_EQ(file.messages.size(), 1u);
  EXPECT_EQ(file.messages[0].code, "points_without_z");
  EXPECT_EQ(file.mesh.face_lines, (Corners{13, 14}));
  for (const FormatVariant& variant : find_format("ply")->variants) {
    const std::string bytes = bytes_of(file, *find_format("ply"), variant.encoding);
    EXPECT_NE(bytes.find("property float x\nproperty float y\nproperty float z\n"), std::string::npos) << bytes;
    EXPECT_EQ(io_test::read_sound("ply", bytes).mesh.positions, file.mesh.positions);
  }
}

TEST(ply_text, points_without_z_may_be_spread_too) {
  const MeshFile file = read_sound("ply", std::string(flat_head) + spread_rows(flat_rows, 3));
  EXPECT_EQ(file.mesh.positions[3], glm::dvec3(0, 1, 0));
  EXPECT_NE(find_message(file, "read_by_words"), nullptr);
}

TEST(ply_text, points_without_z_need_the_exact_count) {
  const auto refused = [](std::string_view rows) {
    return read_refused("ply", std::string(flat_head) + std::string(rows)).message;
  };
  for (const std::string_view rows :
       {"0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n", "0 0\n1 0\n1 1\n0 1\n3 0 1 2\n3 0 2 3\n7\n",
        "0 0\n1 0\n1 1\n0 1\n3 0 1 2\n3 0 2\n", "0 0\n1 0\n1 1 5\n0 1\n3 0 1 2\n3 0 2 3\n", ""}) {
    EXPECT_EQ(refused(rows).code, "missing_property") << rows;
    EXPECT_EQ(refused(rows).line, 3u) << rows;
  }
  // Without y there is no plane.
  std::string text = std::string(flat_head) + std::string(flat_rows);
  text.replace(text.find("property float y\n"), 17, "");
  EXPECT_EQ(read_refused("ply", text).message.code, "missing_property");
}

TEST(ply_text, binary_points_without_z_need_the_exact_size) {
  MeshFile file = read_sound("ply", std::string(flat_head) + std::string(flat_rows));
  std::string bytes = bytes_of(file, *find_format("ply"), Encoding::binary_little);
  const std::size_t head = bytes.find("end_header\n") + 11;
  for (int v = 3; v >= 0; --v) bytes.erase(head + static_cast<std::size_t>(v) * 12 + 8, 4);
  bytes.replace(bytes.find("property float z\n"), 17, "");
  EXPECT_EQ(read_sound("ply", bytes).mesh.positions, file.mesh.positions);
  EXPECT_EQ(read_refused("ply", bytes + "x").message.code, "missing_property");
  EXPECT_EQ(read_refused("ply", bytes.substr(0, bytes.size() - 1)).message.code, "missing_property");
}

TEST(ply_text, many_spread_rows_take_time_that_grows_with_their_number) {
  constexpr int points = 60000;
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points) +
                     "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (int i = 0; i < points; ++i) text += std::to_string(i) + "\n0 " + std::to_string(i % 7) + "\n";
  const MeshFile file = read_sound("ply", text);
  EXPECT_EQ(file.mesh.positions[points - 1], glm::dvec3(points - 1, 0, (points - 1) % 7));
  EXPECT_NE(find_message(file, "read_by_words"), nullptr);
}

// A table that begins amid a line has as much room as the whole rest of the file.
TEST(ply_text, tables_may_begin_amid_a_line) {
  const std::string camera = "element camera 1\nproperty float view\n",
                    vertices =
                        "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                        "property uchar red\nproperty uchar green\nproperty uchar blue\n",
                    faces =
                        "element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\n"
                        "property uchar green\nproperty uchar blue\n";
  const std::string of_camera = "7 ", of_vertices = "0 0 0 1 2 3 1 0 0 4 5 6 0 1 0 7 8 9 0 0 1 1 1 1 ",
                    of_faces = "3 0 1 2 9 9 9 3 0 2 3 8 8 8 ";
  struct Case {
    std::string head, data;
  };
  for (const Case& c :
       {Case{camera + vertices + faces, of_camera + of_vertices + of_faces},
        Case{vertices + camera + faces, of_vertices + of_camera + of_faces},
        Case{vertices + faces + camera, of_vertices + of_faces + of_camera},
        Case{camera + vertices, of_camera + of_vertices}, Case{vertices + faces, of_vertices + of_faces}}) {
    const MeshFile file =
        io_test::read_sound("ply", "ply\nformat ascii 1.0\n" + c.head + "end_header\n" + c.data + "\n");
    ASSERT_EQ(file.mesh.positions.size(), 4u);
    EXPECT_EQ(file.mesh.positions[3], glm::dvec3(0, 0, 1));
    EXPECT_EQ(file.mesh.vertex_colours[2].z, 9 / 255.0);
    if (file.mesh.face_count() == 0) continue;
    EXPECT_EQ(file.mesh.face_colours.values[1].x, 8 / 255.0);
  }
}

}  // namespace
}  // namespace ryosen
