#include "ryosen/algo/repair/seen_area.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "ryosen/algo/unit_scale.h"
#include "ryosen/analysis/box_tree.h"
#include "ryosen/analysis/surface_triangles.h"
#include "ryosen/base/interruption.h"
#include "ryosen/base/parallel.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/ray.h"
#include "ryosen/mesh/triangle_corners.h"

namespace ryosen {

namespace {

// A ray begins that far from its triangle, in units of about the largest coordinate: more than the rounding of its
// centre.
constexpr double first_step = 1e-10;
// Boxes are that much larger: more than the rounding of a ray, but such that it begins outside the boxes of faces that
// lie in one plane with its own, across an axis.
constexpr double margin = 1e-12;

// The sides of a triangle that are seen, as bits.
enum Seen : std::uint8_t { nowhere = 0, from_front = 1, from_behind = 2 };

class Looking {
 public:
  Looking(const Mesh& mesh, const std::vector<std::uint32_t>& patch) : mesh_(mesh), surface_(mesh) {
    const double scale = unit_scale(mesh.positions());
    for (const glm::dvec3& p : mesh.positions()) places_.push_back(p * scale);
    std::vector<Placed> placed;
    for (std::uint32_t i = 0; i < surface_.slots(); ++i) {
      stop_if_interrupted(i);
      const SurfaceTriangle t = surface_.at(mesh, i);
      if (t.face == no_index) continue;
      if (patch[t.face] != no_index) asked_.push_back(i);
      placed.push_back(placed_at(t, i));
    }
    unite(std::move(placed));
  }

  std::vector<SeenArea> look(const std::vector<std::uint32_t>& patch, std::uint32_t patches, Progress& progress) const {
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t slot : asked_) numbers.push_back(number_[slot]);
    sort_unique(numbers);
    const auto count = static_cast<std::uint32_t>(numbers.size());
    std::vector<std::uint8_t> seen(slots_.size(), nowhere);
    constexpr std::uint32_t step = 1 << 14;
    for (std::uint32_t begin = 0; begin < count; begin += step) {
      if (!progress.go_on(begin, count)) return std::vector<SeenArea>(patches);
      const std::uint32_t size = std::min(step, count - begin);
      for_each_part(size, threads_for(count), [&](unsigned, std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t i = begin + first; i < begin + last; ++i) seen[numbers[i]] = seen_from(slots_[numbers[i]]);
      });
    }
    std::vector<SeenArea> areas(patches);
    for (const std::uint32_t slot : asked_) {
      const SurfaceTriangle t = surface_.at(mesh_, slot);
      const std::uint32_t number = number_[slot];
      const double area = glm::length(area_normal(corners_of(t)));
      SeenArea& sum = areas[patch[t.face]];
      const bool is_over = is_turned_[slot] != is_turned_[slots_[number]];
      if ((seen[number] & from_front) != 0) (is_over ? sum.behind : sum.front) += area;
      if ((seen[number] & from_behind) != 0) (is_over ? sum.front : sum.behind) += area;
    }
    return areas;
  }

 private:
  // The places of a triangle in an order of their bits.
  struct Placed {
    std::array<std::array<std::uint64_t, 3>, 3> places;
    std::uint32_t slot;
    bool is_turned;
    friend auto operator<=>(const Placed&, const Placed&) = default;
  };

  Placed placed_at(const SurfaceTriangle& t, std::uint32_t slot) const {
    Placed placed{{}, slot, false};
    const auto corners = corners_of(t);
    for (std::size_t k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis)
        placed.places[k][static_cast<std::size_t>(axis)] = std::bit_cast<std::uint64_t>(corners[k][axis] + 0.0);
    for (const std::size_t k : {0u, 1u, 0u}) {
      if (placed.places[k] <= placed.places[k + 1]) continue;
      std::swap(placed.places[k], placed.places[k + 1]);
      placed.is_turned = !placed.is_turned;
    }
    return placed;
  }

  // Triangles on the same places are one in the tree, however many they are.
  void unite(std::vector<Placed> placed) {
    std::sort(placed.begin(), placed.end());
    number_.resize(surface_.slots());
    is_turned_.resize(surface_.slots());
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const std::uint32_t slot = placed[i].slot;
      is_turned_[slot] = placed[i].is_turned;
      if (i == 0 || placed[i].places != placed[i - 1].places) {
        const Box box = box_of(corners_of(surface_.at(mesh_, slot)));
        boxes.push_back({box.lowest - margin, box.highest + margin});
        slots_.push_back(slot);
      }
      number_[slot] = static_cast<std::uint32_t>(slots_.size() - 1);
    }
    tree_ = BoxTree(std::move(boxes));
  }

  TriangleCorners corners_of(const SurfaceTriangle& t) const {
    return {places_[t.corners[0]], places_[t.corners[1]], places_[t.corners[2]]};
  }

  std::uint8_t seen_from(std::uint32_t slot) const {
    stop_if_interrupted();
    const SurfaceTriangle t = surface_.at(mesh_, slot);
    const TriangleCorners corners = corners_of(t);
    const glm::dvec3 normal = area_normal(corners), middle = box_of(corners).middle();
    const double area = glm::length(normal);
    if (!(area > 0)) return nowhere;
    const glm::dvec3 centre = (corners[0] + corners[1] + corners[2]) / 3.0;
    const auto is_free = [&](double sign) { return !meets_any({centre, normal * (sign / area), first_step}, middle); };
    return static_cast<std::uint8_t>((is_free(1) ? from_front : nowhere) | (is_free(-1) ? from_behind : nowhere));
  }

  // Ends at the first one that is found, wherever it is along the ray. Boxes ahead of that with this middle come before
  // those behind, and the nearer ones first: where many lie over each other, those just ahead are most likely met.
  bool meets_any(const Ray& ray, const glm::dvec3& middle) const {
    const RayCaster caster(ray);
    const auto may = [&](const Box& box) { return passes(ray, box); };
    const auto key = [&](const Box& box) {
      const double ahead = glm::dot(box.middle() - middle, ray.direction);
      return std::pair(ahead < 0, std::abs(ahead));
    };
    return !tree_.visit_by(may, key, [&](std::uint32_t i) {
      const auto [a, b, c] = corners_of(surface_.at(mesh_, slots_[i]));
      return !caster.hit(a, b, c);
    });
  }

  static bool passes(const Ray& ray, const Box& box) {
    double first = first_step, last = ray.t_max;
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
  std::vector<std::uint32_t> asked_;   // slots of triangles
  BoxTree tree_;                       // of all triangles, one where several are
  std::vector<std::uint32_t> slots_;   // by number in the tree
  std::vector<std::uint32_t> number_;  // in the tree, by slot
  std::vector<bool> is_turned_;        // by slot: the loop runs against the order of its places
};

}  // namespace

std::vector<SeenArea> seen_areas(const Mesh& mesh, const std::vector<std::uint32_t>& patch, std::uint32_t patches,
                                 Progress& progress) {
  if (patches == 0) return {};
  return Looking(mesh, patch).look(patch, patches, progress);
}

}  // namespace ryosen
