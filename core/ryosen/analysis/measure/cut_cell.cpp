#include "ryosen/analysis/measure/cut_cell.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ryosen {

namespace {

constexpr double much = 1e-11;  // of coordinates of about 1: what is nearer to a plane is on it

using Near = TriangleTree::Near;
using Signs = std::array<double, 3>;  // of the corners: on which side of a plane, and how far from it

std::size_t longest_side(const TrianglePlaces& t) {
  std::size_t longest = 0;
  double length = -1;
  for (std::size_t i = 0; i < 3; ++i)
    if (const double square = squared(t[(i + 1) % 3] - t[i]); square > length) length = square, longest = i;
  return longest;
}

// Of the plane through a side of a triangle, at a right angle to it: positive on the side of the triangle.
Signs beside_side(const TrianglePlaces& t, std::size_t side, const TrianglePlaces& cell) {
  const glm::dvec3 way = t[(side + 1) % 3] - t[side];
  const glm::dvec3 inwards = glm::cross(glm::cross(way, t[(side + 2) % 3] - t[side]), way);
  const double length = glm::length(inwards);
  Signs found{};
  if (length > 0)
    for (std::size_t i = 0; i < 3; ++i) found[i] = glm::dot(inwards, cell[i] - t[side]) / length;
  return found;
}

bool is_repeated(const FarthestCell& cell, std::size_t i) {
  for (std::size_t k = 0; k < i; ++k)
    if (cell.near[k].triangle == cell.near[i].triangle) return true;
  return false;
}

class Cutter {
 public:
  Cutter(const TriangleTree& to, const FarthestCell& cell) : to_(to), cell_(cell) {}

  CellParts run() {
    if (const Signs by = best_plane(); by != Signs{})
      cut(by);
    else
      halve();
    return parts_;
  }

 private:
  // The plane that leaves most of the cell on either side; zeros where there is none.
  Signs best_plane() const {
    double best = much;
    Signs by{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_repeated(cell_, i)) continue;
      const TrianglePlaces t = to_.places(cell_.near[i].triangle);
      for (std::size_t side = 0; side < 3; ++side) {
        const Signs beside = beside_side(t, side, cell_.corners);
        const auto [low, high] = std::minmax({beside[0], beside[1], beside[2]});
        if (beside[i] < -much || std::min(-low, high) <= best) continue;
        best = std::min(-low, high);
        by = beside;
      }
    }
    for (double& x : by)
      if (std::abs(x) <= much) x = 0;
    return by;
  }

  Near ask(const glm::dvec3& place, std::uint32_t hint) {
    const Near near = nearest_of(to_, place, hint);
    parts_.places[parts_.new_places] = place;
    parts_.distances[parts_.new_places++] = near.distance;
    return near;
  }

  void add(const TrianglePlaces& places, const std::array<Near, 3>& near) {
    parts_.cells[parts_.count++] = {places, near};
  }

  void halve() {
    const std::size_t i = longest_side(cell_.corners);
    cut_at(i, (i + 1) % 3, 0.5 * cell_.corners[i] + 0.5 * cell_.corners[(i + 1) % 3]);
  }
  // In two, from a place between two corners to the third.
  void cut_at(std::size_t i, std::size_t k, const glm::dvec3& place) {
    const Near near = ask(place, cell_.near[i].triangle);
    for (const std::size_t replaced : {k, i}) {
      FarthestCell part = cell_;
      part.corners[replaced] = place;
      part.near[replaced] = near;
      add(part.corners, part.near);
    }
  }

  void cut(const Signs& by) {
    const auto crossing = [&](std::size_t i, std::size_t k) {
      return cell_.corners[i] + by[i] / (by[i] - by[k]) * (cell_.corners[k] - cell_.corners[i]);
    };
    const auto& [corners, near] = cell_;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (i + 1) % 3, l = (i + 2) % 3;
      if (by[i] == 0 && by[k] * by[l] < 0) return cut_at(k, l, crossing(k, l));
      // A corner that is alone on its side: a triangle there, and two on the other.
      if (!(by[i] * by[k] < 0 && by[i] * by[l] < 0)) continue;
      const glm::dvec3 p = crossing(i, k), q = crossing(i, l);
      const Near near_p = ask(p, near[i].triangle), near_q = ask(q, near[i].triangle);
      add({corners[i], p, q}, {near[i], near_p, near_q});
      add({p, corners[k], corners[l]}, {near_p, near[k], near[l]});
      add({p, corners[l], q}, {near_p, near[l], near_q});
      return;
    }
  }

  const TriangleTree& to_;
  const FarthestCell& cell_;
  CellParts parts_;
};

}  // namespace

CellParts cut_cell(const TriangleTree& to, const FarthestCell& cell) { return Cutter(to, cell).run(); }

}  // namespace ryosen
