// The menus, the files and the palette by the keyboard alone.
#include <gtest/gtest.h>

#include "app/editor/commands/text/words.h"
#include "app/editor/preferences/keys.h"
#include "app/editor/preferences/panel_list.h"
#include "app/editor/session/session.h"
#include "app/ui/window_input.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

using test::DrawnText;
using test::window;

class MenuKeys : public testing::Test, protected test::Laid {
 protected:
  MenuKeys() : Laid("cube.obj") { input_.resize(window); }

  void press(const std::string& chord) {
    input_.key_down(chord);
    frames(2);
    input_.key_up(chord);
    gui.modifiers(false, false);
    frames(3);
  }
  void write(const std::string& text) {
    gui.text(text);
    frames(3);
  }
  static std::string without_spaces(std::string_view text) {
    std::string letters(text);
    std::erase(letters, ' ');
    return letters;
  }
  bool shows(std::string_view text) { return DrawnText(gui).count(text) > 0; }

  WindowInput input_{gui, session, {}, [this] { frames(4); }};
};

TEST_F(MenuKeys, f10_opens_them_and_arrows_walk_through_all) {
  press("F10");
  ASSERT_TRUE(gui.has_menu(session.layout));
  EXPECT_TRUE(shows("Append...")) << "the first one";
  press("Right");
  EXPECT_TRUE(shows("Duplicate"));
  EXPECT_FALSE(shows("Append..."));
  press("Left");
  press("Left");
  EXPECT_TRUE(shows("Keys and mouse")) << "round the end of the bar";
  for (std::size_t i = 0; i < std::size(menu_bar); ++i) press("Right");
  EXPECT_TRUE(shows("Keys and mouse"));
  press("F10");
  EXPECT_FALSE(gui.has_menu(session.layout));
}

// What keys do with the selection is found without knowing them, and the menus teach the keys that are in force.
TEST_F(MenuKeys, entries_do_what_keys_do_by_hand) {
  ASSERT_TRUE(session.run("select f0").done());
  ASSERT_TRUE(session.run("preset blender").done());
  std::size_t n = 0;
  for (const KeyRow& row : key_table()) {
    if (row.menu == KeyMenu::none) continue;
    ++n;
    EXPECT_FALSE(row.menu_en.empty() || row.menu_ja.empty()) << row.command;
    ASSERT_TRUE(session.run(row.menu == KeyMenu::edit ? "menu edit" : "menu select").done());
    frames(3);
    EXPECT_TRUE(shows(without_spaces(row.menu_en))) << row.menu_en;
    gui.close_menus();
    frames(3);
  }
  EXPECT_EQ(n, 14u);
  ASSERT_TRUE(session.run("menu edit").done());
  frames(3);
  click(DrawnText(gui).last_place("Delete"));
  EXPECT_EQ(session.mesh().live().faces, 5u) << gui.said().en;
  ASSERT_TRUE(session.run("menu select").done());
  frames(3);
  click(DrawnText(gui).last_place("Selectbyalasso"));
  EXPECT_EQ(session.view.armed_drag, DragAction::lasso);
}

TEST_F(MenuKeys, small_parts_are_selected_by_a_field_with_a_value_that_does_at_once) {
  ASSERT_TRUE(session.run("new").done());
  ASSERT_TRUE(session.run("torus").done());
  ASSERT_TRUE(session.run("cube").done());
  const auto open = [&] {
    ASSERT_TRUE(session.run("menu select").done());
    frames(3);
    click(DrawnText(gui).last_place("Selectsmallparts"));
    frames(3);
  };
  ASSERT_TRUE(session.run("select none").done());
  open();
  ASSERT_TRUE(shows("1%")) << "what stands there";
  press("Enter");
  EXPECT_FALSE(gui.has_menu(session.layout));
  EXPECT_TRUE(session.selecting.selection.empty()) << "six of more than five hundred are no less than 1%";
  open();
  write("7");
  press("Enter");
  EXPECT_EQ(session.selecting.selection.size(), 6u) << gui.said().en;
  open();
  ASSERT_TRUE(shows("7")) << "it stays what it was";
}

TEST_F(MenuKeys, what_has_a_trait_is_selected_by_any_number) {
  ASSERT_TRUE(session.run("new").done());
  ASSERT_TRUE(session.run("cube").done());
  constexpr struct {
    const char *entry, *usual, *value;
    std::size_t usually, found;
  } fields[] = {{"Selectfacesbythenumberofsides", "5..", "4", 0, 6},
                {"Selectverticesbythenumberofedges", "7..", "3..5", 0, 8},
                {"Selectedgesbyhowtheybend", "30", "95", 12, 0},
                {"Selectedgesshorterthan", "", "100", 0, 12},
                {"Selectedgeslongerthan", "", "0", 0, 12}};
  for (const auto& [entry, usual, value, usually, found] : fields) {
    ASSERT_TRUE(session.run("select none").done());
    const auto open = [&, name = entry] {
      ASSERT_TRUE(session.run("menu select").done());
      frames(3);
      click(DrawnText(gui).last_place(name));
      frames(3);
    };
    open();
    if (*usual) {
      EXPECT_TRUE(shows(usual)) << entry;
      press("Enter");
      EXPECT_EQ(session.selecting.selection.size(), usually) << entry << ": " << gui.said().en;
      open();
    }
    write(value);
    press("Enter");
    EXPECT_EQ(session.selecting.selection.size(), found) << entry << ": " << gui.said().en;
  }
  ASSERT_TRUE(session.run("select f0").done());
  ASSERT_TRUE(session.run("menu select").done());
  frames(3);
  click(DrawnText(gui).last_place("Selecttheflatregionaround,within"));
  frames(3);
  write("91");
  press("Enter");
  EXPECT_EQ(session.selecting.selection.size(), 6u) << gui.said().en;
}

TEST_F(MenuKeys, entries_that_ask_for_more_end_in_dots) {
  const auto opens = [&](const char* menu) {
    ASSERT_TRUE(session.run(std::string("menu ") + menu).done());
    frames(3);
  };
  opens("edit");
  for (const char* const text : {"Preferences...", "Command..."}) EXPECT_TRUE(shows(text)) << text;
  opens("help");
  EXPECT_TRUE(shows("Keysandmouse..."));
  EXPECT_TRUE(shows("Practice"));
  EXPECT_FALSE(shows("Practice...")) << "it is in a column";
  opens("add");
  EXPECT_TRUE(shows("Grid..."));
}

TEST_F(MenuKeys, a_function_key_closes_them_and_acts) {
  for (const char* chord : {"F10", "Left", "F3"}) press(chord);
  EXPECT_EQ(session.layout.open_panel, "command");
  EXPECT_FALSE(shows("Keysandmouse...")) << "the menu is closed";
  EXPECT_FALSE(gui.has_menu(session.layout));
  write("poke f0");
  press("Enter");
  EXPECT_EQ(session.document().position(), 1u) << "its field has the keyboard";
}

TEST_F(MenuKeys, ctrl_n_begins_a_new_mesh) {
  press("Ctrl+N");
  EXPECT_EQ(session.mesh().live().vertices, 0u);
  EXPECT_FALSE(session.is_at_start());
  ASSERT_TRUE(session.run("cube").done());
  press("Ctrl+N");
  EXPECT_EQ(session.layout.open_panel, panel_opened_by(PanelOpener::loss).id) << "edits would be lost";
}

TEST_F(MenuKeys, enter_takes_an_entry_and_escape_closes) {
  ASSERT_TRUE(session.run("split 0-1").done());
  for (const char* chord : {"F10", "Right", "Escape"}) press(chord);
  EXPECT_FALSE(gui.has_menu(session.layout));
  EXPECT_EQ(session.document().position(), 1u);
  for (const char* chord : {"F10", "Right", "Enter"}) press(chord);
  EXPECT_EQ(session.document().position(), 0u) << "undo is the first entry of Edit";
  EXPECT_FALSE(gui.has_menu(session.layout));
  for (const char* chord : {"F10", "Right", "Enter"}) press(chord);
  EXPECT_EQ(session.document().position(), 1u) << "what cannot be done is passed over: redo";
}

TEST_F(MenuKeys, arrows_go_into_a_menu_of_a_menu_and_out_again) {
  const glm::dvec3 eye = session.view.camera.eye;
  ASSERT_TRUE(session.run("menu view").done());
  frames(3);
  for (const char* chord : {"Down", "Right"}) press(chord);  // past what needs a selection
  ASSERT_TRUE(shows("Front")) << "the named views";
  press("Left");
  EXPECT_FALSE(shows("Front"));
  for (const char* chord : {"Right", "Down", "Enter"}) press(chord);
  EXPECT_NE(session.view.camera.eye, eye);
  EXPECT_EQ(session.run("menu nothing").exit_code, ExitCode::usage);
}

TEST_F(MenuKeys, alt_alone_opens_them_but_not_with_anything_else) {
  input_.key_down("Alt");
  input_.key_down("Alt+K");
  input_.key_up("Alt+K");
  input_.key_up("Alt");
  input_.key_down("Alt");
  input_.press(MouseButton::left, {{640, 560}, {.alt = true}});
  input_.release(MouseButton::left, {{640, 560}, {.alt = true}});
  input_.key_up("Alt");
  input_.key_down("Alt");
  input_.let_go();
  input_.key_up("Alt");
  frames(4);
  EXPECT_FALSE(gui.has_menu(session.layout));
  press("Alt");
  EXPECT_TRUE(gui.has_menu(session.layout));
  press("Alt");
  EXPECT_FALSE(gui.has_menu(session.layout));
  ASSERT_TRUE(gui.run(session, "panel keys").done());
  frames(3);
  press("Alt");
  EXPECT_EQ(session.layout.open_panel, "keys");
}

TEST_F(MenuKeys, a_palette_that_was_just_used_opens_again_at_once) {
  input_.key_down("F3");
  frames(4);
  gui.text("split 0-1");
  frames(1);
  // No frame comes between these.
  input_.key_down("Enter");
  input_.key_up("Enter");
  input_.key_down("F3");
  EXPECT_EQ(session.document().position(), 1u);
  EXPECT_EQ(session.layout.open_panel, "command");
  frames(3);
  gui.text("undo");
  input_.key_down("Enter");
  input_.key_up("Enter");
  frames(3);
  EXPECT_EQ(session.document().position(), 0u) << "its field has the keyboard and was empty";
}

TEST_F(MenuKeys, keys_that_come_faster_than_frames_go_where_they_were_meant) {
  const auto tap = [&](const std::string& chord) {
    input_.key_down(chord);
    input_.key_up(chord);
  };
  ASSERT_TRUE(session.run("split 0-1").done());
  for (const char* chord : {"F10", "Right", "Enter"}) tap(chord);
  frames(4);
  EXPECT_EQ(session.document().position(), 0u) << "undo, the first entry of Edit";
  for (const char* chord : {"F10", "Right", "Right", "Right", "Down", "Down", "Escape", "4"}) tap(chord);
  frames(4);
  EXPECT_FALSE(gui.has_menu(session.layout));
  EXPECT_EQ(session.selecting.mode, PickMode::halfedge) << "the view has the keys again";
  tap("F3");
  tap("4");  // a letter of the field, no command
  frames(4);
  EXPECT_EQ(session.layout.open_panel, "command");
}

TEST_F(MenuKeys, the_palette_takes_the_first_that_it_finds_where_the_line_is_none) {
  press("F3");
  write("simpl");
  EXPECT_TRUE(shows("Showsalllevelsofdetail")) << "there are several";
  press("Enter");
  EXPECT_EQ(session.layout.open_panel, "values") << gui.said().en;
  EXPECT_EQ(session.layout.asked_algorithm, "simplify");
  press("Escape");
  press("F3");
  write("simplify");  // a command, though one that lacks what its fields ask for
  press("Enter");
  EXPECT_EQ(session.layout.open_panel, "values") << gui.said().en;
  press("Escape");
  press("F3");
  write("smooth");  // lacks nothing, and asks all the same, as the menu does
  press("Enter");
  EXPECT_EQ(session.layout.open_panel, "values") << gui.said().en;
  EXPECT_EQ(session.layout.asked_algorithm, "smooth");
  press("Escape");
  press("F3");
  write("mean curv");
  press("Enter");
  EXPECT_EQ(session.log().size(), 0u);
  EXPECT_EQ(session.layout.open_panel, "");
  EXPECT_TRUE(shows("Mean curvature"));
  press("F3");
  write("no such thing");
  EXPECT_TRUE(shows("Nothing is found by these words."));
  press("Enter");
  EXPECT_EQ(session.layout.open_panel, "command");
  EXPECT_FALSE(gui.said().en.empty());
}

// The row of an entry is both of its lines.
TEST_F(MenuKeys, an_entry_of_the_palette_is_taken_by_a_click_on_its_second_line_too) {
  for (const char* typed : {"curvature", "colours mean_curvature"}) {  // among others, and alone with its whole help
    ASSERT_TRUE(session.run("colours off").done());
    press("F3");
    write(typed);
    ASSERT_TRUE(shows("Howmuchthesurfacebends")) << typed;
    click(DrawnText(gui).last_place("Howmuchthesurfacebends"));
    ASSERT_TRUE(session.view.colouring) << typed << ": " << gui.said().en;
    EXPECT_EQ(session.view.colouring->map->id, "mean_curvature");
  }
}

TEST_F(MenuKeys, the_palette_measures_what_is_selected) {
  ASSERT_TRUE(session.run("select 0-1").done());
  for (const char* typed : {"measure", "measure sel"}) {
    press("F3");
    write(typed);
    EXPECT_TRUE(shows("Measuretheselection")) << typed;
    press("Enter");
    EXPECT_EQ(session.selecting.measures.size(), 1u) << typed << ": " << gui.said().en;
    session.selecting.measures.clear();
  }
  ASSERT_TRUE(session.run("select none").done());
  press("F3");
  write("measure");
  press("Enter");
  EXPECT_EQ(session.selecting.asked_line, "measure") << gui.said().en;
  EXPECT_EQ(session.layout.open_panel, "") << "so that the mesh can be pointed at";
}

// What was pointed at is refused, and asked for again: the status line tells why until something else is pointed at.
TEST_F(MenuKeys, what_is_asked_for_again_says_why) {
  ASSERT_TRUE(session.run("ask make_face v7 v3 v2").done());
  frames(3);
  EXPECT_TRUE(shows("Pointatavertex"));
  press("Enter");
  EXPECT_EQ(session.selecting.asked_line, "make_face") << "it begins anew";
  ASSERT_NE(gui.said().en, "");
  EXPECT_TRUE(shows(without_spaces(gui.said().en).substr(0, 24))) << gui.said().en;
  EXPECT_TRUE(shows("Pointatavertex"));
  const glm::dvec2 at =
      session.view.origin + project(session.view.camera, session.view.size, session.mesh().position(Vertex(3)))->pixel;
  for (const char* const does : {"press left ", "release left "})
    gui.run(session, does + std::to_string(std::lround(at.x)) + "," + std::to_string(std::lround(at.y)));
  frames(3);
  EXPECT_EQ(session.selecting.asked_line, "make_face v3") << gui.said().en;
  EXPECT_TRUE(shows("Pointatavertex"));
  EXPECT_EQ(gui.said().en, "");
}

TEST_F(MenuKeys, the_palette_names_what_is_missing_and_takes_a_refusal_away_with_its_command) {
  press("F3");
  write("select shorter");
  press("Enter");
  press("Enter");
  EXPECT_TRUE(shows("alengthismissing:shorter")) << gui.said().en;
  const std::size_t told = DrawnText(gui).count("alengthismissing");
  press("Down");
  EXPECT_LT(DrawnText(gui).count("alengthismissing"), told) << "only the status line tells it";
}

TEST_F(MenuKeys, the_palette_has_its_last_lines_behind_up) {
  for (const char* line : {"select f0 f1", "select none"}) {
    press("F3");
    write(line);
    press("Enter");
  }
  press("F3");
  for (const char* chord : {"Up", "Up", "Enter"}) press(chord);
  EXPECT_EQ(session.selecting.selection.size(), 2u) << gui.said().en;
}

TEST_F(MenuKeys, the_palette_says_once_how_a_line_is_written) {
  press("F3");
  for (const char* typed : {"poke", " f0"}) {
    write(typed);
    EXPECT_EQ(DrawnText(gui).count("pokefN[X,Y,Z]"), 1u) << typed;
  }
}

TEST_F(MenuKeys, enter_with_nothing_to_do_says_so_in_plain_words) {
  press("Enter");
  EXPECT_EQ(gui.said().en, "there is nothing to carry out here: no click was refused, and nothing waits for elements");
}

TEST_F(MenuKeys, the_palette_cuts_no_name_short_for_a_long_line) {
  press("F3");
  write("divide");
  EXPECT_TRUE(shows("divide a face from vertex to vertex, or join"));
  EXPECT_TRUE(shows("either separate_loop selected | unite_ring selected | make_edge selected"));
  EXPECT_EQ(DrawnText(gui).cut_in_height(), "") << "its lines end whole";
  EXPECT_EQ(DrawnText(gui).cut_sideways(), "");
}

// What takes long is carried out behind the palette, which comes back with the line where that fails.
TEST_F(MenuKeys, the_palette_comes_back_with_a_file_that_cannot_be_opened) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
  press("F3");
  write("open " + file);
  press("Enter");
  frames(5);
  EXPECT_EQ(session.layout.open_panel, "command");
  EXPECT_TRUE(shows("cut.ply")) << "the line stands there to be mended";
  const std::string why = without_spaces(gui.said().en).substr(0, 16);
  EXPECT_EQ(DrawnText(gui).count(why), 3u) << "in the field, below it and in the status line: " << gui.said().en;
  press("Escape");
  press("F3");
  frames(3);
  EXPECT_FALSE(shows("cut.ply")) << "it opens empty as ever";
}

// A command that lacks something is begun, as by a click on it; refused only when it is entered once more.
TEST_F(MenuKeys, a_bare_command_that_lacks_something_is_begun) {
  press("F3");
  write("repair");
  press("Enter");
  EXPECT_TRUE(shows("Repair all"));
  EXPECT_EQ(gui.said().en, "");
  press("Enter");
  EXPECT_EQ(session.layout.open_panel, "") << "there is one way to go on";
  EXPECT_NE(gui.said().en, "");
  press("F3");
  write("view");
  press("Enter");
  EXPECT_EQ(session.layout.open_panel, "command");
  press("Enter");
  EXPECT_NE(gui.said().en.find("the command reads"), std::string::npos) << gui.said().en;
}

TEST_F(MenuKeys, the_palette_completes_paths) {
  test::TemporaryFolder folder;
  folder.write("inner place/torus.off", test::read_file(test::asset("torus.off")));
  press("F3");
  write("open " + folder.path().string() + "/in");
  press("Tab");
  press("Tab");
  press("Enter");
  EXPECT_EQ(session.document().path(), folder.at("inner place/torus.off"));
}

TEST_F(MenuKeys, a_file_is_opened_by_typing_arrows_and_tab) {
  test::TemporaryFolder folder;
  folder.write("inner/torus.off", test::read_file(test::asset("torus.off")));
  folder.copy(test::asset("cube.obj"), "cube.obj");
  folder.copy(test::asset("fin.obj"), "fin.obj");
  ASSERT_TRUE(session.run("open " + file_argument(folder.at("cube.obj"))).done());
  press("Ctrl+O");
  write("fi");
  press("Tab");
  press("Enter");
  EXPECT_EQ(session.document().path(), folder.at("fin.obj"));
  press("Ctrl+O");
  for (const char* chord : {"Up", "Up", "Up", "Enter"}) press(chord);
  EXPECT_EQ(session.layout.open_panel, "open") << "it is in the folder now";
  for (const char* chord : {"Down", "Enter"}) press(chord);
  EXPECT_EQ(session.document().path(), folder.at("inner/torus.off"));
  EXPECT_EQ(session.layout.open_panel, "");
}

TEST_F(MenuKeys, files_are_appended_and_the_selection_saved_from_the_browser) {
  test::TemporaryFolder folder;
  folder.copy(test::asset("cube.obj"), "cube.obj");
  ASSERT_TRUE(session.run("open " + file_argument(folder.at("cube.obj"))).done());
  ASSERT_TRUE(gui.run(session, "panel append").done());
  frames(3);
  press("Enter");
  EXPECT_EQ(session.mesh().live().faces, 12u);
  EXPECT_EQ(session.layout.open_panel, "");
  ASSERT_TRUE(session.run("select f0").done());
  ASSERT_TRUE(gui.run(session, "panel save_selected").done());
  frames(3);
  write("one.off");
  press("Enter");
  auto part = Document::open(folder.at("one.off"));
  ASSERT_TRUE(part);
  EXPECT_EQ(part.value()->mesh().live().faces, 1u);
  EXPECT_EQ(session.document().path(), folder.at("cube.obj")) << "the document stays what it is";
}

TEST_F(MenuKeys, a_question_is_answered_by_arrows_and_enter) {
  ASSERT_TRUE(session.run("split 0-1").done());
  gui.leave(session, {true, {}});
  frames(4);
  press("Right");
  press("Enter");
  EXPECT_TRUE(gui.wants_quit()) << "the second button discards";
}

}  // namespace
}  // namespace ryosen
