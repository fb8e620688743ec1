#include "tests/support/core/kept_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ryosen/analysis/measure/distance.h"
#include "ryosen/analysis/measure/measured_surface.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/triangulate.h"
#include "tests/support/core/holed_shapes.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/simplified.h"
#include "tests/support/core/slow_distance.h"

namespace ryosen::test {

namespace {

std::vector<SlowTriangle> triangles_to_sample(const Mesh& mesh) {
  std::vector<SlowTriangle> triangles;
  const MeasuredSurface surface(mesh);
  for (const Primitive& t : surface.triangles) {
    SlowTriangle& places = triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) places[i] = mesh.position(Vertex(t.vertices[i]));
  }
  return triangles;
}

// Samples so few triangles that it costs some thousandths of a second at most, densely.
double farthest_sampled(const std::vector<SlowTriangle>& from, const std::vector<SlowTriangle>& to) {
  constexpr std::size_t most_pairs = 12'000;
  std::vector<SlowTriangle> some;
  for (std::size_t i = 0, every = 1 + 9 * from.size() * to.size() / most_pairs; i < from.size(); i += every)
    some.push_back(from[i]);
  return slow_figures(some, to, 3).largest;
}

double hills(std::uint32_t x, std::uint32_t y) { return std::sin(0.7 * x) + std::cos(0.5 * y); }

}  // namespace

double size_of_surface(const Mesh& mesh) {
  const Box box = MeasuredSurface(mesh).box;
  return glm::length(box.highest - box.lowest);
}

void expect_kept_within(const Mesh& before, const Mesh& after, double most, const std::string& name) {
  ASSERT_TRUE(has_surface(after)) << name;
  Progress unheard;
  const auto distance = surface_distance(before, after, {.samples = 500}, unheard);
  EXPECT_LE(distance->hausdorff, most * (1 + 1e-9)) << name;
  const std::vector<SlowTriangle> input = triangles_to_sample(before), output = triangles_to_sample(after);
  EXPECT_LE(farthest_sampled(input, output), most * (1 + 1e-9)) << name;
  EXPECT_LE(farthest_sampled(output, input), most * (1 + 1e-9)) << name;
}

Mesh cut_in_triangles(Mesh mesh) {
  Edit edit(mesh, nullptr);
  if (Triangulate{}.check(mesh).legal()) Triangulate{}.apply(edit);
  edit.commit();
  return mesh;
}

Mesh shaken(Mesh mesh, double by, std::uint64_t seed) {
  Edit edit(mesh, nullptr);
  Dice dice(seed);
  const auto step = [&] { return by * (2 * dice.unit() - 1); };
  for (const Vertex v : live_vertices(mesh)) {
    if (has_copies(mesh, v)) continue;  // they move together
    const double x = step(), y = step(), z = step();
    edit.set_position(v, mesh.position(v) + glm::dvec3(x, y, z));
  }
  edit.commit();
  return mesh;
}

Mesh stretched(Mesh mesh, const glm::dvec3& by) {
  Edit edit(mesh, nullptr);
  for (const Vertex v : live_vertices(mesh)) edit.set_position(v, by * mesh.position(v));
  edit.commit();
  return mesh;
}

Mesh doubled(const Mesh& mesh, const glm::dvec3& apart) {
  IndexedMesh both;
  for (const glm::dvec3& shift : {glm::dvec3(0.0), apart}) {
    const auto first = static_cast<std::uint32_t>(both.positions.size());
    for (const Vertex v : live_vertices(mesh)) both.positions.push_back(mesh.position(v) + shift);
    for (const Face f : live_faces(mesh)) {
      for (const Vertex v : vertices_around(mesh, f)) both.corners.push_back(first + v.index);
      both.face_offsets.push_back(static_cast<std::uint32_t>(both.corners.size()));
    }
  }
  return from_indexed(both);
}

std::vector<NamedMesh> meshes_to_keep() {
  const auto made = [](const char* line) { return cut_in_triangles(made_by(line)); };
  const auto torus = [](std::uint32_t around, std::uint32_t across, double radius, double tube) {
    return from_indexed(torus_at_places(around, across, radius, tube));
  };
  const auto divided = [](Mesh mesh) {
    Journal journal;
    run_algorithm(mesh, journal, "subdivide scheme=midpoint steps=2");
    return mesh;
  };
  const auto torn = [](std::uint32_t missing) { return from_indexed(torn_torus(missing, missing)); };
  const Mesh sphere = made("sphere radius=1 segments=12 bands=7"), flat = sheet(9, [](auto, auto) { return 1.0; });
  const Mesh rolling = sheet(9, hills);
  std::vector<NamedMesh> all;
  const auto add = [&](const char* name, Mesh mesh) { all.push_back({name, std::move(mesh)}); };
  add("sphere", sphere);
  add("torus", torus(14, 7, 2, 0.7));
  add("thin torus", torus(20, 5, 2, 0.15));
  add("bumpy torus", shaken(torus(14, 7, 1, 0.4), 0.02, 3));
  add("rough sphere", shaken(sphere, 0.05, 4));
  add("box", divided(made("cube size=2")));
  add("plate with a hole", from_indexed(plate_with_holes(2)));
  add("prism", divided(made("cylinder segments=5")));
  add("cone", made("cone segments=40"));
  add("shaken box", shaken(divided(made("cube size=2")), 1e-4, 5));
  add("flat sheet", flat);
  add("hills", rolling);
  add("steps", sheet(9, wave));
  add("spike", sheet(9, [](std::uint32_t x, std::uint32_t y) { return x == 4 && y == 5 ? 6.0 : 0.0; }));
  add("rough sheet", shaken(flat, 0.1, 6));
  for (const std::uint32_t missing : {1u, 5u, 20u, 60u}) add("torn torus", torn(missing));
  add("torn and rough", shaken(torn(30), 0.03, 7));
  add("two sheets", doubled(rolling, {0, 0, 0.15}));
  add("two sheets one above the other", doubled(flat, {0, 0, 0.02}));
  add("two spheres that meet", doubled(sphere, {0.9, 0, 0}));
  add("two tori, one in the other", doubled(torus(14, 7, 2, 0.7), {0.3, 0.2, 0.1}));
  add("two boxes", doubled(divided(made("cube size=2")), {2.05, 0, 0}));
  add("needles", stretched(sheet(8, wave), {100, 1, 1}));
  add("flat needles", stretched(flat, {1, 1000, 1}));
  add("long sphere", stretched(sphere, {50, 1, 1}));
  add("flattened torus", stretched(torus(14, 7, 2, 0.7), {1, 1, 1e-3}));
  add("far needles", stretched(shaken(sheet(8, hills), 0.2, 8), {1e-3, 1e3, 1e3}));
  return all;
}

}  // namespace ryosen::test
