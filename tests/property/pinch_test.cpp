// The warning that a surface is pinched, against the lists of faces before and after any operator.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/proof.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

using CornerSides = std::set<Vertex>;  // the two points beside it
using CornersByPoint = std::map<Vertex, std::vector<CornerSides>>;

CornersByPoint corners_of(const Mesh& m) {
  CornersByPoint corners;
  for (std::uint32_t i = 0; i < m.face_slots(); ++i)
    if (m.is_alive(Face(i)))
      for (Halfedge h : halfedges_around(m, Face(i)))
        corners[point(m, m.from(h))].push_back({point(m, m.from(m.prev(h))), point(m, m.to(h))});
  return corners;
}

// Corners that share a neighbour are one fan, found by merging sets until none meet.
std::size_t fans_of(std::vector<CornerSides> groups) {
  for (bool merged = true; merged;) {
    merged = false;
    for (std::size_t i = 0; i < groups.size() && !merged; ++i)
      for (std::size_t j = i + 1; j < groups.size() && !merged; ++j) {
        if (std::none_of(groups[i].begin(), groups[i].end(), [&](Vertex v) { return groups[j].contains(v); })) continue;
        groups[i].insert(groups[j].begin(), groups[j].end());
        groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(j));
        merged = true;
      }
  }
  return groups.size();
}

// The points, as they were, that are the point p now: seen from the corners that faces keep.
std::set<Vertex> origins(const Mesh& before, const Mesh& after, Vertex p) {
  std::set<Vertex> found;
  if (before.exists(p) && before.is_alive(p)) found.insert(point(before, p));
  for (std::uint32_t i = 0; i < before.face_slots(); ++i) {
    const Face f(i);
    if (!before.is_alive(f) || !after.is_alive(f)) continue;
    std::vector<Vertex> old_points, new_points;
    for (Vertex v : vertices_around(before, f)) old_points.push_back(point(before, v));
    for (Vertex v : vertices_around(after, f)) new_points.push_back(point(after, v));
    if (old_points.size() != new_points.size()) continue;
    for (std::size_t k = 0; k < new_points.size(); ++k)
      if (new_points[k] == p) found.insert(old_points[k]);
  }
  return found;
}

// The points that have more fans than any of those that they come from, and there were some.
std::set<Vertex> pinched(const Mesh& before, const Mesh& after) {
  CornersByPoint old_corners = corners_of(before);
  std::set<Vertex> found;
  for (const auto& [p, corners] : corners_of(after)) {
    std::size_t most = 0;
    for (Vertex q : origins(before, after, p)) most = std::max(most, fans_of(old_corners[q]));
    if (most > 0 && fans_of(corners) > most) found.insert(p);
  }
  return found;
}

std::set<Vertex> warned(const Mesh& mesh, const AnyOp& op) {
  std::set<Vertex> found;
  for (const Reason& reason : warnings(mesh, op))
    if (reason.rule == Rule::pinch)
      for (const Element& e : reason.witnesses) found.insert(e.vertex());
  return found;
}

// A point that was split off is warned about under the number that it had.
std::set<Vertex> by_old_numbers(const Mesh& before, const Mesh& after, const std::set<Vertex>& points) {
  std::set<Vertex> found;
  for (Vertex p : points) {
    const bool is_old = before.exists(p) && before.is_alive(p) && point(before, p) == p;
    const std::set<Vertex> from = origins(before, after, p);
    found.insert(is_old || from.empty() ? p : *from.begin());
  }
  return found;
}

// A face and a round of three wires that meet at vertex 0.
Mesh face_and_round_of_wires() {
  Mesh mesh = make_mesh({{0, 1, 2}}, 5);
  for (const char* line : {"make_edge 0 3", "make_edge 3 4"}) apply_and_prove(mesh, line);
  apply_and_prove(mesh, "make_edge 4 0 3-4 3-0");
  return mesh;
}

TEST(pinch, is_warned_of_where_a_point_gets_more_fans_and_nowhere_else) {
  std::map<std::string, std::size_t> count;
  const std::uint64_t seeds = seed_count(50, 160), with_wires = is_long_run() ? 10 : 5;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    Mesh first = seed < seeds - with_wires ? random_complex(seed) : face_and_round_of_wires();
    Dice dice(seed);
    for (std::size_t place = 0; place < all_ops().size(); ++place)
      for (int i = 0; i < 12; ++i) {
        const AnyOp op = random_op(first, place, dice);
        if (!check(first, op).legal()) continue;
        Mesh after = first;
        ASSERT_TRUE(try_apply(after, nullptr, op));
        const std::set<Vertex> points = by_old_numbers(first, after, pinched(first, after));
        ASSERT_EQ(warned(first, op), points) << "seed " << seed << ": " << command_of(first, op);
        if (!points.empty()) ++count[std::string(info_of(op).id)];
      }
    for (int i = 0; i < 6; ++i) try_apply(first, nullptr, random_op(first, dice));
  }
  for (const char* id : {"make_face", "weld", "detach", "delete", "delete_loop", "make_loop", "fill"})
    EXPECT_GT(count[id], 0u) << id;
}

std::string pinches(const Mesh& mesh, const std::string& line) {
  std::string names;
  for (Vertex v : warned(mesh, op_of(mesh, line))) names += " " + name_of(mesh, v);
  return names;
}

TEST(pinch, a_face_on_a_vertex_alone) {
  const Mesh one = make_mesh({{0, 1, 2}}, 5);
  EXPECT_EQ(pinches(one, "make_face 0 3 4"), " v0");
  EXPECT_EQ(pinches(one, "make_face 1 0 3"), "") << "beside the face";
  const Mesh loose = make_mesh({}, 3);
  EXPECT_EQ(pinches(loose, "make_face 0 1 2"), "") << "no faces there yet";
}

TEST(pinch, faces_on_wires) {
  const Mesh mesh = face_and_round_of_wires();
  EXPECT_EQ(pinches(mesh, "make_loop 0-3") + pinches(mesh, "make_loop 3-0"), " v0");
  EXPECT_EQ(pinches(mesh, "fill 0-3") + pinches(mesh, "fill 3-0"), " v0");
}

TEST(pinch, what_is_taken_out_of_the_middle) {
  const Mesh strip = make_mesh({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  EXPECT_EQ(pinches(strip, "delete f1"), " v0");
  EXPECT_EQ(pinches(strip, "delete_loop f1"), " v0");
  EXPECT_EQ(pinches(strip, "detach f1"), " v0");
  EXPECT_EQ(pinches(strip, "delete f0"), "");
  EXPECT_EQ(pinches(strip, "delete 0-2"), "");
}

TEST(pinch, welded_points) {
  EXPECT_EQ(pinches(make_mesh({{0, 1, 2}, {3, 4, 5}}), "weld 5 1"), " v1");
  EXPECT_EQ(pinches(make_mesh({{0, 1, 2}, {1, 3, 5}}), "weld 2 5"), "") << "across a gap of two edges";
  EXPECT_EQ(pinches(make_mesh({{0, 1, 2}, {4, 3, 5}}), "weld 1-2 4-5"), "");
  EXPECT_EQ(pinches(make_mesh(bow_tie()), "weld v0@f0 v0@f1"), "") << "two fans before and after";
}

}  // namespace
}  // namespace ryosen
