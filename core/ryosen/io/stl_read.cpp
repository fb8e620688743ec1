#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>

#include "ryosen/base/column_memory.h"
#include "ryosen/base/parallel.h"
#include "ryosen/base/result.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/io/face_list.h"
#include "ryosen/io/losses.h"
#include "ryosen/io/mesh_file.h"
#include "ryosen/io/numbers.h"
#include "ryosen/io/reporter.h"
#include "ryosen/io/stl.h"
#include "ryosen/io/stl_facets.h"
#include "ryosen/io/text_lines.h"
#include "ryosen/mesh/attribute.h"

namespace ryosen {
namespace {

// Quarantines the unusable faces, reports the welding and returns the file.
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

void warn_of_non_finite_facet(Reporter& reporter, FilePlace place) {
  reporter.warn("nonfinite_number", place, [] {
    return Text{"A coordinate of the facet is not finite.", "面の座標に有限でない数があります。"};
  });
}

// Whether `token` is this keyword, case-insensitively. `word` is in lower case.
bool is_stl_word(std::string_view token, std::string_view word) {
  return std::equal(token.begin(), token.end(), word.begin(), word.end(),
                    [](char a, char b) { return lower_case(a) == b; });
}

// Words in any layout; only the name of a solid goes to the end of its line. Every step returns false where nothing
// more can be read.
class StlTextReader {
 public:
  explicit StlTextReader(std::string_view bytes)
      : lines_(bytes, false), faces_(file_.mesh), welder_(file_.mesh.positions, bytes.size() / 30) {}

  Result<MeshFile> read() {
    file_.encoding = Encoding::ascii;
    while (next_word() && !is_stopped_)
      if (!read_solid()) break;
    if (faults_.any()) return faults_.take();
    end_groups();
    if (file_.mesh.face_count() == 0)
      reporter_.warn("no_faces", {}, [] { return Text{"The file has no facets.", "ファイルに面がありません。"}; });
    return finish_stl(file_, faces_, reporter_);
  }

 private:
  bool fail(Code code, Text text, FilePlace place) { return faults_.stop(malformed(code, std::move(text), place)); }
  FilePlace here() const { return lines_.place(word_.data()); }

  // Advances to the next word, across line ends.
  bool next_word() {
    TextLine line;
    word_ = take_word(rest_);
    while (word_.empty()) {
      if (!lines_.next(line)) return false;
      rest_ = line.text;
      word_ = take_word(rest_);
    }
    return true;
  }

  bool ends_early(const char* where_en, const char* where_ja) {
    return fail("unexpected_end",
                {std::string("The file ends within ") + where_en + ".",
                 std::string("ファイルが") + where_ja + "の途中で終わっています。"},
                FilePlace::at_line(lines_.count() + 1));
  }

  bool unexpected(std::string_view wanted) {
    return fail("unknown_keyword",
                {shown(word_) + " stands where " + std::string(wanted) + " is meant.",
                 std::string(wanted) + " があるべき所に " + shown(word_) + " があります。"},
                here());
  }

  // Requires this word next, inside a facet.
  bool expect(std::string_view word) {
    if (!next_word()) return ends_early("a facet", "面");
    return is_stl_word(word_, word) || unexpected(word);
  }

  // If the file is a single line, the name ends where the first facet starts.
  static std::size_t end_of_name(std::string_view line) {
    for (std::string_view rest = line; !rest.empty();) {
      std::string_view after = rest;
      const std::string_view word = take_word(after);
      if (is_stl_word(word, "facet") && begins_facet(after)) return static_cast<std::size_t>(word.data() - line.data());
      rest = after;
    }
    return line.size();
  }
  static bool begins_facet(std::string_view after) {
    if (!is_stl_word(take_word(after), "normal")) return false;
    for (int i = 0; i < 3; ++i)
      if (double ignored = 0; read_real(take_word(after), ignored) == NumberRead::unreadable) return false;
    return is_stl_word(take_word(after), "outer") && is_stl_word(take_word(after), "loop");
  }

  bool read_solid() {
    if (!is_stl_word(word_, "solid")) {
      if (solids_.empty()) return unexpected("solid");
      reporter_.leave_out(&LeftOut::rest);
      reporter_.warn("extra_data", here(), [] {
        return Text{"What follows the last solid is left out.", "最後の solid より後の内容を無視しました。"};
      });
      is_stopped_ = true;
      return true;
    }
    const std::size_t name_end = end_of_name(rest_);
    if (!faults_.any()) solids_.emplace_back(trimmed(rest_.substr(0, name_end)));
    rest_.remove_prefix(name_end);
    while (next_word()) {
      if (is_stl_word(word_, "endsolid")) {
        rest_ = {};
        return true;
      }
      if (!is_stl_word(word_, "facet")) return unexpected("facet");
      if (!read_facet()) return false;
    }
    reporter_.warn("missing_endsolid", FilePlace::at_line(lines_.count() + 1), [] {
      return Text{"The last solid has no endsolid.", "最後の solid に endsolid がありません。"};
    });
    return true;
  }

  bool read_number(double& value) {
    if (!next_word()) return ends_early("a facet", "面");
    switch (read_real(word_, value)) {
      case NumberRead::finite:
        return true;
      case NumberRead::non_finite:
        is_finite_ = false;
        return true;
      default:
        faults_.add("unreadable_number", here(), [&] { return not_a_number(word_); });
        return true;
    }
  }

  bool read_facet() {
    const std::uint64_t line = lines_.count();
    double normal = 0;
    if (!expect("normal")) return false;
    for (int i = 0; i < 3; ++i)
      if (!read_number(normal)) return false;
    if (!expect("outer") || !expect("loop")) return false;
    std::size_t corners = 0;
    while (true) {
      if (!next_word()) return ends_early("a facet", "面");
      if (is_stl_word(word_, "endloop")) break;
      if (!is_stl_word(word_, "vertex")) return unexpected("vertex");
      if (!read_vertex()) return false;
      ++corners;
    }
    if (!expect("endfacet")) return false;
    if (faults_.any()) return true;
    faces_.end_face(line);
    file_.mesh.groups.index.push_back(static_cast<std::uint32_t>(solids_.size() - 1));
    if (corners == 3) return true;
    file_.has_free_facets = true;
    if (corners < 3) return true;  // quarantined, with a message
    reporter_.warn("facet_many_corners", FilePlace::at_line(line), [&] {
      const std::string count = std::to_string(corners);
      return Text{"The facet has " + count + " corners; it is kept as one face.",
                  "面の頂点が " + count + " 個あります。1 つの面として保持します。"};
    });
    return true;
  }

  bool read_vertex() {
    const std::uint64_t line = lines_.count();
    is_finite_ = true;
    glm::dvec3 place;
    for (int i = 0; i < 3; ++i)
      if (!read_number(place[i])) return false;
    if (faults_.any()) return true;
    if (!is_finite_) warn_of_non_finite_facet(reporter_, FilePlace::at_line(line));
    faces_.add_corner(welder_.number(place));
    return true;
  }

  // Solids become groups if they have a name or there are several.
  void end_groups() {
    FaceNames& groups = file_.mesh.groups;
    if (solids_.size() == 1 && solids_[0].empty())
      groups = {};
    else
      groups.names = std::move(solids_);
  }

  TextLines lines_;
  MeshFile file_;
  FaceList faces_;
  Reporter reporter_;
  Welder welder_;
  Faults faults_;
  std::string_view rest_, word_;
  std::vector<std::string> solids_;
  bool is_finite_ = true;
  bool is_stopped_ = false;
};

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
      warn_of_non_finite_facet(reporter_, FilePlace::at_face(facet));
    }
  }

  void keep_attributes(const StlFacets& facets) {
    const std::uint32_t count = facets.count();
    AttributeColumn column = make_column(facet_attribute, ElementKind::face, ValueRule::first, std::uint16_t{0});
    column.data.reserve(count);
    for (std::uint32_t facet = 0; facet < count; ++facet)
      column.data.push_back(attribute_words(facets.attribute(facet))[0]);
    file_.mesh.attributes.push_back(std::move(column));
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

Result<MeshFile> read_stl(std::string_view bytes, const std::filesystem::path&) {
  const bool is_text = may_be_ascii_stl(bytes.substr(0, sniffed_bytes));
  if (!is_whole_binary_stl(bytes, bytes.size())) {
    if (begins_with_solid(bytes) && is_text) return StlTextReader(bytes).read();
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
