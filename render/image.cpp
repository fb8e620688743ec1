#include "render/image.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace ryosen {
namespace {

constexpr int tolerance = 8;  // of 255; channels that differ by at most this count as equal

std::string words(Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

}  // namespace

Result<ImageDifference> compare(const Image& reference, const Image& image) {
  if (reference.size != image.size) {
    return make_failure(
        ExitCode::found_problems, "image_sizes_differ",
        {"The pictures have different sizes: " + words(reference.size) + " and " + words(image.size) + ".",
         "画像の大きさが異なります: " + words(reference.size) + " と " + words(image.size) + "。"});
  }
  ImageDifference difference;
  difference.picture = Image(image.size);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Rgba& a = reference.pixels[i];
    const Rgba& b = image.pixels[i];
    int apart = 0;
    for (std::size_t c = 0; c < 4; ++c) apart = std::max(apart, std::abs(int(a[c]) - int(b[c])));
    difference.largest = std::max(difference.largest, apart);
    if (apart > tolerance) {
      ++difference.pixels;
      difference.picture.pixels[i] = {255, 0, 255, 255};
    } else {
      const int grey = 160 + (int(b[0]) + int(b[1]) + int(b[2])) / 9;
      const auto level = static_cast<std::uint8_t>(grey);
      difference.picture.pixels[i] = {level, level, level, 255};
    }
  }
  if (!image.pixels.empty()) difference.share = double(difference.pixels) / double(image.pixels.size());
  return difference;
}

}  // namespace ryosen
