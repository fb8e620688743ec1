// The plain polygon list on which the oracle works: numbers, and faces as lists of numbers. It knows no halfedges and
// shares nothing with core, so that an error there cannot hide here.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ryosen::oracle {

using Corners = std::vector<int>;
using Pair = std::pair<int, int>;

// Faces over vertex numbers. A dead vertex number and a face without corners are gaps that operations leave behind, so
// that names stay. Orientation of a face is the order of its corners.
struct PolygonList {
  std::vector<char> live;  // one per vertex number
  std::vector<Corners> faces;

  int size() const { return static_cast<int>(live.size()); }
};

// The list of a file: all numbers below `vertices` live.
PolygonList polygon_list(int vertices, std::vector<Corners> faces);

// True if each face has three or more corners, all in range and none twice.
bool is_simple(const PolygonList& list);

// Equal faces up to the corner at which each list of corners starts; vertex and face numbers must agree.
bool same_list(const PolygonList& one, const PolygonList& other);

// The corners rotated so that the smallest number comes first.
Corners rotated(Corners corners);

// The corners from the one with index `first` on, around the end.
Corners from_corner(const Corners& corners, int first);

// As C++ source, to paste a failing mesh into a test.
std::string to_text(const PolygonList& list);

// A side of a face: the corners `corner` and `corner + 1` (cyclic) of `face`, whose numbers are lo <= hi in some order.
struct Side {
  int lo = 0;
  int hi = 0;
  int face = 0;
  int corner = 0;
  bool up = false;  // runs from lo to hi
};

// All sides of a list, those between the same two vertices side by side.
class Sides {
 public:
  explicit Sides(const PolygonList& list);

  const std::vector<Side>& all() const& { return sides_; }
  const std::vector<Side>& all() && = delete;
  int pairs() const { return static_cast<int>(starts_.size()) - 1; }
  const Side* begin(int pair) const { return sides_.data() + starts_[pair]; }
  const Side* end(int pair) const { return sides_.data() + starts_[pair + 1]; }
  int count(int pair) const { return starts_[pair + 1] - starts_[pair]; }
  // The number of the pair to which a side of a face belongs.
  int pair_of(int face, int corner) const { return pair_of_side_[first_corner_[face] + corner]; }

  // Corners numbered through, face after face.
  int corners() const { return static_cast<int>(pair_of_side_.size()); }
  int corner_id(int face, int corner) const { return first_corner_[face] + corner; }
  // The corner of a side at one of its two vertices.
  int corner_at(const Side& side, int vertex) const;
  int corner_id_at(const Side& side, int vertex) const { return corner_id(side.face, corner_at(side, vertex)); }
  int degree(int face) const { return first_corner_[face + 1] - first_corner_[face]; }

 private:
  std::vector<Side> sides_;
  std::vector<int> starts_;
  std::vector<int> first_corner_;
  std::vector<int> pair_of_side_;
};

// Two faces that run the pair in opposite directions, and no third.
bool is_joined(const Sides& sides, int pair);
// Exactly two faces, same direction.
bool is_misoriented(const Sides& sides, int pair);

// Disjoint sets over 0 .. n-1.
class Groups {
 public:
  explicit Groups(int n);
  int root(int i);
  void join(int i, int j) { parent_[root(i)] = root(j); }

 private:
  std::vector<int> parent_;
};

}  // namespace ryosen::oracle
