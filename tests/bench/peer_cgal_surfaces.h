// CGAL's subdivision and isotropic remeshing behind plain functions, and the figures by which results are compared.
#pragma once

#include <memory>

#include "ryosen/indexed/indexed.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::bench {

struct SurfaceQuality {
  std::size_t faces = 0;
  double mean_length = 0, spread = 0;  // in shares of the wanted length: the mean and the standard deviation
  double smallest_angle_deg = 0,
         mean_angle_deg = 0;                     // the smallest of all, and the mean of the smallest of each triangle
  double narrow = 0;                             // the share of triangles with an angle below 30 degrees
  double valence_six = 0, valence_near_six = 0;  // the share of the vertices; of those of 5 to 7
};
SurfaceQuality quality_of(const Mesh& mesh, double wanted_length);

class SurfacesPeer {
 public:
  explicit SurfacesPeer(const IndexedMesh& source);
  ~SurfacesPeer();
  SurfacesPeer(const SurfacesPeer&) = delete;
  SurfacesPeer& operator=(const SurfacesPeer&) = delete;

  // Of one step on a copy, which is not counted; by the first letter of the scheme: L, C or s.
  double milliseconds_of_step(char scheme) const;
  double milliseconds_of_remeshing(double length, unsigned rounds, IndexedMesh& made) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace ryosen::bench
