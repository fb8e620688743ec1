#include <algorithm>
#include <bit>
#include <cstring>

#include "ryosen/base/column_memory.h"
#include "ryosen/base/parallel.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/io/face_list.h"
#include "ryosen/io/losses.h"
#include "ryosen/io/reporter.h"
#include "ryosen/io/stl.h"
#include "ryosen/io/stl_facets.h"
#include "ryosen/io/stl_text.h"
#include "ryosen/io/text_lines.h"

namespace ryosen {
namespace {

constexpr std::size_t facets_begin = stl_head_bytes + 4;

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
    if (count > no_index / 3) return too_many_corners(FilePlace::at_byte(stl_head_bytes));
    keep_head();
    read_facets(static_cast<std::uint32_t>(count));
    warn_of_the_end(claimed, whole, room);
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
    const std::string_view whole = bytes_.substr(0, stl_head_bytes);
    if (whole != stl_head(file_)) file_.stl_head = whole;
    file_.encoding = Encoding::binary_little;
  }

  void read_facets(std::uint32_t count) {
    IndexedMesh& mesh = file_.mesh;
    const StlFacets facets(bytes_.data() + facets_begin, count);
    const StlFacetFindings found = weld_facets(facets, threads_for(facets.corners()), mesh.positions, mesh.corners);
    reserve_large(mesh.face_offsets, std::size_t{count} + 1);
    mesh.face_offsets.resize(std::size_t{count} + 1);
    for (std::uint32_t facet = 0; facet < count; ++facet) mesh.face_offsets[facet + 1] = 3 * (facet + 1);
    if (!found.all_finite) warn_non_finite(facets);
    if (found.has_attributes) keep_attributes(facets);
  }

  void warn_non_finite(const StlFacets& facets) {
    const auto has_place = [&](std::uint32_t c) { return is_finite(glm::dvec3(facets.place(c))); };
    for (std::uint32_t facet = 0; facet < facets.count(); ++facet) {
      if (has_place(3 * facet) && has_place(3 * facet + 1) && has_place(3 * facet + 2)) continue;
      reporter_.warn("nonfinite_number", FilePlace::at_face(facet), [] {
        return Text{"A coordinate of the facet is not finite.", "面の座標に有限でない数があります。"};
      });
    }
  }

  void keep_attributes(const StlFacets& facets) {
    const std::uint32_t count = facets.count();
    Property property;
    property.name = facet_attribute;
    property.type = NumberType::u16;
    property.data.resize(2 * std::size_t{count});
    for (std::uint32_t facet = 0; facet < count; ++facet) {
      const std::uint16_t attribute = facets.attribute(facet);
      std::memcpy(property.data.data() + 2 * std::size_t{facet}, &attribute, sizeof attribute);
    }
    PropertyTable& table = file_.properties.tables.emplace_back();
    table.name = "face";
    table.kind = TableKind::faces;
    table.rows = count;
    table.properties.push_back(std::move(property));
  }

  void warn_of_the_end(std::size_t claimed, std::size_t whole, std::size_t room) {
    const std::size_t count = std::min(claimed, whole), end = facets_begin + count * stl_facet_bytes;
    if (claimed > whole) {
      // If the size is a whole number of facets the count is wrong, else the last facet is truncated.
      const FilePlace place = FilePlace::at_byte(room % stl_facet_bytes == 0 ? stl_head_bytes : end);
      reporter_.warn("unexpected_end", place, [&] {
        const std::string there = std::to_string(whole), all = std::to_string(claimed);
        return Text{"The file has " + there + " of the " + all + " facets that its head counts.",
                    "ヘッダーの面 " + all + " 個のうち " + there + " 個しかありません。"};
      });
    } else if (end != bytes_.size()) {
      reporter_.leave_out(&LeftOut::rest, bytes_.size() - end);
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
};

bool begins_with_solid(std::string_view bytes) {
  std::string_view rest = bytes.substr(0, sniffed_bytes);
  if (rest.starts_with(byte_order_mark)) rest.remove_prefix(byte_order_mark.size());
  const std::size_t begin = rest.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && is_stl_word(rest.substr(begin, 5), "solid");
}

}  // namespace

bool is_whole_binary_stl(std::string_view head, std::uint64_t size) {
  if (head.size() < facets_begin) return false;
  return size ==
         facets_begin + std::uint64_t{stl_facet_bytes} * load_little<std::uint32_t>(head.data() + stl_head_bytes);
}

bool may_be_ascii_stl(std::string_view head) { return head.find('\0') == std::string_view::npos; }

Likeness looks_like_stl(std::string_view head, std::uint64_t size) {
  if (is_whole_binary_stl(head, size)) return Likeness::sure;
  if (!may_be_ascii_stl(head)) return size >= stl_head_bytes + 4 ? Likeness::maybe : Likeness::no;
  TextLines lines(head, false);
  TextLine line;
  bool has_solid = false;
  while (lines.next(line)) {
    std::string_view rest = line.text;
    const std::string_view word = take_word(rest);
    if (word.empty()) continue;
    if (has_solid) return is_stl_word(word, "facet") || is_stl_word(word, "endsolid") ? Likeness::sure : Likeness::no;
    if (!is_stl_word(word, "solid")) return Likeness::no;
    has_solid = true;
  }
  return has_solid ? Likeness::maybe : Likeness::no;
}

MeshFile finish_stl(MeshFile& file, FaceList& faces, Reporter& reporter) {
  const std::size_t corners = file.mesh.corners.size(), points = file.mesh.positions.size();
  faces.finish(reporter);
  file.left_out = reporter.left_out();
  file.messages = reporter.take();
  const std::string from = std::to_string(corners), to = std::to_string(points);
  file.messages.push_back(make_message(
      Severity::info, "welded",
      {from + " corners at " + to + " places were welded.", from + " 個の頂点を " + to + " 個の位置にまとめました。"}));
  return std::move(file);
}

Result<MeshFile> read_stl(std::string_view bytes, const std::filesystem::path&) {
  const bool is_text = may_be_ascii_stl(bytes.substr(0, sniffed_bytes));
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
