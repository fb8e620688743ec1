// Selecting in the real window: by neighbourhood, by trait from the menu, by name; and operators on what is selected.
#include <sstream>

#include "app/editor/session/session.h"
#include "app/ui/texts.h"
#include "ryosen/mesh/names.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/window_hand.h"

namespace ryosen {
namespace {

using test::DrawnText;
using test::Frame;
using test::words_of;

class WindowSelection : public test::WindowHand {
 protected:
  // In the menu bar, and where it has an entry: as a session with the same panels has them.
  void choose(const std::string& name) {
    beside().frames(3);
    const glm::dvec2 bar = DrawnText(beside().gui).place("SelectViewAdd");
    beside().click(bar);
    beside().frames(3);
    const glm::dvec2 entry = DrawnText(beside().gui).last_place(name);
    ASSERT_GT(entry.x, 0) << "the menu has no entry '" << name << "'";
    beside().gui.close_menus();
    beside().frames(3);
    click(bar);
    click(entry);
  }
};

TEST_F(WindowSelection, loops_rings_what_is_linked_and_neighbours_are_selected_by_keys) {
  open_made({"grid", "--columns", "6", "--rows", "4"});
  const auto selected_here = [&](const std::string& line) {
    EXPECT_TRUE(session().run(line).done());
    return static_cast<long>(session().selecting.selection.size());
  };
  const OnEdge at = on_edge(0.5, 7);
  const std::string select = "select " + name_of(session().mesh(), at.edge),
                    click = "mousemove " + words_of(at.pixel) + " click 1";
  for (const auto& [key, line] : {std::pair("l", "select loop"), std::pair("shift+l", "select ring"),
                                  std::pair("k", "select linked"), std::pair("plus", "select grow")}) {
    selected_here("mode edge");
    selected_here(select);
    xdotool("key ctrl+shift+a key 2 " + click);
    ASSERT_TRUE(has_selected(1));
    xdotool(std::string("key ") + key);
    const long expected = selected_here(line);
    EXPECT_GT(expected, 1) << line;
    EXPECT_TRUE(has_selected(expected)) << line << " by the key " << key << ": " << last().selected << ", not "
                                        << expected;
  }
  xdotool("key minus");
  const long fewer = selected_here("select shrink");
  EXPECT_TRUE(has_selected(fewer)) << last().selected << ", not " << fewer;
  xdotool("keydown alt " + click + " keyup alt");
  selected_here(select);
  EXPECT_TRUE(has_selected(selected_here("select loop"))) << "Alt and a click";
}

TEST_F(WindowSelection, a_trait_of_the_menu_is_selected_kept_by_a_name_and_called_back_through_edits) {
  open_copy("cube.obj");
  choose("Select edges by how they bend");
  xdotool("type 100");
  xdotool("key Return");
  ASSERT_TRUE(shows([](const Frame& frame) { return frame.said.find("nothing is selected") != frame.said.npos; }));
  EXPECT_EQ(last().selected, 0);
  choose("Select edges by how they bend");
  xdotool("type 45");
  xdotool("key Return");
  ASSERT_TRUE(has_selected(12)) << "all edges of a cube";
  ASSERT_TRUE(session().run("select sharp 45").done());
  choose(text(UiText::keep_selection, Language::english));
  ASSERT_TRUE(shows([](const Frame& frame) { return frame.panel == "command"; })) << "it asks for a name";
  xdotool("type --delay 20 '\"my edges\"'");
  xdotool("key Return");
  ASSERT_TRUE(shows([](const Frame& frame) { return frame.panel == "-"; }));
  ASSERT_TRUE(session().run("keep \"my edges\"").done());

  // One of them goes.
  const OnEdge edge = on_edge(0.5);
  xdotool("key ctrl+shift+a mousemove " + words_of(edge.pixel) + " click 1 key shift+x");
  ASSERT_TRUE(is_at(1));
  session().selecting.selection = {edge.edge};
  ASSERT_TRUE(session().run("dissolve selected").done());
  xdotool("key ctrl+shift+a");
  ASSERT_TRUE(has_selected(0));
  session().selecting.selection.clear();
  choose("my edges");
  ASSERT_TRUE(session().run("select kept \"my edges\"").done());
  const long left = static_cast<long>(session().selecting.selection.size());
  EXPECT_TRUE(left > 0 && left < 12);
  EXPECT_TRUE(has_selected(left)) << "those that are left: " << left << ", not " << last().selected;
  EXPECT_EQ(last().history, 1) << "selecting is no entry";
  say("select longer 1");
  ASSERT_TRUE(session().run("select longer 1").done());
  EXPECT_TRUE(has_selected(static_cast<long>(session().selecting.selection.size()))) << "by the palette";
}

TEST_F(WindowSelection, an_operator_on_it_is_one_entry_and_counts_by_reason_what_it_refused_and_leaves_selected) {
  open_copy("fan.obj");
  xdotool("mousemove 640 60 key 3 key a");
  const long faces = last().faces;
  ASSERT_TRUE(has_selected(faces));
  say("poke selected");
  ASSERT_TRUE(has_faces(3 * faces));
  EXPECT_EQ(last().history, 1);
  xdotool("mousemove 640 60 key ctrl+z");
  ASSERT_TRUE(has_faces(faces));
  xdotool("key 2 key a");
  ASSERT_TRUE(has_selected(last().edges));
  const long edges = last().edges;
  say("swap selected");
  ASSERT_TRUE(is_at(1)) << "in one entry";
  ASSERT_TRUE(shows([](const Frame& frame) { return frame.said.find("refused") != frame.said.npos; }));
  std::istringstream words(last().said);
  long number = 0, done = 0, refused = 0, reasons = 0;
  for (std::string word, before; words >> word; before = word) {
    if (word == "done." || word == "refused:") number = std::stol(before);
    if (word == "done.") done = number;
    if (word != "refused:") continue;
    refused += number;
    ++reasons;
  }
  EXPECT_GT(reasons, 1) << last().said;
  EXPECT_GT(done, 0) << last().said;
  EXPECT_EQ(done + refused, edges) << last().said;
  EXPECT_EQ(last().selected, refused) << "what was refused stays selected";
  ASSERT_TRUE(session().run("mode edge").done() && session().run("select all").done());
  ASSERT_TRUE(session().run("swap selected").done());
  EXPECT_EQ(refused, static_cast<long>(session().selecting.selection.size())) << "as the command does it";
}

}  // namespace
}  // namespace ryosen
