// Simplification by collapses of edges, the one of least error first [Garland97].
//
// An edge waits on a level of its cost, which nearly is a lower bound: what its ends stand for only grows. It is asked
// anew when its turn comes, and goes to a higher level or collapses. One that is refused is blocked until something
// around it changes. So nothing is written to the queue where a neighbour collapses. Edges of a level are taken many at
// once (simplifier_asking.cpp); what one of them asked is asked again where a collapse of another has changed it.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ryosen/algo/crossings/crossing_guard.h"
#include "ryosen/algo/simplify/collapse_surface.h"
#include "ryosen/algo/simplify/distance_guard.h"
#include "ryosen/algo/simplify/input_sides.h"
#include "ryosen/algo/simplify/jump_limit.h"
#include "ryosen/base/progress.h"
#include "ryosen/mesh/edit.h"
#include "ryosen/ops/rules/local_facts.h"
#include "ryosen/ops/rules/plain_check.h"

namespace ryosen {

// Numbers in the order of a cost, as far as it matters: costs between two powers of two share a few levels, and within
// a level the first to come is the first to go. Adding and taking cost O(1).
class LevelQueue {
 public:
  using Level = std::uint32_t;

  // 2^bits levels from one power of two to the next.
  explicit LevelQueue(unsigned bits)
      : shift_(52 - bits), first_(key_of(smallest)), levels_(key_of(largest) - first_ + 1) {}

  // Of a cost from 0 up; what is no number counts as the largest.
  Level level_of(double cost) const {
    if (!(cost <= largest)) return static_cast<Level>(levels_.size() - 1);
    return static_cast<Level>(key_of(std::max(cost, smallest)) - first_);
  }

  // Puts it on its level, or on the one that is being taken from where that is already past.
  void add(std::uint32_t number, Level level) { levels_[std::max(level, current_)].push_back(number); }

  // Goes to the next number; false where there is none, and everything added from then on is taken from the lowest
  // level again.
  bool next() {
    ++place_;
    while (place_ >= levels_[current_].size()) {
      std::vector<std::uint32_t>().swap(levels_[current_]);
      place_ = 0;
      if (current_ + 1 == levels_.size()) {
        current_ = 0;
        place_ = static_cast<std::size_t>(-1);
        return false;
      }
      ++current_;
    }
    return true;
  }
  // The same, but no further than the end of the level.
  bool next_on_level() {
    if (place_ + 1 >= levels_[current_].size()) return false;
    ++place_;
    return true;
  }
  // Takes all numbers off.
  void clear() {
    for (std::vector<std::uint32_t>& level : levels_) std::vector<std::uint32_t>().swap(level);
    current_ = 0;
    place_ = static_cast<std::size_t>(-1);
  }
  std::uint32_t number() const { return levels_[current_][place_]; }
  // The number so many steps ahead on the same level, or the last one.
  std::uint32_t ahead(std::size_t steps) const {
    const std::vector<std::uint32_t>& level = levels_[current_];
    return level[std::min(place_ + steps, level.size() - 1)];
  }
  Level current() const { return current_; }

 private:
  static constexpr double smallest = 0x1p-120, largest = 0x1p40;

  std::uint64_t key_of(double cost) const { return std::bit_cast<std::uint64_t>(cost) >> shift_; }

  unsigned shift_;
  std::uint64_t first_;
  std::vector<std::vector<std::uint32_t>> levels_;
  Level current_ = 0;
  std::size_t place_ = static_cast<std::size_t>(-1);
};

struct SimplifyGoal {
  std::size_t faces = 0;  // live ones: not more than these
  // 0 to 2: what is done in the end where the input is known and there is neither a journal nor anything to keep apart.
  // From 1 on vertices move nearer to it and faces that look against it are mended; with 2 edges are swapped, and costs
  // have more levels.
  unsigned effort = 1;
  // Of a mesh of triangles no faces may come to meet. Where some do already, pairs that come from them may go on, as
  // many at most (CrossingGuard::inherit).
  bool no_self_intersections = false, has_self_intersections = false;
  // Parts of the surface go that can collapse no further and are smaller than the error: than its limit, or without
  // one, than the largest error that was made until then; and where nothing else can collapse, all that are so small.
  bool removes_small_parts = false;
  // Edges whose collapse would lose the shape are left (jump_limit.h).
  bool keeps_shape = false;
  // Where nothing else can collapse, handles are closed and parts joined, without a journal and where faces may meet.
  bool changes_topology = false;
  // Where nothing else can collapse, points of a weighted boundary may leave it.
  bool lets_boundaries_go = false;
  // In units of the mesh: every point of the surface stays that near to the surface as it was, and every point of that
  // to the surface. Where there is a limit, all faces must be triangles without rings, and no small part goes.
  double most_distance = std::numeric_limits<double>::infinity();
};

class Simplifier {
 public:
  // Collapses edges of this mesh, each as an entry of a journal where there is one; without one what it writes is
  // final, so that it is to be a copy. `input`: the mesh as it is, to stay so: with it the surface comes nearer to it
  // in the end as the effort says, and where there are but triangles without values at their corners, faces that have
  // come to look against it are mended when the goal is reached. `descent`: told where elements come from, without a
  // journal. All must outlive it.
  Simplifier(Mesh& mesh, const CollapseLimits& limits, const SimplifyGoal& goal, Journal* steps = nullptr,
             const Mesh* input = nullptr, Descent* descent = nullptr);

  // Until the goal is reached or no edge can collapse; false where it was cancelled.
  bool run(Progress& progress);

  std::size_t collapses() const { return collapses_; }
  std::size_t removed_parts() const { return removed_parts_; }
  std::size_t swaps() const { return swaps_; }
  // To where the surface lies nearer to the input.
  std::size_t moves() const { return moves_; }
  std::size_t closed_handles() const { return closed_handles_; }
  std::size_t joined_parts() const { return joined_parts_; }
  // Whether an edge could collapse if points of a weighted boundary left it. Cost: that of asking every edge.
  bool has_edges_held_by_boundaries(Progress& progress);
  // Parts could be joined but for the limit of the shape.
  bool has_parts_too_far() const { return has_parts_too_far_; }
  // So many faces had come to look against the input, and so many still do.
  std::size_t turned() const { return turned_; }
  std::size_t still_turned() const { return still_turned_; }
  std::size_t asked() const { return asked_; }
  std::uint64_t looked_at() const {
    return surface_.looked_at() + warmed_ + farthest_looks_ + (sides_ ? sides_->looks() : 0) +
           (crossing_guard_ ? crossing_guard_->looks() : 0) + (distance_guard_ ? distance_guard_->looks() : 0);
  }
  // The largest error of all collapses, in units of the mesh.
  double error_max() const { return surface_.scale().restored_length(error_max_); }
  bool is_at_goal() const { return mesh_.live().faces <= goal_.faces; }

  // As long as one lives nothing may change, and rule_of() is asked of many edges.
  CollapseSurface::Standstill standstill() const { return CollapseSurface::Standstill(surface_); }
  // The first rule under which an edge is held: every place in either direction is refused by it or by one before it.
  // Free where there is one that is not.
  EdgeRule rule_of(Edge e) const;
  // Where the quadrics of both ends are lowest, so that an edge would collapse to it first.
  glm::dvec3 lowest_place(Edge e) const { return surface_.position_of(surface_.lowest(Freedom{halfedge(e)})); }

 private:
  enum class Answer { done, later, refused };
  enum class Legality { none, plain, at_hub, by_kernel };  // plain, also at a hub: as plain_collapse.h does it

  // An edge that is on the level of its cost.
  struct Candidate {
    Edge edge;
    Freedom freedom;
    Placing lowest;
    CollapseSurface::History history;
  };

  void fill_queue();
  // Until the goal is reached or no edge can collapse; false where it was cancelled.
  bool collapse_all(Progress& progress);
  // Adds the edges that can collapse after all; false where there are none.
  bool minds_less(bool has_collapsed);
  bool lets_boundaries_go();
  bool can_collapse(Edge e) const {
    return mesh_.is_alive(e) && !mesh_.is_wire(e) && surface_.freedom(halfedge(e)).is_possible &&
           rule_of(e) == EdgeRule::free;
  }
  bool find_further(Progress& progress);
  // What may be removed where it is smaller than the error.
  double small_size() const { return surface_.limits_error() ? surface_.error_limit() : error_max_; }
  // The part of an edge that cannot collapse, to be removed when the error has become as large as it.
  void note_small_part(Halfedge h);
  void remove_noted_parts();
  // Removes them, the smallest first, until the goal is reached.
  void remove_small_parts();
  void remove_part(std::span<const Vertex> part);
  // Into what vertices have been merged: none where they are their own, and else the last one. O(n).
  std::span<const Vertex> find_merged();
  // Moves vertices to where the surface lies nearer to the input, and with effort 2 swaps edges before
  // (simplifier_nearer.cpp). False where it was cancelled.
  bool come_nearer(Progress& progress);
  // Closes handles and joins parts (simplifier_topology.cpp). False where it was cancelled.
  bool change_topology(Progress& progress);
  std::size_t most_changes() const;
  bool close_handles();
  bool join_parts();
  bool may_exceed_distance(const std::array<Halfedge, 3>& sides, const std::array<Halfedge, 3>& against) const;
  void join(const std::array<Halfedge, 3>& sides, const std::array<Halfedge, 3>& against);
  // Swaps edges, moves vertices and collapses further until no face looks against the input or none of that helps
  // (simplifier_turned.cpp). False where it was cancelled.
  bool mend_turned(Progress& progress);
  std::vector<Face> find_turned();
  bool is_turned(const std::array<glm::dvec3, 3>& triangle) const { return sides_->is_turned(triangle); }
  bool is_turned(Face f) const;
  // How much is looked at for that.
  bool may_look_further() const;
  bool mend(Face f, std::vector<Face>& changed);
  bool swap_mends(Halfedge h);
  std::vector<glm::dvec3> ways_of(Vertex v, Face f) const;
  bool move_mends(Vertex v, Face f, bool may_pass_on);
  Vertex collapse_mends(Halfedge side);
  // How many faces around a vertex look against the input when it is at a position; counted up to what is enough to
  // know.
  std::size_t turned_around(Vertex v, const glm::dvec3& position,
                            std::size_t enough = std::numeric_limits<std::size_t>::max()) const;
  bool turns_fewer(Halfedge h, const Placing& placing) const;
  bool take_batch();
  void ask(Edge e);
  void warm_rings();
  Answer try_again(const Candidate& candidate);
  Answer try_edge(const Freedom& freedom, const Placing& lowest);
  Answer try_place(const Freedom& freedom, const Placing& placing, Legality legality);
  Legality legality(Halfedge h) const;
  bool kernel_allows(Halfedge h) const;
  // Whether an edge at a hub differs from any other between triangles by the valence alone.
  bool is_plain_at_hub(Halfedge h) const;
  // As quick_collapse(), without walking around the hub.
  QuickAnswer collapse_at_hub(Halfedge h) const;
  bool shares_neighbours_with_hub(Halfedge h) const;
  bool are_joined(Vertex v, Vertex hub) const;
  // Within the limit that was set, and within that of the shape.
  bool is_within_error(Halfedge h, const Placing& placing) const;
  bool makes_faces_meet(const Freedom& freedom, const Placing& placing) const;
  bool may_exceed_distance(const Freedom& freedom, const Placing& placing) const;
  void collapse(const Freedom& freedom, const Placing& placing, Legality legality);
  Halfedge directed(const Freedom& freedom, Legality legality);
  void write_collapse(Halfedge h, const Placing& placing, bool is_plain);
  void carry_values(Halfedge h, const Placing& placing);
  void collapse_by_kernel(Halfedge h, const Placing& placing, const glm::dvec3& position);
  void block(Edge e);
  bool is_hub(Vertex v) const;
  void unblock_around(Vertex v, const std::array<Vertex, 2>& apexes);
  EdgeRule refusal(const Freedom& freedom, const Placing& placing, EdgeRule none) const;

  Mesh& writable_;
  const Mesh& mesh_;
  Journal* steps_;
  std::optional<Edit> edit_;  // without a journal one for all
  SimplifyGoal goal_;
  CollapseSurface surface_;
  LevelQueue queue_;
  std::vector<Candidate> batch_;  // whose turn it is
  std::optional<CrossingGuard> crossing_guard_;
  std::optional<JumpLimit> jump_;
  mutable std::optional<DistanceGuard> distance_guard_;  // remembers its last proof
  const Mesh* input_;
  std::vector<Vertex> merged_into_;  // by vertex that went, where faces that look against the input are to be mended
  std::optional<InputSides> sides_;
  // Parts that can collapse no further by their sizes, each by one of its vertices; a heap, the smallest on top.
  std::vector<std::pair<double, Vertex>> noted_parts_;
  std::vector<std::uint8_t> is_blocked_;   // by edge
  std::vector<std::uint8_t> has_blocked_;  // by vertex: perhaps one of its edges is
  bool has_corner_values_, has_vertex_values_;
  bool has_triangles_alone_;  // and no copies
  // What a legal collapse leaves as it is: a vertex that stays has one fan or several as before, and a face that is one
  // simple loop stays one. So no hub and no large face is walked around again for each of its edges.
  mutable LocalFacts known_;
  // Two hubs: an edge between them, or none as long as neither has taken in anything.
  struct HubPair {
    Edge edge;
    CollapseSurface::History history;
  };
  mutable std::map<std::pair<Vertex, Vertex>, HubPair> hub_pairs_;
  std::size_t collapses_ = 0, asked_ = 0, removed_parts_ = 0, swaps_ = 0, moves_ = 0, turned_ = 0, still_turned_ = 0,
              passed_on_ = 0, closed_handles_ = 0, joined_parts_ = 0;
  bool has_parts_too_far_ = false;
  std::uint64_t farthest_looks_ = 0;  // for moves of what lies farthest
  std::uint64_t warmed_ = 0;          // edges around the ends of those that were about to collapse
  double error_max_ = 0;
  CollapseSurface::Minds minds_ = CollapseSurface::Minds::input;  // less where nothing else can collapse
};

// The rules of what is left by edge slot, as EdgeRule: the first one that holds an edge of faces, that of the first of
// its sheets where its points have several; no_rule for every other slot, and of those left where it was cancelled.
// Cost: that of asking every edge.
std::vector<std::uint8_t> find_remaining(const Mesh& mesh, const Simplifier& simplifier, Progress& progress);
// How many edges stand under each, counted on points as in figures.
std::vector<std::size_t> count_remaining(const Mesh& mesh, std::span<const std::uint8_t> rules);

}  // namespace ryosen
