// What a guard of a surface tells of a step, against a comparison of all faces with each other.
#include "ryosen/algo/crossings/crossing_guard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ryosen/geometry/predicates.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/met_faces.h"
#include "tests/support/core/pairs_by_asking_all.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {
namespace {

// Two cones on one rough circle of n places.
IndexedMesh two_cones(std::uint32_t n) {
  IndexedMesh source;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n, radius = 1 + 0.05 * ((i * 7) % 5);
    source.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.02 * ((i * 3) % 7));
    const std::uint32_t k = (i + 1) % n;
    for (const std::uint32_t corner : {n, i, k, n + 1, k, i}) source.corners.push_back(corner);
    source.face_offsets.push_back(6 * i + 3);
    source.face_offsets.push_back(6 * i + 6);
  }
  source.positions.insert(source.positions.end(), {{0, 0, 1}, {0, 0, -1}});
  return source;
}

bool is_flat(const IndexedMesh& mesh, std::size_t face) {
  const auto at = [&](std::size_t k) { return mesh.positions[mesh.face(face)[k]]; };
  return are_collinear(at(0), at(1), at(2));
}

TriangleCorners corners_of_face(const IndexedMesh& mesh, Face f) {
  const auto corners = mesh.face(f.index);
  return {mesh.positions[corners[0]], mesh.positions[corners[1]], mesh.positions[corners[2]]};
}

// Whether faces meet, or one has lost its area, when a vertex has become another one there.
bool meets_by_asking_all(const IndexedMesh& before, std::uint32_t gone, std::uint32_t kept,
                         const glm::dvec3& position) {
  IndexedMesh after;
  after.positions = before.positions;
  after.positions[kept] = position;
  for (std::size_t f = 0; f < before.face_count(); ++f) {
    const auto corners = before.face(f);
    if (std::count(corners.begin(), corners.end(), gone) + std::count(corners.begin(), corners.end(), kept) == 2)
      continue;
    for (const std::uint32_t corner : corners) after.corners.push_back(corner == gone ? kept : corner);
    after.face_offsets.push_back(static_cast<std::uint32_t>(after.corners.size()));
    if (is_flat(after, after.face_count() - 1) && !is_flat(before, f)) return true;
  }
  return !pairs_by_asking_all(after).empty();
}

TEST(crossing_guard, tells_of_a_hub_what_all_faces_tell) {
  const IndexedMesh source = two_cones(150);
  ASSERT_TRUE(pairs_by_asking_all(source).empty());
  const Mesh mesh = from_indexed(source);
  const CrossingGuard guard(mesh);
  Dice dice(11);
  const int steps = is_long_run() ? 150 : 60;
  int refused = 0;
  for (int step = 0; step < steps; ++step) {
    const Halfedge h(static_cast<std::uint32_t>(dice.below(static_cast<int>(mesh.halfedge_slots()))));
    const Vertex gone = mesh.from(h), kept = mesh.to(h);
    const double along = dice.below(5) / 4.0;
    const glm::dvec3 beside = dice.one_in(2) ? 0.1 * glm::dvec3(dice.unit(), dice.unit(), dice.unit()) : glm::dvec3(0);
    const glm::dvec3 position = (1 - along) * mesh.position(gone) + along * mesh.position(kept) + beside;
    const bool expected = meets_by_asking_all(source, gone.index, kept.index, position);
    EXPECT_EQ(guard.would_meet(h, position), expected) << step << ": " << gone.index << " into " << kept.index;
    refused += expected ? 1 : 0;
  }
  EXPECT_GT(refused, steps / 10);
  EXPECT_LT(refused, steps * 9 / 10);
}

// The number of the sheet of each face: those of one have no corner of another.
std::vector<std::uint32_t> parts_of(const IndexedMesh& mesh) {
  std::vector<std::uint32_t> parts(mesh.face_count(), 0);
  std::uint32_t last = 0;
  for (std::size_t f = 1; f < parts.size(); ++f) {
    const auto corners = mesh.face(f), before = mesh.face(f - 1);
    if (*std::min_element(corners.begin(), corners.end()) > *std::max_element(before.begin(), before.end())) ++last;
    parts[f] = last;
  }
  return parts;
}

// Boxes of what faces have in common that meet, a little larger.
MetPlaces places_where_faces_meet(const IndexedMesh& mesh, double reach) {
  const std::vector<std::uint32_t> parts = parts_of(mesh);
  std::vector<MetPlaces::Place> places;
  for (const FacePair& pair : pairs_by_asking_all(mesh)) {
    const Box common = common_box(corners_of_face(mesh, pair.first), corners_of_face(mesh, pair.second));
    places.push_back(
        {{common.lowest - reach, common.highest + reach}, parts[pair.first.index], parts[pair.second.index]});
  }
  return {parts, places};
}

// Whether faces meet away from these places when a vertex lies elsewhere; what meets a face that lies in one of its
// part's is not asked.
bool meets_elsewhere(IndexedMesh mesh, const MetPlaces& met, std::uint32_t moved, const glm::dvec3& position) {
  mesh.positions[moved] = position;
  const std::vector<FacePair> pairs = pairs_by_asking_all(mesh);
  const auto is_free = [&](Face f) {
    const auto corners = mesh.face(f.index);
    return std::count(corners.begin(), corners.end(), moved) > 0 &&
           met.enclose(box_of(corners_of_face(mesh, f)), met.parts()[f.index]);
  };
  return std::any_of(pairs.begin(), pairs.end(), [&](const FacePair& pair) {
    if (is_free(pair.first) || is_free(pair.second)) return false;
    return !(met.have_met(met.parts()[pair.first.index], met.parts()[pair.second.index]) &&
             met.hold(corners_of_face(mesh, pair.first), corners_of_face(mesh, pair.second)));
  });
}

// Grids of n by n, one over the other, rough so that they cross.
IndexedMesh crossing_sheets(std::uint32_t n, std::uint32_t sheets, double rough, std::uint64_t seed) {
  IndexedMesh source;
  Dice dice(seed);
  for (std::uint32_t sheet = 0; sheet < sheets; ++sheet) {
    const auto first = static_cast<std::uint32_t>(source.positions.size());
    for (std::uint32_t i = 0; i < (n + 1) * (n + 1); ++i) {
      const std::uint32_t column = i % (n + 1), row = i / (n + 1);
      glm::dvec3 place(column, row, 0.3 * sheet);
      place.z += rough * dice.unit();
      place.y += 0.2 * dice.unit();
      place.x += 0.2 * dice.unit();
      source.positions.push_back(place);
    }
    for (std::uint32_t i = 0; i < n * n; ++i) {
      const std::uint32_t a = first + i / n * (n + 1) + i % n, c = a + n + 2;
      for (const std::uint32_t corner : {a, a + 1, c, a, c, c - 1}) source.corners.push_back(corner);
      for (int triangle = 0; triangle < 2; ++triangle) source.face_offsets.push_back(source.face_offsets.back() + 3);
    }
  }
  return source;
}

TEST(crossing_guard, lets_faces_meet_where_they_met_before_and_nowhere_else) {
  struct Case {
    std::uint32_t n, sheets;
    double rough, reach;
  };
  for (const Case& c : {Case{4, 2, 0.5, 0.5}, {5, 2, 0.45, 0.1}, {3, 3, 1, 0.3}, {6, 3, 0.4, 1}, {2, 5, 1.2, 0.2}}) {
    SCOPED_TRACE(c.rough);
    const IndexedMesh source = crossing_sheets(c.n, c.sheets, c.rough, c.n);
    const MetPlaces met = places_where_faces_meet(source, c.reach);
    ASSERT_FALSE(met.is_empty());
    const Mesh mesh = from_indexed(source);
    const CrossingGuard guard(mesh, met);
    Dice dice(5);
    int allowed = 0, refused = 0;
    for (int step = 0; step < 100; ++step) {
      const Vertex v(static_cast<std::uint32_t>(dice.below(static_cast<int>(mesh.vertex_slots()))));
      const glm::dvec3 place = mesh.position(v) + glm::dvec3(0, 0, 2 * dice.unit() - 1);
      const bool expected = meets_elsewhere(source, met, v.index, place);
      EXPECT_EQ(guard.would_meet(v, place), expected) << v.index;
      ++(expected ? refused : allowed);
    }
    EXPECT_GT(allowed, 0);
    EXPECT_GT(refused, 0);
  }
}

// Whether a collapse lets pairs meet that come from none, or more than before, or takes the area of a face.
bool adds_by_asking_all(const IndexedMesh& before, std::uint32_t gone, std::uint32_t kept, const glm::dvec3& position) {
  IndexedMesh after;
  after.positions = before.positions;
  after.positions[kept] = position;
  std::vector<Face> all, left;
  for (std::uint32_t f = 0; f < before.face_count(); ++f) {
    const auto corners = before.face(f);
    all.emplace_back(f);
    if (std::count(corners.begin(), corners.end(), gone) + std::count(corners.begin(), corners.end(), kept) == 2)
      continue;
    left.emplace_back(f);
    for (const std::uint32_t corner : corners) after.corners.push_back(corner == gone ? kept : corner);
    after.face_offsets.push_back(static_cast<std::uint32_t>(after.corners.size()));
    if (is_flat(after, after.face_count() - 1) && !is_flat(before, f)) return true;
  }
  const MetFaces was = met_faces(before, all), is = met_faces(after, left);
  return is.pairs.size() > was.pairs.size() || !pairs_from_nowhere(was, is).empty();
}

TEST(crossing_guard, lets_pairs_meet_that_come_from_others_and_no_more) {
  for (const double rough : {0.45, 0.5, 0.6, 0.9, 1.5}) {
    SCOPED_TRACE(rough);
    const IndexedMesh source = crossing_sheets(5, rough < 0.6 ? 2 : 3, rough, 9);
    const Mesh mesh = from_indexed(source);
    CrossingGuard guard(mesh), strict(mesh);
    guard.inherit();
    Dice dice(4);
    int allowed = 0, refused = 0, inherited = 0;
    for (int step = 0; step < 150; ++step) {
      const Halfedge h(static_cast<std::uint32_t>(dice.below(static_cast<int>(mesh.halfedge_slots()))));
      const Vertex gone = mesh.from(h), kept = mesh.to(h);
      const double along = dice.below(3) / 2.0;
      const glm::dvec3 position = (1 - along) * mesh.position(gone) + along * mesh.position(kept);
      const bool expected = adds_by_asking_all(source, gone.index, kept.index, position);
      EXPECT_EQ(guard.would_meet(h, position), expected) << step << ": " << gone.index << " into " << kept.index;
      ++(expected ? refused : allowed);
      if (!expected && strict.would_meet(h, position)) ++inherited;
    }
    EXPECT_GT(allowed, 10);
    EXPECT_GT(refused, 10);
    EXPECT_GT(inherited, 3);
  }
}

// An upright sheet of three triangles through so many level ones, and a vertex that moves hardly in a collapse.
TEST(crossing_guard, refuses_a_step_among_more_pairs_than_it_compares) {
  for (const std::uint32_t levels : {1u, 10u, 100u, 490u, 510u, 900u}) {
    IndexedMesh source;
    source.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 9.99}, {1, 0, 10}, {0, 0, 10}};
    source.corners = {0, 1, 2, 2, 1, 3, 2, 3, 4};
    source.face_offsets = {0, 3, 6, 9};
    for (std::uint32_t i = 0; i < levels; ++i) {
      const double z = 1 + 8.0 * i / levels;
      for (const glm::dvec3& place : {glm::dvec3(-5, -5, z), glm::dvec3(5, -5, z), glm::dvec3(0.5, 9, z)}) {
        source.corners.push_back(static_cast<std::uint32_t>(source.positions.size()));
        source.positions.push_back(place);
      }
      source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
    }
    const Mesh mesh = from_indexed(source);
    CrossingGuard guard(mesh);
    guard.inherit();
    const Halfedge h = any_sheet_between(mesh, Vertex(2), Vertex(4));
    ASSERT_TRUE(h);
    EXPECT_EQ(guard.would_meet(h, mesh.position(Vertex(4))), 2 * levels > 1000) << levels;
  }
}

}  // namespace
}  // namespace ryosen::test
