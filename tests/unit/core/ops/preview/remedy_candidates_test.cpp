#include "ryosen/ops/preview/remedy_candidates.h"

#include <gtest/gtest.h>

#include "tests/support/core/shapes.h"

namespace ryosen {
namespace {

using namespace test;

TEST(remedy_candidates, a_sheet_is_tried_once) {
  const Mesh mesh = make_mesh(two_tetrahedra_on_an_edge());
  KnownSheets sheets;
  const Reason reason{Rule::copies, {Vertex(0), Vertex(1)}};
  std::size_t detachments = 0;
  for (const AnyOp& op : remedy_candidates(mesh, reason, sheets)) detachments += std::holds_alternative<Detach>(op);
  EXPECT_EQ(detachments, 2u);
}

}  // namespace
}  // namespace ryosen
