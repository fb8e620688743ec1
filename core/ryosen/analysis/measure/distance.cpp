#include "ryosen/analysis/measure/distance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/analysis/measure/measured_surface.h"
#include "ryosen/analysis/measure/one_way.h"
#include "ryosen/base/parallel.h"

namespace ryosen {

namespace {

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
