#include "tests/support/core/oracle/local_operators.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace ryosen::oracle {

bool is_legal(const Facts& before, const LocalOutcome& outcome) {
  const Facts after = facts_of(outcome.list);
  for (const Violation& found : after.violations)
    if (!std::binary_search(before.violations.begin(), before.violations.end(), found)) return false;
  return !after.vertex_twice_in_face && !after.point_twice_in_face && after.reads_back &&
         after.nonmanifold == before.nonmanifold && after.misoriented == before.misoriented &&
         after.equal_faces == before.equal_faces && after.groups == before.groups &&
         after.vertices - before.vertices == outcome.vertices && after.edges - before.edges == outcome.edges &&
         after.faces - before.faces == outcome.faces && after.boundary_loops == before.boundary_loops &&
         after.components == before.components && after.isolated_vertices == before.isolated_vertices;
}

namespace {

int add_vertex(CopyList& copies) {
  copies.list.live.push_back(1);
  copies.point_of.push_back(copies.list.size() - 1);
  return copies.list.size() - 1;
}

void remove_vertex(CopyList& copies, int v) {
  copies.list.live[static_cast<std::size_t>(v)] = 0;
  for (Corners& face : copies.list.faces) face.erase(std::remove(face.begin(), face.end(), v), face.end());
}

int count_of(const Corners& face) { return static_cast<int>(face.size()); }

}  // namespace

LocalOutcomes poke(CopyList copies, int f) {
  const Corners face = copies.list.faces[f];
  const int m = add_vertex(copies), n = count_of(face);
  copies.list.faces[f] = {face[0], face[1], m};
  for (int i = 1; i < n; ++i) copies.list.faces.push_back({face[i], face[(i + 1) % n], m});
  return {{copies, 1, n, n - 1}};
}

LocalOutcomes extrude(CopyList copies, int f) {
  const Corners face = copies.list.faces[f];
  const int n = count_of(face);
  Corners top;
  for (int i = 0; i < n; ++i) top.push_back(add_vertex(copies));
  copies.list.faces[f] = top;
  for (int i = 0; i < n; ++i) copies.list.faces.push_back({face[i], face[(i + 1) % n], top[(i + 1) % n], top[i]});
  return {{copies, n, 2 * n, n}};
}

namespace {

// All ways to cut a face into triangles.
void cut(const Corners& face, std::vector<Corners>& made, const std::function<void()>& visit) {
  std::vector<Corners> open{face};
  const std::function<void(std::vector<Corners>)> go = [&](std::vector<Corners> rest) {
    while (!rest.empty() && rest.back().size() < 3) rest.pop_back();
    if (rest.empty()) return visit();
    const Corners part = rest.back();
    rest.pop_back();
    const std::size_t n = part.size();
    for (std::size_t k = 1; k + 1 < n; ++k) {
      made.push_back({part[0], part[k], part[n - 1]});
      std::vector<Corners> further = rest;
      further.emplace_back(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      further.emplace_back(part.begin() + static_cast<std::ptrdiff_t>(k), part.end());
      go(further);
      made.pop_back();
    }
  };
  go(open);
}

}  // namespace

LocalOutcomes triangulate(const CopyList& copies, int f) {
  const Corners face = copies.list.faces[f];
  if (face.size() < 4) return {};
  LocalOutcomes all;
  std::vector<Corners> made;
  cut(face, made, [&] {
    CopyList after = copies;
    after.list.faces[f] = made[0];
    after.list.faces.insert(after.list.faces.end(), made.begin() + 1, made.end());
    all.push_back({after, 0, count_of(face) - 3, count_of(face) - 3});
  });
  return all;
}

namespace {

std::set<Pair> directed(const Corners& face) {
  std::set<Pair> sides;
  for (std::size_t i = 0; i < face.size(); ++i) sides.emplace(face[i], face[(i + 1) % face.size()]);
  return sides;
}

std::map<int, std::set<int>> neighbours_of(const PolygonList& list) {
  std::map<int, std::set<int>> found;
  for (const Corners& face : list.faces)
    for (const auto& [a, b] : directed(face)) found[a].insert(b), found[b].insert(a);
  return found;
}

// The pairs from a-b on through vertices with two neighbours, away from a.
void add_chain(const std::map<int, std::set<int>>& neighbours, int a, int b, std::set<Pair>& taken,
               std::set<int>& inner) {
  taken.insert(std::minmax(a, b));
  while (neighbours.at(b).size() == 2) {
    inner.insert(b);
    int next = -1;
    for (int x : neighbours.at(b))
      if (x != a) next = x;
    a = b;
    b = next;
    if (!taken.insert(std::minmax(a, b)).second) return;
  }
}

// Some faces as one, without the pairs taken; none where what is left of them is not one simple list.
LocalOutcomes unite(CopyList copies, const std::vector<int>& faces, const std::set<Pair>& taken,
                    const std::set<int>& gone) {
  std::map<int, int> next;
  std::size_t sides = 0;
  for (int f : faces) {
    for (const auto& [a, b] : directed(copies.list.faces[f])) {
      if (taken.contains(std::minmax(a, b))) continue;
      if (next.contains(a)) return {};
      next[a] = b;
      ++sides;
    }
  }
  if (next.empty()) return {};
  Corners united;
  for (int v = next.begin()->first; united.size() <= sides;) {
    united.push_back(v);
    v = next[v];
    if (v == united[0]) break;
  }
  if (united.size() != sides || sides < 3) return {};
  for (int f : faces) copies.list.faces[f].clear();
  for (int v : gone) remove_vertex(copies, v);
  copies.list.faces[*std::min_element(faces.begin(), faces.end())] = united;
  return {
      {copies, -static_cast<int>(gone.size()), -static_cast<int>(taken.size()), 1 - static_cast<int>(faces.size())}};
}

}  // namespace

LocalOutcomes dissolve_edge(const CopyList& copies, int a, int b) {
  std::vector<int> faces;
  for (int f = 0; f < static_cast<int>(copies.list.faces.size()); ++f) {
    const std::set<Pair> sides = directed(copies.list.faces[f]);
    if (sides.contains({a, b}) || sides.contains({b, a})) faces.push_back(f);
  }
  if (faces.size() != 2) return {};
  const auto neighbours = neighbours_of(copies.list);
  std::set<Pair> taken;
  std::set<int> inner;
  add_chain(neighbours, a, b, taken, inner);
  add_chain(neighbours, b, a, taken, inner);
  return unite(copies, faces, taken, inner);
}

namespace {

// A vertex with two neighbours goes, and its pairs become one.
LocalOutcomes unite_pairs(CopyList copies, int v, const LocalOutcome& so_far) {
  remove_vertex(copies, v);
  for (const Corners& face : copies.list.faces)
    if (face.size() == 1 || face.size() == 2) return {};
  return {{copies, so_far.vertices - 1, so_far.edges - 1, so_far.faces}};
}

}  // namespace

LocalOutcomes dissolve_vertex(const CopyList& copies, int v, const Facts& before) {
  const auto neighbours = neighbours_of(copies.list);
  if (!neighbours.contains(v)) return {};
  if (neighbours.at(v).size() == 2) return unite_pairs(copies, v, {});
  std::vector<int> faces;
  std::map<int, int> at;  // faces at each neighbour of v
  for (int f = 0; f < static_cast<int>(copies.list.faces.size()); ++f) {
    bool is_at = false;
    for (const auto& [a, b] : directed(copies.list.faces[f])) {
      if (a == v) ++at[b], is_at = true;
      if (b == v) ++at[a], is_at = true;
    }
    if (is_at) faces.push_back(f);
  }
  std::set<Pair> taken;
  std::set<int> gone;
  bool is_inside = true;
  for (const auto& [x, count] : at) {
    if (count == 2)
      add_chain(neighbours, v, x, taken, gone);
    else
      is_inside = false;
  }
  if (is_inside) gone.insert(v);
  const LocalOutcomes united = unite(copies, faces, taken, gone);
  if (united.empty() || is_inside) return united;
  const LocalOutcomes shorter = unite_pairs(united[0].list, v, united[0]);
  return !shorter.empty() && is_legal(before, shorter[0]) ? shorter : united;
}

LocalOutcomes vertex_split(CopyList copies, int v, int left, int right) {
  std::map<int, std::pair<int, int>> face_after;  // by the neighbour: the face left of it and the neighbour beyond
  std::set<int> reached;
  for (int f = 0; f < static_cast<int>(copies.list.faces.size()); ++f) {
    const Corners& face = copies.list.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (face[i] != v) continue;
      const int before = face[(i + face.size() - 1) % face.size()];
      face_after[face[(i + 1) % face.size()]] = {f, before};
      reached.insert(before);
    }
  }
  int first = -1;  // of the fan, where it is open
  for (const auto& [x, beyond] : face_after)
    if (!reached.contains(x)) first = x;
  if (first < 0 && (left < 0 || right < 0)) return {};
  std::vector<int> taken;
  int x = left < 0 ? first : left;
  for (std::size_t steps = 0; x != right && steps <= 2 * face_after.size() + 2; ++steps) {
    if (face_after.contains(x)) {
      taken.push_back(face_after[x].first);
      x = face_after[x].second;
    } else if (right < 0) {
      break;
    } else {
      x = first;
    }
  }
  const int m = add_vertex(copies);
  for (int f : taken) std::replace(copies.list.faces[f].begin(), copies.list.faces[f].end(), v, m);
  if (left >= 0) copies.list.faces.push_back({v, left, m});
  if (right >= 0) copies.list.faces.push_back({v, m, right});
  const int triangles = (left >= 0) + (right >= 0);
  return {{copies, 1, 1 + triangles, triangles}};
}

}  // namespace ryosen::oracle
