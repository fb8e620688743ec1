// How far two surfaces are from each other: mean, root mean square and largest distance, in both directions.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "ryosen/base/progress.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

struct DistanceOptions {
  double gap = 1e-6;  // of the largest distance, how much the bound may be above it; more than 0
  // About so many per direction, one per triangle at least; 0: as many as the larger mesh has triangles, 200000 at
  // least.
  std::uint64_t samples = 0;
  unsigned threads = 0;  // 0 chooses; the result is the same bytes for any number
};

// Of the points of one surface from another. Lengths are in the unit of the meshes.
//
// mean and rms are integrals over the area: the surface is cut into triangles of about equal area, in each of which the
// middle counts 3/4 and the corners 1/12, a rule that is exact for squares of distances from a plane. Where the
// distance is smooth the error falls with the third power of the spacing of the samples, elsewhere (where the nearest
// triangle changes, or the surfaces cross) with the second. Without any area every triangle counts the same.
//
// hausdorff is an upper bound of the largest distance of all points of the surface, hausdorff - hausdorff_gap one that
// a point was found to have: [Tang09]'s branch and bound, except that a part between several nearest triangles is
// bounded by cutting it where their distances are equal. The gap is at most the wanted share, or 1e-10 of the size of
// the meshes, unless the work grows out of proportion to theirs. The bound is rounded up, by 1e-15 of it where the
// length is not exact; all up to the rounding of coordinates, about 1e-15 of the largest.
struct OneWayDistance {
  double mean = 0, rms = 0, hausdorff = 0, hausdorff_gap = 0;
  glm::dvec3 from{0.0}, to{0.0};        // where the largest distance was found, and the nearest point there
  Face face;                            // that `from` is on
  std::uint64_t samples = 0, cuts = 0;  // cuts: of cells whose bound was not good enough
  double area = 0;
  std::size_t faces = 0, left_out = 0;  // measured; not measured since a corner is not finite
};

// The directions together: mean and rms over the area of both, the larger hausdorff.
struct SurfaceDistance {
  OneWayDistance forward, backward;  // from a, from b
  double mean = 0, rms = 0, hausdorff = 0, hausdorff_gap = 0;
  double diagonal = 0;  // of the box around the faces of a
};

// Whether there is anything to measure: a face with finite corners.
bool has_surface(const Mesh& mesh);

// See MeasuredSurface for what is measured. Both meshes have a surface. None where `progress` cancels. O(n log n) for
// surfaces that lie near each other, n the triangles and samples of both.
std::optional<SurfaceDistance> surface_distance(const Mesh& a, const Mesh& b, const DistanceOptions& options,
                                                Progress& progress);

}  // namespace ryosen
