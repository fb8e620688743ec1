// The oracle's list for all that the kernel can hold: faces of several loops and with bridges, edges without a face,
// isolated vertices, several fans at a vertex, copies of points.
#pragma once

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/support/core/oracle/reading.h"

namespace ryosen::oracle {

struct Complex {
  std::vector<char> live;                   // one per number of a vertex
  std::vector<int> point_of;                // the point that each vertex is a copy of
  std::vector<std::vector<Corners>> faces;  // the loops of each face, in any order; none: a number without a face
  std::vector<Pair> wires;                  // edges without a face, the lower end first

  int size() const { return static_cast<int>(live.size()); }
};

std::string to_text(const Complex& complex);

// The loops of all faces as faces of a list of their own, and the face that each belongs to.
struct LoopList {
  CopyList copies;
  std::vector<int> face_of;
};
LoopList loops_of(const Complex& complex);

// Each fan of faces a vertex of its own, a copy of the point: the fan with the lowest face stays, with the wires.
Complex separated(const Complex& complex);
// Each copy replaced by its point, which is its only copy then.
Complex on_points(const Complex& complex);

// Whether the loops come apart, bridges taken out one by one, into simple loops of three or more corners that share no
// vertex, and how many bridges that takes; -1 where they do not.
int bridges_in(std::vector<Corners> loops);

// Corner lists without regard to where they start and in which order they come.
std::vector<Corners> normal_form(std::vector<Corners> loops);

// What two lists are compared by, where the numbers of faces do not matter.
struct Shape {
  std::vector<int> live;
  std::vector<std::vector<Corners>> faces;
  std::vector<Pair> wires;
  friend bool operator==(const Shape&, const Shape&) = default;
};
Shape shape_of(const Complex& complex);

// What is wrong with a list, by its rule and the face, edge or vertex that it is wrong at.
enum class Fault { loops, directed_edge_twice, pair_twice, several_fans, equal_faces };
using Faults = std::vector<std::tuple<Fault, int, int>>;

struct ComplexFacts {
  Faults faults;  // ascending
  int vertices = 0, edges = 0, faces = 0, rings = 0, components = 0, isolated = 0, boundary_loops = 0, bridges = 0;
  // On points, ascending.
  std::vector<std::tuple<int, int, int>> nonmanifold;
  std::vector<Pair> misoriented, equal_faces, doubled_wires;
  std::vector<std::pair<int, std::vector<int>>> groups;
  bool loops_on_points = true;  // each face comes apart as a list of points too
  bool reads_back = true;       // the fans are those that reading the points gives
};

// Components hang together through edges and faces; boundary loops are those of the faces alone.
ComplexFacts facts_of(const Complex& complex);

// The faces at a pair of vertices, as a list of directions: true from a to b.
std::vector<std::pair<int, bool>> sides_between(const Complex& complex, int a, int b);
bool is_wire(const Complex& complex, int a, int b);
// Whether a new edge can go to a vertex: it is isolated, or faces do not lie all around it.
bool has_gap(const Complex& complex, int v);

}  // namespace ryosen::oracle
