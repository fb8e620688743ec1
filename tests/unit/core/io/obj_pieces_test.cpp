// A file read in pieces is the file read in one, whatever the cuts and the threads.

#include <random>

#include "ryosen/io/obj.h"
#include "tests/support/core/long_run.h"
#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

namespace fs = std::filesystem;

std::string described(const Message& message) {
  const auto number = [](const std::optional<std::uint64_t>& n) { return n ? std::to_string(*n) : "-"; };
  return std::string(message.code) + " " + number(message.line) + " " + number(message.column) + " " +
         number(message.byte) + " " + number(message.face) + " " + message.text.en + " " + message.text.ja + "\n";
}

std::string messages_of(const Result<MeshFile>& file) {
  if (!file) return described(file.failure().message);
  std::string out;
  for (const Message& message : file->messages) out += described(message);
  return out;
}

// What two readings of one file differ in.
std::string difference(const Result<MeshFile>& a, const Result<MeshFile>& b) {
  if (messages_of(a) != messages_of(b)) return "messages:\n" + messages_of(a) + "or\n" + messages_of(b);
  if (a.ok() != b.ok()) return "refusal";
  if (!a) return "";
  std::string out = io_test::difference(*a, *b);
  if (a->mesh.face_lines != b->mesh.face_lines) out += " lines";
  if (a->mesh.vertex_lines != b->mesh.vertex_lines) out += " vertex lines";
  for (std::size_t i = 0; i < std::min(a->mesh.quarantine.size(), b->mesh.quarantine.size()); ++i)
    if (a->mesh.quarantine[i].line != b->mesh.quarantine[i].line) out += " line in quarantine";
  for (std::size_t i = 0; i < std::min(a->elements.items.size(), b->elements.items.size()); ++i)
    if (a->elements.items[i].line != b->elements.items[i].line) out += " line of element";
  return out;
}

void expect_same_in_pieces(std::string_view text) {
  const std::string_view whole[] = {text};
  const Result<MeshFile> expected = read_obj_pieces(whole, "folder/model.obj", 1);
  for (const std::size_t piece_bytes : {0u, 13u, 100u, 700u}) {
    const std::vector<std::string_view> cuts = cut_obj(text, piece_bytes);
    std::string joined;
    for (const std::string_view piece : cuts) joined += piece;
    ASSERT_EQ(joined, text);
    if (cuts.size() > 3000) continue;
    for (const unsigned threads : {1u, 2u, 5u})
      ASSERT_EQ(difference(expected, read_obj_pieces(cuts, "folder/model.obj", threads)), "")
          << text.substr(0, 2000) << "\nin pieces of " << piece_bytes << " on " << threads;
  }
}

TEST(obj_pieces, cuts_only_where_a_line_ends) {
  using Pieces = std::vector<std::string_view>;
  EXPECT_EQ(cut_obj("", 0), Pieces{""});
  EXPECT_EQ(cut_obj("a", 0), Pieces{"a"});
  EXPECT_EQ(cut_obj("a\nb\r\nc", 0), (Pieces{"a\n", "b\r\n", "c"}));
  EXPECT_EQ(cut_obj("a\n\n\nb\n", 0), (Pieces{"a\n", "\n", "\n", "b\n"}));
  EXPECT_EQ(cut_obj("a\nb\nc\nd\n", 2), (Pieces{"a\nb\n", "c\nd\n"}));
  EXPECT_EQ(cut_obj("a\\\nb\nc", 0), (Pieces{"a\\\nb\n", "c"})) << "a line that goes on";
  EXPECT_EQ(cut_obj("a\\\r\nb\nc", 0), (Pieces{"a\\\r\nb\n", "c"}));
  EXPECT_EQ(cut_obj("f\\ \t\nb\nc", 0), (Pieces{"f\\ \t\nb\n", "c"}));
  EXPECT_EQ(cut_obj("a\n\xef\xbb\xbf"
                    "b\nc",
                    0),
            (Pieces{"a\n\xef\xbb\xbf"
                    "b\n",
                    "c"}))
      << "no mark begins a piece";
  EXPECT_EQ(cut_obj("a\rb\rc", 0), Pieces{"a\rb\rc"});
  EXPECT_EQ(cut_obj("a\nb\n", 100), Pieces{"a\nb\n"});
}

TEST(obj_pieces, names_colours_and_values_come_together) {
  expect_same_in_pieces(
      "# head\n\n# more\nmtllib m.mtl\nv 0 0 0\nv 1 0 0\n# no head\nv 0 1 0\nv 0 0 1\nf 1 2 3\no a\n"
      "f 1 2 4\nusemtl red\ng x\nf 2 3 4\nf 1 3 4\nusemtl\nf 1 3 4\ns 1\nusemtl red\nf 1 2 3\ng y\n"
      "g x\ns off\nf 1 2 3\n");
  expect_same_in_pieces(
      "v 0 0 0\nv 1 0 0 0.5\nv 0 1 0 1 0 0\nv 0 0 1 1 0 0 0.5\nv 2 2 2\nf 1 2 3\nvt 0 1\nvt 1\n"
      "vn 0 0 1\nf 1/1 2/2 3/1\nf 1 2 4\nf 1//1 2//1 4//1\nf 2/2/1 3/1/1 4/1/1\nvt 1 2 3\nf 5 4 3\n");
}

TEST(obj_pieces, what_needs_the_lines_before_or_a_message_is_read_in_its_turn) {
  expect_same_in_pieces(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nvt 0 0\nf 1/-1 2/-1 3/-1\nvn 0 0 1\nf 1//-1 2//1 3//1\n"
      "l 1 2 3\nusemtl a\np 1 2\nl 1 9\nf 1 2 9\nf 0 1 2\nf 1 1 2\nf 1 2\nf 4294967296 1 2\nmtllib b.mtl\n"
      "what\nv nan 0 0\nv 1e999 0 0 0 0\nf 1/7 2/0 3\nbevel\nf 1 2 3\n");
  expect_same_in_pieces("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 1 x 0\nf 1 2 q\n");
  expect_same_in_pieces("v 0 0 0\nv 1 0\nv 0 1 0\n");
  expect_same_in_pieces("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl a\\b\\\nf 1 2 3\nf 3 2 1\n");
  expect_same_in_pieces(std::string_view("v 0 0 0\nv 1 0 \0\nv 0 1 q\n\0\n", 26));
  expect_same_in_pieces("one\ntwo\nthree\n");
  expect_same_in_pieces("\n# nothing\n\n# at all\n");
  std::string many = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 30; ++i) many += "f 1 2 " + std::to_string(i) + "\nv 0 nan 0\nword" + std::to_string(i) + " 1\n";
  expect_same_in_pieces(many);
}

std::string random_line(std::mt19937& random) {
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto number = [&] { return std::to_string(pick(2000) - 1000) + "." + std::to_string(pick(100)); };
  const int forms = pick(4) == 0 ? 16 : 11;  // from the twelfth on they are odd
  std::string line;
  switch (pick(forms)) {
    case 0:
    case 1:
    case 2:
      line = "v";
      for (int i = pick(6) ? 3 : 3 + pick(5); i > 0; --i) line += " " + number();
      break;
    case 3:
      line = "vt " + number() + (pick(2) ? " " + number() : "");
      break;
    case 4:
      line = "vn " + number() + " " + number() + " " + number();
      break;
    case 5:
    case 6:
    case 7: {
      line = "f";
      const int form = pick(4);
      for (int i = 3 + pick(3); i > 0; --i) {
        line += " " + std::to_string(1 + pick(12));
        if (form == 1 || form == 3) line += "/" + std::to_string(1 + pick(5));
        if (form == 2) line += "/";
        if (form >= 2) line += "/" + std::to_string(1 + pick(3));
      }
      break;
    }
    case 8:
      line = std::string(pick(2) ? "g" : "o") + " n" + std::to_string(pick(4));
      break;
    case 9:
      line = (pick(2) ? "usemtl m" : "s ") + std::to_string(pick(4));
      break;
    case 10:
      line = pick(2) ? "# a comment" : "  ";
      break;
    case 11:
      line = "f -1 -2 -" + std::to_string(1 + pick(9));
      break;
    case 12:
      line = "l 1 " + std::to_string(pick(9));
      break;
    case 13:
      line = "mtllib m" + std::to_string(pick(3)) + ".mtl";
      break;
    case 14:
      line = pick(20) ? "v inf 0 0" : "v a 0 0";
      break;
    default:
      line = pick(2) ? "unknown" : "f 1 \\\n 2 3";
  }
  constexpr const char* ends[] = {"\n", "\r\n", "\r", "\\\n", "\\ \t\n", "\\ \r\n"};
  return line + ends[pick(40) ? 0 : pick(6)];
}

TEST(obj_pieces, random_lines) {
  std::mt19937 random(7);
  for (int turn = 0; turn < (test::is_long_run() ? 400 : 150) && !HasFatalFailure(); ++turn) {
    std::string text;
    for (std::size_t lines = 1 + random() % 60; lines > 0; --lines) text += random_line(random);
    expect_same_in_pieces(text);
  }
}

TEST(obj_pieces, files_that_are_there) {
  const std::uintmax_t most_bytes = test::is_long_run() ? 200000 : 50000;
  std::size_t files = 0;
  for (const char* folder : {RYOSEN_SOURCE_DIR "/tests/data", RYOSEN_SOURCE_DIR "/tests/fuzz/corpus",
                             RYOSEN_SOURCE_DIR "/assets", RYOSEN_SHARED_DIR}) {
    if (!fs::exists(folder)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file() || entry.path().extension() != ".obj" || entry.file_size() > most_bytes) continue;
      SCOPED_TRACE(entry.path());
      expect_same_in_pieces(io_test::whole_file(entry.path()));
      ++files;
    }
  }
  EXPECT_GT(files, 20u);
}

}  // namespace
}  // namespace ryosen
