#include "core/algo/repair/remove_faces.h"

#include <algorithm>

#include "core/algo/repair/delete_soundly.h"
#include "core/analysis/equal_faces.h"
#include "core/base/count_text.h"
#include "core/base/sort_unique.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/mesh/rings.h"
#include "core/ops/rules/sheets.h"

namespace ryosen {

namespace {

using PointList = std::vector<std::uint32_t>;

// Canonical form, independent of start and direction: the lexicographically smallest list, which begins with the smallest
// point. Only at bridges does a loop come to a point again.
PointList normal_form(PointList loop) {
  PointList best;
  const std::uint32_t smallest = *std::min_element(loop.begin(), loop.end());
  for (int way = 0; way < 2; ++way) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop[i] != smallest) continue;
      PointList turned(loop.begin() + static_cast<std::ptrdiff_t>(i), loop.end());
      turned.insert(turned.end(), loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(i));
      if (best.empty() || turned < best) best = std::move(turned);
    }
    std::reverse(loop.begin(), loop.end());
  }
  return best;
}

// The canonical loops of a face, concatenated with a separator.
PointList shape_of(const Mesh& m, Face f) {
  std::vector<PointList> loops;
  for_each_loop(m, f, [&](Halfedge start) {
    PointList loop_points;
    for (Halfedge h : loop(m, start)) loop_points.push_back(point(m, m.from(h)).index);
    loops.push_back(normal_form(std::move(loop_points)));
  });
  std::sort(loops.begin(), loops.end());
  PointList shape;
  for (const PointList& one : loops) {
    shape.insert(shape.end(), one.begin(), one.end());
    shape.push_back(no_index);
  }
  return shape;
}

struct FaceOnPoints {
  PointList points;  // ascending
  Face face;
};

// Faces that share their set of points with another.
std::vector<FaceOnPoints> faces_with_equals(const Mesh& m, const std::vector<std::uint32_t>& duplicates) {
  std::vector<FaceOnPoints> found;
  std::vector<Vertex> at;
  const auto points_of = [&](Face f) {
    PointList points;
    for (Vertex v : vertices_around(m, f)) points.push_back(point(m, v).index);
    std::sort(points.begin(), points.end());
    return points;
  };
  std::vector<Face> faces;
  for (std::uint32_t i : duplicates)
    for (Vertex v : vertices_around(m, Face(i))) at.push_back(point(m, v));
  sort_unique(at);
  for (Vertex p : at)
    for_each_copy(m, p, [&](Vertex copy) {
      for (Face f : faces_around(m, copy))
        if (f) faces.push_back(f);
    });
  sort_unique(faces);
  for (Face f : faces) found.push_back({points_of(f), f});
  std::sort(found.begin(), found.end(), [](const FaceOnPoints& a, const FaceOnPoints& b) {
    return a.points != b.points ? a.points < b.points : a.face < b.face;
  });
  return found;
}

}  // namespace

AlgorithmResult remove_duplicate_faces(Edit& edit, const AlgorithmInput&, Progress&) {
  const Mesh& m = edit.mesh();
  Neighbourhood around(m, Neighbourhood::Reach::whole);
  const std::vector<FaceOnPoints> faces = faces_with_equals(m, find_duplicate_faces(around));
  std::vector<Face> doomed;
  std::vector<Element> of_other_loops;
  AlgorithmResult result;
  for (std::size_t first = 0, last = 0; first < faces.size(); first = last) {
    std::vector<PointList> kept;
    for (last = first; last < faces.size() && faces[last].points == faces[first].points; ++last) {
      if (last == first && (last + 1 == faces.size() || faces[last + 1].points != faces[first].points)) continue;
      PointList shape = shape_of(m, faces[last].face);
      if (std::find(kept.begin(), kept.end(), shape) != kept.end())
        doomed.push_back(faces[last].face);
      else if (kept.push_back(std::move(shape)); kept.size() > 1)
        of_other_loops.emplace_back(faces[last].face);
    }
  }
  result.changed = delete_soundly(edit, doomed);
  std::erase_if(doomed, [&](Face f) { return !m.is_alive(f); });
  result.left = of_other_loops.size() + doomed.size();
  add_left(result.left_for, {"it visits the same points in another order", "同じ点を別の順に通るため"},
           std::move(of_other_loops));
  add_left(result.left_for,
           {"without it two triangles would lie back to back", "なくすと三角形が背中合わせに重なるため"},
           {doomed.begin(), doomed.end()});
  result.text = count_text(result.changed, "One duplicate face was removed.", "# duplicate faces were removed.",
                           "重複面を # 個削除しました。");
  return result;
}

AlgorithmResult remove_isolated_vertices(Edit& edit, const AlgorithmInput& input, Progress&) {
  const Mesh& m = edit.mesh();
  Sheets sheets(edit);
  AlgorithmResult result;
  std::vector<Element> used;
  for (std::uint32_t i = m.vertex_slots(); i-- > 0;) {
    const Vertex v(i);
    if (!m.is_alive(v) || !m.is_isolated(v)) continue;
    const bool is_alone = !has_copies(m, v);
    if (is_alone && std::binary_search(input.used_elsewhere.begin(), input.used_elsewhere.end(), v)) {
      used.emplace_back(v);
      continue;
    }
    result.changed += is_alone;
    sheets.remove_vertex(v);
  }
  result.left = used.size();
  add_left(result.left_for,
           {"a face set aside, a line or a point of the file uses it", "隔離された面・線・点が使っているため"},
           std::move(used));
  result.text = count_text(result.changed, "One isolated vertex was removed.", "# isolated vertices were removed.",
                           "孤立頂点を # 個削除しました。");
  if (result.left > 0) {
    const std::string left = std::to_string(result.left);
    result.text.en += result.left == 1 ? " One stays: a face set aside, a line or a point of the file uses it."
                                       : " " + left + " stay: faces set aside, lines or points of the file use them.";
    result.text.ja += "隔離された面・線・点が使う " + left + " 個は残しました。";
  }
  return result;
}

}  // namespace ryosen
