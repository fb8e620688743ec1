// Brute-force figures of a polygon list, as `check` reports them.
#pragma once

#include <vector>

#include "tests/support/core/oracle/polygons.h"

namespace ryosen::oracle {

struct Figures {
  int vertices = 0;  // live numbers
  int edges = 0;     // distinct vertex pairs
  int faces = 0;
  int boundary_edges = 0;
  int boundary_loops = 0;  // closed chains of boundary edges through the fan of faces at each vertex
  int nonmanifold_edges = 0;
  int max_edge_faces = 0;
  int nonmanifold_vertices = 0;
  int bowtie_vertices = 0;
  int misoriented_edges = 0;
  int duplicate_faces = 0;  // beyond the first on the same vertex set
  int hanging_pairs = 0;
  int isolated_vertices = 0;
  int components = 0;            // faces joined through any shared edge
  int euler_characteristic = 0;  // without isolated vertices
  bool manifold = true;
  bool closed = false;
  bool orientable = true;
  int genus = -1;  // -1 where it is not defined

  friend bool operator==(const Figures&, const Figures&) = default;
};

Figures figures_of(const PolygonList& list);

// The parts of it that an operation is judged by.
int boundary_loops(const PolygonList& list, const Sides& sides);
int components(const PolygonList& list, const Sides& sides);
// Per vertex, into how many groups its corners fall when joined through shared edges whatever their direction.
std::vector<int> fans_per_vertex(const PolygonList& list, const Sides& sides);
// Pairs of faces (lower number first, ascending) on the same vertex set. Corners that repeat count once.
std::vector<std::pair<int, int>> equal_faces(const PolygonList& list);

}  // namespace ryosen::oracle
