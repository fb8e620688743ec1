#include "ryosen/geometry/trees/bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <glm/gtc/matrix_transform.hpp>
#include <iostream>
#include <limits>
#include <set>

#include "ryosen/geometry/trees/primitive.h"
#include "tests/support/core/bvh_inspector.h"
#include "tests/support/core/long_run.h"
#include "tests/unit/core/geometry/trees/pick_fixtures.h"

namespace ryosen {
namespace {

using glm::dvec3;
using test::Scene;

std::optional<RayHit> cast_all(const Scene& scene, const Ray& ray) {
  const RayCaster caster(ray);
  std::optional<RayHit> best;
  for (std::uint32_t slot = 0; slot < scene.primitives.size(); ++slot) {
    if (scene.primitives[slot].size() != 3) continue;
    const auto& v = scene.primitives[slot].vertices;
    const auto hit = caster.hit(scene.positions[v[0]], scene.positions[v[1]], scene.positions[v[2]]);
    if (hit && (!best || hit->t < best->t)) best = RayHit{slot, hit->t, hit->barycentric};
  }
  return best;
}

std::optional<NearestHit> nearest_of_all(const Scene& scene, const dvec3& point) {
  std::optional<NearestHit> best;
  for (std::uint32_t slot = 0; slot < scene.primitives.size(); ++slot) {
    if (scene.primitives[slot].size() == 0) continue;
    const NearestPlace place = nearest_place(scene.positions, scene.primitives[slot], point);
    if (!best || place.distance < best->distance)
      best = NearestHit{slot, place.distance, place.place, place.barycentric};
  }
  return best;
}

bool meets(const Frustum& frustum, const Box& box) {
  for (std::size_t i = 0; i < frustum.count; ++i) {
    const glm::dvec4& plane = frustum.planes[i];
    double sum = plane.w;
    for (int k = 0; k < 3; ++k) sum += plane[k] * (plane[k] > 0 ? box.highest[k] : box.lowest[k]);
    if (sum < 0.0) return false;
  }
  return true;
}

// Compares all queries with the plain loop over everything, around a sphere of the given size.
class Comparison {
 public:
  Comparison(const dvec3& center, double size, unsigned seed) : center_(center), size_(size), random_(seed) {}

  void rays(const Bvh& bvh, const Scene& scene, int count) {
    for (int i = 0; i < count; ++i) {
      Ray ray;
      ray.origin = center_ + vector() * (size_ * 2.0);
      ray.direction = (center_ + vector() * size_ - ray.origin) * std::exp2(unit() * 20.0);
      if (i % 5 == 0) ray.direction[static_cast<int>(random_() % 3)] = 0.0;
      if (i % 7 == 0) ray.t_max = std::abs(unit()) * 1e-3;
      const auto expected = cast_all(scene, ray);
      const auto found = bvh.cast(scene.positions, ray);
      ASSERT_EQ(found.has_value(), expected.has_value());
      if (!found) continue;
      ++hits;
      EXPECT_EQ(found->slot, expected->slot);
      EXPECT_EQ(found->t, expected->t);
      EXPECT_EQ(found->barycentric, expected->barycentric);
    }
  }

  void frustums(const Bvh& bvh, const Scene& scene, int count) {
    for (int i = 0; i < count; ++i) {
      const dvec3 eye = center_ + vector() * (size_ * 2.0);
      const glm::dmat4 clip = glm::perspective(0.9, 1.0, size_ * 0.01, size_ * 10.0) *
                              glm::lookAt(eye, center_ + vector() * size_ * 0.2, dvec3(0.1, 0.9, 0.3));
      const Frustum frustum =
          frustum_around_pixel(clip, {500, 500}, {250 + 200 * unit(), 250 + 200 * unit()}, 6.0 + 30.0 * (i % 3));
      std::set<std::uint32_t> found;
      bvh.visit_frustum(scene.positions, frustum, [&](std::uint32_t slot) { EXPECT_TRUE(found.insert(slot).second); });
      std::size_t expected = 0;
      for (std::uint32_t slot = 0; slot < scene.primitives.size(); ++slot) {
        if (scene.primitives[slot].size() == 0) continue;
        if (!meets(frustum, box_of(scene.positions, scene.primitives[slot]))) continue;
        ++expected;
        EXPECT_TRUE(found.count(slot)) << slot;
      }
      EXPECT_LE(found.size(), expected + 3);  // hardly any that only rounding lets in
      visited += expected;
    }
  }

  void boxes(const Bvh& bvh, const Scene& scene, int count) {
    for (int i = 0; i < count; ++i) {
      Box box;
      for (int corner = 0; corner < 2; ++corner) box.add(center_ + vector() * size_);
      std::set<std::uint32_t> found, expected;
      bvh.visit_box(scene.positions, box, [&](std::uint32_t slot) { EXPECT_TRUE(found.insert(slot).second); });
      for (std::uint32_t slot = 0; slot < scene.primitives.size(); ++slot)
        if (scene.primitives[slot].size() > 0 && box.overlaps(box_of(scene.positions, scene.primitives[slot])))
          expected.insert(slot);
      EXPECT_EQ(found, expected);
    }
  }

  void places(const Bvh& bvh, const Scene& scene, int count) {
    for (int i = 0; i < count; ++i) {
      const dvec3 point = center_ + vector() * (size_ * 2.0);
      const auto expected = nearest_of_all(scene, point);
      const auto found = bvh.nearest(scene.positions, point, std::numeric_limits<double>::infinity());
      ASSERT_EQ(found.has_value(), expected.has_value());
      if (!found) continue;
      EXPECT_EQ(found->slot, expected->slot);
      EXPECT_EQ(found->distance, expected->distance);
      EXPECT_FALSE(bvh.nearest(scene.positions, point, expected->distance * 0.999));
    }
  }

  int hits = 0;
  std::size_t visited = 0;

 private:
  double unit() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
  dvec3 vector() { return {unit(), unit(), unit()}; }

  dvec3 center_;
  double size_;
  std::mt19937 random_;
};

TEST(bvh, random_soups_of_any_size_and_place) {
  const std::pair<double, dvec3> frames[] = {{1.0, dvec3(0)},   {1e-3, dvec3(1e6, -2e6, 5e5)},
                                             {1e150, dvec3(0)}, {1e-200, dvec3(0)},
                                             {50.0, dvec3(7)},  {1e-9, dvec3(1, 2, 3)}};
  for (const auto& [size, center] : frames) {
    for (const std::size_t count : {1u, 2u, 5u, 300u, 3000u}) {
      const Scene scene = test::soup(count, static_cast<unsigned>(count), size, center);
      Bvh bvh;
      bvh.build(scene.positions, scene.primitives);
      ASSERT_EQ(find_defect(bvh, scene.positions), nullptr);
      EXPECT_EQ(bvh.size(), count);
      Comparison comparison(center, size, 5);
      comparison.rays(bvh, scene, test::is_long_run() ? 400 : 150);
      EXPECT_GE(comparison.hits, count >= 300 ? 20 : 0);
      if (size > 1e100 || size < 1e-100) continue;  // squares of lengths leave the double range
      comparison.frustums(bvh, scene, 30);
      comparison.boxes(bvh, scene, 30);
      comparison.places(bvh, scene, 50);
      EXPECT_GE(comparison.visited, count >= 300 ? 20u : 0u);
    }
  }
}

TEST(bvh, equal_depth_goes_to_the_smallest_slot) {
  // Sixty copies of one triangle with turned and reversed corners, far apart in slots.
  const std::vector<dvec3> p = {{0, 0, 0.1}, {1, 0.1, 0}, {0.3, 1, 0.7}};
  std::vector<Primitive> primitives(90);
  for (std::uint32_t i = 30; i < 90; ++i) {
    primitives[i] = i % 2 ? Primitive::triangle(i % 3, (i + 1) % 3, (i + 2) % 3, i)
                          : Primitive::triangle((i + 2) % 3, (i + 1) % 3, i % 3, i);
  }
  Bvh bvh;
  bvh.build(p, primitives);
  const Ray ray{{0.4, 0.3, 5}, {0.01, 0.02, -1}};
  ASSERT_TRUE(bvh.cast(p, ray));
  EXPECT_EQ(bvh.cast(p, ray)->slot, 30u);
  for (std::uint32_t i = 30; i < 80; ++i) bvh.erase(i);
  EXPECT_EQ(bvh.cast(p, ray)->slot, 80u);
  bvh.insert(p, 3, primitives[35]);
  EXPECT_EQ(bvh.cast(p, ray)->slot, 3u);
}

TEST(bvh, empty_and_single) {
  Bvh bvh;
  const std::vector<dvec3> p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Ray ray{{0.2, 0.2, 1}, {0, 0, -1}};
  EXPECT_FALSE(bvh.cast(p, ray));
  EXPECT_FALSE(bvh.nearest(p, dvec3(0), 100.0));
  bvh.build(p, {});
  EXPECT_FALSE(bvh.cast(p, ray));
  bvh.erase(5);
  bvh.update(p, 5);
  bvh.insert(p, 4, Primitive::triangle(0, 1, 2, 9));
  ASSERT_TRUE(bvh.cast(p, ray));
  EXPECT_EQ(bvh.cast(p, ray)->slot, 4u);
  EXPECT_EQ(bvh.primitive(4).owner, 9u);
  EXPECT_EQ(bvh.primitive(3).size(), 0);
  bvh.erase(4);
  EXPECT_FALSE(bvh.cast(p, ray));
  EXPECT_EQ(bvh.size(), 0u);
  EXPECT_EQ(find_defect(bvh, p), nullptr);
}

TEST(bvh, places_that_are_not_finite_are_left_out_until_they_are) {
  Scene scene = test::soup(50, 4);
  const dvec3 before = scene.positions[3];
  scene.positions[3].y = std::numeric_limits<double>::quiet_NaN();
  Bvh bvh;
  bvh.build(scene.positions, scene.primitives);
  EXPECT_EQ(bvh.size(), 49u);
  EXPECT_EQ(find_defect(bvh, scene.positions), nullptr);
  scene.positions[3] = before;
  bvh.update(scene.positions, 1);
  EXPECT_EQ(bvh.size(), 50u);
  scene.positions[3].x = std::numeric_limits<double>::infinity();
  bvh.update(scene.positions, 1);
  EXPECT_EQ(bvh.size(), 49u);
  EXPECT_EQ(find_defect(bvh, scene.positions), nullptr);
  scene.positions[3] = before;
  bvh.update(scene.positions, 1);
  EXPECT_EQ(bvh.size(), 50u);
  EXPECT_EQ(find_defect(bvh, scene.positions), nullptr);
}

// Random edits in step with a plain list.
void edit_tree_at_random(Bvh& bvh, Scene& scene, std::mt19937& random, int count, double size) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return dvec3(unit(random), unit(random), unit(random)) * size; };
  for (int i = 0; i < count; ++i) {
    const auto slot = static_cast<std::uint32_t>(random() % scene.primitives.size());
    const int kind = static_cast<int>(random() % 8);
    if (kind < 3) {
      bvh.erase(slot);
      scene.primitives[slot] = Primitive{};
    } else if (kind < 6) {
      const auto first = static_cast<std::uint32_t>(scene.positions.size());
      const dvec3 place = vector();
      for (int k = 0; k < 3; ++k) scene.positions.push_back(place + 0.15 * vector());
      const std::uint32_t target = kind == 3 ? static_cast<std::uint32_t>(scene.primitives.size()) : slot;
      if (kind == 3) scene.primitives.emplace_back();
      scene.primitives[target] =
          i % 9 == 0 ? Primitive::segment(first, first + 1, 1) : Primitive::triangle(first, first + 1, first + 2, 2);
      bvh.insert(scene.positions, target, scene.primitives[target]);
    } else {
      for (int k = 0; k < scene.primitives[slot].size(); ++k) {
        dvec3& p = scene.positions[scene.primitives[slot].vertices[static_cast<std::size_t>(k)]];
        p = kind == 6 ? p + 0.02 * vector() : p * (0.5 + 0.4 * unit(random)) + vector() * 0.5;
      }
      bvh.update(scene.positions, slot);
    }
  }
}

TEST(bvh, stays_right_through_random_edits) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    Scene scene = test::soup(seed == 0 ? 1 : 400 * seed, seed);
    Bvh bvh;
    bvh.build(scene.positions, scene.primitives);
    std::mt19937 random(seed);
    for (int round = 0; round < (test::is_long_run() ? 12 : 5); ++round) {
      edit_tree_at_random(bvh, scene, random, 150, 1.0);
      ASSERT_STREQ(find_defect(bvh, scene.positions), nullptr);
      Comparison comparison(dvec3(0), 1.0, seed + 100);
      comparison.rays(bvh, scene, 60);
      comparison.frustums(bvh, scene, 5);
      comparison.places(bvh, scene, 10);
      if (HasFailure()) FAIL() << "seed " << seed << " round " << round;
    }
    EXPECT_TRUE(bvh.is_worn());
    bvh.rebuild(scene.positions);
    EXPECT_FALSE(bvh.is_worn());
    ASSERT_STREQ(find_defect(bvh, scene.positions), nullptr);
  }
}

// What only trembles stays where it was; what leaves its box does not.
TEST(bvh, is_worn_by_how_far_things_go) {
  Scene scene = test::soup(1000, 1);
  Bvh bvh;
  bvh.build(scene.positions, scene.primitives);
  const auto move_all = [&](const dvec3& way) {
    for (dvec3& p : scene.positions) p += way;
    for (std::uint32_t slot = 0; slot < scene.primitives.size(); ++slot) bvh.update(scene.positions, slot);
  };
  for (int turn = 0; turn < 10; ++turn) move_all(dvec3(turn % 2 == 0 ? 1e-5 : -1e-5));
  EXPECT_FALSE(bvh.is_worn());
  for (int turn = 0; turn < 10; ++turn) move_all(dvec3(0.05));
  EXPECT_TRUE(bvh.is_worn());
  EXPECT_STREQ(find_defect(bvh, scene.positions), nullptr);
}

TEST(bvh, primitives_far_outside_the_first_frame) {
  Scene scene = test::soup(100, 1);
  Bvh bvh;
  bvh.build(scene.positions, scene.primitives);
  for (const double size : {1e3, 1e9, 1e20, 1e60, 1e150}) {
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    scene.positions.insert(scene.positions.end(),
                           {dvec3(-size, -size, size), dvec3(size, -size, size * 1.1), dvec3(0, size, size)});
    scene.primitives.push_back(Primitive::triangle(first, first + 1, first + 2, 0));
    bvh.insert(scene.positions, static_cast<std::uint32_t>(scene.primitives.size() - 1), scene.primitives.back());
    ASSERT_STREQ(find_defect(bvh, scene.positions), nullptr);
    Comparison near(dvec3(0), 1.0, 3);
    near.rays(bvh, scene, 200);
    Comparison far(dvec3(0), size, 4);
    far.rays(bvh, scene, 200);
    EXPECT_GT(near.hits, 20);
    EXPECT_GT(far.hits, 5);
  }
}

TEST(bvh, many_equal_and_strung_out_primitives) {
  // Equal centers, and sizes that halve: splitting by bins alone would make a list instead of a tree.
  Scene scene;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const double r = i < 1000 ? 1.0 : std::exp2(-static_cast<double>(i - 1000) * 0.5);
    scene.positions.insert(scene.positions.end(), {dvec3(0, -r, r), dvec3(r, r, 0), dvec3(-r, r, 0)});
    scene.primitives.push_back(Primitive::triangle(3 * i, 3 * i + 1, 3 * i + 2, i));
  }
  Bvh bvh;
  bvh.build(scene.positions, scene.primitives);
  ASSERT_STREQ(find_defect(bvh, scene.positions), nullptr);
  Comparison(dvec3(0), 1.0, 3).rays(bvh, scene, 100);
  std::vector<Primitive> primitives = scene.primitives;
  bvh.build(scene.positions, {});
  for (std::uint32_t i = 0; i < 2000; ++i) bvh.insert(scene.positions, i, primitives[i]);
  ASSERT_STREQ(find_defect(bvh, scene.positions), nullptr);
  Comparison(dvec3(0), 1.0, 4).rays(bvh, scene, 100);
}

TEST(bvh, the_bunny_agrees_with_the_plain_loop_before_and_after_edits) {
  Scene scene = test::read_triangles(RYOSEN_SOURCE_DIR "/assets/stanford_bunny.obj");
  ASSERT_EQ(scene.primitives.size(), 69451u);
  Bvh bvh;
  const auto start = std::chrono::steady_clock::now();
  bvh.build(scene.positions, scene.primitives);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  std::cout << "  built in " << time.count() << " ms, " << bvh.bytes() / scene.primitives.size()
            << " bytes a triangle\n";
  ASSERT_STREQ(find_defect(bvh, scene.positions), nullptr);
  const Box root = box_of(scene.positions, Primitive::segment(0, 1, 0));
  dvec3 lowest = root.lowest, highest = root.highest;
  for (const dvec3& p : scene.positions) {
    lowest = glm::min(lowest, p);
    highest = glm::max(highest, p);
  }
  const dvec3 center = (lowest + highest) * 0.5;
  const double size = glm::distance(lowest, highest) * 0.25;
  Comparison comparison(center, size, 9);
  const int rays = test::is_long_run() ? 150 : 20, others = test::is_long_run() ? 20 : 3;
  comparison.rays(bvh, scene, rays);
  comparison.frustums(bvh, scene, others);
  comparison.places(bvh, scene, others);
  EXPECT_GT(comparison.hits, rays / 3);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const auto slot = static_cast<std::uint32_t>(random() % scene.primitives.size());
    if (i % 2 == 0) {
      scene.primitives[slot] = Primitive{};
      bvh.erase(slot);
    } else if (scene.primitives[slot].size() == 3) {
      std::swap(scene.primitives[slot].vertices[0], scene.primitives[slot].vertices[1]);
      bvh.insert(scene.positions, slot, scene.primitives[slot]);
    }
  }
  for (dvec3& p : scene.positions) p += dvec3(unit(random), unit(random), unit(random)) * size * 0.01;
  for (std::uint32_t slot = 0; slot < scene.primitives.size(); ++slot) bvh.update(scene.positions, slot);
  ASSERT_STREQ(find_defect(bvh, scene.positions), nullptr);
  comparison.rays(bvh, scene, rays);
  comparison.frustums(bvh, scene, others);
}

}  // namespace
}  // namespace ryosen
