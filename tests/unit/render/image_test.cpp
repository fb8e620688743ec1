#include "render/image.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

namespace ryosen {
namespace {

class TemporaryFolder {
 public:
  TemporaryFolder() : path_(std::filesystem::temp_directory_path() / ("ryosen_image_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  std::filesystem::path operator/(const char* name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

Image random_image(Size size, bool opaque) {
  std::mt19937 random(7);
  Image image(size);
  for (Rgba& pixel : image.pixels) {
    for (std::size_t c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>(random());
    if (!opaque) pixel[3] = static_cast<std::uint8_t>(random());
  }
  return image;
}

TEST(image, png_gives_back_what_was_written) {
  const TemporaryFolder folder;
  for (const bool opaque : {true, false}) {
    for (const Size size : {Size{1, 1}, Size{3, 2}, Size{2, 5}, Size{61, 47}}) {
      const Image image = random_image(size, opaque);
      ASSERT_TRUE(write_png(image, folder / "a.png").ok());
      Result<Image> read = read_png(folder / "a.png");
      ASSERT_TRUE(read.ok());
      EXPECT_EQ(*read, image) << size.width << "x" << size.height;
    }
  }
}

TEST(image, png_bytes_are_equal_for_equal_images) {
  const Image image = random_image({64, 64}, true);
  EXPECT_EQ(encode_png(image), encode_png(image));
}

TEST(image, flat_picture_is_small) { EXPECT_LT(encode_png(Image({1280, 720}, {10, 20, 30, 255})).size(), 40000u); }

TEST(image, failures_carry_their_exit_codes) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_png(folder / "none.png").failure().exit_code, ExitCode::input_missing);
  std::ofstream(folder / "text.png") << "no picture";
  EXPECT_EQ(read_png(folder / "text.png").failure().exit_code, ExitCode::input_malformed);
  EXPECT_EQ(write_png(Image({1, 1}), folder / "no_folder/a.png").failure().exit_code, ExitCode::output_not_writable);
}

TEST(image, png_cut_short_is_malformed) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> bytes = encode_png(random_image({40, 40}, true));
  bytes.resize(bytes.size() / 2);
  std::ofstream(folder / "cut.png", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  EXPECT_EQ(read_png(folder / "cut.png").failure().exit_code, ExitCode::input_malformed);
}

TEST(image, writing_replaces_whole_and_leaves_nothing_beside) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_png(Image({2, 2}), folder / "a.png").ok());
  ASSERT_TRUE(write_png(Image({5, 1}), folder / "a.png").ok());
  EXPECT_EQ(read_png(folder / "a.png").value().size, (Size{5, 1}));
  int files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++files;
  EXPECT_EQ(files, 1);
}

TEST(image, comparison_counts_pixels_beyond_the_tolerance) {
  const Image grey({10, 10}, {100, 100, 100, 255});
  Image other = grey;
  other.at(3, 4) = {108, 100, 100, 255};
  other.at(5, 6) = {100, 91, 100, 255};
  other.at(9, 9) = {100, 100, 100, 0};
  const Result<ImageDifference> difference = compare(grey, other);
  ASSERT_TRUE(difference.ok());
  EXPECT_EQ(difference->pixels, 2u);
  EXPECT_DOUBLE_EQ(difference->share, 0.02);
  EXPECT_EQ(difference->largest, 255);
  EXPECT_EQ(difference->picture.at(5, 6), (Rgba{255, 0, 255, 255}));
  EXPECT_NE(difference->picture.at(3, 4), (Rgba{255, 0, 255, 255}));
}

TEST(image, comparison_of_different_sizes_fails) {
  const Result<ImageDifference> difference = compare(Image({2, 3}), Image({3, 2}));
  ASSERT_FALSE(difference.ok());
  EXPECT_EQ(difference.failure().exit_code, ExitCode::found_problems);
}

}  // namespace
}  // namespace ryosen
