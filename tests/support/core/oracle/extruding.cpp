#include "tests/support/core/oracle/extruding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace ryosen::oracle {
namespace {

// The sides of a face as they run, bridges left out.
std::vector<Pair> sides_without_bridges(const Complex& points, int face) {
  std::vector<Pair> sides, kept;
  for (const Corners& loop : points.faces[face])
    for (std::size_t i = 0; i < loop.size(); ++i) sides.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
  for (const Pair& side : sides)
    if (!std::count(sides.begin(), sides.end(), Pair(side.second, side.first))) kept.push_back(side);
  return kept;
}

// One directed side per edge of the border, in the order of the faces.
std::vector<Pair> border_of(const Complex& points, const std::vector<int>& faces) {
  std::vector<Pair> border;
  std::set<Pair> met;
  for (int f : faces)
    for (const auto& [a, b] : sides_without_bridges(points, f)) {
      if (!met.insert(std::minmax({a, b})).second) continue;
      const auto all = sides_between(points, a, b);
      const bool has_other = std::any_of(all.begin(), all.end(), [&](const auto& side) {
        return !std::count(faces.begin(), faces.end(), side.first);
      });
      if (has_other || all.size() == 1) border.emplace_back(a, b);
    }
  return border;
}

}  // namespace

Extruded extruded(const Complex& points, const std::vector<int>& faces) {
  std::vector<int> named;
  for (int f : faces)
    if (!std::count(named.begin(), named.end(), f)) named.push_back(f);
  const std::vector<Pair> border = border_of(points, named);
  std::set<int> staying, ours;
  for (const auto& [a, b] : border) staying.insert({a, b});
  Extruded result{points};
  result.border_points = static_cast<int>(staying.size());
  result.walls = static_cast<int>(border.size());
  for (const auto& [a, b] : points.wires) staying.insert({a, b});
  for (int f = 0; f < static_cast<int>(points.faces.size()); ++f)
    for (const Corners& loop : points.faces[f])
      (std::count(named.begin(), named.end(), f) ? ours : staying).insert(loop.begin(), loop.end());
  Complex& after = result.after;
  std::map<int, int> top;
  for (int v : ours) {
    if (!staying.contains(v)) continue;
    top[v] = after.size();
    after.point_of.push_back(after.size());
    after.live.push_back(1);
    ++result.points;
  }
  for (int f : named)
    for (Corners& loop : after.faces[f])
      for (int& v : loop)
        if (top.contains(v)) v = top[v];
  for (const auto& [a, b] : border) after.faces.push_back({{a, b, top[b], top[a]}});
  return result;
}

Complex with_extruded_edges(const Complex& points, const std::vector<Pair>& sides) {
  Complex after = points;
  std::map<int, int> top;
  for (const Pair& side : sides) {
    const int a = side.first, b = side.second;
    for (int v : {a, b}) {
      if (!top.try_emplace(v, after.size()).second) continue;
      after.point_of.push_back(after.size());
      after.live.push_back(1);
    }
    const auto at_faces = sides_between(points, a, b);
    const Corners quad = at_faces.empty() ? Corners{a, b, top[b], top[a]} : Corners{b, a, top[a], top[b]};
    after.faces.push_back({quad});
    std::erase_if(after.wires, [&](const Pair& wire) {
      return std::minmax({wire.first, wire.second}) == std::minmax({a, b});
    });
  }
  return after;
}

std::vector<Corners> faces_with_new_points_in_order(const Complex& complex, int old) {
  std::map<int, int> names;
  std::vector<Corners> faces;
  for (const auto& loops : complex.faces) {
    EXPECT_EQ(loops.size(), 1u);
    faces.push_back(loops.at(0));
    for (int& v : faces.back())
      if (v >= old) v = old + names.emplace(v, names.size()).first->second;
    faces.back() = rotated(faces.back());
  }
  return faces;
}

}  // namespace ryosen::oracle
