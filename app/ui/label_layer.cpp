#include "app/ui/label_layer.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

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

void LabelLayer::follow(Session& session, View& view) {
  const std::span<const LabelSource> sources = label_sources();
  const bool is_on =
      !session.preparing() &&
      std::any_of(sources.begin(), sources.end(), [&](const LabelSource& source) { return source.is_on(session); });
  if (!is_on && is_empty_) return;
  if (is_on && !fonts_) {
    view.set_labels({});
    fonts_ = std::make_unique<ImFontAtlas>();
    load_label_font(*fonts_, std::round(label_font_px * scale_));
    view.set_label_fonts(*fonts_);
  }
  std::vector<PlacedLabel> placed;
  if (is_on)
    placed = placed_labels(
        session, [&](const std::string& s) { return label_size(*fonts_, s); }, scale_);
  const Palette& colours = palette(session.settings.theme);
  std::vector<DrawnLabel> texts;
  for (const PlacedLabel& label : placed)
    texts.push_back({label.corner, label.size, label.text, colours.label, colours.label_ground});
  view.set_labels(texts);
  is_empty_ = texts.empty();
}

}  // namespace ryosen
