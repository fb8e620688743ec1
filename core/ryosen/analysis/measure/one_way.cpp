#include "ryosen/analysis/measure/one_way.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/analysis/measure/surface_samples.h"
#include "ryosen/base/parallel.h"

namespace ryosen {

namespace {

// What rounding may take from a length that is computed from coordinates, as a share.
constexpr double rounding = 0x1p-50;

bool has_exact_length(const glm::dvec3& way) {
  const double square = glm::dot(way, way), length = std::sqrt(square);
  if (std::fma(length, length, -square) != 0) return false;
  // One coordinate alone, or squares that add up without rounding.
  const double x = way.x * way.x, y = way.y * way.y, z = way.z * way.z;
  return std::fma(way.x, way.x, -x) == 0 && std::fma(way.y, way.y, -y) == 0 && std::fma(way.z, way.z, -z) == 0 &&
         (x + y) - x == y && (x + y) - y == x && square - (x + y) == z && square - z == x + y;
}

// The cells whose bounds the samples left open.
bool search_open_cells(SurfaceSamples& samples, const TriangleTree& from, const TriangleTree& to, FarEnough enough,
                       unsigned threads, Progress& progress) {
  std::vector<OpenSample>& open = samples.open;
  std::sort(open.begin(), open.end(), [](const OpenSample& a, const OpenSample& b) {
    if (a.bound != b.bound) return a.bound > b.bound;
    return a.piece != b.piece ? a.piece < b.piece : a.cell < b.cell;
  });
  const FarCells cells{open.size(), [&](std::size_t i) { return double(open[i].bound); },
                       [&](std::size_t i) { return samples.cell(from, to, open[i]); }};
  const std::uint64_t most_steps = 2000000 + 8 * samples.sums.samples;
  return search_farthest(samples.farthest, to, cells, enough, most_steps, threads, progress);
}

}  // namespace

bool measure_one_way(OneWayDistance& way, const TriangleTree& from, const TriangleTree& to,
                     const DistanceOptions& options, Progress& progress) {
  const FarEnough enough{options.gap, 2e-10 * std::max(from.reach(), to.reach()) + 0x1p-50};
  const unsigned threads = options.threads ? options.threads : threads_for(from.size() + options.samples);
  SurfaceSamples samples;
  if (!take_samples(samples, from, to, options, enough, threads, progress) ||
      !progress.go_on(static_cast<std::size_t>(1000 * share_of_samples), 1000) ||
      !search_open_cells(samples, from, to, enough, threads, progress))
    return false;
  const auto& [distance, bound, place, cuts] = samples.farthest;
  way.cuts = cuts;
  way.area = samples.area;
  way.samples = samples.sums.samples;
  way.mean = samples.sums.distance / samples.sums.weight;
  way.rms = std::sqrt(samples.sums.square / samples.sums.weight);
  way.from = place;
  way.face = Face(from.owner(from.nearest(place).triangle));
  const glm::dvec3 longest = to.way(place, to.nearest(place).triangle);
  way.to = place - longest;
  way.hausdorff = bound == distance && has_exact_length(longest) ? bound : bound * (1 + rounding);
  way.hausdorff_gap = way.hausdorff - distance;
  return true;
}

}  // namespace ryosen
