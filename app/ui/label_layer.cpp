#include "app/ui/label_layer.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/session/session.h"
#include "app/ui/fonts.h"
#include "app/ui/style.h"
#include "render/palette.h"
#include "render/view.h"

namespace ryosen {

LabelLayer::LabelLayer() = default;
LabelLayer::~LabelLayer() = default;

void LabelLayer::set_scale(float scale) {
  if (scale == scale_) return;
  scale_ = scale;
  fonts_.reset();
}

void LabelLayer::load(View& view) {
  view.set_labels({});
  fonts_ = std::make_unique<ImFontAtlas>();
  load_label_font(*fonts_, std::round(label_font_px * scale_), has_japanese_);
  view.set_label_fonts(*fonts_);
}

void LabelLayer::follow(Session& session, View& view) {
  const std::span<const LabelSource> sources = label_sources();
  const bool is_on =
      !session.findings().preparing() &&
      std::any_of(sources.begin(), sources.end(), [&](const LabelSource& source) { return source.is_on(session); });
  if (!is_on && is_empty_) return;
  std::vector<PlacedLabel> placed;
  if (is_on) {
    if (!fonts_) load(view);
    const auto place = [&] {
      return placed_labels(
          session, [&](const std::string& s) { return label_size(*fonts_, s); }, scale_);
    };
    placed = place();
    const bool is_japanese = std::any_of(placed.begin(), placed.end(),
                                         [](const PlacedLabel& label) { return needs_japanese(label.text.c_str()); });
    if (is_japanese && !has_japanese_) {
      has_japanese_ = true;
      load(view);
      placed = place();
    }
  }
  const Palette& colours = palette(session.view.settings.theme);
  std::vector<DrawnLabel> texts;
  for (const PlacedLabel& label : placed) {
    DrawnLabel& text =
        texts.emplace_back(DrawnLabel{label.corner, label.size, label.text, colours.label, colours.label_ground});
    if (!label.ground) continue;
    text.ground = rgb(*label.ground);
    const auto [r, g, b, a] = text.ground;
    text.colour = 0.3 * r + 0.6 * g + 0.1 * b > 130 ? rgb(0x000000) : rgb(0xffffff);
  }
  view.set_labels(texts);
  is_empty_ = texts.empty();
}

}  // namespace ryosen
