#include "render/pass/ui_labels.h"

#include <imgui.h>

#include <cfloat>
#include <cmath>

namespace ryosen {

namespace {

constexpr int ground_px = 2;  // beyond the text, to the left and the right

ImU32 packed(Rgba c) { return IM_COL32(c[0], c[1], c[2], c[3]); }

void append(ImDrawList& list, const ImFontAtlas& fonts, const DrawnLabel& drawn) {
  const ImFont& font = *fonts.Fonts[0];
  const PixelRect rect = drawn.rect();
  const auto at = [](int x, int y) { return ImVec2(static_cast<float>(x), static_cast<float>(y)); };
  const ImVec2 white = fonts.TexUvWhitePixel;
  list.PrimReserve(6, 4);
  list.PrimRectUV(at(rect.x0, rect.y0), at(rect.x1, rect.y1), white, white, packed(drawn.ground));
  const ImVec4 everywhere(-FLT_MAX, -FLT_MAX, FLT_MAX, FLT_MAX);
  font.RenderText(&list, font.FontSize, at(rect.x0 + ground_px, rect.y0), packed(drawn.colour), everywhere,
                  drawn.text.data(), drawn.text.data() + drawn.text.size());
}

}  // namespace

Size label_size(const ImFontAtlas& atlas, const std::string& text) {
  const ImFont& font = *atlas.Fonts[0];
  const ImVec2 size = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0, text.data(), text.data() + text.size());
  return {static_cast<int>(std::ceil(size.x)) + 2 * ground_px, static_cast<int>(std::ceil(size.y))};
}

void UiLabels::set_fonts(ImFontAtlas& atlas) {
  ui_.set_fonts(atlas);
  fonts_ = &atlas;
}

void UiLabels::draw(std::span<const DrawnLabel> labels, const Framebuffer& picture, const PixelRect& rect) {
  if (labels.empty() || !fonts_) return;
  ImDrawList list(nullptr);  // only what needs no context is called
  list.CmdBuffer.push_back(ImDrawCmd());
  for (const DrawnLabel& label : labels)
    if (overlap(label.rect(), rect)) append(list, *fonts_, label);
  if (list.VtxBuffer.empty()) return;
  const Size size = picture.size();
  ImDrawCmd& command = list.CmdBuffer.back();
  command.ClipRect = {0, 0, static_cast<float>(size.width), static_cast<float>(size.height)};
  command.TextureId = fonts_->TexID;
  ImDrawList* lists[] = {&list};
  ImDrawData data;
  data.CmdLists = lists;
  data.CmdListsCount = 1;
  data.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
  data.FramebufferScale = {1, 1};
  ui_.draw(data, picture, rect);
}

}  // namespace ryosen
