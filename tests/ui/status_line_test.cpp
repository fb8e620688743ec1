// What the line at the bottom says: what was done, in whole sentences.
#include <gtest/gtest.h>

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
        EXPECT_GE(drawn.count("3problemsareleft.2elementsstayastheyare."), 1u) << size.width;
      }
    }
}

}  // namespace
}  // namespace ryosen
