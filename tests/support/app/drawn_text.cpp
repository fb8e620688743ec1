#include "tests/support/app/drawn_text.h"

#include <imgui.h>

#include <algorithm>
#include <bit>
#include <glm/common.hpp>
#include <numeric>
#include <string>
#include <unordered_map>

namespace ryosen::test {

namespace {

char in_ascii(char32_t letter) { return letter < 128 ? static_cast<char>(letter) : '?'; }

// The letters of a text in UTF-8.
std::u32string without_spaces(std::string_view text) {
  std::u32string letters;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool goes_on = (byte & 0xC0) == 0x80;
    if (goes_on)
      letters.back() = letters.back() << 6 | (byte & 0x3Fu);
    else if (c != ' ')
      letters += byte < 0x80 ? byte : byte < 0xE0 ? byte & 0x1Fu : byte < 0xF0 ? byte & 0x0Fu : byte & 0x07u;
  }
  return letters;
}

}  // namespace

DrawnText::DrawnText(const Gui& gui) {
  // A glyph is four vertices; the first has the upper left corner of its picture in the atlas.
  const auto corner_in_atlas = [](float u, float v) {
    return std::uint64_t{std::bit_cast<std::uint32_t>(u)} << 32 | std::bit_cast<std::uint32_t>(v);
  };
  std::unordered_map<std::uint64_t, unsigned> letters;
  for (const ImFont* font : gui.fonts().Fonts) {
    letters.reserve(letters.size() + static_cast<std::size_t>(font->Glyphs.Size));
    for (const ImFontGlyph& glyph : font->Glyphs)
      if (glyph.Visible) letters[corner_in_atlas(glyph.U0, glyph.V0)] = glyph.Codepoint;
  }
  const ImDrawData& drawn = gui.draw_data();
  for (int i = 0; i < drawn.CmdListsCount; ++i) {
    const ImDrawList& list = *drawn.CmdLists[i];
    std::vector<bool> is_read(static_cast<std::size_t>(list.VtxBuffer.Size));
    for (const ImDrawCmd& command : list.CmdBuffer) {
      for (unsigned n = 0; n < command.ElemCount; ++n) {
        const int k = list.IdxBuffer[static_cast<int>(command.IdxOffset + n)] + static_cast<int>(command.VtxOffset);
        if (is_read[static_cast<std::size_t>(k)] || k + 2 >= list.VtxBuffer.Size) continue;
        const auto letter = letters.find(corner_in_atlas(list.VtxBuffer[k].uv.x, list.VtxBuffer[k].uv.y));
        if (letter == letters.end() || (list.VtxBuffer[k].col & IM_COL32_A_MASK) == 0) continue;
        is_read[static_cast<std::size_t>(k)] = true;
        const ImVec2 &corner = list.VtxBuffer[k].pos, &across = list.VtxBuffer[k + 2].pos;
        if (letter->second == 0x2026) ellipses_.push_back(letters_.size());
        letters_.push_back(letter->second);
        places_.emplace_back((corner.x + across.x) / 2, (corner.y + across.y) / 2);
        glyphs_.push_back({{std::min(corner.x, across.x), std::min(corner.y, across.y)},
                           {std::max(corner.x, across.x), std::max(corner.y, across.y)},
                           {command.ClipRect.x, command.ClipRect.y},
                           {command.ClipRect.z, command.ClipRect.w},
                           i});
      }
    }
  }
}

template <class Is>
std::string DrawnText::letters_that(Is is) const {
  std::string letters;
  for (std::size_t i = 0; i < glyphs_.size(); ++i)
    if (is(i)) letters += in_ascii(letters_[i]);
  return letters;
}

std::string DrawnText::cut_sideways() const {
  return letters_that([&](std::size_t i) {
    const Glyph& g = glyphs_[i];
    const double bearing = 0.3 * (g.last.x - g.first.x);  // a J begins left of its place
    return g.first.x < g.clip_first.x - bearing || g.last.x > g.clip_last.x + bearing;
  });
}

std::string DrawnText::cut_in_height() const {
  return letters_that([&](std::size_t i) {
    const Glyph& g = glyphs_[i];
    const bool is_seen = g.last.y > g.clip_first.y && g.first.y < g.clip_last.y;
    return is_seen && (g.first.y < g.clip_first.y - 1 || g.last.y > g.clip_last.y + 1);
  });
}

std::vector<std::string> DrawnText::shortened() const {
  constexpr std::size_t most = 24;
  std::vector<std::string> ends;
  for (const std::size_t at : ellipses_) {
    const std::size_t begin = at - std::min(at, most);
    const auto place = [&](double pixel) { return std::to_string(static_cast<int>(pixel)); };
    std::string end;
    for (std::size_t i = begin; i < at; ++i) end += in_ascii(letters_[i]);
    ends.push_back(end + " at " + place(places_[at].x) + "," + place(places_[at].y));
  }
  return ends;
}

std::string DrawnText::overlapping() const {
  const auto share = [&](const Glyph& g, const Glyph& h) {
    const glm::dvec2 both = glm::min(g.last, h.last) - glm::max(g.first, h.first), size = g.last - g.first;
    return both.x > 0 && both.y > 0 ? both.x * both.y / (size.x * size.y) : 0;
  };
  std::vector<std::size_t> by_top(glyphs_.size());
  std::iota(by_top.begin(), by_top.end(), std::size_t{0});
  std::sort(by_top.begin(), by_top.end(),
            [&](std::size_t a, std::size_t b) { return glyphs_[a].first.y < glyphs_[b].first.y; });
  double highest = 0;
  for (const Glyph& g : glyphs_) highest = std::max(highest, g.last.y - g.first.y);
  return letters_that([&](std::size_t i) {
    const Glyph& g = glyphs_[i];
    const auto begins_above = [&](std::size_t k, double y) { return glyphs_[k].first.y < y; };
    auto at = std::lower_bound(by_top.begin(), by_top.end(), g.first.y - highest, begins_above);
    for (; at != by_top.end() && begins_above(*at, g.last.y); ++at)
      if (*at != i && glyphs_[*at].window == g.window && share(g, glyphs_[*at]) > 0.4) return true;
    return false;
  });
}

std::vector<glm::dvec2> DrawnText::places(std::string_view text) const {
  const std::u32string wanted = without_spaces(text);
  std::vector<glm::dvec2> found;
  const auto is_letter = [](char32_t drawn, char32_t meant) {
    return drawn == meant || (meant == '?' && drawn >= 128);
  };
  for (auto at = letters_.begin();; ++at) {
    at = std::search(at, letters_.end(), wanted.begin(), wanted.end(), is_letter);
    if (at == letters_.end()) break;
    found.push_back(places_[static_cast<std::size_t>(at - letters_.begin())]);
  }
  return found;
}

std::size_t DrawnText::count(std::string_view text) const { return places(text).size(); }

glm::dvec2 DrawnText::place(std::string_view text) const {
  const std::vector<glm::dvec2> found = places(text);
  return found.empty() ? glm::dvec2(-1e9) : found.front();
}

glm::dvec2 DrawnText::last_place(std::string_view text) const {
  const std::vector<glm::dvec2> found = places(text);
  return found.empty() ? glm::dvec2(-1e9) : found.back();
}

}  // namespace ryosen::test
