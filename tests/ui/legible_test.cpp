// Nothing is clipped or covered: texts fit their places in both languages, lists end with whole rows, tooltips lie
// beside the panels, and thumbs can be seen and grabbed.
#include <gtest/gtest.h>
#include <imgui_internal.h>  // where a list is scrolled to

#include <algorithm>
#include <cmath>
#include <set>

#include "app/editor/commands/palette.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"
#include "app/ui/style.h"
#include "app/ui/widgets.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/ops/all.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

using test::DrawnText;
using test::Laid;

std::string soup_of_triangles(int n) {
  std::string vertices, faces;
  for (int i = 0; i < n; ++i) {
    const std::string x = std::to_string(2 * (i % 100)), y = std::to_string(2 * (i / 100)), k = std::to_string(3 * i);
    vertices += x + " " + y + " 0\n" + x + ".9 " + y + " 0\n" + x + " " + y + ".9 0\n";
    faces += "3 " + k + " " + std::to_string(3 * i + 1) + " " + std::to_string(3 * i + 2) + "\n";
  }
  return "OFF\n" + std::to_string(3 * n) + " " + std::to_string(n) + " 0\n" + vertices + faces;
}

// A window with every panel open, or one after another behind its tab.
struct WindowCase {
  Size size;
  float scale;
};

class LegibleTest : public testing::TestWithParam<WindowCase> {};

TEST_P(LegibleTest, no_text_is_cut_or_lies_over_another_in_either_language) {
  const test::TemporaryFolder folder;
  const std::string soup = folder.write("soup.off", soup_of_triangles(5000));
  const auto [size, scale] = GetParam();
  Laid laid("fin.obj", size, scale);
  const auto is_legible = [&, width = size.width, height = size.height](const std::string& where) {
    laid.gui.pointer({width / 2.0, height / 2.0});
    laid.frames(4);
    const DrawnText text(laid.gui);
    EXPECT_EQ(text.cut_sideways(), "") << where;
    EXPECT_EQ(text.cut_in_height(), "") << where;
    EXPECT_EQ(text.overlapping(), "") << where;
  };
  for (const std::string& mesh : {test::asset("fin.obj"), test::asset("torus.off"), soup}) {
    ASSERT_TRUE(laid.session.run("open " + file_argument(mesh)).done());
    laid.session.run("select f0");
    for (const std::string language : {"en", "ja"}) {
      ASSERT_TRUE(laid.session.run("language " + language).done());
      is_legible(mesh + " " + language);
      for (const PanelRow& row : panel_list()) {
        const bool has_tabs = areas_of({}, size, scale).has_tabs;
        if (row.place == PanelPlace::over || (!has_tabs && row.shown_at_first())) continue;
        const std::string panel = "panel " + std::string(row.id);
        ASSERT_TRUE(laid.session.run(panel + (has_tabs ? " flyout" : " on")).done());
        is_legible(mesh + " " + language + " " + std::string(row.id));
        if (!has_tabs) {
          ASSERT_TRUE(laid.session.run(panel + " off").done());
        }
      }
      for (const PanelRow& row : panel_list()) {
        if (row.place != PanelPlace::over) continue;
        const bool asks = row.opened_by == PanelOpener::asked_values;
        ASSERT_TRUE(laid.session.run(asks ? "values sphere" : "panel " + std::string(row.id)).done());
        is_legible(mesh + " " + language + " " + std::string(row.id));
        ASSERT_TRUE(laid.session.run("panel none").done());
      }
      for (const char* line : {"columns left 200", "columns right 200"}) ASSERT_TRUE(laid.session.run(line).done());
      is_legible(mesh + " " + language + " narrow");
      for (const char* line : {"columns left 240", "columns right 292"}) ASSERT_TRUE(laid.session.run(line).done());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Windows, LegibleTest,
                         testing::Values(WindowCase{{640, 480}, 1}, WindowCase{{900, 700}, 1},
                                         WindowCase{{1280, 800}, 1}, WindowCase{{1280, 1400}, 1},
                                         WindowCase{{2560, 1600}, 2}),
                         [](const auto& test) {
                           return std::to_string(test.param.size.width) + "x" + std::to_string(test.param.size.height) +
                                  "_at_" + std::to_string(static_cast<int>(test.param.scale));
                         });

TEST(legible, problems_remedies_and_measured_forms_fit_a_narrow_column) {
  for (const std::string language : {"en", "ja"}) {
    Laid laid("fin.obj", {1280, 1600});
    for (const std::string& line :
         {"language " + language, std::string("columns right 200"), std::string("tool collapse")})
      ASSERT_TRUE(laid.session.run(line).done());
    laid.frames(3);
    const auto is_legible = [&](const char* what) {
      laid.frames(3);
      EXPECT_EQ(DrawnText(laid.gui).cut_sideways(), "") << language << ", " << what;
      EXPECT_EQ(DrawnText(laid.gui).overlapping(), "") << language << ", " << what;
    };
    const PixelRect view = laid.gui.view_area({1280, 1600}, laid.session.layout);
    // Every header, row and button of the column, one after another: none is lower than 17 pixels.
    for (double y = view.y0 + 10; y < view.y1; y += test::is_long_run() ? 9 : 16) {
      if (laid.session.layout.folded.empty()) laid.click({view.x1 + 60.0, y});
      ASSERT_TRUE(laid.session.run("panel none").done());
      laid.session.layout.folded.clear();
      is_legible(std::to_string(y).c_str());
    }
    for (double x = view.x0 + 60; x < view.x1; x += 60) {
      const glm::dvec2 pixel{x, (view.y0 + view.y1) / 2.0};
      laid.session.pointing.point_at(pixel);
      is_legible("pointed at");
      laid.gui.click(laid.session, {MouseButton::left, pixel, {}, false});
      is_legible("clicked");
      laid.session.selecting.release_verdict();
    }
  }
}

TEST(legible, the_whole_sum_of_a_mesh_of_thousands_of_parts_is_shown) {
  const test::TemporaryFolder folder;
  Laid laid("cube.obj", test::tall_window);
  ASSERT_TRUE(laid.session.run("open " + file_argument(folder.write("soup.off", soup_of_triangles(5000)))).done());
  laid.frames(3);
  const DrawnText text(laid.gui);
  EXPECT_EQ(text.count("V ? E + F = 5,000, as expected: 2 (5,000 ? 0) ? 5,000"), 1u);
}

TEST(legible, the_sum_is_a_sentence_with_each_number_once) {
  Laid laid("cube.obj", test::tall_window);
  for (const auto& [line, told] :
       {std::pair("exercise cube_with_hole", "V ? E + F ? H = 0, as expected: 2 (1 ? 1) ? 0"),
        {"new", "V ? E + F = 0, as expected: 2 (0 ? 0) ? 0"},
        {"exercise triangle", "V ? E + F = 1, as expected: 2 (1 ? 0) ? 1"}}) {
    ASSERT_TRUE(laid.session.run("new").done());
    ASSERT_TRUE(laid.session.run(line).done()) << line;
    laid.frames(3);
    EXPECT_EQ(DrawnText(laid.gui).count(told), 1u) << line;
  }
  laid.open("fin.obj");
  EXPECT_EQ(DrawnText(laid.gui).count("V ? E + F = 1 No G"), 1u) << "there is nothing to expect";
}

TEST(legible, a_long_sentence_ends_with_an_ellipsis_and_is_whole_when_it_is_pointed_at) {
  for (const int width : {640, 1280}) {
    Laid laid("tetrahedron.off", {width, 480});
    laid.gui.run(laid.session, "select " + std::string(200, 'x'));
    laid.frames(3);
    ASSERT_GT(laid.gui.said().en.size(), 200u);
    EXPECT_EQ(DrawnText(laid.gui).cut_sideways(), "") << width;
    EXPECT_EQ(DrawnText(laid.gui).count(std::string(200, 'x')), 0u);
    laid.gui.pointer({width - 30.0, 470});
    laid.frames(3);
    EXPECT_EQ(DrawnText(laid.gui).count(std::string(200, 'x')), 1u) << width;
  }
}

// At the usual width nothing has too little room.
TEST(legible, no_text_of_a_panel_is_shortened_in_either_language) {
  const test::TemporaryFolder folder;  // a short path: a panel shortens the name of a folder
  for (const char* const mesh : {"fin.obj", "torus.off"}) {
    Laid laid("cube.obj", {1280, 800});
    for (const std::string& line :
         {"open " + file_argument(folder.copy(test::asset(mesh), mesh)), std::string("select f0"),
          std::string("poke f0"), std::string("colours edge_length")})
      ASSERT_TRUE(laid.session.run(line).done()) << line;
    for (const std::string language : {"en", "ja"}) {
      ASSERT_TRUE(laid.session.run("language " + language).done());
      for (const PanelRow& row : panel_list()) {
        ASSERT_TRUE(laid.session.run("panel " + std::string(row.id)).done());
        laid.frames(5);
        EXPECT_EQ(DrawnText(laid.gui).shortened(), std::vector<std::string>()) << language << ", " << row.id;
        laid.session.run("panel none");
      }
    }
  }
}

TEST(legible, no_entry_of_the_palette_is_shortened_in_a_narrow_window) {
  Laid laid("fin.obj", {640, 480});
  for (const std::string language : {"en", "ja"}) {
    ASSERT_TRUE(laid.session.run("language " + language).done());
    for (const std::string typed : {"", "measure", "select", "weld_close", "shading"}) {
      ASSERT_TRUE(laid.session.run("panel command").done());
      laid.frames(3);
      for (const char c : typed) laid.gui.character(static_cast<unsigned>(c));
      laid.frames(3);
      laid.gui.pointer({320, 240});
      for (int notch = 0; notch < 10; ++notch) {
        const DrawnText text(laid.gui);
        EXPECT_EQ(text.shortened(), std::vector<std::string>()) << language << ", " << typed;
        EXPECT_EQ(text.overlapping(), "") << language << ", " << typed;
        laid.gui.wheel(-3);
        laid.frames(4);
      }
      laid.session.run("panel none");
      laid.frames(2);
    }
  }
}

TEST(legible, a_result_that_is_longer_than_its_line_leaves_out_the_values_that_were_given) {
  Laid laid("torus.off", {1280, 800});
  laid.gui.run(laid.session, "simplify faces=60");
  laid.frames(3);
  EXPECT_EQ(DrawnText(laid.gui).count("no_self_intersections"), 0u);
  EXPECT_EQ(DrawnText(laid.gui).count("Simplify: From 96 to 60 faces."), 1u) << laid.gui.said().en;
  laid.gui.pointer({1200, 790});
  laid.frames(3);
  EXPECT_GE(DrawnText(laid.gui).count("no_self_intersections"), 1u) << "the whole beside the pointer";
}

TEST(legible, lists_end_with_whole_rows_however_they_are_scrolled) {
  const test::TemporaryFolder folder;
  Laid laid("cube.obj", test::tall_window);
  ASSERT_TRUE(laid.session.run("open " + file_argument(folder.write("soup.off", soup_of_triangles(40)))).done());
  for (int i = 0; i < 12; ++i) ASSERT_TRUE(laid.session.run("poke f" + std::to_string(i)).done());
  laid.frames(3);
  laid.click(DrawnText(laid.gui).place("40 boundary loops"));
  const glm::dvec2 list = DrawnText(laid.gui).place("40 boundary loops") + glm::dvec2(20, 60);
  for (const double steps : {0.0, -1.0, -0.1, -3.0, 1.0, 0.2, -30.0}) {
    for (const glm::dvec2 at : {list, DrawnText(laid.gui).place("Redo") + glm::dvec2(0, 60)}) {
      laid.gui.pointer(at);
      laid.frames(2);
      laid.gui.wheel(steps);
      laid.frames(3);
      EXPECT_EQ(DrawnText(laid.gui).cut_in_height(), "") << steps;
    }
  }
}

// Of the palette, some of whose rows have a second line.
TEST(legible, the_palette_ends_with_whole_rows_however_it_is_walked_through) {
  for (const Size size : {Size{1280, 800}, Size{1280, 790}, Size{640, 480}}) {
    Laid laid("cube.obj", size);
    ASSERT_TRUE(laid.session.run("panel command").done());
    laid.frames(4);
    const float pitch = ImGui::GetTextLineHeightWithSpacing();
    const auto found_list = [] {
      const auto& all = GImGui->Windows;
      const auto is_list = [](const ImGuiWindow* window) {
        return std::string_view(window->Name).find("suggestions") != std::string_view::npos;
      };
      const auto at = std::find_if(all.begin(), all.end(), is_list);
      return at == all.end() ? nullptr : *at;
    };
    ASSERT_TRUE(found_list());
    const float room = found_list()->ContentRegionRect.GetWidth() - 10;
    std::set<long> begins{0};
    for (const PaletteEntry& entry : find_in_palette("")) {
      const std::string help = beyond_name(entry.help.en, entry.name.en);
      begins.insert(*begins.rbegin() + 1 + (help.empty() ? 0 : static_cast<long>(lines_of(help, room))));
    }
    for (int step = 0; step < 30; ++step) {
      const ImGuiWindow* const list = found_list();
      const float top = list->Scroll.y / pitch, bottom = top + list->Size.y / pitch;
      EXPECT_TRUE(begins.contains(std::lround(top))) << size.width << " " << size.height << ", step " << step;
      EXPECT_TRUE(begins.contains(std::lround(bottom))) << size.height << ", step " << step;
      laid.gui.key(ImGuiKey_DownArrow, true);
      laid.frames(1);
      laid.gui.key(ImGuiKey_DownArrow, false);
      laid.frames(4);
    }
  }
}

TEST(legible, what_is_told_of_a_row_lies_beside_its_column) {
  for (const auto& [text, told] :
       {std::pair("Split edge", "puts a vertex at"), std::pair("non-manifold edge", "vertex")}) {
    Laid laid("fin.obj");
    const glm::dvec2 row = DrawnText(laid.gui).place(text);
    const std::size_t before = DrawnText(laid.gui).count(told);
    laid.gui.pointer(row);
    laid.frames(3);
    ASSERT_GE(DrawnText(laid.gui).count(told), before);
    const PixelRect view = laid.gui.view_area(test::window, {});
    const ImDrawData& drawn = laid.gui.draw_data();
    const ImDrawList& tip = *drawn.CmdLists[drawn.CmdListsCount - 1];  // it lies over everything
    for (const ImDrawVert& vertex : tip.VtxBuffer) {
      EXPECT_GT(vertex.pos.x, view.x0) << text;
      EXPECT_LT(vertex.pos.x, view.x1) << text;
      EXPECT_LT(vertex.pos.y, test::window.height) << text;
    }
  }
}

// A window draws one frame for each event of a pointer that goes on moving.
TEST(legible, what_is_said_beside_the_pointer_is_whole_in_the_first_frame_that_says_it) {
  Laid laid("fan.obj");
  Session& session = laid.session;
  int told = 0;
  for (const char* tool : {"tool collapse", "tool swap"}) {
    ASSERT_TRUE(session.run(tool).done());
    for (std::uint32_t i = 0; i < session.mesh().edge_slots(); ++i) {
      const auto [a, b] = ends(session.mesh(), Edge(i));
      const auto at = project(session.view.camera, session.view.size,
                              (session.mesh().position(a) + session.mesh().position(b)) / 2.0);
      session.pointing.point_at(at->pixel + session.view.origin);
      laid.frames(1);
      const DrawnText first(laid.gui);
      laid.frames(3);
      const DrawnText later(laid.gui);
      for (const Reason& reason :
           session.selecting.hover() ? session.selecting.hover()->preview.verdict.reasons : std::vector<Reason>()) {
        const std::string end = Text(describe(session.mesh(), reason)).en;
        EXPECT_EQ(first.last_place(end.substr(end.rfind(' '))), later.last_place(end.substr(end.rfind(' ')))) << end;
        ++told;
      }
      session.pointing.point_away();
      if (i % 2 == 0) laid.frames(1);  // it goes, and comes again
    }
  }
  EXPECT_GT(told, 4);
}

double contrast(const ImVec4& a, const ImVec4& b) {
  const auto light = [](const ImVec4& c) {
    const auto linear = [](float x) { return x <= 0.04045f ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(c.x) + 0.7152 * linear(c.y) + 0.0722 * linear(c.z) + 0.05;
  };
  return std::max(light(a), light(b)) / std::min(light(a), light(b));
}

TEST(legible, thumbs_are_wide_long_and_seen_on_their_ground) {
  const Gui gui(1);
  for (const Theme theme : {Theme::dark, Theme::light}) {
    apply_style(theme, 1);
    const ImGuiStyle& style = ImGui::GetStyle();
    EXPECT_GE(style.ScrollbarSize - 6, 10) << "without what ImGui leaves on both sides";
    EXPECT_GE(style.GrabMinSize, 24);
    EXPECT_GE(contrast(style.Colors[ImGuiCol_ScrollbarGrab], ui_colours(theme).panel), 3);
  }
}

TEST(tools, stand_in_the_group_that_their_rows_say_and_tell_what_a_press_does) {
  Laid laid("cube.obj", test::tall_window);
  for (const OpGroupRow& group : op_groups()) {
    EXPECT_EQ(DrawnText(laid.gui).count(group.en), 1u) << group.en;
    laid.click(DrawnText(laid.gui).place(group.en));
  }
  const DrawnText text(laid.gui);
  double y = 0;
  for (const OpGroupRow& group : op_groups()) {
    EXPECT_GT(text.place(group.en).y, y) << group.en;
    y = text.place(group.en).y;
    for (const OpInfo& op : all_ops()) {
      if (op.group != group.group) continue;
      // "Delete" and "Weld" begin other texts too.
      EXPECT_GE(text.count(op.name_en), 1u) << op.name_en;
    }
  }
  const auto told = [&](const char* row, const char* sentence) {
    laid.gui.pointer(DrawnText(laid.gui).place(row));
    laid.frames(3);
    return DrawnText(laid.gui).count(sentence) == 1;
  };
  EXPECT_TRUE(told("Orient faces", "acts at once"));
  EXPECT_TRUE(told("Swap edge", "takes the tool"));
  EXPECT_TRUE(told("Make vertex", "asks for the rest"));
}

}  // namespace
}  // namespace ryosen
