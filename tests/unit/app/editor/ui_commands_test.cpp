// The commands of the user interface, which the session keeps and the window shows.
#include <gtest/gtest.h>

#include "app/editor/keys.h"
#include "app/editor/session.h"
#include "tests/support/app/program.h"

namespace ryosen {
namespace {

TEST(UiCommands, SetWhatTheyName) {
  Session session(std::make_unique<Document>());
  EXPECT_TRUE(session.run("language ja").done());
  EXPECT_EQ(session.language, Language::japanese);
  EXPECT_TRUE(session.run("theme light").done());
  EXPECT_TRUE(session.light_theme);
  EXPECT_TRUE(session.run("panel keys").done());
  EXPECT_EQ(session.open_panel, "keys");
  for (const char* wrong : {"language", "language de", "theme pink", "panel", "panel kyes", "cancel all"})
    EXPECT_EQ(session.run(wrong).exit_code, ExitCode::usage) << wrong;
  EXPECT_TRUE(session.log().empty()) << "a script of the edits does not hold how the window looked";
}

TEST(UiCommands, CancelStepsOutOfOneThingAtATime) {
  auto document = Document::open(test::asset("torus.off"));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  for (const char* line : {"select v0", "tool collapse", "panel keys", "cancel"}) ASSERT_TRUE(session.run(line).done());
  EXPECT_EQ(session.open_panel, "");
  EXPECT_EQ(session.tool, "collapse");
  ASSERT_TRUE(session.run("cancel").done());
  EXPECT_EQ(session.tool, "");
  EXPECT_EQ(session.selection.size(), 1u);
  ASSERT_TRUE(session.run("cancel").done());
  EXPECT_TRUE(session.selection.empty());
}

TEST(UiCommands, EveryKeySendsACommandThatIsUnderstood) {
  for (const KeyRow& key : key_table()) {
    auto document = Document::open(test::asset("torus.off"));
    ASSERT_TRUE(document);
    Session session(std::move(document).value());
    session.take_picture = [](const std::filesystem::path&) { return success(); };
    if (key.command == "save") continue;  // would write the asset
    EXPECT_NE(session.run(std::string(key.command)).exit_code, ExitCode::usage) << key.chord;
  }
}

TEST(UiCommands, PixelsCountFromTheWindowsCornerAndEndWithTheView) {
  auto document = Document::open(test::asset("torus.off"));
  ASSERT_TRUE(document);
  Session session(std::move(document).value());
  const auto inside = session.pick({640, 560}, PickMode::face);
  ASSERT_TRUE(inside);
  session.view_origin = {200, 30};
  const auto moved = session.pick({840, 590}, PickMode::face);
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->element, inside->element);
  EXPECT_FALSE(session.pick({199, 300}, PickMode::face));
  EXPECT_FALSE(session.pick({1480, 300}, PickMode::face));
}

}  // namespace
}  // namespace ryosen
