#include "tests/support/core/oracle/complex.h"

#include <algorithm>
#include <map>
#include <set>

#include "tests/support/core/oracle/figures.h"

namespace ryosen::oracle {
namespace {

std::vector<int> corner_owners(const LoopList& loops) {
  std::vector<int> owners;
  for (std::size_t l = 0; l < loops.copies.list.faces.size(); ++l)
    owners.insert(owners.end(), loops.copies.list.faces[l].size(), loops.face_of[l]);
  return owners;
}

// Corners of one vertex that lie in one fan, joined through edges with a face on either side.
Groups fans_of(const Sides& sides) {
  Groups groups(sides.corners());
  for (int pair = 0; pair < sides.pairs(); ++pair) {
    const Side& first = *sides.begin(pair);
    for (const Side* s = sides.begin(pair); s != sides.end(pair); ++s)
      for (int end : {first.lo, first.hi}) groups.join(sides.corner_id_at(*s, end), sides.corner_id_at(first, end));
  }
  return groups;
}

void find_edge_faults(const Complex& complex, const Sides& sides, ComplexFacts& facts) {
  std::set<Pair> pairs;
  for (int pair = 0; pair < sides.pairs(); ++pair) {
    const Side& first = *sides.begin(pair);
    pairs.emplace(first.lo, first.hi);
    const auto ups = std::count_if(sides.begin(pair), sides.end(pair), [](const Side& s) { return s.up; });
    if (ups > 1) facts.faults.emplace_back(Fault::directed_edge_twice, first.lo, first.hi);
    if (sides.count(pair) - ups > 1) facts.faults.emplace_back(Fault::directed_edge_twice, first.hi, first.lo);
  }
  for (const Pair& wire : complex.wires)
    if (wire.first == wire.second || !pairs.insert(wire).second)
      facts.faults.emplace_back(Fault::pair_twice, wire.first, wire.second);
  facts.edges = static_cast<int>(pairs.size());
}

std::vector<Pair> equal_faces_of(const Complex& complex) {
  std::map<std::set<int>, std::vector<int>> on;
  for (int f = 0; f < static_cast<int>(complex.faces.size()); ++f) {
    std::set<int> corners;
    for (const Corners& loop : complex.faces[f]) corners.insert(loop.begin(), loop.end());
    if (!corners.empty()) on[corners].push_back(f);
  }
  std::vector<Pair> equal;
  for (const auto& [corners, faces] : on)
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::size_t k = i + 1; k < faces.size(); ++k) equal.emplace_back(faces[i], faces[k]);
  std::sort(equal.begin(), equal.end());
  return equal;
}

void look_at_points(const Complex& complex, ComplexFacts& facts) {
  const Complex points = on_points(complex);
  const LoopList loops = loops_of(points);
  const Sides sides(loops.copies.list);
  std::set<Pair> pairs;
  for (int pair = 0; pair < sides.pairs(); ++pair) {
    const Side& first = *sides.begin(pair);
    pairs.emplace(first.lo, first.hi);
    if (sides.count(pair) > 2) facts.nonmanifold.emplace_back(first.lo, first.hi, sides.count(pair));
    if (is_misoriented(sides, pair)) facts.misoriented.emplace_back(first.lo, first.hi);
  }
  for (const Pair& wire : points.wires)
    if (!pairs.insert(wire).second) facts.doubled_wires.push_back(wire);
  std::sort(facts.doubled_wires.begin(), facts.doubled_wires.end());
  facts.equal_faces = equal_faces_of(points);
  for (const auto& face : points.faces) facts.loops_on_points &= face.empty() || bridges_in(face) >= 0;
  const LoopList single = loops_of(separated(complex));
  if (facts.loops_on_points) facts.reads_back = fans_as_read(loops.copies.list) == fans_as_listed(single.copies.list);
  std::set<Pair> used;
  for (const Corners& loop : single.copies.list.faces)
    for (int v : loop) used.emplace(single.copies.point_of[v], v);
  for (const auto& [point, copy] : used) {
    if (facts.groups.empty() || facts.groups.back().first != point) facts.groups.push_back({point, {}});
    facts.groups.back().second.push_back(copy);
  }
  std::erase_if(facts.groups, [](const auto& group) { return group.second.size() < 2; });
}

int count_components(const Complex& complex) {
  Groups groups(complex.size());
  for (const auto& face : complex.faces)
    for (const Corners& loop : face)
      for (int v : loop) groups.join(v, face[0][0]);
  for (const Pair& wire : complex.wires) groups.join(wire.first, wire.second);
  int count = 0;
  for (int v = 0; v < complex.size(); ++v) count += complex.live[v] && groups.root(v) == v;
  return count;
}

}  // namespace

std::string to_text(const Complex& complex) {
  std::string text = std::to_string(complex.size()) + " vertices, faces";
  for (std::size_t f = 0; f < complex.faces.size(); ++f) {
    if (complex.faces[f].empty()) continue;
    text += " f" + std::to_string(f);
    for (const Corners& loop : complex.faces[f]) {
      text += "(";
      for (std::size_t i = 0; i < loop.size(); ++i) text += (i ? " " : "") + std::to_string(loop[i]);
      text += ")";
    }
  }
  text += complex.wires.empty() ? "" : ", wires";
  for (const auto& [a, b] : complex.wires) text += " " + std::to_string(a) + "-" + std::to_string(b);
  for (int v = 0; v < complex.size(); ++v) {
    if (!complex.live[v]) text += ", without " + std::to_string(v);
    if (complex.live[v] && complex.point_of[v] != v)
      text += ", " + std::to_string(v) + " copy of " + std::to_string(complex.point_of[v]);
  }
  return text;
}

LoopList loops_of(const Complex& complex) {
  LoopList loops{{{complex.live, {}}, complex.point_of}, {}};
  for (int f = 0; f < static_cast<int>(complex.faces.size()); ++f)
    for (const Corners& loop : complex.faces[f]) {
      loops.copies.list.faces.push_back(loop);
      loops.face_of.push_back(f);
    }
  return loops;
}

Complex separated(const Complex& complex) {
  const LoopList loops = loops_of(complex);
  const Sides sides(loops.copies.list);
  Groups fans = fans_of(sides);
  const std::vector<int> owner = corner_owners(loops);
  std::map<Pair, int> lowest;  // face, by vertex and fan
  int corner = 0;
  for (const Corners& loop : loops.copies.list.faces)
    for (int v : loop) {
      int& face = lowest.try_emplace({v, fans.root(corner)}, owner[corner]).first->second;
      face = std::min(face, owner[corner++]);
    }
  std::map<int, std::vector<Pair>> fans_at;  // by vertex: lowest face, fan
  for (const auto& [key, face] : lowest) fans_at[key.first].emplace_back(face, key.second);
  Complex result = complex;
  std::map<Pair, int> number;
  for (auto& [v, at] : fans_at) {
    std::sort(at.begin(), at.end());
    for (std::size_t k = 0; k < at.size(); ++k) {
      if (k > 0) {
        result.live.push_back(1);
        result.point_of.push_back(complex.point_of[v]);
      }
      number[{v, at[k].second}] = k == 0 ? v : result.size() - 1;
    }
  }
  corner = 0;
  for (auto& face : result.faces)
    for (Corners& loop : face)
      for (int& v : loop) v = number.at({v, fans.root(corner++)});
  return result;
}

Complex on_points(const Complex& complex) {
  Complex points = complex;
  std::fill(points.live.begin(), points.live.end(), char{0});
  for (int v = 0; v < complex.size(); ++v) {
    points.point_of[v] = v;
    if (complex.live[v]) points.live[complex.point_of[v]] = 1;
  }
  for (auto& face : points.faces)
    for (Corners& loop : face)
      for (int& v : loop) v = complex.point_of[v];
  for (auto& [a, b] : points.wires) {
    const int p = complex.point_of[a], q = complex.point_of[b];
    a = std::min(p, q);
    b = std::max(p, q);
  }
  return points;
}

int bridges_in(std::vector<Corners> loops) {
  int bridges = 0;
  for (std::size_t l = 0; l < loops.size();) {
    const Corners loop = loops[l];
    const int n = static_cast<int>(loop.size());
    bool cut = false;
    for (int i = 0; i < n && !cut; ++i)
      for (int j = i + 1; j < n && !cut; ++j) {
        if (loop[j] != loop[(i + 1) % n] || loop[(j + 1) % n] != loop[i]) continue;
        cut = true;
        loops[l].assign(loop.begin() + i + 1, loop.begin() + j);
        Corners rest(loop.begin() + j + 1, loop.end());
        rest.insert(rest.end(), loop.begin(), loop.begin() + i);
        loops.push_back(rest);
        ++bridges;
      }
    l += !cut;
  }
  std::set<int> seen;
  for (const Corners& loop : loops) {
    if (loop.size() < 3) return -1;
    for (int v : loop)
      if (!seen.insert(v).second) return -1;
  }
  return bridges;
}

std::vector<Corners> normal_form(std::vector<Corners> loops) {
  for (Corners& loop : loops) {
    Corners smallest = loop;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      std::rotate(loop.begin(), loop.begin() + 1, loop.end());
      smallest = std::min(smallest, loop);
    }
    loop = smallest;
  }
  std::sort(loops.begin(), loops.end());
  return loops;
}

Shape shape_of(const Complex& complex) {
  Shape shape;
  for (int v = 0; v < complex.size(); ++v)
    if (complex.live[v]) shape.live.push_back(v);
  for (const auto& face : complex.faces)
    if (!face.empty()) shape.faces.push_back(normal_form(face));
  std::sort(shape.faces.begin(), shape.faces.end());
  shape.wires = complex.wires;
  std::sort(shape.wires.begin(), shape.wires.end());
  return shape;
}

ComplexFacts facts_of(const Complex& complex) {
  ComplexFacts facts;
  const LoopList loops = loops_of(complex);
  const Sides sides(loops.copies.list);
  find_edge_faults(complex, sides, facts);
  bool simple = true;
  for (int f = 0; f < static_cast<int>(complex.faces.size()); ++f) {
    if (complex.faces[f].empty()) continue;
    ++facts.faces;
    facts.rings += static_cast<int>(complex.faces[f].size()) - 1;
    const int bridges = bridges_in(complex.faces[f]);
    facts.bridges += std::max(bridges, 0);
    if (bridges < 0) facts.faults.emplace_back(Fault::loops, f, -1);
    simple = simple && bridges >= 0;
  }
  for (const auto& [f, g] : equal_faces_of(complex)) facts.faults.emplace_back(Fault::equal_faces, f, g);
  const std::vector<int> fans = fans_per_vertex(loops.copies.list, sides);
  std::vector<char> used(complex.live.size(), 0);
  for (const Corners& loop : loops.copies.list.faces)
    for (int v : loop) used[v] = 1;
  for (const auto& [a, b] : complex.wires) used[a] = used[b] = 1;
  for (int v = 0; v < complex.size(); ++v) {
    facts.vertices += complex.live[v];
    facts.isolated += complex.live[v] && !used[v];
    if (fans[v] > 1) facts.faults.emplace_back(Fault::several_fans, v, -1);
  }
  std::sort(facts.faults.begin(), facts.faults.end());
  facts.components = count_components(complex);
  if (!simple) return facts;
  facts.boundary_loops = boundary_loops(loops.copies.list, sides);
  look_at_points(complex, facts);
  return facts;
}

std::vector<std::pair<int, bool>> sides_between(const Complex& complex, int a, int b) {
  std::vector<std::pair<int, bool>> sides;
  for (int f = 0; f < static_cast<int>(complex.faces.size()); ++f)
    for (const Corners& loop : complex.faces[f])
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int from = loop[i], to = loop[(i + 1) % loop.size()];
        if (from == a && to == b) sides.emplace_back(f, true);
        if (from == b && to == a) sides.emplace_back(f, false);
      }
  return sides;
}

bool is_wire(const Complex& complex, int a, int b) {
  return std::find(complex.wires.begin(), complex.wires.end(), Pair(std::minmax(a, b))) != complex.wires.end();
}

bool has_gap(const Complex& complex, int v) {
  bool has_face = false;
  for (const Pair& wire : complex.wires)
    if (wire.first == v || wire.second == v) return true;
  for (const auto& face : complex.faces)
    for (const Corners& loop : face)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (loop[i] != v) continue;
        has_face = true;
        for (std::size_t k : {i + 1, i + loop.size() - 1})
          if (sides_between(complex, v, loop[k % loop.size()]).size() == 1) return true;
      }
  return !has_face;
}

}  // namespace ryosen::oracle
