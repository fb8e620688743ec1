#include "render/pass/labels.h"

#include <algorithm>

namespace ryosen {

std::vector<PixelRect> LabelsPass::set(std::span<const DrawnLabel> texts) {
  std::vector<PixelRect> changed;
  if (std::equal(texts.begin(), texts.end(), texts_.begin(), texts_.end())) return changed;
  const auto add_missing = [&](std::span<const DrawnLabel> from, std::span<const DrawnLabel> in) {
    for (const DrawnLabel& text : from)
      if (std::find(in.begin(), in.end(), text) == in.end()) changed.push_back(text.rect());
  };
  add_missing(texts_, texts);
  add_missing(texts, texts_);
  texts_.assign(texts.begin(), texts.end());
  return changed;
}

}  // namespace ryosen
