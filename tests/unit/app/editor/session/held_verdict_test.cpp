// The verdict of a refused click stays until it is let go.
#include <gtest/gtest.h>

#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

constexpr glm::dvec2 elsewhere{3, 3};

class HeldVerdict : public testing::Test {
 protected:
  void SetUp() override {
    auto document = Document::open(test::asset("tetrahedron.off"));
    ASSERT_TRUE(document);
    session_.set_document(std::move(document).value());
    session_.framing.frame_all();
    ASSERT_TRUE(session_.run("tool collapse").done());
  }
  // The middle of an edge that is seen.
  glm::dvec2 on_edge() {
    const Mesh& m = session_.mesh();
    for (std::uint32_t i = 0; i < m.edge_slots(); ++i) {
      const auto [a, b] = ends(m, Edge(i));
      const auto at = project(session_.view.camera, session_.view.size, (m.position(a) + m.position(b)) / 2.0);
      const auto picked = session_.pointing.pick(at->pixel, PickMode::edge);
      if (picked && picked->element == Element(Edge(i))) return at->pixel;
    }
    ADD_FAILURE() << "no edge is seen";
    return {};
  }
  void refuse() {
    ASSERT_EQ(session_.pointing.click(on_edge(), session_.selecting.tool).kind, Outcome::Kind::refused);
    ASSERT_TRUE(session_.selecting.is_verdict_held());
  }

  Session session_{std::make_unique<Document>()};
};

TEST_F(HeldVerdict, stays_while_the_pointer_and_the_camera_move) {
  refuse();
  const Element held = session_.selecting.hover()->picked.element;
  session_.pointing.point_at(elsewhere);
  session_.pointing.point_away();
  ASSERT_TRUE(session_.run("drag 300,300 380,330").done());
  ASSERT_TRUE(session_.selecting.hover());
  EXPECT_EQ(session_.selecting.hover()->picked.element, held);
  EXPECT_FALSE(session_.selecting.hover()->preview.verdict.legal());
}

TEST_F(HeldVerdict, goes_with_the_next_click_the_tool_and_cancel) {
  refuse();
  session_.pointing.click(elsewhere, session_.selecting.tool);
  EXPECT_FALSE(session_.selecting.is_verdict_held());
  refuse();
  ASSERT_TRUE(session_.run("mode face").done());
  EXPECT_FALSE(session_.selecting.is_verdict_held());
  refuse();
  ASSERT_TRUE(session_.run("cancel").done());
  EXPECT_FALSE(session_.selecting.is_verdict_held());
  EXPECT_FALSE(session_.selecting.hover());
  EXPECT_EQ(session_.selecting.tool, "collapse") << "one step at a time";
  ASSERT_TRUE(session_.run("cancel").done());
  EXPECT_EQ(session_.selecting.tool, "");
}

TEST_F(HeldVerdict, enter_carries_out_the_first_remedy_and_asks_again) {
  EXPECT_EQ(session_.run("key Enter").exit_code, ExitCode::refused) << "nothing is held";
  refuse();
  const std::vector<std::string> remedy = session_.selecting.hover_remedy();
  ASSERT_FALSE(remedy.empty());
  EXPECT_EQ(session_.run("remedy 99").exit_code, ExitCode::refused);
  for (const char* line : {"remedy 0", "remedy x", "remedy 1 2"})
    EXPECT_EQ(session_.run(line).exit_code, ExitCode::usage) << line;
  ASSERT_TRUE(session_.run("key Enter").done());
  ASSERT_EQ(session_.log().size(), 1u);
  EXPECT_EQ(session_.log()[0].substr(0, 5), remedy[0].substr(0, 5));
  EXPECT_EQ(session_.selecting.is_verdict_held(), remedy.size() > 1);
  ASSERT_TRUE(session_.run("undo").done());
}

// It is asked of its operator, not of what lies at the pixel now.
TEST_F(HeldVerdict, is_of_the_same_element_though_the_camera_has_gone_round) {
  refuse();
  const Element held = session_.selecting.hover()->picked.element;
  session_.view.camera.eye = 2.0 * session_.view.camera.target - session_.view.camera.eye;
  ASSERT_TRUE(session_.run("remedy").done());
  if (session_.selecting.is_verdict_held()) {
    EXPECT_EQ(session_.selecting.hover()->picked.element, held);
  }
  ASSERT_TRUE(session_.run("undo").done());
}

TEST_F(HeldVerdict, goes_with_its_element) {
  ASSERT_TRUE(session_.run("split 0-1").done());
  ASSERT_TRUE(session_.run("tool make_ring").done());
  const glm::dvec2 pixel = on_edge();
  if (session_.pointing.click(pixel, session_.selecting.tool).kind != Outcome::Kind::refused) return;
  session_.view.camera.eye =
      session_.selecting.hover()->picked.place + 0.5 * (session_.view.camera.target - session_.view.camera.eye);
  ASSERT_TRUE(session_.run("undo").done());
  if (session_.selecting.hover()) {
    EXPECT_TRUE(session_.mesh().exists(session_.selecting.hover()->picked.element.edge()));
  }
}

// The last step ends it; whatever it was held for may be gone with any edit.
TEST_F(HeldVerdict, ends_where_the_mesh_no_longer_refuses) {
  refuse();
  ASSERT_TRUE(session_.run("delete f0").done());
  ASSERT_TRUE(session_.run("delete f1").done());
  ASSERT_TRUE(session_.run("delete f2").done());
  ASSERT_TRUE(session_.run("delete f3").done());
  EXPECT_FALSE(session_.selecting.is_verdict_held());
  ASSERT_TRUE(session_.run("new").done());
  EXPECT_FALSE(session_.selecting.hover());
}

}  // namespace
}  // namespace ryosen
