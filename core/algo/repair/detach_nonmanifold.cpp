#include "core/algo/repair/detach_nonmanifold.h"

#include <algorithm>

#include "core/analysis/disjoint_sets.h"
#include "core/analysis/neighbourhood.h"
#include "core/base/count_text.h"
#include "core/base/sort_unique.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/ops/rules/sheets.h"

namespace ryosen {

namespace {

std::vector<Vertex> nonmanifold_points(const Mesh& m) {
  std::vector<Vertex> found;
  Neighbourhood around(m, Neighbourhood::Reach::whole);
  const auto is_nonmanifold = row_of(ProblemKind::nonmanifold_vertex).vertex;
  for (std::uint32_t i = 0; i < m.vertex_slots(); ++i)
    if (m.is_alive(Vertex(i)) && is_nonmanifold(around, Vertex(i))) found.emplace_back(i);
  return found;
}

using Groups = std::vector<std::vector<Vertex>>;  // of copies that stay together, each ascending

// One turn of taking points apart.
class Detaching {
 public:
  explicit Detaching(Edit& edit) : edit_(edit), m_(edit.mesh()) {}

  // Returns the number of new points.
  std::size_t take_apart(const std::vector<Vertex>& gently, std::vector<Vertex> wholly) {
    Sheets sheets(edit_);
    for (const std::vector<Vertex>& points : {gently, wholly})
      for (Vertex p : points) separate_fans_at(sheets, p);
    Groups groups = groups_at(gently, wholly);
    // Two equal triangles that a third face held apart would hang on each other: they are parted at their third corner.
    for (wholly = points_of_pairs(); !wholly.empty(); wholly = points_of_pairs()) {
      for (Vertex p : wholly) separate_fans_at(sheets, p);
      const Groups more = groups_at({}, wholly);
      groups.insert(groups.end(), more.begin(), more.end());
    }
    std::vector<Vertex> parts, unsettled;
    for (const std::vector<Vertex>& group : groups) {
      if (has_copies(m_, group[0])) parts.push_back(group[0]);
      if (has_copies(m_, group[0]) || has_neighbour_with_copies(group[0])) unsettled.push_back(group[0]);
    }
    sheets.settle(unsettled);
    find_what_is_next(parts);
    return made_;
  }

  // What the last turn asks for.
  std::vector<Vertex> next_gently, next_wholly;

 private:
  void separate_fans_at(Sheets& sheets, Vertex p) const {
    std::vector<Vertex> copies;
    for_each_copy(m_, p, [&](Vertex copy) { copies.push_back(copy); });
    for (Vertex copy : copies) sheets.separate(copy);
  }

  // Takes the points apart. All groups are found before any is split: edges are judged on the original points.
  Groups groups_at(const std::vector<Vertex>& gently, const std::vector<Vertex>& wholly) {
    Neighbourhood around(m_);
    Groups groups;
    for (Vertex p : gently) add_groups(around, p, true, groups);
    for (Vertex p : wholly) add_groups(around, p, false, groups);
    for (const std::vector<Vertex>& group : groups) link_copies(edit_, group);
    made_ += groups.size() - gently.size() - wholly.size();
    return groups;
  }

  // Points with copies at edges that were non-manifold and now have two triangles on the same points.
  std::vector<Vertex> points_of_pairs() {
    Neighbourhood around(m_);
    std::vector<Vertex> found, points, others;
    std::vector<Face> faces;
    for (Halfedge h : were_nonmanifold_) {
      if (around.edge(h).faces() != 2) continue;
      around.faces_at(h, faces);
      if (corner_count(m_, faces[0]) != 3) continue;
      points_of_face(around, faces[0], points);
      points_of_face(around, faces[1], others);
      std::sort(points.begin(), points.end());
      std::sort(others.begin(), others.end());
      if (points != others) continue;
      for (Vertex p : points)
        if (has_copies(m_, p)) found.push_back(p);
    }
    sort_unique(found);
    return found;
  }

  void add_groups(Neighbourhood& around, Vertex p, bool keeps_misoriented, Groups& groups) {
    std::vector<Vertex> copies;
    for_each_copy(m_, p, [&](Vertex copy) { copies.push_back(copy); });
    std::sort(copies.begin(), copies.end());
    DisjointSets sets(copies.size());
    const Star star = around.star(p);
    for (const StarEdge& e : star.edges) {
      const auto corner = [&](std::uint32_t i) { return star.corners[star.sides[e.first_side + i] / 2]; };
      if (e.faces.is_misoriented()) {
        if (keeps_misoriented)
          sets.join(place_in(copies, m_.from(corner(0))), place_in(copies, m_.from(corner(1))));
        else
          cut_ends_.push_back(e.neighbour);
      }
      if (e.faces.is_nonmanifold())
        for (std::uint32_t i = 0; i < e.faces.faces(); ++i) were_nonmanifold_.push_back(side(star, e.first_side + i));
    }
    std::vector<std::uint32_t> group_of(copies.size(), no_index);
    for (std::uint32_t i = 0; i < copies.size(); ++i) {
      std::uint32_t& group = group_of[sets.root(i)];
      if (group == no_index) {
        group = static_cast<std::uint32_t>(groups.size());
        groups.emplace_back();
      }
      groups[group].push_back(copies[i]);
    }
  }

  bool has_neighbour_with_copies(Vertex v) const {
    if (m_.is_isolated(v)) return false;
    for (Vertex end : neighbours(m_, v))
      if (has_copies(m_, end)) return true;
    return false;
  }
  static std::uint32_t place_in(const std::vector<Vertex>& copies, Vertex v) {
    return static_cast<std::uint32_t>(std::lower_bound(copies.begin(), copies.end(), v) - copies.begin());
  }
  Halfedge side(const Star& star, std::uint32_t i) const {
    const Halfedge corner = star.corners[star.sides[i] / 2];
    return (star.sides[i] & 1u) != 0 ? m_.prev(corner) : corner;
  }

  void find_what_is_next(const std::vector<Vertex>& parts) {
    Neighbourhood around(m_);
    next_gently = std::move(cut_ends_);
    const auto is_nonmanifold = row_of(ProblemKind::nonmanifold_vertex).vertex;
    for (Vertex p : parts)
      if (m_.is_alive(p) && is_nonmanifold(around, around.point(p))) next_wholly.push_back(around.point(p));
    for (Halfedge h : were_nonmanifold_) {
      if (!m_.is_alive(h) || !around.edge(h).is_misoriented()) continue;
      for (Vertex v : {m_.from(h), m_.to(h)})
        if (has_copies(m_, v)) next_wholly.push_back(around.point(v));
    }
    sort_unique(next_wholly);
  }

  Edit& edit_;
  const Mesh& m_;
  std::size_t made_ = 0;
  std::vector<Halfedge> were_nonmanifold_;  // sides of such edges
  std::vector<Vertex> cut_ends_;            // the other ends of misoriented edges that were cut
};

// Those that are non-manifold, and in none of the others.
void keep_nonmanifold(const Mesh& m, std::vector<Vertex>& points, const std::vector<Vertex>& others) {
  Neighbourhood around(m);
  const auto is_nonmanifold = row_of(ProblemKind::nonmanifold_vertex).vertex;
  std::erase_if(points, [&](Vertex p) { return !m.is_alive(p); });
  for (Vertex& p : points) p = around.point(p);
  sort_unique(points);
  std::erase_if(points, [&](Vertex p) {
    return std::binary_search(others.begin(), others.end(), p) || !is_nonmanifold(around, p);
  });
}

}  // namespace

std::size_t detach_points(Edit& edit, std::vector<Vertex> gently, std::vector<Vertex> wholly) {
  const Mesh& m = edit.mesh();
  std::erase_if(wholly, [&](Vertex p) { return !m.is_alive(p); });
  for (Vertex& p : wholly) p = point(m, p);
  sort_unique(wholly);
  std::size_t made = 0;
  // Every turn splits a point, or leaves it to the next one to split wholly.
  for (;;) {
    keep_nonmanifold(m, gently, wholly);
    if (gently.empty() && wholly.empty()) return made;
    Detaching turn(edit);
    made += turn.take_apart(gently, std::move(wholly));
    gently = std::move(turn.next_gently);
    wholly = std::move(turn.next_wholly);
  }
}

AlgorithmResult detach_nonmanifold(Edit& edit, const AlgorithmInput&, Progress& progress) {
  const Mesh& m = edit.mesh();
  std::vector<Vertex> points = nonmanifold_points(m);
  AlgorithmResult result;
  result.changed = points.size();
  std::size_t made = 0;
  while (!points.empty() && progress.go_on()) {  // splitting some may expose others
    made += detach_points(edit, std::move(points));
    points = nonmanifold_points(m);
  }
  result.text = count_text(made, "One point was added to take the surface apart",
                           "# points were added to take the surface apart", "曲面を切り離すため点を # 個追加しました");
  const std::string n = std::to_string(result.changed);
  if (made > 0) {
    result.text.en += " at " + n + (result.changed == 1 ? " place" : " places");
    result.text.ja += "（" + n + " か所）";
  }
  result.text.en += ".";
  result.text.ja += "。";
  return result;
}

}  // namespace ryosen
