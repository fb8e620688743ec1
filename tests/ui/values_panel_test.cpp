// The fields of an algorithm's values: one per parameter of its row, whatever the row is.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>  // its windows

#include <algorithm>
#include <optional>
#include <set>

#include "app/editor/camera/framing.h"
#include "app/editor/session/session.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/analysis/measures.h"
#include "ryosen/base/number_text.h"
#include "ryosen/mesh/copies.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"
#include "tests/support/core/scatter_algorithm.h"

namespace ryosen {
namespace {

class ValuesPanel : public testing::Test, protected test::Laid {
 protected:
  ValuesPanel() : Laid("cube.obj", {1280, 1000}) {}

  void type(std::string_view text) {
    for (const char c : text) gui.character(static_cast<unsigned>(c));
    frames(2);
  }
  void press(int key) {
    gui.key(key, true);
    gui.key(key, false);
    frames(2);
  }

  // What its rows are in; null where it is not there.
  static const ImGuiWindow* fields_window() {
    for (const ImGuiWindow* const one : GImGui->Windows)
      if (one->Active && std::string_view(one->Name).find("/fields") != std::string_view::npos) return one;
    return nullptr;
  }

  // Whether the frame of a field reaches over this height by more than a hair.
  static bool is_cut(const ImGuiWindow& fields, float y) {
    const ImDrawList& drawn = *fields.DrawList;
    const ImU32 frame = ImGui::ColorConvertFloat4ToU32(ImGui::GetStyle().Colors[ImGuiCol_FrameBg]);
    for (const ImDrawCmd& command : drawn.CmdBuffer)
      for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
        float low = 1e9f, high = -1e9f;
        bool is_frame = true;
        for (unsigned k = 0; k < 3; ++k) {
          const int index = drawn.IdxBuffer[static_cast<int>(command.IdxOffset + i + k)];
          const ImDrawVert& corner = drawn.VtxBuffer[index + static_cast<int>(command.VtxOffset)];
          low = std::min(low, corner.pos.y);
          high = std::max(high, corner.pos.y);
          is_frame = is_frame && corner.col == frame;
        }
        frames_seen += is_frame ? 1 : 0;
        if (is_frame && low < y - 2 && high > y + 2) return true;
      }
    return false;
  }
  static inline int frames_seen = 0;

  void press_button(std::string_view name) {
    click(test::DrawnText(gui).last_place(name));
    frames(2);
  }

  const ScopedAlgorithm scatter_{test::scatter_row()};
};

TEST_F(ValuesPanel, runs_what_its_fields_say_when_the_frame_is_laid_out) {
  bool was_laying_out = true;
  session.frontend.on_progress = [&](double) {
    was_laying_out = gui.is_laying_out();
    return true;
  };
  ASSERT_TRUE(gui.run(session, "values scatter").done());
  frames(3);
  type("50%");
  for (std::size_t i = 1; i < test::scatter_row().parameters.size(); ++i) press(ImGuiKey_Tab);
  type("v1,f0");
  press(ImGuiKey_Enter);
  frames(2);
  EXPECT_EQ(gui.said().en,
            "scatter distance=50% x=0 copies=1 share=0.5 angle=0 by=0,0,0 way=up mirror=off at=v1,f0: 1 put.");
  EXPECT_FALSE(was_laying_out);
  EXPECT_EQ(session.mesh().live().vertices, 9u);
  ASSERT_TRUE(session.run("undo").done());
  EXPECT_EQ(session.mesh().live().vertices, 8u);
}

TEST_F(ValuesPanel, tells_only_what_a_field_takes_that_does_not_show_it) {
  ASSERT_TRUE(gui.run(session, "values simplify").done());
  frames(3);
  const auto drawn = [&](std::string_view text) { return test::DrawnText(gui).count(text); };
  EXPECT_EQ(drawn("onoroff"), 0u) << "a check box";
  EXPECT_EQ(drawn("oneoffree"), 0u) << "a list";
  EXPECT_EQ(drawn("oneofFaces,Ratio,Error,Largestdistancemustbegiven"), 1u) << "below all fields, not under each";
  EXPECT_EQ(drawn("oneoffaces,ratio,error"), 0u);
  EXPECT_EQ(drawn("aratiofrom0to1"), 1u);
}

TEST_F(ValuesPanel, brings_what_would_come_into_view_and_looks_back_when_it_goes) {
  const auto write = [&](std::string_view text) {
    for (int i = 0; i < 4; ++i) press(ImGuiKey_Backspace);
    type(text);
  };
  const auto shows_mesh = [&] {
    return shows_all(session.view.camera, session.view.size, {}, session.mesh().positions());
  };
  ASSERT_TRUE(session.run("wheel -1 640,400").done());
  const Camera before = session.view.camera;
  ASSERT_TRUE(gui.run(session, "values cube").done());
  frames(3);
  write("0.1");
  ASSERT_EQ(session.mesh().live().vertices, 16u);
  EXPECT_EQ(session.view.camera, before) << "what lies in view moves nothing";
  write("9");
  EXPECT_TRUE(shows_mesh());
  EXPECT_NE(session.view.camera, before);
  write("0.1");
  EXPECT_EQ(session.view.camera, before) << "a smaller one needs no other view";
  write("9");
  EXPECT_TRUE(shows_mesh());
  ASSERT_TRUE(session.run("panel none").done());
  frames(3);
  EXPECT_EQ(session.view.camera, before);
  ASSERT_TRUE(gui.run(session, "values cube").done());
  frames(3);
  write("9");
  press(ImGuiKey_Enter);
  frames(3);
  EXPECT_EQ(session.mesh().live().vertices, 16u);
  EXPECT_FALSE(session.document().is_on_trial());
  EXPECT_TRUE(shows_mesh()) << "what was made stays in view";
}

// In a narrow window it leaves half of it to the mesh, and what would come is seen whole there.
TEST(values_panel, leaves_what_would_come_to_be_seen_beside_it) {
  test::Laid laid("cube.obj", {640, 480});
  Session& session = laid.session;
  ASSERT_TRUE(laid.gui.run(session, "values cylinder").done());
  laid.frames(6);
  ASSERT_TRUE(session.document().is_on_trial());
  const Covered covered = session.framing.covered();
  EXPECT_GT(covered.right, 200);
  EXPECT_LT(covered.right, 320);
  EXPECT_TRUE(shows_all(session.view.camera, session.view.size, covered, session.mesh().positions()));
  ASSERT_TRUE(session.run("panel none").done());
  laid.frames(6);
  EXPECT_EQ(session.framing.covered().right, 0);
  EXPECT_TRUE(session.framing.is_framed()) << "as before";
}

// Also where nothing comes that was not in view: the panel covers a part of what is changed.
TEST(values_panel, leaves_what_would_change_to_be_seen_beside_it) {
  test::Laid laid("torus.off", {640, 480});
  Session& session = laid.session;
  const Camera before = session.view.camera;
  ASSERT_TRUE(laid.gui.run(session, "values remesh").done());
  laid.frames(6);
  ASSERT_TRUE(session.document().is_on_trial());
  EXPECT_TRUE(shows_all(session.view.camera, session.view.size, session.framing.covered(), session.mesh().positions()));
  EXPECT_NE(session.view.camera, before);
  ASSERT_TRUE(session.run("panel none").done());
  laid.frames(6);
  EXPECT_LT(glm::distance(session.view.camera.eye, before.eye), 1e-9);
}

TEST_F(ValuesPanel, looks_back_when_an_undo_ends_what_would_come) {
  ASSERT_TRUE(session.run("split 0-1").done());
  ASSERT_TRUE(session.run("wheel -1 640,400").done());
  const Camera before = session.view.camera;
  ASSERT_TRUE(gui.run(session, "values cube").done());
  frames(3);
  press(ImGuiKey_Backspace);
  type("9");
  ASSERT_NE(session.view.camera, before);
  ASSERT_TRUE(session.run("undo").done());
  ASSERT_TRUE(session.run("panel none").done());
  frames(3);
  EXPECT_EQ(session.view.camera, before);
}

TEST_F(ValuesPanel, leaves_the_camera_to_who_moves_it_while_values_are_written) {
  ASSERT_TRUE(gui.run(session, "values cube").done());
  frames(3);
  type("9");
  ASSERT_TRUE(session.framing.is_framed());
  session.view.camera.eye *= 0.5;
  const Camera moved = session.view.camera;
  type("9");
  EXPECT_EQ(session.view.camera, moved);
  ASSERT_TRUE(session.run("panel none").done());
  frames(3);
  EXPECT_EQ(session.view.camera, moved);
}

TEST_F(ValuesPanel, takes_the_selection_for_elements) {
  AlgorithmRow mark = test::scatter_row();
  mark.id = "mark";
  mark.run = [](Edit& edit, const AlgorithmInput& input, Progress&) -> AlgorithmResult {
    for (const Element& element : input.values.elements("at")) edit.set_position(element.vertex(), {9, 9, 9});
    return {input.values.elements("at").size(), 0, {"Moved.", "動かしました。"}};
  };
  mark.parameters = {mark.parameters.back()};
  const ScopedAlgorithm scoped(mark);
  ASSERT_TRUE(session.run("select v1 v3").done());
  ASSERT_TRUE(session.run("values mark").done());
  frames(3);
  press_button("Selection");
  press_button("Run");
  EXPECT_EQ(gui.said().en, "mark at=v1,v3: Moved.");
  EXPECT_EQ(session.mesh().position(Vertex(3)), glm::dvec3(9, 9, 9));
}

// By a word, which can be cleared.
TEST_F(ValuesPanel, begins_with_what_is_selected_where_that_is_worked_on) {
  for (const bool clears : {false, true}) {
    ASSERT_TRUE(session.run("select f0 f1").done());
    ASSERT_TRUE(session.run("values smooth").done());
    frames(6);
    EXPECT_TRUE(session.document().is_on_trial()) << "with a preview";
    const auto& rows = find_algorithm("smooth")->parameters;
    for (std::size_t i = 0; rows[i].kind != ParameterKind::elements; ++i) press(ImGuiKey_Tab);
    EXPECT_EQ(test::DrawnText(gui).count("selectedSelection"), 1u);
    if (clears) press(ImGuiKey_Backspace);
    press(ImGuiKey_Enter);
    frames(3);
    EXPECT_EQ(session.layout.open_panel, "") << gui.said().en;
    EXPECT_EQ(gui.said().en.find("select=f0,f1") == std::string::npos, clears) << gui.said().en;
    ASSERT_TRUE(session.run("undo").done());
  }
  ASSERT_TRUE(session.run("select f0").done());
  ASSERT_TRUE(session.run("values subdivide").done());
  frames(4);
  EXPECT_EQ(test::DrawnText(gui).count("selectedSelection"), 0u) << "what stays sharp is not what is worked on";
}

// An operator has fields as well: where the new vertex lies is seen before it is run.
TEST_F(ValuesPanel, asks_what_an_operator_may_be_told) {
  ASSERT_TRUE(session.run("select f0").done());
  ASSERT_TRUE(gui.run(session, "values poke").done());
  frames(6);
  ASSERT_TRUE(session.document().is_on_trial());
  ASSERT_EQ(session.mesh().live().vertices, 9u);
  press(ImGuiKey_Backspace);
  type("9,9,9");
  frames(3);
  ASSERT_EQ(session.mesh().live().vertices, 9u);
  EXPECT_EQ(session.mesh().position(Vertex(8)), glm::dvec3(9)) << "the preview follows what is written";
  EXPECT_EQ(session.document().position(), 0u);
  press(ImGuiKey_Enter);
  frames(3);
  EXPECT_FALSE(session.document().is_on_trial());
  EXPECT_EQ(session.document().position(), 1u);
  EXPECT_EQ(session.mesh().position(Vertex(8)), glm::dvec3(9));
  EXPECT_EQ(session.layout.open_panel, "") << gui.said().en;
  ASSERT_TRUE(session.run("undo").done());
  EXPECT_EQ(session.mesh().live().vertices, 8u);
}

TEST_F(ValuesPanel, waits_for_what_an_operator_works_on) {
  ASSERT_TRUE(session.run("select none").done());
  ASSERT_TRUE(gui.run(session, "values extrude").done());
  frames(4);
  EXPECT_FALSE(session.document().is_on_trial());
  EXPECT_EQ(test::DrawnText(gui).count("Nothingisselectedthatitworkson."), 1u);
  press_button("Run");
  EXPECT_EQ(session.document().position(), 0u) << "the button is dead";
  ASSERT_TRUE(session.run("select f0 f2").done());
  frames(4);
  EXPECT_TRUE(session.document().is_on_trial()) << "shown as soon as something is selected";
  press_button("Run");
  frames(3);
  EXPECT_EQ(session.document().position(), 1u) << gui.said().en;
  EXPECT_EQ(session.mesh().live().faces, 12u) << "six walls around two faces side by side";
}

TEST_F(ValuesPanel, tells_the_copies_of_a_point_apart) {
  open("fin.obj");
  AlgorithmRow lift = test::scatter_row();
  lift.id = "lift";
  lift.parameters = {lift.parameters.back()};
  lift.run = [](Edit&, const AlgorithmInput& input, Progress&) -> AlgorithmResult {
    return {input.values.elements("at").size(), 0, {"Seen.", "見ました。"}};
  };
  const ScopedAlgorithm scoped(lift);
  std::string names;
  for (std::uint32_t i = 0; i < session.mesh().vertex_slots(); ++i) {
    if (!has_copies(session.mesh(), Vertex(i))) continue;
    session.selecting.selection.push_back(Vertex(i));
    names += (names.empty() ? "" : ",") + name_of_copy(session.mesh(), Vertex(i));
  }
  ASSERT_NE(names.find('@'), std::string::npos);
  ASSERT_TRUE(session.run("values lift").done());
  frames(3);
  press_button("Selection");
  press_button("Run");
  EXPECT_NE(gui.said().en.find("at=" + names), std::string::npos) << gui.said().en;
}

TEST_F(ValuesPanel, offers_all_algorithms_before_one_is_asked_for) {
  ASSERT_TRUE(session.run("panel values").done());
  frames(3);
  press_button(algorithm_table().front().name_en);
  EXPECT_EQ(session.layout.asked_algorithm, algorithm_table().front().id);
}

TEST_F(ValuesPanel, does_nothing_while_a_value_is_missing_or_wrong) {
  ASSERT_TRUE(session.run("values weld_close").done());
  frames(3);
  press(ImGuiKey_Backspace);
  press(ImGuiKey_Enter);
  EXPECT_EQ(session.layout.open_panel, "values") << "the distance is missing";
  type("-1");
  press(ImGuiKey_Enter);
  EXPECT_EQ(session.layout.open_panel, "values") << "it is no length";
  EXPECT_EQ(session.document().position(), 0u);
}

// Whoever opens it can run it: fields begin with what the mesh has.
TEST_F(ValuesPanel, begins_with_lengths_and_a_scheme_as_the_mesh_has_them) {
  const auto run = [&](const char* id) {
    ASSERT_TRUE(session.run(std::string("values ") + id).done());
    frames(4);
    press_button("Run");
    frames(3);
    EXPECT_EQ(session.layout.open_panel, "") << id << ": " << gui.said().en;
  };
  const double side = edge_length(session.mesh(), Edge(0));
  run("remesh");
  EXPECT_NE(gui.said().en.find("length=" + format_double(side)), std::string::npos) << gui.said().en;
  ASSERT_TRUE(session.run("undo").done());
  run("weld_close");
  EXPECT_NE(gui.said().en.find("distance=" + format_double(side / 100)), std::string::npos) << gui.said().en;
  run("subdivide");
  EXPECT_NE(gui.said().en.find("scheme=catmull_clark"), std::string::npos) << "of quads: " << gui.said().en;
  open("tetrahedron.off");
  run("subdivide");
  EXPECT_NE(gui.said().en.find("scheme=loop"), std::string::npos) << "of triangles: " << gui.said().en;
  const ParameterRow& scheme = find_algorithm("subdivide")->parameters[0];
  EXPECT_EQ(scheme.initial, "loop") << "what scripts and the command line have without it";
}

// Enter leaves the caret where something is missing.
TEST_F(ValuesPanel, takes_what_is_typed_behind_an_enter_that_came_too_early) {
  ASSERT_TRUE(session.run("values weld_close").done());
  frames(3);
  press(ImGuiKey_Backspace);
  press(ImGuiKey_Enter);
  frames(2);
  type("0.5");
  press(ImGuiKey_Enter);
  frames(2);
  EXPECT_EQ(session.layout.open_panel, "");
  EXPECT_TRUE(gui.said().en.starts_with("weld_close distance=0.5")) << gui.said().en;
}

TEST_F(ValuesPanel, gives_way_to_another_and_begins_anew) {
  ASSERT_TRUE(session.run("values weld_close").done());
  frames(3);
  type("0.5");
  ASSERT_TRUE(session.run("values fill_holes").done());
  frames(4);
  press(ImGuiKey_Enter);
  frames(2);
  EXPECT_TRUE(gui.said().en.starts_with("fill_holes shape=auto crossing=refuse: ")) << gui.said().en;
  ASSERT_TRUE(session.run("values weld_close").done());
  frames(3);
  EXPECT_EQ(test::DrawnText(gui).count("0.5"), 0u) << "its field begins anew";
  ASSERT_TRUE(session.run("cancel").done());
  frames(3);
  EXPECT_FALSE(gui.owns_pointer(session.layout, {1280, 1000}, {640, 500}));
}

TEST_F(ValuesPanel, shows_beforehand_what_is_quick_and_takes_it_back) {
  const std::uint64_t hash = session.mesh().hash();
  ASSERT_TRUE(session.run("values subdivide").done());
  frames(4);
  EXPECT_TRUE(session.document().is_on_trial());
  const std::size_t once = session.mesh().live().faces;
  EXPECT_GT(once, 6u);
  EXPECT_EQ(session.document().position(), 0u);
  EXPECT_FALSE(session.document().is_modified());
  press(ImGuiKey_Tab);  // from the scheme to the steps
  type("2");
  frames(2);
  EXPECT_GT(session.mesh().live().faces, once) << "with what was just written";
  press_button("Preview");
  EXPECT_EQ(session.mesh().hash(), hash) << "it is switched off";
  press_button("Preview");
  EXPECT_TRUE(session.document().is_on_trial());
  ASSERT_TRUE(session.run("cancel").done());
  frames(3);
  EXPECT_EQ(session.mesh().hash(), hash) << "it is given up";
  EXPECT_FALSE(session.document().is_on_trial());
}

// The space bar opens a list or ticks a box; Enter runs, as in every other field.
TEST_F(ValuesPanel, runs_by_enter_in_a_list) {
  ASSERT_TRUE(session.run("values subdivide").done());
  frames(4);
  press(ImGuiKey_Space);
  EXPECT_GT(test::DrawnText(gui).count("Catmull"), 0u) << "its list is open";
  press(ImGuiKey_Escape);
  frames(2);
  ASSERT_EQ(session.layout.open_panel, "values");
  press(ImGuiKey_Enter);
  frames(3);
  EXPECT_EQ(session.document().position(), 1u);
  EXPECT_EQ(session.layout.open_panel, "");
}

// Its fields are where they were when another algorithm was asked for.
TEST_F(ValuesPanel, begins_at_the_same_place_for_all_algorithms) {
  std::optional<glm::dvec2> first;
  for (const char* const id : {"subdivide", "simplify", "smooth"}) {
    ASSERT_TRUE(session.run(std::string("values ") + id).done());
    frames(4);
    const glm::dvec2 at = test::DrawnText(gui).last_place("Values");
    ASSERT_GT(at.x, 0);
    if (!first) first = at;
    EXPECT_EQ(at, *first) << id;
    ASSERT_TRUE(session.run("panel none").done());
    frames(3);
  }
}

TEST_F(ValuesPanel, is_as_high_as_its_fields) {
  for (const char* const id : {"subdivide", "simplify"}) {
    ASSERT_TRUE(session.run(std::string("values ") + id).done());
    frames(8);
    const ImGuiWindow* const fields = fields_window();
    ASSERT_TRUE(fields);
    EXPECT_EQ(fields->ScrollMax.y, 0) << id;
    EXPECT_LT(fields->Size.y - fields->ContentSize.y, 60) << id << ", and leaves no empty part";
    ASSERT_TRUE(session.run("panel none").done());
    frames(3);
  }
}

TEST_F(ValuesPanel, scrolls_by_whole_rows) {
  size_ = {640, 480};
  ASSERT_TRUE(session.run("values simplify").done());
  frames(6);
  std::set<float> tops;
  for (const double steps : {0.0, -0.3, -0.3, -1.0, -1.0, 0.4, -30.0, 1.0, 30.0}) {
    const ImGuiWindow* fields = fields_window();
    ASSERT_TRUE(fields);
    gui.pointer({fields->Pos.x + 20, fields->Pos.y + 0.5f * fields->Size.y});
    frames(2);
    gui.wheel(steps);
    frames(6);
    fields = fields_window();
    ASSERT_TRUE(fields);
    tops.insert(fields->Scroll.y);
    EXPECT_FALSE(is_cut(*fields, fields->InnerClipRect.Min.y)) << steps;
    EXPECT_FALSE(is_cut(*fields, fields->InnerClipRect.Max.y)) << steps;
  }
  EXPECT_GT(frames_seen, 50) << "else nothing was looked at";
  EXPECT_GT(tops.size(), 3u) << "it scrolls";
  EXPECT_EQ(*tops.begin(), 0) << "and back to the top";
}

TEST_F(ValuesPanel, runs_what_it_has_shown) {
  ASSERT_TRUE(session.run("values subdivide").done());
  frames(4);
  const std::uint64_t shown = session.mesh().hash();
  ASSERT_TRUE(session.document().is_on_trial());
  press_button("Run");
  frames(3);
  EXPECT_FALSE(session.document().is_on_trial());
  EXPECT_EQ(session.mesh().hash(), shown);
  EXPECT_EQ(session.document().position(), 1u);
  ASSERT_EQ(session.log().size(), 1u);
}

TEST_F(ValuesPanel, keeps_what_runs_it_in_sight_in_a_small_window) {
  size_ = {640, 480};
  for (const AlgorithmRow& row : algorithm_table()) {
    if (row.parameters.empty()) continue;
    ASSERT_TRUE(session.run("values " + std::string(row.id)).done());
    frames(4);
    const test::DrawnText text(gui);
    EXPECT_GT(text.last_place("Run").y, 0) << row.id;
    EXPECT_LT(text.last_place("Run").y, 470) << row.id;
    EXPECT_GE(text.count(row.name_en), 1u) << row.id;
    ASSERT_TRUE(session.run("panel none").done());
    frames(3);
  }
}

}  // namespace
}  // namespace ryosen
