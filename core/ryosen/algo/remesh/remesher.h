// The passes of isotropic remeshing [Botsch04], by the kernel's operators and their verdicts.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ryosen/algo/remesh/features.h"
#include "ryosen/algo/remesh/seam_lines.h"
#include "ryosen/algo/remesh/surface_keeper.h"
#include "ryosen/algo/remesh/target.h"
#include "ryosen/base/progress.h"
#include "ryosen/mesh/edit.h"

namespace ryosen::remesh {

// Remeshes triangles. Feature edges are split alone, feature points never move, but points amid seams that are weighed
// may leave along these (seam_lines.h), into the next one; everything else stays on the surface that the target holds,
// and no step is done that the keeper refuses: points of the surface as it was stay within a quarter of the length of
// the surface as it becomes, but where short edges are removed at last. Each pass goes over the edges in a fixed order,
// so the result does not depend on threads; false: cancelled.
class Remesher {
 public:
  // The features, to which it adds its own, and the target are of the mesh as it is; they and the keeper outlive it.
  Remesher(Edit& edit, const Features& features, const Target& target, SurfaceKeeper& keeper);

  // Splits edges longer than 4/3 of what is wanted, the longest first, until there is none.
  bool split_long(Progress& progress);
  // Collapses edges shorter than 4/5 of it, the shortest first, where the kernel allows it, no longer edge than 4/3
  // comes of it and no face turns by 60 degrees: into the middle or else an end, or into the end that stays.
  bool collapse_short(Progress& progress);
  // After the rounds: from here on no step makes an edge of under 4/5 of the shortest length there is, and edges of up
  // to twice that length may come of a collapse, so that few short ones are left. Before, an eighth of the longest
  // length takes its place, so that rounds go on as [Botsch04] has them.
  void begin_closing();
  // Removes edges that are left shorter than 4/5 of the shortest length there is, by collapses, swaps and moves, also
  // of points that were put on features. Exempt are pieces of features of the input, and edges between two of its
  // feature points, which may not move. Where nothing else helps, points of the surface as it was come to lie anywhere.
  // Edges stay too where each remedy is refused by the kernel, makes faces meet or lose their area, or makes a still
  // shorter edge.
  bool remove_shortest(Progress& progress);
  // Swaps edges where that brings valences nearer to 6, and 4 at boundaries, and no face turns by 60 degrees.
  bool swap_for_valence(Progress& progress);
  // Swaps edges between triangles of which one is a sliver, where neither of the two that come of it is as narrow.
  bool swap_slivers(Progress& progress);
  // Moves points within the plane across their normal to the mean of the triangles around, by their areas, and back to
  // the surface; not where a face would turn by 60 degrees or become a sliver.
  bool relax(Progress& progress);
  // Gives each point that is no feature the values (colours, texture) of the surface as it was, there where it has come
  // to lie; feature edges were only divided, so theirs are right. `before`: the mesh of the target.
  void take_values(const Mesh& before);

  // How many of these there are.
  std::size_t short_edges() const;
  // Edges that are left shorter than 4/5 of what is wanted, which nothing but seams keeps from collapsing; not those
  // that divisions have made.
  std::vector<Edge> held_by_seams() const;

 private:
  static constexpr double cosine_of_turn = 0.5;  // of 60 degrees
  // Points that a seam had may be so far from it as it becomes, as a share of the length.
  static constexpr double share_of_seam_reach = 0.1;
  // Of 20 degrees: no pass but the splits makes a narrower triangle of wider ones.
  static constexpr double sliver_sine = 0.34;
  // Below it rounding tells which way a face lies, so that it meets its neighbours.
  static constexpr double needle_sine = 1e-4;
  // Of the length: how far the surface as it was may be from it as it becomes.
  static constexpr double share_of_reach = 0.25;
  static constexpr std::size_t between_reports = 256;
  struct SwappedTriangles;
  // How far a step may go: the cosine of the turn of a face, the length of edges that come of a collapse, and the sine
  // of the smallest angle below which no wider triangle becomes narrower, by a collapse and by a move.
  struct Guard {
    double turn_cosine = cosine_of_turn, longest = 0, sine = needle_sine, move_sine = sliver_sine;
    double reach = 1;                                         // of the keeper
    double beside = std::numeric_limits<double>::infinity();  // of the length: how far from the surface faces may lie
    bool in_two_steps = false;                                // whether its surroundings may change first
    double mended = std::numeric_limits<double>::infinity();  // the length of the edge that goes
  };

  bool is_feature(Edge e) const { return features_.edges[e.index] != 0; }
  bool is_fixed(Vertex v) const { return features_.vertices[v.index] != 0; }
  bool is_weighed(Edge e) const { return features_.is_weighed(e); }
  bool is_weighed(Vertex v) const { return features_.is_weighed(v); }
  // Whether rules of features let an edge collapse.
  bool may_vanish(Edge e) const;
  double length_of(Edge e) const;
  double wanted(Edge e) const;
  // Edges that are wanted, by length.
  using IsWanted = std::function<bool(Edge, double length)>;
  std::vector<Edge> edges_by_length(bool longest_first, const IsWanted& is_wanted) const;
  // Whether an edge of length `made` in place of one of length `before` is too short.
  bool is_too_short(double made, double before) const { return made < least_ && made < before; }
  bool makes_short_edges(Edge e, double along) const;
  std::optional<double> split_place(Edge e) const;
  bool try_split(Edge e);
  bool try_collapse(Edge e);
  bool try_collapse(Halfedge h, const glm::dvec3& place);
  bool try_leaving(Halfedge h);
  bool may_collapse(Halfedge h, const glm::dvec3& place) const;
  SwappedTriangles triangles_at(Halfedge h) const;
  // Whether both are points of features of the input, which stay: how far apart they are is given.
  bool stay(Vertex a, Vertex b) const { return stays(a) && stays(b); }
  bool stays(Vertex v) const { return is_fixed(v) && !is_weighed(v) && v.index < first_made_; }
  // No step makes an edge that short which nothing could remove at last: points with copies cannot leave an edge where
  // many sheets meet.
  double least_at_last() const;
  bool is_pinned(Vertex v) const;
  bool is_lasting(double made, Vertex a, Vertex b) const;
  bool mend_all(Progress& progress, std::size_t& left);
  bool is_short(Edge e, double length) const;
  bool mend_short(Edge e);
  bool mend_at_once(Edge e);
  bool mend_in_two_steps(Edge e);
  bool swap_longer(Halfedge h);
  bool is_guarded_swap(Halfedge h) const;
  bool move_apart(Halfedge h);
  bool remove_vertex(Vertex v);
  bool try_swap(Edge e, std::vector<int>& valences);
  bool try_swap_sliver(Edge e);
  bool try_swap_cap(Edge e);
  bool swap_if_allowed(Halfedge h);
  bool swap_if_kept(Halfedge h);
  int valence_error(Vertex v, int valence) const;
  glm::dvec3 normal_of(Vertex v) const;
  // Where on the surface, and how long edges are to be there.
  struct Relaxed {
    glm::dvec3 place;
    double length;
    std::uint32_t part;  // of the surface, which none of the vertices around leaves; no_index where one does
  };
  std::optional<Relaxed> relaxed(Vertex v, const std::vector<std::uint32_t>& parts);
  std::pair<std::vector<std::uint32_t>, std::uint32_t> parts_of_surface() const;
  void move(std::span<const Vertex> vertices, const std::vector<std::optional<Relaxed>>& found);
  // One value for all corners of a vertex within a chart: by it collapses know the chart.
  void share_corner_values(Vertex v);
  std::vector<std::optional<Target::Share>> shares(const Mesh& before) const;
  // Whether the middle of a triangle that comes of a step lies as near to the surface as it must.
  bool lies_near(const Corners& corners, Vertex v) const;
  bool faces_stay(Vertex v, const glm::dvec3& place) const;
  bool try_move(Vertex v, const glm::dvec3& place, SurfaceKeeper::MoveJudge& judge);

  Edit& edit_;
  const Mesh& mesh_;
  const Features& begun_with_;
  Features features_;
  SeamLines seams_;
  const Target& target_;
  SurfaceKeeper& keeper_;
  SurfaceKeeper::MoveJudge judge_;
  double least_;  // no step makes a shorter edge of a longer one, but pieces of features
  Guard guard_ = {};
  std::uint32_t first_made_;  // vertices before it are of the input
  double most_ = 0;  // edges of this length may come of a collapse, and longer ones only where longer ones are wanted
  std::vector<double> wanted_;         // per vertex
  std::vector<std::uint32_t> nearby_;  // per vertex, a triangle of the target; no_index where none is known
};

}  // namespace ryosen::remesh
