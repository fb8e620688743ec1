// What every operator does to a list with rings, wires and fans, and whether that was legal.
#pragma once

#include <vector>

#include "tests/support/core/oracle/complex.h"

namespace ryosen::oracle {

// A list that an operator makes, and by how much it says that the counts change. In what was before it, each first
// number of `read_as` is read as the second.
struct Outcome {
  Complex after;
  int vertices = 0, edges = 0, faces = 0, rings = 0;
  std::vector<Pair> read_as = {};
};
// Empty: the operator has no meaning there. Several: any of them will do.
using Outcomes = std::vector<Outcome>;

// A place in a loop of a face, and the side that begins there.
struct Place {
  int face = 0, loop = 0, corner = 0;
};
int vertex_at(const Complex& complex, Place place);
int next_vertex(const Complex& complex, Place place);

// Collapse and swap work on separated lists. Vertices a and b are joined by an edge.
Outcomes collapse(const Complex& separated, int a, int b);
Outcomes swap(const Complex& separated, Place side, bool back);
// Result on points; the new point has the number `middle`. `cuts`: triangles without rings are cut in two.
Outcomes put_into_edge(const Complex& complex, int a, int b, int middle, bool cuts);

// The Euler operators, on vertices as the kernel has them. A cycle runs outside.
Outcomes make_edge(const Complex& complex, int a, int b);
Outcomes delete_edge(const Complex& complex, int a, int b);
Outcomes make_loop(const Complex& complex, const Corners& cycle);
Outcomes delete_loop(const Complex& complex, int face);
Outcomes separate_loop(const Complex& complex, Place a, Place b);
Outcomes unite_loop(const Complex& complex, Place side);
Outcomes unite_edge(const Complex& complex, int v);
Outcomes make_ring(const Complex& complex, Place side);
Outcomes unite_ring(const Complex& complex, Place a, Place b);

// Taking away, filling and repairing, on lists of points.
Complex without_faces(const Complex& points, const std::vector<int>& faces, const std::vector<Pair>& wires);
Outcomes make_face(const Complex& points, const Corners& corners);
Outcomes weld(const Complex& points, const std::vector<Pair>& gone_and_stays);
Complex detached(const Complex& points, const std::vector<int>& faces, int first_number);
// The faces that edges with exactly two faces in opposite directions join to a face; all that share an edge with it.
std::vector<int> sheet_of(const Complex& points, int face);
std::vector<int> component_of(const Complex& points, int face);

}  // namespace ryosen::oracle
