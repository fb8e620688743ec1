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

std::vector<Vertex> copies_of(const Mesh& m, Vertex p) {
  std::vector<Vertex> copies;
  for_each_copy(m, p, [&](Vertex copy) { copies.push_back(copy); });
  std::sort(copies.begin(), copies.end());
  return copies;
}

// Partitions the copies into groups that stay together, the group of the lowest copy first.
std::vector<std::vector<Vertex>> groups_at(const Mesh& m, const std::vector<Vertex>& copies, bool keep_misoriented) {
  DisjointSets sets(copies.size());
  const auto place_of = [&](Vertex v) {
    return static_cast<std::uint32_t>(std::lower_bound(copies.begin(), copies.end(), v) - copies.begin());
  };
  for (std::uint32_t i = 0; keep_misoriented && i < copies.size(); ++i) {
    if (m.is_isolated(copies[i])) continue;
    for (Halfedge h : outgoing(m, copies[i])) {
      if (!point_edge(m, h).is_misoriented()) continue;
      for (Halfedge sheet : sheets_between(m, m.from(h), m.to(h))) sets.join(i, place_of(m.from(sheet)));
    }
  }
  std::vector<std::vector<Vertex>> groups;
  std::vector<std::uint32_t> group_of(copies.size(), no_index);
  for (std::uint32_t i = 0; i < copies.size(); ++i) {
    std::uint32_t& group = group_of[sets.root(i)];
    if (group == no_index) {
      group = static_cast<std::uint32_t>(groups.size());
      groups.emplace_back();
    }
    groups[group].push_back(copies[i]);
  }
  return groups;
}

// Returns the resulting points, old and new.
std::vector<Vertex> take_apart(Edit& edit, const std::vector<Vertex>& points, bool keep_misoriented) {
  const Mesh& m = edit.mesh();
  Sheets sheets(edit);
  for (Vertex p : points)
    for (Vertex copy : copies_of(m, p)) sheets.separate(copy);
  // Find all groups before splitting any point: edges are classified on the original points.
  std::vector<std::vector<Vertex>> groups;
  std::vector<Vertex> parts;
  for (Vertex p : points)
    for (std::vector<Vertex>& group : groups_at(m, copies_of(m, p), keep_misoriented)) {
      parts.push_back(group[0]);
      groups.push_back(std::move(group));
    }
  for (const std::vector<Vertex>& group : groups) link_copies(edit, group);
  sheets.settle(parts);
  return parts;
}

void keep_nonmanifold(const Mesh& m, std::vector<Vertex>& points) {
  Neighbourhood around(m);
  const auto is_nonmanifold = row_of(ProblemKind::nonmanifold_vertex).vertex;
  for (Vertex& p : points)
    if (m.is_alive(p)) p = around.point(p);
  sort_unique(points);
  std::erase_if(points, [&](Vertex p) { return !m.is_alive(p) || !is_nonmanifold(around, p); });
}

}  // namespace

std::size_t detach_points(Edit& edit, std::vector<Vertex> points) {
  const Mesh& m = edit.mesh();
  constexpr int most_passes = 8;  // from the second on, every fan is split off
  std::size_t made = 0;
  for (int pass = 0; pass < most_passes; ++pass) {
    keep_nonmanifold(m, points);
    if (points.empty()) break;
    const std::size_t before = points.size();
    points = take_apart(edit, points, pass == 0);
    made += points.size() - before;
  }
  return made;
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
