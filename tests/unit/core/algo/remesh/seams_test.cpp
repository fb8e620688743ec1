// Seams of corner values in remeshing and Delaunay swaps: weighed, kept or dropped; normals of flat faces are none but
// where seams are kept.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "ryosen/algo/remesh/remesh.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/rules/corner_values.h"
#include "tests/support/core/run_algorithm.h"
#include "tests/support/core/seamed_meshes.h"
#include "tests/support/core/valued_sheet.h"

namespace ryosen::test {
namespace {

// Runs it, sees that undo gives the mesh back to the byte, and does it again.
AlgorithmResult run_and_undo(Mesh& mesh, const std::string& line) {
  SCOPED_TRACE(line);
  const MeshColumns before = mesh.columns();
  Journal journal;
  AlgorithmResult result = run_algorithm(mesh, journal, line);
  EXPECT_FALSE(result.fault || result.refused);
  EXPECT_FALSE(check_invariants(mesh));
  if (result.changed == 0) return result;
  const MeshColumns after = mesh.columns();
  journal.undo(mesh);
  EXPECT_TRUE(mesh.columns() == before);
  journal.redo(mesh);
  EXPECT_TRUE(mesh.columns() == after);
  return result;
}

Mesh triangles_of(const std::string& shape) {
  Mesh mesh = made_by(shape);
  Journal journal;
  run_algorithm(mesh, journal, "simplify ratio=1 faces=100000 triangulate=on");
  return from_indexed(to_indexed(mesh).mesh);
}

double length_of(const Mesh& mesh, Edge e) {
  const auto [a, b] = ends(mesh, e);
  return glm::distance(mesh.position(a), mesh.position(b));
}

double longest_edge(const Mesh& mesh) {
  double longest = 0;
  for (const Edge e : live_edges(mesh)) longest = std::max(longest, length_of(mesh, e));
  return longest;
}

std::vector<Edge> seams_of(const Mesh& mesh) {
  std::vector<Edge> seams;
  for (const Edge e : live_edges(mesh))
    if (is_seam(mesh, halfedge(e))) seams.push_back(e);
  return seams;
}

// An edge between two triangles whose opposite angles are together above 180 degrees, by their cosines and sines.
bool is_bad(const Mesh& mesh, Edge e) {
  const auto angle_rad = [&](Halfedge h) {
    const glm::dvec3 c = mesh.position(mesh.from(mesh.prev(h)));
    return std::acos(std::clamp(
        glm::dot(glm::normalize(mesh.position(mesh.from(h)) - c), glm::normalize(mesh.position(mesh.to(h)) - c)), -1.0,
        1.0));
  };
  const Halfedge h = halfedge(e);
  if (mesh.is_outside(h) || mesh.is_outside(twin(h))) return false;
  return angle_rad(h) + angle_rad(twin(h)) > std::numbers::pi + 1e-6;
}

// Polygons of the mesh by the places of their corners, which are in no order.
std::multiset<std::vector<std::array<double, 3>>> places_of(const Mesh& mesh) {
  std::multiset<std::vector<std::array<double, 3>>> faces;
  for (const Face f : live_faces(mesh)) {
    std::vector<std::array<double, 3>> corners;
    for (const Halfedge h : halfedges_around(mesh, f)) {
      const glm::dvec3& p = mesh.position(mesh.from(h));
      corners.push_back({p.x, p.y, p.z});
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    faces.insert(corners);
  }
  return faces;
}

glm::dvec3 texture_at(const Mesh& mesh, Halfedge h) {
  const AttributeColumn &index = *find_column(mesh, attribute_names::texcoord),
                        &pool = *find_column(mesh, attribute_names::texcoord_pool);
  EXPECT_NE(index.data[h.index], no_index);
  return attribute_value<glm::dvec3>(pool, index.data[h.index]);
}

// Stretched by factors along the axes, since edges of the shapes are rather even.
Mesh stretched(Mesh mesh, const glm::dvec3& by) {
  MeshColumns columns = mesh.columns();
  for (glm::dvec3& p : columns.positions) p *= by;
  return Mesh(std::move(columns));
}

TEST(RemeshSeams, flat_normals_change_no_result) {
  for (const char* const shape : {"cube", "sphere", "torus", "icosahedron", "cylinder"}) {
    const Mesh plain = stretched(triangles_of(shape), {1, 1.5, 0.7}), flat = with_flat_normals(plain);
    for (const char* const words : {"remesh length=0.3", "remesh length=0.7", "remesh length=0.5 adaptive=on",
                                    "delaunay", "delaunay most_turn=60"}) {
      SCOPED_TRACE(std::string(shape) + " " + words);
      Mesh made = flat, expected = plain;
      run_and_undo(made, words);
      run_and_undo(expected, words);
      EXPECT_EQ(places_of(made), places_of(expected));
      expect_flat_normals(made);
    }
  }
}

// Halves of squares that bend have normals of their own, and files round.
TEST(RemeshSeams, flat_normals_of_polygons_and_rounded_ones_are_flat) {
  for (const double rounding : {1e-6, 1e-4, 1e-3, 3e-3})
    for (const char* const words : {"remesh length=0.2", "remesh length=0.5", "delaunay most_turn=40"}) {
      Mesh mesh = with_flat_normals(triangles_of("torus"), rounding);
      run_and_undo(mesh, words);
      expect_flat_normals(mesh, 0.9998477);
    }
  for (const char* const shape : {"cube", "sphere", "torus", "cone", "cylinder"}) {
    IndexedMesh source = to_indexed(made_by(shape)).mesh;
    source.normals.components = 3;
    for (std::size_t f = 0; f < source.face_count(); ++f) {
      const auto corners = source.face(f);
      glm::dvec3 sum(0);
      for (std::size_t i = 0; i < corners.size(); ++i)
        sum += glm::cross(source.positions[corners[i]], source.positions[corners[(i + 1) % corners.size()]]);
      for (std::size_t i = 0; i < corners.size(); ++i) source.normals.index.push_back(static_cast<std::uint32_t>(f));
      source.normals.pool.push_back(glm::normalize(sum));
    }
    Mesh mesh = from_indexed(std::move(source));
    run_and_undo(mesh, "remesh length=0.4");
    expect_flat_normals(mesh);
  }
}

TEST(RemeshSeams, kept_flat_normals_hold_all_edges) {
  for (const char* const shape : {"sphere", "torus", "icosahedron", "sphere radius=2", "torus tube=0.5"}) {
    const Mesh flat = with_flat_normals(triangles_of(shape));
    Mesh made = flat;
    const AlgorithmResult result = run_and_undo(made, "remesh length=2 seams=keep feature_angle=180");
    EXPECT_EQ(made.live(), flat.live()) << shape;
    std::size_t held = 0;
    for (const Edge e : live_edges(made)) held += length_of(made, e) < 0.8 * 2;
    EXPECT_EQ(result.left, held);
    ASSERT_EQ(result.left_for.size(), 1u);
    EXPECT_EQ(result.left_for[0].elements.size(), held);
    EXPECT_NE(result.text.en.find("; " + std::to_string(held) + " edges stay too short (seam;"), std::string::npos)
        << result.text.en;
    EXPECT_NE(result.text.ja.find("シーム"), std::string::npos);
    made = stretched(flat, {1, 2, 0.5});
    const std::size_t seams = seams_of(made).size();
    const AlgorithmResult swapped = run_and_undo(made, "delaunay most_turn=180 seams=keep");
    EXPECT_EQ(seams_of(made).size(), seams);
    std::size_t bad = 0;
    for (const Edge e : seams_of(made)) bad += is_bad(made, e);
    EXPECT_GT(bad, 0u) << shape;
    EXPECT_EQ(swapped.left, bad);
    ASSERT_EQ(swapped.left_for.size(), 1u);
    EXPECT_EQ(swapped.left_for[0].elements.size(), bad);
    EXPECT_NE(swapped.text.en.find(bad == 1 ? "is a seam" : "are seams"), std::string::npos) << swapped.text.en;
  }
}

// Texture is the place, so that it stays exactly so.
TEST(RemeshSeams, linear_texture_stays_so_while_points_leave_the_seam) {
  for (const glm::dmat3& turn : {glm::dmat3(1), some_turn()})
    for (const double seam : {0.25, 0.5, 0.75})
      for (const char* const words : {"length=0.15", "length=0.25", "length=0.3 rounds=2", "length=0.15 adaptive=on"}) {
        SCOPED_TRACE(words);
        Mesh weighed = valued_sheet(20, seam, turn), kept = weighed;
        run_and_undo(weighed, std::string("remesh ") + words);
        run_and_undo(kept, std::string("remesh seams=keep ") + words);
        EXPECT_LT(worst_value(weighed, seam, turn), across_seam * 1e-15);
        EXPECT_LT(worst_value(kept, seam, turn), across_seam * 1e-15);
        EXPECT_EQ(seams_of(kept).size(), 20u);
        EXPECT_LE(seams_of(weighed).size(), 12u);
        double length = 0;
        for (const Edge e : seams_of(weighed)) length += length_of(weighed, e);
        EXPECT_NEAR(length, 1, 1e-12);
      }
}

// A seam that winds over a sheet: it stays near its line, and each side on its chart.
TEST(RemeshSeams, winding_seams_stay_near_their_line) {
  constexpr double seam = 0.5;
  const auto winding = [](double y) { return 0.1 * std::sin(2 * std::numbers::pi * y); };
  for (const double length : {0.06, 0.1, 0.15, 0.2, 0.3}) {
    MeshColumns columns = valued_sheet(40, seam).columns();
    for (glm::dvec3& p : columns.positions) p.x += 4 * p.x * (1 - p.x) * winding(p.y);
    Mesh mesh(std::move(columns));
    run_and_undo(mesh, "remesh length=" + std::to_string(length));
    EXPECT_LT(seams_of(mesh).size(), 36u);
    for (const Edge e : seams_of(mesh)) {
      const auto [a, b] = ends(mesh, e);
      for (const double t : {0.0, 0.25, 0.5, 0.75}) {
        const glm::dvec3 p = glm::mix(mesh.position(a), mesh.position(b), t);
        EXPECT_LE(std::abs(p.x - seam - winding(p.y)), 0.11 * length);
      }
    }
    for (const Halfedge h : live_halfedges(mesh)) {
      if (mesh.is_outside(h)) continue;
      const glm::dvec3 p = mesh.position(mesh.from(h)), value = texture_at(mesh, h);
      const double x = value.x > 50 ? value.x - across_seam : value.x;
      EXPECT_LE(std::abs(x + 4 * x * (1 - x) * winding(value.y) - p.x), 0.15 * length);
    }
  }
}

TEST(RemeshSeams, the_seam_of_a_sphere_runs_from_pole_to_pole) {
  for (const std::uint32_t meridians : {16u, 24u, 32u, 48u, 64u})
    for (const char* const mode : {"weigh", "keep"}) {
      const double length = 0.5;
      Mesh mesh = seamed_sphere(meridians);
      ASSERT_EQ(seams_of(mesh).size(), meridians / 2);
      const AlgorithmResult result = run_and_undo(mesh, std::string("remesh length=0.5 seams=") + mode);
      const std::vector<Edge> seams = seams_of(mesh);
      double along = 0;
      std::map<Vertex, int> at;
      for (const Edge e : seams) {
        const auto [a, b] = ends(mesh, e);
        along += length_of(mesh, e), ++at[a], ++at[b];
        EXPECT_LT(length_of(mesh, e), 4.0 / 3 * length);
        for (const Halfedge h : {halfedge(e), twin(halfedge(e))}) {
          const glm::dvec3 value = texture_at(mesh, h);
          const bool is_pole = std::abs(mesh.position(mesh.from(h)).z) > 1 - 1e-12;
          EXPECT_TRUE(is_pole || value.x < 1e-12 || value.x > 1 - 1e-12) << value.x;
          EXPECT_NEAR(-std::cos(std::numbers::pi * value.y), mesh.position(mesh.from(h)).z, 0.02);
        }
      }
      EXPECT_NEAR(along, std::numbers::pi, 0.1);
      EXPECT_EQ(std::count_if(at.begin(), at.end(), [](const auto& each) { return each.second == 1; }), 2);
      EXPECT_EQ(std::count_if(at.begin(), at.end(), [](const auto& each) { return each.second > 2; }), 0);
      if (mode == std::string_view("weigh")) {
        EXPECT_LE(seams.size(), 12u);
      } else {
        EXPECT_GE(seams.size(), meridians / 2);
        EXPECT_EQ(result.left > 0, std::numbers::pi / (meridians / 2) < 0.8 * length);
      }
    }
}

// The corners of a box are where three seams meet.
TEST(RemeshSeams, islands_of_sides_keep_their_corners_and_their_places) {
  for (const std::uint32_t n : {2u, 4u, 6u, 8u, 10u})
    for (const char* const words :
         {"remesh length=0.3", "remesh length=0.3 seams=keep", "remesh length=0.3 feature_angle=180",
          "remesh length=0.05 feature_angle=180", "delaunay", "delaunay most_turn=180"}) {
      SCOPED_TRACE(std::to_string(n) + " " + words);
      Mesh mesh = island_box(n);
      run_and_undo(mesh, words);
      std::size_t corners = 0;
      for (const Vertex v : live_vertices(mesh)) {
        const glm::dvec3 p = mesh.position(v);
        corners += glm::all(glm::equal(p * (1.0 - p), glm::dvec3(0)));
      }
      EXPECT_EQ(corners, 8u);
      EXPECT_NEAR(*compute_figures(mesh).volume, 1, 1e-9);
      for (const Halfedge h : live_halfedges(mesh)) {
        const glm::dvec3 p = mesh.position(mesh.from(h)), value = texture_at(mesh, h);
        const int side = static_cast<int>(value.x / 10 + 0.01), axis = side / 2, level = side % 2;
        const double u = p[(axis + 1) % 3], v = p[(axis + 2) % 3];
        EXPECT_NEAR(p[axis], level, 1e-12);
        EXPECT_NEAR(value.x, island_of(axis, level) + (level == 1 ? u : v), 1e-12);
        EXPECT_NEAR(value.y, level == 1 ? v : u, 1e-12);
      }
    }
}

// Without creases there are but seams between the sides of a box.
TEST(RemeshSeams, points_between_islands_leave_where_only_seams_hold_them) {
  for (const std::uint32_t n : {6u, 8u, 10u, 12u, 16u}) {
    Mesh weighed = island_box(n), kept = weighed;
    EXPECT_EQ(run_and_undo(weighed, "remesh length=0.4 feature_angle=180").left, 0u);
    EXPECT_GT(run_and_undo(kept, "remesh length=0.4 feature_angle=180 seams=keep").left, 0u);
    EXPECT_EQ(seams_of(kept).size(), 12u * n);
    EXPECT_LE(seams_of(weighed).size(), 12u * 4);
  }
}

TEST(RemeshSeams, islands_of_triangles_are_divided_and_stay_on_themselves) {
  for (const char* const shape : {"icosahedron", "sphere", "torus", "cube", "torus tube=0.5"})
    for (const double length : {0.2, 0.3, 5.0})
      for (const char* const mode : {"weigh", "keep"}) {
        SCOPED_TRACE(shape);
        const Mesh islands = with_islands(triangles_of(shape));
        Mesh mesh = islands;
        const AlgorithmResult result =
            run_and_undo(mesh, "remesh length=" + std::to_string(length) + " seams=" + std::string(mode));
        EXPECT_LT(longest_edge(mesh), 1.8 * length);
        for (const Vertex v : live_vertices(islands)) EXPECT_EQ(mesh.position(v), islands.position(v));
        if (length == 5) {
          EXPECT_EQ(mesh.live(), islands.live());
          EXPECT_GT(result.left, 0u);
        }
        for (const Face f : live_faces(mesh)) {
          std::set<int> numbers;
          for (const Halfedge h : halfedges_around(mesh, f))
            numbers.insert(static_cast<int>(std::floor(texture_at(mesh, h).x + 1e-9)));
          EXPECT_EQ(numbers.size(), 1u);
        }
      }
}

TEST(RemeshSeams, islands_of_triangles_are_not_swapped) {
  for (const char* const shape : {"sphere", "torus", "icosahedron", "sphere radius=3", "cone"})
    for (const char* const mode : {"weigh", "keep"}) {
      Mesh mesh = stretched(with_islands(triangles_of(shape)), {1, 2, 0.5});
      std::size_t bad = 0;
      for (const Edge e : live_edges(mesh)) bad += is_bad(mesh, e);
      const AlgorithmResult result = run_and_undo(mesh, std::string("delaunay most_turn=180 seams=") + mode);
      EXPECT_EQ(result.changed, 0u);
      EXPECT_EQ(result.left, bad);
    }
}

TEST(RemeshSeams, dropped_they_change_what_a_mesh_without_them_does) {
  for (const char* const shape : {"icosahedron", "sphere", "torus", "cube", "cylinder"}) {
    const Mesh plain = stretched(triangles_of(shape), {1, 2, 0.5});
    const Mesh textured = with_islands(plain), flat = with_flat_normals(plain), both = with_flat_normals(textured);
    for (const char* const words : {"remesh length=0.7", "delaunay most_turn=60"}) {
      Mesh expected = plain;
      run_and_undo(expected, words);
      const auto expect_dropped = [&](Mesh mesh, const char* sentence) {
        const AlgorithmResult result = run_and_undo(mesh, std::string(words) + " seams=drop");
        EXPECT_TRUE(result.text.en.ends_with(sentence)) << result.text.en;
        EXPECT_TRUE(mesh.columns() == expected.columns()) << shape << " " << words;
        EXPECT_TRUE(corner_attributes(mesh).empty());
      };
      expect_dropped(textured, " Texture was dropped.");
      expect_dropped(flat, " Normals were dropped.");
      expect_dropped(both, " Texture and normals were dropped.");
    }
  }
}

TEST(RemeshSeams, dropped_they_take_no_colours_along) {
  for (const double seam : {0.2, 0.4, 0.5, 0.6, 0.8})
    for (const char* const words : {"remesh length=0.2", "remesh length=0.03", "delaunay", "delaunay most_turn=180"}) {
      Mesh mesh = valued_sheet(8, seam, glm::dmat3({1, 0, 0}, {0.7, 1, 0}, {0, 0, 1}));
      run_and_undo(mesh, std::string(words) + " seams=drop");
      EXPECT_TRUE(corner_attributes(mesh).empty());
      const AttributeColumn* const colours = find_column(mesh, attribute_names::colour);
      ASSERT_TRUE(colours);
      for (const Vertex v : live_vertices(mesh)) {
        const auto colour = attribute_value<glm::dvec4>(*colours, v.index);
        EXPECT_NEAR(glm::distance(glm::dvec3(colour), mesh.position(v)), 0, 1e-14);
      }
      EXPECT_TRUE(seams_of(mesh).empty());
    }
}

TEST(RemeshSeams, modes_are_one_where_there_are_no_values) {
  for (const char* const shape : {"sphere", "torus", "cube", "cylinder", "grid width=4 depth=4"})
    for (const char* const words : {"remesh length=0.4", "delaunay"}) {
      const Mesh plain = stretched(triangles_of(shape), {1, 2, 0.5});
      Mesh weighed = plain;
      const AlgorithmResult result = run_and_undo(weighed, words);
      for (const char* const mode : {"keep", "drop"}) {
        Mesh made = plain;
        const AlgorithmResult other = run_and_undo(made, std::string(words) + " seams=" + mode);
        EXPECT_TRUE(made.columns() == weighed.columns());
        EXPECT_EQ(other.text.en, result.text.en);
        EXPECT_EQ(other.left, result.left);
      }
    }
}

// A round island within a sheet, of which its seam goes around: however long edges are to be, it does not vanish.
TEST(RemeshSeams, islands_do_not_vanish) {
  for (const double radius : {0.06, 0.1, 0.15, 0.2, 0.3})
    for (const char* const words : {"remesh length=0.1", "remesh length=0.5", "remesh length=2"}) {
      SCOPED_TRACE(std::to_string(radius) + " " + words);
      IndexedMesh source = to_indexed(valued_sheet(30)).mesh;
      source.texcoords.pool.clear();
      source.texcoords.index.clear();
      double before = 0, after = 0;
      for (std::size_t f = 0; f < source.face_count(); ++f) {
        const auto corners = source.face(f);
        glm::dvec3 middle(0);
        for (const std::uint32_t corner : corners) middle += source.positions[corner] / 3.0;
        const bool is_inside = glm::distance(middle, glm::dvec3(0.5, 0.5, 0)) < radius;
        before += is_inside ? 0.5 / 900 : 0;
        for (const std::uint32_t corner : corners) {
          source.texcoords.index.push_back(static_cast<std::uint32_t>(source.texcoords.pool.size()));
          source.texcoords.pool.push_back(source.positions[corner] + glm::dvec3(is_inside ? across_seam : 0, 0, 0));
        }
      }
      Mesh mesh = from_indexed(std::move(source));
      const std::size_t seams = seams_of(mesh).size();
      run_and_undo(mesh, words);
      EXPECT_LT(seams_of(mesh).size(), seams);
      for (const Face f : live_faces(mesh)) {
        std::set<bool> sides;
        for (const Halfedge h : halfedges_around(mesh, f)) sides.insert(texture_at(mesh, h).x > 50);
        EXPECT_EQ(sides.size(), 1u);
        if (*sides.begin()) after += glm::length(area_normal(corners_of(mesh, mesh.halfedge(f)))) / 2;
      }
      EXPECT_GT(after, 0.1 * before);
      EXPECT_LT(after, 1.5 * before);
    }
}

TEST(RemeshSeams, flat_normals_need_no_descent) {
  for (const char* const shape : {"cube", "sphere", "torus", "icosahedron", "cylinder"}) {
    const Mesh flat = with_flat_normals(stretched(triangles_of(shape), {1, 1.5, 0.7}));
    Progress unheard;
    expect_flat_normals(Mesh(remesh::remeshed(flat, {.length = 0.4}, unheard).columns));
    const remesh::Swapped swapped = remesh::delaunay_swapped(flat, {.most_turn_rad = 1}, unheard);
    expect_flat_normals(Mesh(swapped.columns));
  }
}

// A cap of normals of its own on a drum with smooth ones.
TEST(RemeshSeams, flat_faces_beside_smooth_ones_stay_flat) {
  for (const double length : {0.15, 0.3, 0.5, 0.7, 0.9}) {
    IndexedMesh source = to_indexed(triangles_of("cylinder")).mesh;
    source.normals.components = 3;
    for (std::size_t f = 0; f < source.face_count(); ++f) {
      const auto corners = source.face(f);
      const auto at = [&](std::size_t i) { return source.positions[corners[i]]; };
      const glm::dvec3 own = glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
      for (std::size_t i = 0; i < 3; ++i) {
        source.normals.index.push_back(static_cast<std::uint32_t>(source.normals.pool.size()));
        source.normals.pool.push_back(std::abs(own.y) > 0.9 ? own : glm::normalize(glm::dvec3(at(i).x, 0, at(i).z)));
      }
    }
    Mesh mesh = from_indexed(std::move(source));
    run_and_undo(mesh, "remesh feature_angle=180 length=" + std::to_string(length));
    const AttributeColumn &index = *find_column(mesh, attribute_names::normal),
                          &pool = *find_column(mesh, attribute_names::normal_pool);
    std::size_t caps = 0;
    for (const Face f : live_faces(mesh)) {
      const glm::dvec3 own = glm::normalize(area_normal(corners_of(mesh, mesh.halfedge(f))));
      for (const Halfedge h : halfedges_around(mesh, f)) {
        ASSERT_NE(index.data[h.index], no_index);
        const auto value = attribute_value<glm::dvec3>(pool, index.data[h.index]);
        if (std::abs(value.y) > 0.5) {
          ++caps;
          EXPECT_NEAR(glm::distance(value, own), 0, 1e-12);
        } else {
          EXPECT_NEAR(value.y, 0, 1e-9);
        }
      }
    }
    EXPECT_GT(caps, 0u);
  }
}

}  // namespace
}  // namespace ryosen::test
