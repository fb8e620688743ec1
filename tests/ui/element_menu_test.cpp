// What the menu of the element under the pointer offers.
#include <gtest/gtest.h>
#include <imgui_internal.h>  // which menus are open

#include "app/editor/session/session.h"
#include "app/ui/window_input.h"
#include "ryosen/mesh/face_polygon.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

class ElementMenu : public testing::Test, protected test::Laid {
 protected:
  ElementMenu() : Laid("cube.obj") {
    input_.resize(size_);
    session.run("mode edge");
  }
  // Of an edge that can be seen.
  glm::dvec2 place_of_edge() {
    for (std::uint32_t i = 0; i < session.mesh().edge_slots(); ++i) {
      const Element edge{Edge(i)};
      const auto seen = project(session.view.camera, session.view.size, middle_of(session.mesh(), edge));
      const auto picked =
          seen ? session.pointing.pick(session.view.origin + seen->pixel, PickMode::edge) : std::nullopt;
      if (picked && picked->element == edge) return session.view.origin + seen->pixel;
    }
    ADD_FAILURE() << "no edge is seen";
    return {};
  }
  void open_menu(glm::dvec2 pixel) {
    input_.press(MouseButton::right, {pixel});
    input_.release(MouseButton::right, {pixel});
    frames(5);
  }

  WindowInput input_{gui, session, {}, [this] { frames(4); }};
};

// What is done every day stands in it; single steps of construction and what else may be selected in menus of their
// own.
TEST_F(ElementMenu, is_short) {
  open_menu(place_of_edge());
  ASSERT_EQ(GImGui->OpenPopupStack.Size, 1);
  const test::DrawnText drawn(gui);
  for (const char* const text : {"Splitandmove", "Hideeverythingelse", "Hidetheselection"})
    EXPECT_EQ(drawn.count(text), 1u) << text;
  for (const char* const text : {"Makeloop", "Uniteloops", "Divideedge", "Selecttheneighbourstoo"})
    EXPECT_EQ(drawn.count(text), 0u) << text;
  click(drawn.last_place("Euleroperators"));
  frames(5);
  ASSERT_EQ(GImGui->OpenPopupStack.Size, 2);
  click(test::DrawnText(gui).place("Divideedge"));
  ASSERT_FALSE(session.document().history().empty());
  EXPECT_EQ(session.document().history().back().command, "separate_edge selected");
}

// It was placed by the height that it had while its title was wrapped.
TEST_F(ElementMenu, opens_at_the_pointer) {
  for (const glm::dvec2 pixel : {glm::dvec2(270, 600), glm::dvec2(900, 660), place_of_edge(), glm::dvec2(270, 90)}) {
    open_menu(pixel);
    ASSERT_EQ(GImGui->OpenPopupStack.Size, 1);
    const ImRect menu = GImGui->OpenPopupStack.back().Window->Rect();
    EXPECT_LE(menu.Min.y, pixel.y + 2) << pixel.x << "," << pixel.y;
    EXPECT_GE(menu.Max.y, pixel.y - 2) << pixel.x << "," << pixel.y;
    EXPECT_NEAR(menu.Min.x, pixel.x + 2, 2) << pixel.x << "," << pixel.y;
    gui.close_menus();
    frames(3);
  }
}

// All edges of a closed cube: there is no hole at any of them, and none of them is a vertex.
TEST_F(ElementMenu, offers_nothing_that_cannot_be) {
  const glm::dvec2 pixel = place_of_edge();
  ASSERT_TRUE(session.run("select all").done());
  open_menu(pixel);
  const test::DrawnText drawn(gui);
  EXPECT_EQ(drawn.count("Splitvertex"), 0u);
  EXPECT_EQ(drawn.count("Fillhole"), 1u);
  const std::size_t before = session.document().position();
  click(drawn.place("Fillhole"));
  EXPECT_EQ(session.document().position(), before);
  EXPECT_EQ(gui.said().en, "") << "an entry that is off runs nothing";
}

}  // namespace
}  // namespace ryosen
