// Lines of text that end where a panel does: also between kana and kanji, and not behind the points of numbers.
#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "app/ui/widgets.h"

namespace ryosen {

namespace {

const char* behind_letter(const char* at, const char* end) {
  do ++at;
  while (at < end && !begins_letter(*at));
  return at;
}

// The beginning of the letter that ends there.
const char* at_letter(const char* end) {
  do --end;
  while (!begins_letter(*end));
  return end;
}

// No line begins with one of these.
bool is_closing(std::string_view text) {
  for (const std::string_view mark :
       {"、", "。", "）", "」", "：", "・", "！", "？", "ー", "々", "っ", "ゃ", "ゅ", "ょ", "ッ",
        "ャ", "ュ", "ョ", "ァ", "ィ", "ゥ", "ェ", "ォ", "ぁ", "ぃ", "ぅ", "ぇ", "ぉ", "°",  "%"})
    if (text.starts_with(mark)) return true;
  return false;
}

// No line ends with one of these.
bool is_opening(std::string_view letter) { return letter == "（" || letter == "「"; }

bool is_kanji(char c) { return static_cast<unsigned char>(c) >= 0xE3; }
bool is_latin(char c) { return c > ' ' && c <= '~'; }
// Behind these a word of Latin letters may be parted: alternatives and chords of keys.
bool parts_words(char c) { return c == '|' || c == '+'; }

// Between kana and kanji a line may end anywhere: takes as many of them as fit, and the Latin words that they follow
// without a blank, where ImGui would end at a blank before.
const char* with_kanji(const char* begin, const char* at, const char* end, float width_px) {
  while (at < end) {
    const char* next = std::find_if(at, end, [](char c) { return c != ' '; });
    if (next == end) return at;
    if (is_kanji(*next)) {
      next = behind_letter(next, end);
    } else {
      next = std::find_if(next, end, [](char c) { return c == ' ' || is_kanji(c); });
      if (next == end || *next == ' ') break;  // ImGui has seen that it does not fit
    }
    if (ImGui::CalcTextSize(begin, next).x > width_px) break;
    at = next;
  }
  const char* before = at;
  while (before > begin && is_closing({before, static_cast<std::size_t>(end - before)})) {
    before = at_letter(before);
    while (before > begin && is_latin(*before) && is_latin(before[-1]))
      --before;  // a word or number goes on as a whole
  }
  // ImGui ends lines behind the points of numbers and, where there is no blank before, within words.
  const char* word = before;
  while (word > begin && word < end && is_latin(*word) && is_latin(word[-1]) && !parts_words(word[-1])) --word;
  if (word > begin) before = word;
  while (before > begin && is_opening({at_letter(before), static_cast<std::size_t>(before - at_letter(before))}))
    before = at_letter(before);
  return before > begin ? before : at;
}

// Where a line that begins at a letter ends when it is no wider than that; at least one letter.
const char* end_of_line(const char* begin, const char* end, float width_px) {
  end = std::find(begin, end, '\n');
  const char* at = ImGui::GetFont()->CalcWordWrapPositionA(1, begin, end, width_px);
  // ImGui ends lines behind points too, also those of numbers and file names.
  const char* blank = at;
  while (blank > begin && *blank != ' ' && !parts_words(blank[-1])) --blank;
  if (at < end && *at != ' ' && blank > begin && static_cast<unsigned char>(*at) < 0x80) at = blank;
  return at == begin && at < end ? behind_letter(at, end) : with_kanji(begin, at, end, width_px);
}

// Calls each(begin, end) of every line of a text no wider than that; at least once.
template <class Each>
void for_each_line(std::string_view text, float width_px, Each each) {
  const char *at = text.data(), *const end = at + text.size();
  do {
    const char* const line_end = end_of_line(at, end, width_px);
    each(at, line_end);
    at = line_end;
    while (at < end && *at == ' ') ++at;
    if (at < end && *at == '\n') ++at;
  } while (at < end);
}

}  // namespace

void wrapped_text(const char* text) { wrapped_text(text, ImGui::GetContentRegionAvail().x); }

void wrapped_text(std::string_view text, float width_px) {
  ImGui::BeginGroup();
  for_each_line(text, width_px, [](const char* begin, const char* end) { ImGui::TextUnformatted(begin, end); });
  ImGui::EndGroup();
}

ImVec2 wrapped_size(std::string_view text, float width_px) {
  ImVec2 size(0, -ImGui::GetStyle().ItemSpacing.y);
  for_each_line(text, width_px, [&](const char* begin, const char* end) {
    const ImVec2 line = ImGui::CalcTextSize(begin, end);
    size = {std::max(size.x, line.x), size.y + line.y + ImGui::GetStyle().ItemSpacing.y};
  });
  return size;
}

std::size_t lines_of(std::string_view text, float width_px) {
  std::size_t lines = 0;
  for_each_line(text, width_px, [&](const char*, const char*) { ++lines; });
  return lines;
}

std::string fitted_lines(std::string_view text, float width_px, std::size_t most) {
  std::vector<const char*> begins;
  for_each_line(text, width_px, [&](const char* begin, const char*) { begins.push_back(begin); });
  if (begins.size() <= most) return std::string(text);
  const std::string_view last = text.substr(static_cast<std::size_t>(begins[most - 1] - text.data()));
  return std::string(text.substr(0, text.size() - last.size())) + fitted_at_word(last, width_px);
}

bool wrapped_row(PanelContext& context, std::string_view text, bool is_active, float width_px) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float indent = 12 * context.scale, pitch = ImGui::GetTextLineHeightWithSpacing();
  const float height = wrapped_size(text, width_px - indent).y;
  const bool clicked = marked_row(context, is_active, height);
  ImVec2 line{at.x + indent, at.y};
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 0.4f * indent, at.y + 0.55f * ImGui::GetFontSize()},
                                              2 * context.scale, ImGui::GetColorU32(context.colours().dim));
  for_each_line(text, width_px - indent, [&](const char* begin, const char* end) {
    ImGui::GetWindowDrawList()->AddText(line, ImGui::GetColorU32(ImGuiCol_Text), begin, end);
    line.y += pitch;
  });
  return clicked;
}

float lines_of_wrapped_row(PanelContext& context, std::string_view text, float width_px) {
  const float height = wrapped_size(text, width_px - 12 * context.scale).y + ImGui::GetStyle().ItemSpacing.y;
  return std::round(height / ImGui::GetTextLineHeightWithSpacing());
}

}  // namespace ryosen
