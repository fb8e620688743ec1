// Faces with rings: recognised in files, written back as they were, and bridged anew after edits.
#include "ryosen/indexed/bridged_corners.h"

#include <gtest/gtest.h>

#include <glm/vec2.hpp>
#include <random>

#include "ryosen/analysis/euler_poincare.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/bridges.h"
#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/all.h"

namespace ryosen {
namespace {

// A square plate with square holes in a row, its front face one bridged list and nothing else.
IndexedMesh plate(std::uint32_t holes) {
  IndexedMesh m;
  const double width = 2.0 * holes + 1;
  m.positions = {{0, 0, 0}, {width, 0, 0}, {width, 3, 0}, {0, 3, 0}};
  m.corners = {0, 1, 2, 3};
  std::uint32_t anchor = 0;
  for (std::uint32_t i = 0; i < holes; ++i) {
    const double x = 1 + 2.0 * i;
    const auto first = static_cast<std::uint32_t>(m.positions.size());
    for (const glm::dvec3& p :
         {glm::dvec3(x, 1, 0), glm::dvec3(x, 2, 0), glm::dvec3(x + 1, 2, 0), glm::dvec3(x + 1, 1, 0)})
      m.positions.push_back(p);
    // From the corner met last: over the bridge, around the hole, and back.
    std::vector<std::uint32_t> detour{first, first + 1, first + 2, first + 3, first, anchor};
    const auto place = std::find(m.corners.begin(), m.corners.end(), anchor);
    m.corners.insert(place + 1, detour.begin(), detour.end());
    anchor = first;
  }
  m.face_offsets.push_back(static_cast<std::uint32_t>(m.corners.size()));
  m.bridged = {0};
  return m;
}

TEST(bridged_corners, a_plate_with_holes_is_one_face_with_rings) {
  for (std::uint32_t holes : {1u, 2u, 5u}) {
    const IndexedMesh source = plate(holes);
    const FileTables tables = file_tables(source);
    const Mesh mesh = from_indexed(source);
    ASSERT_FALSE(check_invariants(mesh)) << check_invariants(mesh)->sentence;
    EXPECT_EQ(mesh.live().rings, holes);
    EXPECT_EQ(mesh.live().edges, 4 + 4 * holes);
    const Figures figures = compute_figures(mesh);
    EXPECT_EQ(figures.rings, holes);
    EXPECT_EQ(figures.corners, source.corners.size());
    EXPECT_EQ(figures.boundary_loops, 1 + holes);
    EXPECT_EQ(figures.components, 1u);
    EXPECT_EQ(figures.euler_characteristic, 1 - static_cast<std::int64_t>(holes));
    EXPECT_NEAR(figures.area, 3 * (2.0 * holes + 1) - holes, 1e-12);
    const EulerPoincare e = euler_poincare(mesh);
    EXPECT_TRUE(e.holds());
    const IndexedMesh back = to_indexed(mesh, tables).mesh;
    EXPECT_EQ(back.corners, source.corners) << "written as read";
    EXPECT_EQ(back.bridged, source.bridged);
  }
}

TEST(bridged_corners, new_bridges_cross_nothing_and_read_back) {
  for (std::uint32_t holes : {1u, 2u, 3u, 7u}) {
    const Mesh mesh = from_indexed(plate(holes));
    const IndexedMesh written = to_indexed(mesh).mesh;  // without the file's lists
    CornerLoops list;
    list.add(written.face(0));
    const auto parts = take_out_bridges(list);
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->size(), holes + 1);
    const Mesh again = from_indexed(written);
    EXPECT_EQ(again.hash(), mesh.hash());
  }
}

TEST(bridged_corners, an_edited_face_gets_new_bridges) {
  const IndexedMesh source = plate(2);
  const FileTables tables = file_tables(source);
  Mesh mesh = from_indexed(source);
  Journal journal;
  {
    Edit edit(mesh, &journal);
    ryosen::apply(edit, *parse_line(mesh, "split 4-5").op);  // a side of the first hole
    edit.commit();
  }
  ASSERT_FALSE(check_invariants(mesh));
  EXPECT_EQ(mesh.live().faces, 1u);
  const IndexedMesh written = to_indexed(mesh, tables).mesh;
  EXPECT_NE(written.corners, source.corners);
  EXPECT_EQ(from_indexed(written).hash(), mesh.hash());
  journal.undo(mesh);
  EXPECT_EQ(to_indexed(mesh, tables).mesh.corners, source.corners);
}

// A bridge put into the mesh is the user's choice: the list that the file had, which has another one, does not undo it.
TEST(bridged_corners, a_bridge_in_the_mesh_is_written_and_one_that_the_file_had_changes_nothing) {
  const IndexedMesh source = plate(2);
  const FileTables tables = file_tables(source);
  const auto written_after = [&](std::initializer_list<const char*> lines) {
    Mesh mesh = from_indexed(source);
    for (const char* line : lines) {
      Edit edit(mesh, nullptr);
      ryosen::apply(edit, *parse_line(mesh, line).op);
      edit.commit();
    }
    return to_indexed(mesh, tables).mesh.corners;
  };
  const auto walks = [](const std::vector<std::uint32_t>& list, std::uint32_t a, std::uint32_t b) {
    for (std::size_t i = 0; i < list.size(); ++i)
      if (list[i] == a && list[(i + 1) % list.size()] == b) return true;
    return false;
  };
  EXPECT_TRUE(walks(source.corners, 0, 4) && !walks(source.corners, 3, 5));
  const auto other = written_after({"unite_ring 3 5"});
  EXPECT_TRUE(walks(other, 3, 5) && walks(other, 5, 3));
  EXPECT_EQ(other.size(), source.corners.size()) << "the second hole has a bridge too";
  EXPECT_EQ(written_after({"unite_ring 0 4"}), source.corners);
  EXPECT_EQ(written_after({"unite_ring 3 5", "make_ring 3-5"}), source.corners)
      << "the loops are those of the file again";
}

TEST(take_out_bridges, refuses_what_is_no_face_with_rings) {
  const auto parts = [](std::vector<std::uint32_t> corners) {
    CornerLoops list;
    list.add(corners);
    return take_out_bridges(list);
  };
  EXPECT_TRUE(parts({0, 1, 2}));
  EXPECT_TRUE(parts({0, 4, 5, 6, 4, 0, 1, 2, 3}));
  EXPECT_FALSE(parts({0, 1, 2, 0, 3, 4})) << "a repeated corner without a bridge";
  EXPECT_FALSE(parts({0, 1, 2, 1})) << "a dangling edge";
  EXPECT_FALSE(parts({0, 4, 5, 4, 0, 1, 2})) << "a ring of two corners";
  EXPECT_FALSE(parts({0, 1})) << "two corners";
  EXPECT_FALSE(parts({0, 4, 5, 6, 4, 0, 6, 1, 2})) << "loops that share a vertex";
  EXPECT_FALSE(parts({0, 7, 4, 5, 6, 4, 7, 0, 1, 2})) << "a bridge of two edges leaves a vertex that is in no loop";
}

// A corner at which very many bridges end costs no more than others: were it looked at anew for each, this would take
// minutes.
TEST(take_out_bridges, many_bridges_at_one_corner) {
  CornerLoops spikes, rings;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 1; i <= 200'000; ++i) corners.insert(corners.end(), {0, i});
  spikes.add(corners);
  EXPECT_FALSE(take_out_bridges(spikes));
  corners = {0, 1, 2};
  for (std::uint32_t first = 3; first <= 3 + 3 * 2000; first += 3)
    corners.insert(corners.begin(), {0, first, first + 1, first + 2, first});
  rings.add(corners);
  const auto parts = take_out_bridges(rings);
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->size(), 2002u);
}

// Random holes in a large square on a grid of cells: whatever is bridged crosses nothing and comes apart again.
TEST(bridged_corners, random_holes) {
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round) {
    IndexedMesh m;
    const int cells = 2 + static_cast<int>(random() % 6);
    const double size = 4.0 * cells;
    m.positions = {{0, 0, 1}, {size, 0, 1}, {size, size, 1}, {0, size, 1}};
    std::vector<std::vector<std::uint32_t>> rings;
    for (int cell = 0; cell < cells * cells; ++cell) {
      if (random() % 2) continue;
      const double x = 4 * (cell % cells) + 1, y = 4 * (cell / cells) + 1;
      rings.emplace_back();
      const auto shift = [&] { return static_cast<double>(random() % 8) / 8; };
      for (const glm::dvec2& p : {glm::dvec2(0, 0), glm::dvec2(0, 2), glm::dvec2(2, 2), glm::dvec2(2, 0)}) {
        rings.back().push_back(static_cast<std::uint32_t>(m.positions.size()));
        m.positions.push_back({x + p.x * (0.6 + 0.4 * shift()), y + p.y * (0.6 + 0.4 * shift()), 1});
      }
    }
    // Connected through the kernel: the face, and the rings by any bridges at all.
    m.corners = {0, 1, 2, 3};
    std::vector<std::uint32_t> detours;
    for (const auto& ring : rings) {
      detours.insert(detours.end(), ring.begin(), ring.end());
      detours.insert(detours.end(), {ring[0], 0});
    }
    m.corners.insert(m.corners.begin() + 1, detours.begin(), detours.end());
    m.face_offsets.push_back(static_cast<std::uint32_t>(m.corners.size()));
    if (!rings.empty()) m.bridged = {0};
    const Mesh mesh = from_indexed(m);
    ASSERT_FALSE(check_invariants(mesh));
    const IndexedMesh written = to_indexed(mesh).mesh;
    EXPECT_EQ(from_indexed(written).hash(), mesh.hash());
    // No two sides of the written list cross, bridges included.
    const auto face = written.face(0);
    const auto at = [&](std::size_t i) { return written.positions[face[i % face.size()]]; };
    const auto side = [](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
      return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    for (std::size_t i = 0; i < face.size(); ++i)
      for (std::size_t j = i + 1; j < face.size(); ++j) {
        const bool cross = side(at(i), at(i + 1), at(j)) * side(at(i), at(i + 1), at(j + 1)) < 0 &&
                           side(at(j), at(j + 1), at(i)) * side(at(j), at(j + 1), at(i + 1)) < 0;
        EXPECT_FALSE(cross) << round;
      }
  }
}

}  // namespace
}  // namespace ryosen
