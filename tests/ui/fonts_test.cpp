#include "app/ui/fonts.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <filesystem>

namespace ryosen {
namespace {

TEST(fonts, uses_name_the_file_that_is_taken) {
  const std::vector<FontUse> uses = font_uses();
  ASSERT_EQ(uses.size(), 3u);
  for (const FontUse& use : uses) {
    EXPECT_STRNE(use.purpose_en, "");
    EXPECT_STRNE(use.purpose_ja, "");
    EXPECT_EQ(use.is_found, std::filesystem::is_regular_file(use.file)) << use.file;
  }
  ImFontAtlas atlas;
  load_fonts(atlas, 15, false);
  std::vector<std::string> loaded;
  for (const ImFontConfig& config : atlas.ConfigData) loaded.emplace_back(config.Name);
  for (const FontUse& use : uses) {
    const std::string name = std::filesystem::path(use.file).filename();
    const bool is_loaded = std::any_of(loaded.begin(), loaded.end(),
                                       [&](const std::string& other) { return other.find(name) != std::string::npos; });
    EXPECT_EQ(is_loaded, use.is_found) << name;
  }
}

}  // namespace
}  // namespace ryosen
