#include "core/algo/smooth/keep_volume.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "core/analysis/disjoint_sets.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"

namespace ryosen::smooth {

namespace {

// The corners of all faces, as points; faces with rings as their triangles.
struct FaceCorners {
  std::vector<std::uint32_t> corners, ends;

  explicit FaceCorners(const Mesh& mesh, double scale) {
    FacePolygon polygon;
    std::vector<CornerTriangle> cut;
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
      const Face f(i);
      if (!mesh.is_alive(f)) continue;
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
    for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i)
      if (const Halfedge h(i); mesh.is_alive(h) && mesh.is_boundary(edge(h)))
        is_open_[part_of_[point(mesh, mesh.from(h)).index]] = true;
  }

  KeptVolume keep(const Places& before, Places& places) const {
    KeptVolume kept;
    for (std::uint32_t i = 0; i < part_of_.size(); ++i)
      if (part_of_[i] == i && is_moved_[i]) ++(is_open_[i] ? kept.open_parts : kept.parts);
    const std::vector<double> wanted = volumes(before, before);
    Places normals = slopes_of_points(places, before);
    for (glm::dvec3& n : normals)
      if (const double length = glm::length(n); length > 0) n /= length;
    const Places start = places;
    std::vector<double> moved(part_of_.size(), 0.0);
    constexpr int rounds = 20;  // of Newton's; the volume is a cubic of the length
    for (int round = 0; round < rounds; ++round) {
      const std::vector<double> now = volumes(places, before);
      const Places slopes = slopes_of_points(places, before);
      std::vector<double> slope(part_of_.size(), 0.0);
      for (std::uint32_t i = 0; i < slopes.size(); ++i)
        if (shares_[i] > 0) slope[part_of_[i]] += shares_[i] * glm::dot(slopes[i], normals[i]);
      for (std::size_t i = 0; i < moved.size(); ++i)
        if (slope[i] != 0 && is_moved_[i] && !is_open_[i]) moved[i] += (wanted[i] - now[i]) / slope[i];
      for (std::uint32_t i = 0; i < places.size(); ++i)
        places[i] = shares_[i] > 0 ? start[i] + (shares_[i] * moved[part_of_[i]]) * normals[i] : start[i];
    }
    return kept;
  }

 private:
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
