#include "tests/support/core/oracle/operators.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "tests/support/core/oracle/figures.h"

#include "tests/support/core/oracle/exchange.h"

namespace ryosen::oracle {
namespace {

// The pair of two vertices, or -1.
int find_pair(const Sides& sides, int a, int b) {
  for (int pair = 0; pair < sides.pairs(); ++pair)
    if (sides.begin(pair)->lo == std::min(a, b) && sides.begin(pair)->hi == std::max(a, b)) return pair;
  return -1;
}

int copies_of(const CopyList& list, int point) {
  return static_cast<int>(std::count(list.point_of.begin(), list.point_of.end(), point));
}

void replace_vertex(PolygonList& list, int gone, int stays) {
  for (Corners& face : list.faces) {
    std::replace(face.begin(), face.end(), gone, stays);
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
    if (face.size() < 3) face.clear();
  }
  list.live[gone] = 0;
}

// face (a, b, c, ..., z) and the face (b, a, d, ..., q) beyond the edge; forward loses b and gains d, back loses a and
// gains q. Told from either side of the edge it is the same rule.
Corners swapped(const Corners& face, const Corners& beyond, bool back) {
  Corners result;
  if (back) {
    result.assign({face.back(), beyond.back()});
    result.insert(result.end(), face.begin() + 1, face.end() - 1);
  } else {
    result.assign(face.begin() + 2, face.end());
    result.insert(result.end(), {face[0], beyond[2]});
  }
  return result;
}

void swap_faces(PolygonList& list, const Sides& sides, int pair, bool back) {
  const Side &s = sides.begin(pair)[0], &t = sides.begin(pair)[1];
  const Corners f = from_corner(list.faces[s.face], s.corner), g = from_corner(list.faces[t.face], t.corner);
  list.faces[s.face] = swapped(f, g, back);
  list.faces[t.face] = swapped(g, f, back);
}

CopyList split_on_points(const CopyList& before, const PolygonList& points, const Sides& sides, int pair, int from) {
  PolygonList after = points;
  after.live.resize(static_cast<std::size_t>(before.list.size()), 0);  // numbers of copies are taken
  const int middle = before.list.size();
  after.live.push_back(1);
  for (bool left : {true, false}) {
    for (const Side* s = sides.begin(pair); s != sides.end(pair); ++s) {
      const Corners face = from_corner(points.faces[s->face], s->corner);
      if ((face[0] == from) != left) continue;
      if (face.size() > 3) {
        after.faces[s->face] = face;
        after.faces[s->face].insert(after.faces[s->face].begin() + 1, middle);
      } else {
        after.faces[s->face] = left ? Corners{face[0], middle, face[2]} : Corners{middle, face[1], face[2]};
        after.faces.push_back(left ? Corners{middle, face[1], face[2]} : Corners{face[0], middle, face[2]});
      }
    }
  }
  return read_copies(after);
}

// One or two sides that are one edge of the list of copies.
bool is_one_edge(const Sides& sides, int pair) { return sides.count(pair) == 1 || is_joined(sides, pair); }

bool has_repeat(const Corners& face) {
  for (auto corner = face.begin(); corner != face.end(); ++corner)
    if (std::find(face.begin(), corner, *corner) != corner) return true;
  return false;
}

void find_violations(const PolygonList& list, const Sides& sides, Facts& facts) {
  for (int f = 0; f < static_cast<int>(list.faces.size()); ++f)
    if (has_repeat(list.faces[f])) facts.violations.push_back({Rule::corner_twice, f, -1});
  for (int pair = 0; pair < sides.pairs(); ++pair) {
    const Side& first = *sides.begin(pair);
    const int ups = static_cast<int>(std::count_if(sides.begin(pair), sides.end(pair), [](auto& s) { return s.up; }));
    if (ups > 1) facts.violations.push_back({Rule::directed_edge_twice, first.lo, first.hi});
    if (sides.count(pair) - ups > 1) facts.violations.push_back({Rule::directed_edge_twice, first.hi, first.lo});
  }
  const std::vector<int> fans = fans_per_vertex(list, sides);
  for (int v = 0; v < list.size(); ++v)
    if (fans[v] > 1) facts.violations.push_back({Rule::several_fans, v, -1});
  for (auto [f, g] : equal_faces(list)) facts.violations.push_back({Rule::equal_faces, f, g});
  std::sort(facts.violations.begin(), facts.violations.end());
}

void look_at_points(const CopyList& copies, Facts& facts) {
  const PolygonList points = points_of(copies);
  const Sides sides(points);
  for (int pair = 0; pair < sides.pairs(); ++pair) {
    const Side& first = *sides.begin(pair);
    if (sides.count(pair) > 2) facts.nonmanifold.emplace_back(first.lo, first.hi, sides.count(pair));
    if (is_misoriented(sides, pair)) facts.misoriented.emplace_back(first.lo, first.hi);
  }
  facts.equal_faces = equal_faces(points);
  for (const Corners& face : points.faces) facts.point_twice_in_face = facts.point_twice_in_face || has_repeat(face);
  if (!facts.point_twice_in_face) facts.reads_back = fans_as_read(points) == fans_as_listed(copies.list);
}

void group_copies(const CopyList& copies, Facts& facts) {
  std::set<std::pair<int, int>> used;  // point, copy
  for (const Corners& face : copies.list.faces)
    for (int v : face) used.emplace(copies.point_of[v], v);
  for (auto [point, copy] : used) {
    if (facts.groups.empty() || facts.groups.back().first != point) facts.groups.push_back({point, {}});
    facts.groups.back().second.push_back(copy);
  }
  std::erase_if(facts.groups, [](const auto& group) { return group.second.size() < 2; });
}

// a read as b in everything that is named by points or copies. A point and its first copy have one number, and only a
// point without further copies goes, so one exchange serves both.
void read_as(Facts& facts, int gone, int stays) {
  const auto exchange = [=](int& v) {
    if (v == gone) v = stays;
  };
  for (auto& [rule, first, second] : facts.violations) {
    if (rule == Rule::directed_edge_twice || rule == Rule::several_fans) {
      exchange(first);
      exchange(second);
    }
  }
  std::sort(facts.violations.begin(), facts.violations.end());
  exchange_points(facts.nonmanifold, facts.misoriented, exchange);
}

// Two triangles at the edge with the same third point.
bool has_same_apex(const PolygonList& points, const Sides& sides, int pair) {
  std::set<int> apexes;
  for (const Side* s = sides.begin(pair); s != sides.end(pair); ++s) {
    const Corners face = from_corner(points.faces[s->face], s->corner);
    if (face.size() == 3 && !apexes.insert(face[2]).second) return true;
  }
  return false;
}

}  // namespace

std::string to_text(const Operation& operation) {
  static const char* const names[] = {"collapse ", "swap ", "swap back ", "split "};
  return names[static_cast<int>(operation.kind)] + std::to_string(operation.from) + "-" + std::to_string(operation.to) +
         (operation.face < 0 ? "" : "@f" + std::to_string(operation.face));
}

std::vector<Operation> operations_of(const PolygonList& points) {
  std::vector<Operation> all;
  const Sides sides(points);
  for (int pair = 0; pair < sides.pairs(); ++pair) {
    const Side* end = is_one_edge(sides, pair) ? sides.begin(pair) + 1 : sides.end(pair);
    for (const Side* s = sides.begin(pair); s != end; ++s)
      for (Kind kind : {Kind::collapse, Kind::swap, Kind::swap_back, Kind::split})
        for (bool turned : {false, true})
          all.push_back({kind, turned ? s->hi : s->lo, turned ? s->lo : s->hi, s->face});
  }
  return all;
}

std::optional<CopyList> apply(const CopyList& before, const Operation& operation) {
  const PolygonList points = points_of(before);
  const Sides on_points(points);
  const int pair = find_pair(on_points, operation.from, operation.to);
  if (pair < 0) return std::nullopt;
  if (operation.kind == Kind::split) return split_on_points(before, points, on_points, pair, operation.from);
  if (!is_one_edge(on_points, pair)) return std::nullopt;

  const Side& side = *on_points.begin(pair);
  const Corners& face = before.list.faces[side.face];
  int a = face[on_points.corner_at(side, operation.from)], b = face[on_points.corner_at(side, operation.to)];
  CopyList after = before;
  if (operation.kind == Kind::collapse) {
    if (copies_of(before, operation.from) > 1) std::swap(a, b);
    replace_vertex(after.list, a, b);
  } else {
    if (on_points.count(pair) != 2) return std::nullopt;
    swap_faces(after.list, on_points, pair, operation.kind == Kind::swap_back);
  }
  return after;
}

Facts facts_of(const CopyList& copies) {
  Facts facts;
  const Sides sides(copies.list);
  for (const Corners& face : copies.list.faces) {
    facts.vertex_twice_in_face = facts.vertex_twice_in_face || has_repeat(face);
    facts.faces += !face.empty();
  }
  find_violations(copies.list, sides, facts);
  look_at_points(copies, facts);
  // A face that repeats a corner is a violation already; chains around it have no meaning.
  if (facts.vertex_twice_in_face) return facts;
  std::vector<char> used(copies.list.live.size(), 0);
  for (const Corners& face : copies.list.faces)
    for (int v : face) used[v] = 1;
  for (int v = 0; v < copies.list.size(); ++v) {
    facts.vertices += copies.list.live[v];
    facts.isolated_vertices += copies.list.live[v] && !used[v];
  }
  facts.edges = sides.pairs();
  facts.euler_characteristic = facts.vertices - facts.edges + facts.faces;
  facts.boundary_loops = boundary_loops(copies.list, sides);
  facts.components = components(copies.list, sides);
  group_copies(copies, facts);
  return facts;
}

Reasons compare_facts(Facts before, const Facts& after, Kind kind, int gone, int stays) {
  if (gone >= 0) read_as(before, gone, stays);
  Reasons reasons;
  static const char* const names[] = {"1 corner twice in a face: ", "1 directed edge twice: ", "1 more than one fan: ",
                                      "1 two faces on one vertex set: "};
  for (const Violation& found : after.violations) {
    if (std::binary_search(before.violations.begin(), before.violations.end(), found)) continue;
    const std::string second = found.second < 0 ? "" : " " + std::to_string(found.second);
    reasons.push_back(names[static_cast<int>(found.rule)] + std::to_string(found.first) + second);
  }
  if (after.point_twice_in_face) reasons.push_back("3 face visits a point twice");
  if (!after.reads_back) reasons.push_back("3 reading the points gives other fans");
  if (after.nonmanifold != before.nonmanifold) reasons.push_back("3 non-manifold edges change");
  if (after.misoriented != before.misoriented) reasons.push_back("3 misoriented edges change");
  if (after.equal_faces != before.equal_faces) reasons.push_back("3 faces on equal point sets change");
  if (after.vertex_twice_in_face) return reasons;

  const bool collapse = kind == Kind::collapse;
  const auto expect = [&](const char* name, int was, int is, int change) {
    if (is - was != change) reasons.push_back("2 " + std::string(name) + " " + std::to_string(is - was));
  };
  expect("V", before.vertices, after.vertices, collapse ? -1 : 0);
  if (!collapse) {
    expect("E", before.edges, after.edges, 0);
    expect("F", before.faces, after.faces, 0);
  }
  expect("Euler characteristic", before.euler_characteristic, after.euler_characteristic, 0);
  expect("boundary loops", before.boundary_loops, after.boundary_loops, 0);
  expect("components", before.components, after.components, 0);
  expect("isolated vertices", before.isolated_vertices, after.isolated_vertices, 0);
  if (after.groups != before.groups) reasons.push_back("3 groups of copies change");
  return reasons;
}

Judge::Judge(CopyList list)
    : list_(std::move(list)), points_(points_of(list_)), sides_(points_), facts_(facts_of(list_)) {}

Reasons Judge::reasons(const Operation& operation) const {
  const int pair = find_pair(sides_, operation.from, operation.to);
  if (pair < 0) return {"no such edge"};
  if (operation.kind == Kind::split)
    return has_same_apex(points_, sides_, pair) ? Reasons{"two triangles with the same third point"} : Reasons{};
  if (!is_one_edge(sides_, pair)) return {not_one_edge};
  if (operation.kind == Kind::collapse) {
    const bool from_stays = copies_of(list_, operation.from) > 1;
    if (from_stays && copies_of(list_, operation.to) > 1) return {"both points have copies"};
    const int gone = from_stays ? operation.to : operation.from;
    const int stays = from_stays ? operation.from : operation.to;
    return compare_facts(facts_, facts_of(*apply(list_, operation)), operation.kind, gone, stays);
  }
  if (sides_.count(pair) == 1) return {"boundary edge"};
  return compare_facts(facts_, facts_of(*apply(list_, operation)), operation.kind, -1, -1);
}

}  // namespace ryosen::oracle
