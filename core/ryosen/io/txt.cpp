#include "ryosen/io/txt.h"

#include <algorithm>
#include <array>
#include <optional>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/io/face_list.h"
#include "ryosen/io/numbers.h"
#include "ryosen/io/reporter.h"
#include "ryosen/io/text_lines.h"
#include "ryosen/io/text_out.h"
#include "ryosen/io/triangulated.h"

namespace ryosen {
namespace {

// Detects lists that count vertices from 0: several faces reference the vertex before the first (-1 here, since corners
// are stored from 0), and none the last.
class ZeroBase {
 public:
  explicit ZeroBase(std::size_t vertices) : last_(static_cast<std::int64_t>(vertices) - 1) {}

  // Returns whether the face references vertex -1.
  template <class Corners>
  bool add_face(const Corners& corners) {
    bool has_zero = false;
    for (const std::int64_t corner : corners) {
      has_zero = has_zero || corner == -1;
      is_within_ = is_within_ && corner >= -1 && corner < last_;
    }
    zero_faces_ += has_zero;
    return has_zero;
  }
  // For a list of `faces` faces. A single such face among others is more likely damaged.
  bool is_shown(std::size_t faces) const { return is_within_ && (zero_faces_ > 1 || (zero_faces_ == 1 && faces == 1)); }

 private:
  std::int64_t last_;
  std::size_t zero_faces_ = 0;
  bool is_within_ = true;  // no vertex exceeds the range of a list from 0
};

// Every step returns false where nothing more can be read; what reads a line, where that has a fault.
class TxtReader {
 public:
  explicit TxtReader(std::string_view bytes) : bytes_(bytes), lines_(bytes, false), faces_(file_.mesh) {}

  Result<MeshFile> read() {
    if (!read_counts() || !read_vertices() || !read_faces() || faults_.any()) return faults_.take();
    warn_of_lines_left(lines_, reporter_, {"face", "面"}, [this] { return next_line(); });
    faces_.finish(reporter_);
    return finished(file_, reporter_);
  }

 private:
  bool fail(Code code, Text text, FilePlace place) { return faults_.stop(malformed(code, std::move(text), place)); }

  bool next_line() { return lines_.next_filled(rest_); }

  bool ends_early(std::size_t there, std::size_t claimed, bool are_faces) {
    const std::string found = std::to_string(there), all = std::to_string(claimed);
    return fail("unexpected_end",
                {"The file ends too early: it has " + found + " of " + all + (are_faces ? " faces." : " vertices."),
                 "ファイルが途中で終わっています: " + std::string(are_faces ? "面 " : "頂点 ") + all + " 個のうち " +
                     found + " 個しかありません。"},
                FilePlace::at_line(lines_.count() + 1));
  }

  bool too_few(int wanted) {
    return faults_.add("missing_number", lines_.place(rest_.data()), [&] {
      return Text{"The line has fewer than the " + std::to_string(wanted) + " numbers that are needed.",
                  "この行には " + std::to_string(wanted) + " 個の数が必要です。"};
    });
  }

  bool end_line(int wanted) {
    const std::string_view word = take_word(rest_);
    if (word.empty()) return true;
    return faults_.add("extra_values", lines_.place(word.data()), [&] {
      return Text{"The line has more than the " + std::to_string(wanted) + " numbers that have a meaning.",
                  "この行には意味のある " + std::to_string(wanted) + " 個より多くの数があります。"};
    });
  }

  bool read_whole(int wanted, std::int64_t& value) {
    const std::string_view word = take_word(rest_);
    if (word.empty()) return too_few(wanted);
    if (read_integer(word, value)) return true;
    return faults_.add("unreadable_index", lines_.place(word.data()), [&] { return not_a_whole_number(word); });
  }

  bool read_count(std::size_t& count) {
    std::int64_t value = 0;
    if (!read_whole(2, value)) return false;
    if (value < 0)
      return fail("negative_count", {"A count is negative.", "個数が負です。"}, FilePlace::at_line(lines_.count()));
    // The shortest line has three numbers of one digit.
    constexpr std::size_t least_bytes = 6;
    if (static_cast<std::uint64_t>(value) / 4 > bytes_.size() / least_bytes || value >= std::int64_t{no_index}) {
      return fail("count_too_large",
                  {"The count " + std::to_string(value) + " is more than a file of this size can hold.",
                   "個数 " + std::to_string(value) + " は、このファイルの大きさに収まりません。"},
                  FilePlace::at_line(lines_.count()));
    }
    count = static_cast<std::size_t>(value);
    return true;
  }

  bool read_counts() {
    next_line();
    return read_count(vertices_) && read_count(face_count_) && end_line(2);
  }

  bool read_vertices() {
    for (std::size_t v = 0; v < vertices_; ++v) {
      if (!next_line()) return ends_early(v, vertices_, false);
      glm::dvec3 p;
      if (!read_vertex(p) || faults_.any()) continue;
      if (!is_finite(p)) warn_of_non_finite_vertex(reporter_, FilePlace::at_line(lines_.count()));
      file_.mesh.positions.push_back(p);
      file_.mesh.vertex_lines.add(lines_.count());
    }
    return true;
  }

  bool read_vertex(glm::dvec3& p) {
    for (int i = 0; i < 3; ++i)
      if (!take_number(rest_, p[i]) && !read_unusual(p[i])) return false;
    return end_line(3);
  }

  bool read_unusual(double& value) {
    const std::string_view word = take_word(rest_);
    if (word.empty()) return too_few(3);
    if (read_real(word, value) != NumberRead::unreadable) return true;
    return faults_.add("unreadable_number", lines_.place(word.data()), [&] { return not_a_number(word); });
  }

  bool read_faces() {
    ZeroBase zero_base(vertices_);
    std::uint64_t first_zero_line = 0;
    for (std::size_t f = 0; f < face_count_; ++f) {
      if (!next_line()) return ends_early(f, face_count_, true);
      if (faces_.is_full(3)) return faults_.stop(too_many_corners(FilePlace::at_line(lines_.count())));
      std::array<std::int64_t, 3> corners{};
      if (!read_corners(corners) || faults_.any()) continue;
      for (const std::int64_t corner : corners) faces_.add_corner(corner);
      if (zero_base.add_face(corners) && first_zero_line == 0) first_zero_line = lines_.count();
      faces_.end_face(lines_.count());
    }
    if (faults_.any() || !zero_base.is_shown(face_count_)) return true;
    return fail("zero_based",
                {"The faces name vertex 0 and never the last one: they count from 0, and this format counts from 1. "
                 "Add 1 to every vertex.",
                 "面が頂点 0 を参照し、最後の頂点を参照していません。番号が 0 から始まっているようです。この形式では 1 "
                 "から数えるので、すべての番号に 1 を加えてください。"},
                FilePlace::at_line(first_zero_line));
  }

  bool read_corners(std::array<std::int64_t, 3>& corners) {
    for (std::int64_t& corner : corners) {
      if (!take_number(rest_, corner) && !read_whole(3, corner)) return false;
      if (corner != INT64_MIN && corner != INT64_MAX) --corner;  // unless saturated
    }
    return end_line(3);
  }

  std::string_view bytes_;
  TextLines lines_;
  MeshFile file_;
  FaceList faces_;
  Reporter reporter_;
  Faults faults_;
  std::string_view rest_;
  std::size_t vertices_ = 0, face_count_ = 0;
};

}  // namespace

Result<MeshFile> read_txt(std::string_view bytes, const std::filesystem::path&) {
  if (std::optional<Failure> refusal = refuse_nul_bytes(bytes)) return std::move(*refusal);
  return TxtReader(bytes).read();
}

Likeness looks_like_txt(std::string_view head, std::uint64_t) {
  TextLines lines(head, false);
  TextLine line;
  bool has_counts = false;
  while (lines.next(line)) {
    std::string_view rest = line.text;
    std::size_t words = 0;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest), ++words) {
      std::int64_t count = 0;
      double value = 0;
      if (has_counts ? read_real(word, value) == NumberRead::unreadable : !read_integer(word, count))
        return Likeness::no;
    }
    if (words == 0) continue;
    if (has_counts) return words == 3 ? Likeness::sure : Likeness::no;
    if (words != 2) return Likeness::no;
    has_counts = true;
  }
  return has_counts ? Likeness::maybe : Likeness::no;
}

TxtQuarantine::TxtQuarantine(const IndexedMesh& mesh) {
  ZeroBase zero_base(mesh.positions.size());
  std::size_t triangles = mesh.face_count() - mesh.quarantine.size();
  for (const QuarantinedFace& face : mesh.quarantine) {
    if (face.corners.size() != 3) continue;
    ++triangles;
    zero_base.add_face(face.corners);
  }
  if (!zero_base.is_shown(triangles)) return;
  zero_base.add_face(mesh.corners);  // all usable faces; none of them references vertex -1
  looks_zero_based_ = zero_base.is_shown(triangles);
}

bool TxtQuarantine::holds(const QuarantinedFace& face) const {
  if (face.corners.size() != 3) return false;
  return !looks_zero_based_ || std::count(face.corners.begin(), face.corners.end(), -1) == 0;
}

std::string write_txt(const MeshFile& file) {
  if (has_polygons(file.mesh)) return write_txt(triangulated(file));
  const IndexedMesh& mesh = file.mesh;
  const TxtQuarantine quarantine(mesh);
  const auto is_written = [&](const QuarantinedFace& face) { return quarantine.holds(face); };
  const auto left_out = mesh.quarantine.size() - static_cast<std::size_t>(std::count_if(
                                                     mesh.quarantine.begin(), mesh.quarantine.end(), is_written));
  TextOut out(40 * mesh.positions.size() + 24 * mesh.face_count());
  out << mesh.positions.size() << ' ' << mesh.face_count() - left_out << '\n';
  for (const glm::dvec3& p : mesh.positions) out << p.x << ' ' << p.y << ' ' << p.z << '\n';
  const auto write_face = [&](const auto& corners) {
    for (int i = 0; i < 3; ++i) {
      const auto corner = static_cast<std::int64_t>(corners[static_cast<std::size_t>(i)]);
      out << (corner == INT64_MAX ? corner : corner + 1) << (i < 2 ? ' ' : '\n');
    }
  };
  for_each_face(
      mesh, [&](std::size_t, std::span<const std::uint32_t> corners) { write_face(corners); },
      [&](const QuarantinedFace& aside) {
        if (is_written(aside)) write_face(aside.corners);
      });
  return out.take();
}

}  // namespace ryosen
