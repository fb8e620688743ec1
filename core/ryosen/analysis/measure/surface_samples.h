// A surface measured at samples.
#pragma once

#include "ryosen/analysis/measure/distance.h"
#include "ryosen/analysis/measure/farthest.h"
#include "ryosen/analysis/measure/sampled_piece.h"

namespace ryosen {

struct SampleSums {
  double weight = 0, distance = 0, square = 0;
  std::uint64_t samples = 0;
};

// A cell whose bound may be larger than the largest distance found. Bounds are floats that are not below it.
struct OpenSample {
  std::uint32_t piece, cell;
  float bound;
  std::array<std::uint32_t, 3> near;  // what is nearest to its corners
};

struct SurfaceSamples {
  std::vector<SampledPiece> pieces;
  double area = 0;
  SampleSums sums;
  Farthest farthest;             // the bound is that of all cells but the open ones
  std::vector<OpenSample> open;  // in no order

  FarthestCell cell(const TriangleTree& from, const TriangleTree& to, const OpenSample& open) const;
};

// Where its progress is then, of the whole of one way.
constexpr double share_of_samples = 0.75;

// Of `from`, about options.samples, in units of the trees. The same for any number of threads. False where `progress`
// cancels.
bool take_samples(SurfaceSamples& samples, const TriangleTree& from, const TriangleTree& to,
                  const DistanceOptions& options, FarEnough enough, unsigned threads, Progress& progress);

}  // namespace ryosen
