#include "tests/support/render/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "tests/support/render/context.h"

namespace ryosen {

void Scene::add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  faces.push_back(static_cast<std::uint32_t>(triangles.size()));
  triangles.push_back({a, b, c});
  edge_bits.push_back(7);
  tints.push_back(0);
}

Scene square_scene(int cells) {
  Scene scene;
  const auto row = static_cast<std::uint32_t>(cells + 1);
  for (int y = 0; y <= cells; ++y) {
    for (int x = 0; x <= cells; ++x) scene.positions.push_back({2.0 * x / cells - 1, 2.0 * y / cells - 1, 0});
  }
  for (std::uint32_t y = 0; y + 1 < row; ++y) {
    for (std::uint32_t x = 0; x + 1 < row; ++x) {
      const std::uint32_t a = y * row + x;
      scene.add(a, a + 1, a + 1 + row);
      scene.add(a, a + 1 + row, a + row);
    }
  }
  return scene;
}

Scene sphere_scene(int rings) {
  Scene scene;
  const int around = 2 * rings;
  for (int i = 0; i <= rings; ++i) {
    const double tilt = std::numbers::pi * i / rings;
    for (int k = 0; k < around; ++k) {
      const double turn = 2 * std::numbers::pi * k / around;
      scene.positions.push_back({std::sin(tilt) * std::cos(turn), std::cos(tilt), -std::sin(tilt) * std::sin(turn)});
    }
  }
  for (int i = 0; i < rings; ++i) {
    for (int k = 0; k < around; ++k) {
      const auto a = static_cast<std::uint32_t>(i * around + k),
                 b = static_cast<std::uint32_t>(i * around + (k + 1) % around);
      const auto below = static_cast<std::uint32_t>(around);
      if (i > 0) scene.add(a, a + below, b);
      if (i + 1 < rings) scene.add(b, a + below, b + below);
    }
  }
  return scene;
}

std::unique_ptr<Renderer> front_view(const Scene& scene, Size size, double height) {
  test_context();
  Result<std::unique_ptr<Renderer>> made = Renderer::make();
  if (!made) {
    ADD_FAILURE() << made.failure().message.text.en;
    std::exit(1);
  }
  Renderer& view = **made;
  view.resize(size);
  view.set_mesh(scene.source());
  Camera camera;
  camera.eye = {0, 0, 5};
  camera.ortho_height = height;
  view.set_camera(camera);
  return std::move(*made);
}

int count_pixels(const Image& image, Rgba colour, int tolerance) {
  int count = 0;
  for (const Rgba& p : image.pixels) {
    bool near = true;
    for (std::size_t c = 0; c < 4; ++c) near = near && std::abs(int(p[c]) - int(colour[c])) <= tolerance;
    count += near;
  }
  return count;
}

}  // namespace ryosen
