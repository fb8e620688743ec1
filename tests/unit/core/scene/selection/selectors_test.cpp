#include "ryosen/scene/selection/selectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/scene/selection/derived_selections.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

constexpr Element::Kind kinds[] = {Element::Kind::vertex, Element::Kind::halfedge, Element::Kind::edge,
                                   Element::Kind::face};

Elements find(const char* id, const Mesh& mesh, const Elements& selection = {},
              Element::Kind sort = Element::Kind::edge, const char* value = nullptr) {
  const Selector& row = *find_selector(id);
  const auto range = value ? parse_value(row, value) : ValueRange();
  return row.find(mesh, selection, sort, *range);
}

using ElementsByOrder = std::set<Element>;
ElementsByOrder as_set(const Elements& elements) {
  EXPECT_EQ(ElementsByOrder(elements.begin(), elements.end()).size(), elements.size()) << "none twice";
  return {elements.begin(), elements.end()};
}

// By the definition alone: the points of an element from its corners, all pairs of elements compared.
std::set<std::uint32_t> points_of(const Mesh& mesh, Element e) {
  std::set<std::uint32_t> points;
  const auto add = [&](Vertex v) { points.insert(mesh.copy_point(v).index); };
  if (e.kind == Element::Kind::vertex) add(e.vertex());
  if (e.kind == Element::Kind::face)
    for (Halfedge h : halfedges_around(mesh, e.face())) add(mesh.from(h));
  if (e.kind == Element::Kind::edge || e.kind == Element::Kind::halfedge) {
    const Halfedge h = e.kind == Element::Kind::edge ? halfedge(e.edge(), 0) : e.halfedge();
    add(mesh.from(h));
    add(mesh.from(twin(h)));
  }
  return points;
}

bool touch(const Mesh& mesh, Element a, Element b) {
  const auto p = points_of(mesh, a), q = points_of(mesh, b);
  if (a.kind != Element::Kind::vertex)
    return std::any_of(p.begin(), p.end(), [&](std::uint32_t i) { return q.contains(i); });
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (!mesh.is_alive(Edge(i))) continue;
    const auto r = points_of(mesh, Edge(i));
    if (r.contains(*p.begin()) && r.contains(*q.begin()) && (*p.begin() != *q.begin() || r.size() == 1)) return true;
  }
  return false;
}

TEST(selectors, grow_and_shrink_as_neighbours_are_defined) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const SeededMesh source = seeded_mesh(seed);
    const Mesh mesh = make_mesh(source.faces, source.points);
    Dice dice(seed);
    for (const Element::Kind kind : kinds) {
      SCOPED_TRACE("seed " + std::to_string(seed) + " kind " + std::to_string(static_cast<int>(kind)));
      const Elements all = find("all", mesh, {}, kind);
      Elements some;
      for (const Element& e : all)
        if (dice.one_in(4)) some.push_back(e);
      ElementsByOrder more = as_set(some), fewer;
      for (const Element& e : all)
        for (const Element& s : some)
          if (touch(mesh, e, s)) more.insert(e);
      EXPECT_EQ(as_set(grown(mesh, some)), more);
      const Elements grown_once(more.begin(), more.end());
      for (const Element& e : grown_once)
        if (std::none_of(all.begin(), all.end(),
                         [&](const Element& other) { return !more.contains(other) && touch(mesh, e, other); }))
          fewer.insert(e);
      EXPECT_EQ(as_set(shrunk(mesh, grown_once)), fewer);
      Elements last, now = some;
      while (now.size() != last.size()) {
        last = now;
        now = grown(mesh, now);
      }
      EXPECT_EQ(as_set(linked(mesh, some)), as_set(now));
      const Element::Kind other = kind == Element::Kind::face ? Element::Kind::edge : Element::Kind::face;
      if (some.empty()) continue;  // then it is all of the mode
      for (const Element::Kind mode : {kind, other}) {
        Elements others = find("invert", mesh, some, mode);
        EXPECT_EQ(others.size() + some.size(), all.size());
        if (others.empty()) continue;
        EXPECT_EQ(find("invert", mesh, others, mode), some);
      }
    }
  }
}

TEST(selectors, keep_the_order_of_what_was_selected) {
  const Mesh mesh = make_mesh(torus_grid(4, 5));
  const Elements two{Face(7), Face(2)};
  const Elements more = grown(mesh, two);
  ASSERT_GT(more.size(), 2u);
  EXPECT_EQ(more[0], Element(Face(7)));
  EXPECT_EQ(more[1], Element(Face(2)));
  EXPECT_TRUE(std::is_sorted(more.begin() + 2, more.end()));
}

TEST(selectors, a_loop_on_a_torus_of_quads_goes_around_it_and_a_ring_across) {
  const std::uint32_t rows = 4, columns = 7;
  Polygons quads;
  for (std::uint32_t i = 0; i < rows; ++i)
    for (std::uint32_t j = 0; j < columns; ++j) {
      const std::uint32_t below = (i + 1) % rows * columns, right = (j + 1) % columns;
      quads.push_back({i * columns + j, i * columns + right, below + right, below + j});
    }
  const Mesh mesh = make_mesh(quads);
  ASSERT_EQ(corner_count(mesh, Face(0)), 4u);
  std::multiset<std::size_t> loops, rings;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    const Elements loop = edge_loops(mesh, Elements{Edge(i)}), ring = edge_rings(mesh, Elements{Edge(i)});
    as_set(loop);
    as_set(ring);
    loops.insert(loop.size());
    rings.insert(ring.size());
    EXPECT_EQ(loop.size() + ring.size(), rows + columns) << "they cross";
    EXPECT_EQ(edge_loops(mesh, loop), loop) << "there is nothing to add";
    EXPECT_EQ(as_set(edge_loops(mesh, Elements{loop.back()})), as_set(loop)) << "from whichever of its edges";
    EXPECT_EQ(as_set(edge_rings(mesh, Elements{ring.back()})), as_set(ring));
  }
  EXPECT_EQ(loops.count(rows), rows * columns);
  EXPECT_EQ(loops.count(columns), rows * columns);
}

TEST(selectors, a_loop_runs_along_the_whole_boundary_and_ends_at_other_vertices) {
  const Mesh fan = make_mesh({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  const auto between = [&](std::uint32_t a, std::uint32_t b) {
    return Elements{edge(find_halfedge(fan, Vertex(a), Vertex(b)))};
  };
  EXPECT_EQ(edge_loops(fan, between(1, 2)).size(), 5u);
  EXPECT_EQ(edge_loops(fan, between(0, 2)).size(), 1u) << "both ends lie on the boundary";
  EXPECT_EQ(edge_rings(fan, between(1, 2)).size(), 1u) << "a triangle has no other side";
  const Mesh quads = make_mesh(two_quads());
  std::set<std::size_t> rings;
  for (std::uint32_t i = 0; i < quads.edge_slots(); ++i) rings.insert(edge_rings(quads, Elements{Edge(i)}).size());
  EXPECT_EQ(rings, (std::set<std::size_t>{2, 3}));
}

TEST(selectors, traits_are_counted_on_points) {
  const Mesh fan = make_mesh(closed_fan(9));
  EXPECT_EQ(find("valence", fan, {}, {}, "9"), Elements{Vertex(0)});
  EXPECT_EQ(find("valence", fan, {}, {}, "..8").size(), 9u);
  EXPECT_EQ(find("valence", fan, {}, {}, "3..3").size(), 9u);
  EXPECT_EQ(find("sides", fan, {}, {}, "3..").size(), 9u);
  EXPECT_TRUE(find("sides", fan, {}, {}, "4..").empty());
  const Mesh tie = make_mesh(bow_tie());  // its knot is two copies in the kernel
  Elements knot = find("valence", tie, {}, {}, "4");
  ASSERT_EQ(knot.size(), 1u);
  EXPECT_TRUE(has_copies(tie, knot[0].vertex()));
  EXPECT_EQ(tie.copy_point(knot[0].vertex()), knot[0].vertex());
}

// A roof of two planes, each of two triangles, bent by 90 degrees at the edge 1-2.
Mesh roof() {
  IndexedMesh source = indexed({{0, 1, 2}, {0, 2, 3}, {1, 4, 2}, {4, 5, 2}});
  source.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, -1}, {1, 1, -1}};
  return from_indexed(std::move(source));
}

TEST(selectors, a_flat_region_ends_where_the_surface_bends) {
  const Mesh mesh = roof();
  EXPECT_EQ(find("flat", mesh, {Face(0)}, {}, "1"), (Elements{Face(0), Face(1)}));
  EXPECT_EQ(find("flat", mesh, {Face(3)}, {}, "89"), (Elements{Face(3), Face(2)}));
  EXPECT_EQ(find("flat", mesh, {Face(3)}, {}, "91").size(), 4u);
  const Elements bent = find("sharp", mesh, {}, {}, "30");
  ASSERT_EQ(bent.size(), 1u);
  EXPECT_EQ(bent[0], Element(edge(find_halfedge(mesh, Vertex(1), Vertex(2)))));
  EXPECT_TRUE(find("sharp", mesh, {}, {}, "91").empty());
}

TEST(selectors, shorter_and_longer_leave_out_what_is_as_long) {
  const Mesh mesh = roof();  // seven sides of length 1, two diagonals
  EXPECT_EQ(find("longer", mesh, {}, {}, "1").size(), 2u);
  EXPECT_EQ(find("shorter", mesh, {}, {}, "1").size(), 0u);
  EXPECT_EQ(find("shorter", mesh, {}, {}, "1.2").size(), 7u);
  EXPECT_EQ(find("longer", mesh, {}, {}, "1.5").size(), 0u);
}

TEST(selectors, small_parts_are_those_of_fewer_faces_or_of_less_than_a_share_of_the_largest) {
  Polygons faces = torus_grid(5, 10);
  ASSERT_EQ(faces.size(), 100u);
  for (std::vector<std::uint32_t> face : cube()) {
    for (std::uint32_t& corner : face) corner += 50;
    faces.push_back(face);
  }
  faces.push_back({58, 59, 60});
  const Mesh mesh = make_mesh(faces, 61);
  const auto count = [&](const char* value) {
    const Elements found = find("parts", mesh, {}, Element::Kind::vertex, value);
    for (const Element& e : found) EXPECT_GE(e.index, 100u) << "never of the largest";
    return found.size();
  };
  EXPECT_EQ(count("1"), 0u);
  EXPECT_EQ(count("6"), 1u) << "smaller than the cube";
  EXPECT_EQ(count("7"), 7u);
  EXPECT_EQ(count("1%"), 0u) << "one of a hundred is not less";
  EXPECT_EQ(count("1.5%"), 1u);
  EXPECT_EQ(count("100%"), 7u);
  EXPECT_EQ(find("parts", Mesh(), {}, Element::Kind::face, "5").size(), 0u);
  const Selector& parts = *find_selector("parts");
  for (const char* wrong : {"", "%", "101%", "-1%", "x%", "1..2"}) EXPECT_FALSE(parse_value(parts, wrong)) << wrong;
  EXPECT_EQ(syntax_of(parts), "parts [N|N%]");
}

TEST(selectors, values_are_numbers_from_zero_and_ranges_of_them) {
  const Selector &sides = *find_selector("sides"), &shorter = *find_selector("shorter"), &all = *find_selector("all");
  for (const char* wrong : {"", "x", "-1", "5..3", "..", "1..2..3", "nan", "3.. "})
    EXPECT_FALSE(parse_value(sides, wrong)) << wrong;
  EXPECT_FALSE(parse_value(shorter, "1..2"));
  EXPECT_FALSE(parse_value(all, "1"));
  EXPECT_TRUE(parse_value(sides, "3..5")->holds(5));
  EXPECT_FALSE(parse_value(sides, "3..5")->holds(6));
  EXPECT_TRUE(parse_value(sides, "3..")->holds(1e9));
}

TEST(selectors, say_what_must_be_selected_first) {
  for (const Selector& row : selectors()) {
    const bool needs = row.needs || row.needs_any;
    EXPECT_EQ(missing_for(row, {}).en.empty(), !needs) << row.id;
    EXPECT_EQ(missing_for(row, {}).ja.empty(), !needs) << row.id;
  }
  const Selector& loop = *find_selector("loop");
  EXPECT_FALSE(missing_for(loop, Elements{Vertex(0), Face(0)}).en.empty());
  EXPECT_TRUE(missing_for(loop, Elements{Vertex(0), Halfedge(0)}).en.empty());
}

}  // namespace
}  // namespace ryosen
