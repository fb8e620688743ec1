// The fonts of the window.
#pragma once

#include <string>
#include <vector>

struct ImFont;
struct ImFontAtlas;

namespace ryosen {

struct Fonts {
  ImFont* normal = nullptr;
  ImFont* bold = nullptr;  // the normal one where there is no bold
};

// Fills an atlas anew with glyphs `size_px` high: Latin letters and the signs that the window uses, and with `japanese`
// those of everyday Japanese, which take most of the time. A missing font file leaves ImGui's built-in font.
Fonts load_fonts(ImFontAtlas& atlas, float size_px, bool japanese);

// A use of a font, and the file that load_fonts() takes for it: the first of its candidates that can be read.
struct FontUse {
  const char *purpose_en, *purpose_ja;
  std::string file;  // where none can be read, the first candidate
  bool is_found = false;
};
std::vector<FontUse> font_uses();

// Whether a text has letters that only the Japanese glyphs cover.
bool needs_japanese(const char* utf8);

}  // namespace ryosen
