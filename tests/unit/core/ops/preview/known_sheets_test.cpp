#include "ryosen/ops/preview/remedy_candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "ryosen/ops/all.h"
#include "ryosen/ops/rules/sheets.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

// A strip of quads with a fin on every `every`-th rung, behind it a large grid.
Mesh sheets_of_all_sizes(std::uint32_t rungs, std::uint32_t every) {
  Polygons faces;
  std::uint32_t points = 2 * rungs;
  for (std::uint32_t i = 0; i + 1 < rungs; ++i) {
    faces.push_back({2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2});
    if (i % every == 1) faces.push_back({2 * i, 2 * i + 1, points++});
  }
  for (const std::vector<std::uint32_t>& face : torus_grid(30, 40)) {
    faces.emplace_back();
    for (std::uint32_t p : face) faces.back().push_back(points + p);
  }
  return make_mesh(faces);
}

// Whatever is asked first, the answer is the size of the sheet.
TEST(known_sheets, large_ones_are_those_of_a_thousand_faces_in_whichever_order_they_are_asked_for) {
  constexpr std::size_t large = 1000;
  Dice dice(3);
  for (std::uint32_t every : {998u, 1001u}) {
    const Mesh mesh = sheets_of_all_sizes(3100, every);
    std::vector<std::uint32_t> order(mesh.face_slots());
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[static_cast<std::size_t>(dice.below(static_cast<int>(i)))]);
    KnownSheets sheets;
    std::size_t found = 0;
    for (std::uint32_t f : order) {
      const bool is_large = sheets.is_large(mesh, Face(f));
      found += is_large;
      if (!test::is_long_run() && f % 3 != 0) continue;
      ASSERT_EQ(is_large, faces_of_sheet(mesh, Face(f), large).size() >= large) << "f" << f << " every " << every;
    }
    EXPECT_GE(found, large);
    EXPECT_LT(found, mesh.face_slots());
  }
}

// The faces of a sheet that touches others stand for one detachment, those of one that touches none each for its own.
TEST(known_sheets, have_one_key_for_each_detachment) {
  std::size_t alike_on_a_sheet = 0;
  for (const Polygons& faces : {fin(), bow_tie(), two_tetrahedra_on_an_edge(), tetrahedron(),
                                Polygons{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}, {4, 1, 6}, {7, 8, 9}}}) {
    const Mesh mesh = make_mesh(faces);
    const auto detached = [&](Face f) {
      Mesh copy = mesh;
      const Detach op{{f}};
      if (!op.check(copy).legal()) return polygons_of(copy);
      Edit edit(copy, nullptr);
      op.apply(edit);
      edit.commit();
      return polygons_of(copy);
    };
    KnownSheets sheets;
    for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
      const Polygons after = detached(Face(f));
      const std::vector<Face> sheet = faces_of_sheet(mesh, Face(f));
      for (std::uint32_t g = 0; g < f; ++g) {
        const bool is_alike = after == detached(Face(g));
        const bool is_same_key = sheets.key(mesh, Face(f)) == sheets.key(mesh, Face(g));
        EXPECT_TRUE(is_alike || !is_same_key) << f << " " << g;
        if (!is_alike || after == polygons_of(mesh) || std::find(sheet.begin(), sheet.end(), Face(g)) == sheet.end())
          continue;
        EXPECT_TRUE(is_same_key) << f << " " << g;
        ++alike_on_a_sheet;
      }
    }
    EXPECT_EQ(sheets.key(mesh, Face(0)) == sheets.key(mesh, Face(1)), faces.size() == 8) << "two tetrahedra on an edge";
  }
  EXPECT_GT(alike_on_a_sheet, 0u);
}

}  // namespace
}  // namespace ryosen
