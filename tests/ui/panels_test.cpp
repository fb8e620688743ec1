// The list of panels: what is in it can be shown and hidden, and a panel of another program joins it with a state of
// its own.
#include "app/ui/panels.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <set>

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

class PanelsTest : public testing::Test, protected test::Laid {
 protected:
  PanelsTest() : Laid("cube.obj", test::tall_window) {}

  int drawn() {
    gui.pointer({640, 1300});
    frames(3);
    return gui.draw_data().TotalVtxCount;
  }
};

// How many faces there were in each frame, as a curve.
class FacesPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    shown_faces.push_back(static_cast<float>(context.session.mesh().live().faces));
    ImGui::PlotLines("##faces", shown_faces.data(), static_cast<int>(shown_faces.size()), 0, nullptr, 0, 12, {0, 80});
  }
  std::vector<float> shown_faces;
};

constexpr PanelRow faces_row{"face_curve", PanelPlace::right, "Faces over time", "面の数の推移"};

TEST(panel_list, has_an_id_and_a_title_in_both_languages_for_each_panel_that_is_made) {
  EXPECT_EQ(make_panels().size(), panel_list().size());
  std::set<std::string_view> ids;
  for (const PanelRow& row : panel_list()) {
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_NE(row.title_en, "") << row.id;
    EXPECT_NE(row.title_ja, "") << row.id;
    EXPECT_NE(row.title_en, row.title_ja) << row.id;
    EXPECT_EQ(row.short_en.empty(), row.short_ja.empty()) << row.id;
    EXPECT_EQ(find_panel(row.id)->id, row.id);
  }
  EXPECT_EQ(find_panel("none"), nullptr) << "the word that closes";
}

TEST_F(PanelsTest, each_panel_of_a_column_can_be_hidden_and_comes_back_as_it_was) {
  const int all = drawn();
  for (const PanelRow& row : panel_list()) {
    if (row.place == PanelPlace::over || !row.shown_at_first()) continue;
    ASSERT_TRUE(session.run("panel " + std::string(row.id) + " off").done());
    EXPECT_LT(drawn(), all) << row.id;
    ASSERT_TRUE(session.run("panel " + std::string(row.id) + " on").done());
    EXPECT_EQ(drawn(), all) << row.id;
  }
}

TEST_F(PanelsTest, one_of_another_program_is_drawn_with_what_it_keeps) {
  const int before = drawn();
  auto made = std::make_unique<FacesPanel>();
  FacesPanel& panel = *made;
  gui.add_panel(faces_row, std::move(made));
  const int with_one = drawn();
  EXPECT_GT(with_one, before);
  ASSERT_TRUE(session.run("poke f0").done());
  frames(2);
  EXPECT_EQ(panel.shown_faces, (std::vector<float>{6, 6, 6, 9, 9}));
  EXPECT_GT(gui.draw_data().TotalVtxCount, with_one) << "a longer curve";
}

TEST_F(PanelsTest, one_that_is_hidden_at_first_is_drawn_when_it_is_asked_for) {
  const int before = drawn();
  PanelRow row = faces_row;
  row.at_first = PanelAtFirst::hidden;
  auto made = std::make_unique<FacesPanel>();
  FacesPanel& panel = *made;
  gui.add_panel(row, std::move(made));
  EXPECT_EQ(drawn(), before);
  EXPECT_TRUE(panel.shown_faces.empty());
  ASSERT_TRUE(session.run("panel face_curve").done());
  EXPECT_GT(drawn(), before);
  EXPECT_EQ(panel.shown_faces.size(), 3u);
}

TEST_F(PanelsTest, one_of_another_program_is_known_to_the_command_and_its_help_while_it_is_there) {
  const CommandRow command = *find_command_row("panel");
  const auto names_it = [&](Language language) {
    return help_of(command, language).find("face_curve") != std::string::npos;
  };
  EXPECT_FALSE(names_it(Language::english));
  {
    Gui other(1);
    other.add_panel(faces_row, std::make_unique<FacesPanel>());
    EXPECT_TRUE(names_it(Language::english));
    EXPECT_TRUE(names_it(Language::japanese));
    EXPECT_TRUE(session.run("panel face_curve").done());
    EXPECT_NE(session.run("panel face_curv").sentence.en.find("did you mean face_curve?"), std::string::npos);
  }
  EXPECT_FALSE(names_it(Language::english));
  EXPECT_EQ(session.run("panel face_curve").exit_code, ExitCode::usage);
}

TEST_F(PanelsTest, one_of_another_program_is_the_last_of_the_panels_in_the_view_menu) {
  auto made = std::make_unique<FacesPanel>();
  FacesPanel& panel = *made;
  gui.add_panel(faces_row, std::move(made));
  frames(3);
  const auto press_its_entry = [&] {
    open_menu("View");
    click_on("Panels");
    const test::DrawnText menu(gui);
    const double y = menu.last_place("Facesovertime").y;
    for (const PanelRow& row : panel_list())
      if (row.menu == PanelMenu::view && row.id != faces_row.id) {
        std::string shown(row.title_en);
        std::erase(shown, ' ');
        EXPECT_LT(menu.last_place(shown).y, y) << shown;
      }
    click(menu.last_place("Facesovertime"));
  };
  press_its_entry();
  EXPECT_EQ(session.layout.switched, std::set<std::string>{"face_curve"});
  const std::size_t seen = panel.shown_faces.size();
  frames(3);
  EXPECT_EQ(panel.shown_faces.size(), seen) << "it is not drawn while it is hidden";
  press_its_entry();
  EXPECT_TRUE(session.layout.switched.empty());
  EXPECT_GT(panel.shown_faces.size(), seen);
}

}  // namespace
}  // namespace ryosen
