// Sentences in the upper left corner of the view.
#include "app/editor/camera/view_state.h"
#include "app/editor/labels/labels.h"
#include "app/editor/preferences/preference_values.h"

namespace ryosen {

namespace {

// Roughly, in pixels at display scale 1: other characters than Latin ones are as wide as they are high.
double width_of(std::string_view character) { return character.size() > 1 ? 15.0 : 7.8; }

// The lines of a text of at most so many pixels each: broken between words, or between characters where these are wide.
std::vector<std::string> broken_lines(std::string_view text, double most_px) {
  std::vector<std::string> lines(1);
  double width = 0;
  std::size_t last_break = 0;  // in the last line: behind it the next one begins
  for (std::size_t at = 0; at < text.size();) {
    std::size_t bytes = 1;
    while (at + bytes < text.size() && (static_cast<unsigned char>(text[at + bytes]) & 0xc0u) == 0x80u) ++bytes;
    const std::string_view character = text.substr(at, bytes);
    at += bytes;
    lines.back() += character;
    width += width_of(character);
    if (character == " " || bytes > 1) last_break = lines.back().size();
    if (width < most_px || last_break == 0) continue;
    std::string rest = lines.back().substr(last_break);
    lines.back().resize(last_break);
    width = 7.8 * double(rest.size());
    lines.push_back(std::move(rest));
    last_break = 0;
  }
  return lines;
}

}  // namespace

void add_caption(const ViewState& view, const Preferences& preferences, std::span<const std::string> sentences,
                 std::vector<Label>& labels) {
  int row = 0;
  const double scale = preferences.label_scale();
  const double left = view.covered_px.x / scale + caption_margin_px;
  const double room = (view.size.width - view.covered_px.x - view.covered_px.y) / scale - 2 * caption_margin_px;
  for (const std::string& sentence : sentences)
    for (std::string& line : broken_lines(sentence, room))
      labels.push_back({.text = std::move(line),
                        .priority = legend_priority,
                        .shift_px = {left, caption_margin_px + (row++ + 0.5) * caption_row_px},
                        .pixel = glm::dvec2(0, 0),
                        .begins_there = true});
}

}  // namespace ryosen
