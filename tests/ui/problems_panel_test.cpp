// The problems panel: a kind unfolds to its repairs and its elements; a press repairs, asks for a value, or goes there.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>  // which windows are tooltips

#include <algorithm>
#include <glm/common.hpp>
#include <optional>

#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"
#include "ryosen/analysis/problems.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

using test::DrawnText;

class ProblemsPanel : public testing::Test, protected test::Laid {
 protected:
  ProblemsPanel() : Laid("cube.obj", test::tall_window) {}

  // Unfolds the row of a kind with so many findings.
  void unfold(const std::string& row) { click(DrawnText(gui).place(row)); }
  glm::dvec2 place(std::string_view text) { return DrawnText(gui).place(text); }
  // Everything that is drawn in the panel below a place, as it is read.
  bool is_drawn(std::string_view text) { return DrawnText(gui).count(text) > 0; }
};

TEST_F(ProblemsPanel, a_press_on_a_repair_does_it_and_undo_takes_it_back) {
  open("duplicate_face.obj");
  ASSERT_EQ(session.mesh().live().faces, 2u);
  unfold("1duplicateface");
  click(place("Removeduplicatefaces"));
  ASSERT_EQ(session.document().position(), 1u) << "one entry of the history";
  EXPECT_EQ(session.document().history()[0].command, "repair remove_duplicates");
  EXPECT_EQ(session.mesh().live().faces, 1u);
  EXPECT_TRUE(gui.said().en.starts_with("repair remove_duplicates: ")) << gui.said().en;
  EXPECT_NE(gui.said().ja, gui.said().en);
  ASSERT_TRUE(session.run("undo").done());
  frames(2);
  EXPECT_EQ(session.mesh().live().faces, 2u);
}

// A copy in its place is seen nowhere else.
TEST_F(ProblemsPanel, points_that_lie_on_others_are_listed_with_a_repair_and_a_click_selects_all_of_a_place) {
  EXPECT_FALSE(is_drawn("coincident"));
  ASSERT_TRUE(session.run("duplicate elements=f0").done());
  frames(3);
  unfold("8coincidentpoints");
  EXPECT_TRUE(is_drawn("Weldequalpoints") || is_drawn("Weld")) << "a repair is offered";
  click(DrawnText(gui).place("v0v1v2"));
  EXPECT_EQ(session.selecting.selection, (Elements{Vertex(0), Vertex(8)}));
  ASSERT_TRUE(session.run("select problem coincident_points").done());
  EXPECT_EQ(session.selecting.selection.size(), 8u);
  ASSERT_TRUE(session.run("undo").done());
  gui.pointer({500, 400});
  frames(4);
  EXPECT_FALSE(is_drawn("coincident"));
}

// What was tried on a step was done to the mesh beneath.
TEST_F(ProblemsPanel, nothing_is_repaired_while_another_mesh_is_shown) {
  open("isolated_vertex.obj");
  const std::uint64_t hash = session.mesh().hash();
  for (const char* const line : {"steps script square", "steps forward"}) ASSERT_TRUE(session.run(line).done());
  frames(4);
  const glm::dvec2 all = place("Repairall");
  EXPECT_FALSE(is_drawn("Trial:"));
  EXPECT_TRUE(is_drawn("Repairsaredoneonthemesh"));
  click(all);
  frames(3);
  ASSERT_TRUE(session.shown.player());
  EXPECT_EQ(gui.said().en, "") << "the button is off";
  EXPECT_EQ(session.run("repair").exit_code, ExitCode::refused);
  ASSERT_TRUE(session.run("steps close").done());
  EXPECT_EQ(session.mesh().hash(), hash);
  frames(4);
  EXPECT_TRUE(is_drawn("Trial:"));
}

TEST_F(ProblemsPanel, a_repair_that_needs_a_value_unfolds_its_field_and_enter_runs_it) {
  open("moebius.off");
  unfold("1boundaryloop");
  click(place("Weldclosepoints"));
  EXPECT_EQ(session.layout.open_panel, "") << "the field stands in the row";
  EXPECT_EQ(session.document().position(), 0u) << "nothing was done yet";
  frames(3);
  for (const char c : std::string_view("0.001")) gui.character(static_cast<unsigned>(c));
  frames(1);
  gui.key(ImGuiKey_Enter, true);
  gui.key(ImGuiKey_Enter, false);
  frames(3);
  EXPECT_TRUE(gui.said().en.starts_with("repair weld_close distance=0.001: ")) << gui.said().en;
}

TEST_F(ProblemsPanel, a_repair_says_before_the_click_what_it_would_change_and_leave) {
  open("bow_tie.obj");
  unfold("1non-manifoldvertex");
  EXPECT_TRUE(is_drawn("Trial:Onepointwas")) << "in the row";
  const std::uint64_t revision = session.document().revision();
  gui.pointer(place("Detachatnon"));
  frames(3);
  EXPECT_TRUE(is_drawn("Onepointwasaddedtotakethesurfaceapartat1place.")) << "whole beside the pointer";
  EXPECT_EQ(session.document().revision(), revision) << "nothing was written";
  open("seam.obj");
  unfold("2boundaryloops");
  gui.pointer(place("Fillholes"));
  frames(3);
  EXPECT_TRUE(is_drawn("2holeswerefilledby4triangles"));
}

// In three lines: all of it, fewer of its parts, or how much it is.
TEST_F(ProblemsPanel, what_a_trial_found_out_is_told_in_whole_sentences) {
  open("bow_tie.obj");
  EXPECT_TRUE(is_drawn("Trial:Onepointwasaddedtotakethesurfaceapartat1place."));
  open("seam.obj");
  EXPECT_TRUE(is_drawn("Trial:Nothingwaschanged.2problemsareleft."));
  gui.pointer(place("Trial:"));
  frames(3);
  EXPECT_TRUE(is_drawn("Trial:Nothingwaschanged.Left:Boundaryloop:")) << "more of it beside the pointer";
}

TEST_F(ProblemsPanel, the_numbers_of_a_repair_change_what_it_would_do) {
  open("seam.obj");
  unfold("2boundaryloops");
  const glm::dvec2 button = place("Fillholes");
  click({button.x - 22, button.y});
  ASSERT_TRUE(is_drawn("Mostedges"));
  click({place("Mostedges").x + 150, place("Mostedges").y});
  gui.character('3');
  frames(3);
  gui.pointer(place("Fillholes"));
  frames(3);
  EXPECT_TRUE(is_drawn("0holeswerefilled.Left:Boundaryloop:thisrepairleavesit")) << "their loops have four edges";
  click(place("Fillholes"));
  EXPECT_EQ(session.document().position(), 0u);
  EXPECT_TRUE(gui.said().en.starts_with("repair fill_holes most_edges=3 shape=auto crossing=refuse: "))
      << gui.said().en;
}

// Where every row of the panel stands.
TEST_F(ProblemsPanel, no_row_moves_while_the_pointer_stays_after_a_repair) {
  open("../tests/data/doubled_triangle.obj");  // four kinds that one repair takes away; a boundary loop comes
  unfold("1duplicateface");
  const glm::dvec2 button = place("Removeduplicatefaces"), last = place("1duplicateface");
  click(button);
  ASSERT_EQ(session.document().position(), 1u);
  EXPECT_TRUE(is_drawn("0duplicatefaces:mended"));
  EXPECT_EQ(place("0duplicatefaces:mended").y, last.y);
  EXPECT_EQ(place("Removeduplicatefaces"), button) << "under the pointer";
  for (int again = 0; again < 3; ++again) click(button);
  EXPECT_EQ(session.document().position(), 1u) << "nothing else is done there";
  EXPECT_GT(place("1boundaryloop").y, button.y) << "what has come stands behind";
  gui.pointer({500, 400});
  frames(3);
  EXPECT_FALSE(is_drawn("mended")) << "they go when the pointer does";
}

TEST(problems_panel, double_clicks_in_one_place_never_run_two_different_repairs) {
  std::size_t repaired = 0;
  for (const char* file : {"fin.obj", "hanging_pair.obj", "misoriented.obj", "bow_tie.obj", "duplicate_face.obj",
                           "collinear.obj", "isolated_vertex.obj", "../tests/data/doubled_triangle.obj"}) {
    test::Laid laid(file, test::tall_window);
    std::optional<DrawnText> drawn(laid.gui);
    for (const ProblemRow& row : problem_table()) {
      for (std::size_t count = 1; count < 10; ++count) {
        std::string name = std::to_string(count) + row.name_of(count).en;
        std::erase(name, ' ');
        if (drawn->count(name) == 0) continue;
        laid.click(drawn->place(name));
        drawn.emplace(laid.gui);
      }
    }
    const glm::dvec2 header = DrawnText(laid.gui).place("Problems");
    for (double y = 16; y < 560; y += test::is_long_run() ? 7 : 18) {
      laid.gui.pointer({500, 400});
      laid.open(file);
      const double right = laid.session.view.origin.x + laid.session.view.size.width;  // where the column begins
      const glm::dvec2 at{glm::mix(right, static_cast<double>(test::tall_window.width), 0.2), header.y + y};
      laid.click(at);
      const std::vector<HistoryEntry> first = laid.session.document().history();
      laid.click(at);
      const std::vector<HistoryEntry>& second = laid.session.document().history();
      if (first.empty()) continue;
      ++repaired;
      for (const HistoryEntry& entry : second) EXPECT_EQ(entry.command, first[0].command) << file << " at " << y;
    }
  }
  EXPECT_GT(repaired, test::is_long_run() ? 20u : 12u);
}

TEST_F(ProblemsPanel, repair_all_is_one_entry_and_says_what_could_not_be_mended) {
  open("isolated_vertex.obj");
  gui.pointer(place("Repairall"));
  frames(3);
  EXPECT_TRUE(is_drawn("\"Removeisolatedvertices\"isforit"));
  open("fin.obj");
  click(place("Repairall"));
  ASSERT_EQ(session.document().history().size(), 1u);
  EXPECT_EQ(session.document().history()[0].command, "repair default");
  ASSERT_TRUE(is_drawn("Notmended"));
  const RepairReport& report = *session.findings().last_repair();
  ASSERT_FALSE(report.left.empty());
  session.run("select");
  const glm::dvec3 eye = session.view.camera.eye;
  session.selecting.selection.clear();
  const std::string name = session.selecting.names_of({report.left.front().elements.front()}).front();
  const glm::dvec2 heading = place("Notmended");
  bool was_found = false;
  for (double y = heading.y + 12; y < heading.y + 140 && !was_found; y += 6) {
    click({heading.x + 2, y});
    was_found = !session.selecting.selection.empty();
  }
  ASSERT_TRUE(was_found) << "a link to " << name;
  EXPECT_EQ(session.selecting.selected_names().front(), name);
  EXPECT_NE(session.view.camera.eye, eye) << "it flies there";
  EXPECT_EQ(session.document().history().size(), 1u);
}

TEST_F(ProblemsPanel, beside_repair_all_stands_what_moves_geometry_where_only_degenerate_faces_are_left) {
  open("fin.obj");
  EXPECT_FALSE(is_drawn("Repairallmovesnopoint"));
  const test::TemporaryFolder folder;
  const std::string path =
      folder.write("flat.obj", "v 0 0 0\nv 2 0 0\nv 1 0 0\nv 1 2 0\nv 1 -2 0\nf 1 3 2\nf 1 2 4\nf 3 1 5\nf 2 3 5\n");
  ASSERT_TRUE(session.run("open " + file_argument(path)).done());
  frames(4);
  ASSERT_TRUE(is_drawn("Repairallmovesnopoint,andleavesthis:Degenerateface."));
  EXPECT_TRUE(is_drawn("Trial:Onefacewithoutareawasremoved")) << "with its trial";
  const glm::dvec2 button = place("Removefaceswithoutarea");
  click(button);
  ASSERT_EQ(session.document().history().size(), 1u);
  EXPECT_EQ(session.document().history()[0].command, "repair remove_degenerate");
  EXPECT_EQ(place("Removefaceswithoutarea"), button) << "it stays under the pointer";
  gui.pointer({500, 400});
  frames(3);
  EXPECT_FALSE(is_drawn("Repairallmovesnopoint"));
}

TEST_F(ProblemsPanel, loose_pieces_that_a_repair_leaves_are_offered_for_deletion) {
  ASSERT_TRUE(
      session.run("open " + file_argument(std::string(RYOSEN_SOURCE_DIR) + "/tests/data/reports/two_fins.off")).done());
  frames(4);
  EXPECT_FALSE(is_drawn("loosepieces"));
  click(place("Repairall"));
  ASSERT_EQ(session.document().history().size(), 1u);
  gui.pointer({500, 400});
  frames(3);
  click(place("Selecttheloosepieces(2)"));
  EXPECT_FALSE(session.selecting.selection.empty());
  EXPECT_EQ(session.document().history().size(), 1u);
  click(place("Deletetheloosepieces(2)"));
  ASSERT_EQ(session.document().history().size(), 2u);
  EXPECT_EQ(session.mesh().live().faces, 4u);
  frames(3);
  EXPECT_FALSE(is_drawn("theloosepieces")) << "nothing is left to delete";
}

// Of all that is left on a mesh with every kind of fault no more is told than a glance takes.
TEST_F(ProblemsPanel, a_repair_tells_about_eight_lines_of_a_long_report_and_counts_the_rest) {
  open("fin.obj");
  for (const char* const file : {"three_tri_edge.off", "bow_tie.obj", "misoriented.obj", "duplicate_face.obj",
                                 "isolated_vertex.obj", "collinear.obj", "hanging_pair.obj", "klein_bottle.off"})
    ASSERT_TRUE(session.run("append " + test::asset(file)).done()) << file;
  for (const char* const language : {"language en", "language ja"}) {
    ASSERT_TRUE(session.run("language en").done());
    frames(3);
    const glm::dvec2 button = place("Repairall");
    ASSERT_TRUE(session.run(language).done());
    gui.pointer(button);
    frames(3);
    float height = 0;
    for (const ImGuiWindow* const one : GImGui->Windows)
      if (one->Active && (one->Flags & ImGuiWindowFlags_Tooltip) != 0) height = std::max(height, one->Size.y);
    EXPECT_GT(height, 0) << language;
    EXPECT_LT(height, 18 * ImGui::GetTextLineHeightWithSpacing()) << language;
  }
  ASSERT_TRUE(session.run("language en").done());
  frames(3);
  EXPECT_TRUE(is_drawn("more."));
}

TEST_F(ProblemsPanel, on_a_large_mesh_only_what_is_pointed_at_is_tried_and_in_the_background) {
  open("stanford_bunny.obj");
  ASSERT_TRUE(is_costly_to_try(session.mesh()));
  session.trials.in_background = true;
  unfold("5boundaryloops");
  gui.pointer({500, 400});
  frames(3);
  EXPECT_FALSE(session.trials.share()) << "nobody points at one";
  gui.pointer(place("Fillholes"));
  frames(3);
  EXPECT_TRUE(session.trials.share());
  gui.pointer({500, 400});
  frames(3);
  EXPECT_FALSE(session.trials.share()) << "cancelled when the pointer goes";
}

TEST(problems_panel, is_legible_in_both_languages_and_sizes_with_its_repairs_unfolded) {
  for (const Size size : {Size{640, 480}, Size{1280, 800}})
    for (const char* language : {"en", "ja"})
      for (const char* file : {"fin.obj", "isolated_vertex.obj", "moebius.off"}) {
        SCOPED_TRACE(std::string(file) + " " + language + " " + std::to_string(size.width));
        test::Laid laid(file, size);
        ASSERT_TRUE(laid.session.run(std::string("language ") + language).done());
        ASSERT_TRUE(laid.session.run("panel problems").done());
        laid.frames(3);
        for (int y = 20; y < size.height - 30; y += 21) laid.click({size.width - 120.0, static_cast<double>(y)});
        laid.frames(3);
        EXPECT_EQ(DrawnText(laid.gui).cut_sideways(), "");
        EXPECT_EQ(DrawnText(laid.gui).overlapping(), "");
      }
}

TEST_F(ProblemsPanel, a_press_on_an_element_selects_it_and_goes_there) {
  open("duplicate_face.obj");
  const glm::dvec3 eye = session.view.camera.eye;
  unfold("4misorientededges");
  click(place("0-1"));
  ASSERT_EQ(session.selecting.selection.size(), 3u) << "the edge and its faces";
  EXPECT_EQ(session.document().position(), 0u);
  EXPECT_EQ(session.selecting.selection[0].kind, Element::Kind::edge);
  EXPECT_NE(session.view.camera.eye, eye);
}

TEST_F(ProblemsPanel, a_press_on_a_quarantined_face_says_why_it_is_set_aside_and_its_line) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("aside.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 1\n");
  ASSERT_TRUE(session.run("open " + file_argument(path)).done());
  frames(3);
  const ProblemRow& kind = *std::find_if(problem_table().begin(), problem_table().end(), [](const ProblemRow& row) {
    return row.quarantined && row.quarantined(QuarantinedFace{1, 8, "repeated_corner", {0, 1, 1}, {}, {}}, 4);
  });
  click(DrawnText(gui).place("1" + kind.name_of(1).en));
  click(DrawnText(gui).place("f1"));
  const std::string why =
      "Face f1 is set aside: it visits vertex v1 more than once. It has been since the file was read";
  EXPECT_EQ(gui.said().en, why + " (line 8).");
  EXPECT_NE(gui.said().ja, gui.said().en);
  frames(3);
  EXPECT_EQ(DrawnText(gui).count(gui.said().en), 2u) << "in the status line and beside the pointer";
}

TEST_F(ProblemsPanel, claims_nothing_of_a_mesh_that_is_not_there) {
  EXPECT_TRUE(is_drawn("Noproblemsfound."));
  ASSERT_TRUE(session.run("new").done());
  frames(3);
  EXPECT_FALSE(is_drawn("Noproblemsfound."));
  EXPECT_TRUE(is_drawn("Thereisnomeshyet."));
}

}  // namespace
}  // namespace ryosen
