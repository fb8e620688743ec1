#include "ryosen/algo/repair/weld_points.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "ryosen/algo/repair/detach_nonmanifold.h"
#include "ryosen/algo/repair/near_points.h"
#include "ryosen/algo/repair/pair_faces.h"
#include "ryosen/algo/repair/pockets.h"
#include "ryosen/algo/repair/point_merger.h"
#include "ryosen/algo/repair/side_effects.h"
#include "ryosen/algo/repair/sides_apart.h"
#include "ryosen/algo/repair/sound_changes.h"
#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/analysis/problem_kinds.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/faces_at.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/rules/turn_faces.h"

namespace ryosen {

namespace {

struct Welded {
  std::size_t points = 0, turned = 0;
  std::vector<Element> left;  // the first point of each place that stays several
  std::vector<Edge> joined;
};

// Which points become one, chosen side by side, so that the faces at every one of them stay one fan.
class Welding {
 public:
  Welding(const Mesh& m, const NearPoints& near, const Reach& reach) : m_(m), place_(near.first), used_(reach.used) {
    for (const Vertex p : live_vertices(m))
      if (point_of(p) == p && place_[p.index] != p) mates_[place_[p.index]].push_back(p);
    for (auto& [first, others] : mates_) {
      others.push_back(first);
      sort_unique(others);
    }
  }

  // The faces to turn so that sides that lie on each other run in opposite directions, where they can; empty: none.
  std::vector<bool> faces_to_turn() const { return turns_of(m_, sides_at_one_place(m_, place_)); }

  Welded weld(Edit& edit, Progress& progress) {
    Welded welded;
    merger_.emplace(m_, points_to_merge());
    const std::vector<Halfedge> across = pair_at_places(m_, place_).across;
    for (const auto& [f, g] : find_pockets(m_, across))
      if (would_close(f, across)) merger_->let_be_pocket(f, g);
    const std::vector<SidePair> all = pairs(across);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!progress.go_on(i, all.size())) return welded;
      if (join(all[i]))
        for (Halfedge h : {all[i].first, all[i].second}) welded.joined.push_back(edge(h));
    }
    const std::vector<JoinedPoints> classes = joined_classes(welded);
    for (const JoinedPoints& joined : classes) welded.points += joined.points.size() - 1;
    join_points(edit, classes);
    return welded;
  }

  // Says what is left where nothing is done.
  Welded leave() {
    Welded welded;
    merger_.emplace(m_, points_to_merge());
    joined_classes(welded);
    return welded;
  }

 private:
  // Whether each side of a pocket's face is joined to the other face, or can be by welding an end of it. A side on the
  // same points as the other is cut from it where more faces meet, and stays so.
  bool would_close(Face f, const std::vector<Halfedge>& across) const {
    for (const Halfedge h : halfedges_around(m_, f)) {
      const Halfedge other = across[h.index];
      if (twin(h) != other && same_point(m_, m_.from(h), m_.to(other)) && same_point(m_, m_.to(h), m_.from(other)))
        return false;
    }
    return true;
  }

  Vertex point_of(Vertex v) const { return point(m_, v); }

  // The sides that are paired across points, in the order of their places.
  std::vector<SidePair> pairs(const std::vector<Halfedge>& across) const {
    const auto points = [&](Halfedge h) { return std::minmax({point_of(m_.from(h)), point_of(m_.to(h))}); };
    const auto places = [&](Halfedge h) { return std::minmax({place_[m_.from(h).index], place_[m_.to(h).index]}); };
    std::vector<SidePair> found;
    for (std::uint32_t i = 0; i < across.size(); ++i) {
      const Halfedge h(i), other = across[i];
      if (other && h < other && points(h) != points(other)) found.push_back({h, other, false});
    }
    std::sort(found.begin(), found.end(), [&](const SidePair& a, const SidePair& b) {
      return std::pair(places(a.first), a.first) < std::pair(places(b.first), b.first);
    });
    return found;
  }

  // Those that are manifold and have a boundary; the others have no side to join.
  std::vector<Vertex> points_to_merge() const {
    Neighbourhood around(m_);
    std::vector<Vertex> found;
    for (const auto& [first, others] : mates_)
      for (Vertex p : others) {
        if (m_.is_isolated(p) || ends_a_wire(m_, p)) continue;
        const bool has_boundary = any_of_copies(m_, p, [&](Vertex copy) { return m_.is_boundary(copy); });
        if (has_boundary && !is_nonmanifold(around, p)) found.push_back(p);
      }
    return found;
  }

  glm::dvec3 place_of(Vertex v) const {
    const Vertex p = point_of(v);
    return moved_.contains(p) ? m_.position(place_[p.index]) : m_.position(p);
  }

  bool makes_flat(Vertex moved) const {
    return any_of_faces_at(
        m_, moved, [&](Face f) { return !is_flat(m_, f) && is_flat_at(m_, f, [&](Vertex v) { return place_of(v); }); });
  }

  // Points that leave their own position by being welded now.
  bool move(std::span<const Vertex> points) {
    std::vector<Vertex> now;
    for (Vertex p : points)
      if (m_.position(p) != m_.position(place_[p.index]) && moved_.insert(p).second) now.push_back(p);
    if (std::none_of(now.begin(), now.end(), [&](Vertex p) { return makes_flat(p); })) return true;
    for (Vertex p : now) moved_.erase(p);
    return false;
  }

  bool join(const SidePair& pair) {
    const std::array<Vertex, 4> ends{point_of(m_.from(pair.first)), point_of(m_.to(pair.second)),
                                     point_of(m_.to(pair.first)), point_of(m_.from(pair.second))};
    std::vector<Vertex> merged;
    std::size_t merges = 0;
    bool is_sound = true;
    for (std::size_t i = 0; i < 4 && is_sound; i += 2) {
      const Vertex a = merger_->root(ends[i]), b = merger_->root(ends[i + 1]);
      if (a == b) continue;
      is_sound = merger_->may_merge(a) && merger_->may_merge(b) && merger_->merge(a, b);
      merges += is_sound;
      merged.insert(merged.end(), {ends[i], ends[i + 1]});
    }
    if (is_sound && move(merged)) return true;
    for (; merges > 0; --merges) merger_->undo();
    return false;
  }

  std::vector<JoinedPoints> joined_classes(Welded& welded) const {
    std::vector<JoinedPoints> classes;
    for (const auto& [first, others] : mates_)
      if (add_classes(first, others, classes) > 1) welded.left.emplace_back(first);
    return classes;
  }

  // The classes of several points at one place. Isolated ones join the lowest other. Returns how many points stay
  // apart.
  std::size_t add_classes(Vertex first, const std::vector<Vertex>& others, std::vector<JoinedPoints>& classes) const {
    std::map<Vertex, std::vector<Vertex>> by_root;
    for (Vertex p : others)
      if (!is_isolated_point(m_, p)) by_root[merger_->root(p)].push_back(p);
    if (by_root.empty()) by_root[others[0]];
    const auto lowest = std::min_element(by_root.begin(), by_root.end(), [](const auto& a, const auto& b) {
      return !b.second.empty() && (a.second.empty() || a.second < b.second);
    });
    const bool had_several = lowest->second.size() > 1;
    const glm::dvec3 own = lowest->second.empty() ? m_.position(first) : m_.position(lowest->second[0]);
    std::size_t apart = by_root.size();
    apart += add_isolated(others, had_several ? m_.position(first) : own, lowest->second);
    for (auto& [root, points] : by_root) {
      if (points.size() < 2) continue;
      const bool stays = root == lowest->first && !had_several;
      classes.push_back({points, stays ? own : m_.position(first)});
    }
    return apart;
  }

  // Adds isolated points to a class that will be at this place. One that is used elsewhere goes only where the file can
  // do without it (to_indexed.h): to a lower point at its very place. Returns how many stay alone.
  std::size_t add_isolated(const std::vector<Vertex>& others, const glm::dvec3& place,
                           std::vector<Vertex>& points) const {
    std::vector<Vertex> used;
    for (Vertex p : others)
      if (is_isolated_point(m_, p)) (std::binary_search(used_.begin(), used_.end(), p) ? used : points).push_back(p);
    if (points.empty()) points.push_back(used[0]);
    sort_unique(points);
    const Vertex lowest = points[0];
    std::size_t alone = 0;
    for (Vertex p : used) {
      if (p == lowest) continue;
      const bool may_go = lowest < p && m_.position(p) == place;
      if (may_go) points.push_back(p);
      alone += !may_go;
    }
    sort_unique(points);
    return alone;
  }

  const Mesh& m_;
  const std::vector<Vertex>& place_;             // by vertex the first point there
  std::span<const Vertex> used_;                 // elsewhere
  std::map<Vertex, std::vector<Vertex>> mates_;  // all points at a place of several, ascending
  std::set<Vertex> moved_;
  std::optional<PointMerger> merger_;
};

AlgorithmResult result_of(const Welded& welded) {
  AlgorithmResult result{welded.points, welded.left.size(), {}};
  add_left(result.left_for,
           {"points at one place stay apart where joining them would make the surface unsound, or where they lie on no "
            "boundary",
            "同じ位置の点でも、縫合すると曲面が不健全になる場合や境界上にない場合は縫合しません"},
           welded.left);
  result.text = count_text(welded.points, "One point was welded to another", "# points were welded to others",
                           "点を # 個、ほかの点に縫合しました");
  if (welded.points > 0 && welded.turned > 0)
    result.text += count_text(welded.turned, "; one face was turned round to fit", "; # faces were turned round to fit",
                              "（向きを合わせるため面を # 枚裏返しました）");
  if (result.left > 0)
    result.text +=
        count_text(result.left, "; # place was left apart", "; # places were left apart", "（縫合できない箇所 #）");
  result.text += Text{".", "。"};
  return result;
}

void add(const Welded& more, Welded& welded) {
  welded.points += more.points;
  welded.left = more.left;
  welded.joined.insert(welded.joined.end(), more.joined.begin(), more.joined.end());
}

// Welds until nothing more is welded: a weld may allow another one.
template <class Weld>
Welded weld_all(Edit& edit, const NearPoints& near, const Reach& reach, Weld weld) {
  Welded welded = weld(edit, near);
  for (std::size_t points = welded.points; points > 0;) {
    const Welded more = weld(edit, find_near_points(edit.mesh(), reach));
    points = more.points;
    add(more, welded);
  }
  return welded;
}

template <class Weld>
Welded weld_copy(Mesh& copy, const Reach& reach, Weld weld, Descent& descent) {
  Edit edit(copy, nullptr, &descent);
  Welded welded = weld_all(edit, find_near_points(copy, reach), reach, weld);
  edit.commit();
  return welded;
}

// First as the faces are, so that no closed part has to be turned; nothing where that would tear one. Turning replaces
// all columns, which must be the only write of the edit: then everything is done on a copy.
template <class Weld>
Welded weld_and_turn(Edit& edit, const NearPoints& near, const Reach& reach, Weld weld) {
  const Mesh& m = edit.mesh();
  if (Welding(m, near, reach).faces_to_turn().empty() && !pair_faces(m).has_nonmanifold_edges)
    return weld_all(edit, near, reach, weld);
  Mesh copy = m;
  Descent descent = edit.new_descent();
  Welded welded = weld_copy(copy, reach, weld, descent);
  if (is_torn(m, copy)) return Welding(m, near, reach).leave();
  const std::vector<bool> turned = Welding(copy, find_near_points(copy, reach), reach).faces_to_turn();
  if (!turned.empty()) {
    Descent descent_now = descent;
    Mesh now(turn_faces(copy, turned, &descent_now).columns);
    const Welded more = weld_copy(now, reach, weld, descent_now);
    if (!is_torn(m, now)) {
      copy = std::move(now);
      descent = std::move(descent_now);
      add(more, welded);
      welded.turned = static_cast<std::size_t>(std::count(turned.begin(), turned.end(), true));
    }
  }
  edit.replace(std::move(copy).columns(), descent);
  return welded;
}

Welded weld_near(Edit& edit, const Reach& reach, Progress& progress) {
  const NearPoints near = find_near_points(edit.mesh(), reach);
  if (!near.are_any) return {};
  return weld_and_turn(edit, near, reach, [&](Edit& on, const NearPoints& now) {
    return Welding(on.mesh(), now, reach).weld(on, progress);
  });
}

}  // namespace

AlgorithmResult weld_equal_points(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  return result_of(weld_near(edit, {0, input.used_elsewhere}, progress));
}

std::vector<Edge> weld_near_points(Edit& edit, const Reach& reach, Progress& progress) {
  return weld_near(edit, reach, progress).joined;
}

AlgorithmResult weld_close_points(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const Reach reach{input.values.length("distance"), input.used_elsewhere};
  const NearPoints near = find_near_points(edit.mesh(), reach);
  if (!near.are_any) return result_of({});
  const Mesh before = edit.mesh();
  const Welded welded = weld_and_turn(edit, near, reach, [&](Edit& on, const NearPoints& at_first) {
    const std::size_t collapsed = collapse_near(on, at_first, progress);
    const NearPoints now = collapsed > 0 ? find_near_points(on.mesh(), reach) : at_first;
    Welded result = Welding(on.mesh(), now, reach).weld(on, progress);
    result.points += collapsed;
    return result;
  });
  AlgorithmResult result = result_of(welded);
  if (result.changed > 0 && progress.go_on()) add_new_crossings(before, edit.mesh(), result);
  return result;
}

}  // namespace ryosen
