// The fonts of the window.
#pragma once

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

// Whether a text has letters that only the Japanese glyphs cover.
bool needs_japanese(const char* utf8);

}  // namespace ryosen
