#include "ryosen/io/off_binary.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

namespace ryosen {
namespace {

struct Layout {
  bool is_big_endian;
  bool has_face_colours;
};

// First the specification, then what programs write.
constexpr Layout layouts[] = {{true, true}, {false, false}, {false, true}, {true, false}};

// Reads 32-bit words from a byte range.
class Words {
 public:
  Words(std::string_view bytes, bool is_big_endian) : bytes_(bytes), is_big_endian_(is_big_endian) {}

  std::size_t left() const { return bytes_.size() / 4; }
  std::size_t left_bytes() const { return bytes_.size(); }
  void skip(std::size_t words) { bytes_.remove_prefix(4 * words); }
  // Precondition: left() > 0.
  std::uint32_t take() {
    unsigned char b[4];
    std::memcpy(b, bytes_.data(), 4);
    skip(1);
    std::uint32_t word = 0;
    for (int i = 0; i < 4; ++i) word = word << 8 | b[is_big_endian_ ? i : 3 - i];
    return word;
  }
  double take_real() { return static_cast<double>(std::bit_cast<float>(take())); }

 private:
  std::string_view bytes_;
  bool is_big_endian_;
};

struct Counts {
  std::uint32_t vertices = 0, faces = 0;
};

std::size_t words_per_vertex(OffKind kind) {
  return 3u + (kind.has_normals ? 3u : 0u) + (kind.has_colours ? 4u : 0u) + (kind.has_texcoords ? 2u : 0u);
}

// The counts, if the file is large enough for them.
std::optional<Counts> plausible_counts(Words& words, OffKind kind) {
  if (words.left() < 3) return std::nullopt;
  Counts counts;
  counts.vertices = words.take();
  counts.faces = words.take();
  words.skip(1);  // the number of edges, unused
  if (counts.vertices > words.left() / words_per_vertex(kind)) return std::nullopt;
  if (counts.faces > words.left() - counts.vertices * words_per_vertex(kind)) return std::nullopt;
  return counts;
}

// The number of bytes left over if all faces fit in the file and reference existing vertices, else none.
std::optional<std::size_t> bytes_over(std::string_view data, OffKind kind, Layout layout) {
  Words words(data, layout.is_big_endian);
  const std::optional<Counts> counts = plausible_counts(words, kind);
  if (!counts) return std::nullopt;
  words.skip(counts->vertices * words_per_vertex(kind));
  for (std::uint32_t f = 0; f < counts->faces; ++f) {
    if (words.left() == 0) return std::nullopt;
    const std::uint32_t corners = words.take();
    if (corners > words.left()) return std::nullopt;
    for (std::uint32_t i = 0; i < corners; ++i) {
      if (words.take() >= counts->vertices) return std::nullopt;
    }
    if (!layout.has_face_colours) continue;
    if (words.left() == 0) return std::nullopt;
    const std::uint32_t colours = words.take();
    if (colours > 4 || colours > words.left()) return std::nullopt;
    words.skip(colours);
  }
  return words.left_bytes();
}

MeshFile read_as(std::string_view bytes, std::uint64_t start, OffKind kind, Layout layout) {
  const std::string_view data = bytes.substr(start);
  Words words(data, layout.is_big_endian);
  const Counts counts = *plausible_counts(words, kind);
  OffBuilder builder(kind);
  builder.reserve(counts.vertices, counts.faces);
  const auto here = [&] { return static_cast<std::uint64_t>(bytes.size() - words.left_bytes()); };
  double values[12];
  for (std::uint32_t v = 0; v < counts.vertices; ++v) {
    const std::uint64_t byte = here();
    bool is_finite = true;
    for (std::size_t i = 0; i < words_per_vertex(kind); ++i) {
      values[i] = words.take_real();
      is_finite = is_finite && std::isfinite(values[i]);
    }
    if (!is_finite) warn_of_non_finite_vertex(builder.reporter(), FilePlace::at_byte(byte));
    builder.add_vertex(values, words_per_vertex(kind));
  }
  for (std::uint32_t f = 0; f < counts.faces; ++f) {
    const std::uint32_t corners = words.take();
    for (std::uint32_t i = 0; i < corners; ++i) builder.add_corner(words.take());
    const std::uint32_t colours = layout.has_face_colours ? words.take() : 0;
    for (std::uint32_t i = 0; i < colours; ++i) values[i] = words.take_real();
    if (!builder.end_face(0, values, colours, false)) {
      builder.reporter().leave_out(&LeftOut::values);
      builder.reporter().warn("extra_values", FilePlace::at_byte(here()), [] {
        return Text{"The colour of a face has two numbers, which has no meaning.",
                    "面の色の数が 2 個で意味を持ちません。"};
      });
    }
  }
  if (words.left_bytes() != 0) {
    builder.reporter().leave_out(&LeftOut::rest, words.left_bytes());
    builder.reporter().warn("extra_data", FilePlace::at_byte(here()), [&] {
      const std::string count = std::to_string(words.left_bytes());
      return Text{count + " bytes after the last face are left out.",
                  "最後の面の後の " + count + " バイトを無視しました。"};
    });
  }
  return builder.finish();
}

}  // namespace

Result<MeshFile> read_off_binary(std::string_view bytes, std::uint64_t start, OffKind kind) {
  const std::string_view data = bytes.substr(start);
  std::optional<std::size_t> least;
  Layout best{};
  for (const Layout layout : layouts) {
    const std::optional<std::size_t> over = bytes_over(data, kind, layout);
    if (!over || (least && *over >= *least)) continue;
    least = over;
    best = layout;
  }
  if (least) return read_as(bytes, start, kind, best);
  return malformed("count_too_large",
                   {"The file is shorter than its binary counts claim, or its indices make no sense.",
                    "バイナリーの個数に対してファイルが短すぎるか、番号が不正です。"},
                   FilePlace::at_byte(start));
}

}  // namespace ryosen
