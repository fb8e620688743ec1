// Simplification by collapses of edges, the one of least error first [Garland97].
//
// An edge waits on a level of its cost, which is a lower bound: what its ends stand for only grows. It is asked anew when
// its turn comes, and goes to a higher level or collapses. One that is refused is blocked until something around it
// changes. So nothing is written to the queue where a neighbour collapses.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/algo/simplify/collapse_surface.h"
#include "core/algo/simplify/crossing_guard.h"
#include "core/algo/simplify/level_queue.h"
#include "core/base/progress.h"
#include "core/mesh/edit.h"

namespace ryosen {

struct SimplifyGoal {
  std::size_t faces = 0;  // live ones: not more than these
  unsigned effort = 1;    // 0 to 2
  // No faces may come to meet: of a mesh of triangles, none of which do.
  bool no_self_intersections = false;
  // Where the goal is not reached, parts of the surface go that are smaller than the error: than its limit, or without
  // one, than the largest error that was made.
  bool removes_small_parts = false;
};

class Simplifier {
 public:
  // Collapses edges of this mesh, each as an entry of a journal where there is one; without one what it writes is final,
  // so that it is to be a copy. Both must outlive it.
  Simplifier(Mesh& mesh, const CollapseLimits& limits, const SimplifyGoal& goal, Journal* steps = nullptr);

  // Until the goal is reached or no edge can collapse; false where it was cancelled.
  bool run(Progress& progress);

  std::size_t collapses() const { return collapses_; }
  std::size_t removed_parts() const { return removed_parts_; }
  std::size_t asked() const { return asked_; }
  // The largest error of all collapses, in units of the mesh.
  double error_max() const { return surface_.scale().restored_length(error_max_); }
  bool is_at_goal() const { return mesh_.live().faces <= goal_.faces; }

  // The first rule under which an edge is held: every place in either direction is refused by it or by one before it.
  // Free where there is one that is not.
  EdgeRule rule_of(Edge e) const;

 private:
  enum class Answer { done, later, refused };

  void fill_queue();
  // Adds the edges that can collapse after all; false where there are none.
  bool find_further();
  // Removes them, the smallest first, until the goal is reached.
  void remove_small_parts();
  Answer try_edge(Edge e);
  Answer try_place(const Freedom& freedom, const Placing& placing);
  bool is_legal(Halfedge h) const;
  // That of a placing, in units of the mesh; to the bit that of an end where it is one.
  glm::dvec3 position_of(const Placing& placing) const;
  bool makes_faces_meet(const Freedom& freedom, const Placing& placing) const;
  void collapse(const Freedom& freedom, const Placing& placing);
  void write_collapse(Halfedge h, const Placing& placing, bool is_plain);
  void collapse_by_kernel(Halfedge h, const Placing& placing, const glm::dvec3& position);
  void block(Edge e);
  void unblock_around(Vertex v);
  std::optional<EdgeRule> refusal(const Freedom& freedom, const Placing& placing) const;

  Mesh& writable_;
  const Mesh& mesh_;
  Journal* steps_;
  std::optional<Edit> edit_;  // without a journal one for all
  SimplifyGoal goal_;
  CollapseSurface surface_;
  LevelQueue queue_;
  std::optional<CrossingGuard> guard_;
  std::vector<std::uint8_t> is_blocked_;   // by edge
  std::vector<std::uint8_t> has_blocked_;  // by vertex: perhaps one of its edges is
  bool has_corner_values_, has_vertex_values_;
  std::size_t collapses_ = 0, asked_ = 0, removed_parts_ = 0;
  double error_max_ = 0;
};

}  // namespace ryosen
