#include "ryosen/io/stl_text.h"

#include <cmath>
#include <cstring>

#include "ryosen/io/faults.h"
#include "ryosen/io/numbers.h"
#include "ryosen/io/stl_facets.h"
#include "ryosen/io/text_lines.h"

namespace ryosen {
namespace {

// Words in any layout; only the name of a solid goes to the end of its line. Every step returns false where nothing
// more can be read.
class StlTextReader {
 public:
  explicit StlTextReader(std::string_view bytes)
      : lines_(bytes, false), faces_(file_.mesh), welder_(file_.mesh.positions, bytes.size() / 30) {}

  Result<MeshFile> read() {
    file_.encoding = Encoding::ascii;
    while (next_word() && !is_stopped_) {
      if (!read_solid()) break;
    }
    if (faults_.any()) return faults_.take();
    end_groups();
    if (file_.mesh.face_count() == 0) {
      reporter_.warn("no_faces", {}, [] { return Text{"The file has no facets.", "ファイルに面がありません。"}; });
    }
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
    for (int i = 0; i < 3; ++i) {
      if (!read_number(normal)) return false;
    }
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
    for (int i = 0; i < 3; ++i) {
      if (!read_number(place[i])) return false;
    }
    if (faults_.any()) return true;
    if (!is_finite_) {
      reporter_.warn("nonfinite_number", FilePlace::at_line(line), [] {
        return Text{"A coordinate of the facet is not finite.", "面の座標に有限でない数があります。"};
      });
    }
    faces_.add_corner(welder_.number(place));
    return true;
  }

  // Solids become groups if they have a name or there are several.
  void end_groups() {
    FaceNames& groups = file_.mesh.groups;
    if (solids_.size() == 1 && solids_[0].empty()) {
      groups = {};
    } else {
      groups.names = std::move(solids_);
    }
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

}  // namespace

bool is_stl_word(std::string_view token, std::string_view word) {
  if (token.size() != word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const char c = token[i] >= 'A' && token[i] <= 'Z' ? static_cast<char>(token[i] - 'A' + 'a') : token[i];
    if (c != word[i]) return false;
  }
  return true;
}

Result<MeshFile> read_stl_text(std::string_view bytes) { return StlTextReader(bytes).read(); }

}  // namespace ryosen
