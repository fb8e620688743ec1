#include "tests/support/core/ugly_meshes.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <random>

namespace ryosen::test {

namespace {

void add_polygon(IndexedMesh& mesh, std::initializer_list<std::uint32_t> corners) {
  mesh.corners.insert(mesh.corners.end(), corners);
  mesh.face_offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
}

glm::dvec3 on_circle(std::uint32_t i, std::uint32_t n, double z) {
  const double angle = 2 * std::numbers::pi * i / n;
  return {std::cos(angle), std::sin(angle), z};
}

constexpr std::array families{
    UglyFamily{"fan", "triangles around one vertex", fan},
    UglyFamily{"bipyramid", "triangles around two vertices", bipyramid},
    UglyFamily{"book", "triangles on one edge", book},
    UglyFamily{"squares", "squares on one edge", book_of_squares},
    UglyFamily{"equal", "times the same triangle", equal_triangles},
    UglyFamily{"voxels", "cubes of six quads", voxel_block},
    UglyFamily{"large_face", "corners of one face", large_face},
    UglyFamily{"apex_soup", "loose triangles that touch at one place", apex_soup},
    UglyFamily{"comb", "holes in a strip", comb_of_holes},
    UglyFamily{"slivers", "thin triangles around one corner", sliver_fan},
    UglyFamily{"flat_chain", "flat triangles in a row", flat_chain},
    UglyFamily{"spokes", "triangles between a point and a line, and flat ones on it", spokes_on_a_line},
    UglyFamily{"seams", "pairs of triangles along seams through one point", seams_at_a_point},
    UglyFamily{"grid", "triangles of a regular grid", clean_grid},
};

}  // namespace

std::span<const UglyFamily> ugly_families() { return families; }

IndexedMesh fan(std::uint32_t n) {
  IndexedMesh mesh;
  mesh.positions.push_back({0, 0, 1});
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.positions.push_back(on_circle(i, n, 0));
    add_polygon(mesh, {0, 1 + i, 1 + (i + 1) % n});
  }
  return mesh;
}

IndexedMesh bipyramid(std::uint32_t n) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 1}, {0, 0, -1}};
  const std::uint32_t ring = n < 6 ? 3 : n / 2;
  for (std::uint32_t i = 0; i < ring; ++i) {
    mesh.positions.push_back(on_circle(i, ring, 0));
    add_polygon(mesh, {0, 2 + i, 2 + (i + 1) % ring});
    add_polygon(mesh, {1, 2 + (i + 1) % ring, 2 + i});
  }
  return mesh;
}

IndexedMesh book(std::uint32_t n) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}};
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.positions.push_back(on_circle(i, n, 0.5));
    add_polygon(mesh, {0, 1, 2 + i});
  }
  return mesh;
}

IndexedMesh book_of_squares(std::uint32_t n) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}};
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.positions.insert(mesh.positions.end(), {on_circle(i, n, 0), on_circle(i, n, 1)});
    add_polygon(mesh, {0, 1, 3 + 2 * i, 2 + 2 * i});
  }
  return mesh;
}

IndexedMesh equal_triangles(std::uint32_t n) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (std::uint32_t i = 0; i < n; ++i) add_polygon(mesh, {0, 1, 2});
  return mesh;
}

IndexedMesh voxel_block(std::uint32_t n) {
  std::array<std::uint32_t, 3> size{1, 1, 1};
  for (std::uint32_t axis = 0; size[0] * size[1] * size[2] < n; axis = (axis + 1) % 3) size[axis] *= 2;
  IndexedMesh mesh;
  for (std::uint32_t z = 0; z <= size[2]; ++z)
    for (std::uint32_t y = 0; y <= size[1]; ++y)
      for (std::uint32_t x = 0; x <= size[0]; ++x) mesh.positions.push_back({x, y, z});
  const auto id = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return (z * (size[1] + 1) + y) * (size[0] + 1) + x;
  };
  for (std::uint32_t z = 0; z < size[2]; ++z)
    for (std::uint32_t y = 0; y < size[1]; ++y)
      for (std::uint32_t x = 0; x < size[0]; ++x) {
        const auto corner = [&](std::uint32_t bits) {
          return id(x + (bits & 1), y + (bits >> 1 & 1), z + (bits >> 2));
        };
        for (const auto& q : std::array<std::array<std::uint32_t, 4>, 6>{
                 {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}})
          add_polygon(mesh, {corner(q[0]), corner(q[1]), corner(q[2]), corner(q[3])});
      }
  return mesh;
}

IndexedMesh large_face(std::uint32_t n) {
  IndexedMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.positions.push_back(on_circle(i, n, 0));
    mesh.corners.push_back(i);
  }
  mesh.face_offsets.push_back(n);
  return mesh;
}

IndexedMesh apex_soup(std::uint32_t n) {
  IndexedMesh mesh;
  std::mt19937 random(1);
  const auto coordinate = [&] { return std::ldexp(static_cast<double>(random()), -31) - 1; };
  for (std::uint32_t i = 0; i < n; ++i) {
    const glm::dvec3 a{coordinate(), coordinate(), coordinate()}, b{coordinate(), coordinate(), coordinate()};
    mesh.positions.insert(mesh.positions.end(), {{0, 0, 0}, a, b});
    add_polygon(mesh, {3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

IndexedMesh comb_of_holes(std::uint32_t n) {
  IndexedMesh mesh;
  const std::uint32_t columns = 2 * n + 1;
  for (std::uint32_t x = 0; x <= columns; ++x)
    for (std::uint32_t y = 0; y < 4; ++y) mesh.positions.push_back({x, y, 0});
  for (std::uint32_t x = 0; x < columns; ++x)
    for (std::uint32_t y = 0; y < 3; ++y)
      if (y != 1 || x % 2 == 0) add_polygon(mesh, {4 * x + y, 4 * x + 4 + y, 4 * x + 5 + y, 4 * x + 1 + y});
  return mesh;
}

IndexedMesh sliver_fan(std::uint32_t n) {
  IndexedMesh mesh;
  mesh.positions.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i <= n; ++i) mesh.positions.push_back({1, 1e-6 * i, 0});
  for (std::uint32_t i = 0; i < n; ++i) add_polygon(mesh, {0, 1 + i, 2 + i});
  return mesh;
}

IndexedMesh flat_chain(std::uint32_t n) {
  IndexedMesh mesh;
  for (std::uint32_t i = 0; i < n + 2; ++i) mesh.positions.push_back({i, 0, 0});
  for (std::uint32_t i = 0; i < n; ++i) add_polygon(mesh, {i, i + 1, i + 2});
  return mesh;
}

IndexedMesh spokes_on_a_line(std::uint32_t n) {
  IndexedMesh mesh;
  const std::uint32_t points = 2 * n / 3 + 1;
  for (std::uint32_t i = 0; i < points; ++i) mesh.positions.push_back({i, 0, 0});
  mesh.positions.push_back({0, 1, 0});
  for (std::uint32_t i = 0; i + 1 < points; ++i) add_polygon(mesh, {i, i + 1, points});
  for (std::uint32_t i = 0; i + 2 < points; i += 2) add_polygon(mesh, {i, i + 2, i + 1});
  return mesh;
}

IndexedMesh seams_at_a_point(std::uint32_t n) {
  IndexedMesh mesh;
  const std::uint32_t half = n / 2;
  const auto end = static_cast<double>(half);
  for (std::uint32_t i = 0; i < half; ++i) {
    const double x = 1.0 + i;  // a whole multiple of (x, end) leads along the seam
    mesh.positions.insert(mesh.positions.end(),
                          {{-x, -end, 0}, {x, end, 0}, {0, 0, x}, {0, 0, 0}, {x, end, 0}, {0, 0, -x}});
    add_polygon(mesh, {6 * i, 6 * i + 1, 6 * i + 2});
    add_polygon(mesh, {6 * i + 4, 6 * i + 3, 6 * i + 5});
  }
  return mesh;
}

IndexedMesh clean_grid(std::uint32_t n) {
  IndexedMesh mesh;
  const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(n / 2.0)));
  for (std::uint32_t y = 0; y <= side; ++y)
    for (std::uint32_t x = 0; x <= side; ++x) mesh.positions.push_back({x, y, std::sin(0.3 * x) * std::cos(0.2 * y)});
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t a = y * (side + 1) + x, b = a + 1, c = a + side + 1, d = c + 1;
      add_polygon(mesh, {a, b, d});
      add_polygon(mesh, {a, d, c});
    }
  return mesh;
}

}  // namespace ryosen::test
