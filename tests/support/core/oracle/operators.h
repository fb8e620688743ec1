// The oracle: does collapse, swap and split on a list of copies and looks whether that was legal.
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "tests/support/core/oracle/reading.h"

namespace ryosen::oracle {

enum class Kind { collapse, swap, swap_back, split };

// An operation on the edge between the points from and to. `face` tells which side of the edge was named; the verdict
// does not depend on it, for where a point pair is more than one edge, collapse and swap are refused and split takes
// all.
struct Operation {
  Kind kind = Kind::collapse;
  int from = 0;
  int to = 0;
  int face = -1;
};

std::string to_text(const Operation& operation);

// Every operation on every edge: one per kind and direction, and on a non-manifold or misoriented edge per face as
// well.
std::vector<Operation> operations_of(const PolygonList& points);

// The list after the operation, or nothing where it has no meaning: no such edge, an edge that is not two copies joined
// by one or two sides (collapse, swap), a boundary edge (swap).
// collapse: `from` goes, or `to` where `from` has copies. Faces that vanish leave an empty corner list.
// split: the part of a triangle that holds `from` keeps its number; new faces get the next numbers, those left of
// from -> to first. The new point gets the next number of a copy, and one copy per fan as reading makes them.
std::optional<CopyList> apply(const CopyList& before, const Operation& operation);

// What a list of copies must not have anew.
enum class Rule { corner_twice, directed_edge_twice, several_fans, equal_faces };

// A violation, named by its rule and the numbers of its faces, its edge or its vertex (second: -1).
struct Violation {
  Rule rule;
  int first;
  int second;
  friend auto operator<=>(const Violation&, const Violation&) = default;
};

// What is compared between the list before and the list after.
struct Facts {
  std::vector<Violation> violations;  // ascending
  int vertices = 0, edges = 0, faces = 0, euler_characteristic = 0;
  int boundary_loops = 0, components = 0, isolated_vertices = 0;
  // On points, ascending.
  std::vector<std::tuple<int, int, int>> nonmanifold;  // lower end, higher end, faces
  std::vector<std::pair<int, int>> misoriented;
  std::vector<std::pair<int, int>> equal_faces;
  std::vector<std::pair<int, std::vector<int>>> groups;  // points with two or more copies that have faces
  bool point_twice_in_face = false;
  bool vertex_twice_in_face = false;
  bool reads_back = true;  // reading the points gives the same fans
};

// Empty: legal. Otherwise why not, in the order of the rules.
using Reasons = std::vector<std::string>;

// The reason against collapse and swap where faces run between the two points in any way but as one edge.
inline const std::string not_one_edge = "the edge is non-manifold or misoriented on points";

// Judges operations on one list.
class Judge {
 public:
  explicit Judge(CopyList list);

  const CopyList& list() const { return list_; }
  Reasons reasons(const Operation& operation) const;
  bool legal(const Operation& operation) const { return reasons(operation).empty(); }

 private:
  CopyList list_;
  PolygonList points_;
  Sides sides_;  // of points_
  Facts facts_;
};

Facts facts_of(const CopyList& copies);

// Rules 1, 2 and 3 for a collapse or swap that has been done; `gone` is read as `stays` in the facts before it (-1:
// none).
Reasons compare_facts(Facts before, const Facts& after, Kind kind, int gone, int stays);

}  // namespace ryosen::oracle
