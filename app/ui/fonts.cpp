#include "app/ui/fonts.h"

#include <imgui.h>
#include <imgui_freetype.h>

#include <cmath>
#include <filesystem>
#include <initializer_list>

namespace ryosen {

namespace {

constexpr const char* normal_file = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr const char* bold_file = "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf";
constexpr std::initializer_list<const char*> japanese_files = {
    "/usr/share/fonts/opentype/ipaexfont-gothic/ipaexg.ttf",
    "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",
};

// Latin, dashes and quotes, arrows, the minus sign, a tick and a cross.
constexpr ImWchar latin_ranges[] = {0x20,   0x17F,  0x2010, 0x2027, 0x2032, 0x2033, 0x2190, 0x2193, 0x2212,
                                    0x2212, 0x2260, 0x2260, 0x25B2, 0x25C6, 0x2713, 0x2717, 0};

// What the button that leads to Japanese says.
constexpr ImWchar word_ranges[] = {0x65E5, 0x65E5, 0x672C, 0x672C, 0x8A9E, 0x8A9E, 0};

bool exists(const char* file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored);
}

ImFont* add(ImFontAtlas& atlas, const char* file, float size_px, const ImWchar* ranges, bool merge) {
  if (!exists(file)) return nullptr;
  ImFontConfig config;
  config.MergeMode = merge;
  config.PixelSnapH = true;
  config.OversampleH = 1;
  if (merge) config.GlyphOffset.y = std::round(size_px / 15);  // the letters of both fonts stand on one line
  return atlas.AddFontFromFileTTF(file, size_px, &config, ranges);
}

}  // namespace

Fonts load_fonts(ImFontAtlas& atlas, float size_px, bool japanese) {
  atlas.Clear();
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  Fonts fonts;
  fonts.normal = add(atlas, normal_file, size_px, latin_ranges, false);
  if (!fonts.normal) {
    ImFontConfig config;
    config.SizePixels = size_px;
    fonts.normal = atlas.AddFontDefault(&config);
  }
  const ImWchar* const ranges = japanese ? atlas.GetGlyphRangesJapanese() : word_ranges;
  for (const char* file : japanese_files)
    if (add(atlas, file, size_px, ranges, true)) break;
  // Japanese has one weight here: a heading in it would otherwise need all glyphs twice.
  fonts.bold = japanese ? nullptr : add(atlas, bold_file, size_px, latin_ranges, false);
  if (!fonts.bold) fonts.bold = fonts.normal;
  return fonts;
}

bool needs_japanese(const char* utf8) {
  // Two-byte sequences reach to U+07FF; what begins with E3 or more is kana, kanji or beyond.
  for (; *utf8; ++utf8)
    if (static_cast<unsigned char>(*utf8) >= 0xE3) return true;
  return false;
}

}  // namespace ryosen
