// Which way the input looks near a place, against a search through all its faces.
#include "ryosen/algo/simplify/input_sides.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "ryosen/geometry/closest.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/simplified.h"

namespace ryosen::test {
namespace {

using Triangle = std::array<glm::dvec3, 3>;

Triangle triangle_of(const Mesh& mesh, Face f) {
  const Halfedge h = mesh.halfedge(f);
  return {mesh.position(mesh.from(h)), mesh.position(mesh.to(h)), mesh.position(mesh.from(mesh.prev(h)))};
}

glm::dvec3 normal_of(const Triangle& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

// The distances of the nearest face that looks along a triangle and of the nearest that does not.
std::array<double, 2> distances(const Mesh& mesh, const Triangle& t) {
  std::array<double, 2> least{1e300, 1e300};
  const glm::dvec3 middle = (t[0] + t[1] + t[2]) / 3.0;
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    const Triangle face = triangle_of(mesh, Face(i));
    double& distance = least[glm::dot(normal_of(face), normal_of(t)) > 0 ? 0 : 1];
    distance = std::min(distance, glm::length(way_from_triangle(face[0], face[1], face[2], middle)));
  }
  return least;
}

TEST(input_sides, tells_faces_that_look_against_the_nearest_one_as_a_search_through_all_does) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  // Two sheets, the upper one the other way up, and a face far larger than all others.
  const Mesh lower = sheet(16, wave);
  IndexedMesh source;
  for (const glm::dvec3& p : lower.positions()) source.positions.push_back(p);
  for (const glm::dvec3& p : lower.positions()) source.positions.emplace_back(p.x, p.y, p.z + 0.4);
  for (const glm::dvec3& p : {glm::dvec3(-200, -100, 3), glm::dvec3(300, -100, 3), glm::dvec3(0, 300, 3)})
    source.positions.push_back(p);
  const auto count = static_cast<std::uint32_t>(lower.positions().size());
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    source.corners.insert(source.corners.end(), {a, b, c});
    source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
  };
  for (std::uint32_t i = 0; i < lower.face_slots(); ++i) {
    const Halfedge h = lower.halfedge(Face(i));
    const std::uint32_t a = lower.from(h).index, b = lower.to(h).index, c = lower.from(lower.prev(h)).index;
    add(a, b, c);
    add(count + b, count + a, count + c);
  }
  add(2 * count, 2 * count + 1, 2 * count + 2);
  const Mesh mesh = from_indexed(source);
  const InputSides sides(mesh, std::vector<std::uint8_t>(mesh.vertex_slots(), 1));
  std::size_t turned = 0;
  for (int i = 0; i < (is_long_run() ? 4000 : 1500); ++i) {
    const auto far = [&](double size) { return size * glm::dvec3(unit(random), unit(random), unit(random)); };
    const glm::dvec3 at = glm::dvec3(8, 8, 1.5) + far(1) * glm::dvec3(8, 8, 1.5);
    const Triangle t{at + far(0.3), at + far(0.3), at + far(0.3)};
    const auto [along, against] = distances(mesh, t);
    if (std::min(along, against) > 1 || std::abs(along - against) < 1e-6) continue;
    EXPECT_EQ(sides.is_turned(t), against < along) << i;
    turned += against < along;
  }
  EXPECT_GT(turned, is_long_run() ? 500u : 150u);
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) EXPECT_FALSE(sides.is_turned(triangle_of(mesh, Face(i)))) << i;
}

}  // namespace
}  // namespace ryosen::test
