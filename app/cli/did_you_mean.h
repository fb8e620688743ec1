// Suggestions for unknown words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/editor/script.h"
#include "core/base/message.h"

namespace ryosen::cli {

// " Did you mean 'x'?", or empty if no known word is close.
inline Text did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::string best = closest_word(word.substr(0, 64), known);
  if (best.empty()) return {};
  return {" Did you mean '" + best + "'?", "「" + best + "」のことですか。"};
}

}  // namespace ryosen::cli
