// The holes of a mesh: parted where they touch, found, and told why one stays open.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ryosen/algo/algorithm.h"
#include "ryosen/algo/repair/hole_loop.h"
#include "ryosen/base/message.h"
#include "ryosen/base/progress.h"
#include "ryosen/ops/op.h"

namespace ryosen {

// Parts each boundary loop that visits places more than once, so that each part visits a place once. Two holes that
// touch in a point are one loop while the fans of faces f and g between them have a vertex each, and two loops once
// these are one:
//
//        \ f /                 \ f /
//         v'                    \ /
//     A        B      =>     A   v   B
//         v''                   / \        A, B: holes
//        / g \                 / g \       f, g: fans of faces
//
// The vertices may also be two points at one place, as detaching leaves them. A loop stays whole where an edge of it
// has no or several faces, or a part would have fewer than three sides. Returns the vertices that two points have
// become. O(halfedges), and a sort of the places of the loops.
std::vector<Vertex> part_loops(Edit& edit);
// Gives each fan a vertex of its own again, and a point of its own where part_loops() has joined two. O(vertices).
void join_loops(Edit& edit, const std::vector<Vertex>& joined);

// Of several causes the last one counts: it got furthest.
enum class WhyOpen : std::uint8_t {
  untried,
  not_finite,
  visits_twice,
  has_wire,
  cut_edge,
  face_exists,
  flat_sheet,
  without_area,
  edge_exists,
  crosses,
  coincides,
  filled,
};

struct WhyOpenRow {
  WhyOpen cause;
  std::string_view en, ja;  // clauses; `#` stands for the next remedy
  std::array<AlgorithmResult (*)(Edit&, const AlgorithmInput&, Progress&), 2> remedies = {};

  // With the names and ids of the remedies.
  Text text() const;
};
// Of those that are told, in the order of reports.
std::span<const WhyOpenRow> reasons_to_stay_open();

struct Hole {
  Halfedge start;  // halfedge without a face; the loop's lowest point is where it begins
  WhyOpen cause = WhyOpen::untried;
  Face crossed = {};  // the first face that a patch for it was found to cross, if any
};

// Every boundary loop of at most so many edges, ascending by lowest point. Neither wires nor what is longer is a hole.
std::vector<Hole> find_holes(const Mesh& mesh, std::optional<double> most_edges, Progress& progress);

// Gives holes that were tried in vain, and each of whose sides lies on a further open side of a face, that cause:
// welding is for them. A pass over the halfedges and a sort, if there is such a hole.
void tell_coinciding_borders(const Mesh& mesh, std::vector<Hole>& holes);

// The edges of the mesh that join corners of these holes. O(edges), and a sort of those.
JoinedCorners joined_corners(const Mesh& mesh, std::span<const Hole> holes, std::span<const std::uint32_t> chosen);

}  // namespace ryosen
