#include "ryosen/hull/projection.h"

#include <array>

#include "ryosen/base/enum_table.h"
#include "ryosen/base/rows.h"
#include "ryosen/geometry/box.h"
#include "ryosen/geometry/is_finite.h"

namespace ryosen {

namespace {

constexpr std::array rows{
    ProjectionRow{Projection::none, "none", "None", "なし"},
    ProjectionRow{Projection::x, "x", "Along X", "X 方向"},
    ProjectionRow{Projection::y, "y", "Along Y", "Y 方向"},
    ProjectionRow{Projection::z, "z", "Along Z", "Z 方向"},
    ProjectionRow{Projection::best, "best", "Along the thinnest axis", "最も薄い軸の方向"},
};
static_assert(rows_are_in_order(rows, &ProjectionRow::projection));

int thinnest_axis(const std::vector<glm::dvec3>& points) {
  const Box box = box_of_finite(points);
  // Halves, since a difference of doubles may be beyond the largest one.
  const glm::dvec3 extent = box.highest / 2.0 - box.lowest / 2.0;
  int thinnest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (extent[axis] < extent[thinnest]) thinnest = axis;
  return thinnest;
}

}  // namespace

std::span<const ProjectionRow> projections() { return rows; }

const ProjectionRow* find_projection(std::string_view id) { return find_row(rows, id); }

void project(std::vector<glm::dvec3>& points, Projection projection) {
  if (projection == Projection::none) return;
  const int axis = projection == Projection::best ? thinnest_axis(points)
                                                  : static_cast<int>(projection) - static_cast<int>(Projection::x);
  for (glm::dvec3& p : points)
    if (is_finite(p)) p[axis] = 0;
}

}  // namespace ryosen
