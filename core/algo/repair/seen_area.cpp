#include "core/algo/repair/seen_area.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "core/algo/unit_scale.h"
#include "core/analysis/box_tree.h"
#include "core/base/interruption.h"
#include "core/base/parallel.h"
#include "core/pick/ray.h"
#include "core/pick/surface_triangles.h"

namespace ryosen {

namespace {

// A ray begins that far from its triangle, in units of about the largest coordinate: more than the rounding of its centre.
constexpr double first_step = 1e-10;

// The sides of a triangle that are seen, as bits.
enum Seen : std::uint8_t { nowhere = 0, from_front = 1, from_behind = 2 };

class Looking {
 public:
  Looking(const Mesh& mesh, const std::vector<std::uint32_t>& patch) : mesh_(mesh), surface_(mesh) {
    const double scale = unit_scale(mesh.positions());
    for (const glm::dvec3& p : mesh.positions()) places_.push_back(p * scale);
    std::vector<Box> boxes;
    for (std::uint32_t i = 0; i < surface_.slots(); ++i) {
      stop_if_interrupted(i);
      const SurfaceTriangle t = surface_.at(mesh, i);
      if (t.face == no_index) continue;
      if (patch[t.face] != no_index) asked_.push_back(i);
      const Box box = box_of(corners_of(t));
      boxes.push_back({box.lowest - first_step, box.highest + first_step});
      slots_.push_back(i);
    }
    tree_ = BoxTree(std::move(boxes));
  }

  std::vector<SeenArea> look(const std::vector<std::uint32_t>& patch, std::uint32_t patches, Progress& progress) const {
    const auto count = static_cast<std::uint32_t>(asked_.size());
    std::vector<std::uint8_t> seen(count, nowhere);
    constexpr std::uint32_t step = 1 << 14;
    for (std::uint32_t begin = 0; begin < count; begin += step) {
      if (!progress.go_on(begin, count)) return std::vector<SeenArea>(patches);
      const std::uint32_t size = std::min(step, count - begin);
      for_each_part(size, threads_for(count), [&](unsigned, std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t i = begin + first; i < begin + last; ++i) seen[i] = seen_from(asked_[i]);
      });
    }
    std::vector<SeenArea> areas(patches);
    for (std::uint32_t i = 0; i < count; ++i) {
      const SurfaceTriangle t = surface_.at(mesh_, asked_[i]);
      const double area = glm::length(area_normal(t));
      if ((seen[i] & from_front) != 0) areas[patch[t.face]].front += area;
      if ((seen[i] & from_behind) != 0) areas[patch[t.face]].behind += area;
    }
    return areas;
  }

 private:
  std::array<glm::dvec3, 3> corners_of(const SurfaceTriangle& t) const {
    return {places_[t.corners[0]], places_[t.corners[1]], places_[t.corners[2]]};
  }
  glm::dvec3 area_normal(const SurfaceTriangle& t) const {
    const auto [a, b, c] = corners_of(t);
    return glm::cross(b - a, c - a);
  }

  std::uint8_t seen_from(std::uint32_t slot) const {
    stop_if_interrupted();
    const SurfaceTriangle t = surface_.at(mesh_, slot);
    const glm::dvec3 normal = area_normal(t);
    const double area = glm::length(normal);
    if (!(area > 0)) return nowhere;
    const auto [a, b, c] = corners_of(t);
    const glm::dvec3 centre = (a + b + c) / 3.0;
    const auto is_free = [&](double sign) { return !meets_any({centre, normal * (sign / area), first_step}); };
    return static_cast<std::uint8_t>((is_free(1) ? from_front : nowhere) | (is_free(-1) ? from_behind : nowhere));
  }

  // Ends at the first one that is found, wherever it is along the ray.
  bool meets_any(const Ray& ray) const {
    const RayCaster caster(ray);
    const auto may = [&](const Box& box) { return passes(ray, box); };
    return !tree_.visit(may, [&](std::uint32_t i) {
      const auto [a, b, c] = corners_of(surface_.at(mesh_, slots_[i]));
      return !caster.hit(a, b, c);
    });
  }

  static bool passes(const Ray& ray, const Box& box) {
    double first = 0, last = ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
      const double from = box.lowest[axis] - ray.origin[axis], to = box.highest[axis] - ray.origin[axis];
      if (ray.direction[axis] == 0) {
        if (from > 0 || to < 0) return false;
        continue;
      }
      const double s = from / ray.direction[axis], t = to / ray.direction[axis];
      first = std::max(first, std::min(s, t));
      last = std::min(last, std::max(s, t));
    }
    return first <= last;
  }

  const Mesh& mesh_;
  SurfaceTriangles surface_;
  std::vector<glm::dvec3> places_;
  std::vector<std::uint32_t> asked_;  // slots of triangles
  BoxTree tree_;                      // of all triangles
  std::vector<std::uint32_t> slots_;  // by number in the tree
};

}  // namespace

std::vector<SeenArea> seen_areas(const Mesh& mesh, const std::vector<std::uint32_t>& patch, std::uint32_t patches,
                                 Progress& progress) {
  if (patches == 0) return {};
  return Looking(mesh, patch).look(patch, patches, progress);
}

}  // namespace ryosen
