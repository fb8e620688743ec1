// A switch of the view is one row: one that this program adds is said, pressed, chosen, given as a flag and explained
// as all others are.
#include <gtest/gtest.h>
#include <imgui.h>

#include "app/cli/run.h"
#include "app/editor/commands/commands.h"
#include "app/editor/preferences/keys.h"
#include "app/editor/preferences/view_switches.h"
#include "app/editor/session/session.h"
#include "tests/support/app/laid.h"

namespace ryosen {
namespace {

std::size_t fog = 0;

class ScopedViewSwitchTest : public testing::Test {
 protected:
  ScopedViewSwitchTest() { fog = 0; }

  const ScopedViewSwitch added_{
      {.id = "fog",
       .help_en = "lets what is far away fade",
       .help_ja = "遠くを霞ませる",
       .values = {{"none", "No fog", "霧なし"}, {"thin", "Thin fog", "薄い霧"}, {"thick", "Thick fog", "濃い霧"}},
       .value = [](const Session&) { return fog; },
       .set = [](Session&, std::size_t value) { fog = value; },
       .chord = "Ctrl+F",
       .key_en = "more fog",
       .key_ja = "霧を濃くする",
       .flag_en = "how far one sees",
       .flag_ja = "見通し"}};
};

std::string printed(const std::vector<std::string>& arguments) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(cli::run(arguments), ExitCode::done);
  return testing::internal::GetCapturedStdout();
}

TEST_F(ScopedViewSwitchTest, is_a_command_of_scripts) {
  Session session(std::make_unique<Document>());
  EXPECT_TRUE(session.run("fog thick").done());
  EXPECT_EQ(fog, 2u);
  EXPECT_TRUE(session.run("fog toggle").done());
  EXPECT_EQ(fog, 0u) << "behind the last comes the first";
  EXPECT_EQ(session.run("fog grey").sentence.en, "the command reads: fog toggle|none|thin|thick");
  EXPECT_EQ(session.run("fog").exit_code, ExitCode::usage);
  EXPECT_NE(session.run("fogg none").sentence.en.find("did you mean fog?"), std::string::npos);
  EXPECT_TRUE(session.log().empty()) << "it is no edit";
}

TEST_F(ScopedViewSwitchTest, has_a_key_that_goes_on_to_the_next_value) {
  Session session(std::make_unique<Document>());
  for (const std::size_t next : {1u, 2u, 0u}) {
    EXPECT_TRUE(session.run("key Ctrl+F").done());
    EXPECT_EQ(fog, next);
  }
  const std::string keys = printed({"keys", "--lang", "en"});
  EXPECT_NE(keys.find("Ctrl+F        more fog [fog toggle]"), std::string::npos) << keys;
}

TEST_F(ScopedViewSwitchTest, has_an_entry_of_the_view_menu_for_each_value) {
  test::Laid laid("cube.obj", test::tall_window);
  for (const auto& [name, value] : {std::pair("Thin fog", 1u), {"Thick fog", 2u}, {"No fog", 0u}}) {
    laid.open_menu("View");
    EXPECT_EQ(test::DrawnText(laid.gui).count(name), 1u) << name;
    laid.click_on(name);
    EXPECT_EQ(fog, value) << name;
  }
}

TEST_F(ScopedViewSwitchTest, is_suggested_in_the_command_window) {
  test::Laid laid("cube.obj");
  const auto type = [&](std::string_view text) {
    for (const char c : text) laid.gui.character(static_cast<unsigned>(c));
    laid.frames(2);
  };
  ASSERT_TRUE(laid.session.run("panel command").done());
  laid.frames(3);
  type("fog");
  laid.click_on("lets what is far away fade");  // the first suggestion
  type("thick");
  laid.gui.key(ImGuiKey_Enter, true);
  laid.gui.key(ImGuiKey_Enter, false);
  laid.frames(3);
  EXPECT_EQ(fog, 2u) << laid.gui.said().en;
}

TEST_F(ScopedViewSwitchTest, is_a_flag_of_shot_with_its_help) {
  const test::TemporaryFolder folder;
  const auto shot = [&](const std::string& value) {
    return cli::run({"shot", test::asset("cube.obj"), "-o", folder.at("a.png"), "--size", "32x24", "--backend",
                     "osmesa", "--fog", value});
  };
  EXPECT_EQ(shot("thick"), ExitCode::done);
  EXPECT_EQ(fog, 2u);
  testing::internal::CaptureStderr();
  EXPECT_EQ(shot("grey"), ExitCode::usage);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("--fog is none, thin or thick, not 'grey'."),
            std::string::npos);
  const std::string help = printed({"help", "shot", "--lang", "en"});
  EXPECT_NE(help.find("--fog none|thin|thick"), std::string::npos);
  EXPECT_NE(help.find("how far one sees"), std::string::npos);
  EXPECT_NE(help.find("fog toggle|none|thin|thick"), std::string::npos) << "the command";
  EXPECT_NE(printed({"help", "edit", "--lang", "ja"}).find("遠くを霞ませる"), std::string::npos);
}

TEST(view_switches, begin_with_their_first_value_and_take_each) {
  Session session(std::make_unique<Document>());
  for (const ViewSwitch& row : view_switches()) {
    EXPECT_EQ(row.value(session), 0u) << row.id;
    EXPECT_GE(row.values.size(), 2u) << row.id;
    EXPECT_EQ(row.toggles(), !row.key_en.empty() && !row.key_ja.empty()) << row.id;
    EXPECT_EQ(row.has_flag(), !row.flag_ja.empty()) << row.id;
    for (std::size_t i = row.values.size(); i-- > 0;) {
      EXPECT_TRUE(session.run(std::string(row.id) + " " + std::string(row.values[i].id)).done());
      EXPECT_EQ(row.value(session), i) << row.id;
      EXPECT_NE(row.values[i].name_en, row.values[i].name_ja) << row.id;
    }
    EXPECT_EQ(find_command_row(row.id)->help_en, row.help_en) << row.id;
  }
  EXPECT_EQ(session.view.settings, ViewSettings());
}

TEST(view_switches, reach_shaders_by_the_names_of_their_rows) {
  ViewSettings().for_each([&](std::string_view name, int first) {
    EXPECT_EQ(first, 0) << name;
    std::size_t told = 0;
    for (const ViewSwitch& row : view_switches()) {
      if (row.id != name) continue;
      Session session(std::make_unique<Document>());
      row.set(session, 1);
      session.view.settings.for_each([&](std::string_view other, int value) { told += other == name && value == 1; });
    }
    EXPECT_EQ(told, 1u) << name;
  });
}

}  // namespace
}  // namespace ryosen
