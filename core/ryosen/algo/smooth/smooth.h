// Smoothing: points move towards the mean of their neighbours, connectivity stays.
//
//   laplace    p + s (mean - p)                                       s: the strength, at most 1
//   implicit   the p' with p' - s (mean' - p') = p [Desbrun99]        any strength
//   taubin     laplace with s, then with 1 / (k - 1 / s), which is negative [Taubin95]: what varies slowly
//              (below the pass band k) neither shrinks nor grows
//
// Weights: laplacian.h; those of the cotangents are formed again before each step. A share of less than 1 lowers the
// strength. Points with copies or several fans, and ends of wires, stay; so do points without a finite place and those
// beside them count without them.
#pragma once

#include <optional>

#include "ryosen/algo/smooth/keep_volume.h"
#include "ryosen/base/progress.h"

namespace ryosen::smooth {

enum class Method { laplace, implicit, taubin };
// locked: its points stay. sliding: they move along the curve that the boundary was, towards the middle of their
// neighbours on it; where it bends by more than 45 degrees they stay. free: they move as all others.
enum class BoundaryRule { locked, sliding, free };

struct Options {
  Method method = Method::laplace;
  WeightKind weights = WeightKind::cotangent;
  BoundaryRule boundary = BoundaryRule::locked;
  std::size_t steps = 10;
  double strength = 0.5;   // above 0
  double pass_band = 0.1;  // of taubin
  bool keeps_volume = false;
};

struct Smoothed {
  Places places;  // per vertex slot; that of a point stands for its copies
  KeptVolume volume;
  bool is_cancelled = false;
};

// `shares`: per vertex slot, of the points from 0 to 1. Cost: the steps times n, implicit ones times what the solver
// takes.
Smoothed smoothed(const Mesh& mesh, const Options& options, std::vector<double> shares, Progress& progress);

}  // namespace ryosen::smooth
