#include "ryosen/algo/primitives/platonic.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "ryosen/algo/primitives/shape.h"

namespace ryosen {

namespace {

using Directions = std::vector<glm::dvec3>;

// Of each solid its vertices; they are the directions of the faces of its dual.
Directions tetrahedron_vertices() { return {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}; }

Directions octahedron_vertices() { return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}; }

Directions cube_vertices() {
  Directions all;
  for (int z = -1; z <= 1; z += 2)
    for (int y = -1; y <= 1; y += 2)
      for (int x = -1; x <= 1; x += 2) all.emplace_back(x, y, z);
  return all;
}

// (0, +-a, +-b) and what turning the axes makes of them: the corners of three rectangles.
Directions rectangles(double a, double b) {
  Directions all;
  for (int axis = 0; axis < 3; ++axis)
    for (const double first : {a, -a})
      for (const double second : {b, -b}) {
        glm::dvec3 place(0);
        place[(axis + 1) % 3] = first;
        place[(axis + 2) % 3] = second;
        all.push_back(place);
      }
  return all;
}

Directions icosahedron_vertices() { return rectangles(1, std::numbers::phi); }

Directions dodecahedron_vertices() {
  Directions all = cube_vertices();
  const Directions others = rectangles(std::numbers::phi, 1 / std::numbers::phi);
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

// The vertices farthest in a direction, counter-clockwise seen from there.
std::vector<std::uint32_t> face_in(const glm::dvec3& direction, const Directions& vertices) {
  constexpr double tolerance = 1e-9;
  double farthest = 0;
  for (const glm::dvec3& v : vertices) farthest = std::max(farthest, glm::dot(v, direction));
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < vertices.size(); ++i)
    if (glm::dot(vertices[i], direction) > farthest - tolerance) corners.push_back(i);
  const glm::dvec3 first = vertices[corners[0]] - direction * (farthest / glm::dot(direction, direction));
  const glm::dvec3 beside = glm::cross(direction, first) / glm::length(direction);
  const auto turn = [&](std::uint32_t i) {
    const double angle = std::atan2(glm::dot(vertices[i], beside), glm::dot(vertices[i], first));
    return angle < -tolerance ? angle + 2 * std::numbers::pi : angle;
  };
  std::sort(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) { return turn(a) < turn(b); });
  return corners;
}

AlgorithmResult add_solid(Edit& edit, const AlgorithmInput& input, Progress& progress, const Directions& vertices,
                          const Directions& faces, double scale) {
  Shape shape(input.values.place("at"));
  for (const glm::dvec3& v : vertices) shape.add_point(scale * v);
  for (const glm::dvec3& direction : faces) shape.add_face(face_in(direction, vertices));
  return std::move(shape).add_to(edit, progress);
}

AlgorithmResult add_within_sphere(Edit& edit, const AlgorithmInput& input, Progress& progress,
                                  const Directions& vertices, const Directions& faces) {
  const double scale = input.values.length("radius") / glm::length(vertices[0]);
  return add_solid(edit, input, progress, vertices, faces, scale);
}

}  // namespace

AlgorithmResult add_cube(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  return add_solid(edit, input, progress, cube_vertices(), octahedron_vertices(), input.values.length("size") / 2);
}

AlgorithmResult add_tetrahedron(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  Directions faces = tetrahedron_vertices();
  for (glm::dvec3& direction : faces) direction = -direction;
  return add_within_sphere(edit, input, progress, tetrahedron_vertices(), faces);
}

AlgorithmResult add_octahedron(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  return add_within_sphere(edit, input, progress, octahedron_vertices(), cube_vertices());
}

AlgorithmResult add_dodecahedron(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  return add_within_sphere(edit, input, progress, dodecahedron_vertices(), icosahedron_vertices());
}

AlgorithmResult add_icosahedron(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  return add_within_sphere(edit, input, progress, icosahedron_vertices(), dodecahedron_vertices());
}

}  // namespace ryosen
