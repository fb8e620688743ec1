// A file that is refused for a value says at how many places there are such.
#include "ryosen/io/reporter.h"

#include "ryosen/io/obj.h"
#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

using io_test::read_refused;

TEST(faults, names_the_first_five_places_and_counts_the_others) {
  const auto said = [](std::initializer_list<std::uint64_t> lines) {
    Faults faults;
    for (const std::uint64_t line : lines)
      faults.add("unreadable_number", FilePlace::at_line(line, 3), [] { return Text{"It is bad.", "悪い。"}; });
    const Failure failure = faults.take();
    EXPECT_EQ(failure.message.line, *lines.begin());
    EXPECT_EQ(failure.message.column, 3u);
    return failure.message.text;
  };
  EXPECT_EQ(said({7}).en, "It is bad.");
  EXPECT_EQ(said({7, 7}).en, "It is bad.") << "a line counts once";
  EXPECT_EQ(said({7, 9}).en, "It is bad. 2 such places: lines 7 and 9.");
  EXPECT_EQ(said({7, 9, 12, 20, 31}).en, "It is bad. 5 such places: lines 7, 9, 12, 20 and 31.");
  EXPECT_EQ(said({7, 9, 12, 20, 31, 40, 41}).en, "It is bad. 7 such places: lines 7, 9, 12, 20, 31 and 2 more.");
  EXPECT_EQ(said({7, 9, 12, 20, 31, 40, 41}).ja,
            "悪い。同様の箇所は全部で 7 か所あります: 7、9、12、20、31 行目、ほか 2 か所。");
}

TEST(faults, other_faults_do_not_count_and_one_without_a_way_on_ends_all) {
  Faults faults;
  faults.add("short_face", FilePlace::at_line(2), [] { return Text{"A.", "あ。"}; });
  faults.add("missing_number", FilePlace::at_line(3), [] { return Text{"B.", "い。"}; });
  EXPECT_FALSE(faults.is_stopped());
  faults.stop(malformed("unexpected_end", {"C.", "う。"}));
  EXPECT_TRUE(faults.is_stopped());
  EXPECT_EQ(faults.take().message.text.en, "A.");
}

TEST(faults, every_format_counts_its_places) {
  struct Case {
    const char *format, *text, *code;
    std::uint64_t line;
    const char* places;
  };
  for (const Case& c : {
           Case{"obj", "v 0 0 0\nv 1 x 0\nv y z 0\nvt q\nvn 0 0 w\nf 1 2 k\nf 1 2 3\n", "unreadable_number", 2,
                "4 such places: lines 2, 3, 4 and 5."},
           Case{"obj", "v 0 0 0\nf 1 2 k\nf 1 2 3\nv x 0 0\nl 1 2/a\nf 1/2/3/4 1 2\n", "unreadable_index", 2,
                "3 such places: lines 2, 5 and 6."},
           Case{"obj", "v 0 0\nv 1 0 0\nvn 1\n", "missing_number", 1, "2 such places: lines 1 and 3."},
           Case{"off", "OFF\n3 2 0\n0 0 a\n1 0 0\nb c 0\n3 0 1 2\n3 0 1 2 red\n", "unreadable_number", 3,
                "3 such places: lines 3, 5 and 7."},
           Case{"off", "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n3 0 1 2\n3 2\n", "short_face", 6,
                "2 such places: lines 6 and 8."},
           Case{"off", "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n3 0 1 2\n-1\n", "negative_count", 6,
                "2 such places: lines 6 and 8."},
           Case{"txt", "3 2\n0 0 0\n1 0 a\n0 b 0\n1 2 3\n1 2 3\n", "unreadable_number", 3,
                "2 such places: lines 3 and 4."},
           Case{"txt", "3 3\n0 0 0\n1 0 0\n0 1 0\n1 2 3 4\n1 2 3\n1 2 3 4\n", "extra_values", 5,
                "2 such places: lines 5 and 7."},
           Case{"txt", "3 2\n0 0 0\n1 0 0\n0 1 0\n1 2 2.5\n1 x 3\n", "unreadable_index", 5,
                "2 such places: lines 5 and 6."},
           Case{"stl",
                "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 a\nvertex 1 b c\nvertex 0 1 0\nendloop\nendfacet\n"
                "facet normal 0 0 d\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
                "0\nendloop\nendfacet\nendsolid\n",
                "unreadable_number", 4, "3 such places: lines 4, 5 and 9."},
           Case{"ply",
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                "property uchar q\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
                "0 0 a 1\n1 0 0 1\n0 b 0 c\n3 0 1 2\n3 0 1 2\n",
                "unreadable_number", 11, "2 such places: lines 11 and 13."},
           Case{"ply",
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                "property uchar q\nelement face 3\nproperty list uchar int vertex_indices\nend_header\n"
                "0 0 0 300\n1 0 0 1\n0 1 0 -1\n3 0 1 2\n3 0 1\n3 0 1 x\n",
                "number_out_of_type", 11, "2 such places: lines 11 and 13."},
           Case{"ply",
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                "element face 3\nproperty list uchar int vertex_indices\nproperty list uchar float w\nend_header\n"
                "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 5\n3 0 1\n3 0 1 2 2 5\n",
                "short_face", 15, "2 such places: lines 15 and 16."},
       }) {
    const Failure failure = read_refused(c.format, c.text);
    EXPECT_EQ(failure.message.code, c.code) << c.text;
    EXPECT_EQ(failure.message.line, c.line) << c.text;
    EXPECT_TRUE(failure.message.text.en.ends_with(std::string(" ") + c.places)) << failure.message.text.en;
  }
}

TEST(faults, rows_that_are_too_short_to_have_room_are_counted_all_the_same) {
  constexpr std::size_t rows = 30000;
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(rows) +
                     "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (std::size_t i = 0; i < rows; ++i) text += "0\n";
  const Failure failure = read_refused("ply", text);
  EXPECT_EQ(failure.message.code, "missing_number");
  EXPECT_NE(failure.message.text.en.find("30000 such places: lines 8, 9, 10, 11, 12 and 29995 more."),
            std::string::npos)
      << failure.message.text.en;
}

TEST(faults, bytes_that_no_text_has_are_counted_as_bytes) {
  const std::string text("v 0 0 0\n\0v\0\0\n", 13);
  for (const char* format : {"obj", "txt"}) {
    const Failure failure = read_refused(format, text);
    EXPECT_EQ(failure.message.code, "nul_byte");
    EXPECT_EQ(failure.message.byte, 8u);
    EXPECT_TRUE(failure.message.text.en.ends_with(" 3 such places: bytes 8, 10 and 11.")) << failure.message.text.en;
  }
}

TEST(faults, pieces_of_a_file_count_as_the_whole) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += i % 40 == 7 ? "v 0 x 0\n" : i % 50 == 9 ? "f 1 -1 2\ng a\n" : "v 0 0 1\n";
  const Failure whole = read_refused("obj", text);
  EXPECT_TRUE(whole.message.text.en.ends_with("8 such places: lines 8, 49, 90, 131, 172 and 3 more."))
      << whole.message.text.en;
  for (const std::size_t piece : {1u, 50u, 333u}) {
    const Result<MeshFile> file = read_obj_pieces(cut_obj(text, piece), {}, 2);
    ASSERT_FALSE(file.ok());
    EXPECT_EQ(file.failure().message.text.en, whole.message.text.en) << piece;
    EXPECT_EQ(file.failure().message.line, whole.message.line);
  }
}

TEST(faults, a_large_file_of_nothing_else_is_counted_quickly) {
  const auto start = std::chrono::steady_clock::now();
  std::string text = "v x 0 0\n";
  constexpr std::size_t doublings = 18;
  for (std::size_t i = 0; i < doublings; ++i) text += text;
  const Failure failure = read_refused("obj", text);
  EXPECT_TRUE(failure.message.text.en.find(" 262144 such places: lines 1, 2, 3, 4, 5 and 262139 more.") !=
              std::string::npos)
      << failure.message.text.en;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

}  // namespace
}  // namespace ryosen
