// The terms of V - E + F + (B + W + I) - H = 2(S - G), on points and undirected edges.
//
// B + W + I counts the closed walks outside the faces; the headers of the operators (ryosen/ops) call the sum B.
// On a manifold, orientable mesh the kernel has B + W cycles of outside halfedges.
//
// A bridge (an edge with the same face on both sides) is an ordinary edge until make_ring replaces it by a ring. Files
// do not distinguish the two: a bridge that is written reads back as a ring. So Figures, which describe the file, count
// bridges as rings; the terms, the list of problems and `expect`, which describe the open mesh, do not. V - E - H is
// the same either way.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "ryosen/analysis/boundary_loops.h"
#include "ryosen/analysis/problem_sets.h"
#include "ryosen/base/element.h"
#include "ryosen/base/message.h"

namespace ryosen {

// Why there is no G, in the order of asking.
enum class NoGenus : std::uint8_t {
  none,                // there is one
  nonmanifold_edge,    // three or more faces on an edge
  nonmanifold_vertex,  // several fans at a point
  one_sided,           // no turning of faces makes all agree
  unturned,            // wires beside misoriented faces: the sides of a wire are ambiguous
  wire_at_copies,      // a wire ends at a point with copies, or where the faces leave no gap
};

struct EulerPoincare {
  std::int64_t vertices = 0;        // V: points
  std::int64_t edges = 0;           // E: pairs of points with an edge, wires and bridges too
  std::int64_t faces = 0;           // F
  std::int64_t boundary_loops = 0;  // B: of the faces, as `check` and the list of problems count them
  // W: outside cycles that contain a wire, minus the boundary loops that they contain. A lone wire counts +1, one with
  // one end on a boundary 0, one from a boundary loop to itself +1, one between two boundary loops -1.
  std::int64_t wire_cycles = 0;
  std::int64_t isolated = 0;  // I: points without an edge
  std::int64_t rings = 0;     // H: inner loops of faces
  std::int64_t parts = 0;     // S: what hangs together by edges, faces and points; an isolated point is one
  // G: the genus of all parts together: half the edges that are neither in a spanning forest of the points nor in one
  // of the faces and outside walks. It does not use the other terms, so the sum is a check.
  std::optional<std::int64_t> genus;
  NoGenus no_genus = NoGenus::none;
  bool open_chain = false;  // some boundary edges close to no loop: boundary_loops is no B
  Element at;               // where, if there is none

  std::int64_t outside() const { return boundary_loops + wire_cycles + isolated; }
  std::int64_t left() const { return vertices - edges + faces + outside() - rings; }
  std::int64_t right() const { return 2 * (parts - genus.value_or(0)); }
  bool holds() const { return genus && left() == right(); }
  friend bool operator==(const EulerPoincare&, const EulerPoincare&) = default;
};

// A term of the sum by its letter; `value` is empty for G, or B, where there is none.
struct EulerTerm {
  char letter;
  std::string_view en, ja;
  std::string_view help_en, help_ja;  // what it counts, in a sentence
  std::optional<std::int64_t> (*value)(const EulerPoincare&);
  bool is_rare = false;  // 0 for most meshes
};
// In the order of the sum.
std::span<const EulerTerm> euler_letters();

// `sets` are those of the mesh as it is. O(edges), and a logarithm beside copies.
EulerPoincare euler_poincare(const Mesh& mesh, const ProblemSets& sets);
// Searches for itself.
EulerPoincare euler_poincare(const Mesh& mesh);

// Updates the terms after an operator that keeps W, S and G (Topology::kept). False if they must be computed anew.
// O(1).
bool follow_operator(EulerPoincare& terms, const Mesh& mesh, const ProblemSets& sets,
                     const BoundaryLoopCount& boundary_loops);

// "not manifold at 0-1"; empty where there is a G.
Text why_no_genus(const Mesh& mesh, const EulerPoincare& terms);
// The reason why a term has no value; empty where it has one.
Text why_no_value(const Mesh& mesh, const EulerPoincare& terms, const EulerTerm& term);

}  // namespace ryosen
