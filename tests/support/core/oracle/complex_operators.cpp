#include "tests/support/core/oracle/complex_operators.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>

namespace ryosen::oracle {
namespace {

int degree(const Corners& loop) { return static_cast<int>(loop.size()); }

const Corners& loop_at(const Complex& complex, Place place) {
  return complex.faces[static_cast<std::size_t>(place.face)][static_cast<std::size_t>(place.loop)];
}

// The side that runs from a to b.
std::optional<Place> find_side(const Complex& complex, int a, int b) {
  for (int f = 0; f < static_cast<int>(complex.faces.size()); ++f)
    for (int l = 0; l < static_cast<int>(complex.faces[f].size()); ++l) {
      const Corners& loop = complex.faces[f][l];
      for (int i = 0; i < degree(loop); ++i)
        if (loop[i] == a && loop[(i + 1) % degree(loop)] == b) return Place{f, l, i};
    }
  return std::nullopt;
}

void remove_wire(Complex& complex, int a, int b) { std::erase(complex.wires, Pair(std::minmax(a, b))); }

void drop_repeats(Corners& loop) {
  loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
  while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
}

int copies_of(const Complex& complex, int point) {
  int count = 0;
  for (int v = 0; v < complex.size(); ++v) count += complex.live[v] && complex.point_of[v] == point;
  return count;
}

// Whether the faces between two points, if any, are those of one edge.
bool is_one_edge(const Complex& complex, int a, int b) {
  const auto sides = sides_between(on_points(complex), complex.point_of[a], complex.point_of[b]);
  return sides.size() < 2 || (sides.size() == 2 && sides[0].second != sides[1].second);
}

// All loops but those of one place, given to one face or another in every way.
void distribute(const std::vector<Corners>& loops, std::vector<Corners> one, std::vector<Corners> other,
                std::size_t next,
                const std::function<void(const std::vector<Corners>&, const std::vector<Corners>&)>& visit) {
  if (next == loops.size()) return visit(one, other);
  one.push_back(loops[next]);
  distribute(loops, one, other, next + 1, visit);
  one.pop_back();
  other.push_back(loops[next]);
  distribute(loops, one, other, next + 1, visit);
}

}  // namespace

int vertex_at(const Complex& complex, Place place) { return loop_at(complex, place)[place.corner]; }
int next_vertex(const Complex& complex, Place place) {
  const Corners& loop = loop_at(complex, place);
  return loop[(place.corner + 1) % degree(loop)];
}

Outcomes collapse(const Complex& separated, int a, int b) {
  if (!is_one_edge(separated, a, b)) return {};
  if (copies_of(separated, separated.point_of[a]) > 1) std::swap(a, b);
  if (copies_of(separated, separated.point_of[a]) > 1) return {};
  Outcome outcome{separated, -1, 0, 0, 0, {{a, b}}};
  remove_wire(outcome.after, a, b);
  for (auto& face : outcome.after.faces) {
    for (Corners& loop : face) {
      std::replace(loop.begin(), loop.end(), a, b);
      drop_repeats(loop);
    }
    if (face.size() == 1 && face[0].size() < 3) face.clear();
  }
  for (Pair& wire : outcome.after.wires) {
    const int p = wire.first == a ? b : wire.first, q = wire.second == a ? b : wire.second;
    wire = std::minmax(p, q);
  }
  outcome.after.live[a] = 0;
  return {outcome};
}

Outcomes swap(const Complex& separated, Place side, bool back) {
  const int a = vertex_at(separated, side), b = next_vertex(separated, side);
  const auto other = find_side(separated, b, a);
  if (!other || other->face == side.face || !is_one_edge(separated, a, b)) return {};
  const Corners f = from_corner(loop_at(separated, side), side.corner);
  const Corners g = from_corner(loop_at(separated, *other), other->corner);
  const auto turned = [&](const Corners& face, const Corners& beyond) {
    Corners result;
    if (back) {
      result = {face.back(), beyond.back()};
      result.insert(result.end(), face.begin() + 1, face.end() - 1);
    } else {
      result.assign(face.begin() + 2, face.end());
      result.insert(result.end(), {face[0], beyond[2]});
    }
    return result;
  };
  Outcome outcome{separated};
  outcome.after.faces[side.face][side.loop] = turned(f, g);
  outcome.after.faces[other->face][other->loop] = turned(g, f);
  return {outcome};
}

Outcomes put_into_edge(const Complex& complex, int a, int b, int middle, bool cuts) {
  const Complex points = on_points(complex);
  Outcome outcome{points};
  Complex& after = outcome.after;
  while (after.size() <= middle) {
    after.live.push_back(0);
    after.point_of.push_back(after.size() - 1);
  }
  after.live[middle] = 1;
  std::set<int> apexes;
  for (int f = 0; f < static_cast<int>(points.faces.size()); ++f) {
    for (std::size_t l = 0; l < points.faces[f].size(); ++l) {
      const Corners& loop = points.faces[f][l];
      int times = 0;
      for (int i = 0; i < degree(loop); ++i) {
        const int p = loop[i], q = loop[(i + 1) % degree(loop)];
        if (!(p == a && q == b) && !(p == b && q == a)) continue;
        if (++times > 1) return {};  // a bridge
        const Corners turned = from_corner(loop, i);
        if (cuts && points.faces[f].size() == 1 && loop.size() == 3) {
          if (!apexes.insert(turned[2]).second) return {};
          after.faces[f] = {p == a ? Corners{p, middle, turned[2]} : Corners{middle, q, turned[2]}};
          after.faces.push_back({p == a ? Corners{middle, q, turned[2]} : Corners{p, middle, turned[2]}});
        } else {
          after.faces[f][l] = turned;
          after.faces[f][l].insert(after.faces[f][l].begin() + 1, middle);
        }
      }
    }
  }
  if (is_wire(after, a, b)) {
    remove_wire(after, a, b);
    after.wires.push_back(std::minmax(a, middle));
    after.wires.push_back(std::minmax(b, middle));
  }
  return {outcome};
}

Outcomes make_edge(const Complex& complex, int a, int b) {
  Outcome outcome{complex, 0, 1};
  outcome.after.wires.push_back(std::minmax(a, b));
  return {outcome};
}

Outcomes delete_edge(const Complex& complex, int a, int b) {
  if (!is_wire(complex, a, b)) return {};
  Outcome outcome{complex, 0, -1};
  remove_wire(outcome.after, a, b);
  return {outcome};
}

Outcomes make_loop(const Complex& complex, const Corners& cycle) {
  Outcome outcome{complex, 0, 0, 1};
  outcome.after.faces.push_back({cycle});
  for (int i = 0; i < degree(cycle); ++i) remove_wire(outcome.after, cycle[i], cycle[(i + 1) % degree(cycle)]);
  return {outcome};
}

Outcomes delete_loop(const Complex& complex, int face) {
  Outcome outcome{complex, 0, 0, -1, 1 - static_cast<int>(complex.faces[face].size())};
  outcome.after.faces[face].clear();
  for (const Corners& loop : complex.faces[face])
    for (int i = 0; i < degree(loop); ++i) {
      const int a = loop[i], b = loop[(i + 1) % degree(loop)];
      if (sides_between(outcome.after, a, b).empty() && !is_wire(outcome.after, a, b))
        outcome.after.wires.push_back(std::minmax(a, b));
    }
  return {outcome};
}

Outcomes separate_loop(const Complex& complex, Place a, Place b) {
  if (a.face != b.face || a.loop != b.loop || vertex_at(complex, a) == vertex_at(complex, b)) return {};
  Corners turned = from_corner(loop_at(complex, a), a.corner);
  const int n = degree(turned), k = (b.corner - a.corner + n) % n;
  const Corners near(turned.begin(), turned.begin() + k + 1);
  Corners far(turned.begin() + k, turned.end());
  far.push_back(turned[0]);
  std::vector<Corners> others = complex.faces[a.face];
  others.erase(others.begin() + a.loop);
  Outcomes outcomes;
  distribute(others, {near}, {far}, 0, [&](const auto& one, const auto& other) {
    Outcome outcome{complex, 0, 1, 1};
    outcome.after.faces[a.face] = one;
    outcome.after.faces.push_back(other);
    outcomes.push_back(outcome);
  });
  return outcomes;
}

Outcomes unite_loop(const Complex& complex, Place side) {
  const int a = vertex_at(complex, side), b = next_vertex(complex, side);
  const auto other = find_side(complex, b, a);
  if (!other || other->face == side.face || !is_one_edge(complex, a, b)) return {};
  Corners united = from_corner(loop_at(complex, side), side.corner + 1);
  const Corners beyond = from_corner(loop_at(complex, *other), other->corner + 2);
  united.insert(united.end(), beyond.begin(), beyond.end() - 2);
  Outcome outcome{complex, 0, -1, -1};
  std::vector<Corners> loops{united};
  for (const Place& place : {side, *other}) {
    for (int l = 0; l < static_cast<int>(complex.faces[place.face].size()); ++l)
      if (l != place.loop) loops.push_back(complex.faces[place.face][l]);
    outcome.after.faces[place.face].clear();
  }
  // A second edge that they share, be it on points alone, would become a bridge.
  const auto bridges_on_points = [&](std::vector<Corners> on_points) {
    for (Corners& loop : on_points)
      for (int& v : loop) v = complex.point_of[v];
    return bridges_in(on_points);
  };
  const int before = bridges_on_points(complex.faces[side.face]) + bridges_on_points(complex.faces[other->face]);
  if (bridges_on_points(loops) != before) return {};
  outcome.after.faces[std::min(side.face, other->face)] = loops;
  return {outcome};
}

Outcomes unite_edge(const Complex& complex, int v) {
  if (copies_of(complex, complex.point_of[v]) > 1) return {};
  std::set<int> neighbours;
  for (const auto& [a, b] : complex.wires)
    if (a == v || b == v) neighbours.insert(a == v ? b : a);
  Outcome outcome{complex, -1, -1};
  for (auto& face : outcome.after.faces)
    for (Corners& loop : face) {
      for (int i = 0; i < degree(loop); ++i)
        if (loop[i] == v)
          neighbours.insert({loop[(i + 1) % degree(loop)], loop[(i + degree(loop) - 1) % degree(loop)]});
      std::erase(loop, v);
    }
  if (neighbours.size() != 2) return {};
  const int a = *neighbours.begin(), b = *neighbours.rbegin();
  if (is_wire(complex, a, v)) {
    remove_wire(outcome.after, a, v);
    remove_wire(outcome.after, b, v);
    outcome.after.wires.push_back(std::minmax(a, b));
  }
  // The edge that is new must not be there, of whatever kind and on whatever copies.
  const Complex points = on_points(complex);
  const int p = complex.point_of[a], q = complex.point_of[b];
  if (!sides_between(points, p, q).empty() || is_wire(points, p, q)) return {};
  outcome.after.live[v] = 0;
  return {outcome};
}

Outcomes make_ring(const Complex& complex, Place side) {
  const auto other = find_side(complex, next_vertex(complex, side), vertex_at(complex, side));
  if (!other || other->face != side.face || other->loop != side.loop) return {};
  const Corners turned = from_corner(loop_at(complex, side), side.corner);
  const int n = degree(turned), k = (other->corner - side.corner + n) % n;
  Outcome outcome{complex, 0, -1, 0, 1};
  outcome.after.faces[side.face][side.loop] = Corners(turned.begin() + 1, turned.begin() + k);
  outcome.after.faces[side.face].push_back(Corners(turned.begin() + k + 1, turned.end()));
  return {outcome};
}

Outcomes unite_ring(const Complex& complex, Place a, Place b) {
  if (a.face != b.face || a.loop == b.loop) return {};
  const Corners one = from_corner(loop_at(complex, a), a.corner), other = from_corner(loop_at(complex, b), b.corner);
  Outcome outcome{complex, 0, 1, 0, -1};
  Corners united = one;
  united.push_back(one[0]);
  united.insert(united.end(), other.begin(), other.end());
  united.push_back(other[0]);
  outcome.after.faces[a.face][a.loop] = united;
  outcome.after.faces[b.face].erase(outcome.after.faces[b.face].begin() + b.loop);
  return {outcome};
}

Complex without_faces(const Complex& points, const std::vector<int>& faces, const std::vector<Pair>& wires) {
  Complex after = points;
  std::set<int> touched;
  for (int f : faces) {
    for (const Corners& loop : after.faces[f]) touched.insert(loop.begin(), loop.end());
    after.faces[f].clear();
  }
  for (const auto& [a, b] : wires) {
    remove_wire(after, a, b);
    touched.insert({a, b});
  }
  for (const auto& face : after.faces)
    for (const Corners& loop : face)
      for (int v : loop) touched.erase(v);
  for (const auto& [a, b] : after.wires) {
    touched.erase(a);
    touched.erase(b);
  }
  for (int v : touched) after.live[v] = 0;
  return after;
}

Outcomes make_face(const Complex& points, const Corners& corners) {
  Outcome outcome{points, 0, 0, 1};
  outcome.after.faces.push_back({corners});
  for (int i = 0; i < degree(corners); ++i) {
    const int a = corners[i], b = corners[(i + 1) % degree(corners)];
    outcome.edges += sides_between(points, a, b).empty() && !is_wire(points, a, b);
    remove_wire(outcome.after, a, b);
  }
  return {outcome};
}

Outcomes weld(const Complex& points, const std::vector<Pair>& gone_and_stays) {
  // Where a face has both it would meet one point twice, be it at a bridge.
  for (const auto& [gone, stays] : gone_and_stays)
    for (const auto& face : points.faces) {
      bool has_gone = false, has_other = false;
      for (const Corners& loop : face) {
        has_gone = has_gone || std::count(loop.begin(), loop.end(), gone);
        has_other = has_other || std::count(loop.begin(), loop.end(), stays);
      }
      if (has_gone && has_other) return {};
    }
  Outcome outcome{points};
  outcome.read_as = gone_and_stays;
  for (const auto& [gone, stays] : gone_and_stays) {
    for (auto& face : outcome.after.faces)
      for (Corners& loop : face) std::replace(loop.begin(), loop.end(), gone, stays);
    for (Pair& wire : outcome.after.wires) {
      const int p = wire.first == gone ? stays : wire.first, q = wire.second == gone ? stays : wire.second;
      wire = std::minmax(p, q);
    }
    outcome.after.live[gone] = 0;
  }
  return {outcome};
}

Complex detached(const Complex& points, const std::vector<int>& faces, int first_number) {
  std::set<int> inside, outside;
  for (int f = 0; f < static_cast<int>(points.faces.size()); ++f)
    for (const Corners& loop : points.faces[f])
      for (int v : loop) (std::count(faces.begin(), faces.end(), f) ? inside : outside).insert(v);
  Complex after = points;
  for (int v : inside) {
    if (!outside.contains(v)) continue;
    while (after.size() <= first_number) {
      after.live.push_back(0);
      after.point_of.push_back(after.size() - 1);
    }
    after.live[first_number] = 1;
    for (int f : faces)
      for (Corners& loop : after.faces[f]) std::replace(loop.begin(), loop.end(), v, first_number);
    ++first_number;
  }
  return after;
}

namespace {

std::vector<int> joined_faces(const Complex& points, int face, bool only_ordinary) {
  std::map<Pair, std::vector<std::pair<int, bool>>> at;
  for (int f = 0; f < static_cast<int>(points.faces.size()); ++f)
    for (const Corners& loop : points.faces[f])
      for (int i = 0; i < degree(loop); ++i) {
        const int a = loop[i], b = loop[(i + 1) % degree(loop)];
        at[std::minmax(a, b)].emplace_back(f, a < b);
      }
  std::set<int> found{face};
  for (std::size_t before = 0; before != found.size();) {
    before = found.size();
    for (const auto& [pair, sides] : at) {
      if (only_ordinary && (sides.size() != 2 || sides[0].second == sides[1].second)) continue;
      bool meets = false;
      for (const auto& side : sides) meets = meets || found.contains(side.first);
      if (!meets) continue;
      for (const auto& side : sides) found.insert(side.first);
    }
  }
  return {found.begin(), found.end()};
}

}  // namespace

std::vector<int> sheet_of(const Complex& points, int face) { return joined_faces(points, face, true); }
std::vector<int> component_of(const Complex& points, int face) { return joined_faces(points, face, false); }

}  // namespace ryosen::oracle
