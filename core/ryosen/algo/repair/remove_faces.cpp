#include "ryosen/algo/repair/remove_faces.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "ryosen/algo/repair/detach_nonmanifold.h"
#include "ryosen/algo/repair/pair_faces.h"
#include "ryosen/algo/repair/sound_changes.h"
#include "ryosen/analysis/equal_faces.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/faces_at.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

namespace {

struct EqualLoops {
  std::vector<Face> redundant;       // go
  std::vector<Face> of_solids;       // stay since they bound closed parts
  std::vector<Face> holding;         // stay since an edge would open without them
  std::vector<Face> of_other_loops;  // on the same points as another, in another order

  // Faces that run alike on one loop can stand for each other.
  struct Alike {
    std::vector<Face> faces;  // ascending
    std::size_t closed = 0;   // how many of those that stay bound closed parts
  };
  std::vector<Alike> alike;
  // As many as are redundant, the highest of those that run alike: to go in their place where that opens no closed
  // part.
  std::vector<Face> highest;
  std::vector<Face> closed_alone;  // faces of closed parts that run like no other
};

using PointList = std::vector<std::uint32_t>;

struct LoopForm {
  PointList points;
  bool is_turned;  // it runs the other way

  friend auto operator<=>(const LoopForm&, const LoopForm&) = default;
};

// Canonical form, independent of start and direction: the lexicographically smallest list, which begins with the
// smallest point. Only at bridges does a loop come to a point again.
LoopForm normal_form(PointList loop) {
  LoopForm best{};
  const std::uint32_t smallest = *std::min_element(loop.begin(), loop.end());
  for (const bool is_turned : {false, true}) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop[i] != smallest) continue;
      PointList turned(loop.begin() + static_cast<std::ptrdiff_t>(i), loop.end());
      turned.insert(turned.end(), loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(i));
      if (best.points.empty() || turned < best.points) best = {std::move(turned), is_turned};
    }
    std::reverse(loop.begin(), loop.end());
  }
  return best;
}

// The canonical loops of a face, concatenated with a separator, and the direction of the first.
LoopForm shape_of(const Mesh& m, Face f) {
  std::vector<LoopForm> loops;
  for_each_loop(m, f, [&](Halfedge start) {
    PointList loop_points;
    for (Halfedge h : loop(m, start)) loop_points.push_back(point(m, m.from(h)).index);
    loops.push_back(normal_form(std::move(loop_points)));
  });
  std::sort(loops.begin(), loops.end());
  LoopForm shape{{}, loops[0].is_turned};
  for (const LoopForm& one : loops) {
    shape.points.insert(shape.points.end(), one.points.begin(), one.points.end());
    shape.points.push_back(no_index);
  }
  return shape;
}

struct FaceOnPoints {
  PointList points;  // ascending
  Face face;

  friend auto operator<=>(const FaceOnPoints&, const FaceOnPoints&) = default;
};

// Faces that share their set of points with another.
std::vector<FaceOnPoints> faces_with_equals(const Mesh& m, const std::vector<std::uint32_t>& duplicates) {
  std::vector<Vertex> at;
  std::vector<Face> faces;
  for (std::uint32_t i : duplicates)
    for (Vertex v : vertices_around(m, Face(i))) at.push_back(point(m, v));
  sort_unique(at);
  for (Vertex p : at) for_each_face_at(m, p, [&](Face f) { faces.push_back(f); });
  sort_unique(faces);
  std::vector<FaceOnPoints> found;
  for (Face f : faces) {
    found.push_back({{}, f});
    for (Vertex v : vertices_around(m, f)) found.back().points.push_back(point(m, v).index);
    std::sort(found.back().points.begin(), found.back().points.end());
  }
  std::sort(found.begin(), found.end());
  return found;
}

struct Member {
  Face face;
  bool is_turned;
};
using Class = std::vector<Member>;  // on one loop of points, ascending by face

// The classes of several faces. Faces on the same points as a lower one in another order are added to `of_other_loops`.
std::vector<Class> classes_of(const Mesh& m, std::vector<Face>& of_other_loops) {
  Neighbourhood around(m, Neighbourhood::Reach::whole);
  const std::vector<FaceOnPoints> faces = faces_with_equals(m, find_duplicate_faces(around));
  std::vector<Class> classes;
  for (std::size_t first = 0, last = 0; first < faces.size(); first = last) {
    for (last = first; last < faces.size() && faces[last].points == faces[first].points;) ++last;
    if (last - first < 2) continue;
    std::map<PointList, Class> by_shape;
    for (std::size_t i = first; i < last; ++i) {
      LoopForm shape = shape_of(m, faces[i].face);
      Class& members = by_shape[std::move(shape.points)];
      if (members.empty() && by_shape.size() > 1) of_other_loops.push_back(faces[i].face);
      members.push_back({faces[i].face, shape.is_turned});
    }
    for (auto& [shape, members] : by_shape)
      if (members.size() > 1) classes.push_back(std::move(members));
  }
  std::sort(classes.begin(), classes.end(), [](const Class& a, const Class& b) { return a[0].face < b[0].face; });
  return classes;
}

// Decides which members of the classes go.
class LoopChoice {
 public:
  LoopChoice(const Mesh& m, const std::vector<Class>& classes)
      : m_(m), classes_(classes), pairing_(pair_faces(m)), goes_(m.face_slots(), false) {}

  void choose() {
    for (const Class& members : classes_)
      for (const Member& member : members) goes_[member.face.index] = !is_closed(member.face);
    drop_equal_parts();
    for (const Class& members : classes_)
      for (const Member& member : members)
        if (goes(member.face) && is_needed(member.face)) keep(member.face);
    for (const Class& members : classes_)
      if (std::all_of(members.begin(), members.end(), [&](const Member& member) { return goes(member.face); }))
        keep(members[0].face);
  }

  bool goes(Face f) const { return goes_[f.index]; }
  bool is_closed(Face f) const { return pairing_.is_closed[f.index]; }

 private:
  // Closed parts whose faces are all on those of a lower closed part, in the same directions.
  void drop_equal_parts() {
    std::map<std::uint32_t, std::vector<std::pair<std::uint32_t, bool>>> loops;  // by part
    for (std::uint32_t c = 0; c < classes_.size(); ++c)
      for (const Member& member : classes_[c])
        if (is_closed(member.face)) loops[pairing_.part[member.face.index]].emplace_back(c, member.is_turned);
    std::vector<std::size_t> sizes(m_.face_slots(), 0);
    for (const Face f : live_faces(m_)) ++sizes[pairing_.part[f.index]];
    std::map<std::vector<std::pair<std::uint32_t, bool>>, std::uint32_t> lowest;
    std::vector<bool> is_dropped(m_.face_slots(), false);
    for (auto& [part, list] : loops) {
      if (list.size() != sizes[part]) continue;
      std::sort(list.begin(), list.end());
      is_dropped[part] = !lowest.try_emplace(std::move(list), part).second;
    }
    for (const Class& members : classes_)
      for (const Member& member : members)
        if (is_dropped[pairing_.part[member.face.index]]) goes_[member.face.index] = true;
  }

  // Whether a face that stays is paired with it.
  bool is_needed(Face f) const {
    for (const Halfedge h : halfedges_around(m_, f)) {
      const Halfedge other = pairing_.across[h.index];
      if (other && !goes(m_.face(other))) return true;
    }
    return false;
  }

  void keep(Face f) {
    std::vector<Face> kept{f};
    goes_[f.index] = false;
    for (std::size_t i = 0; i < kept.size(); ++i)
      for (const Halfedge h : halfedges_around(m_, kept[i])) {
        const Halfedge other = pairing_.across[h.index];
        if (!other || !goes(m_.face(other))) continue;
        goes_[m_.face(other).index] = false;
        kept.push_back(m_.face(other));
      }
  }

  const Mesh& m_;
  const std::vector<Class>& classes_;
  const FacePairing pairing_;
  std::vector<bool> goes_;  // by face slot
};

// Keeps one of the faces on the same loop of points, regardless of direction and start: where the pairs of faces
// (pair_faces.h) make no difference, the lowest. A face of a closed part goes only where all of that part goes, because
// a lower part has the same faces; another face goes where no face that stays is paired with it. O(n log n).
EqualLoops find_equal_loops(const Mesh& mesh) {
  EqualLoops found;
  const std::vector<Class> classes = classes_of(mesh, found.of_other_loops);
  if (classes.empty()) return found;
  LoopChoice choice(mesh, classes);
  choice.choose();
  std::vector<bool> is_alike(mesh.face_slots(), false);
  for (const Class& members : classes) {
    for (const bool is_turned : {false, true}) {
      EqualLoops::Alike alike;
      std::size_t going = 0;
      for (const Member& member : members) {
        if (member.is_turned != is_turned) continue;
        alike.faces.push_back(member.face);
        is_alike[member.face.index] = true;
        going += choice.goes(member.face);
        alike.closed += !choice.goes(member.face) && choice.is_closed(member.face);
      }
      found.highest.insert(found.highest.end(), alike.faces.end() - static_cast<std::ptrdiff_t>(going),
                           alike.faces.end());
      found.alike.push_back(std::move(alike));
    }
    bool is_first = true;
    for (const Member& member : members) {
      if (choice.goes(member.face)) {
        found.redundant.push_back(member.face);
        continue;
      }
      if (!is_first) (choice.is_closed(member.face) ? found.of_solids : found.holding).push_back(member.face);
      is_first = false;
    }
  }
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f)
    if (choice.is_closed(Face(f)) && !is_alike[f]) found.closed_alone.push_back(Face(f));
  return found;
}

// Whether the faces of closed parts that were to stay bound closed parts. O(n).
bool keeps_closed(const EqualLoops& found, const FacePairing& after) {
  const auto is_closed = [&](Face f) { return static_cast<bool>(after.is_closed[f.index]); };
  return std::all_of(found.closed_alone.begin(), found.closed_alone.end(), is_closed) &&
         std::all_of(found.alike.begin(), found.alike.end(), [&](const EqualLoops::Alike& alike) {
           const auto closed = std::count_if(alike.faces.begin(), alike.faces.end(), is_closed);
           return static_cast<std::size_t>(closed) >= alike.closed;
         });
}

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
  if (result.left > 0)
    result.text += count_text(result.left, " One stays: a face set aside, a line or a point of the file uses it.",
                              " # stay: faces set aside, lines or points of the file use them.",
                              "隔離された面・線・点が使う # 個は残しました。");
  return result;
}

}  // namespace ryosen
