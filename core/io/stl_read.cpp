#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/io/face_list.h"
#include "core/io/losses.h"
#include "core/io/reporter.h"
#include "core/io/sniff.h"
#include "core/io/stl.h"
#include "core/io/stl_text.h"
#include "core/io/welder.h"

namespace ryosen {
namespace {

constexpr std::size_t facets_begin = stl_head_bytes + 4;

template <class Number>
Number load_little(const char* at) {
  unsigned char bytes[sizeof(Number)];
  std::memcpy(bytes, at, sizeof bytes);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes, bytes + sizeof bytes);
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

class StlBinaryReader {
 public:
  explicit StlBinaryReader(std::string_view bytes) : bytes_(bytes), faces_(file_.mesh) {}

  Result<MeshFile> read() {
    const std::size_t claimed = load_little<std::uint32_t>(bytes_.data() + stl_head_bytes);
    const std::size_t room = bytes_.size() - facets_begin, whole = room / stl_facet_bytes;
    const std::size_t count = std::min(claimed, whole);
    if (claimed / 4 > whole) {
      return malformed("count_too_large",
                       {"The head counts " + std::to_string(claimed) + " facets; the file has room for " +
                            std::to_string(whole) + ".",
                        "ヘッダーの面の個数 " + std::to_string(claimed) + " に対し、ファイルには " +
                            std::to_string(whole) + " 個分の大きさしかありません。"},
                       FilePlace::at_byte(stl_head_bytes));
    }
    keep_head();
    read_facets(count);
    warn_of_the_end(claimed, whole, room);
    keep_attributes(count);
    return finish_stl(file_, faces_, reporter_);
  }

 private:
  void keep_head() {
    std::string_view head = bytes_.substr(0, stl_head_bytes);
    while (!head.empty() && (head.back() == '\0' || head.back() == ' ')) head.remove_suffix(1);
    const auto is_text = [](char c) {
      return c == '\t' || (c >= ' ' && c != 0x7f) || static_cast<unsigned char>(c) > 0x7f;
    };
    if (!head.empty() && head != stl_plain_head && std::all_of(head.begin(), head.end(), is_text))
      file_.head_comments.emplace_back(head);
    file_.encoding = Encoding::binary_little;
  }

  void read_facets(std::size_t count) {
    IndexedMesh& mesh = file_.mesh;
    mesh.corners.resize(3 * count);
    mesh.face_offsets.resize(count + 1);
    Welder<float> welder(mesh.positions, 3 * count);
    constexpr std::size_t block = 256;
    glm::vec3 places[3 * block];
    for (std::size_t first = 0; first < count; first += block) {
      const std::size_t n = std::min(block, count - first);
      float nothing = 0;  // stays zero while all are finite
      for (std::size_t i = 0; i < n; ++i) {
        const char* const facet = bytes_.data() + facets_begin + (first + i) * stl_facet_bytes;
        for (std::size_t k = 0; k < 9; ++k) {
          const auto value = load_little<float>(facet + 12 + 4 * k);
          nothing += value * 0.0f;
          places[3 * i + k / 3][static_cast<int>(k % 3)] = value;
        }
        if (const auto attribute = load_little<std::uint16_t>(facet + 48)) note_attribute(first + i, attribute);
        mesh.face_offsets[first + i + 1] = static_cast<std::uint32_t>(3 * (first + i + 1));
      }
      if (!(nothing == 0.0f)) warn_non_finite(places, first, n);
      welder.number(places, 3 * n, mesh.corners.data() + 3 * first);
    }
  }

  void warn_non_finite(const glm::vec3* places, std::size_t first, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto is_finite = [](const glm::vec3& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
      };
      if (std::all_of(places + 3 * i, places + 3 * i + 3, is_finite)) continue;
      reporter_.warn("nonfinite_number", FilePlace::at_face(first + i), [] {
        return Text{"A coordinate of the facet is not finite.", "面の座標に有限でない数があります。"};
      });
    }
  }

  void note_attribute(std::size_t facet, std::uint16_t attribute) {
    attributes_.resize(facet + 1, 0);
    attributes_[facet] = attribute;
  }

  void keep_attributes(std::size_t count) {
    if (attributes_.empty()) return;
    attributes_.resize(count, 0);
    Property property;
    property.name = facet_attribute;
    property.type = NumberType::u16;
    property.data.resize(2 * count);
    std::memcpy(property.data.data(), attributes_.data(), 2 * count);
    PropertyTable& table = file_.properties.tables.emplace_back();
    table.name = "face";
    table.kind = TableKind::faces;
    table.rows = count;
    table.properties.push_back(std::move(property));
  }

  void warn_of_the_end(std::size_t claimed, std::size_t whole, std::size_t room) {
    const std::size_t count = std::min(claimed, whole), end = facets_begin + count * stl_facet_bytes;
    if (claimed > whole) {
      // Without a rest it is the count that is wrong, else the last facet is cut.
      const FilePlace place = FilePlace::at_byte(room % stl_facet_bytes == 0 ? stl_head_bytes : end);
      reporter_.warn("unexpected_end", place, [&] {
        const std::string there = std::to_string(whole), all = std::to_string(claimed);
        return Text{"The file has " + there + " of the " + all + " facets that its head counts.",
                    "ヘッダーの面 " + all + " 個のうち " + there + " 個しかありません。"};
      });
    } else if (end != bytes_.size()) {
      reporter_.warn("extra_data", FilePlace::at_byte(end), [&] {
        const std::string rest = std::to_string(bytes_.size() - end);
        return Text{rest + " bytes after the last facet are left out.",
                    "最後の面の後の " + rest + " バイトを無視しました。"};
      });
    }
    if (claimed == 0) {
      reporter_.warn("no_faces", FilePlace::at_byte(stl_head_bytes), [] {
        return Text{"The file has no facets.", "ファイルに面がありません。"};
      });
    }
  }

  std::string_view bytes_;
  MeshFile file_;
  FaceList faces_;
  Reporter reporter_;
  std::vector<std::uint16_t> attributes_;  // up to the last facet that has one
};

bool begins_with_solid(std::string_view bytes) {
  std::string_view rest = bytes.substr(0, sniffed_bytes);
  const std::size_t begin = rest.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && is_stl_word(rest.substr(begin, 5), "solid");
}

}  // namespace

bool is_whole_binary_stl(std::string_view head, std::uint64_t size) {
  if (head.size() < facets_begin) return false;
  return size ==
         facets_begin + std::uint64_t{stl_facet_bytes} * load_little<std::uint32_t>(head.data() + stl_head_bytes);
}

MeshFile finish_stl(MeshFile& file, FaceList& faces, Reporter& reporter) {
  const std::size_t corners = file.mesh.corners.size(), points = file.mesh.positions.size();
  faces.finish(reporter);
  file.messages = reporter.take();
  const std::string from = std::to_string(corners), to = std::to_string(points);
  file.messages.push_back(make_message(
      Severity::info, "welded",
      {from + " corners at " + to + " places were welded.", from + " 個の頂点を " + to + " 個の位置にまとめました。"}));
  return std::move(file);
}

Result<MeshFile> read_stl(std::string_view bytes, const std::filesystem::path&) {
  const bool is_text = !refuse_binary(bytes.substr(0, sniffed_bytes));
  if (!is_whole_binary_stl(bytes, bytes.size())) {
    if (begins_with_solid(bytes) && is_text) return read_stl_text(bytes);
    if (bytes.size() >= facets_begin && is_text) {
      return malformed("not_stl",
                       {"The content is a text that does not begin with the word solid; it is not STL.",
                        "solid という語で始まらないテキストです。STL ではありません。"},
                       FilePlace::at_byte(0));
    }
    if (bytes.size() < facets_begin) {
      return malformed("unexpected_end",
                       {"The file ends before the count of facets, and it is no ascii STL.",
                        "面の個数より前でファイルが終わっています。テキストの STL でもありません。"},
                       FilePlace::at_byte(std::min(bytes.size(), stl_head_bytes)));
    }
  }
  return StlBinaryReader(bytes).read();
}

}  // namespace ryosen
