// Judges the steps of remeshing by what becomes of the surface.
#pragma once

#include <optional>

#include "core/algo/crossing_guard.h"
#include "core/algo/remesh/covered_points.h"
#include "core/algo/remesh/watched_places.h"

namespace ryosen::remesh {

// A step is asked about, and if it is allowed and done, told. None may leave a point of the surface as it was farther away
// than a reach (covered_points.h); and in the places that are watched none may make faces meet (crossing_guard.h).
class SurfaceKeeper {
 public:
  // Of a mesh of triangles, with points so far from each other. Nothing is watched where `watched` is empty.
  SurfaceKeeper(const Mesh& mesh, const Features& features, double spacing, const WatchedPlaces& watched,
                CrossingGuard::Surface surface);

  bool allows_collapse(Halfedge h, const glm::dvec3& place, double reach);
  void collapsed();
  bool allows_move(Vertex v, const glm::dvec3& place, double reach);
  void moved(Vertex v);
  bool allows_swap(Halfedge h, double reach);
  void swapped(Halfedge h);
  // Into halves that meet at `place`, which is on the edge but for rounding.
  bool allows_split(Halfedge h, const glm::dvec3& place);
  // The middle, and the copies of it behind it; the first of the faces that are new.
  void split(Vertex first_copy, Face first_new);

  // How many steps were refused since faces would have met.
  std::size_t refused() const { return refused_; }

 private:
  using Kind = CoveredPoints::Change::Kind;
  void add(Face f, Kind kind, const Corners& corners = {}, double moved = 0) {
    changes_.push_back({f, kind, corners, moved});
  }
  // Whether it is plain that each face around a vertex keeps its points if that moves.
  bool keeps_points(Vertex v, const glm::dvec3& place, double reach);
  // Those around a vertex but for two, as they become when it comes to a place; false where they are too many.
  bool add_around(Vertex v, const glm::dvec3& place, Face left = {}, Face right = {});
  bool is_watched(const glm::dvec3& place) const { return guard_ && watched_.contains(place); }
  bool refuses(bool would_meet);

  const Mesh& mesh_;
  const WatchedPlaces& watched_;
  CoveredPoints points_;
  std::optional<CrossingGuard> guard_;
  std::size_t refused_ = 0;
  std::vector<CoveredPoints::Change> changes_;  // of the step asked about
};

}  // namespace ryosen::remesh
