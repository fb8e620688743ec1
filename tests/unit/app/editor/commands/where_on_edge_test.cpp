// What a tool does depends on where along the edge the pointer is.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/session/session.h"
#include "ryosen/base/number_text.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

class WhereOnEdge : public testing::Test {
 protected:
  void SetUp() override {
    auto document = Document::open(test::asset("torus.off"));
    ASSERT_TRUE(document);
    session_.set_document(std::move(document).value());
    session_.framing.frame_all();
    const auto picked = session_.pointing.pick({478, 488}, PickMode::edge);
    ASSERT_TRUE(picked);
    half_ = picked->halfedge;
    from_ = name_of(session_.mesh(), session_.mesh().from(half_)).substr(1);
    to_ = name_of(session_.mesh(), session_.mesh().to(half_)).substr(1);
  }
  // The line that a click would send, with the pointer over this share of the edge.
  std::string line(double along, const std::string& tool, Modifiers modifiers = {}) {
    session_.selecting.tool = tool;
    const Mesh& m = session_.mesh();
    const glm::dvec3 place = m.position(m.from(half_)) * (1 - along) + m.position(m.to(half_)) * along;
    session_.pointing.point_at(project(session_.view.camera, session_.view.size, place)->pixel, modifiers);
    if (!session_.selecting.hover() || !session_.selecting.hover()->op) return "nothing";
    return command_of(m, *session_.selecting.hover()->op);
  }

  // A split so far along the edge, from whichever end it is said.
  void expect_split(const std::string& line, double along) const {
    const auto said = [&](const std::string& a, const std::string& b, double t) {
      return "split " + a + "-" + b + (t == 0.5 ? "" : " " + format_double(t));
    };
    EXPECT_TRUE(line == said(from_, to_, along) || line == said(to_, from_, std::round((1 - along) * 10) / 10)) << line;
  }

  Session session_{std::make_unique<Document>()};
  Halfedge half_;
  std::string from_, to_;
};

TEST_F(WhereOnEdge, a_split_snaps_to_the_middle_and_to_tenths_and_shift_frees_it) {
  expect_split(line(0.5, "split"), 0.5);
  expect_split(line(0.43, "split"), 0.5);
  expect_split(line(0.31, "split"), 0.3);
  expect_split(line(0.18, "split"), 0.2);
  expect_split(line(0.04, "split"), 0.1);
  const std::string free = line(0.31, "split", {.shift = true});
  const double along = std::stod(free.substr(free.rfind(' ')));
  EXPECT_NEAR(free.substr(0, free.rfind(' ')) == "split " + from_ + "-" + to_ ? along : 1 - along, 0.31, 0.002) << free;
}

TEST_F(WhereOnEdge, a_collapse_goes_to_the_middle_or_to_the_end_whose_third_it_is) {
  EXPECT_EQ(line(0.45, "collapse"), "collapse " + from_ + "-" + to_ + " mid");
  EXPECT_EQ(line(0.6, "collapse"), "collapse " + to_ + "-" + from_ + " mid");
  EXPECT_EQ(line(0.2, "collapse"), "collapse " + to_ + "-" + from_) << "the other end goes";
  EXPECT_EQ(line(0.8, "collapse"), "collapse " + from_ + "-" + to_);
  const glm::dvec3 away = session_.view.camera.eye - session_.view.camera.target;
  session_.view.camera.eye = session_.view.camera.target + 8.0 * away;  // under 24 pixels
  EXPECT_EQ(line(0.2, "collapse"), "collapse " + from_ + "-" + to_ + " mid");
}

TEST_F(WhereOnEdge, a_click_does_what_was_shown) {
  const std::string shown = line(0.31, "split", {.shift = true});
  const Hover hover = *session_.selecting.hover();
  ASSERT_TRUE(session_.pointing.click(hover.pixel, "split", {.shift = true}).done());
  EXPECT_EQ(session_.log().back(), shown);
}

}  // namespace
}  // namespace ryosen
