// Lines of text are drawn whole or not at all: one that the end of its list, panel or column would cut in two is left out,
// as if the list ended with a whole row.
#pragma once

#include <cstdint>
#include <unordered_map>

struct ImDrawData;
struct ImFontAtlas;

namespace ryosen {

class WholeLines {
 public:
  // Again whenever the glyphs have changed.
  void learn(const ImFontAtlas& atlas);
  // Of a frame that is rendered. O(vertices).
  void keep(ImDrawData& drawn) const;

 private:
  // Where a glyph lies in its line, in pixels from the top of that; how high a line is.
  struct InLine {
    float top, height;
  };
  std::unordered_map<std::uint64_t, InLine> glyphs_;  // by their places in the atlas
};

}  // namespace ryosen
