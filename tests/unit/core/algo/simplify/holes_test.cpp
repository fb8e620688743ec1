// Holes of a sheet do not grow where it is simplified.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "tests/support/core/simplified.h"

namespace ryosen::test {
namespace {

constexpr std::uint32_t side = 40;

double hills(double x, double y) { return 4 * std::sin(0.13 * x) * std::cos(0.17 * y); }

// The sheet without the triangles that have a hole at their square; `upper` tells the second half of one.
Mesh holed_sheet(const std::function<bool(std::uint32_t x, std::uint32_t y, bool upper)>& is_hole) {
  IndexedMesh source;
  for (std::uint32_t y = 0; y <= side; ++y)
    for (std::uint32_t x = 0; x <= side; ++x) source.positions.emplace_back(x, y, hills(x, y));
  const auto at = [](std::uint32_t x, std::uint32_t y) { return y * (side + 1) + x; };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    source.corners.insert(source.corners.end(), {a, b, c});
    source.face_offsets.push_back(static_cast<std::uint32_t>(source.corners.size()));
  };
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      if (!is_hole(x, y, false)) add(at(x, y), at(x + 1, y), at(x + 1, y + 1));
      if (!is_hole(x, y, true)) add(at(x, y), at(x + 1, y + 1), at(x, y + 1));
    }
  return from_indexed(source);
}

// The length and the area of each loop of outside halfedges as seen from above.
struct Hole {
  double length = 0, area = 0;
};
std::vector<Hole> holes_of(const Mesh& mesh) {
  std::vector<Hole> holes;
  std::vector<std::uint8_t> is_seen(mesh.halfedge_slots());
  for (const Edge e : live_edges(mesh))
    for (const Halfedge first : {halfedge(e), twin(halfedge(e))}) {
      if (!mesh.is_outside(first) || is_seen[first.index]) continue;
      Hole hole;
      for (const Halfedge h : loop(mesh, first)) {
        is_seen[h.index] = 1;
        const glm::dvec3 &a = mesh.position(mesh.from(h)), &b = mesh.position(mesh.to(h));
        hole.length += glm::distance(a, b);
        hole.area += (a.x * b.y - a.y * b.x) / 2;
      }
      hole.area = std::abs(hole.area);
      holes.push_back(hole);
    }
  return holes;
}

struct Pattern {
  const char* name;
  std::function<bool(std::uint32_t x, std::uint32_t y, bool upper)> is_hole;
};

const Pattern patterns[] = {
    {"triangles", [](auto x, auto y, bool upper) { return upper && x % 10 == 5 && y % 10 == 5; }},
    {"squares", [](auto x, auto y, bool) { return x % 10 == 5 && y % 10 == 5; }},
    {"four squares", [](auto x, auto y, bool) { return x % 12 > 9 && y % 12 > 9; }},
    {"slits", [](auto x, auto y, bool) { return x % 12 > 5 && x % 12 < 11 && y % 12 == 6; }},
    {"at the rim", [](auto x, auto y, bool) { return x % 10 == 5 && (y == 1 || y == side - 2); }},
    {"one alone", [](auto x, auto y, bool upper) { return !upper && x == 20 && y == 20; }}};

TEST(SimplifyHoles, do_not_grow) {
  for (const Pattern& pattern : patterns)
    for (const char* const goal : {"ratio=0.1", "ratio=0.04", "ratio=0.02"})
      for (const char* const effort : {" effort=0", " effort=2"}) {
        Mesh mesh = holed_sheet(pattern.is_hole);
        const std::vector<Hole> before = holes_of(mesh);
        simplified(mesh, std::string(goal) + effort);
        const std::vector<Hole> after = holes_of(mesh);
        ASSERT_EQ(after.size(), before.size()) << pattern.name << goal << effort;
        // The rim of the sheet is by far the longest.
        const auto largest = [](const std::vector<Hole>& holes) {
          std::vector<Hole> inner = holes;
          std::sort(inner.begin(), inner.end(), [](const Hole& a, const Hole& b) { return a.length < b.length; });
          inner.pop_back();
          Hole most;
          for (const Hole& hole : inner) {
            most.length = std::max(most.length, hole.length);
            most.area = std::max(most.area, hole.area);
          }
          return most;
        };
        EXPECT_LE(largest(after).length, 1.05 * largest(before).length) << pattern.name << goal << effort;
        EXPECT_LE(largest(after).area, 1.05 * largest(before).area + 1e-9) << pattern.name << goal << effort;
      }
}

// Beyond that it stops, says so and goes on by force; where nothing else holds an edge than the structure, it says
// that.
TEST(SimplifyHoles, end_it_where_they_would_grow) {
  for (const Pattern& pattern : patterns)
    for (const char* const effort : {" effort=0", " effort=1"}) {
      Mesh held = holed_sheet(pattern.is_hole), forced = held, locked = held;
      const AlgorithmResult stopped = simplified(held, std::string("faces=4") + effort);
      const AlgorithmResult further = simplified(forced, std::string("faces=4 force=on") + effort);
      EXPECT_EQ(further.goal_report->stopped == Stop::blocked, !further.goal_report->is_reached) << pattern.name;
      if (forced.live().faces < held.live().faces) {
        EXPECT_EQ(stopped.goal_report->stopped, Stop::shape) << pattern.name << effort;
        EXPECT_NE(stopped.text.en.find("force goes on"), std::string::npos) << stopped.text.en;
      }
      const AlgorithmResult at_rim = simplified(locked, std::string("faces=4 boundary=locked") + effort);
      EXPECT_EQ(at_rim.text.en.find("draw a boundary out"), std::string::npos) << at_rim.text.en;
    }
  Mesh mesh = holed_sheet(patterns[1].is_hole);
  const AlgorithmResult result = simplified(mesh, "faces=4 effort=0");
  EXPECT_NE(result.text.en.find("draw a boundary out"), std::string::npos) << result.text.en;
}

}  // namespace
}  // namespace ryosen::test
