#include "ryosen/io/txt.h"

#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::difference_after_round_trip;
using io_test::expect_refusals;
using io_test::find_message;
using io_test::read_refused;
using io_test::read_sound;
using Corners = std::vector<std::uint32_t>;

constexpr std::string_view triangle_list = "4 4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 3 2\n1 2 4\n2 3 4\n1 4 3\n";

TEST(txt_read, four_faces) {
  const MeshFile file = read_sound("txt", triangle_list);
  EXPECT_TRUE(file.messages.empty());
  EXPECT_EQ(file.mesh.corners, (Corners{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}));
  EXPECT_EQ(file.mesh.face_lines, (Corners{6, 7, 8, 9}));
  EXPECT_EQ(bytes_of(file, *find_format("txt")), triangle_list);
}

TEST(txt_read, faces_that_cannot_be_used) {
  const MeshFile file = read_sound("txt", "3 5\n.1 0 0\n1 nan 0\n0 1 -0\n1 2 3\n1 2 4\n1 1 2\n0 1 2\n-5 1 3\n\nrest\n");
  EXPECT_EQ(find_message(file, "nonfinite_number")->line, 3u);
  EXPECT_EQ(find_message(file, "extra_data")->line, 11u);
  ASSERT_EQ(file.mesh.quarantine.size(), 4u);
  EXPECT_EQ(file.mesh.quarantine[1].code, "repeated_corner");
  EXPECT_EQ(file.mesh.quarantine[2].corners[0], -1);
  EXPECT_EQ(file.mesh.quarantine[3].corners[0], -6);
  EXPECT_EQ(difference_after_round_trip(file, "txt"), "");
}

TEST(txt_read, lists_that_cannot_be) {
  expect_refusals("txt", triangle_list,
                  {
                      {"4 4\n", "4\n", "missing_number", 1},
                      {"4 4\n", "4 4 0\n", "extra_values", 1},
                      {"4 4\n", "-4 4\n", "negative_count", 1},
                      {"4 4\n", "99999999999999999999 4\n", "count_too_large", 1},
                      {"4 4\n", "4 5\n", "unexpected_end", 10},
                      {"4 4\n", "4.0 4\n", "unreadable_index", 1},
                      {"1 0 0\n", "1 0\n", "missing_number", 3},
                      {"1 0 0\n", "1 0 0 9\n", "extra_values", 3},
                      {"1 0 0\n", "1 zero 0\n", "unreadable_number", 3},
                      {"1 3 2\n", "1 3\n", "missing_number", 6},
                      {"1 3 2\n", "1 3 2 4\n", "extra_values", 6},
                      {"1 3 2\n", "1 3 2.5\n", "unreadable_index", 6},
                      {"1 3 2\n1 2 4\n2 3 4\n1 4 3\n", "0 2 1\n0 1 3\n1 2 3\n0 3 2\n", "zero_based", 6},
                  });
}

TEST(txt_write, cuts_polygons_and_names_what_it_cannot_hold) {
  const MeshFile file = read_sound("obj",
                                   "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 9 9 9\nvt 0 0\nvn 0 0 1\n"
                                   "f 1/1/1 2/1/1 3/1/1 4/1/1\nf 1 2\nf 1 2 77\nl 1 2\n");
  EXPECT_EQ(io_test::loss_codes(file, "txt"),
            "loses_polygons loses_quarantined loses_elements loses_texcoords loses_normals");
  const MeshFile again = read_sound("txt", bytes_of(file, *find_format("txt")));
  EXPECT_EQ(again.mesh.positions.size(), 5u);
  EXPECT_EQ(again.mesh.face_count(), 3u);
  EXPECT_EQ(again.mesh.corners.size(), 6u);
  EXPECT_EQ(again.mesh.quarantine[0].corners, (std::vector<std::int64_t>{0, 1, 76}));
}

}  // namespace
}  // namespace ryosen
