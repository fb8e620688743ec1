#include "ryosen/ops/preview/known_answers.h"

#include <gtest/gtest.h>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/ops/all.h"
#include "ryosen/ops/preview/preview.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_meshes.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/ugly_meshes.h"

namespace ryosen {
namespace {

using namespace test;

template <class Op>
void compare(Mesh& mesh, std::size_t& asked) {
  KnownAnswers known;
  Journal journal;
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    if (!mesh.is_alive(Halfedge(i))) continue;
    const Op op = Op::at(mesh, {.halfedge = Halfedge(i)});
    const Answer answer = known.ask(mesh, op, true);
    const Preview alone = preview(mesh, journal, op);
    ASSERT_EQ(answer.verdict.reasons, alone.verdict.reasons) << command_of(mesh, op);
    ASSERT_EQ(answer.warnings, alone.warnings) << command_of(mesh, op);
    ++asked;
  }
}

// All operators on an edge.
template <std::size_t... I>
void compare_all(Mesh& mesh, std::size_t& asked, std::index_sequence<I...>) {
  const auto one = [&]<class Op>(std::type_identity<Op>) {
    if (Op::info.target == OpTargetKind::edge) compare<Op>(mesh, asked);
  };
  (one(std::type_identity<std::variant_alternative_t<I, AnyOp>>()), ...);
}

void compare_all(Mesh mesh, std::size_t& asked) {
  compare_all(mesh, asked, std::make_index_sequence<std::variant_size_v<AnyOp>>());
}

Mesh placed_at_random(const RandomMesh& random) {
  IndexedMesh list = indexed(Polygons(), static_cast<std::size_t>(random.points));
  for (const auto& face : random.faces) {
    for (int corner : face) list.corners.push_back(static_cast<std::uint32_t>(corner));
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  Dice dice(random.seed);
  for (glm::dvec3& place : list.positions) place = {dice.unit(), dice.unit(), dice.unit()};
  return from_indexed(std::move(list));
}

// Two polygons of n corners joined by n squares.
Mesh prism(std::uint32_t n) {
  Polygons faces(2);
  for (std::uint32_t i = 0; i < n; ++i) {
    faces[0].push_back(n - 1 - i);
    faces[1].push_back(n + i);
    faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return make_mesh(faces);
}

TEST(known_answers, are_those_of_single_questions) {
  std::size_t asked = 0;
  for (std::uint32_t n = 3; n < 7; ++n) ASSERT_NO_FATAL_FAILURE(compare_all(prism(n), asked));
  for (const UglyFamily& family : ugly_families()) {
    SCOPED_TRACE(family.id);
    ASSERT_NO_FATAL_FAILURE(compare_all(from_indexed(family.make(12)), asked));
  }
  for (std::uint64_t seed = 1; seed <= seed_count(25, 60); ++seed) {
    const RandomMesh random = random_mesh(seed);
    SCOPED_TRACE(random.story);
    ASSERT_NO_FATAL_FAILURE(compare_all(placed_at_random(random), asked));
  }
  EXPECT_GT(asked, 10000u);
}

TEST(known_answers, say_where_the_shape_of_very_many_faces_was_not_looked_at) {
  for (const std::uint32_t n : {300u, 500u}) {
    Mesh mesh = from_indexed(fan(n));
    KnownAnswers known;
    const Vertex hub(0);
    const Answer answer = known.ask(mesh, CollapseEdge{mesh.halfedge(hub)}, true);
    ASSERT_TRUE(answer.verdict.legal());
    const bool is_unseen = answer.warnings == std::vector<Reason>{{Rule::shape_unseen, {}}};
    EXPECT_EQ(is_unseen, n > 400) << n;
    EXPECT_TRUE(known.ask(mesh, CollapseEdge{mesh.halfedge(hub)}, false).warnings.empty());
  }
}

}  // namespace
}  // namespace ryosen
