// Points that deletions would pinch, asked about one after another, against the question by itself.

#include <gtest/gtest.h>

#include <algorithm>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/delete.h"
#include "ryosen/ops/rules/pinch.h"
#include "ryosen/ops/rules/sheets.h"
#include "tests/support/core/long_run.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/shapes.h"
#include "tests/support/core/ugly_meshes.h"

namespace ryosen {
namespace {

using namespace test;

std::vector<Face> all_faces(const Mesh& m) {
  std::vector<Face> faces;
  for (const Face f : live_faces(m)) faces.push_back(f);
  return faces;
}

void remove_faces(Edit& edit, const std::vector<Face>& faces) {
  Sheets sheets(edit);
  Deletion deletion;
  deletion.faces = faces;
  delete_elements(edit, sheets, deletion);
}

// Some faces at a time, of which some are deleted, until none are left.
void expect_same_answers(Mesh mesh, Dice& dice) {
  Edit edit(mesh, nullptr);
  PinchWatch watch(mesh);
  for (int i = 0; i < 300; ++i) {
    const std::vector<Face> left = all_faces(mesh);
    if (left.empty()) return;
    std::vector<Face> some;
    for (int k = dice.one_in(2) ? 1 : 1 + dice.below(4); k > 0; --k)
      some.push_back(left[static_cast<std::size_t>(dice.below(static_cast<int>(left.size())))]);
    sort_unique(some);
    const bool is_pinched = watch.is_pinched_without(some);
    ASSERT_EQ(is_pinched, !pinched_without(mesh, some).empty());
    if (is_pinched && !dice.one_in(4)) continue;
    watch.loses(some);
    remove_faces(edit, some);
  }
}

TEST(pinch_watch, answers_as_each_question_by_itself) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const SeededMesh seeded = seeded_mesh(seed);
    expect_same_answers(seed % 2 == 0 ? random_complex(seed) : make_mesh(seeded.faces, seeded.points), dice);
    if (HasFatalFailure()) return;
  }
}

TEST(pinch_watch, answers_so_on_shapes_where_one_point_meets_all) {
  for (const UglyFamily& family : ugly_families()) {
    SCOPED_TRACE(family.id);
    Dice dice(1);
    expect_same_answers(from_indexed(family.make(40)), dice);
    if (HasFatalFailure()) return;
  }
}

TEST(pinch_watch, costs_what_is_near_the_faces) {
  const auto looks = [](const IndexedMesh& start) {
    Mesh mesh = from_indexed(start);
    Edit edit(mesh, nullptr);
    PinchWatch watch(mesh);
    for (const Face f : all_faces(mesh)) {
      const Face faces[] = {f};
      if (watch.is_pinched_without(faces)) continue;
      watch.loses(faces);
      remove_faces(edit, {f});
    }
    return watch.looks();
  };
  const std::uint32_t few = is_long_run() ? 300 : 100;
  for (const auto family : {fan, bipyramid, book, book_of_squares, equal_triangles, apex_soup})
    EXPECT_LE(looks(family(4 * few)), 5 * looks(family(few))) << "four times the faces";
}

}  // namespace
}  // namespace ryosen
