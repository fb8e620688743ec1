#include "tests/support/core/solids.h"

#include <algorithm>
#include <map>
#include <set>

namespace ryosen::test {

namespace {

LatticePoint random_point(Dice& dice, int size) { return {dice.below(size), dice.below(size), dice.below(size)}; }

bool has_area(const std::array<LatticePoint, 3>& t) {
  return cross(difference(t[1], t[0]), difference(t[2], t[0])) != LatticeVector{0, 0, 0};
}

void add_triangle(SolidBuilder& to, const std::array<LatticePoint, 3>& t) {
  if (has_area(t)) to.add_face({t[0], t[1], t[2]});
}

}  // namespace

std::int64_t volume_six(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d) {
  return dot(cross(difference(b, a), difference(c, a)), difference(d, a));
}

void SolidBuilder::add_cube(const LatticePoint& lowest, bool triangles) {
  const auto corner = [&](unsigned i) {
    return LatticePoint{lowest[0] + static_cast<int>(i & 1u), lowest[1] + static_cast<int>(i >> 1 & 1u),
                        lowest[2] + static_cast<int>(i >> 2)};
  };
  const unsigned squares[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& s : squares) {
    std::vector<LatticePoint> face;
    for (const unsigned i : s) face.push_back(corner(i));
    if (!triangles) {
      add_face(face);
      continue;
    }
    // The diagonal that leaves the lower of the two points with the smaller coordinates, so that neighbours agree.
    const auto lowest_corner = std::min_element(face.begin(), face.end());
    std::rotate(face.begin(), lowest_corner, face.end());
    add_face({face[0], face[1], face[2]});
    add_face({face[0], face[2], face[3]});
  }
}

bool SolidBuilder::add_tetrahedron(std::array<LatticePoint, 4> p) {
  const std::int64_t volume = test::volume_six(p[0], p[1], p[2], p[3]);
  if (volume == 0) return false;
  if (volume < 0) std::swap(p[0], p[1]);
  for (const std::array<std::size_t, 3>& f : {std::array<std::size_t, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}})
    add_face({p[f[0]], p[f[1]], p[f[2]]});
  return true;
}

void SolidBuilder::turn(std::size_t from_face) {
  for (std::size_t i = from_face; i < faces_.size(); ++i) std::reverse(faces_[i].begin(), faces_[i].end());
}

void SolidBuilder::shuffle(Dice& dice) {
  for (std::size_t i = faces_.size(); i > 1; --i)
    std::swap(faces_[i - 1], faces_[static_cast<std::size_t>(dice.below(static_cast<int>(i)))]);
  for (auto& face : faces_)
    std::rotate(face.begin(), face.begin() + dice.below(static_cast<int>(face.size())), face.end());
}

std::int64_t SolidBuilder::volume_six() const {
  std::int64_t sum = 0;
  for (const auto& face : faces_)
    for (std::size_t i = 2; i < face.size(); ++i) sum += test::volume_six({0, 0, 0}, face[0], face[i - 1], face[i]);
  return sum;
}

IndexedMesh SolidBuilder::indexed() const {
  IndexedMesh mesh;
  std::map<LatticePoint, std::uint32_t> number;
  for (const auto& face : faces_) {
    for (const LatticePoint& p : face) {
      const auto [at, is_new] = number.try_emplace(p, static_cast<std::uint32_t>(mesh.positions.size()));
      if (is_new) mesh.positions.push_back({p[0], p[1], p[2]});
      mesh.corners.push_back(at->second);
    }
    mesh.face_offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
  return mesh;
}

IndexedMesh SolidBuilder::loose() const {
  IndexedMesh mesh;
  for (const auto& face : faces_) {
    for (const LatticePoint& p : face) {
      mesh.corners.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back({p[0], p[1], p[2]});
    }
    mesh.face_offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
  return mesh;
}

SolidBuilder random_union(std::uint64_t seed) {
  Dice dice(seed);
  SolidBuilder built;
  const int size = 2 + dice.below(2);
  const bool triangles = dice.one_in(2);
  std::set<LatticePoint> cells;
  for (int i = dice.below(9); i >= 0; --i)
    if (const LatticePoint cell = random_point(dice, size); cells.insert(cell).second) built.add_cube(cell, triangles);
  std::set<std::set<LatticePoint>> tetrahedra;
  for (int i = dice.below(7); i > 0; --i) {
    const std::array<LatticePoint, 4> p{random_point(dice, size + 1), random_point(dice, size + 1),
                                        random_point(dice, size + 1), random_point(dice, size + 1)};
    if (tetrahedra.insert({p.begin(), p.end()}).second) built.add_tetrahedron(p);
  }
  built.shuffle(dice);
  return built;
}

SolidBuilder random_solids_and_sheets(std::uint64_t seed) {
  Dice dice(seed * 6364136223846793005u + 1);
  const int size = 2 + dice.below(2);
  const auto point = [&] { return random_point(dice, size); };
  SolidBuilder built;
  for (int i = dice.below(4); i >= 0; --i) {
    const std::size_t first = built.faces().size();
    if (dice.one_in(3))
      built.add_cube({dice.below(2), dice.below(2), 0}, true);
    else
      built.add_tetrahedron({point(), point(), point(), point()});
    if (dice.one_in(5)) built.turn(first);
  }
  for (int i = dice.below(5); i > 0; --i) {
    const std::vector<std::vector<LatticePoint>> faces = built.faces();
    if (faces.empty() || dice.one_in(4)) {
      add_triangle(built, {point(), point(), point()});
      continue;
    }
    std::vector<LatticePoint> face = faces[static_cast<std::size_t>(dice.below(static_cast<int>(faces.size())))];
    if (dice.one_in(2)) std::reverse(face.begin(), face.end());
    if (dice.one_in(2)) face[static_cast<std::size_t>(dice.below(3))] = point();
    add_triangle(built, {face[0], face[1], face[2]});
  }
  built.shuffle(dice);
  return built;
}

SolidBuilder random_triangles(std::uint64_t seed) {
  Dice dice(seed * 2862933555777941757u + 3);
  SolidBuilder built;
  std::vector<LatticePoint> points;
  for (int i = 4 + dice.below(4); i > 0; --i) points.push_back(random_point(dice, 4));
  const auto point = [&] { return points[static_cast<std::size_t>(dice.below(static_cast<int>(points.size())))]; };
  for (int i = 2 + dice.below(14); i > 0; --i) add_triangle(built, {point(), point(), point()});
  built.shuffle(dice);
  return built;
}

}  // namespace ryosen::test
