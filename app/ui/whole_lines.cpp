#include "app/ui/whole_lines.h"

#include <imgui.h>

#include <algorithm>
#include <bit>
#include <limits>

namespace ryosen {

namespace {

// What of a line may be cut: no letter reaches there.
constexpr float free_above = 0.12f, free_below = 0.03f;  // shares of its height
// Of what else there is, in lines: so little of a frame may be cut; higher ones are no rows.
constexpr float free_of_frame = 0.12f, highest_row = 2.2f;

std::uint64_t place_key(float u, float v) {
  return std::uint64_t{std::bit_cast<std::uint32_t>(u)} << 32 | std::bit_cast<std::uint32_t>(v);
}

// What is drawn in one go: a letter, a frame, a mark. Its corners follow each other in the list.
struct Shape {
  int first, last;
  float top, bottom;
};

void hide(ImDrawList& list, int first, int last) {
  for (int k = first; k <= last; ++k) list.VtxBuffer[k].col &= ~IM_COL32_A_MASK;
}

// Calls each(shape) of all that a list draws; triangles without a common corner are parts of different ones.
template <class Each>
void for_each_shape(const ImDrawList& list, Each each) {
  for (const ImDrawCmd& command : list.CmdBuffer) {
    constexpr float far = std::numeric_limits<float>::max();
    Shape shape{0, -1, far, -far};
    for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
      int corners[3];
      for (unsigned k = 0; k < 3; ++k)
        corners[k] = list.IdxBuffer[static_cast<int>(command.IdxOffset + i + k)] + static_cast<int>(command.VtxOffset);
      const auto [low, high] = std::minmax({corners[0], corners[1], corners[2]});
      if (low > shape.last || high < shape.first) {
        if (shape.last >= 0) each(shape);
        shape = {low, -1, far, -far};
      }
      for (const int corner : corners) {
        const float y = list.VtxBuffer[corner].pos.y;
        shape = {std::min(shape.first, corner), std::max(shape.last, corner), std::min(shape.top, y),
                 std::max(shape.bottom, y)};
      }
    }
    if (shape.last >= 0) each(shape);
  }
}

bool is_of(const ImDrawList& list, const SeenPart& seen) {
  const std::string_view name = list._OwnerName ? list._OwnerName : "";
  return name.starts_with(seen.window) && (seen.covering.empty() || !name.starts_with(seen.covering));
}

}  // namespace

void WholeLines::learn(const ImFontAtlas& atlas) {
  glyphs_.clear();
  line_px_ = atlas.Fonts.empty() ? 0 : atlas.Fonts[0]->FontSize;
  for (const ImFont* const font : atlas.Fonts)
    for (const ImFontGlyph& glyph : font->Glyphs)
      if (glyph.Visible) glyphs_[place_key(glyph.U0, glyph.V0)] = {glyph.Y0, font->FontSize};
}

// Where the line of a letter lies, as far as letters reach; nothing for what is none or is turned. A letter has four
// vertices, the first at its upper left corner.
std::optional<WholeLines::Band> WholeLines::line_of(const ImDrawList& list, int first) const {
  if (first + 3 >= list.VtxBuffer.Size) return std::nullopt;
  const ImDrawVert* const corner = &list.VtxBuffer[first];
  const auto glyph = glyphs_.find(place_key(corner[0].uv.x, corner[0].uv.y));
  const bool is_upright = corner[0].pos.y == corner[1].pos.y && corner[0].pos.x < corner[1].pos.x;
  if (glyph == glyphs_.end() || !is_upright) return std::nullopt;
  const float height = glyph->second.height, top = corner[0].pos.y - glyph->second.top;
  return Band{top + free_above * height, top + (1 - free_below) * height};
}

void WholeLines::keep_letters(ImDrawList& list) const {
  for (const ImDrawCmd& command : list.CmdBuffer) {
    for (unsigned i = 0; i + 5 < command.ElemCount; i += 3) {
      const int first = list.IdxBuffer[static_cast<int>(command.IdxOffset + i)] + static_cast<int>(command.VtxOffset);
      const auto line = line_of(list, first);
      if (line && (line->top < command.ClipRect.y || line->bottom > command.ClipRect.w)) hide(list, first, first + 3);
    }
  }
}

// First what is cut, then what stands in the same row and is not.
void WholeLines::keep_rows(ImDrawData& drawn, const SeenPart& seen) const {
  std::vector<Band> cut;
  const auto is_cut = [&](const Band& band) {
    return (band.top < seen.top && band.bottom > seen.top) || (band.top < seen.bottom && band.bottom > seen.bottom);
  };
  const auto is_beside_cut = [&](float y) {
    return std::any_of(cut.begin(), cut.end(), [&](const Band& band) { return band.top < y && y < band.bottom; });
  };
  for (const bool is_first : {true, false}) {
    for (int n = 0; n < drawn.CmdListsCount; ++n) {
      ImDrawList& list = *drawn.CmdLists[n];
      if (!is_of(list, seen)) continue;
      for_each_shape(list, [&](const Shape& shape) {
        if (shape.bottom - shape.top > highest_row * line_px_) return;
        const float free = free_of_frame * line_px_;
        const Band band = line_of(list, shape.first).value_or(Band{shape.top + free, shape.bottom - free});
        if (is_first ? !is_cut(band) : !is_beside_cut((shape.top + shape.bottom) / 2)) return;
        hide(list, shape.first, shape.last);
        if (is_first) cut.push_back(band);
      });
    }
  }
}

void WholeLines::keep(ImDrawData& drawn, std::span<const SeenPart> columns) const {
  for (int n = 0; n < drawn.CmdListsCount; ++n) keep_letters(*drawn.CmdLists[n]);
  for (const SeenPart& column : columns) keep_rows(drawn, column);
}

}  // namespace ryosen
