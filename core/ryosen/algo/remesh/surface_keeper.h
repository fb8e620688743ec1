// Judges the steps of remeshing by what becomes of the surface.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <unordered_set>

#include "ryosen/algo/crossings/crossing_guard.h"
#include "ryosen/algo/remesh/covered_points.h"
#include "ryosen/geometry/box.h"

namespace ryosen::remesh {

// Parts of space, as equal cubes, where steps are judged more closely.
class WatchedPlaces {
 public:
  explicit WatchedPlaces(double cell) : cell_(cell) {}

  // The cubes of a box and those beside them; all of space, where they would be very many.
  void add(const Box& box);
  void add_all() { is_all_ = true; }
  bool contains(const glm::dvec3& place) const {
    return is_all_ || (!cells_.empty() && cells_.count(cell_of(place)) > 0);
  }
  bool is_all() const { return is_all_; }
  bool is_empty() const { return !is_all_ && cells_.empty(); }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& c) const;
  };
  Cell cell_of(const glm::dvec3& place) const;

  double cell_;
  bool is_all_ = false;
  std::unordered_set<Cell, Hash> cells_;
};

// A step is asked about, and if it is allowed and done, told. None may leave a point of the surface as it was farther
// away than a reach (covered_points.h); and in the places that are watched none may make faces meet (crossing_guard.h).
class SurfaceKeeper {
 public:
  // Keeps a mesh of triangles near these points of it. Nothing is watched where `watched` is empty. At the places of
  // `met` faces may meet, since they do.
  SurfaceKeeper(const Mesh& mesh, CoveredPoints points, const WatchedPlaces& watched, const MetPlaces& met);
  SurfaceKeeper(const SurfaceKeeper&) = delete;
  SurfaceKeeper& operator=(const SurfaceKeeper&) = delete;

  bool allows_collapse(Halfedge h, const glm::dvec3& place, double reach);
  void collapsed();
  bool allows_swap(Halfedge h, double reach);
  void swapped(Halfedge h);
  // Into halves that meet at `place`, which is on the edge but for rounding.
  bool allows_split(Halfedge h, const glm::dvec3& place);
  // The middle, and the copies of it behind it; the first of the faces that are new.
  void split(Vertex first_copy, Face first_new);

  // Moves of vertices. Where may_move_beside() is true, several threads may have a judge each, as long as none moves a
  // vertex that has a face in common with one that another moves.
  class MoveJudge {
   public:
    explicit MoveJudge(SurfaceKeeper& keeper) : keeper_(keeper), step_(keeper.points_) {}
    bool allows(Vertex v, const glm::dvec3& place, double reach);
    void moved(Vertex v);

   private:
    bool keeps_points(Vertex v, const glm::dvec3& place, double reach);

    SurfaceKeeper& keeper_;
    CoveredStep step_;
    std::vector<CoveredStep::Change> changes_;
  };
  bool may_move_beside();

  // From here on points of the surface may lie so many times as far from it as is told. Where that is infinite they may
  // lie anywhere, but no step makes more faces meet than it parts.
  void widen(double reach);

  // How many steps were refused since faces would have met.
  std::size_t refused() const { return refused_; }

 private:
  using Changes = std::vector<CoveredStep::Change>;
  // Those around a vertex but for two, as they become when it comes to a place; false where they are too many.
  bool add_around(Changes& changes, Vertex v, const glm::dvec3& place, Face left = {}, Face right = {}) const;
  bool is_watched(const glm::dvec3& place) const {
    return guard_ && (!std::isfinite(widened_) || watched_.contains(place));
  }
  bool stays_near(std::span<const CoveredStep::Change> changes, double reach, CoveredStep& step) const;
  bool refuses(bool would_meet);

  const Mesh& mesh_;
  const WatchedPlaces& watched_;
  const MetPlaces& met_;
  double widened_ = 1;  // infinite: the guard judges each step
  CoveredPoints points_;
  std::optional<CrossingGuard> guard_;
  std::size_t refused_ = 0;
  // Of the step asked about, if it is no move.
  CoveredStep step_;
  Changes changes_;
};

}  // namespace ryosen::remesh
