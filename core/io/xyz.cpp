#include "core/io/xyz.h"

#include "core/geometry/is_finite.h"
#include "core/io/faults.h"
#include "core/io/numbers.h"
#include "core/io/text_lines.h"

namespace ryosen {
namespace {

// Every step returns false where the line has a fault.
class XyzReader {
 public:
  explicit XyzReader(std::string_view bytes) : lines_(bytes, false) {}

  Result<MeshFile> read() {
    TextLine line;
    while (lines_.next(line)) {
      rest_ = line.text.substr(0, line.text.find('#'));
      if (is_blank(rest_)) continue;
      glm::dvec3 p;
      if (!read_point(p) || faults_.any()) continue;
      if (!is_finite(p)) warn_of_non_finite_vertex(reporter_, FilePlace::at_line(lines_.count()));
      file_.mesh.positions.push_back(p);
      file_.mesh.vertex_lines.add(lines_.count());
    }
    if (faults_.any()) return faults_.take();
    file_.left_out = reporter_.left_out();
    file_.messages = reporter_.take();
    return std::move(file_);
  }

 private:
  bool read_point(glm::dvec3& p) {
    for (int i = 0; i < 3; ++i)
      if (!take_number(rest_, p[i]) && !read_unusual(p[i])) return false;
    if (!is_blank(rest_)) warn_of_extra_values(reporter_, lines_.place(rest_.data()));
    return true;
  }

  bool read_unusual(double& value) {
    const std::string_view word = take_word(rest_);
    if (word.empty())
      return faults_.add("missing_number", lines_.place(word.data()), [] {
        return Text{"The line has fewer than the three numbers of a point.", "この行には点の座標 3 個が必要です。"};
      });
    if (read_real(word, value) != NumberRead::unreadable) return true;
    return faults_.add("unreadable_number", lines_.place(word.data()), [&] { return not_a_number(word); });
  }

  TextLines lines_;
  std::string_view rest_;
  MeshFile file_;
  Reporter reporter_;
  Faults faults_;
};

}  // namespace

Result<MeshFile> read_xyz(std::string_view bytes, const std::filesystem::path&) {
  if (std::optional<Failure> refusal = refuse_nul_bytes(bytes)) return std::move(*refusal);
  return XyzReader(bytes).read();
}

Likeness looks_like_xyz(std::string_view head, std::uint64_t size) {
  if (head.size() < size) head = head.substr(0, head.rfind('\n') + 1);  // the last line may be cut
  TextLines lines(head, false);
  TextLine line;
  bool has_point = false;
  while (lines.next(line)) {
    std::string_view rest = line.text.substr(0, line.text.find('#'));
    std::size_t words = 0;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest), ++words) {
      double value = 0;
      if (words < 3 && read_real(word, value) == NumberRead::unreadable) return Likeness::no;
    }
    if (words > 0 && words < 3) return Likeness::no;
    has_point = has_point || words > 0;
  }
  return has_point ? Likeness::maybe : Likeness::no;
}

}  // namespace ryosen
