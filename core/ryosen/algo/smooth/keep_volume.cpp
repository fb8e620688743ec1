#include "ryosen/algo/smooth/keep_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "ryosen/analysis/disjoint_sets.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen::smooth {

namespace {

// The corners of all faces, as points; faces with rings as their triangles.
struct FaceCorners {
  std::vector<std::uint32_t> corners, ends;

  explicit FaceCorners(const Mesh& mesh, double scale) {
    FacePolygon polygon;
    std::vector<CornerTriangle> cut;
    for (const Face f : live_faces(mesh)) {
      polygon.read(mesh, f);
      if (!polygon.is_finite()) continue;
      const auto add = [&](std::size_t corner) {
        corners.push_back(point(mesh, mesh.from(polygon.corners()[corner])).index);
      };
      if (mesh.has_rings(f)) {
        cut_scaled(mesh, scale, polygon, cut);
        for (const CornerTriangle& t : cut) {
          for (const std::uint32_t corner : t) add(corner);
          end();
        }
        continue;
      }
      for (std::size_t k = 0; k < polygon.corners().size(); ++k) add(k);
      end();
    }
  }
  // Calls visit(its corners) for each.
  template <class Visit>
  void for_each(const Visit& visit) const {
    std::uint32_t begin = 0;
    for (const std::uint32_t end : ends) {
      visit(std::span(corners).subspan(begin, end - begin));
      begin = end;
    }
  }

 private:
  void end() { ends.push_back(static_cast<std::uint32_t>(corners.size())); }
};

// How much volume a part has too much, as its points move by a share of its size: a cubic.
struct Cubic {
  double constant, linear, square, cube;

  static Cubic through(double at_less, double at_0, double at_1, double at_2) {
    const double square = 0.5 * (at_1 + at_less) - at_0, odd = 0.5 * (at_1 - at_less);
    const double cube = (at_2 - at_0 - 4 * square - 2 * odd) / 6;
    return {at_0, odd - cube, square, cube};
  }
  double at(double x) const { return constant + x * (linear + x * (square + x * cube)); }
  double slope(double x) const { return linear + x * (2 * square + x * 3 * cube); }

  // Among shares up to 1, each way; between two turning points there is one root at most.
  std::optional<double> root_nearest_0() const {
    std::array<double, 4> ends{-1, 1, 1, 1};
    const double a = 3 * cube, half = square, under = half * half - a * linear;
    if (under > 0) {
      const double q = -(half + std::copysign(std::sqrt(under), half));
      ends[1] = a != 0 ? std::clamp(q / a, -1.0, 1.0) : 1;
      ends[2] = q != 0 ? std::clamp(linear / q, -1.0, 1.0) : 1;
      if (ends[1] > ends[2]) std::swap(ends[1], ends[2]);
    }
    std::optional<double> nearest;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      double low = ends[i], high = ends[i + 1];
      if (!(at(low) * at(high) <= 0)) continue;
      const bool rises = at(high) > at(low);
      for (int step = 0; step < 100; ++step) {
        const double middle = 0.5 * (low + high);
        ((at(middle) < 0) == rises ? low : high) = middle;
      }
      if (const double root = 0.5 * (low + high); !nearest || std::abs(root) < std::abs(*nearest)) nearest = root;
    }
    return nearest;
  }
};

class VolumeKeeper {
 public:
  VolumeKeeper(const Mesh& mesh, double scale, std::span<const double> shares)
      : faces_(mesh, scale),
        shares_(shares),
        part_of_(shares.size()),
        is_open_(shares.size(), false),
        is_moved_(shares.size(), false) {
    DisjointSets parts(shares.size());
    faces_.for_each([&](std::span<const std::uint32_t> face) {
      for (const std::uint32_t corner : face) parts.join(face[0], corner);
    });
    for (std::uint32_t i = 0; i < part_of_.size(); ++i) part_of_[i] = parts.root(i);
    for (const std::uint32_t corner : faces_.corners)
      if (shares[corner] > 0) is_moved_[part_of_[corner]] = true;
    for (const Halfedge h : live_halfedges(mesh))
      if (mesh.is_boundary(edge(h))) is_open_[part_of_[point(mesh, mesh.from(h)).index]] = true;
  }

  KeptVolume keep(const Places& before, Places& places) const {
    const std::vector<double> wanted = volumes(before, before), sizes = sizes_of_parts(before);
    Places normals = slopes_of_points(places, before);
    for (glm::dvec3& n : normals)
      if (const double length = glm::length(n); length > 0) n /= length;
    const Places start = places;
    // The share of its size by which each part is moved.
    std::vector<double> moved(part_of_.size(), 0.0);
    const auto move = [&] {
      for (std::uint32_t i = 0; i < places.size(); ++i) {
        const std::uint32_t part = part_of_[i];
        places[i] = has_volume(part) && shares_[i] > 0
                        ? start[i] + (shares_[i] * moved[part] * sizes[part]) * normals[i]
                        : start[i];
      }
    };
    const auto volumes_at = [&](double share) {
      std::fill(moved.begin(), moved.end(), share);
      move();
      return volumes(places, before);
    };
    const std::vector<double> at_0 = volumes_at(0), at_1 = volumes_at(1), at_less = volumes_at(-1),
                              at_2 = volumes_at(2);
    std::vector<Cubic> lacks;
    lacks.reserve(moved.size());
    for (std::size_t i = 0; i < moved.size(); ++i) {
      lacks.push_back(
          Cubic::through(at_less[i] - wanted[i], at_0[i] - wanted[i], at_1[i] - wanted[i], at_2[i] - wanted[i]));
      moved[i] = lacks[i].root_nearest_0().value_or(0);
    }
    constexpr int corrections = 2;  // of what rounding of the cubic's values has left
    for (int round = 0; round < corrections; ++round) {
      move();
      const std::vector<double> now = volumes(places, before);
      for (std::size_t i = 0; i < moved.size(); ++i)
        if (const double slope = lacks[i].slope(moved[i]), step = (wanted[i] - now[i]) / slope; std::abs(step) < 1e-6)
          moved[i] += step;
    }
    move();
    return leave_what_failed(wanted, volumes(places, before), start, places);
  }

 private:
  bool has_volume(std::uint32_t part) const { return is_moved_[part] && !is_open_[part]; }

  // The parts whose volumes are not those that are wanted stay as they were smoothed.
  KeptVolume leave_what_failed(const std::vector<double>& wanted, const std::vector<double>& now, const Places& start,
                               Places& places) const {
    constexpr double tolerance = 1e-9;
    KeptVolume kept;
    std::vector<bool> has_failed(part_of_.size(), false);
    for (std::uint32_t i = 0; i < part_of_.size(); ++i) {
      if (part_of_[i] != i || !is_moved_[i]) continue;
      has_failed[i] = !is_open_[i] && !(std::abs(now[i] - wanted[i]) <= tolerance * std::abs(wanted[i]));
      ++(is_open_[i] ? kept.open_parts : has_failed[i] ? kept.failed_parts : kept.parts);
    }
    for (std::uint32_t i = 0; i < places.size(); ++i)
      if (has_failed[part_of_[i]]) places[i] = start[i];
    return kept;
  }

  // By part, how far its points are at most from its first one, along an axis.
  std::vector<double> sizes_of_parts(const Places& places) const {
    std::vector<double> sizes(part_of_.size(), 0.0);
    for (const std::uint32_t corner : faces_.corners) {
      const glm::dvec3 way = glm::abs(places[corner] - places[part_of_[corner]]);
      sizes[part_of_[corner]] = std::max({sizes[part_of_[corner]], way.x, way.y, way.z});
    }
    return sizes;
  }

  // By part; each from its own first point, so that they are exact far from the origin too.
  std::vector<double> volumes(const Places& places, const Places& origins) const {
    std::vector<double> sums(part_of_.size(), 0.0);
    faces_.for_each([&](std::span<const std::uint32_t> face) {
      const std::uint32_t part = part_of_[face[0]];
      const Cone cone(face, places, origins[part]);
      sums[part] += glm::dot(cone.apex, cone.doubled_area) / 6;
    });
    return sums;
  }
  // How the volume changes with each point.
  Places slopes_of_points(const Places& places, const Places& origins) const {
    Places sums(places.size(), glm::dvec3(0));
    faces_.for_each([&](std::span<const std::uint32_t> face) {
      const Cone cone(face, places, origins[part_of_[face[0]]]);
      const std::size_t n = face.size();
      for (std::size_t k = 0; k < n; ++k) {
        const glm::dvec3 across = places[face[(k + n - 1) % n]] - places[face[(k + 1) % n]];
        sums[face[k]] += cone.doubled_area / (6.0 * static_cast<double>(n)) + glm::cross(cone.apex, across) / 6.0;
      }
    });
    return sums;
  }

  // Over a face from the mean of its corners, seen from an origin.
  struct Cone {
    glm::dvec3 apex{0}, doubled_area{0};
    Cone(std::span<const std::uint32_t> face, const Places& places, const glm::dvec3& origin) {
      for (std::size_t k = 0; k < face.size(); ++k) {
        const glm::dvec3 p = places[face[k]] - origin, q = places[face[(k + 1) % face.size()]] - origin;
        apex += p / static_cast<double>(face.size());
        doubled_area += glm::cross(p, q);
      }
    }
  };

  FaceCorners faces_;
  std::span<const double> shares_;
  std::vector<std::uint32_t> part_of_;
  std::vector<bool> is_open_, is_moved_;
};

}  // namespace

KeptVolume keep_volume(const Mesh& mesh, double scale, std::span<const double> shares, const Places& before,
                       Places& places) {
  return VolumeKeeper(mesh, scale, shares).keep(before, places);
}

}  // namespace ryosen::smooth
