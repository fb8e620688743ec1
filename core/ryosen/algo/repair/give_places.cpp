#include "ryosen/algo/repair/give_places.h"

#include <algorithm>
#include <optional>

#include "ryosen/algo/repair/sound_changes.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/faces_at.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/delete.h"

namespace ryosen {

namespace {

bool has_place(const Mesh& m, Vertex v) { return is_finite(m.position(v)); }

std::vector<Vertex> points_without_place(const Mesh& m) {
  std::vector<Vertex> found;
  for (const Vertex v : live_vertices(m))
    if (point(m, v) == v && !has_place(m, v)) found.push_back(v);
  return found;
}

// The points that edges join to one, ascending.
std::vector<Vertex> points_around(const Mesh& m, Vertex of) {
  std::vector<Vertex> around;
  for_each_copy(m, of, [&](Vertex copy) {
    if (m.is_isolated(copy)) return;
    for (const Vertex other : neighbours(m, copy)) around.push_back(point(m, other));
  });
  sort_unique(around);
  return around;
}

// On the way no sum is larger than the places.
std::optional<glm::dvec3> middle_of_neighbours(const Mesh& m, Vertex of) {
  glm::dvec3 middle(0);
  double n = 0;
  for (const Vertex v : points_around(m, of)) {
    if (!has_place(m, v)) continue;
    ++n;
    middle = middle * ((n - 1) / n) + m.position(v) / n;
  }
  return n > 0 ? std::optional(middle) : std::nullopt;
}

// From the rim inwards: each round goes by the places before it, so that the order makes no difference. Returns the
// points that got a place.
std::vector<Vertex> place_inwards(Edit& edit, std::vector<Vertex> asked) {
  const Mesh& m = edit.mesh();
  std::vector<Vertex> placed;
  while (!asked.empty()) {
    std::vector<std::pair<Vertex, glm::dvec3>> found;
    for (const Vertex v : asked)
      if (const auto middle = middle_of_neighbours(m, v)) found.emplace_back(v, *middle);
    asked.clear();
    for (const auto& [v, place] : found) {
      move_point(edit, v, place);
      placed.push_back(v);
    }
    for (const auto& [v, place] : found)
      for (const Vertex other : points_around(m, v))
        if (!has_place(m, other)) asked.push_back(other);
    sort_unique(asked);
  }
  return placed;
}

template <class Is>
void add_faces_at(const Mesh& m, Vertex of, std::vector<Face>& faces, Is is) {
  for_each_face_at(m, of, [&](Face f) {
    if (is(f)) faces.push_back(f);
  });
}

bool has_faces(const Mesh& m, Vertex of) {
  std::vector<Face> faces;
  add_faces_at(m, of, faces, [](Face) { return true; });
  return !faces.empty();
}

// Where a face without area had to stay one of its points is left as it was. Returns these.
std::vector<Element> take_back_from(Edit& edit, std::span<const Face> faces, const std::vector<glm::dvec3>& before) {
  const Mesh& m = edit.mesh();
  std::vector<Element> taken_back;
  for (const Face f : faces) {
    if (!m.is_alive(f) || !is_flat(m, f)) continue;
    for (const Vertex v : vertices_around(m, f)) {
      const std::uint32_t was = v.index < before.size() ? v.index : point(m, v).index;  // a copy has been added since
      if (was >= before.size() || is_finite(before[was])) continue;
      move_point(edit, v, before[was]);
      taken_back.emplace_back(point(m, v));
      break;
    }
  }
  return taken_back;
}

Text told(std::size_t placed, std::size_t faces, std::size_t vertices) {
  Text text = count_text(placed, "One vertex was put in the middle of its neighbours.",
                         "# vertices were put in the middle of their neighbours.",
                         "頂点 # 個を隣り合う頂点の平均の位置に置きました。");
  if (faces > 0)
    text += count_text(faces, " One face that had no place was removed.", " # faces that had no place were removed.",
                       "位置の決まらない面 # 個を削除しました。");
  if (vertices > 0)
    text +=
        count_text(vertices, " One vertex beside none with a place was removed.",
                   " # vertices beside none with a place were removed.", "位置の決まらない頂点 # 個を削除しました。");
  return text;
}

// What one pass has done, and what it had to leave.
struct Pass {
  std::size_t placed = 0, faces = 0, vertices = 0;
  std::vector<Element> used, kept;

  std::size_t changed() const { return placed + faces + vertices; }
};

Pass pass_over(Edit& edit, const AlgorithmInput& input) {
  const Mesh& m = edit.mesh();
  const std::uint32_t faces_before = m.live().faces;
  const std::vector<glm::dvec3> before(m.positions().begin(), m.positions().end());
  Pass pass;
  std::vector<Vertex> lost = points_without_place(m);
  const std::vector<Vertex> placed = place_inwards(edit, lost);
  std::vector<Face> doomed;
  for (const Vertex v : placed) add_faces_at(m, v, doomed, [&](Face f) { return is_flat(m, f); });
  std::erase_if(lost, [&](Vertex v) { return has_place(m, v); });
  std::erase_if(lost, [&](Vertex v) {
    const bool is_used = std::binary_search(input.used_elsewhere.begin(), input.used_elsewhere.end(), v);
    if (is_used) pass.used.emplace_back(v);
    return is_used;
  });
  for (const Vertex v : lost) add_faces_at(m, v, doomed, [](Face) { return true; });
  delete_soundly(edit, doomed);
  sort_unique(doomed);
  pass.kept = take_back_from(edit, doomed, before);
  pass.placed = placed.size() - pass.kept.size();
  std::erase_if(lost, [&](Vertex v) {
    const bool is_kept = m.is_alive(v) && has_faces(m, v);
    if (is_kept) pass.kept.emplace_back(v);
    return is_kept;
  });
  for (const Vertex v : lost)
    if (const Delete op{v}; m.is_alive(v) && !has_place(m, v) && op.check(m).legal()) op.apply(edit);
  pass.faces = faces_before - m.live().faces;
  pass.vertices = lost.size();
  return pass;
}

}  // namespace

// Again as long as that does anything: what a face had to stay for may be gone.
AlgorithmResult give_places(Edit& edit, const AlgorithmInput& input, Progress&) {
  Pass all, last;
  do {
    last = pass_over(edit, input);
    all.placed += last.placed;
    all.faces += last.faces;
    all.vertices += last.vertices;
  } while (last.changed() > 0 && !(last.kept.empty() && last.used.empty()));
  AlgorithmResult result;
  result.changed = all.changed();
  result.left = last.used.size() + last.kept.size();
  result.text = told(all.placed, all.faces, all.vertices);
  add_left(result.left_for,
           {"a face set aside, a line or a point of the file uses it", "隔離された面・線・点が使っているため"},
           std::move(last.used));
  add_left(result.left_for,
           {"without one of its faces two triangles would lie back to back",
            "ある面をなくすと三角形が背中合わせに重なるため"},
           std::move(last.kept));
  return result;
}

}  // namespace ryosen
