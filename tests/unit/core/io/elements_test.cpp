#include "ryosen/io/edited_file.h"

#include "ryosen/io/obj.h"
#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

constexpr std::string_view sample_text =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0\nvt 1\nl 1/1 2/2 3/1\nf 1 2 3\np 2\nf 1 2 4\nl 2 4\np 1 9 0\nl\n";

TEST(elements, stay_the_same_without_change) {
  const MeshFile file = io_test::read_sound("obj", sample_text);
  const std::vector<std::uint32_t> vertices = {0, 1, 2, 3}, faces = {0, 1};
  EXPECT_TRUE(io_test::same_elements(renumbered(file.elements, vertices, faces, 4, 4), file.elements));
}

TEST(elements, are_counted) {
  const ElementTotals totals = totals_of(io_test::read_sound("obj", sample_text));
  EXPECT_EQ(totals.lines, 3u);
  EXPECT_EQ(totals.points, 2u);
}

TEST(elements, follow_their_vertices_and_lose_those_that_are_gone) {
  const MeshFile file = io_test::read_sound("obj", sample_text);
  // Vertex 1 and face 0 are gone, two vertices and a face are new.
  const std::vector<std::uint32_t> vertices = {0, no_index, 1, 2, 3, 4}, faces = {no_index, 0, 1};
  const ElementList out = renumbered(file.elements, vertices, faces, 4, 5);
  ASSERT_EQ(out.items.size(), 3u);
  EXPECT_EQ(out.vertices, (std::vector<std::int64_t>{0, 1, 0, 9, -1}));
  EXPECT_EQ(out.items[0].count, 2u);
  EXPECT_EQ(out.texcoords, (std::vector<std::uint32_t>{0, 0, no_index, no_index, no_index}));
  EXPECT_TRUE(out.items[1].is_points);
  EXPECT_EQ(out.items[1].before_face, 1u);
  EXPECT_EQ(out.items[2].count, 0u);
}

}  // namespace
}  // namespace ryosen
