// Small meshes as triangles, and counting of pixels.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/image.h"
#include "render/renderer.h"

namespace ryosen {

// Owns what a TriangleSource looks at.
struct Scene {
  std::vector<glm::dvec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> faces;
  std::vector<std::uint8_t> edge_bits;
  std::vector<std::uint8_t> tints;
  std::vector<std::array<std::uint32_t, 3>> normals;  // of the corners, packed; may be empty

  TriangleSource source() const {
    return {positions, static_cast<std::uint32_t>(triangles.size()),
            [this](std::span<const std::uint32_t> numbers, DrawnTriangle* to) {
              for (const std::uint32_t i : numbers) *to++ = {triangles[i], faces[i], edge_bits[i]};
            },
            tints, normals};
  }
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c);
};

// A square from (-1,-1,0) to (1,1,0) seen from +Z, of n x n cells of two triangles.
Scene square_scene(int cells);
// A sphere of radius 1, of about 4 * rings * rings triangles.
Scene sphere_scene(int rings);

// A view made in the test context. Straight from the front at +Z, orthographic: the view's height shows `height` units.
std::unique_ptr<Renderer> front_view(const Scene& scene, Size size, double height);

// Pixels whose channels differ from the colour by at most `tolerance`.
int count_pixels(const Image& image, Rgba colour, int tolerance = 8);

}  // namespace ryosen
