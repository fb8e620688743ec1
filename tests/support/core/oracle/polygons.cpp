#include "tests/support/core/oracle/polygons.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace ryosen::oracle {

PolygonList polygon_list(int vertices, std::vector<Corners> faces) {
  return {std::vector<char>(static_cast<std::size_t>(vertices), 1), std::move(faces)};
}

bool is_simple(const PolygonList& list) {
  for (const Corners& face : list.faces) {
    if (face.size() < 3) return false;
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (face[i] < 0 || face[i] >= list.size() || !list.live[face[i]]) return false;
      if (std::count(face.begin(), face.end(), face[i]) != 1) return false;
    }
  }
  return true;
}

Corners rotated(Corners corners) {
  if (!corners.empty()) std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

Corners from_corner(const Corners& corners, int first) {
  Corners turned = corners;
  std::rotate(turned.begin(), turned.begin() + first % static_cast<int>(corners.size()), turned.end());
  return turned;
}

bool same_list(const PolygonList& one, const PolygonList& other) {
  if (one.live != other.live || one.faces.size() != other.faces.size()) return false;
  for (std::size_t f = 0; f < one.faces.size(); ++f)
    if (rotated(one.faces[f]) != rotated(other.faces[f])) return false;
  return true;
}

std::string to_text(const PolygonList& list) {
  std::string text = "polygon_list(" + std::to_string(list.size()) + ", {";
  for (std::size_t f = 0; f < list.faces.size(); ++f) {
    text += f ? ", {" : "{";
    for (std::size_t i = 0; i < list.faces[f].size(); ++i) text += (i ? "," : "") + std::to_string(list.faces[f][i]);
    text += "}";
  }
  text += "})";
  for (int v = 0; v < list.size(); ++v)
    if (!list.live[v]) text += " without " + std::to_string(v);
  return text;
}

Sides::Sides(const PolygonList& list) {
  first_corner_.push_back(0);
  for (std::size_t f = 0; f < list.faces.size(); ++f) {
    const Corners& face = list.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int from = face[i], to = face[i + 1 < face.size() ? i + 1 : 0];
      sides_.push_back({std::min(from, to), std::max(from, to), static_cast<int>(f), static_cast<int>(i), from < to});
    }
    first_corner_.push_back(static_cast<int>(sides_.size()));
  }
  std::sort(sides_.begin(), sides_.end(), [](const Side& s, const Side& t) {
    return std::tie(s.lo, s.hi, s.face, s.corner) < std::tie(t.lo, t.hi, t.face, t.corner);
  });
  pair_of_side_.resize(sides_.size());
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    if (i == 0 || sides_[i].lo != sides_[i - 1].lo || sides_[i].hi != sides_[i - 1].hi)
      starts_.push_back(static_cast<int>(i));
    pair_of_side_[corner_id(sides_[i].face, sides_[i].corner)] = static_cast<int>(starts_.size()) - 1;
  }
  starts_.push_back(static_cast<int>(sides_.size()));
}

int Sides::corner_at(const Side& side, int vertex) const {
  const bool first = (vertex == side.lo) == side.up;
  return first ? side.corner : (side.corner + 1) % degree(side.face);
}

bool is_joined(const Sides& sides, int pair) {
  return sides.count(pair) == 2 && sides.begin(pair)[0].up != sides.begin(pair)[1].up;
}

bool is_misoriented(const Sides& sides, int pair) {
  return sides.count(pair) == 2 && sides.begin(pair)[0].up == sides.begin(pair)[1].up;
}

Groups::Groups(int n) : parent_(static_cast<std::size_t>(n)) { std::iota(parent_.begin(), parent_.end(), 0); }

int Groups::root(int i) {
  while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
  return i;
}

}  // namespace ryosen::oracle
