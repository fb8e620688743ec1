// The fonts of the window.
#pragma once

#include <string>
#include <vector>

struct ImFont;
struct ImFontAtlas;

namespace ryosen {

struct Fonts {
  ImFont* normal = nullptr;
  ImFont* bold = nullptr;  // the normal one if there is no bold
};

// Rebuilds an atlas with glyphs `size_px` high: Latin letters and the symbols used by the window, and with `japanese`
// common Japanese characters, which take most of the time. If a font file is missing, ImGui's built-in font is used.
Fonts load_fonts(ImFontAtlas& atlas, float size_px, bool japanese);

// As above, of one weight only.
void load_label_font(ImFontAtlas& atlas, float size_px, bool japanese);

// A font role and the file that load_fonts() uses for it: its first readable candidate.
struct FontUse {
  const char *purpose_en, *purpose_ja;
  std::string file;  // the first candidate if none is readable
  bool is_found = false;
};
std::vector<FontUse> font_uses();

// Whether a text has characters that only the Japanese glyphs cover.
bool needs_japanese(const char* utf8);

}  // namespace ryosen
