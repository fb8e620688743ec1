// Subdivision against closed forms, counts, an oracle on polygon lists, and its own laws.
#include "ryosen/algo/subdivide/subdivide.h"
#include "ryosen/algo/algorithm_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <map>
#include <numbers>
#include <random>

#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/mesh_kind.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/triangulate.h"
#include "tests/support/core/element_values.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_edits.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {
namespace {

using subdivide::Scheme;

constexpr std::array all_schemes{Scheme::loop, Scheme::catmull_clark, Scheme::midpoint, Scheme::sqrt3};

Mesh made(const Mesh& mesh, const subdivide::Options& options) {
  Progress unheard;
  subdivide::Subdivided result = subdivide::subdivided(mesh, options, unheard);
  EXPECT_FALSE(result.fault) << result.fault->en;
  Mesh finer(std::move(result.columns));
  const auto broken = check_invariants(finer);
  EXPECT_FALSE(broken) << broken->sentence;
  return finer;
}

Mesh with_places(const Polygons& faces, const std::vector<glm::dvec3>& places) {
  IndexedMesh list = indexed(faces, places.size());
  list.positions = places;
  return from_indexed(list);
}

// Random places on the polygons, so that nothing is symmetric.
Mesh shaken(const Polygons& faces, std::size_t points = 0) {
  IndexedMesh list = indexed(faces, points);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1, 1);
  for (glm::dvec3& p : list.positions) p = {place(random), place(random), place(random)};
  return from_indexed(list);
}

// Rows of squares, or of two triangles each, over the plane, lifted by a function.
template <class Height>
Mesh sheet(std::uint32_t n, bool triangles, const Height& height) {
  Polygons faces;
  std::vector<glm::dvec3> places;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) {
      places.emplace_back(x, y, height(double(x), double(y)));
      if (x == n || y == n) continue;
      const std::uint32_t a = y * (n + 1) + x, b = a + 1, c = b + n + 1, d = a + n + 1;
      if (!triangles) faces.push_back({a, b, c, d});
      if (triangles) faces.insert(faces.end(), {{a, b, c}, {a, c, d}});
    }
  return with_places(faces, places);
}

double distance(const Mesh& a, const Mesh& b, std::uint32_t vertices) {
  double most = 0;
  for (std::uint32_t i = 0; i < vertices; ++i)
    most = std::max(most, glm::distance(a.position(Vertex(i)), b.position(Vertex(i))));
  return most;
}

struct NamedPolygons {
  const char* name;
  Polygons faces;
  std::size_t points = 0;
};

std::vector<NamedPolygons> shapes() {
  return {{"tetrahedron", tetrahedron()},
          {"cube", cube()},
          {"torus", torus_grid(3, 4)},
          {"quads", two_quads()},
          {"fan", closed_fan(7)},
          {"triangle", {{0, 1, 2}}},
          {"pentagon", {{0, 1, 2, 3, 4}}},
          {"strip", {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}},
          {"bow tie", bow_tie()},
          {"fin", fin()},
          {"moebius", moebius_strip()},
          {"two tetrahedra", two_tetrahedra_on_an_edge()},
          {"isolated", {{0, 1, 2}}, 5},
          {"twice", {{0, 1, 2}, {0, 1, 2}}},
          {"quads twice", {{0, 1, 2, 3}, {0, 1, 2, 3}}}};
}

TEST(Subdivide, counts_per_step_are_exact_and_every_mesh_is_whole) {
  for (const NamedPolygons& shape : shapes())
    for (const Scheme scheme : all_schemes) {
      SCOPED_TRACE(std::string(shape.name) + " " + std::to_string(int(scheme)));
      Mesh mesh = shaken(shape.faces, shape.points);
      if (std::string_view(shape.name).find("twice") != std::string_view::npos)
        continue;  // inner edges lie on each other
      if (scheme == Scheme::loop || scheme == Scheme::sqrt3)
        mesh = made(mesh, {.scheme = Scheme::loop});  // all triangles, opened where it has to be
      else
        mesh = made(mesh, {.scheme = Scheme::midpoint});
      for (int step = 0; step < 2; ++step) {
        const ElementCounts before = mesh.live();
        std::uint32_t corners = 0, quads = 0;
        for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) corners += corner_count(mesh, Face(f));
        for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) quads += corner_count(mesh, Face(f)) == 4;
        mesh = made(mesh, {.scheme = scheme});
        const ElementCounts after = mesh.live();
        if (scheme == Scheme::loop || (scheme == Scheme::midpoint && quads == 0)) {
          EXPECT_EQ(after,
                    (ElementCounts{before.vertices + before.edges, 2 * before.edges + corners, 4 * before.faces}));
        } else if (scheme == Scheme::sqrt3) {
          EXPECT_EQ(after, (ElementCounts{before.vertices + before.faces, before.edges + corners, corners}));
        } else {
          EXPECT_EQ(after, (ElementCounts{before.vertices + before.edges + before.faces, 2 * before.edges + corners,
                                          corners}));
        }
      }
    }
}

// Two steps of sqrt(3) cut a triangle into nine, and each boundary edge into three.
TEST(Subdivide, two_steps_of_sqrt3_make_nine_of_a_triangle) {
  for (const Polygons& faces : {Polygons{{0, 1, 2}}, closed_fan(6), Polygons{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}}) {
    const Mesh mesh = shaken(faces);
    const Mesh finer = made(mesh, {.scheme = Scheme::sqrt3, .steps = 2});
    EXPECT_EQ(finer.live().faces, 9 * mesh.live().faces);
    const Figures before = compute_figures(mesh), after = compute_figures(finer);
    EXPECT_EQ(after[ProblemKind::boundary_loop], 3 * before[ProblemKind::boundary_loop]);
    EXPECT_EQ(after.euler_characteristic, before.euler_characteristic);
  }
}

TEST(Subdivide, the_limit_of_a_vertex_is_the_same_from_every_level) {
  for (const NamedPolygons& shape : shapes())
    for (const Scheme scheme : all_schemes)
      for (const bool has_creases : {false, true}) {
        SCOPED_TRACE(std::string(shape.name) + " " + std::to_string(int(scheme)) + (has_creases ? " creased" : ""));
        const Mesh mesh = shaken(shape.faces, shape.points);
        subdivide::Options options{.scheme = scheme, .steps = 2, .to_limit = true};
        if (has_creases) options.crease_angle_rad = 1.2;
        const Mesh once = made(mesh, options);
        options.steps = 4;
        const Mesh again = made(mesh, options);
        EXPECT_LT(distance(once, again, once.vertex_slots()), 1e-12);
      }
}

// A sheet with a bump, and on it a crease that begins and ends within.
subdivide::Options with_darts(const Mesh& mesh, Scheme scheme) {
  const auto edge_between = [&](std::uint32_t a, std::uint32_t b) {
    return Element(edge(find_halfedge(mesh, Vertex(a), Vertex(b))));
  };
  return {.scheme = scheme, .sharp = {edge_between(14, 15), edge_between(15, 16)}};
}
Mesh bumpy_sheet(bool triangles) {
  return sheet(5, triangles,
               [](double x, double y) { return std::sin(1.3 * x + 0.4) * std::cos(0.9 * y) + 0.2 * x * y; });
}

TEST(Subdivide, the_limit_of_a_dart_is_the_same_from_every_level) {
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark}) {
    const Mesh mesh = bumpy_sheet(scheme == Scheme::loop);
    subdivide::Options options = with_darts(mesh, scheme);
    options.to_limit = true;
    const Mesh once = made(mesh, options);
    options.steps = 4;
    EXPECT_LT(distance(once, made(mesh, options), once.vertex_slots()), 1e-13);
    subdivide::Options far = with_darts(mesh, scheme);
    far.steps = 7;
    EXPECT_LT(glm::distance(made(mesh, far).position(Vertex(14)), once.position(Vertex(14))), 1e-4)
        << "a step towards it";
  }
}

// The normals of the corners of a vertex: what the attribute says, or those of the faces.
std::vector<glm::dvec3> normals_at(const Mesh& mesh, Vertex v, bool of_faces) {
  std::vector<glm::dvec3> found;
  const int index = mesh.find_attribute(attribute_names::normal),
            pool = mesh.find_attribute(attribute_names::normal_pool);
  for (const Halfedge h : outgoing(mesh, v)) {
    if (mesh.is_outside(h)) continue;
    if (of_faces) {
      const glm::dvec3 &a = mesh.position(v), &b = mesh.position(mesh.to(h)),
                       &c = mesh.position(mesh.from(mesh.prev(h)));
      found.push_back(glm::normalize(glm::cross(b - a, c - a)));
      continue;
    }
    const auto place = mesh.attributes()[static_cast<std::size_t>(index)].data[h.index];
    if (place != no_index)
      found.push_back(attribute_value<glm::dvec3>(mesh.attributes()[static_cast<std::size_t>(pool)], place));
  }
  return found;
}

// How far each of some directions is from the nearest of others.
double apart(const std::vector<glm::dvec3>& some, const std::vector<glm::dvec3>& others) {
  double most = 0;
  for (const glm::dvec3& one : some) {
    double least = 2;
    for (const glm::dvec3& other : others) least = std::min(least, glm::distance(one, other));
    most = std::max(most, least);
  }
  return most;
}

TEST(Subdivide, limit_normals_are_those_of_the_faces_of_ever_finer_levels) {
  const auto expect_normals = [](const Mesh& mesh, subdivide::Options options, const char* name) {
    SCOPED_TRACE(std::string(name) + " " + std::to_string(int(options.scheme)));
    options.to_limit = true;
    const Mesh here = made(mesh, options);
    subdivide::Options finer = options;
    std::array<double, 2> errors{};
    for (const std::size_t more : {2u, 4u}) {
      finer.steps = options.steps + more;
      const Mesh fine = made(mesh, finer);
      for (Vertex v(0); v.index < here.vertex_slots(); ++v.index) {
        const auto of_limit = normals_at(here, v, false), of_faces = normals_at(fine, v, true);
        ASSERT_EQ(of_limit.empty(), of_faces.empty()) << v.index;
        double& error = errors[more == 2 ? 0 : 1];
        error = std::max({error, apart(of_limit, of_faces), apart(of_faces, of_limit)});
      }
    }
    EXPECT_LT(errors[1], 0.15);
    EXPECT_LT(errors[1], 0.55 * errors[0] + 1e-9) << "a quarter of the spacing";
  };
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark, Scheme::sqrt3}) {
    const bool triangles = scheme != Scheme::catmull_clark;
    expect_normals(made_by(triangles ? "tetrahedron" : "cube"), {.scheme = scheme, .steps = 2}, "closed");
    if (is_long_run()) expect_normals(made_by("icosahedron"), {.scheme = scheme, .steps = 2}, "valence 5");
    if (scheme == Scheme::sqrt3) continue;  // its boundaries have no masks of their own
    expect_normals(bumpy_sheet(triangles), {.scheme = scheme, .steps = 2}, "sheet");
    expect_normals(made_by("cube"), {.scheme = scheme, .steps = 2, .crease_angle_rad = 1.2}, "corners");
    const Mesh mesh = bumpy_sheet(triangles);
    subdivide::Options options = with_darts(mesh, scheme);
    options.steps = 2;
    expect_normals(mesh, options, "darts");
  }
}

TEST(Subdivide, limit_normals_of_a_plane_are_its_own_and_copies_of_a_smooth_vertex_share_them) {
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark, Scheme::sqrt3}) {
    const Mesh made_flat = made(sheet(3, scheme != Scheme::catmull_clark, [](double x, double y) { return x - 2 * y; }),
                                {.scheme = scheme, .steps = 2, .to_limit = true});
    for (Vertex v(0); v.index < made_flat.vertex_slots(); ++v.index)
      for (const glm::dvec3& normal : normals_at(made_flat, v, false))
        EXPECT_LT(glm::distance(normal, glm::normalize(glm::dvec3(-1, 2, 1))), 1e-12);
    const int pool = made_flat.find_attribute(attribute_names::normal_pool);
    EXPECT_EQ(made_flat.attributes()[static_cast<std::size_t>(pool)].data.size(), 6 * made_flat.live().vertices);
  }
}

// Cubic splines over a square grid, and box splines over a triangular one, of a quadratic are that quadratic and a
// constant more: 1/3 of each square of the first, and by the mask of the other (1/12 six times).
TEST(Subdivide, regular_sheets_tend_to_their_splines) {
  const auto height = [](double x, double y) { return 0.3 * x * x - 0.2 * x * y + 0.1 * y * y + x - 2; };
  constexpr std::uint32_t n = 8;
  for (const bool triangles : {false, true}) {
    const Mesh mesh = sheet(n, triangles, height);
    const Scheme scheme = triangles ? Scheme::loop : Scheme::catmull_clark;
    const Mesh finer = made(mesh, {.scheme = scheme, .steps = 3, .to_limit = true});
    // Of the six neighbours, in both directions: (1 0) (1 1) (0 1).
    const double more = triangles ? 2 * (0.3 + (0.3 - 0.2 + 0.1) + 0.1) / 12 : (0.3 + 0.1) / 3;
    std::uint32_t inside = 0;
    for (std::uint32_t i = 0; i < finer.vertex_slots(); ++i) {
      const glm::dvec3& p = finer.position(Vertex(i));
      if (p.x < 2 || p.x > n - 2 || p.y < 2 || p.y > n - 2) continue;
      EXPECT_NEAR(p.z, height(p.x, p.y) + more, 1e-12);
      ++inside;
    }
    EXPECT_GT(inside, 1000u);
  }
}

TEST(Subdivide, boundaries_tend_to_cubic_splines_whatever_lies_inside) {
  const std::uint32_t n = 7;
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark, Scheme::sqrt3}) {
    const Mesh mesh = shaken(closed_fan(n));
    const Mesh finer = made(mesh, {.scheme = scheme, .steps = 4, .to_limit = true});
    const std::uint32_t parts = scheme == Scheme::sqrt3 ? 9 : 16;
    // From the vertex 1 along the boundary, both ways round.
    Halfedge h = finer.halfedge(Vertex(1));
    ASSERT_TRUE(finer.is_outside(h));
    const std::uint32_t second = mesh.to(mesh.halfedge(Vertex(1))).index;
    const bool is_forward = second == 2;
    const auto control = [&](std::uint32_t k) {
      const std::uint32_t ring = k % n;
      return mesh.position(Vertex(1 + (is_forward ? ring : (n - ring) % n)));
    };
    std::uint32_t steps = 0;
    for (const Halfedge step : loop(finer, h)) {
      const std::uint32_t k = n + steps / parts;
      const double t = double(steps % parts) / parts, s = 1 - t;
      const glm::dvec3 spline = (s * s * s * control(k - 1) + (3 * t * t * t - 6 * t * t + 4) * control(k) +
                                 (3 * s * s * s - 6 * s * s + 4) * control(k + 1) + t * t * t * control(k + 2)) /
                                6.0;
      EXPECT_LT(glm::distance(spline, finer.position(finer.from(step))), 1e-12) << int(scheme) << " " << steps;
      ++steps;
    }
    EXPECT_EQ(steps, n * parts);
  }
}

TEST(Subdivide, an_affine_map_may_come_before_or_behind) {
  const glm::dmat3 turn(0.3, -1.2, 0.5, 2, 0.1, -0.7, 0.4, 0.9, 1.5);
  const auto map = [&](const glm::dvec3& p) { return turn * p + glm::dvec3(3, -5, 7); };
  for (const NamedPolygons& shape : shapes())
    for (const Scheme scheme : all_schemes) {
      // Which way a bent polygon is cut into triangles depends on how it lies.
      const bool all_triangles =
          std::all_of(shape.faces.begin(), shape.faces.end(), [](const auto& f) { return f.size() == 3; });
      if (!all_triangles && (scheme == Scheme::loop || scheme == Scheme::sqrt3)) continue;
      const Mesh mesh = shaken(shape.faces, shape.points);
      MeshColumns moved = mesh.columns();
      for (glm::dvec3& p : moved.positions) p = map(p);
      const subdivide::Options options{.scheme = scheme, .steps = 2, .sharp = {Edge(0)}, .sharp_steps = 1.5};
      const Mesh behind = made(mesh, options), before = made(Mesh(moved), options);
      for (std::uint32_t i = 0; i < behind.vertex_slots(); ++i)
        EXPECT_LT(glm::distance(map(behind.position(Vertex(i))), before.position(Vertex(i))), 1e-12) << shape.name;
    }
}

// A step of Loop's or Catmull's and Clark's scheme on a closed polygon list, by looking everything up.
std::vector<glm::dvec3> places_by_lookup(const IndexedMesh& list, Scheme scheme) {
  const bool is_loop = scheme == Scheme::loop;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> faces_of_edge;
  std::map<std::uint32_t, std::vector<std::size_t>> faces_of_vertex;
  std::vector<glm::dvec3> centres;
  for (std::size_t f = 0; f < list.face_count(); ++f) {
    const auto corners = list.face(f);
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      sum += list.positions[corners[i]];
      faces_of_edge[std::minmax(corners[i], corners[(i + 1) % corners.size()])].push_back(f);
      faces_of_vertex[corners[i]].push_back(f);
    }
    centres.push_back(sum / double(corners.size()));
  }
  std::vector<glm::dvec3> places;
  std::map<std::uint32_t, glm::dvec3> neighbour_sum;
  for (const auto& [ends, faces] : faces_of_edge) {
    const glm::dvec3 a = list.positions[ends.first], b = list.positions[ends.second];
    neighbour_sum[ends.first] += b;
    neighbour_sum[ends.second] += a;
    if (is_loop)  // (3 a + 3 b + c + d) / 8, and c is three times the centre without a and b
      places.push_back((3.0 * (a + b) + 3.0 * (centres[faces[0]] + centres[faces[1]]) - 2.0 * (a + b)) / 8.0);
    else
      places.push_back((a + b + centres[faces[0]] + centres[faces[1]]) / 4.0);
  }
  for (const auto& [v, faces] : faces_of_vertex) {
    const double n = double(faces.size());
    const glm::dvec3 p = list.positions[v];
    if (is_loop) {
      const double c = 3.0 / 8 + std::cos(2 * std::numbers::pi / n) / 4, beta = (5.0 / 8 - c * c) / n;
      places.push_back(p * (1 - n * beta) + beta * neighbour_sum[v]);
    } else {
      glm::dvec3 q(0);
      for (const std::size_t f : faces) q += centres[f] / n;
      const glm::dvec3 r = (p + neighbour_sum[v] / n) / 2.0;
      places.push_back((q + 2.0 * r + (n - 3) * p) / n);
    }
  }
  if (!is_loop) places.insert(places.end(), centres.begin(), centres.end());
  return places;
}

// Whether both are the same places, each at most a rounding apart; by sorting them along a direction.
double farthest_apart(std::vector<glm::dvec3> a, std::vector<glm::dvec3> b) {
  if (a.size() != b.size()) return 1e9;
  const auto along = [](const glm::dvec3& p) { return p.x + 0.73 * p.y + 0.41 * p.z; };
  const auto before = [&](const glm::dvec3& p, const glm::dvec3& q) { return along(p) < along(q); };
  std::sort(a.begin(), a.end(), before);
  std::sort(b.begin(), b.end(), before);
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, glm::distance(a[i], b[i]));
  return most;
}

TEST(Subdivide, large_closed_meshes_equal_an_oracle_on_their_list) {
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark}) {
    if (scheme == Scheme::loop && !is_long_run()) continue;
    IndexedMesh list = indexed(torus_grid(150, 200));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-1, 1);
    for (glm::dvec3& p : list.positions) p = {place(random), place(random), place(random)};
    const Mesh mesh = from_indexed(list);
    ASSERT_GT(mesh.edge_slots(), 50000u);
    const Mesh finer = made(mesh, {.scheme = scheme});
    const std::vector<glm::dvec3> places(finer.positions().begin(), finer.positions().end());
    EXPECT_LT(farthest_apart(places, places_by_lookup(list, scheme)), 1e-13);
  }
}

TEST(Subdivide, creases_stay_flat_and_corners_stay) {
  const Mesh mesh = made_by("cube");
  for (const Scheme scheme : all_schemes) {
    const Mesh sharp = made(mesh, {.scheme = scheme, .steps = 4, .crease_angle_rad = 1.0});
    const Figures figures = compute_figures(sharp);
    EXPECT_NEAR(figures.area, 24, 1e-12);
    EXPECT_NEAR(*figures.volume, 8, 1e-12);
    for (std::uint32_t i = 0; i < 8; ++i) EXPECT_EQ(sharp.position(Vertex(i)), mesh.position(Vertex(i)));
  }
}

TEST(Subdivide, semi_sharp_edges_lie_between_smooth_and_sharp_ones) {
  const Mesh mesh = made_by("cube");
  double before = 0;
  for (const double steps : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0}) {
    const Mesh some =
        made(mesh, {.scheme = Scheme::catmull_clark, .steps = 4, .crease_angle_rad = 1.0, .sharp_steps = steps});
    const double volume = *compute_figures(some).volume;
    EXPECT_GT(volume, before) << steps;
    before = volume;
  }
  EXPECT_LT(before, 8);
  // Two steps sharp and two smooth are the same as doing them one after the other.
  const Mesh once =
      made(mesh, {.scheme = Scheme::catmull_clark, .steps = 4, .crease_angle_rad = 1.0, .sharp_steps = 2});
  const Mesh first = made(mesh, {.scheme = Scheme::catmull_clark, .steps = 2, .crease_angle_rad = 1.0});
  const Mesh then = made(first, {.scheme = Scheme::catmull_clark, .steps = 2});
  EXPECT_EQ(once.columns(), then.columns());
}

TEST(Subdivide, copies_stay_together_and_reading_the_points_gives_the_same) {
  for (const NamedPolygons& shape : shapes())
    for (const Scheme scheme : all_schemes) {
      SCOPED_TRACE(std::string(shape.name) + " " + std::to_string(int(scheme)));
      const Mesh mesh = shaken(shape.faces, shape.points);
      const Mesh finer = made(mesh, {.scheme = scheme, .steps = 2});
      const Figures before = compute_figures(mesh), after = compute_figures(finer),
                    read = compute_figures(from_indexed(to_indexed(finer).mesh));
      EXPECT_EQ(after, read);
      const std::uint64_t parts = scheme == Scheme::sqrt3 ? 3 : 4;
      if (std::string_view(shape.name).find("twice") != std::string_view::npos) continue;
      for (const ProblemKind kind :
           {ProblemKind::nonmanifold_edge, ProblemKind::misoriented_edge, ProblemKind::boundary_loop})
        EXPECT_EQ(after[kind], parts * before[kind]);
      EXPECT_EQ(after.components, before.components);
      EXPECT_EQ(after.euler_characteristic, before.euler_characteristic);
      for (std::uint32_t i = 0; i < mesh.file_vertices(); ++i) {
        if (!has_copies(mesh, Vertex(i))) continue;
        EXPECT_EQ(finer.position(Vertex(i)), mesh.position(Vertex(i)));
      }
    }
}

// Places as texture coordinates, on a sheet whose halves have pools of their own.
TEST(Subdivide, copies_and_sheets_have_one_value) {
  std::vector<Mesh> meshes;
  for (const NamedPolygons& shape : shapes()) meshes.push_back(shaken(shape.faces, shape.points));
  for (std::uint64_t seed = 1; seed <= 40; ++seed) meshes.push_back(random_kernel_mesh(seed));
  for (Mesh& mesh : meshes) {
    add_values(mesh, nullptr);
    for (const Scheme scheme : all_schemes)
      for (const std::size_t steps : {1u, 2u}) {
        Progress unheard;
        const subdivide::Subdivided result = subdivide::subdivided(mesh, {.scheme = scheme, .steps = steps}, unheard);
        if (!result.fault) expect_copies_agree(Mesh(result.columns));
      }
  }
}

TEST(Subdivide, texture_colours_and_names_are_carried_along) {
  IndexedMesh list = indexed({{0, 1, 4, 3}, {1, 2, 5, 4}});
  list.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  list.texcoords.pool = list.positions;
  for (const glm::dvec3& p : list.positions) list.texcoords.pool.push_back(p + glm::dvec3(10, 0, 0));
  list.texcoords.index = {0, 1, 4, 3, 7, 8, 11, 10};
  for (const glm::dvec3& p : list.positions) list.vertex_colours.emplace_back(p, 1);
  list.materials.names = {"a", "b"};
  list.materials.index = {0, 1};
  const Mesh mesh = from_indexed(list);
  for (const Scheme scheme : all_schemes) {
    subdivide::Options options{.scheme = scheme, .steps = 2};
    // All stays where it is, so that linear values are still the places.
    for (std::uint32_t i = 0; i < 6; ++i) options.sharp.emplace_back(Vertex(i));
    const Mesh finer = made(mesh, options);
    const IndexedMesh out = to_indexed(finer, file_tables(list)).mesh;
    ASSERT_EQ(out.texcoords.index.size(), out.corners.size());
    std::size_t of_b = 0;
    for (std::size_t f = 0; f < out.face_count(); ++f) {
      const std::uint32_t material = out.materials.index[f];
      of_b += material;
      for (std::uint32_t c = out.face_offsets[f]; c < out.face_offsets[f + 1]; ++c) {
        const glm::dvec3 p = out.positions[out.corners[c]], uv = out.texcoords.pool[out.texcoords.index[c]];
        EXPECT_LT(glm::distance(uv - glm::dvec3(10.0 * material, 0, 0), p), scheme == Scheme::midpoint ? 1e-14 : 0.4);
        EXPECT_GE(uv.x, 10.0 * material + material - 1e-12) << "within its own half";
        EXPECT_LE(uv.x, 10.0 * material + material + 1 + 1e-12);
      }
    }
    EXPECT_EQ(2 * of_b, out.face_count());
    for (std::size_t v = 0; v < out.positions.size() && scheme == Scheme::midpoint; ++v)
      EXPECT_LT(glm::distance(glm::dvec3(out.vertex_colours[v]), out.positions[v]), 1e-14);
  }
}

// Texture coordinates and colours that are the places stay so, whatever a mask does to an irregular sheet; a slit in it
// ends in a vertex with one value.
TEST(Subdivide, values_stay_where_they_are_on_the_surface) {
  constexpr std::uint32_t side = 6;
  Dice dice(5);
  IndexedMesh list;
  for (std::uint32_t i = 0; i < (side + 1) * (side + 1); ++i) {
    const std::uint32_t column = i % (side + 1), row = i / (side + 1);
    list.positions.emplace_back(column + 0.4 * dice.unit(), row + 0.4 * dice.unit(), 0);
  }
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const std::uint32_t a = i / side * (side + 1) + i % side, c = a + side + 2;
    if (i % 3 == 0) {
      list.corners.insert(list.corners.end(), {a, a + 1, c, c - 1});
      list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
      continue;
    }
    list.corners.insert(list.corners.end(), {a, a + 1, c, a, c, c - 1});
    for (const std::size_t end : {list.corners.size() - 3, list.corners.size()})
      list.face_offsets.push_back(static_cast<std::uint32_t>(end));
  }
  list.texcoords.pool = list.positions;
  list.texcoords.index = list.corners;
  for (const glm::dvec3& p : list.positions) list.vertex_colours.emplace_back(p, 0.3);
  for (const Scheme scheme : all_schemes)
    for (const bool to_limit : {false, true}) {
      const subdivide::Options options{.scheme = scheme, .steps = 2, .to_limit = to_limit};
      const IndexedMesh out = to_indexed(made(from_indexed(list), options), file_tables(list)).mesh;
      ASSERT_EQ(out.texcoords.index.size(), out.corners.size());
      for (std::size_t c = 0; c < out.corners.size(); ++c)
        EXPECT_LT(glm::distance(out.texcoords.pool[out.texcoords.index[c]], out.positions[out.corners[c]]), 1e-13);
      for (std::size_t v = 0; v < out.positions.size(); ++v) {
        EXPECT_LT(glm::distance(glm::dvec3(out.vertex_colours[v]), out.positions[v]), 1e-13);
        EXPECT_EQ(out.vertex_colours[v].w, 0.3) << "equal values stay to the bit";
      }
    }
}

// Places as five doubles and as a float; sums of faces by their areas and of edges; what points have of sums stays with
// them.
TEST(Subdivide, values_of_all_types_go_by_their_rules) {
  for (const Scheme scheme : all_schemes)
    for (const bool to_limit : {false, true}) {
      Mesh mesh = shaken(torus_grid(5, 4));
      if (scheme == Scheme::loop || scheme == Scheme::sqrt3) {
        Edit edit(mesh, nullptr);
        Triangulate{}.apply(edit);
        edit.commit();
      }
      Edit edit(mesh, nullptr);
      const std::size_t five =
                            edit.add_attribute("five", ElementKind::vertex, ValueRule::blend, std::array<double, 5>{}),
                        one = edit.add_attribute("one", ElementKind::vertex, ValueRule::blend, 0.0f),
                        mass = edit.add_attribute("mass", ElementKind::vertex, ValueRule::sum, 7),
                        count = edit.add_attribute("count", ElementKind::face, ValueRule::sum, std::int64_t{0}),
                        length = edit.add_attribute("length", ElementKind::edge, ValueRule::sum, 0.0);
      for (const Vertex v : live_vertices(mesh)) {
        const glm::dvec3 p = mesh.position(v);
        edit.set_attribute(five, v.index, attribute_words(std::array{p.x, p.y, p.z, 0.3, p.y}));
        edit.set_attribute(one, v.index, attribute_words(static_cast<float>(p.x)));
      }
      for (const Face f : live_faces(mesh)) edit.set_attribute(count, f.index, attribute_words(std::int64_t{101}));
      for (const Edge e : live_edges(mesh)) edit.set_attribute(length, e.index, attribute_words(3.0));
      edit.commit();
      const Mesh finer = made(mesh, {.scheme = scheme, .steps = 2, .to_limit = to_limit});
      const auto column = [&](std::size_t k) -> const AttributeColumn& { return finer.attributes()[k]; };
      for (const Vertex v : live_vertices(finer)) {
        const auto values = attribute_value<std::array<double, 5>>(column(five), v.index);
        const glm::dvec3 p = finer.position(v);
        EXPECT_LT(glm::distance(glm::dvec3(values[0], values[1], values[2]), p), 1e-13);
        EXPECT_EQ(values[3], 0.3) << "equal values stay to the bit";
        EXPECT_EQ(values[4], values[1]);
        EXPECT_NEAR(attribute_value<float>(column(one), v.index), p.x, 1e-6);
        EXPECT_EQ(attribute_value<int>(column(mass), v.index), 7) << "the default of what lies between several";
      }
      std::int64_t counted = 0;
      for (const Face f : live_faces(finer)) counted += attribute_value<std::int64_t>(column(count), f.index);
      EXPECT_EQ(counted, 101 * std::int64_t{mesh.live().faces});
      double sum = 0;
      for (const Edge e : live_edges(finer)) sum += attribute_value<double>(column(length), e.index);
      if (scheme != Scheme::sqrt3) {
        EXPECT_NEAR(sum, 3.0 * mesh.live().edges, 1e-9);
      }
    }
}

// A chart is torn along one inner edge: its end has one value, which is that of its place; the other has two.
TEST(Subdivide, values_at_the_end_of_a_slit_are_those_of_the_place) {
  IndexedMesh list;
  for (std::uint32_t i = 0; i < 25; ++i) {
    const std::uint32_t column = i % 5, row = i / 5;
    list.positions.emplace_back(column + 0.1 * (i * 7 % 4), row + 0.1 * (i % 3), 0);
  }
  for (std::uint32_t i = 0; i < 16; ++i) {
    const std::uint32_t a = i / 4 * 5 + i % 4;
    list.corners.insert(list.corners.end(), {a, a + 1, a + 6, a, a + 6, a + 5});
    list.face_offsets.insert(list.face_offsets.end(), {6 * i + 3, 6 * i + 6});
  }
  list.texcoords.pool = list.positions;
  list.texcoords.index = list.corners;
  // From the left side to the middle, 12: those above it at 10 and 11 lie in another place of the texture.
  for (const std::uint32_t v : {10u, 11u}) {
    for (std::size_t c = 6 * 8; c < list.corners.size(); ++c)
      if (list.corners[c] == v) list.texcoords.index[c] = static_cast<std::uint32_t>(list.texcoords.pool.size());
    list.texcoords.pool.push_back(list.positions[v] + glm::dvec3(0, 0.2, 0));
  }
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark}) {
    const IndexedMesh out =
        to_indexed(made(from_indexed(list), {.scheme = scheme, .steps = 1}), file_tables(list)).mesh;
    // The mask at 12 has half a share of the one value of 11 and half of the other, which lies 0.2 further.
    for (std::size_t c = 0; c < out.corners.size(); ++c) {
      const glm::dvec3 off = out.texcoords.pool[out.texcoords.index[c]] - out.positions[out.corners[c]];
      if (out.corners[c] != 12) continue;
      EXPECT_LT(std::abs(off.x), 1e-14);
      EXPECT_GT(off.y, 0.001);
      EXPECT_LT(off.y, 0.02);
    }
  }
}

TEST(Subdivide, faces_with_rings_and_deleted_elements_are_taken_care_of) {
  Mesh mesh = made_by("cube");
  Journal journal;
  {
    Edit edit(mesh, &journal);
    ryosen::apply(edit, *parse_line(mesh, "delete f0").op);
    edit.commit();
  }
  {
    Edit edit(mesh, &journal);
    ryosen::apply(edit, *parse_line(mesh, "dissolve 4-5").op);
    edit.commit();
  }
  for (const Scheme scheme : all_schemes) {
    const Mesh finer = made(mesh, {.scheme = scheme, .steps = 2});
    EXPECT_EQ(compute_figures(finer).euler_characteristic, 1);
    EXPECT_FALSE(finer.is_alive(Face(0))) << "its number stays its own";
  }
  IndexedMesh ringed = indexed({{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}});
  ringed.positions = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};
  ringed.bridged = {0};
  for (const Scheme scheme : all_schemes) {
    Progress unheard;
    const subdivide::Subdivided cut = subdivide::subdivided(from_indexed(ringed), {.scheme = scheme}, unheard);
    EXPECT_EQ(cut.cut_faces, 1u);
    const Figures figures = compute_figures(Mesh(cut.columns));
    EXPECT_EQ(figures.boundary_loops, 2u);
    EXPECT_EQ(figures.rings, 0u);
  }
}

TEST(Subdivide, what_cannot_be_is_refused_with_a_sentence) {
  Mesh mesh = made_by("cube");
  const AlgorithmRow& row = *find_algorithm("subdivide");
  for (const char* words : {"steps=0", "steps=-1", "steps=nan", "steps=1e300", "steps=17", "sharp_steps=-1",
                            "crease_angle=181", "scheme=butterfly"}) {
    const std::string_view word = words;
    EXPECT_FALSE(read_values(row.parameters, std::span(&word, 1)).values) << words;
  }
  const auto fault = [&](const subdivide::Options& options) {
    Progress unheard;
    return subdivide::subdivided(mesh, options, unheard).fault;
  };
  EXPECT_NE(fault({.steps = 16})->en.find("at most"), std::string::npos);
  EXPECT_TRUE(fault({.steps = 1, .crease_angle_rad = 1.0, .sharp_steps = 2, .to_limit = true}));
  EXPECT_TRUE(fault({.scheme = Scheme::sqrt3, .crease_angle_rad = 1.0, .to_limit = true}));
  EXPECT_FALSE(fault({.scheme = Scheme::sqrt3, .to_limit = true}));
  const auto huge = [](double size) {
    IndexedMesh list = indexed(tetrahedron());
    list.positions = {{-size, -size, -size}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
    return from_indexed(list);
  };
  for (const Scheme scheme : all_schemes) {
    const Mesh finer = made(huge(1.7e308), {.scheme = scheme, .steps = 3});
    for (const glm::dvec3& p : finer.positions()) EXPECT_TRUE(std::isfinite(p.x + p.y * 0 + p.z * 0));
  }
  Mesh empty;
  Journal journal;
  EXPECT_TRUE(run_algorithm(empty, journal, "subdivide").refused);
}

TEST(Subdivide, as_an_algorithm_tells_what_it_did) {
  Mesh mesh = made_by("cube");
  Journal journal;
  const AlgorithmResult result = run_algorithm(mesh, journal, "subdivide scheme=loop steps=2");
  EXPECT_EQ(result.text.en, "6 faces became 192; 6 faces were cut into triangles first.");
  EXPECT_EQ(mesh.live().faces, 192u);
}

}  // namespace
}  // namespace ryosen::test
