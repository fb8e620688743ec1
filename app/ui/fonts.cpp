#include "app/ui/fonts.h"

#include <imgui.h>
#include <imgui_freetype.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <initializer_list>

namespace ryosen {

namespace {

using Candidates = std::initializer_list<const char*>;

constexpr Candidates normal_files = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"};
constexpr Candidates bold_files = {"/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"};
constexpr Candidates japanese_files = {
    "/usr/share/fonts/opentype/ipaexfont-gothic/ipaexg.ttf",
    "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",
};

// Latin, dashes and quotes, arrows, the minus sign, a tick and a cross.
constexpr ImWchar latin_ranges[] = {0x20,   0x17F,  0x2010, 0x2027, 0x2032, 0x2033, 0x2190, 0x2193, 0x2212,
                                    0x2212, 0x2260, 0x2260, 0x25B2, 0x25C6, 0x2713, 0x2717, 0};

// The label of the button that switches to Japanese.
constexpr ImWchar word_ranges[] = {0x65E5, 0x65E5, 0x672C, 0x672C, 0x8A9E, 0x8A9E, 0};

// The first candidate that can be read, or null.
const char* find_file(Candidates candidates) {
  for (const char* file : candidates) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored) && access(file, R_OK) == 0) return file;
  }
  return nullptr;
}

FontUse use(const char* purpose_en, const char* purpose_ja, Candidates candidates) {
  const char* const found = find_file(candidates);
  return {purpose_en, purpose_ja, found ? found : *candidates.begin(), found != nullptr};
}

ImFont* add(ImFontAtlas& atlas, Candidates candidates, float size_px, const ImWchar* ranges, bool merge) {
  const char* const file = find_file(candidates);
  if (!file) return nullptr;
  ImFontConfig config;
  config.MergeMode = merge;
  config.PixelSnapH = true;
  config.OversampleH = 1;
  if (merge) config.GlyphOffset.y = std::round(size_px / 15);  // align the baselines of both fonts
  return atlas.AddFontFromFileTTF(file, size_px, &config, ranges);
}

// Clears an atlas and adds the Latin letters.
ImFont* begin(ImFontAtlas& atlas, float size_px) {
  atlas.Clear();
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  if (ImFont* const font = add(atlas, normal_files, size_px, latin_ranges, false)) return font;
  ImFontConfig config;
  config.SizePixels = size_px;
  return atlas.AddFontDefault(&config);
}

}  // namespace

Fonts load_fonts(ImFontAtlas& atlas, float size_px, bool japanese) {
  Fonts fonts;
  fonts.normal = begin(atlas, size_px);
  const ImWchar* const ranges = japanese ? atlas.GetGlyphRangesJapanese() : word_ranges;
  add(atlas, japanese_files, size_px, ranges, true);
  fonts.bold = add(atlas, bold_files, size_px, latin_ranges, false);
  if (!fonts.bold) fonts.bold = fonts.normal;
  return fonts;
}

void load_label_font(ImFontAtlas& atlas, float size_px, bool japanese) {
  begin(atlas, size_px);
  if (japanese) add(atlas, japanese_files, size_px, atlas.GetGlyphRangesJapanese(), true);
}

std::vector<FontUse> font_uses() {
  return {use("texts", "文字", normal_files), use("headings", "見出し", bold_files),
          use("Japanese texts", "日本語の文字", japanese_files)};
}

bool needs_japanese(const char* utf8) {
  // Two-byte sequences reach to U+07FF; lead bytes from E3 on are kana, kanji or beyond.
  for (; *utf8; ++utf8)
    if (static_cast<unsigned char>(*utf8) >= 0xE3) return true;
  return false;
}

}  // namespace ryosen
