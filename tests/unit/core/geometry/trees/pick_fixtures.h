// Triangle soups and the bunny for the tests of picking.
#pragma once

#include <array>
#include <cstdint>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "ryosen/geometry/trees/primitive.h"

namespace ryosen::test {

struct Scene {
  std::vector<glm::dvec3> positions;
  std::vector<Primitive> primitives;
};

// Small triangles, segments and points at random places of a cube around `center`.
inline Scene soup(std::size_t count, unsigned seed, double size = 1.0, const glm::dvec3& center = glm::dvec3(0.0)) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
  Scene scene;
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::dvec3 place = vector();
    for (int k = 0; k < 3; ++k) scene.positions.push_back(center + (place + 0.15 * vector()) * size);
    if (i % 11 == 5) {
      scene.primitives.push_back(Primitive::segment(3 * i, 3 * i + 1, i));
    } else if (i % 11 == 8) {
      scene.primitives.push_back(Primitive::point(3 * i));
    } else {
      scene.primitives.push_back(Primitive::triangle(3 * i, 3 * i + 1, 3 * i + 2, i));
    }
  }
  return scene;
}

// The triangles of an OBJ file whose faces are triangles; empty if it cannot be read.
inline Scene read_triangles(const std::string& file) {
  Scene scene;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      glm::dvec3 p;
      words >> p.x >> p.y >> p.z;
      scene.positions.push_back(p);
    } else if (kind == "f") {
      std::array<std::uint32_t, 3> v{};
      for (std::uint32_t& number : v) {
        std::string corner;
        words >> corner;
        number = static_cast<std::uint32_t>(std::stoul(corner)) - 1;
      }
      const auto face = static_cast<std::uint32_t>(scene.primitives.size());
      scene.primitives.push_back(Primitive::triangle(v[0], v[1], v[2], face));
    }
  }
  return scene;
}

}  // namespace ryosen::test
