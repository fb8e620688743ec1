// The oracle is held against cases whose answer is known by hand; oracle_laws_test.cpp has the laws it must obey.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "tests/support/core/long_run.h"
#include "tests/support/core/oracle/comparison.h"
#include "tests/support/core/oracle/figures.h"
#include "tests/support/core/oracle/operators.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::oracle {
namespace {

const PolygonList tetrahedron = polygon_list(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
const PolygonList two_tetrahedra_on_an_edge =
    polygon_list(6, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 1, 4}, {0, 5, 1}, {1, 5, 4}, {0, 4, 5}});
const PolygonList three_on_an_edge = polygon_list(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
const PolygonList octahedron =
    polygon_list(6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}});
const PolygonList projective_plane = polygon_list(
    6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}});
const PolygonList two_quads = polygon_list(6, {{0, 1, 2, 3}, {1, 4, 5, 2}});

PolygonList torus(int columns, int rows) {
  std::vector<Corners> faces;
  const auto at = [&](int i, int j) { return (i % columns) * rows + j % rows; };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return polygon_list(columns * rows, faces);
}

PolygonList list_of(const RandomMesh& mesh) { return polygon_list(mesh.points, mesh.faces); }

bool legal(const PolygonList& points, Kind kind, int from, int to) {
  return Judge(read_copies(points)).legal({kind, from, to});
}

// The share of legal operations of one kind: how many of the operations_of are legal, and how many there are.
std::pair<int, int> count_legal(const PolygonList& points, Kind kind) {
  const Judge judge(read_copies(points));
  int legal_ones = 0, all = 0;
  for (const Operation& operation : operations_of(points)) {
    if (operation.kind != kind) continue;
    ++all;
    legal_ones += judge.legal(operation);
  }
  return {legal_ones, all};
}

PolygonList points_after(const PolygonList& points, Kind kind, int from, int to) {
  return points_of(apply(read_copies(points), {kind, from, to}).value());
}

bool mentions(const Reasons& reasons, const std::string& part) {
  return std::any_of(reasons.begin(), reasons.end(),
                     [&](const std::string& reason) { return reason.find(part) != std::string::npos; });
}

// ---- reading ----

TEST(oracle_reading, a_closed_mesh_has_no_further_copies) {
  EXPECT_TRUE(same_list(read_copies(tetrahedron).list, tetrahedron));
  EXPECT_TRUE(same_list(read_copies(torus(4, 3)).list, torus(4, 3)));
}

TEST(oracle_reading, two_tetrahedra_on_an_edge_become_two_closed_ones) {
  const CopyList copies = read_copies(two_tetrahedra_on_an_edge);
  const Figures figures = figures_of(copies.list);
  EXPECT_EQ(figures.vertices, 8);
  EXPECT_EQ(figures.edges, 12);
  EXPECT_EQ(figures.components, 2);
  EXPECT_TRUE(figures.closed && figures.manifold);
  EXPECT_EQ(copies.point_of, (std::vector<int>{0, 1, 2, 3, 4, 5, 0, 1}));
  EXPECT_EQ(copies.list.faces[5], (Corners{6, 5, 7}));
}

TEST(oracle_reading, copies_are_numbered_by_point_then_by_lowest_face) {
  const CopyList copies = read_copies(three_on_an_edge);
  EXPECT_EQ(copies.list.faces, (std::vector<Corners>{{0, 1, 2}, {7, 5, 3}, {6, 8, 4}}));
  EXPECT_EQ(copies.point_of, (std::vector<int>{0, 1, 2, 3, 4, 0, 0, 1, 1}));
}

TEST(oracle_reading, misoriented_neighbours_are_cut_and_a_bow_tie_comes_apart) {
  const CopyList turned = read_copies(polygon_list(4, {{0, 1, 2}, {0, 1, 3}}));
  EXPECT_EQ(turned.list.faces, (std::vector<Corners>{{0, 1, 2}, {4, 5, 3}}));
  const CopyList bow_tie = read_copies(polygon_list(6, {{0, 3, 4}, {0, 1, 2}}));
  EXPECT_EQ(bow_tie.list.faces, (std::vector<Corners>{{0, 3, 4}, {6, 1, 2}}));
  EXPECT_EQ(bow_tie.list.size(), 7);
}

// The specification's own words, with outside halves and loops: how many loops of two there are.
int outside_loops_of_two(const CopyList& copies, const Sides& on_points) {
  // A cut side of a face has an outside half the other way; a copy has at most one gap, so the half that follows is the
  // one that starts where this ends.
  std::vector<std::pair<int, int>> halves;
  for (const Side& s : on_points.all()) {
    if (is_joined(on_points, on_points.pair_of(s.face, s.corner))) continue;
    const Corners& face = copies.list.faces[s.face];
    halves.emplace_back(face[(s.corner + 1) % face.size()], face[s.corner]);
  }
  int loops = 0;
  for (auto [from, to] : halves) {
    EXPECT_EQ(std::count_if(halves.begin(), halves.end(), [to = to](auto& half) { return half.first == to; }), 1);
    loops += from < to && std::count(halves.begin(), halves.end(), std::pair(to, from)) == 1;
  }
  return loops;
}

TEST(oracle_reading, outside_loops_of_two_are_the_only_cut_sides_that_are_one_edge_of_the_copies) {
  int closed_again = 0;
  for (std::uint64_t seed = 0; seed < 5000; ++seed) {
    const PolygonList points = list_of(random_mesh(seed));
    const CopyList copies = read_copies(points);
    const Sides on_points(points), on_copies(copies.list);
    int joined_on_points = 0, joined_on_copies = 0;
    for (int pair = 0; pair < on_points.pairs(); ++pair) joined_on_points += is_joined(on_points, pair);
    for (int pair = 0; pair < on_copies.pairs(); ++pair) {
      joined_on_copies += is_joined(on_copies, pair);
      EXPECT_TRUE(on_copies.count(pair) == 1 || is_joined(on_copies, pair)) << seed;
    }
    const int loops = outside_loops_of_two(copies, on_points);
    EXPECT_EQ(joined_on_copies, joined_on_points + loops) << seed << " " << to_text(points);
    closed_again += loops;
  }
  EXPECT_GT(closed_again, 100);
}

TEST(oracle_reading, reads_back_itself) {
  for (std::uint64_t seed = 0; seed < 5000; ++seed) {
    const PolygonList points = list_of(random_mesh(seed));
    ASSERT_TRUE(is_simple(points)) << seed;
    const CopyList copies = read_copies(points);
    EXPECT_EQ(points_of(copies).faces, points.faces) << seed;
    const Facts facts = facts_of(copies);
    EXPECT_TRUE(facts.reads_back) << seed;
    for (const Violation& violation : facts.violations) EXPECT_EQ(violation.rule, Rule::equal_faces) << seed;
  }
}

// ---- figures ----

TEST(oracle_figures, small_meshes) {
  EXPECT_EQ(figures_of(tetrahedron).genus, 0);
  EXPECT_EQ(figures_of(torus(3, 3)).genus, 1);
  EXPECT_TRUE(figures_of(octahedron).closed);

  const Figures fin = figures_of(three_on_an_edge);
  EXPECT_EQ(fin.nonmanifold_edges, 1);
  EXPECT_EQ(fin.boundary_edges, 6);
  EXPECT_EQ(fin.boundary_loops, 0);
  EXPECT_EQ(fin.max_edge_faces, 3);
  EXPECT_EQ(fin.nonmanifold_vertices, 2);
  EXPECT_EQ(fin.bowtie_vertices, 0);
  EXPECT_EQ(fin.genus, -1);

  const Figures plane = figures_of(projective_plane);
  EXPECT_EQ(plane.misoriented_edges, 10);
  EXPECT_FALSE(plane.orientable);
  EXPECT_EQ(plane.euler_characteristic, 1);

  const Figures pillow = figures_of(polygon_list(4, {{0, 1, 2}, {2, 1, 0}}));
  EXPECT_EQ(pillow.hanging_pairs, 1);
  EXPECT_EQ(pillow.duplicate_faces, 1);
  EXPECT_EQ(pillow.isolated_vertices, 1);
  EXPECT_EQ(pillow.genus, 0);
  EXPECT_EQ(figures_of(polygon_list(3, {{0, 1, 2}, {1, 2, 0}})).hanging_pairs, 0);
  // Opposite triangles with a third face on two of their edges hang no more.
  EXPECT_EQ(figures_of(polygon_list(5, {{0, 1, 2}, {2, 1, 0}, {0, 1, 3}, {1, 2, 4}})).hanging_pairs, 0);
  EXPECT_EQ(figures_of(polygon_list(5, {{0, 1, 2}, {2, 1, 0}, {0, 1, 3}})).hanging_pairs, 1);

  const Figures nothing = figures_of(polygon_list(2, {}));
  EXPECT_FALSE(nothing.closed);
  EXPECT_TRUE(nothing.manifold);
  EXPECT_EQ(nothing.isolated_vertices, 2);
}

TEST(oracle_figures, loops_go_apart_at_a_bow_tie_and_on_across_a_misoriented_edge) {
  const Figures bow_tie = figures_of(polygon_list(5, {{0, 1, 2}, {0, 3, 4}}));
  EXPECT_EQ(bow_tie.boundary_loops, 2);
  EXPECT_EQ(bow_tie.bowtie_vertices, 1);
  EXPECT_EQ(bow_tie.components, 2);
  const Figures turned = figures_of(polygon_list(4, {{0, 1, 2}, {0, 1, 3}}));
  EXPECT_EQ(turned.boundary_loops, 1);
  EXPECT_EQ(turned.misoriented_edges, 1);
  EXPECT_EQ(turned.nonmanifold_vertices, 0);
  EXPECT_TRUE(turned.orientable);
}

TEST(oracle_figures, euler_poincare_holds_on_the_copies) {
  for (std::uint64_t seed = 0; seed < 5000; ++seed) {
    const Figures figures = figures_of(read_copies(list_of(random_mesh(seed))).list);
    ASSERT_TRUE(figures.manifold && figures.orientable) << seed;
    EXPECT_EQ(figures.misoriented_edges, 0);
    EXPECT_EQ(figures.euler_characteristic + figures.boundary_loops + 2 * figures.genus, 2 * figures.components)
        << seed;
  }
}

// The kept faces and the number of points of an OFF file of the known meshes.
PolygonList read_off(const std::string& path) {
  std::ifstream file(path);
  std::string word;
  std::size_t points = 0, faces = 0, edges = 0, corners = 0;
  file >> word >> points >> faces >> edges;
  for (std::size_t i = 0; i < 3 * points; ++i) file >> word;
  PolygonList list = polygon_list(static_cast<int>(points), {});
  for (std::size_t f = 0; f < faces && file >> corners; ++f) {
    Corners face(corners);
    for (int& corner : face) file >> corner;
    if (is_simple(polygon_list(static_cast<int>(points), {face}))) list.faces.push_back(face);
  }
  return list;
}

std::string value_of(const std::string& line, const std::string& key) {
  const std::string opening = "\"" + key + "\":";
  const std::size_t start = line.find(opening) + opening.size();
  return line.substr(start, line.find_first_of(",}", start) - start);
}

TEST(oracle_figures, known_meshes) {
  const std::string folder = std::string(RYOSEN_SHARED_DIR) + "/meshes/known/";
  std::ifstream truth(folder + "truth.jsonl");
  for (std::string line; std::getline(truth, line);) {
    const std::string name = value_of(line, "file");
    const Figures figures = figures_of(read_off(folder + name.substr(1, name.size() - 2)));
    const std::map<std::string, int> expected{{"V", figures.vertices},
                                              {"E", figures.edges},
                                              {"F", figures.faces},
                                              {"boundary_edges", figures.boundary_edges},
                                              {"boundary_loops", figures.boundary_loops},
                                              {"nm_edges", figures.nonmanifold_edges},
                                              {"max_edge_faces", figures.max_edge_faces},
                                              {"nm_vertices", figures.nonmanifold_vertices},
                                              {"bowtie_vertices", figures.bowtie_vertices},
                                              {"inconsistent_edges", figures.misoriented_edges},
                                              {"dup_faces", figures.duplicate_faces},
                                              {"isolated_v", figures.isolated_vertices},
                                              {"components", figures.components},
                                              {"chi", figures.euler_characteristic}};
    for (const auto& [key, value] : expected) EXPECT_EQ(value_of(line, key), std::to_string(value)) << name << key;
    const auto word = [](bool yes) { return yes ? "true" : "false"; };
    EXPECT_EQ(value_of(line, "manifold"), word(figures.manifold)) << name;
    EXPECT_EQ(value_of(line, "closed"), word(figures.closed)) << name;
    EXPECT_EQ(value_of(line, "orientable"), word(figures.orientable)) << name;
    EXPECT_EQ(value_of(line, "genus"), figures.genus < 0 ? "null" : std::to_string(figures.genus)) << name;
  }
}

// ---- verdicts ----

TEST(oracle_verdicts, tetrahedron_refuses_every_collapse_and_swap) {
  EXPECT_EQ(count_legal(tetrahedron, Kind::collapse), std::pair(0, 12));
  EXPECT_EQ(count_legal(tetrahedron, Kind::swap), std::pair(0, 12));
  EXPECT_EQ(count_legal(tetrahedron, Kind::swap_back), std::pair(0, 12));
  EXPECT_EQ(count_legal(tetrahedron, Kind::split), std::pair(12, 12));
  const Judge judge(read_copies(tetrahedron));
  EXPECT_EQ(judge.reasons({Kind::collapse, 0, 1}),
            (Reasons{"1 two faces on one vertex set: 2 3", "3 faces on equal point sets change"}));
  EXPECT_TRUE(mentions(judge.reasons({Kind::swap, 0, 1}), "1 directed edge twice"));
}

TEST(oracle_verdicts, octahedron_and_torus) {
  EXPECT_EQ(count_legal(octahedron, Kind::collapse), std::pair(24, 24));
  EXPECT_EQ(count_legal(octahedron, Kind::swap), std::pair(24, 24));
  // On the small torus each ring has three edges, so every collapse would close one.
  EXPECT_EQ(count_legal(torus(3, 3), Kind::collapse), std::pair(0, 54));
  EXPECT_EQ(count_legal(torus(5, 5), Kind::collapse), std::pair(150, 150));
  EXPECT_EQ(count_legal(torus(5, 5), Kind::swap), std::pair(150, 150));
  EXPECT_EQ(count_legal(projective_plane, Kind::swap).first, 0);
}

TEST(oracle_verdicts, inner_edge_between_two_boundary_vertices) {
  const PolygonList two_triangles = polygon_list(4, {{0, 1, 2}, {2, 1, 3}});
  EXPECT_FALSE(legal(two_triangles, Kind::collapse, 1, 2));
  EXPECT_TRUE(legal(two_triangles, Kind::collapse, 0, 1));
  const PolygonList row = polygon_list(6, {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}});
  EXPECT_FALSE(legal(row, Kind::collapse, 2, 3));
  EXPECT_TRUE(mentions(Judge(read_copies(row)).reasons({Kind::collapse, 2, 3}), "1 more than one fan"));
  EXPECT_TRUE(legal(two_triangles, Kind::swap, 1, 2));
}

TEST(oracle_verdicts, last_face_and_ear) {
  const PolygonList triangle = polygon_list(3, {{0, 1, 2}});
  EXPECT_EQ(count_legal(triangle, Kind::collapse).first, 0);
  EXPECT_TRUE(legal(polygon_list(4, {{0, 1, 2, 3}}), Kind::collapse, 0, 1));
  // The outer edges of an ear may go, for the ear's tip then is no vertex of its own any more.
  EXPECT_TRUE(legal(polygon_list(4, {{0, 1, 2}, {2, 1, 3}}), Kind::collapse, 3, 1));
}

TEST(oracle_verdicts, beside_a_three_edge_hole) {
  PolygonList open = octahedron;
  open.faces.erase(open.faces.begin());
  EXPECT_FALSE(legal(open, Kind::collapse, 0, 1));
  EXPECT_TRUE(mentions(Judge(read_copies(open)).reasons({Kind::collapse, 0, 1}), "2 boundary loops -1"));
  EXPECT_TRUE(legal(open, Kind::collapse, 3, 0));
  open.faces.erase(open.faces.begin());
  EXPECT_TRUE(legal(open, Kind::collapse, 0, 1)) << "the hole has four edges";
}

TEST(oracle_verdicts, swap_between_quads_turns_by_one_corner) {
  EXPECT_TRUE(legal(two_quads, Kind::swap, 1, 2));
  EXPECT_TRUE(same_list(points_after(two_quads, Kind::swap, 1, 2), polygon_list(6, {{3, 0, 1, 4}, {4, 5, 2, 3}})));
  EXPECT_TRUE(same_list(points_after(two_quads, Kind::swap_back, 1, 2), polygon_list(6, {{0, 5, 2, 3}, {5, 0, 1, 4}})));
  const PolygonList forth = points_after(two_quads, Kind::swap, 1, 2);
  EXPECT_TRUE(same_list(points_after(forth, Kind::swap_back, 3, 4), two_quads));
}

TEST(oracle_verdicts, swap_onto_an_edge_that_exists) {
  // 2-3 lies in the third face.
  const PolygonList mesh = polygon_list(5, {{0, 1, 2}, {1, 0, 3}, {2, 3, 4}});
  EXPECT_FALSE(legal(mesh, Kind::swap, 0, 1));
  EXPECT_TRUE(legal(polygon_list(4, {{0, 1, 2}, {1, 0, 3}}), Kind::swap, 0, 1));
}

TEST(oracle_verdicts, faces_that_share_two_edges) {
  const PolygonList mesh = polygon_list(4, {{0, 1, 2, 3}, {0, 3, 2}});
  EXPECT_FALSE(legal(mesh, Kind::swap, 2, 3)) << "3 has two edges only";
  EXPECT_TRUE(legal(mesh, Kind::collapse, 3, 0)) << "the triangle goes with the inner vertex";
  EXPECT_FALSE(legal(mesh, Kind::collapse, 0, 2)) << "an edge of the triangle and no edge of the quad";
  const PolygonList pillow = polygon_list(4, {{0, 1, 2, 3}, {3, 2, 1, 0}});
  EXPECT_TRUE(legal(pillow, Kind::collapse, 0, 1)) << "the two faces are on one vertex set before and after";
  EXPECT_FALSE(legal(polygon_list(3, {{0, 1, 2}, {2, 1, 0}}), Kind::collapse, 0, 1));
}

TEST(oracle_verdicts, edges_that_are_not_one_edge_on_points) {
  for (Kind kind : {Kind::collapse, Kind::swap, Kind::swap_back}) {
    EXPECT_FALSE(legal(three_on_an_edge, kind, 0, 1));
    EXPECT_FALSE(legal(two_tetrahedra_on_an_edge, kind, 0, 1));
    EXPECT_FALSE(legal(polygon_list(4, {{0, 1, 2}, {0, 1, 3}}), kind, 0, 1));
  }
  EXPECT_EQ(count_legal(three_on_an_edge, Kind::swap).first, 0);
  EXPECT_TRUE(legal(three_on_an_edge, Kind::split, 0, 1));
  EXPECT_FALSE(legal(polygon_list(3, {{0, 1, 2}, {2, 1, 0}}), Kind::split, 0, 1));
}

TEST(oracle_verdicts, a_point_with_copies_stays_whichever_way_it_is_named) {
  // A quad on a bow-tie: 0 has two copies.
  const PolygonList mesh = polygon_list(7, {{0, 1, 2, 3}, {0, 4, 5, 6}});
  for (auto [from, to] : {std::pair(0, 1), std::pair(1, 0)}) {
    EXPECT_TRUE(legal(mesh, Kind::collapse, from, to));
    EXPECT_EQ(points_after(mesh, Kind::collapse, from, to).faces, (std::vector<Corners>{{0, 2, 3}, {0, 4, 5, 6}}));
  }
  // Two quads that touch at both ends of an edge of neither.
  const PolygonList both = polygon_list(6, {{0, 1, 2, 3}, {0, 4, 1, 5}});
  EXPECT_EQ(Judge(read_copies(both)).reasons({Kind::collapse, 0, 1}), (Reasons{"both points have copies"}));
}

TEST(oracle_verdicts, sheets_must_not_meet_on_points) {
  // 1-2 contracted puts the edge 0-2 on the edge 0-2 of the other sheet.
  const PolygonList mesh = polygon_list(6, {{0, 1, 2, 3}, {0, 2, 4, 5}});
  EXPECT_FALSE(legal(mesh, Kind::collapse, 1, 2));
}

TEST(oracle_verdicts, a_far_defect_changes_nothing) {
  const PolygonList defects = polygon_list(19, {{0, 1, 2},
                                                {2, 1, 0},
                                                {3, 4, 5},
                                                {3, 6, 7},
                                                {8, 9, 10},
                                                {8, 9, 11},
                                                {12, 13, 14},
                                                {12, 13, 15},
                                                {13, 12, 16},
                                                {16, 17, 18},
                                                {18, 17, 16}});
  for (std::uint64_t seed = 0; seed < test::seed_count(100, 300); ++seed) {
    const PolygonList mesh = list_of(random_mesh(seed));
    PolygonList both = mesh;
    for (Corners face : defects.faces) {
      for (int& p : face) p += mesh.size();
      both.faces.push_back(face);
    }
    both.live.resize(both.live.size() + defects.live.size(), 1);
    const Judge alone(read_copies(mesh)), beside(read_copies(both));
    for (const Operation& operation : operations_of(mesh))
      EXPECT_EQ(alone.legal(operation), beside.legal(operation)) << seed << " " << to_text(operation);
  }
}

}  // namespace
}  // namespace ryosen::oracle
