// Curvatures against formulas, on surfaces cut ever finer: that they converge, and how fast.
#include "ryosen/analysis/curvature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <random>

#include "ryosen/mesh/circulate.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

using Place = std::function<glm::dvec3(double u, double v)>;  // of parameters from 0 to 1
struct Truth {
  double smallest, largest;
};
using Formula = std::function<Truth(const glm::dvec3&)>;

// A patch of n by n squares, each cut in two along a diagonal by chance, whose inner points are moved by up to `aside`
// of their spacing.
Mesh patch(std::uint32_t n, double aside, const Place& place) {
  std::mt19937 random(n);
  std::uniform_real_distribution<double> share(-aside, aside);
  IndexedMesh list;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) {
      const bool inside = x > 0 && y > 0 && x < n && y < n;
      const double u = x + (inside ? share(random) : 0), v = y + (inside ? share(random) : 0);
      list.positions.push_back(place(u / n, v / n));
    }
  const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    for (const std::uint32_t corner : {a, b, c}) list.corners.push_back(corner);
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  };
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x, b = a + 1, c = b + n + 1, d = a + n + 1;
      if (aside > 0 && random() % 2 == 0) {
        triangle(a, b, d);
        triangle(b, c, d);
      } else {
        triangle(a, b, c);
        triangle(a, c, d);
      }
    }
  return from_indexed(std::move(list));
}

// The largest of both curvatures at the vertices of a sort, and the root of the mean square.
struct Error {
  double most = 0, squares = 0, count = 0;

  void add(double error) {
    most = std::max(most, std::abs(error));
    squares += error * error;
    ++count;
  }
  double usual() const { return std::sqrt(squares / count); }
};
struct Errors {
  Error inside, boundary;  // the latter of what lies within an edge of it
};

Errors errors_of(const Mesh& mesh, const Formula& truth) {
  Errors errors;
  Neighbourhood around(mesh, Neighbourhood::Reach::whole);
  for (Vertex v(0); v.index < mesh.vertex_slots(); ++v.index) {
    bool is_near = mesh.is_boundary(v);
    for (const Vertex w : neighbours(mesh, v)) is_near |= mesh.is_boundary(w);
    const Curvature found = curvature_at(around, v);
    const Truth wanted = truth(mesh.position(v));
    for (const double error : {found.smallest - wanted.smallest, found.largest - wanted.largest}) {
      EXPECT_TRUE(std::isfinite(error)) << v.index;
      (is_near ? errors.boundary : errors.inside).add(error);
    }
  }
  return errors;
}

struct Family {
  const char* name;
  Place place;
  Formula truth;
};

std::vector<Family> families() {
  constexpr double turn = 2 * std::numbers::pi;
  return {{"sphere",
           [](double u, double v) {
             const double a = 0.3 + u, b = 0.2 + 1.2 * v;
             return 2.0 * glm::dvec3(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
           },
           [](const glm::dvec3&) {
             return Truth{0.5, 0.5};
           }},
          {"cylinder", [](double u, double v) { return glm::dvec3(0.5 * std::cos(u), 0.5 * std::sin(u), v); },
           [](const glm::dvec3&) {
             return Truth{0, 2};
           }},
          {"torus",
           [](double u, double v) {
             const double a = turn * u / 4, b = turn * (v / 2 - 0.2), r = 2 + 0.8 * std::cos(b);
             return glm::dvec3(r * std::cos(a), r * std::sin(a), 0.8 * std::sin(b));
           },
           [](const glm::dvec3& p) {
             const double r = std::hypot(p.x, p.y), along = (r - 2) / 0.8 / r;
             return Truth{along, 1 / 0.8};
           }},
          {"saddle",
           [](double u, double v) {
             const double x = 2 * u - 1, y = 2 * v - 1;
             return glm::dvec3(x, y, 0.6 * x * y + 0.2 * x * x * x);
           },
           [](const glm::dvec3& p) {
             const double fx = 0.6 * p.y + 0.6 * p.x * p.x, fy = 0.6 * p.x, fxx = 1.2 * p.x, fxy = 0.6;
             const double w = 1 + fx * fx + fy * fy;
             const double mean = -((1 + fy * fy) * fxx - 2 * fx * fy * fxy) / (2 * w * std::sqrt(w));
             const double gaussian = -fxy * fxy / (w * w), apart = std::sqrt(mean * mean - gaussian);
             return Truth{mean - apart, mean + apart};
           }}};
}

// By which power of the spacing an error falls from one mesh to a finer one.
double order(const Error& coarse, const Error& fine, double finer) {
  return std::log(coarse.usual() / fine.usual()) / std::log(finer);
}

TEST(Curvature, inside_the_error_falls_with_the_square_of_the_spacing_whatever_the_triangles) {
  for (const Family& family : families())
    for (const double aside : {0.0, 0.3}) {
      const Errors coarse = errors_of(patch(16, aside, family.place), family.truth),
                   fine = errors_of(patch(64, aside, family.place), family.truth);
      const double inside = order(coarse.inside, fine.inside, 4), boundary = order(coarse.boundary, fine.boundary, 4);
      EXPECT_GT(inside, 1.8) << family.name << " " << aside;
      EXPECT_LT(fine.inside.most, 0.01) << family.name << " " << aside;
      EXPECT_GT(boundary, 0.9) << family.name << " " << aside;
      EXPECT_LT(fine.boundary.most, 0.15) << family.name << " " << aside;
    }
}

TEST(Curvature, of_a_sphere_of_icosahedra_is_that_of_the_sphere) {
  std::optional<Error> before;
  for (const char* steps : {"2", "3", "4"}) {
    Mesh mesh = made_by("icosahedron radius=1");
    Journal journal;
    run_algorithm(mesh, journal, std::string("subdivide scheme=midpoint steps=") + steps);
    MeshColumns columns = mesh.columns();
    for (glm::dvec3& p : columns.positions) p = 3.0 * glm::normalize(p);
    const Errors errors = errors_of(Mesh(std::move(columns)), [](const glm::dvec3&) {
      return Truth{1.0 / 3, 1.0 / 3};
    });
    if (before) {
      EXPECT_GT(order(*before, errors.inside, 2), 1.8) << steps;
    }
    before = errors.inside;
    EXPECT_LT(before->most, 1e-3) << steps;
  }
  EXPECT_LT(before->most, 1e-5);
}

TEST(Curvature, of_a_coarse_torus_is_nearly_that_of_the_torus) {
  const Mesh mesh = made_by("torus radius=1 tube=0.4 segments=16 tube_segments=8");
  Neighbourhood around(mesh);
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const glm::dvec3 p = mesh.position(Vertex(i));
    const double from_axis = std::hypot(p.x, p.z), outwards = (from_axis - 1) / 0.4;
    const Curvature found = curvature_at(around, Vertex(i));
    EXPECT_NEAR(found.largest, 1 / 0.4, 0.06) << i;
    EXPECT_NEAR(found.smallest, outwards / from_axis, 0.2) << i;
  }
}

Curvature at(const Mesh& mesh, Vertex v) {
  Neighbourhood around(mesh);
  return curvature_at(around, v);
}

TEST(Curvature, turns_with_the_faces_and_shrinks_as_the_mesh_grows) {
  const Mesh mesh = patch(6, 0.3, families()[3].place);
  const Vertex v(24);
  const Curvature found = at(mesh, v);
  MeshColumns columns = mesh.columns();
  for (glm::dvec3& p : columns.positions) p *= 0x1p600;
  const Curvature large = at(Mesh(columns), v);
  EXPECT_EQ(large.smallest * 0x1p600, found.smallest);
  EXPECT_EQ(large.largest * 0x1p600, found.largest);
  IndexedMesh turned;
  turned.positions.assign(mesh.positions().begin(), mesh.positions().end());
  for (const auto& corners : polygons_of(mesh)) {
    turned.corners.insert(turned.corners.end(), corners.rbegin(), corners.rend());
    turned.face_offsets.push_back(static_cast<std::uint32_t>(turned.corners.size()));
  }
  const Curvature other = at(from_indexed(std::move(turned)), v);
  EXPECT_NEAR(other.smallest, -found.largest, 1e-9);
  EXPECT_NEAR(other.largest, -found.smallest, 1e-9);
}

TEST(Curvature, there_is_none_where_there_is_no_one_surface) {
  const auto is_none = [](const Polygons& faces, std::uint32_t v) {
    return std::isnan(at(make_mesh(faces), Vertex(v)).mean());
  };
  EXPECT_TRUE(is_none({{0, 1, 2}}, 0)) << "two points do not tell";
  EXPECT_TRUE(is_none(fin(), 0)) << "three sheets";
  EXPECT_TRUE(is_none(two_tetrahedra_on_an_edge(), 0));
  for (std::uint32_t v = 0; v < 4; ++v) EXPECT_FALSE(is_none(tetrahedron(), v));
  Mesh flat = patch(4, 0, [](double u, double v) { return glm::dvec3(u, v, 3); });
  EXPECT_EQ(at(flat, Vertex(12)).mean(), 0);
  MeshColumns columns = flat.columns();
  columns.positions[13].z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(at(Mesh(columns), Vertex(12)).mean()));
  EXPECT_TRUE(std::isnan(at(Mesh(columns), Vertex(11)).mean())) << "two edges away";
  EXPECT_FALSE(std::isnan(at(Mesh(columns), Vertex(0)).mean()));
}

TEST(Curvature, a_fan_of_many_triangles_takes_no_longer_than_its_edges) {
  const std::uint32_t n = 20000;
  const Mesh mesh = make_mesh(closed_fan(n));
  Neighbourhood around(mesh, Neighbourhood::Reach::whole);
  std::size_t finite = 0;
  for (Vertex v(0); v.index < mesh.vertex_slots(); ++v.index) finite += std::isfinite(curvature_at(around, v).mean());
  EXPECT_GT(finite, n / 2) << "in milliseconds; minutes where every spoke looks at all others";
}

}  // namespace
}  // namespace ryosen::test
