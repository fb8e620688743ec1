#include "core/ops/remedy_candidates.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/ops/sheets.h"
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
TEST(large_sheets, are_those_of_a_thousand_faces_in_whichever_order_they_are_asked_for) {
  constexpr std::size_t large = 1000;
  Dice dice(3);
  for (std::uint32_t every : {3u, 998u, 1000u, 1001u, 1500u}) {
    const Mesh mesh = sheets_of_all_sizes(3100, every);
    std::vector<std::uint32_t> order(mesh.face_slots());
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[static_cast<std::size_t>(dice.below(static_cast<int>(i)))]);
    LargeSheets sheets;
    std::size_t found = 0;
    for (std::uint32_t f : order) {
      const bool is_large = faces_of_sheet(mesh, Face(f), large).size() >= large;
      ASSERT_EQ(sheets.contains(mesh, Face(f)), is_large) << "f" << f << " every " << every;
      found += is_large;
    }
    EXPECT_GE(found, large);
    EXPECT_LT(found, mesh.face_slots());
  }
}

}  // namespace
}  // namespace ryosen
