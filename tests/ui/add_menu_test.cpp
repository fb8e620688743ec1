// The Add menu: an entry for each primitive, which asks for its values; the first shape is seen as a whole.
#include <gtest/gtest.h>
#include <imgui.h>

#include <glm/geometric.hpp>

#include "app/editor/preferences/panel_list.h"
#include "app/editor/session/session.h"
#include "ryosen/algo/algorithm_table.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

class AddMenu : public testing::Test, protected test::Laid {
 protected:
  AddMenu() : Laid("cube.obj") {}
};

TEST_F(AddMenu, has_an_entry_for_each_primitive_that_asks_for_its_values) {
  const glm::dvec2 menu = test::DrawnText(gui).place("Add");
  for (const AlgorithmRow& row : algorithm_table()) {
    if (!row.is_primitive) continue;
    click(menu);
    click(test::DrawnText(gui).place(row.name_en));
    EXPECT_EQ(session.layout.open_panel, "values") << row.id;
    EXPECT_EQ(session.layout.asked_algorithm, row.id);
    session.run("panel none");
    frames(3);
  }
}

// One word for two things leads to the wrong one.
TEST_F(AddMenu, is_called_as_no_panel_and_operators_have_one_word) {
  for (const MenuRow& menu : menu_bar)
    for (const PanelRow& panel : panel_list()) {
      EXPECT_NE(menu.title_en, panel.title_en);
      EXPECT_NE(menu.title_ja, panel.title_ja) << panel.id;
    }
  for (const AlgorithmRow& row : algorithm_table()) {
    std::string told = std::string(row.name_ja) + std::string(row.help_ja);
    for (const ParameterRow& parameter : row.parameters)
      told += std::string(parameter.name_ja) + std::string(parameter.help_ja);
    EXPECT_EQ(told.find("縮約"), std::string::npos) << row.id << ": to collapse is 稜線削除";
  }
}

TEST_F(AddMenu, adds_what_the_fields_say_and_shows_all_of_it_where_nothing_was_before) {
  session.set_document(std::make_unique<Document>());
  ASSERT_TRUE(session.run("values sphere").done());
  frames(3);
  for (const char digit : std::string_view("50")) gui.character(static_cast<unsigned>(digit));  // the radius
  frames(2);
  gui.key(ImGuiKey_Enter, true);
  gui.key(ImGuiKey_Enter, false);
  frames(4);
  EXPECT_EQ(session.log(), std::vector<std::string>{"sphere radius=50 segments=32 bands=16 at=0,0,0"}) << gui.said().en;
  const Camera shown = session.view.camera;
  session.framing.frame_all();
  EXPECT_NEAR(glm::distance(session.view.camera.eye, shown.eye), 0, 1e-9);
  session.view.camera = shown;
  ASSERT_TRUE(session.run("cube at=900,0,0").done());
  EXPECT_EQ(session.view.camera, shown) << "what was looked at stays where it is";
}

TEST_F(AddMenu, keeps_values_that_were_refused_with_the_reason) {
  session.set_document(std::make_unique<Document>());
  ASSERT_TRUE(session.run("values sphere").done());
  frames(3);
  for (const char c : std::string_view("50%")) gui.character(static_cast<unsigned>(c));
  frames(2);
  gui.key(ImGuiKey_Enter, true);
  gui.key(ImGuiKey_Enter, false);
  frames(5);
  EXPECT_EQ(session.layout.open_panel, "values") << "a share of nothing";
  EXPECT_GE(test::DrawnText(gui).count(gui.said().en), 2u) << "the reason stands there too";
  EXPECT_GT(test::DrawnText(gui).count("50%"), test::DrawnText(gui).count(gui.said().en)) << "in its field too";
}

TEST_F(AddMenu, selects_what_was_added) {
  const std::uint32_t before = session.mesh().live().faces;
  ASSERT_TRUE(session.run("sphere").done());
  EXPECT_EQ(session.selecting.selection.size(), session.mesh().live().faces - before);
  // Its preview, which the fields show, is not what was there before.
  ASSERT_TRUE(session.run("values torus").done());
  frames(3);
  ASSERT_TRUE(session.document().is_on_trial());
  const std::uint32_t shown = session.mesh().live().faces;
  gui.key(ImGuiKey_Enter, true);
  gui.key(ImGuiKey_Enter, false);
  frames(4);
  EXPECT_EQ(session.mesh().live().faces, shown);
  EXPECT_FALSE(session.document().is_on_trial());
  EXPECT_EQ(session.selecting.selection.size(), 512u);
}

TEST_F(AddMenu, takes_a_share_of_the_diagonal_without_what_its_preview_adds) {
  ASSERT_TRUE(session.run("values sphere").done());
  frames(3);
  for (const char c : std::string_view("200%")) gui.character(static_cast<unsigned>(c));
  frames(2);
  ASSERT_TRUE(session.document().is_on_trial());
  gui.key(ImGuiKey_Enter, true);
  gui.key(ImGuiKey_Enter, false);
  frames(4);
  const auto fresh = std::make_unique<Session>(Document::open(test::asset("cube.obj")).value());
  ASSERT_TRUE(fresh->run("sphere 200%").done());
  const Vertex last(session.mesh().vertex_slots() - 1);
  EXPECT_EQ(session.mesh().position(last), fresh->mesh().position(last));
}

}  // namespace
}  // namespace ryosen
