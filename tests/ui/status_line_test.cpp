// What the line at the bottom says: what was done, in whole sentences, and how a gesture ends.
#include <gtest/gtest.h>

#include "app/editor/session/session.h"
#include "app/ui/window_input.h"
#include "tests/support/app/drawn_text.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

using test::DrawnText;

class StatusLine : public testing::Test, protected test::Laid {
 protected:
  StatusLine() : Laid("cube.obj") {}
  void resize(Size size) {
    size_ = size;
    input_.resize(size_);
    gui.place_view(session, size_);
    frames(3);
  }

  WindowInput input_{gui, session, {}, [this] { frames(4); }};
};

constexpr Size sizes[] = {{640, 480}, {1280, 800}};

TEST_F(StatusLine, tells_what_repair_all_did_in_whole_sentences) {
  for (const char* const language : {"language en", "language ja"})
    for (const Size size : sizes) {
      ASSERT_TRUE(session.run(language).done());
      open("fin.obj");
      resize(size);
      ASSERT_TRUE(gui.run(session, "repair default").done());
      EXPECT_GT(gui.said().en.size(), 200u) << "all of it, for whoever points at it";
      frames(4);
      const DrawnText drawn(gui);
      for (const std::string& shortened : drawn.shortened())
        ADD_FAILURE() << language << ", " << size.width << ": " << shortened;
      if (language == std::string_view("language en")) {
        EXPECT_GE(drawn.count("2problemsareleft.2elementsstayastheyare."), 1u) << size.width;
        EXPECT_EQ(drawn.count("Repairall:"), size.width < 900 ? 0u : 1u) << "by its name, where there is room";
      }
    }
}

TEST_F(StatusLine, says_first_how_a_gesture_ends_and_is_taken_back) {
  struct Held {
    const char *selecting, *key, *told;
  };
  for (const char* const language : {"language en", "language ja"})
    for (const Size size : sizes)
      for (const Held& held : {Held{"select f0", "E", "Extrude"}, Held{"select f0 f1", "G", "Move"},
                               Held{"select v0 v1", "R", "Turn"}, Held{"select e0", "Shift+S", "Scale"}}) {
        SCOPED_TRACE(std::string(language) + ", " + held.key + ", " + std::to_string(size.width));
        ASSERT_TRUE(session.run(language).done());
        resize(size);
        ASSERT_TRUE(session.run(held.selecting).done());
        ASSERT_TRUE(input_.key(held.key).done());
        ASSERT_TRUE(input_.key("O").done());
        input_.move({{320, 240}});
        frames(3);
        input_.move({{150, 400}});
        frames(3);
        ASSERT_TRUE(session.gesturing.is_active());
        const DrawnText drawn(gui);
        if (session.preferences.language == Language::english) {
          EXPECT_EQ(drawn.count(held.told), 1u);
          EXPECT_EQ(drawn.count("Enter,clickdone"), 1u);
          EXPECT_EQ(drawn.count("Escgiveup"), 1u);
          EXPECT_LT(drawn.place("Enter,clickdone").x, drawn.place("Escgiveup").x);
        } else {
          EXPECT_EQ(drawn.count("Enter"), 1u);
          EXPECT_EQ(drawn.count("Esc"), size.width < 900 ? 1u : 2u) << "also beside the tool Select, where it is seen";
        }
        EXPECT_EQ(drawn.cut_sideways(), "");
        ASSERT_TRUE(input_.key("Escape").done());
        frames(2);
      }
}

}  // namespace
}  // namespace ryosen
