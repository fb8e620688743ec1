// What is found near triangles while a mesh with hubs changes, against asking every face.
#include "ryosen/algo/crossings/near_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ryosen/geometry/predicates.h"
#include "ryosen/geometry/triangles_meet.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/edit.h"
#include "ryosen/ops/collapse_edge.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {
namespace {

// A fan of n faces around a hub so high, another one below on the same circle, and n squares between, each in two
// triangles.
Mesh two_hubs(std::uint32_t n, double height) {
  IndexedMesh source;
  for (const double radius : {1.0, 1.0 + 6.0 / n})
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 6.283185307179586 * i / n;
      source.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
  source.positions.insert(source.positions.end(), {{0, 0, height}, {0, 0, -1}});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t k = (i + 1) % n;
    for (const std::uint32_t corner : {2 * n, i, k, 2 * n + 1, n + k, n + i, i, n + i, n + k, i, n + k, k})
      source.corners.push_back(corner);
    for (std::uint32_t f = 1; f <= 4; ++f) source.face_offsets.push_back(12 * i + 3 * f);
  }
  return from_indexed(source);
}

// Pages that stand around a spine, each of so many squares along it, in two triangles each. They bend with the spine by
// so much.
Mesh book(std::uint32_t pages, std::uint32_t squares, double bend) {
  IndexedMesh source;
  const auto at = [&](double radius, double angle, std::uint32_t k) {
    source.positions.emplace_back(radius * std::cos(angle) + bend * (k % 2), radius * std::sin(angle), k);
  };
  for (std::uint32_t k = 0; k <= squares; ++k) at(0, 0, k);
  for (std::uint32_t page = 0; page < pages; ++page) {
    const auto first = static_cast<std::uint32_t>(source.positions.size());
    for (std::uint32_t k = 0; k <= squares; ++k) at(1, 6.283185307179586 * page / pages, k);
    for (std::uint32_t k = 0; k < squares; ++k) {
      for (const std::uint32_t corner : {k, k + 1, first + k, first + k, k + 1, first + k + 1})
        source.corners.push_back(corner);
      for (int f = 0; f < 2; ++f) source.face_offsets.push_back(source.face_offsets.back() + 3);
    }
  }
  return from_indexed(source);
}

NumberedTriangle numbered(const Mesh& mesh, Face f) {
  NumberedTriangle t{corners_of(mesh, mesh.halfedge(f)), {}};
  std::size_t i = 0;
  for (const Vertex v : vertices_around(mesh, f)) t.numbers[i++] = point(mesh, v).index;
  return t;
}

class Watched {
 public:
  Watched(Mesh mesh, std::uint64_t seed) : mesh_(std::move(mesh)), near_(mesh_), dice_(seed) {}

  Vertex any_vertex() {
    for (;;) {
      const Vertex v(static_cast<std::uint32_t>(dice_.below(static_cast<int>(mesh_.vertex_slots()))));
      if (mesh_.is_alive(v) && !mesh_.is_isolated(v)) return v;
    }
  }
  void move_any() {
    const Vertex v = any_vertex();
    Edit edit(mesh_, nullptr);
    move_point(edit, v, mesh_.position(v) + 0.05 * any_way());
    edit.commit();
    for_each_copy(mesh_, v, [&](Vertex copy) { near_.follow_move(copy); });
  }
  void collapse_any() {
    Halfedge h = mesh_.halfedge(any_vertex());
    if (dice_.one_in(2)) h = twin(h);
    if (!CollapseEdge{h}.is_legal(mesh_)) return;
    const Vertex kept = mesh_.to(h);
    for (const Face f : {mesh_.face(h), mesh_.face(twin(h))})
      if (f) near_.forget(f);
    Edit edit(mesh_, nullptr);
    CollapseEdge{h}.apply(edit);
    edit.commit();
    near_.follow(kept);
  }
  // Triangles at a hub, in the plane of faces, along edges and anywhere; of points of the mesh and of others in their
  // places.
  NumberedTriangle any_triangle() {
    NumberedTriangle t;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Vertex v = any_vertex();
      put(t, i, v);
      if (dice_.one_in(2)) move(t, i, 0.5 * t.places[i] + 0.5 * mesh_.position(any_vertex()));
      if (dice_.one_in(3)) move(t, i, t.places[i] + 0.1 * any_way());
    }
    const Vertex v = any_vertex();
    if (dice_.one_in(2)) put(t, 0, dice_.one_in(2) ? mesh_.to(mesh_.halfedge(v)) : v);
    return t;
  }
  // The faces that one of them meets are found, and none twice; returns how many those are, and adds what was found.
  std::size_t check(const std::vector<NumberedTriangle>& triangles, std::size_t& sum) {
    std::vector<Face> found;
    near_.find(triangles, found);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    std::size_t meeting = 0;
    for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
      if (!mesh_.is_alive(Face(i)) || !meets(Face(i), triangles)) continue;
      ++meeting;
      EXPECT_TRUE(std::binary_search(found.begin(), found.end(), Face(i))) << i;
    }
    sum += found.size();
    return meeting;
  }

 private:
  glm::dvec3 any_way() { return glm::dvec3(dice_.unit(), dice_.unit(), dice_.unit()) - 0.5; }
  void put(NumberedTriangle& t, std::uint32_t corner, Vertex v) {
    t.places[corner] = mesh_.position(v);
    t.numbers[corner] = dice_.one_in(8) ? mesh_.vertex_slots() + corner : point(mesh_, v).index;
  }
  void move(NumberedTriangle& t, std::uint32_t corner, const glm::dvec3& place) {
    t.places[corner] = place;
    t.numbers[corner] = mesh_.vertex_slots() + corner;
  }
  bool meets(Face f, const std::vector<NumberedTriangle>& triangles) const {
    const NumberedTriangle own = numbered(mesh_, f);
    if (are_collinear(own.places[0], own.places[1], own.places[2])) return false;
    return std::any_of(triangles.begin(), triangles.end(), [&](const NumberedTriangle& other) {
      return !are_collinear(other.places[0], other.places[1], other.places[2]) && meet_elsewhere(own, other);
    });
  }

  Mesh mesh_;
  NearFaces near_;
  Dice dice_;
};

// Changes the mesh before every so many-th of 400 questions.
void walk(Watched&& watched, int every, void (*change)(Watched&, int step)) {
  std::size_t met = 0, found = 0;
  constexpr int steps = 400;
  for (int step = 0; step < steps; ++step) {
    if (step % every == 0) change(watched, step);
    std::vector<NumberedTriangle> triangles;
    for (int i = 0; i <= step % 4; ++i) triangles.push_back(watched.any_triangle());
    met += watched.check(triangles, found);
  }
  EXPECT_GT(met, 10u * steps);
  EXPECT_LT(found, 12 * met);
}

TEST(near_faces, holds_all_that_meet_while_hubs_move_and_collapse) {
  for (const double height : {1.0, 0.0, -0.5})
    walk(Watched(two_hubs(90, height), 7), 1,
         [](Watched& watched, int step) { step % 3 == 0 ? watched.collapse_any() : watched.move_any(); });
}

TEST(near_faces, holds_all_that_meet_while_pages_on_a_spine_move) {
  for (const double bend : {0.0, 0.01})
    walk(Watched(book(80, 3, bend), 11), 4, [](Watched& watched, int) { watched.move_any(); });
}

TEST(near_faces, are_few_where_a_triangle_touches_a_hub_of_many) {
  for (const double height : {1.0, 0.0})
    for (const std::uint32_t n : {400u, 1600u}) {
      const Mesh mesh = two_hubs(n, height);
      NearFaces near(mesh);
      for (std::uint32_t i = 0; i < 4 * n; ++i) {
        std::vector<Face> found;
        near.find(std::vector{numbered(mesh, Face(i))}, found);
        EXPECT_GE(found.size(), 4u);
        EXPECT_LE(found.size(), 60u) << n << " " << i;
      }
    }
}

}  // namespace
}  // namespace ryosen::test
