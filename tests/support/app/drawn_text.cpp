#include "tests/support/app/drawn_text.h"

#include <imgui.h>

#include <algorithm>
#include <map>
#include <string>

namespace ryosen::test {

namespace {

std::string without_spaces(std::string_view text) {
  std::string rest(text);
  std::erase(rest, ' ');
  return rest;
}

}  // namespace

DrawnText::DrawnText(const Gui& gui) {
  // A glyph is four vertices; the first has the upper left corner of its picture in the atlas.
  std::map<std::pair<float, float>, unsigned> glyphs;
  for (const ImFont* font : gui.fonts().Fonts)
    for (const ImFontGlyph& glyph : font->Glyphs)
      if (glyph.Visible) glyphs[{glyph.U0, glyph.V0}] = glyph.Codepoint;
  const ImDrawData& drawn = gui.draw_data();
  for (int i = 0; i < drawn.CmdListsCount; ++i) {
    const ImVector<ImDrawVert>& vertices = drawn.CmdLists[i]->VtxBuffer;
    for (int k = 0; k + 2 < vertices.Size; ++k) {
      const auto glyph = glyphs.find({vertices[k].uv.x, vertices[k].uv.y});
      if (glyph == glyphs.end()) continue;
      const ImVec2 &corner = vertices[k].pos, &across = vertices[k + 2].pos;
      text_ += glyph->second < 128 ? static_cast<char>(glyph->second) : '?';
      places_.emplace_back((corner.x + across.x) / 2, (corner.y + across.y) / 2);
    }
  }
}

std::size_t DrawnText::count(std::string_view text) const {
  const std::string wanted = without_spaces(text);
  std::size_t n = 0;
  for (std::size_t at = text_.find(wanted); at != std::string::npos; at = text_.find(wanted, at + 1)) ++n;
  return n;
}

glm::dvec2 DrawnText::place(std::string_view text) const {
  const std::size_t at = text_.find(without_spaces(text));
  return at == std::string::npos ? glm::dvec2(-1e9) : places_[at];
}

}  // namespace ryosen::test
