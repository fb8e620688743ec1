// Vertices of a simplified surface move nearer to the input, and where nothing is nearer, or something holds them, they
// stay where they are to the bit.
#include "ryosen/algo/simplify/nearer_moves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "ryosen/algo/simplify/simplifier.h"
#include "ryosen/analysis/measure/distance.h"
#include "ryosen/base/parallel.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/live_elements.h"
#include "tests/support/core/asset_mesh.h"
#include "tests/support/core/simplified.h"

namespace ryosen::test {
namespace {

double rms_between(const Mesh& a, const Mesh& b) {
  Progress unheard;
  return surface_distance(a, b, {.gap = 1, .samples = 20000}, unheard)->rms;
}

struct Made {
  Mesh mesh;
  std::size_t moves;
};

// With the input vertices move, without it they do not.
Made collapsed(const Mesh& input, std::size_t faces, bool knows_input, const CollapseLimits& limits = {},
               unsigned effort = 1) {
  Made made{input, 0};
  Progress unheard;
  Simplifier simplifier(made.mesh, limits, {.faces = faces, .effort = effort}, nullptr, knows_input ? &input : nullptr);
  EXPECT_TRUE(simplifier.run(unheard));
  made.moves = simplifier.moves();
  return made;
}

TEST(nearer_moves, bring_round_surfaces_nearer) {
  for (const char* const shape : {"sphere", "torus", "ball"})
    for (const std::size_t divisor : {2u, 5u, 10u}) {
      Mesh input = std::string(shape) == "ball" ? asset_mesh("ball.off") : made_by(shape);
      Edit edit(input, nullptr);
      Triangulate{}.apply(edit);
      edit.commit();
      const std::size_t faces = input.live().faces / divisor;
      const Made moved = collapsed(input, faces, true), stayed = collapsed(input, faces, false);
      EXPECT_GT(moved.moves, 0u) << shape;
      EXPECT_EQ(moved.mesh.live(), stayed.mesh.live());
      EXPECT_LT(rms_between(input, moved.mesh), 0.95 * rms_between(input, stayed.mesh)) << shape << " " << divisor;
    }
}

TEST(nearer_moves, bring_a_bumpy_sheet_nearer_and_leave_its_boundary) {
  const Mesh input = sheet(40, bump);
  const Made moved = collapsed(input, 300, true), stayed = collapsed(input, 300, false);
  EXPECT_LT(rms_between(input, moved.mesh), 0.9 * rms_between(input, stayed.mesh));
  for (const Vertex v : live_vertices(stayed.mesh))
    if (stayed.mesh.is_boundary(v)) {
      EXPECT_EQ(moved.mesh.position(v), stayed.mesh.position(v));
    }
}

TEST(nearer_moves, leave_flat_shapes_as_they_are) {
  const Mesh flat = sheet(20, [](std::uint32_t, std::uint32_t) { return 0.0; });
  const Mesh roof = sheet(20, [](std::uint32_t x, std::uint32_t) { return x < 10 ? 0.5 * x : 10 - 0.5 * x; });
  const Mesh fold = sheet(20, [](std::uint32_t x, std::uint32_t y) { return 1.0 * std::max(x, y) - std::min(x, y); });
  for (const Mesh* const input : {&flat, &roof, &fold})
    for (const std::size_t faces : {400u, 100u, 40u}) {
      const Made moved = collapsed(*input, faces, true), stayed = collapsed(*input, faces, false);
      ASSERT_LT(rms_between(*input, stayed.mesh), 1e-12);
      EXPECT_EQ(moved.moves, 0u) << faces;
      EXPECT_TRUE(moved.mesh.columns() == stayed.mesh.columns()) << faces;
    }
}

TEST(nearer_moves, leave_what_is_held) {
  const Mesh input = sheet(30, bump);
  CollapseLimits limits;
  limits.fixed.assign(input.vertex_slots(), 0);
  for (std::uint32_t i = 0; i < input.vertex_slots(); i += 3) limits.fixed[i] = 1;
  const Made moved = collapsed(input, 800, true, limits);
  EXPECT_GT(moved.moves, 0u);
  for (std::uint32_t i = 0; i < input.vertex_slots(); i += 3)
    if (moved.mesh.is_alive(Vertex(i))) {
      EXPECT_EQ(moved.mesh.position(Vertex(i)), input.position(Vertex(i)));
    }
}

TEST(nearer_moves, stay_within_the_error) {
  for (const double error : {0.01, 0.05, 0.2}) {
    Mesh mesh = sheet(30, bump);
    const Mesh input = mesh;
    Simplifier simplifier(mesh, {.error = error}, {}, nullptr, &input);
    Progress unheard;
    EXPECT_TRUE(simplifier.run(unheard));
    EXPECT_GT(simplifier.moves(), 0u);
    EXPECT_LE(simplifier.error_max(), error);
  }
}

TEST(nearer_moves, are_the_same_for_any_number_of_threads) {
  const Mesh input = sheet(60, bump);
  for (const unsigned effort : {1u, 2u}) {
    std::optional<MeshColumns> first;
    for (const unsigned threads : {1u, 2u, 5u}) {
      const ThreadCount count(threads);
      const Made made = collapsed(input, 700, true, {}, effort);
      if (!first) first = made.mesh.columns();
      EXPECT_EQ(made.mesh.columns(), *first) << threads;
    }
  }
}

TEST(nearer_moves, leave_lines_of_groups_and_seams) {
  Mesh mesh = sheet(30, bump);
  Edit edit(mesh, nullptr);
  const std::size_t group =
      edit.add_attribute(attribute_names::group, ElementKind::face, ValueRule::first, std::uint32_t{1});
  for (const Face f : live_faces(mesh)) {
    const std::uint32_t side = mesh.position(mesh.from(mesh.halfedge(f))).x < 15 ? 1 : 2;
    edit.set_attribute(group, f.index, std::span(&side, 1));
  }
  edit.commit();
  const Mesh input = mesh;
  const Made moved = collapsed(input, 300, true), stayed = collapsed(input, 300, false);
  std::size_t on_line = 0;
  for (const Edge e : live_edges(stayed.mesh)) {
    const Halfedge h = halfedge(e);
    if (stayed.mesh.is_outside(h) || stayed.mesh.is_outside(twin(h))) continue;
    const auto side = [&](Halfedge g) { return stayed.mesh.attributes()[group].data[stayed.mesh.face(g).index]; };
    if (side(h) == side(twin(h))) continue;
    for (const Halfedge g : {h, twin(h)}) {
      ++on_line;
      EXPECT_EQ(moved.mesh.position(stayed.mesh.from(g)), stayed.mesh.position(stayed.mesh.from(g)));
    }
  }
  EXPECT_GT(on_line, 6u);
}

}  // namespace
}  // namespace ryosen::test
