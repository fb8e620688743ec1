// The fields of an algorithm's values: one per parameter of its row, whatever the row is.
#include <gtest/gtest.h>
#include <imgui.h>

#include "core/mesh/copies.h"
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

  // In a window with one field.
  static constexpr glm::dvec2 selection_button{780, 483}, run_button{430, 541};

  const ScopedAlgorithm scatter_{test::scatter_row()};
};

TEST_F(ValuesPanel, runs_what_its_fields_say_when_the_frame_is_laid_out) {
  bool was_laying_out = true;
  session.on_progress = [&](double) {
    was_laying_out = gui.is_laying_out();
    return true;
  };
  ASSERT_TRUE(gui.run(session, "values scatter").done());
  frames(3);
  type("50%");
  for (int i = 0; i < 6; ++i) press(ImGuiKey_Tab);  // from text to text: the last is that of the elements
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
  click(selection_button);
  click(run_button);
  frames(2);
  EXPECT_EQ(gui.said().en, "mark at=v1,v3: Moved.");
  EXPECT_EQ(session.mesh().position(Vertex(3)), glm::dvec3(9, 9, 9));
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
    session.selection.push_back(Vertex(i));
    names += (names.empty() ? "" : ",") + name_of_copy(session.mesh(), Vertex(i));
  }
  ASSERT_NE(names.find('@'), std::string::npos);
  ASSERT_TRUE(session.run("values lift").done());
  frames(3);
  click(selection_button);
  click(run_button);
  frames(2);
  EXPECT_NE(gui.said().en.find("at=" + names), std::string::npos) << gui.said().en;
}

TEST_F(ValuesPanel, offers_all_algorithms_before_one_is_asked_for) {
  ASSERT_TRUE(session.run("panel values").done());
  frames(3);
  click({400, 459});
  EXPECT_EQ(session.asked_algorithm, algorithm_table().front().id);
}

TEST_F(ValuesPanel, does_nothing_while_a_value_is_missing_or_wrong) {
  ASSERT_TRUE(session.run("values weld_close").done());
  frames(3);
  press(ImGuiKey_Enter);
  EXPECT_EQ(session.open_panel, "values") << "the distance is missing";
  type("-1");
  press(ImGuiKey_Enter);
  EXPECT_EQ(session.open_panel, "values") << "it is no length";
  EXPECT_EQ(session.document().position(), 0u);
}

TEST_F(ValuesPanel, gives_way_to_another_and_begins_anew) {
  ASSERT_TRUE(session.run("values weld_close").done());
  frames(3);
  type("0.5");
  ASSERT_TRUE(session.run("values fill_holes").done());
  frames(4);
  press(ImGuiKey_Enter);
  frames(2);
  EXPECT_TRUE(gui.said().en.starts_with("fill_holes: ")) << gui.said().en;
  ASSERT_TRUE(session.run("values weld_close").done());
  frames(3);
  press(ImGuiKey_Enter);
  EXPECT_EQ(session.open_panel, "values") << "its field is empty again";
  ASSERT_TRUE(session.run("cancel").done());
  frames(3);
  EXPECT_FALSE(gui.owns_pointer(session, {1280, 1000}, {640, 500}));
}

}  // namespace
}  // namespace ryosen
