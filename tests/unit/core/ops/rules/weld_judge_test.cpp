#include "ryosen/ops/rules/weld_judge.h"

#include <gtest/gtest.h>

#include "ryosen/mesh/copies.h"
#include "ryosen/ops/weld.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

Polygons tetrahedra(std::uint32_t n) {
  Polygons faces;
  for (std::uint32_t i = 0; i < 4 * n; i += 4)
    for (const auto& [a, b, c] :
         {std::tuple(i, i + 1, i + 2), {i, i + 2, i + 3}, {i, i + 3, i + 1}, {i + 1, i + 3, i + 2}})
      faces.push_back({a, b, c});
  return faces;
}

// One corner of each is welded into the last, whose faces become more each time; the others are refused.
std::uint64_t looks_at(std::uint32_t n) {
  Mesh mesh = make_mesh(tetrahedra(n), 4 * n);
  std::uint64_t looks = 0;
  std::size_t refused = 0;
  const Vertex last(4 * n - 1);
  for (std::uint32_t i = 0; i + 4 < 4 * n; ++i) {
    Verdict verdict;
    judge_weld(mesh, {{point(mesh, Vertex(i)), point(mesh, last)}}, verdict, &looks);
    refused += !verdict.legal();
    if (!verdict.legal()) continue;
    Edit edit(mesh, nullptr);
    Weld{last, Vertex(i), {}, {}}.apply(edit);
    edit.commit();
  }
  EXPECT_EQ(refused, 3 * (n - 1)) << "the rest of each tetrahedron";
  return looks;
}

TEST(weld_judge, looks_at_what_is_near_the_smaller_point) {
  const std::uint64_t small = looks_at(50);
  EXPECT_GT(small, 500u);
  EXPECT_LE(looks_at(100), 5 * small / 2) << "twice as much";
  EXPECT_LE(looks_at(200), 5 * small) << "four times as much";
}

}  // namespace
}  // namespace ryosen
