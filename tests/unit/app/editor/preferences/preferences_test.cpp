#include "app/editor/preferences/preferences.h"

#include <gtest/gtest.h>

#include <chrono>

#include "app/editor/preferences/view_switches.h"
#include "app/editor/session/session.h"

namespace ryosen {
namespace {

TEST(preferences, are_set_by_a_command_each_and_begin_as_their_rows_say) {
  Session session(std::make_unique<Document>());
  begin_as_window(session);
  for (const PreferenceRow& row : preference_table()) {
    const std::string id(row.field.id);
    EXPECT_EQ(row.value(session), row.field.initial) << id;
    EXPECT_FALSE(row.field.name_en.empty() || row.field.name_ja.empty() || row.field.help_ja.empty()) << id;
    const std::string other = !row.field.choices.empty() ? std::string(row.field.choices.back().id) : "2";
    const bool is_in_range = !fault_of_preference(id, other);
    const std::string value = is_in_range ? other : "20";
    ASSERT_TRUE(session.run("prefer " + id + " " + value).done()) << id;
    EXPECT_EQ(row.value(session), value) << id;
    EXPECT_EQ(session.run("prefer " + id + " nonsense").exit_code, ExitCode::usage) << id;
    EXPECT_EQ(row.value(session), value) << "a wrong value changes nothing";
  }
  EXPECT_EQ(session.preferences.language, Language::japanese);
  EXPECT_EQ(session.preferences.ui_scale, 2);
  EXPECT_EQ(session.preferences.font_size_px, 20);
  EXPECT_EQ(session.preferences.samples, 2);
  ASSERT_TRUE(session.run("prefer scale initial").done());
  EXPECT_EQ(session.preferences.ui_scale, 1);
  ASSERT_TRUE(session.run("prefer all initial").done());
  for (const PreferenceRow& row : preference_table()) EXPECT_EQ(row.value(session), row.field.initial);
}

TEST(preferences, say_what_would_be_right) {
  Session session(std::make_unique<Document>());
  EXPECT_NE(session.run("prefer teme dark").sentence.en.find("did you mean theme?"), std::string::npos);
  EXPECT_NE(session.run("prefer scale 9").sentence.en.find("0.5 to 3"), std::string::npos)
      << session.run("prefer scale 9").sentence.en;
  EXPECT_EQ(session.run("prefer scale").exit_code, ExitCode::usage);
}

TEST(preferences, bind_keys_and_say_which_other_command_loses_its_key) {
  Session session(std::make_unique<Document>());
  ASSERT_TRUE(session.run("bind Shift+Ctrl+K frame all").done());
  const std::vector<KeyBinding> one{{"Ctrl+Shift+K", "frame all"}};
  EXPECT_EQ(session.preferences.bindings, one) << "modifiers in their usual order";
  const Outcome taken = session.run("bind G frame all");
  ASSERT_TRUE(taken.done());
  EXPECT_NE(taken.sentence.en.find("G did 'move the selection"), std::string::npos) << taken.sentence.en;
  EXPECT_NE(taken.sentence.en.find("(gesture move)"), std::string::npos) << taken.sentence.en;
  const InputPreset& preset = input_presets()[0];
  EXPECT_EQ(find_key("G", preset, session.preferences.bindings)->command, "frame all");
  EXPECT_EQ(find_key("G", preset, session.preferences.bindings)->help_en, find_key("Home")->help_en);
  ASSERT_EQ(rows_without_key(preset, session.preferences.bindings).size(), 1u);
  EXPECT_EQ(rows_without_key(preset, session.preferences.bindings)[0].command, "gesture move");
  ASSERT_TRUE(session.run("bind M gesture move").done());
  EXPECT_EQ(rows_without_key(preset, session.preferences.bindings)[0].command, "weld selected");
  ASSERT_TRUE(session.run("bind Home none").done());
  EXPECT_FALSE(find_key("Home", preset, session.preferences.bindings));
  ASSERT_TRUE(session.run("bind G initial").done());
  EXPECT_EQ(find_key("G", preset, session.preferences.bindings)->command, "gesture move");
  ASSERT_TRUE(session.run("bind M weld selected").done());
  EXPECT_EQ(session.preferences.bindings.size(), 2u) << "what the preset says is no binding of one's own";
  ASSERT_TRUE(session.run("bind all initial").done());
  EXPECT_TRUE(session.preferences.bindings.empty());
  for (const char* line : {"bind", "bind G", "bind Clrt+G shot", "bind Escape shot", "bind G nonsense", "bind Q mode"})
    EXPECT_EQ(session.run(line).exit_code, ExitCode::usage) << line;
  EXPECT_TRUE(session.preferences.bindings.empty());
}

TEST(preferences, a_bound_key_does_its_command_in_scripts) {
  Session session(std::make_unique<Document>());
  EXPECT_EQ(session.run("key Ctrl+K").exit_code, ExitCode::usage);
  ASSERT_TRUE(session.run("bind Ctrl+K theme light").done());
  ASSERT_TRUE(session.run("key Ctrl+K").done());
  EXPECT_EQ(session.view.settings.theme, Theme::light);
}

// Nested, bind was read again from each bind on, and deeper than the stack is.
TEST(preferences, a_key_binds_no_other_key_however_deep) {
  Session session(std::make_unique<Document>());
  const auto nested = [](std::size_t depth) {
    std::string line;
    for (std::size_t i = 0; i < depth; ++i) line += "bind Ctrl+K ";
    return line + "undo";
  };
  const auto start = std::chrono::steady_clock::now();
  for (const std::size_t depth : {2u, 3u, 100u, 7000u, 300000u}) {
    const Outcome outcome = session.run(nested(depth));
    EXPECT_EQ(outcome.exit_code, ExitCode::usage) << depth;
    EXPECT_EQ(outcome.sentence.en, "bind: a key cannot bind another key") << depth;
    EXPECT_NE(outcome.sentence.ja.find("bind"), std::string::npos) << depth;
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  for (const char* line : {"bind Ctrl+K bind G none", "bind Ctrl+K bind all initial", "bind Ctrl+K bind",
                           "bind Ctrl+K either undo | bind G none", "bind Ctrl+K either bind G undo | redo"})
    EXPECT_EQ(session.run(line).exit_code, ExitCode::usage) << line;
  EXPECT_TRUE(session.preferences.bindings.empty());
  EXPECT_TRUE(session.run("bind Ctrl+K either undo | redo").done());
}

TEST(preferences, keys_that_press_each_other_in_a_circle_are_refused) {
  Session session(std::make_unique<Document>());
  for (const char* line :
       {"bind F5 key F5", "bind F6 key F7", "bind F7 either undo | key F6", "bind F8 key F9", "bind F9 theme light"})
    ASSERT_TRUE(session.run(line).done()) << line;
  for (const char* line : {"key F5", "key F6", "key F7"}) {
    const Outcome outcome = session.run(line);
    EXPECT_EQ(outcome.exit_code, ExitCode::refused) << line;
    // Of several refusals `either` tells the first.
    EXPECT_NE(outcome.sentence.en.find(line == std::string("key F5") ? "in a circle" : "nothing to undo"),
              std::string::npos)
        << outcome.sentence.en;
  }
  EXPECT_TRUE(session.run("key F8").done()) << "one key may press another";
  EXPECT_EQ(session.view.settings.theme, Theme::light);
}

}  // namespace
}  // namespace ryosen
