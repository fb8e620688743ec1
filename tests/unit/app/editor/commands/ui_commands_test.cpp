// The commands of the user interface, which the session keeps and the window shows.
#include <gtest/gtest.h>

#include "app/editor/preferences/keys.h"
#include "app/editor/preferences/panel_list.h"
#include "app/editor/session/session.h"
#include "ryosen/base/enum_table.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

TEST(ui_commands, set_what_they_name) {
  Session session(std::make_unique<Document>());
  EXPECT_TRUE(session.run("language ja").done());
  EXPECT_EQ(session.preferences.language, Language::japanese);
  EXPECT_TRUE(session.run("theme light").done());
  EXPECT_EQ(session.view.settings.theme, Theme::light);
  EXPECT_TRUE(session.run("panel keys").done());
  EXPECT_EQ(session.layout.open_panel, "keys");
  for (const char* wrong : {"language", "language de", "theme pink", "panel", "panel kyes", "cancel all"})
    EXPECT_EQ(session.run(wrong).exit_code, ExitCode::usage) << wrong;
  EXPECT_TRUE(session.log().empty()) << "a script of the edits does not hold how the window looked";
}

TEST(ui_commands, panels_over_the_view_take_turns_and_those_of_the_columns_are_hidden_each_by_itself) {
  Session session(std::make_unique<Document>());
  for (const char* line : {"panel keys", "panel history off", "panel open", "panel keys off"})
    EXPECT_TRUE(session.run(line).done()) << line;
  EXPECT_EQ(session.layout.open_panel, "open") << "another than the one that was to be closed";
  EXPECT_FALSE(session.layout.is_shown(*find_panel("history")));
  EXPECT_TRUE(session.layout.is_shown(*find_panel("tools")));
  for (const char* line : {"panel none", "panel tools off", "panel history"}) EXPECT_TRUE(session.run(line).done());
  EXPECT_EQ(session.layout.open_panel, "");
  EXPECT_TRUE(session.layout.is_shown(*find_panel("history")));
  EXPECT_FALSE(session.layout.is_shown(*find_panel("tools")));
  for (const char* wrong : {"panel history maybe", "panel none off", "panel history on on"})
    EXPECT_EQ(session.run(wrong).exit_code, ExitCode::usage) << wrong;
  EXPECT_EQ(session.run("panel histroy").sentence.en, "there is no panel 'histroy'; did you mean history?");
  for (const char* wrong : {"panel none off", "panel none on"})
    EXPECT_EQ(session.run(wrong).sentence.en, "panel none closes what lies over the view; it takes no further word");
}

TEST(ui_commands, panels_begin_as_their_rows_say) {
  const ScopedPanel quiet(
      {"quiet", PanelPlace::right, "Quiet", "静か", PanelMenu::view, PanelOpener::nothing, PanelAtFirst::hidden});
  {
    Session session(std::make_unique<Document>());
    EXPECT_EQ(session.layout.open_panel, "");
    for (const PanelRow& row : panel_list()) EXPECT_EQ(session.layout.is_shown(row), row.shown_at_first()) << row.id;
    const PanelRow row = *find_panel("quiet");
    for (const bool on : {true, false}) {
      EXPECT_TRUE(session.run(on ? "panel quiet" : "panel quiet off").done());
      EXPECT_EQ(session.layout.is_shown(row), on);
      EXPECT_TRUE(session.run(on ? "panel quiet on" : "panel quiet off").done()) << "once more changes nothing";
      EXPECT_EQ(session.layout.is_shown(row), on);
    }
  }
  const ScopedPanel loud(
      {"loud", PanelPlace::over, "Loud", "声高", PanelMenu::none, PanelOpener::nothing, PanelAtFirst::shown});
  Session session(std::make_unique<Document>());
  EXPECT_EQ(session.layout.open_panel, "loud");
}

TEST(ui_commands, each_opener_opens_one_panel) {
  std::set<PanelOpener> met;
  for (const PanelRow& row : panel_list()) {
    if (row.opened_by == PanelOpener::nothing) continue;
    EXPECT_TRUE(met.insert(row.opened_by).second) << row.id;
    EXPECT_EQ(panel_opened_by(row.opened_by).id, row.id);
    const bool is_beside = row.opened_by == PanelOpener::coloured || row.opened_by == PanelOpener::played ||
                           row.opened_by == PanelOpener::levelled || row.opened_by == PanelOpener::practised;
    EXPECT_EQ(row.place == PanelPlace::over, !is_beside) << row.id;
  }
  EXPECT_EQ(met.size(), enum_count<PanelOpener> - 1);
}

TEST(ui_commands, only_what_leads_out_and_the_help_acts_while_a_panel_is_open) {
  std::set<std::string> acting;
  for (const KeyRow& key : key_table())
    if (key.acts_always) acting.insert(key.chord);
  EXPECT_EQ(acting, (std::set<std::string>{"Escape", "F1"}));
}

TEST(ui_commands, cancel_steps_out_of_one_thing_at_a_time) {
  auto document = Document::open(test::asset("torus.off"));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  for (const char* line : {"select v0", "tool collapse", "panel keys", "cancel"}) ASSERT_TRUE(session.run(line).done());
  EXPECT_EQ(session.layout.open_panel, "");
  EXPECT_EQ(session.selecting.tool, "collapse");
  ASSERT_TRUE(session.run("cancel").done());
  EXPECT_EQ(session.selecting.tool, "");
  EXPECT_EQ(session.selecting.selection.size(), 1u);
  ASSERT_TRUE(session.run("cancel").done());
  EXPECT_TRUE(session.selecting.selection.empty());
}

TEST(ui_commands, every_key_sends_a_command_that_is_understood) {
  for (const KeyRow& key : key_table()) {
    auto document = Document::open(test::asset("torus.off"));
    ASSERT_TRUE(document);
    Session session(std::move(document).value());
    session.frontend.take_picture = [](const std::filesystem::path&) { return success(); };
    if (key.command == "save") continue;  // would write the asset
    EXPECT_NE(session.run(key.command).exit_code, ExitCode::usage) << key.chord;
  }
}

TEST(ui_commands, arrows_walk_halfedges) {
  auto document = Document::open(test::asset("torus.off"));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  EXPECT_EQ(session.run("walk next").exit_code, ExitCode::refused) << "nothing is selected";
  EXPECT_EQ(session.run("walk sideways").exit_code, ExitCode::usage);
  const Mesh& mesh = session.mesh();
  const Halfedge start(0);
  const auto walked = [&](const char* line) {
    session.selecting.selection = {start};
    EXPECT_TRUE(session.run(line).done()) << line;
    return session.selecting.selection;
  };
  EXPECT_EQ(walked("key Right"), std::vector<Element>{mesh.next(start)});
  EXPECT_EQ(walked("key Left"), std::vector<Element>{mesh.prev(start)});
  EXPECT_EQ(walked("key Up"), std::vector<Element>{twin(start)});
  session.selecting.selection = {start};
  int steps = 0;
  do {
    ASSERT_TRUE(session.run("key Down").done());
    EXPECT_EQ(mesh.from(session.selecting.selection[0].halfedge()), mesh.from(start));
  } while (++steps < 20 && session.selecting.selection[0] != Element(start));
  EXPECT_EQ(steps, 6) << "around a vertex of degree 6";
}

TEST(ui_commands, pixels_count_from_the_windows_corner_and_end_with_the_view) {
  auto document = Document::open(test::asset("torus.off"));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  const auto inside = session.pointing.pick({640, 560}, PickMode::face);
  ASSERT_TRUE(inside);
  session.view.origin = {200, 30};
  const auto moved = session.pointing.pick({840, 590}, PickMode::face);
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->element, inside->element);
  EXPECT_FALSE(session.pointing.pick({199, 300}, PickMode::face));
  EXPECT_FALSE(session.pointing.pick({1480, 300}, PickMode::face));
}

}  // namespace
}  // namespace ryosen
