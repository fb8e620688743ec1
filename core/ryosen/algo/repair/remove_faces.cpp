#include "ryosen/algo/repair/remove_faces.h"

#include <algorithm>
#include <utility>

#include "ryosen/algo/repair/delete_soundly.h"
#include "ryosen/algo/repair/detach_nonmanifold.h"
#include "ryosen/algo/repair/equal_loops.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

namespace {

// Where closed parts would be torn once the faces are gone they are taken apart first.
std::size_t remove_redundant(Edit& edit, const EqualLoops& equal) {
  if (equal.redundant.empty()) return 0;
  const Mesh& m = edit.mesh();
  Mesh trial = m;
  Edit on_trial(trial, nullptr);
  delete_soundly(on_trial, equal.highest, true);
  if (keeps_closed(equal, pair_faces(trial))) return delete_soundly(edit, equal.highest, true);
  std::vector<Vertex> points;
  for (const Face f : equal.redundant)
    for (const Vertex v : vertices_around(m, f)) points.push_back(point(m, v));
  sort_unique(points);
  detach_points(edit, std::move(points));
  return delete_soundly(edit, equal.redundant, true);
}

}  // namespace

AlgorithmResult remove_duplicate_faces(Edit& edit, const AlgorithmInput&, Progress&) {
  const Mesh& m = edit.mesh();
  AlgorithmResult result;
  EqualLoops equal = find_equal_loops(m);
  while (!equal.redundant.empty()) {
    result.changed += remove_redundant(edit, equal);
    equal = find_equal_loops(m);
  }
  const auto leave = [&](const std::vector<Face>& faces, Text reason) {
    result.left += faces.size();
    add_left(result.left_for, std::move(reason), {faces.begin(), faces.end()});
  };
  leave(equal.of_other_loops, {"it visits the same points in another order", "同じ点を別の順に通るため"});
  leave(equal.of_solids,
        {"it bounds a closed part, as the face on its points does", "同じ点の面とともに閉じた部分の壁であるため"});
  leave(equal.holding, {"without it an edge would open", "なくすと稜線が開くため"});
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
