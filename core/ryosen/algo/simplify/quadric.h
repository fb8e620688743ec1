// The sum of weighted squared distances to planes, as a function of the place [Garland97].
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace ryosen {

// x'Ax + 2 b'x + c with a symmetric A. Coordinates about 1 in size keep about half of the digits of a distance.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  glm::dvec3 b{0.0};
  double c = 0;
  double weight = 0;  // of all its planes

  // The plane through a place, by its unit normal.
  void add_plane(const glm::dvec3& normal, const glm::dvec3& through, double plane_weight) {
    const glm::dvec3 n = plane_weight * normal;
    const double d = -glm::dot(normal, through);
    *this += {n.x * normal.x, n.x * normal.y, n.x * normal.z,       n.y * normal.y, n.y * normal.z,
              n.z * normal.z, d * n,          plane_weight * d * d, plane_weight};
  }

  Quadric& operator+=(const Quadric& q) {
    xx += q.xx;
    xy += q.xy;
    xz += q.xz;
    yy += q.yy;
    yz += q.yz;
    zz += q.zz;
    b += q.b;
    c += q.c;
    weight += q.weight;
    return *this;
  }

  glm::dvec3 times(const glm::dvec3& p) const {
    return {xx * p.x + xy * p.y + xz * p.z, xy * p.x + yy * p.y + yz * p.z, xz * p.x + yz * p.y + zz * p.z};
  }
  // The sum at a place; never negative.
  double at(const glm::dvec3& p) const { return std::max(0.0, glm::dot(p, times(p) + 2.0 * b) + c); }

  // Whether the slope at a place is that of rounding, so that no other one is lower. Places are about 1 in size.
  bool is_lowest(const glm::dvec3& place) const { return is_rounding(times(place) + b); }

  // The place of the least sum; where planes leave it open, as on a flat or straight part, the one nearest to `near`. A
  // share of the trace on the diagonal of A makes both one equation, which is solved by LDL': the larger it is, the
  // more `near` holds the place.
  glm::dvec3 lowest(const glm::dvec3& near, double share = 1e-8) const {
    const double trace = xx + yy + zz;
    if (!(trace > 0)) return near;
    const double held = share * trace;
    const glm::dvec3 r = -(times(near) + b);
    if (is_rounding(r)) return near;
    const double d0 = xx + held, l10 = xy / d0, l20 = xz / d0;
    const double d1 = yy + held - l10 * xy, e = yz - l20 * xy, l21 = e / d1;
    const double d2 = zz + held - l20 * xz - l21 * e;
    const double y1 = r.y - l10 * r.x, y2 = r.z - l20 * r.x - l21 * y1;
    glm::dvec3 x;
    x.z = y2 / d2;
    x.y = y1 / d1 - l21 * x.z;
    x.x = r.x / d0 - l10 * x.y - l20 * x.z;
    return near + x;
  }

 private:
  bool is_rounding(const glm::dvec3& slope) const {
    constexpr double share = 1e-13;
    const double most = share * (xx + yy + zz);
    return glm::dot(slope, slope) <= most * most;
  }
};

// a + b, without a sum that is only used once being written to memory.
inline Quadric operator+(Quadric a, const Quadric& b) { return a += b; }

}  // namespace ryosen
