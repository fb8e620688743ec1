// Remeshing: other triangles on the same surface.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "ryosen/algo/remesh/target.h"
#include "ryosen/algo/seams/seam_mode.h"
#include "ryosen/base/message.h"
#include "ryosen/base/progress.h"
#include "ryosen/mesh/descent.h"

namespace ryosen::remesh {

struct Options {
  double length = 0;      // of edges, above 0
  bool adaptive = false;  // shorter where the surface bends (target.h)
  double tolerance = 0;   // of adaptive ones, above 0
  std::size_t rounds = 5;
  double feature_angle_rad = 0.8;
  SeamMode seams = SeamMode::weighed;
  std::span<const Vertex> on_lines = {};  // something beside the mesh hangs on them, so that they stay
};

struct Remeshed {
  MeshColumns columns;
  std::size_t cut_faces = 0;             // polygons, cut into triangles first
  std::size_t refused = 0;               // steps that would have made faces meet
  std::vector<Edge> held_by_seams = {};  // too short, see remesher.h
  bool is_cancelled = false;
  std::optional<Text> fault = {};
};

// Rounds of remesher.h. Elements that stay keep their numbers, new ones come behind them. Of a surface without
// self-intersections comes one without: where faces meet in the end, it begins again and watches these places, and at
// last all of them. Of one in which faces meet comes one in which none meet elsewhere, unless more than 100,000 pairs
// do, or two million then: those are let be. Weighed seams are lines along which points may leave; normals of flat
// faces are no seams then, and are made anew. A length for which there is no room is a fault. `descent`: told where
// elements come from, as an edit tells it. O(rounds times n log n).
Remeshed remeshed(const Mesh& mesh, const Options& options, Progress& progress, Descent* descent = nullptr);

struct SwapOptions {
  double most_turn_rad = 0;
  SeamMode seams = SeamMode::weighed;
};

struct Swapped {
  MeshColumns columns;
  std::size_t cut_faces = 0, swaps = 0;
  std::size_t refused = 0;               // edges that are not Delaunay and may not be swapped
  std::vector<Edge> held_by_seams = {};  // those that are not Delaunay either, but seams
  bool is_cancelled = false;
  std::optional<Text> fault = {};
};

// Swaps edges whose opposite angles are together above 180 degrees and whose faces bend by at most `most_turn_rad`, as
// long as the cotangents of the angles of both triangles together become less, which comes to an end [Bobenko07].
// Features (features.h, with that angle) stay, and so does each seam, since a swap would tear its charts; where seams
// are weighed, normals of flat faces are none, and are made anew. `descent`: told where elements come from; a swapped
// edge is new there.
Swapped delaunay_swapped(const Mesh& mesh, const SwapOptions& options, Progress& progress, Descent* descent = nullptr);

}  // namespace ryosen::remesh
