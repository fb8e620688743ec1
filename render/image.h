// Images: in memory, as PNG files, and their comparison.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "render/colour.h"
#include "ryosen/base/result.h"
#include "ryosen/scene/view/size.h"

namespace ryosen {

// An RGBA image, rows top-down, without padding.
struct Image {
  Size size;
  std::vector<Rgba> pixels;

  Image() = default;
  explicit Image(Size s, Rgba fill = {0, 0, 0, 255})
      : size(s), pixels(static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height), fill) {}

  Rgba& at(int x, int y) { return pixels[index(x, y)]; }
  const Rgba& at(int x, int y) const { return pixels[index(x, y)]; }
  friend bool operator==(const Image&, const Image&) = default;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
  }
};

// The bytes of a PNG file: 8 bits per channel, with alpha only if some pixel is not opaque. Deterministic.
std::vector<std::uint8_t> encode_png(const Image& image);

// Writes a PNG file atomically: to a temporary file beside it, flushed to disk, then renamed. Fails with
// ExitCode::output_not_writable.
Status write_png(const Image& image, const std::filesystem::path& path);

// Reads a PNG file of any kind as 8-bit RGBA; at most 16384 pixels a side.
// Fails with ExitCode::input_missing or ExitCode::input_malformed.
Result<Image> read_png(const std::filesystem::path& path);

// The difference of two images of the same size.
struct ImageDifference {
  std::uint64_t pixels = 0;  // with any channel differing by more than 8/255
  double share = 0;          // `pixels` as a fraction of all, 0 to 1
  int largest = 0;           // largest difference of any channel, 0 to 255
  Image picture;             // the second image in pale grey, differing pixels in magenta
};

// Fails with ExitCode::found_problems if the sizes differ.
Result<ImageDifference> compare(const Image& reference, const Image& image);

}  // namespace ryosen
