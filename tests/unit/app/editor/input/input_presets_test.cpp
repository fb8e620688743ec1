#include "app/editor/input/input_presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace ryosen {
namespace {

std::string does_in(const std::vector<MouseRow>& rows, std::string_view input) {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const MouseRow& one) { return one.input.en == input; });
  return row == rows.end() ? "" : row->does.en;
}

TEST(gestures, are_told_as_the_preset_in_hand_has_them) {
  const auto told = [](std::size_t preset, std::string_view input) {
    return does_in(mouse_table(input_presets()[preset]), input);
  };
  EXPECT_EQ(told(0, "left drag"), "orbit");
  EXPECT_EQ(told(0, "Ctrl+Shift+left drag"), "select by a box; Alt goes through");
  EXPECT_EQ(told(1, "left drag"), "select by a box; Alt goes through");
  EXPECT_EQ(told(1, "Ctrl+right drag"), "select by a lasso; Alt goes through");
  EXPECT_EQ(told(2, "Shift+left drag"), "zoom");
  EXPECT_EQ(told(2, "middle drag"), "pan");
}

TEST(gestures, are_told_each_once_in_both_languages) {
  for (const InputPreset& preset : input_presets()) {
    std::set<std::string> en, ja;
    const std::vector<MouseRow> rows = mouse_table(preset);
    for (const MouseRow& row : rows) {
      EXPECT_TRUE(en.insert(row.input.en).second) << preset.id << ' ' << row.input.en;
      EXPECT_TRUE(ja.insert(row.input.ja).second) << preset.id << ' ' << row.input.ja;
      EXPECT_FALSE(row.does.en.empty() || row.does.ja.empty()) << preset.id << ' ' << row.input.en;
    }
    EXPECT_GT(rows.size(), preset.drags.size());
  }
}

}  // namespace
}  // namespace ryosen
