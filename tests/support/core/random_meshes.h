// Small random polygon meshes from a seed: the same seed gives the same mesh on every platform and compiler.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ryosen {

// Faces as lists of point numbers below `points`; every face has three or more corners and none twice.
struct RandomMesh {
  std::uint64_t seed = 0;
  std::string story;  // how it was made, for messages
  int points = 0;
  std::vector<std::vector<int>> faces;
};

// Numbers from a seed (splitmix64), independent of the standard library's distributions.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  // 0 .. n-1, n > 0.
  int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }
  bool one_in(int n) { return below(n) == 0; }
  // 0 <= x < 1.
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

// A mesh of about 1 to 20 faces: a base (closed triangulations of sphere, torus, projective plane and Klein bottle,
// disks, strips with and without twist, prisms, pillows, books of faces on one edge, cones, soups on few points), then
// some of these changes: flips, dissolved edges, new points on edges, faces removed, turned, doubled, added on an edge,
// points glued, parts side by side, isolated points; at last all numbers are shuffled.
RandomMesh random_mesh(std::uint64_t seed);

// A mesh without non-manifold points or misoriented edges, closed or with one face taken out, of at least `faces` - 1
// faces.
RandomMesh random_manifold(std::uint64_t seed, int faces);

}  // namespace ryosen
