#include "ryosen/ops/euler/make_edge.h"

#include <gtest/gtest.h>

#include <chrono>

#include "ryosen/mesh/invariants.h"
#include "ryosen/ops/all.h"

namespace ryosen {
namespace {

// A cost that grows with the square of the wires at the hub would be minutes.
TEST(make_edge, a_hub_of_many_wires) {
  constexpr std::uint32_t wires = 60000;
  const auto begin = std::chrono::steady_clock::now();
  Mesh mesh;
  {
    Edit edit(mesh, nullptr);
    for (std::uint32_t i = 0; i <= wires; ++i) edit.fresh(edit.add_vertex({i, 0, 0}));
    for (std::uint32_t i = 1; i <= wires; ++i) {
      const std::string tip = std::to_string(i), before = std::to_string(i - 1);
      const std::string line = "make_edge v0 v" + tip + (i > 2 ? " " + before + "-0" : "");
      const ParsedOp parsed = parse_line(mesh, line);
      ASSERT_TRUE(parsed.op) << line << ": " << parsed.sentence.en;
      ASSERT_TRUE(check(mesh, *parsed.op).legal()) << line;
      ASSERT_EQ(command_of(mesh, *parsed.op), line);
      apply(edit, *parsed.op);
    }
    edit.commit();
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
  EXPECT_EQ(mesh.live().edges, wires);
  EXPECT_FALSE(check_invariants(mesh));
  EXPECT_EQ(parse_line(mesh, "make_edge 0 0").error, NameError::ambiguous);
}

TEST(make_edge, a_named_corner_must_lie_at_a_gap_of_its_vertex) {
  Mesh mesh;
  for (const char* line : {"make_vertex 0,0,0", "make_vertex 1,0,0", "make_vertex 0,1,0", "make_vertex 5,0,0",
                           "make_edge 0 1", "make_edge 1 2", "make_edge 2 0", "make_loop 0-1", "make_edge 0 3 2-0"}) {
    const ParsedOp parsed = parse_line(mesh, line);
    if (!parsed.op || !check(mesh, *parsed.op).legal()) {
      EXPECT_STREQ(line, "make_edge 0 3 2-0");
      EXPECT_NE(parsed.sentence.en.find("'2-0' is not a halfedge that arrives at v0"), std::string::npos);
      continue;
    }
    Edit edit(mesh, nullptr);
    apply(edit, *parsed.op);
    edit.commit();
  }
  EXPECT_TRUE(parse_line(mesh, "make_edge 0 3 1-0").op);
  EXPECT_TRUE(parse_line(mesh, "make_edge 0 3").op);
  EXPECT_FALSE(parse_line(mesh, "make_edge 0 3 1-2").op);
}

}  // namespace
}  // namespace ryosen
