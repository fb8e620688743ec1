#include "ryosen/algo/repair/remove_degenerate.h"

#include <algorithm>
#include <deque>
#include <glm/geometric.hpp>
#include <map>
#include <span>

#include "ryosen/algo/repair/sound_changes.h"
#include "ryosen/analysis/boundary_loops.h"
#include "ryosen/analysis/problem_sets.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/delete.h"
#include "ryosen/ops/dissolve.h"
#include "ryosen/ops/rules/sheets.h"
#include "ryosen/ops/swap_edge.h"

namespace ryosen {

namespace {

template <class Op>
bool apply_if_legal(Edit& edit, const Op& op) {
  if (!op.check(edit.mesh()).legal()) return false;
  op.apply(edit);
  return true;
}

bool collapse_if_sound(Edit& edit, Halfedge h) {
  if (!collapses_soundly(edit.mesh(), h)) return false;
  CollapseEdge{h, CollapseEdge::Place::end}.apply(edit);
  return true;
}

bool is_plain_triangle(const Mesh& m, Face f) { return is_triangle(m, m.halfedge(f)) && !m.has_rings(f); }

double length_of(const Mesh& m, Halfedge h) { return glm::distance(m.position(m.from(h)), m.position(m.to(h))); }

bool collapse_short_edge(Edit& edit, Face f) {
  const Mesh& m = edit.mesh();
  std::vector<Halfedge> sides;
  for (Halfedge h : halfedges_around(m, f))
    if (m.position(m.from(h)) == m.position(m.to(h))) sides.push_back(h);
  return std::any_of(sides.begin(), sides.end(),
                     [&](Halfedge h) { return collapse_if_sound(edit, h) || collapse_if_sound(edit, twin(h)); });
}

// The side of a plain triangle opposite the middle one of its collinear corners, which are at three places; else none.
Halfedge long_side(const Mesh& m, Face f) {
  if (!is_plain_triangle(m, f)) return Halfedge();
  const Halfedge h = m.halfedge(f);
  for (Halfedge side : {h, m.next(h), m.prev(h)}) {
    const glm::dvec3 &a = m.position(m.from(side)), &b = m.position(m.to(side)), &c = m.position(m.to(m.next(side)));
    bool between = true;
    for (int axis = 0; axis < 3; ++axis)
      between = between && std::min(a[axis], b[axis]) <= c[axis] && c[axis] <= std::max(a[axis], b[axis]);
    if (between && c != a && c != b) return side;
  }
  return Halfedge();
}

bool give_corner_away(Edit& edit, Face f) {
  const Mesh& m = edit.mesh();
  const Halfedge side = long_side(m, f);
  const Face other = side ? m.face(twin(side)) : Face();
  if (!other || is_flat(m, other)) return false;
  if (is_plain_triangle(m, other) && apply_if_legal(edit, SwapEdge{side})) return true;
  return apply_if_legal(edit, Dissolve{side});
}

// Gives corners to the same face at once, by halves where that is not legal. Returns how many.
std::size_t give_corners_away(Edit& edit, std::span<const Halfedge> sides) {
  constexpr std::size_t few = 8;
  if (sides.size() < few) return 0;
  if (dissolve_together(edit, {sides.begin(), sides.end()})) return sides.size();
  const std::size_t half = sides.size() / 2;
  const std::size_t in_first = give_corners_away(edit, sides.first(half));
  return in_first + give_corners_away(edit, sides.subspan(half));
}

bool shorten_common_side(Edit& edit, Face f) {
  const Mesh& m = edit.mesh();
  const Halfedge side = long_side(m, f);
  const Face other = side ? m.face(twin(side)) : Face();
  if (!other || other == f || !is_plain_triangle(m, other) || !is_flat(m, other)) return false;
  const glm::dvec3 &c = m.position(m.to(m.next(side))), &d = m.position(m.to(m.next(twin(side))));
  return glm::distance(c, d) < length_of(m, side) && apply_if_legal(edit, SwapEdge{side});
}

bool is_loose(const Mesh& m, Face f) {
  const auto around = halfedges_around(m, f);
  return !m.has_rings(f) &&
         std::all_of(around.begin(), around.end(), [&](Halfedge h) { return m.is_outside(twin(h)); });
}

// Whether the face can go without a hole: its sides without a neighbour are one run, and no other corner is on a
// boundary.
bool is_at_border(const Mesh& m, Face f) {
  if (m.has_rings(f)) return false;
  std::size_t runs = 0, open = 0;
  bool others_are_inside = true;
  for (Halfedge h : halfedges_around(m, f)) {
    const bool is_open = m.is_outside(twin(h)), was_open = m.is_outside(twin(m.prev(h)));
    open += is_open;
    runs += is_open && !was_open;
    const Vertex v = m.from(h);
    if (!is_open && !was_open) others_are_inside = others_are_inside && !m.is_boundary(v) && !has_copies(m, v);
  }
  return open == corner_count(m, f) || (runs == 1 && others_are_inside);
}

bool move_corner(Edit& edit, Face f) {
  const Mesh& m = edit.mesh();
  std::vector<std::tuple<bool, double, Halfedge>> ways;  // inner corners first, then short ways
  for (Halfedge side : halfedges_around(m, f))
    for (Halfedge h : {side, twin(side)}) ways.emplace_back(m.is_boundary(m.from(h)), length_of(m, h), h);
  std::sort(ways.begin(), ways.end());
  return std::any_of(ways.begin(), ways.end(), [&](const auto& way) {
    const CollapseEdge op{std::get<Halfedge>(way), CollapseEdge::Place::end};
    if (!collapses_soundly(m, op.halfedge)) return false;
    for (const Reason& reason : op.warnings(m))
      if (reason.rule != Rule::seam) return false;
    op.apply(edit);
    return true;
  });
}

std::vector<Face> flat_faces(const Mesh& m) {
  std::vector<Face> flat;
  Neighbourhood around(m);
  const auto is_degenerate = row_of(ProblemKind::degenerate_area).face;
  for (const Face f : live_faces(m))
    if (is_degenerate(around, f)) flat.push_back(f);
  return flat;
}

std::size_t boundary_loops(const Mesh& m) {
  const ProblemSets sets(m);
  Neighbourhood around(m);
  BoundaryLoopCount loops;
  loops.search(around, sets.of(ProblemKind::boundary_loop));
  return loops.count();
}

class Removal {
 public:
  Removal(Edit& edit, std::vector<Face> flat, Progress& progress)
      : edit_(edit), m_(edit.mesh()), progress_(progress), flat_(std::move(flat)), all_(flat_.size()) {}

  AlgorithmResult run() {
    do {
      while (!flat_.empty() && takes_some_away()) continue;
      if (progress_.is_cancelled()) return {};
    } while (!flat_.empty() && open_holes());  // where one has opened, other ways may have too
    return result();
  }

  // Only where the surface stays as it is. Returns how many faces went.
  std::size_t mend() {
    while (!flat_.empty() && (give_many_away() || sweep([&](Face f) { return keep_surface(f); }) ||
                              sweep([&](Face f) { return leave_border(f); })))
      continue;
    return all_ - flat_.size();
  }

 private:
  bool is_left(Face f) const { return m_.is_alive(f) && is_flat(m_, f); }
  bool may_go_on() { return progress_.go_on(all_ - std::min(all_, flat_.size()), all_); }

  // One way after the other, those that keep the surface first. Whether some face went.
  bool takes_some_away() {
    return give_many_away() || sweep([&](Face f) { return keep_surface(f); }) || drop_loose() ||
           sweep([&](Face f) { return leave_border(f); }) ||
           sweep([&](Face f) { return shorten_common_side(edit_, f); }) ||
           sweep([&](Face f) { return move_corner(edit_, f) && ++collapsed_ > 0; });
  }

  // Tries a step on each flat face, and again on the flat faces beside one that is gone. Whether any went.
  template <class Step>
  bool sweep(Step step) {
    bool any = false;
    std::deque<Face> queue(flat_.begin(), flat_.end());
    std::vector<Face> beside;
    for (; !queue.empty(); queue.pop_front()) {
      const Face f = queue.front();
      if (!may_go_on()) return false;
      if (!is_left(f)) continue;
      beside.clear();
      for (Halfedge h : halfedges_around(m_, f))
        if (const Face g = m_.face(twin(h)); g && g != f) beside.push_back(g);
      if (!step(f)) continue;
      any = true;
      for (Face g : beside)
        if (is_left(g)) queue.push_back(g);
    }
    forget_gone();
    return any;
  }

  // Corners given to faces with many: each gets all of its at once.
  bool give_many_away() {
    constexpr std::size_t many = 16;
    if (!may_go_on()) return false;
    std::map<Face, std::vector<Halfedge>> sides;
    for (Face f : flat_) {
      const Halfedge side = long_side(m_, f);
      if (side && m_.face(twin(side))) sides[m_.face(twin(side))].push_back(side);
    }
    const std::size_t before = given_;
    for (const auto& [face, at_face] : sides)
      if (m_.is_alive(face) && at_face.size() >= many && !is_flat(m_, face))
        given_ += give_corners_away(edit_, at_face);
    forget_gone();
    return given_ > before;
  }

  bool keep_surface(Face f) {
    if (collapse_short_edge(edit_, f)) return ++collapsed_, true;
    if (give_corner_away(edit_, f)) return ++given_, true;
    return false;
  }

  // Whether no corner has copies.
  bool is_alone(Face f) const {
    for (Vertex v : vertices_around(m_, f))
      if (has_copies(m_, v)) return false;
    return true;
  }

  // Faces without a neighbour that meet others at their points, all at once: there may be many at one edge.
  bool drop_loose() {
    if (!may_go_on()) return false;
    std::vector<Face> loose;
    for (Face f : flat_)
      if (is_left(f) && is_loose(m_, f) && !is_alone(f)) loose.push_back(f);
    if (loose.empty()) return false;
    const bool any = count_deleted(delete_soundly(edit_, std::move(loose)));
    forget_gone();
    return any;
  }

  bool count_deleted(std::size_t gone) {
    deleted_ += gone;
    return gone > 0;
  }
  void forget_gone() {
    std::erase_if(flat_, [&](Face f) { return !is_left(f); });
  }

  bool leave_border(Face f) {
    if (!is_at_border(m_, f)) return false;
    if (!is_alone(f)) return count_deleted(delete_soundly(edit_, {f}));
    Sheets sheets(edit_);  // where it is alone nothing else can become unsound
    delete_elements(edit_, sheets, {{f}, {}, {}});
    return count_deleted(1);
  }

  // Deletes what no other way takes away. Whether some face went.
  bool open_holes() {
    const std::size_t before = boundary_loops(m_);
    const bool any = count_deleted(delete_soundly(edit_, flat_));
    opened_ += std::max(boundary_loops(m_), before) - before;
    forget_gone();
    return any;
  }

  // How many in each way: ": 2 edges collapsed, 3 deleted".
  Text ways() const {
    Text text;
    const auto add = [&](std::size_t n, const char* one, const char* many, const char* ja) {
      if (n > 0) text += (text.en.empty() ? Text{": ", "（"} : Text{", ", "、"}) + count_text(n, one, many, ja);
    };
    add(collapsed_, "# edge collapsed", "# edges collapsed", "稜線削除 #");
    add(given_, "# corner given to the face across", "# corners given to the face across", "向かいの面への統合 #");
    add(deleted_, "# deleted", "# deleted", "面の削除 #");
    return text + Text{"", "）"};
  }

  AlgorithmResult result() const {
    AlgorithmResult result;
    result.changed = collapsed_ + given_ + deleted_ > 0 ? all_ - flat_.size() : 0;
    result.left = flat_.size();
    add_left(
        result.left_for,
        {"every way to take it away would make the surface unsound", "どの方法で取り除いても曲面が不健全になるため"},
        {flat_.begin(), flat_.end()});
    result.text = count_text(result.changed, "One face without area was removed", "# faces without area were removed",
                             "面積ゼロの面を # 個なくしました");
    if (result.changed > 0) result.text += ways();
    if (opened_ > 0)
      result.text += count_text(opened_, "; this opened one boundary loop", "; this opened # boundary loops",
                                "。境界ループが # 本増えました");
    if (result.left > 0) result.text += count_text(result.left, "; # stays", "; # stay", "。残り #");
    result.text += Text{".", "。"};
    return result;
  }

  Edit& edit_;
  const Mesh& m_;
  Progress& progress_;
  std::vector<Face> flat_;
  std::size_t all_, collapsed_ = 0, given_ = 0, deleted_ = 0, opened_ = 0;
};

}  // namespace

AlgorithmResult remove_degenerate_faces(Edit& edit, const AlgorithmInput&, Progress& progress) {
  return Removal(edit, flat_faces(edit.mesh()), progress).run();
}

std::size_t mend_degenerate_faces(Edit& edit, std::vector<Face> faces, Progress& progress) {
  const Mesh& m = edit.mesh();
  sort_unique(faces);
  std::erase_if(faces, [&](Face f) { return !is_flat(m, f) || is_loose(m, f); });
  return faces.empty() ? 0 : Removal(edit, std::move(faces), progress).mend();
}

}  // namespace ryosen
