// The edge split of the source texts on triangles whose halfedges are numbered 3i, 3i+1, 3i+2 by their face i.
//
//          v1                     v1            the triangle left of the halfedge v3 -> v0 becomes (v0, v1,
//        / a  \                 / | \           new), the one on its right, if any, (v2, v0, new); (v1, v3, new)
//      v3 ---> v0     =>      v3-new-v0         and then, if there were two, (v3, v2, new) come last
//        \ b  /                 \ | /
//          v2                     v2
#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "ryosen/base/handle.h"

namespace ryosen::forms {

// The vertex inserted by a split, and the first face added.
struct Split3ij {
  std::uint32_t vertex, face;
};

// Structure offers corner(h), opposite(h) (no_index on a boundary), position(v), add_vertex(position),
// add_face() and set_face(f, corners), which unlinks the sides of f, join(h, g) and set_boundary(h). If there are two
// triangles, their third corners must differ.
template <class Structure>
Split3ij split_3ij(Structure& mesh, std::uint32_t h, const glm::dvec3& position) {
  const auto next = [](std::uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; };
  const auto prev = [](std::uint32_t side) { return side % 3 == 0 ? side + 2 : side - 1; };
  const std::uint32_t other = mesh.opposite(h), left = h / 3;
  const std::uint32_t v0 = mesh.corner(next(h)), v1 = mesh.corner(prev(h)), v3 = mesh.corner(h);
  const std::uint32_t beyond_v0v1 = mesh.opposite(next(h)), beyond_v1v3 = mesh.opposite(prev(h));
  const auto join = [&](std::uint32_t side, std::uint32_t beyond) {
    beyond == no_index ? mesh.set_boundary(side) : mesh.join(side, beyond);
  };
  std::uint32_t v2 = no_index, beyond_v3v2 = no_index, beyond_v2v0 = no_index;
  if (other != no_index) {
    v2 = mesh.corner(prev(other));
    beyond_v3v2 = mesh.opposite(next(other));
    beyond_v2v0 = mesh.opposite(prev(other));
  }

  const std::uint32_t v = mesh.add_vertex(position);
  mesh.set_face(left, std::array{v0, v1, v});
  if (other != no_index) mesh.set_face(other / 3, std::array{v2, v0, v});
  const std::uint32_t new_left = mesh.add_face();
  mesh.set_face(new_left, std::array{v1, v3, v});
  join(3 * left, beyond_v0v1);
  join(3 * new_left, beyond_v1v3);
  mesh.join(3 * left + 1, 3 * new_left + 2);
  if (other == no_index) {
    mesh.set_boundary(3 * left + 2);
    mesh.set_boundary(3 * new_left + 1);
    return {v, new_left};
  }
  const std::uint32_t right = other / 3, new_right = mesh.add_face();
  mesh.set_face(new_right, std::array{v3, v2, v});
  join(3 * right, beyond_v2v0);
  join(3 * new_right, beyond_v3v2);
  mesh.join(3 * right + 1, 3 * left + 2);
  mesh.join(3 * new_right + 1, 3 * right + 2);
  mesh.join(3 * new_left + 1, 3 * new_right + 2);
  return {v, new_left};
}

// Splits the edge of a halfedge at its midpoint, starting from the halfedge that leaves the smaller vertex; this
// reproduces the numbering of the source texts' hexagon.
template <class Structure>
Split3ij split_edge_3ij(Structure& mesh, std::uint32_t h) {
  const std::uint32_t other = mesh.opposite(h);
  if (other != no_index && mesh.corner(other) < mesh.corner(h)) h = other;
  const std::uint32_t end = mesh.corner(h % 3 == 2 ? h - 2 : h + 1);
  return split_3ij(mesh, h, 0.5 * (mesh.position(mesh.corner(h)) + mesh.position(end)));
}

template <class Structure>
double area_3ij(const Structure& mesh, std::uint32_t face) {
  const glm::dvec3& a = mesh.position(mesh.corner(3 * face));
  return 0.5 * glm::length(glm::cross(mesh.position(mesh.corner(3 * face + 1)) - a,
                                      mesh.position(mesh.corner(3 * face + 2)) - a));
}

// The repeated split of the source texts: `times` times the longest side of the largest triangle (the first of equal
// ones) is split at its midpoint. O(times * faces).
template <class Structure>
void split_largest_3ij(Structure& mesh, std::size_t times) {
  for (; times > 0; --times) {
    std::uint32_t largest = 0, longest = 0;
    double area = -1, length = -1;
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      if (area_3ij(mesh, f) <= area) continue;
      area = area_3ij(mesh, f);
      largest = f;
    }
    for (std::uint32_t h = 3 * largest; h < 3 * largest + 3; ++h) {
      const std::uint32_t end = h % 3 == 2 ? h - 2 : h + 1;
      const double side = glm::distance(mesh.position(mesh.corner(h)), mesh.position(mesh.corner(end)));
      if (side <= length) continue;
      length = side;
      longest = h;
    }
    split_edge_3ij(mesh, longest);
  }
}

}  // namespace ryosen::forms
