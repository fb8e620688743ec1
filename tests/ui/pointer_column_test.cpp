// What changes with the pointer has a room of its own in the column: nothing else moves there.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "app/editor/session/session.h"
#include "ryosen/mesh/circulate.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

// All over the view, and on each edge.
std::vector<glm::dvec2> places_to_point(const Session& session) {
  std::vector<glm::dvec2> pixels;
  for (int row = 1; row < 6; ++row)
    for (int column = 1; column < 8; ++column)
      pixels.push_back(session.view.origin +
                       glm::dvec2(session.view.size.width * column / 8, session.view.size.height * row / 6));
  const Mesh& m = session.mesh();
  for (std::uint32_t i = 0; i < std::min(m.edge_slots(), 40u); ++i) {
    const auto [a, b] = ends(m, Edge(i));
    const auto at = project(session.view.camera, session.view.size, 0.5 * (m.position(a) + m.position(b)));
    if (at) pixels.push_back(at->pixel + session.view.origin);
  }
  return pixels;
}

TEST(pointer_column, stays_where_it_is_over_what_is_refused_what_is_legal_and_nothing) {
  std::map<std::string, int> seen;
  for (const char* const file : {"tetrahedron.off", "moebius.off"})
    for (const char* const tool : {"collapse", "swap", "split", "none"}) {
      SCOPED_TRACE(std::string(file) + " " + tool);
      test::Laid laid(file, {1280, 800});
      Session& session = laid.session;
      ASSERT_TRUE(session.run("mode edge").done() && session.run(std::string("tool ") + tool).done());
      const auto places = [&] {
        const test::DrawnText drawn(laid.gui);
        std::vector<glm::dvec2> all;
        for (const char* const title : {"Undo", "Inspector", "Problems", "History", "Formsofthesource", "Totals"})
          all.push_back(drawn.place(title));
        return all;
      };
      laid.frames(3);
      const std::vector<glm::dvec2> first = places();
      for (const glm::dvec2& place : first) ASSERT_GT(place.x, 0);
      for (const glm::dvec2& pixel : places_to_point(session)) {
        laid.gui.pointer(pixel);
        session.pointing.point_at(pixel);
        const auto& hover = session.selecting.hover();
        ++seen[!hover ? "nothing" : !hover->op ? "an element" : hover->preview.verdict.legal() ? "legal" : "refused"];
        for (int frame = 0; frame < 2; ++frame) {
          laid.frames(1);
          ASSERT_EQ(places(), first) << "at " << pixel.x << "," << pixel.y << ", frame " << frame;
        }
      }
    }
  for (const char* const sort : {"nothing", "an element", "legal", "refused"}) EXPECT_GT(seen[sort], 10) << sort;
}

// However far the column is scrolled below it: else what comes there looks as if it were of what is under the pointer.
TEST(pointer_column, what_is_seen_below_it_has_its_own_header) {
  test::Laid laid("fin.obj", {1280, 460});
  laid.gui.pointer({999, 330});  // beside all that has a tooltip
  laid.frames(3);
  int pinned = 0;
  for (int notch = 0; notch < 100; ++notch) {
    laid.gui.wheel(-0.1);
    laid.frames(3);
    const test::DrawnText drawn(laid.gui);
    constexpr double held_ends = 205;  // what lies above is covered
    const double last_row = drawn.place("Searchforself").y;
    if (last_row < held_ends + 60) continue;
    const double header = drawn.last_place("Problems").y;
    EXPECT_GT(header, held_ends) << notch;
    EXPECT_LT(header, last_row) << notch;
    pinned += drawn.place("Repairall").y < header;
  }
  EXPECT_GT(pinned, 0) << "its own header was scrolled away";
}

}  // namespace
}  // namespace ryosen
