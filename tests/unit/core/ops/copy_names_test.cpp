// The name that a copy of a point is printed with is read as that copy: its number and a face, its number alone where
// it has no face.
#include <gtest/gtest.h>

#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/all.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

std::size_t count_read_back(const Mesh& mesh, bool has_face) {
  std::size_t found = 0;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const Vertex v(i);
    if (!mesh.is_alive(v) || !has_copies(mesh, v)) continue;
    const std::string name = name_of_copy(mesh, v);
    if ((name.find('@') != name.npos) != has_face) continue;
    ++found;
    const auto read = parse_line(mesh, "dissolve " + name);
    const Dissolve* op = read.op ? std::get_if<Dissolve>(&*read.op) : nullptr;
    EXPECT_TRUE(op && op->vertex == v) << name << ": " << read.sentence.en;
  }
  return found;
}

// Triangles on few points, changed by random operators, which leave copies with wires alone.
Mesh random_sheets(std::uint64_t seed) {
  Dice dice(seed);
  const auto points = static_cast<std::uint32_t>(4 + dice.below(4));
  std::vector<std::vector<std::uint32_t>> triangles;
  for (int i = 0; i < 12; ++i) {
    const auto a = static_cast<std::uint32_t>(dice.below(static_cast<int>(points)));
    triangles.push_back({a, (a + 1) % points, (a + 2 + static_cast<std::uint32_t>(dice.below(2))) % points});
  }
  Mesh mesh = test::make_mesh(triangles, points);
  for (int i = 0; i < 12; ++i) test::try_apply(mesh, nullptr, test::random_op(mesh, dice));
  return mesh;
}

TEST(copy_names, are_read_as_they_are_printed) {
  std::size_t with_face = 0, without_face = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = seed % 2 == 0 ? test::random_complex(seed) : random_sheets(seed);
    with_face += count_read_back(mesh, true);
    without_face += count_read_back(mesh, false);
  }
  EXPECT_GT(with_face, 50u);
  EXPECT_GT(without_face, 10u);
}

// Of a point with several sheets the number alone says no copy that has a face.
TEST(copy_names, without_a_face_are_ambiguous_for_copies_with_one) {
  std::size_t asked = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Mesh mesh = test::random_complex(seed);
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
      const Vertex v(i);
      if (!mesh.is_alive(v) || !has_copies(mesh, v) || name_of_copy(mesh, v).find('@') == std::string::npos) continue;
      ++asked;
      EXPECT_EQ(parse_line(mesh, "dissolve " + name_of(mesh, v)).error, NameError::ambiguous) << seed << " v" << i;
    }
  }
  EXPECT_GT(asked, 50u);
}

}  // namespace
}  // namespace ryosen
