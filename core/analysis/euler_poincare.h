// The terms of V - E + F + (B + W + I) - H = 2(S - G), on points and undirected edges.
//
// B, W and I together are the closed walks outside of the faces, which the sample program and the operators (core/ops)
// count as one number B. On a manifold, orientable mesh the kernel's cycles of outside halfedges are B + W.
//
// A bridge (an edge with the same face on both sides) is an edge like any other until make_ring takes it out and a ring
// is left. A file cannot tell the two apart: what is written with a bridge reads back as a ring, an edge less and a ring
// more. So Figures, which speak of the file, count the bridges of an open mesh as rings; the terms, the list of problems
// and `expect`, which speak of the open mesh, do not. V - E - H is the same either way.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/analysis/problem_sets.h"
#include "core/base/element.h"
#include "core/base/message.h"

namespace ryosen {

// Why there is no G, in the order of asking.
enum class NoGenus : std::uint8_t {
  none,                // there is one
  nonmanifold_edge,    // three or more faces on an edge
  nonmanifold_vertex,  // several fans at a point
  one_sided,           // no turning of faces makes all agree
  unturned,            // wires, and faces that disagree: on which side of a wire one walks is not said
  wire_at_copies,      // a wire ends at a point with copies, or where the faces leave no gap
};

struct EulerPoincare {
  std::int64_t vertices = 0;        // V: points
  std::int64_t edges = 0;           // E: pairs of points with an edge, wires and bridges too
  std::int64_t faces = 0;           // F
  std::int64_t boundary_loops = 0;  // B: of the faces, as `check` and the list of problems count them
  // W: cycles outside that run along a wire, less the boundary loops that they run along. A wire that stands alone makes
  // one more. One that hangs on a boundary is part of the walk along that boundary and adds none. One from a boundary
  // loop to itself parts the walk and makes one more, one between two loops makes one walk of them and one less.
  std::int64_t wire_cycles = 0;
  std::int64_t isolated = 0;  // I: points without an edge
  std::int64_t rings = 0;     // H: inner loops of faces
  std::int64_t parts = 0;     // S: what hangs together by edges, faces and points; an isolated point is one
  // G: handles of all parts together. Counted on its own: of the edges that neither a spanning tree of the points nor one
  // of the faces and of the walks outside holds, half. So the sum is a test.
  std::optional<std::int64_t> genus;
  NoGenus no_genus = NoGenus::none;
  Element at;  // where, if there is none

  std::int64_t outside() const { return boundary_loops + wire_cycles + isolated; }
  std::int64_t left() const { return vertices - edges + faces + outside() - rings; }
  std::int64_t right() const { return 2 * (parts - genus.value_or(0)); }
  bool holds() const { return genus && left() == right(); }
  friend bool operator==(const EulerPoincare&, const EulerPoincare&) = default;
};

// A term of the sum by its letter; `value` is empty for G where there is none.
struct EulerTerm {
  char letter;
  std::string_view en, ja;
  std::optional<std::int64_t> (*value)(const EulerPoincare&);
  bool is_rare = false;  // 0 for most meshes
};
// In the order of the sum.
std::span<const EulerTerm> euler_letters();

// `sets` are those of the mesh as it is. O(edges), and a logarithm beside copies.
EulerPoincare euler_poincare(const Mesh& mesh, const ProblemSets& sets);
// Searches for itself.
EulerPoincare euler_poincare(const Mesh& mesh);

// Brings the terms up to date after an operator that leaves W, S and G alone (Topology::kept). False where that is
// not enough and they must be asked anew. O(1).
bool follow_operator(EulerPoincare& terms, const Mesh& mesh, const ProblemSets& sets, std::uint32_t boundary_loops);

// "not manifold at 0-1"; empty where there is a G.
Text why_no_genus(const Mesh& mesh, const EulerPoincare& terms);

}  // namespace ryosen
