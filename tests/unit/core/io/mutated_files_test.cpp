// Small damage at random places of good files: whatever comes of it is refused with a sentence, or read so that writing
// and reading again gives the same.
#include <random>

#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

constexpr std::string_view pieces[] = {"v ",
                                       "vt ",
                                       "vn ",
                                       "f ",
                                       "l ",
                                       "p ",
                                       "s ",
                                       "g ",
                                       "usemtl ",
                                       "\n",
                                       "\r",
                                       "\\\n",
                                       "/",
                                       "//",
                                       "nan",
                                       "1e999",
                                       "1.#IND",
                                       "4294967296",
                                       "-1",
                                       "0",
                                       "OFF",
                                       "COFF",
                                       "#",
                                       " -9 ",
                                       "3 ",
                                       "\t",
                                       "-9223372036854775808",
                                       "9999999999",
                                       "element ",
                                       "property ",
                                       "list ",
                                       "uchar ",
                                       "double ",
                                       "comment ",
                                       "end_header\n",
                                       "\xff\xff\xff\xff"};

std::string mutated(std::string text, std::mt19937& random) {
  const std::size_t changes = 1 + random() % 4;
  for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = random() % text.size(), length = random() % 20;
    switch (random() % 5) {
      case 0:
        text[at] = static_cast<char>(random());
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, pieces[random() % std::size(pieces)]);
        break;
      case 3:
        text.insert(at, text.substr(random() % text.size(), length));
        break;
      default:
        text.resize(at);
    }
  }
  return text;
}

TEST(mutated_files, are_refused_or_read_the_same_twice) {
  std::mt19937 random(20240607);
  std::size_t refused = 0, read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RYOSEN_SOURCE_DIR "/tests/data/io")) {
    const Format& format = *format_of_extension(entry.path());
    const std::string good = io_test::whole_file(entry.path());
    for (int i = 0; i < 1500; ++i) {
      const std::string text = mutated(good, random);
      const Result<MeshFile> file = read_mesh(text, format);
      if (!file) {
        ++refused;
        ASSERT_FALSE(file.failure().message.text.en.empty()) << text;
        ASSERT_FALSE(file.failure().message.text.ja.empty()) << text;
        continue;
      }
      ++read;
      const std::string written = bytes_of(*file, format);
      if (written == "# no vertices\n") continue;
      ASSERT_EQ(io_test::difference_after_round_trip(*file, format.id), "") << text << "\n---\n" << written;
    }
  }
  EXPECT_GT(refused, 100u);
  EXPECT_GT(read, 100u);
}

}  // namespace
}  // namespace ryosen
