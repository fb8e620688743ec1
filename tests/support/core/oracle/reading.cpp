#include "tests/support/core/oracle/reading.h"

#include <algorithm>

namespace ryosen::oracle {

std::vector<int> fans_as_read(const PolygonList& points) {
  const Sides sides(points);
  Groups groups(sides.corners());
  for (int pair = 0; pair < sides.pairs(); ++pair) {
    if (!is_joined(sides, pair)) continue;
    const Side &s = sides.begin(pair)[0], &t = sides.begin(pair)[1];
    for (int end : {s.lo, s.hi}) groups.join(sides.corner_id_at(s, end), sides.corner_id_at(t, end));
  }
  std::vector<int> first(static_cast<std::size_t>(sides.corners()), -1), fan(first);
  for (int c = 0; c < sides.corners(); ++c) {
    int& lowest = first[groups.root(c)];
    if (lowest < 0) lowest = c;
    fan[c] = lowest;
  }
  return fan;
}

std::vector<int> fans_as_listed(const PolygonList& copies) {
  std::vector<int> first(static_cast<std::size_t>(copies.size()), -1), fan;
  for (const Corners& face : copies.faces) {
    for (int v : face) {
      if (first[v] < 0) first[v] = static_cast<int>(fan.size());
      fan.push_back(first[v]);
    }
  }
  return fan;
}

CopyList read_copies(const PolygonList& points) {
  const std::vector<int> fan = fans_as_read(points);
  // Corners are numbered face after face, so the first corner of a fan lies in its lowest face.
  std::vector<std::vector<int>> fans_of_point(points.live.size());
  int corner = 0;
  for (const Corners& face : points.faces)
    for (int p : face) {
      if (fan[corner] == corner) fans_of_point[p].push_back(corner);
      ++corner;
    }

  CopyList result{points, {}};
  for (int p = 0; p < points.size(); ++p) result.point_of.push_back(p);
  std::vector<int> number(static_cast<std::size_t>(corner), -1);
  for (int p = 0; p < points.size(); ++p) {
    for (std::size_t k = 0; k < fans_of_point[p].size(); ++k) {
      if (k > 0) {
        result.point_of.push_back(p);
        result.list.live.push_back(1);
      }
      number[fans_of_point[p][k]] = k == 0 ? p : result.list.size() - 1;
    }
  }
  corner = 0;
  for (Corners& face : result.list.faces)
    for (int& v : face) v = number[fan[corner++]];
  return result;
}

PolygonList points_of(const CopyList& copies) {
  PolygonList points = copies.list;
  std::fill(points.live.begin(), points.live.end(), char{0});
  for (int v = 0; v < copies.list.size(); ++v)
    if (copies.list.live[v]) points.live[copies.point_of[v]] = 1;
  for (Corners& face : points.faces)
    for (int& v : face) v = copies.point_of[v];
  return points;
}

}  // namespace ryosen::oracle
