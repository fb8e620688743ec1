// The panel of practice: questions are answered by a click on a row, on a number or in the view, and judged at once.
// And what the textbooks build is in the menu Help.
#include <gtest/gtest.h>

#include <set>

#include "app/editor/session/session.h"
#include "app/editor/textbook/exercises.h"
#include "app/editor/textbook/playing.h"
#include "app/editor/textbook/practice.h"
#include "app/ui/overlays.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

class PracticePanelTest : public testing::Test, protected test::Laid {
 protected:
  PracticePanelTest() : Laid("figures/000-12.obj", test::tall_window) {
    for (const PanelRow& row : panel_list())
      if (row.place == PanelPlace::right) session.run("panel " + std::string(row.id) + " off");
    session.run("panel practice");
    frames(3);
  }
  bool has(std::string_view text) const { return test::DrawnText(gui).count(text) > 0; }
  void take(std::string_view text) {
    click(test::DrawnText(gui).place(text));
    frames(3);
  }
  // The panel counts seeds from 1, and asks of all kinds in turn.
  Question go_to(QuestionKind kind) {
    while (kind_of_seed(seed_) != kind) {
      take("Nextquestion");
      ++seed_;
    }
    return make_question(session.mesh(), kind, seed_);
  }

  std::uint64_t seed_ = 1;
};

TEST_F(PracticePanelTest, takes_a_click_on_a_rule) {
  for (int n = 0; n < 4; ++n) {
    const Question question = go_to(QuestionKind::legal);
    EXPECT_TRUE(has("Yes,itmay."));
    const bool may = is_right(session.mesh(), solve(session.mesh(), question), "yes");
    take("Yes,itmay.");
    EXPECT_EQ(has("Right."), may) << question.line;
    EXPECT_EQ(has("No,therightansweris"), !may) << question.line;
    take("Nextquestion");
    ++seed_;
    EXPECT_FALSE(has("Right."));
  }
}

// However long the answers are, and in a low window: with the answer that was given and the right one in words.
TEST_F(PracticePanelTest, shows_a_question_and_its_judgement_with_what_goes_on_from_them) {
  for (const Size size : {Size{640, 480}, Size{1280, 800}, test::tall_window}) {
    size_ = size;
    open("fin.obj");
    session.run(size.width < 900 ? "panel practice flyout" : "panel practice on");
    frames(6);
    int judged = 0;
    for (int n = 0; n < 12; ++n) {
      ASSERT_TRUE(has("Nextquestion")) << size.height << " " << n;
      if (has("Yes,itmay.")) {
        ++judged;
        take("Yes,itmay.");
        ASSERT_TRUE(has("Youranswer:Yes,itmay.")) << size.height;
        ASSERT_TRUE(has("Nextquestion")) << size.height << " " << n;
      }
      take("Nextquestion");
      frames(3);
    }
    EXPECT_GT(judged, 0) << size.height;
  }
}

// Below other panels too, whose column it scrolls: with all that may be answered, which is higher than a judgement.
TEST_F(PracticePanelTest, shows_the_next_question_whole_below_other_panels) {
  size_ = {1280, 800};
  open("fin.obj");
  for (const char* const panel : {"inspector", "problems", "history", "practice"})
    session.run("panel " + std::string(panel) + " on");
  frames(6);
  ASSERT_TRUE(has("Nextquestion"));
  int higher = 0;
  for (int n = 0; n < 12; ++n) {
    const double before = test::DrawnText(gui).place("Nextquestion").y;
    if (has("Yes,itmay.")) take("Yes,itmay.");
    higher += test::DrawnText(gui).place("Nextquestion").y < before;
    take("Nextquestion");
    frames(6);
    const test::DrawnText drawn(gui);
    for (const char* const text : {"Anyquestion", "Nextquestion"}) ASSERT_EQ(drawn.count(text), 1u) << text << " " << n;
    if (!drawn.count("Yes,itmay.")) continue;
    take("Yes,itmay.");
    frames(6);
    for (const char* const text : {"Anyquestion", "Nextquestion"})
      ASSERT_EQ(test::DrawnText(gui).count(text), 1u) << "the judgement: " << text << " " << n;
  }
  EXPECT_GT(higher, 0) << "no judgement was lower than its question";
}

// Two answers that begin alike could not be told apart by their beginnings.
TEST_F(PracticePanelTest, shows_the_answers_whole) {
  for (int n = 0; n < 4; ++n) {
    const Question question = go_to(QuestionKind::legal);
    std::set<std::string> unseen;
    for (const AnswerChoice& choice : answer_choices(question, solve(session.mesh(), question)))
      for (const std::string_view word : split_words(choice.says.en)) unseen.emplace(word);
    gui.pointer(test::DrawnText(gui).place("Yes,itmay."));
    for (int notch = 0; notch < 12; ++notch) {
      const test::DrawnText text(gui);
      std::erase_if(unseen, [&](const std::string& word) { return text.count(word) > 0; });
      EXPECT_EQ(text.cut_sideways(), "");
      gui.wheel(-1);
      frames(4);
    }
    EXPECT_TRUE(unseen.empty()) << *unseen.begin() << " in " << question.line;
    take("Nextquestion");
    ++seed_;
  }
}

// In the view, whatever it is: a halfedge as an arrow beside its twin.
TEST_F(PracticePanelTest, marks_what_it_asks_about) {
  for (const QuestionKind kind : {QuestionKind::legal, QuestionKind::valence, QuestionKind::next}) {
    const Element about = go_to(kind).about;
    ASSERT_EQ(asked_element(session.document(), session.layout, session.asked_question), about);
    const Overlay marks = question_overlay(session, Theme::dark);
    if (kind == QuestionKind::valence) {
      ASSERT_EQ(marks.points.size(), 1u);
      EXPECT_EQ(marks.points[0].at, session.mesh().position(about.vertex()));
      continue;
    }
    ASSERT_EQ(marks.lines.size(), 1u);
    EXPECT_EQ(marks.lines[0].arrow, kind == QuestionKind::next);
    if (kind != QuestionKind::legal) continue;
    const Halfedge h = halfedge(about.edge());
    EXPECT_EQ(
        std::set({marks.lines[0].a.x, marks.lines[0].b.x}),
        std::set({session.mesh().position(session.mesh().from(h)).x, session.mesh().position(session.mesh().to(h)).x}));
  }
  session.run("panel practice off");
  frames(3);
  EXPECT_TRUE(question_overlay(session, Theme::dark).empty());
  session.run("panel practice");
  frames(3);
  EXPECT_FALSE(question_overlay(session, Theme::dark).empty());
  ASSERT_TRUE(gui.run(session, "split e0").done());
  EXPECT_TRUE(question_overlay(session, Theme::dark).empty()) << "of another mesh";
}

TEST_F(PracticePanelTest, escape_leaves_the_question_last) {
  go_to(QuestionKind::legal);
  ASSERT_TRUE(session.run("select v0").done());
  ASSERT_TRUE(gui.run(session, "cancel").done());
  frames(3);
  EXPECT_TRUE(session.selecting.selection.empty());
  EXPECT_TRUE(asked_element(session.document(), session.layout, session.asked_question));
  ASSERT_TRUE(gui.run(session, "cancel").done());
  frames(3);
  EXPECT_FALSE(asked_element(session.document(), session.layout, session.asked_question));
  EXPECT_FALSE(has("Yes,itmay."));
  take("Nextquestion");
  EXPECT_TRUE(asked_element(session.document(), session.layout, session.asked_question));
}

TEST_F(PracticePanelTest, takes_a_click_on_a_number) {
  const Question question = go_to(QuestionKind::valence);
  const std::string right = solve(session.mesh(), question).answers[0];
  EXPECT_FALSE(has("Yes,itmay."));
  ASSERT_NE("11", right);
  take("11");
  EXPECT_TRUE(has("Youranswer:11"));
  EXPECT_TRUE(has("No,therightansweris:" + right));
}

TEST_F(PracticePanelTest, takes_a_click_in_the_view) {
  const Question question = go_to(QuestionKind::twin);
  const Solution solution = solve(session.mesh(), question);
  session.selecting.selection = {*solution.element};
  frames(3);
  EXPECT_TRUE(has("Right."));
}

TEST(help_menu, plays_the_exercises_and_the_figures) {
  test::Laid laid("fan.obj");
  const auto take = [&](std::string_view text) {
    laid.click(test::DrawnText(laid.gui).place(text));
    laid.frames(3);
  };
  take("Help");
  take("Exercises");
  for (const ExerciseScript& script : exercise_scripts()) {
    std::string name = name_of_exercise(script).en;
    std::erase(name, ' ');
    EXPECT_GT(test::DrawnText(laid.gui).count(name), 0) << name;
  }
  take("Acubewithonethrough-hole");
  ASSERT_TRUE(laid.session.shown.player());
  EXPECT_EQ(laid.session.shown.player()->call(), "script cube_with_hole");
}

// Where there is no room for a row of the list, none is drawn, and nothing breaks.
TEST(help_menu, list_of_the_texts_fits_a_window_of_any_size) {
  for (const Size size : {Size{640, 90}, Size{320, 60}, Size{60, 30}}) {
    test::Laid laid("fan.obj", size);
    ASSERT_TRUE(laid.session.run("panel texts").done());
    laid.frames(5);
    EXPECT_FALSE(laid.session.layout.open_panel.empty());
  }
}

// A click on a place of the texts shows it; where edits would be lost it asks.
TEST(help_menu, shows_what_is_clicked_in_the_list_of_the_texts) {
  test::Laid laid("fan.obj");
  const auto take = [&](std::string_view text) {
    ASSERT_TRUE(laid.session.run("panel texts").done());
    laid.frames(3);
    laid.click(test::DrawnText(laid.gui).place(text));
    laid.frames(3);
  };
  take("Figure3:partsofapolygonmodel");
  EXPECT_EQ(laid.session.mesh().live().faces, 4u);
  EXPECT_TRUE(laid.session.layout.open_panel.empty());
  EXPECT_EQ(laid.session.view.settings.numbers, Numbers::all);
  take("Table3");
  EXPECT_EQ(laid.session.selecting.selection.size(), 1u);
  ASSERT_TRUE(laid.session.run("poke f0").done());
  take("Figure11:thefileofatorus");
  EXPECT_EQ(laid.session.mesh().live().faces, 6u) << "the edited mesh is there";
  EXPECT_EQ(laid.session.layout.open_panel, panel_opened_by(PanelOpener::loss).id);
}

}  // namespace
}  // namespace ryosen
