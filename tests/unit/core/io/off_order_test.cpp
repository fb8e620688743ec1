// The letters of the first word of OFF, and which of normal and colour comes first.
#include "ryosen/io/off_builder.h"

#include "ryosen/io/off.h"
#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::find_message;
using io_test::read_sound;

const std::string two_faces = "3 0 2 1\n3 0 1 3\n";

std::string off(const std::string& word, std::initializer_list<const char*> numbers) {
  std::string text = word + "\n4 2 0\n";
  const char* const places[] = {"0 0 0 ", "1 0 0 ", "0 1 0 ", "0 0 1 "};
  std::size_t v = 0;
  for (const char* row : numbers) text += places[v++] + std::string(row) + "\n";
  return text + two_faces;
}

TEST(off_order, letters_have_any_order) {
  const auto in_order = {"0 0 1 255 0 0 255", "0 1 0 0 255 0 255", "1 0 0 0 0 255 255", "0 0 -1 9 9 9 255"};
  const MeshFile first = read_sound("off", off("CNOFF", in_order));
  EXPECT_TRUE(first.messages.empty());
  EXPECT_EQ(first.mesh.normals.pool[3], glm::dvec3(0, 0, -1));
  EXPECT_EQ(first.mesh.vertex_colours[1], glm::dvec4(0, 1, 0, 1));
  EXPECT_EQ(io_test::difference(first, read_sound("off", off("NCOFF", in_order))), "");
  const auto with_texcoords = {"0 0 1 255 0 0 0.5 0.25", "0 1 0 0 255 0 0 1", "1 0 0 0 0 255 1 0", "0 0 -1 9 9 9 1 1"};
  const MeshFile all = read_sound("off", off("STCNOFF", with_texcoords));
  EXPECT_EQ(all.mesh.texcoords.pool[0], glm::dvec3(0.5, 0.25, 0));
  for (const char* word : {"STNCOFF", "CSTNOFF", "CNSTOFF", "NSTCOFF", "NCSTOFF"})
    EXPECT_EQ(io_test::difference(all, read_sound("off", off(word, with_texcoords))), "") << word;
  for (const char* word : {"NSTOFF", "STNOFF"})
    EXPECT_EQ(
        read_sound("off", off(word, {"0 0 1 .5 1", "0 0 1 0 0", "0 0 1 1 1", "0 0 1 1 0"})).mesh.texcoords.pool[0],
        glm::dvec3(0.5, 1, 0))
        << word;
  for (const char* word : {"CCOFF", "NNOFF", "STSTOFF", "TSOFF", "XOFF", "OFFN"})
    EXPECT_FALSE(OffKind::from_word(word).has_value()) << word;
  for (const char* word : {"4OFF", "N4OFF", "4NOFF", "nOFF", "CnOFF", "n4COFF"})
    EXPECT_FALSE(OffKind::from_word(word)->is_three_dimensional) << word;
}

TEST(off_order, colours_come_first_where_only_so_normals_are_of_length_1) {
  const MeshFile file = read_sound(
      "off", off("NCOFF", {"255 0 0 255 0 0 -1", "0 255 0 255 1 0 0", "0 0 255 255 0 1 0", "9 9 9 255 0 0 1"}));
  EXPECT_EQ(file.mesh.vertex_colours[0], glm::dvec4(1, 0, 0, 1));
  EXPECT_EQ(file.mesh.normals.pool[0], glm::dvec3(0, 0, -1));
  ASSERT_EQ(file.messages.size(), 1u) << "said once";
  EXPECT_EQ(file.messages[0].code, "content_mismatch");
  EXPECT_EQ(file.messages[0].line, 3u);
  EXPECT_EQ(io_test::difference_after_round_trip(file, "off"), "");
  const MeshFile three = read_sound(
      "off", off("CNOFF", {"0.5 0 0 0.6 0 0.8", "0 0.5 0 1 0 0", "0 0 0.5 0 1.005 0", "0.25 0.25 0.25 0 0 1"}));
  EXPECT_EQ(three.mesh.vertex_colours[0], glm::dvec4(0.5, 0, 0, 1));
  EXPECT_EQ(three.mesh.normals.pool[0], glm::dvec3(0.6, 0, 0.8));
}

TEST(off_order, a_colour_out_of_range_tells_too) {
  const MeshFile file = read_sound("off", off("NCOFF", {"1 0 0 0 0 -1", "0 1 0 1 0 0", "0 0 1 0 1 0", "0 1 0 0 0 1"}));
  EXPECT_EQ(file.mesh.vertex_colours[0], glm::dvec4(1, 0, 0, 1));
  EXPECT_EQ(file.mesh.normals.pool[0], glm::dvec3(0, 0, -1));
  EXPECT_NE(find_message(file, "content_mismatch"), nullptr);
}

TEST(off_order, the_order_of_the_format_stays_where_neither_or_both_make_sense) {
  const auto expect_normals_first = [](std::initializer_list<const char*> rows) {
    const MeshFile file = read_sound("off", off("NCOFF", rows));
    EXPECT_TRUE(file.messages.empty()) << *rows.begin();
    EXPECT_GT(file.mesh.normals.pool[0].z, 0.9) << *rows.begin();
  };
  expect_normals_first({"0 0 1 0 1 0", "0 1 0 1 0 0", "1 0 0 0 0 1", "0 0 1 0 0 1"});
  expect_normals_first({"0 0 5 0 7 0", "0 1 0 1 0 0", "1 0 0 0 0 1", "0 0 1 0 0 1"});
  expect_normals_first({"0 0 0.98 0 0 1", "0 0 2 0.5 0 0", "0 0 2 0 0 1", "0 0 1 0 0 1"});
  expect_normals_first({"0 0 1", "0 1 0", "1 0 0", "0 0 -1"});
}

// Normals of other lengths beside colours that look like normals: what is written is read as it was.
TEST(off_order, what_is_written_is_not_taken_for_the_other_order) {
  for (const char* alpha : {"", " 1"}) {
    for (const char* colour : {"0 0 1", "1 0 0", "0.6 0 0.8"}) {
      const std::string numbers = std::string(colour) + alpha;
      const char* const row = numbers.c_str();
      MeshFile file = read_sound("off", off("COFF", {row, row, row, row}));
      file.mesh.normals.pool.assign(4, glm::dvec3(0.5, 0.25, 0));
      file.mesh.normals.index = file.mesh.corners;
      EXPECT_EQ(io_test::difference_after_round_trip(file, "off"), "") << colour << alpha;
    }
  }
}

TEST(off_order, binary_files_and_words_too) {
  const auto rows = {"255 0 0 255 0 0 -1", "0 255 0 255 1 0 0", "0 0 255 255 0 1 0", "9 9 9 255 0 0 1"};
  std::string words = off("NCOFF", rows);
  words.replace(words.find("0 0 0 255"), 9, "0 0 0\n255");
  const MeshFile file = read_sound("off", words);
  EXPECT_NE(find_message(file, "read_by_words"), nullptr);
  EXPECT_EQ(file.mesh.normals.pool[0], glm::dvec3(0, 0, -1));
  EXPECT_NE(find_message(file, "content_mismatch"), nullptr);
}

}  // namespace
}  // namespace ryosen
