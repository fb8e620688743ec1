#include "app/ui/whole_lines.h"

#include <imgui.h>

#include <bit>

namespace ryosen {

namespace {

// What of a line may be cut: no letter reaches there.
constexpr float free_above = 0.12f, free_below = 0.03f;  // shares of its height

std::uint64_t place_key(float u, float v) {
  return std::uint64_t{std::bit_cast<std::uint32_t>(u)} << 32 | std::bit_cast<std::uint32_t>(v);
}

}  // namespace

void WholeLines::learn(const ImFontAtlas& atlas) {
  glyphs_.clear();
  for (const ImFont* const font : atlas.Fonts)
    for (const ImFontGlyph& glyph : font->Glyphs)
      if (glyph.Visible) glyphs_[place_key(glyph.U0, glyph.V0)] = {glyph.Y0, font->FontSize};
}

void WholeLines::keep(ImDrawData& drawn) const {
  for (int n = 0; n < drawn.CmdListsCount; ++n) {
    ImDrawList& list = *drawn.CmdLists[n];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      // A letter is two triangles of four vertices, the first at its upper left corner; turned ones are left alone.
      for (unsigned i = 0; i + 5 < command.ElemCount; i += 3) {
        const int first = list.IdxBuffer[static_cast<int>(command.IdxOffset + i)] + static_cast<int>(command.VtxOffset);
        if (first + 3 >= list.VtxBuffer.Size) continue;
        ImDrawVert* const corner = &list.VtxBuffer[first];
        const auto glyph = glyphs_.find(place_key(corner[0].uv.x, corner[0].uv.y));
        const bool is_upright = corner[0].pos.y == corner[1].pos.y && corner[0].pos.x < corner[1].pos.x;
        if (glyph == glyphs_.end() || !is_upright) continue;
        const float height = glyph->second.height, top = corner[0].pos.y - glyph->second.top;
        const bool is_cut =
            top + free_above * height < command.ClipRect.y || top + (1 - free_below) * height > command.ClipRect.w;
        if (!is_cut) continue;
        for (int k = 0; k < 4; ++k) corner[k].col &= ~IM_COL32_A_MASK;
      }
    }
  }
}

}  // namespace ryosen
