// Remeshing of many equal parts on one place: of each comes what comes of one alone.
#include <gtest/gtest.h>

#include <set>

#include "ryosen/indexed/from_indexed.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/run_algorithm.h"

namespace ryosen::test {
namespace {

// A part so many times over, each with points of its own.
IndexedMesh copies_of(const IndexedMesh& part, std::uint32_t count) {
  IndexedMesh all;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
    for (std::size_t f = 0; f < part.face_count(); ++f) {
      for (const std::uint32_t corner : part.face(f)) all.corners.push_back(first + corner);
      all.face_offsets.push_back(static_cast<std::uint32_t>(all.corners.size()));
    }
  }
  return all;
}

IndexedMesh part_of(std::vector<glm::dvec3> positions, std::vector<std::uint32_t> corners) {
  IndexedMesh part;
  part.positions = std::move(positions);
  for (std::size_t i = 3; i <= corners.size(); i += 3) part.face_offsets.push_back(static_cast<std::uint32_t>(i));
  part.corners = std::move(corners);
  return part;
}

Mesh remeshing_of(const IndexedMesh& source, const std::string& words) {
  Mesh mesh = from_indexed(source);
  Journal journal;
  const AlgorithmResult result = run_algorithm(mesh, journal, "remesh " + words);
  EXPECT_FALSE(result.fault) << words;
  return mesh;
}

std::set<std::array<double, 3>> places_in(const Mesh& mesh) {
  std::set<std::array<double, 3>> places;
  for (Vertex v(0); v.index < mesh.vertex_slots(); ++v.index)
    if (mesh.is_alive(v)) places.insert({mesh.position(v).x, mesh.position(v).y, mesh.position(v).z});
  return places;
}

TEST(RemeshEqual, of_each_part_comes_what_comes_of_one) {
  struct Case {
    IndexedMesh part;
    std::uint32_t many, few;  // parts in a long run and in a short one
    const char* words;
  };
  const std::vector<std::uint32_t> one{0, 1, 2};
  for (const Case& c : {
           Case{part_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, one), 300, 50, "length=20%"},
           {part_of({{0, 0, 0}, {3, 0.1, 0}, {1.5, 1, 0}}, one), 30, 12, "length=25%"},
           {part_of({{1e6, 2, 3}, {1e6 + 1, 3, 3.5}, {1e6 - 0.3, 2.2, 5}}, one), 60, 20, "length=25% adaptive=on"},
           {part_of({{0, 0, 0}, {1e-7, 0, 1e-8}, {4e-8, 9e-8, 0}}, one), 60, 20, "length=30% rounds=2"},
           {part_of({{0, 0, 0}, {1, 0, 0}, {1.2, 1, 0.1}, {0, 1, 0}}, {0, 1, 2, 0, 2, 3}), 20, 8, "length=15%"},
           {part_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}), 15, 6,
            "length=20%"},
       }) {
    SCOPED_TRACE(c.words);
    const std::uint32_t count = is_long_run() ? c.many : c.few;
    const Mesh alone = remeshing_of(c.part, c.words), all = remeshing_of(copies_of(c.part, count), c.words);
    EXPECT_GT(alone.live().faces, c.part.face_count());
    EXPECT_EQ(all.live().faces, count * alone.live().faces);
    EXPECT_EQ(all.live().vertices, count * alone.live().vertices);
    EXPECT_EQ(places_in(all), places_in(alone));
  }
}

TEST(RemeshEqual, of_equal_triangles_of_a_report) {
  const IndexedMesh soup = report_list("equalsoup_500.obj");
  IndexedMesh one;
  one.positions.assign(soup.positions.begin(), soup.positions.begin() + 3);
  one.corners = {0, 1, 2};
  one.face_offsets = {0, 3};
  EXPECT_EQ(remeshing_of(soup, "length=20%").live().faces, 500 * remeshing_of(one, "length=20%").live().faces);
}

}  // namespace
}  // namespace ryosen::test
