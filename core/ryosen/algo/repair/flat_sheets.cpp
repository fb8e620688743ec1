#include "ryosen/algo/repair/flat_sheets.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

namespace {

// Goes over the sheets at the rims, each once.
class Sheeting {
 public:
  Sheeting(const Mesh& mesh, const Rims& rims) : mesh_(mesh), rims_(rims), seen_(mesh.face_slots(), false) {}

  // Whether the sheet at the rim lies in the plane of the rim and faces the other way than a patch. Asked for the
  // largest rim of a sheet, since that tells the plane best; for others of the sheet the answer is no.
  bool is_border_of_flat(std::uint32_t hole, Halfedge start) {
    const Face first = mesh_.face(twin(start));
    if (seen_[first.index]) return false;
    const RimPlane& plane = *rims_.planes[hole];
    // The fit may lean within the tolerance. What is as thick as wide is no sheet, however small.
    const double most = std::min(2 * plane.tolerance(), std::sqrt(polygon_area(rims_.places[hole])) / 64);
    std::vector<Face> open{first};
    seen_[first.index] = true;
    bool is_flat = true;
    double faces_along = 0;
    for (std::size_t next = 0; next < open.size(); ++next) {
      std::vector<glm::dvec3> corners;
      for (Halfedge h : halfedges_around(mesh_, open[next])) {
        corners.push_back(mesh_.position(mesh_.from(h)));
        is_flat = is_flat && plane.distance(corners.back()) <= most;
        const Face beyond = mesh_.face(twin(h));
        if (!beyond || seen_[beyond.index]) continue;
        seen_[beyond.index] = true;
        open.push_back(beyond);
      }
      if (is_flat) faces_along += glm::dot(plane.normal(), polygon_normal(corners)) * polygon_area(corners);
    }
    return is_flat && faces_along < 0;
  }

 private:
  const Mesh& mesh_;
  const Rims& rims_;
  std::vector<bool> seen_;  // by face
};

}  // namespace

void tell_flat_sheets(const Mesh& mesh, const Rims& rims, std::vector<Hole>& holes) {
  std::vector<std::pair<double, std::uint32_t>> by_area;
  for (std::uint32_t i = 0; i < holes.size(); ++i)
    if (rims.planes[i]) by_area.emplace_back(polygon_area(rims.places[i]), i);
  std::stable_sort(by_area.begin(), by_area.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  Sheeting sheeting(mesh, rims);
  for (const auto& [area, i] : by_area)
    if (sheeting.is_border_of_flat(i, holes[i].start)) holes[i].cause = WhyOpen::flat_sheet;
}

}  // namespace ryosen
