#include "app/ui/label_layer.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/session/session.h"
#include "app/editor/views/seen_mesh.h"
#include "app/ui/fonts.h"
#include "app/ui/style.h"
#include "render/palette.h"
#include "render/renderer.h"

namespace ryosen {

LabelLayer::LabelLayer() = default;
LabelLayer::~LabelLayer() = default;

void LabelLayer::set_scale(float scale) {
  if (scale == scale_) return;
  scale_ = scale;
  fonts_.reset();
}

void LabelLayer::load(Renderer& renderer) {
  renderer.set_labels({});
  fonts_ = std::make_unique<ImFontAtlas>();
  load_label_font(*fonts_, std::round(label_font_px * scale_), has_japanese_);
  renderer.set_label_fonts(*fonts_);
}

void LabelLayer::follow(Session& session, Renderer& renderer) {
  const std::span<const LabelSource> sources = label_sources();
  const bool has_any =
      !session.findings().preparing() &&
      std::any_of(sources.begin(), sources.end(), [&](const LabelSource& source) { return source.is_on(session); });
  const auto place = [&](const TextSize& size_of) { return placed_labels(session, size_of, scale_); };
  follow(has_any, place, session.view.settings.theme, renderer);
}

void LabelLayer::follow(const SeenMesh& compared, Renderer& renderer) {
  const auto place = [&](const TextSize& size_of) { return placed_labels(compared, size_of, scale_); };
  follow(!compared.findings.preparing() && has_labels(compared), place, compared.view.settings.theme, renderer);
}

void LabelLayer::follow(bool has_any, const Place& place, Theme theme, Renderer& renderer) {
  if (!has_any && is_empty_) return;
  const auto size_of = [&](const std::string& text) { return label_size(*fonts_, text); };
  std::vector<PlacedLabel> placed;
  if (has_any) {
    if (!fonts_) load(renderer);
    placed = place(size_of);
    const bool is_japanese = std::any_of(placed.begin(), placed.end(),
                                         [](const PlacedLabel& label) { return needs_japanese(label.text.c_str()); });
    if (is_japanese && !has_japanese_) {
      has_japanese_ = true;
      load(renderer);
      placed = place(size_of);
    }
  }
  const Palette& colours = palette(theme);
  std::vector<DrawnLabel> texts;
  for (const PlacedLabel& label : placed) {
    DrawnLabel& text =
        texts.emplace_back(DrawnLabel{label.corner, label.size, label.text, colours.label, colours.label_ground});
    if (!label.ground) continue;
    text.ground = rgb(*label.ground);
    const auto [r, g, b, a] = text.ground;
    text.colour = 0.3 * r + 0.6 * g + 0.1 * b > 130 ? rgb(0x000000) : rgb(0xffffff);
  }
  renderer.set_labels(texts);
  is_empty_ = texts.empty();
}

}  // namespace ryosen
