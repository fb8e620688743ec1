// Lines of text are drawn whole or not at all: one that the end of its list, panel or column would cut in two is left
// out, as if the list ended with a whole row. So are buttons, headers and marks that the end of a column would cut.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

struct ImDrawData;
struct ImDrawList;
struct ImFontAtlas;

namespace ryosen {

// What of a column that scrolls is seen, in pixels; `covering` is drawn over its upper end.
struct SeenPart {
  std::string_view window, covering;  // their names, of which those of the windows inside begin
  float top = 0, bottom = 0;
};

class WholeLines {
 public:
  // Again whenever the glyphs have changed.
  void learn(const ImFontAtlas& atlas);
  // Of a frame that is rendered. O(vertices).
  void keep(ImDrawData& drawn, std::span<const SeenPart> columns) const;

 private:
  // Where a glyph lies in its line, in pixels from the top of that; how high a line is.
  struct InLine {
    float top, height;
  };
  // From a height to one further down.
  struct Band {
    float top, bottom;
  };
  std::optional<Band> line_of(const ImDrawList& list, int first) const;
  void keep_letters(ImDrawList& list) const;
  void keep_rows(ImDrawData& drawn, const SeenPart& seen) const;

  std::unordered_map<std::uint64_t, InLine> glyphs_;  // by their places in the atlas
  float line_px_ = 0;                                 // how high the lowest lines are
};

}  // namespace ryosen
