#include "render/image.h"

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include "ryosen/base/parallel.h"
#include "ryosen/io/safe_write.h"
#include "ryosen/io/system_reason.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_MAX_DIMENSIONS 16384
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace ryosen {

namespace {

constexpr int tolerance = 8;  // of 255; channels that differ by at most this count as equal

std::string words(Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

using Bytes = std::vector<std::uint8_t>;

void append_big_endian(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void append_chunk(Bytes& bytes, const char* kind, const Bytes& content) {
  append_big_endian(bytes, static_cast<std::uint32_t>(content.size()));
  const std::size_t start = bytes.size();
  bytes.insert(bytes.end(), kind, kind + 4);
  bytes.insert(bytes.end(), content.begin(), content.end());
  const uLong checksum = crc32(0, bytes.data() + start, static_cast<uInt>(bytes.size() - start));
  append_big_endian(bytes, static_cast<std::uint32_t>(checksum));
}

// Rows [first, last) with PNG filter type Up: a filter byte, then each byte minus the one above. It gives runs of zeros
// in flat and vertically uniform areas, of which pictures of meshes mostly consist.
Bytes filtered_rows(const Image& image, std::size_t channels, int first, int last) {
  const auto width = static_cast<std::size_t>(image.size.width);
  Bytes rows((width * channels + 1) * static_cast<std::size_t>(last - first));
  std::uint8_t* out = rows.data();
  const Rgba nothing{};
  for (int y = first; y < last; ++y) {
    constexpr std::uint8_t filter_up = 2;
    *out++ = filter_up;
    const Rgba* row = &image.at(0, y);
    for (std::size_t x = 0; x < width; ++x) {
      const Rgba& above = y > 0 ? (row - width)[x] : nothing;
      for (std::size_t c = 0; c < channels; ++c) *out++ = static_cast<std::uint8_t>(row[x][c] - above[c]);
    }
  }
  return rows;
}

struct Piece {
  Bytes deflated;
  uLong checksum = 0;
  std::size_t length = 0;
};

// A part of a deflate stream that does not refer to earlier parts.
Piece deflate_piece(const Bytes& rows, bool is_last) {
  Piece piece;
  piece.length = rows.size();
  piece.checksum = adler32(adler32(0, nullptr, 0), rows.data(), static_cast<uInt>(rows.size()));
  z_stream stream{};
  constexpr int raw_window = -15;
  deflateInit2(&stream, 1, Z_DEFLATED, raw_window, 9, Z_DEFAULT_STRATEGY);
  piece.deflated.resize(deflateBound(&stream, static_cast<uLong>(rows.size())) + 16);
  stream.next_in = const_cast<Bytef*>(rows.data());
  stream.avail_in = static_cast<uInt>(rows.size());
  stream.next_out = piece.deflated.data();
  stream.avail_out = static_cast<uInt>(piece.deflated.size());
  deflate(&stream, is_last ? Z_FINISH : Z_SYNC_FLUSH);
  piece.deflated.resize(stream.total_out);
  deflateEnd(&stream);
  return piece;
}

// The zlib stream of the filtered rows. The split into pieces is fixed, so the bytes do not depend on the number of
// threads.
Bytes compressed_rows(const Image& image, std::size_t channels) {
  constexpr unsigned piece_count = 4, threads = 2;
  Piece pieces[piece_count];
  for_each_task(piece_count, threads, [&](unsigned i) {
    const auto height = static_cast<std::uint32_t>(image.size.height);
    const auto first = static_cast<int>(part_begin(height, i, piece_count));
    const auto last = static_cast<int>(part_begin(height, i + 1, piece_count));
    pieces[i] = deflate_piece(filtered_rows(image, channels, first, last), i + 1 == piece_count);
  });
  Bytes stream{0x78, 0x01};
  uLong checksum = adler32(0, nullptr, 0);
  for (const Piece& piece : pieces) {
    stream.insert(stream.end(), piece.deflated.begin(), piece.deflated.end());
    checksum = adler32_combine(checksum, piece.checksum, static_cast<z_off_t>(piece.length));
  }
  append_big_endian(stream, static_cast<std::uint32_t>(checksum));
  return stream;
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
  const bool opaque = std::all_of(image.pixels.begin(), image.pixels.end(), [](const Rgba& p) { return p[3] == 255; });
  Bytes bytes{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  Bytes header;
  append_big_endian(header, static_cast<std::uint32_t>(image.size.width));
  append_big_endian(header, static_cast<std::uint32_t>(image.size.height));
  constexpr std::uint8_t bits_per_channel = 8, rgb = 2, rgb_alpha = 6;
  const std::uint8_t rest[] = {bits_per_channel, opaque ? rgb : rgb_alpha, 0, 0, 0};
  header.insert(header.end(), std::begin(rest), std::end(rest));
  append_chunk(bytes, "IHDR", header);
  append_chunk(bytes, "sRGB", {0});
  append_chunk(bytes, "IDAT", compressed_rows(image, opaque ? 3 : 4));
  append_chunk(bytes, "IEND", {});
  return bytes;
}

Status write_png(const Image& image, const std::filesystem::path& path) {
  const Bytes bytes = encode_png(image);
  return safe_write(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Result<Image> read_png(const std::filesystem::path& path) {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) {
    const Text cause = system_reason(errno);
    return make_failure(ExitCode::input_missing, "input_missing",
                        {"The picture " + path.string() + " cannot be read: " + cause.en + ".",
                         "画像 " + path.string() + " を読み込めません：" + cause.ja + "。"});
  }
  Size size;
  std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_file(file.get(), &size.width, &size.height, nullptr, 4), stbi_image_free);
  if (!pixels) {
    return make_failure(ExitCode::input_malformed, "png_malformed",
                        {"The file " + path.string() + " is not a PNG picture that can be read.",
                         "ファイル " + path.string() + " は読み込める PNG 画像ではありません。"});
  }
  Image image(size);
  std::memcpy(image.pixels.data(), pixels.get(), image.pixels.size() * sizeof(Rgba));
  return image;
}

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
