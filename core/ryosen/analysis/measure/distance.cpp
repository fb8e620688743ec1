#include "ryosen/analysis/measure/distance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/analysis/measure/measured_surface.h"
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

// Fills in what follows from the trees, neither of which is empty: all of `way` but the numbers of faces, in the scale
// of the trees. `options.samples` is not 0. False where `progress` cancels. Progress is told on the calling thread.
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

// In the unit of the mesh; at the corners of the result the scale is taken back.
void scale_back(OneWayDistance& way, double scale) {
  for (double* const length : {&way.mean, &way.rms, &way.hausdorff, &way.hausdorff_gap}) *length /= scale;
  way.from /= scale;
  way.to /= scale;
  way.area = way.area / scale / scale;
}

}  // namespace

bool has_surface(const Mesh& mesh) { return !MeasuredSurface(mesh).is_empty(); }

std::optional<SurfaceDistance> surface_distance(const Mesh& a, const Mesh& b, const DistanceOptions& options,
                                                Progress& progress) {
  std::optional<MeasuredSurface> of_a, of_b;
  do_beside([&] { of_a.emplace(a); }, [&] { of_b.emplace(b); });
  if (!progress.go_on(0, 1)) return std::nullopt;
  const double scale = scale_for(std::max(of_a->reach(), of_b->reach()));
  TriangleTree tree_a, tree_b;
  do_beside([&] { tree_a = of_a->tree(scale); }, [&] { tree_b = of_b->tree(scale); });
  const std::uint64_t samples =
      options.samples > 0 ? options.samples : std::max<std::uint64_t>({tree_a.size(), tree_b.size(), 200000});

  SurfaceDistance result;
  const auto measure = [&](OneWayDistance& way, const MeasuredSurface& from, const TriangleTree& of,
                           const TriangleTree& to) {
    if (!measure_one_way(way, of, to, {options.gap, samples, options.threads}, progress)) return false;
    way.faces = from.faces;
    way.left_out = from.left_out;
    return true;
  };
  progress.begin_part(0, 2);
  if (!measure(result.forward, *of_a, tree_a, tree_b)) return std::nullopt;
  progress.begin_part(1, 2);
  if (!measure(result.backward, *of_b, tree_b, tree_a)) return std::nullopt;

  const OneWayDistance &f = result.forward, &g = result.backward;
  const double area = f.area + g.area, share = area > 0 ? f.area / area : 0.5;
  result.mean = share * f.mean + (1 - share) * g.mean;
  result.rms = std::sqrt(share * f.rms * f.rms + (1 - share) * g.rms * g.rms) / scale;
  result.mean /= scale;
  result.hausdorff = std::max(f.hausdorff, g.hausdorff);
  result.hausdorff_gap = result.hausdorff - std::max(f.hausdorff - f.hausdorff_gap, g.hausdorff - g.hausdorff_gap);
  result.hausdorff /= scale;
  result.hausdorff_gap /= scale;
  result.diagonal = glm::length(of_a->box.highest * scale - of_a->box.lowest * scale) / scale;
  scale_back(result.forward, scale);
  scale_back(result.backward, scale);
  return result;
}

}  // namespace ryosen
