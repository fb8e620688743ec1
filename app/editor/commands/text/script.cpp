#include "app/editor/commands/text/script.h"

#include <algorithm>

#include "app/editor/commands/text/words.h"

namespace ryosen {

namespace {

// Damerau-Levenshtein distance (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] != b[j - 1]);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

std::string closest_word(std::string_view word, const std::vector<std::string>& known) {
  std::string best;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= least) continue;
    least = distance;
    best = candidate;
  }
  return best;
}

}  // namespace

std::vector<ScriptLine> split_script(std::string_view script) {
  std::vector<ScriptLine> lines;
  std::string current;
  int line = 1, depth = 0;
  bool comment = false, quoted = false, escaped = false;
  const auto finish = [&] {
    if (const std::string_view text = without_blanks(current); !text.empty())
      lines.push_back({line, std::string(text)});
    current.clear();
  };
  for (const char c : script) {
    if (c == '\n') {
      finish();
      ++line;
      comment = quoted = escaped = false;
      depth = 0;
    } else if (!comment) {
      if (c == '"' && !escaped) quoted = !quoted;
      escaped = quoted && !escaped && c == '\\';
      if (!quoted) depth += (c == '{') - (c == '}');
      const bool free = !quoted && depth <= 0;
      if (free && c == '#')
        comment = true;
      else if (free && c == ';')
        finish();
      else
        current += c;
    }
  }
  finish();
  return lines;
}

Text did_you_mean(std::string_view word, const std::vector<std::string>& known, HintForm form) {
  const std::string best = closest_word(word.substr(0, 64), known);
  if (best.empty()) return {};
  if (form == HintForm::sentence) return {" Did you mean '" + best + "'?", "「" + best + "」のことですか。"};
  return {"; did you mean " + best + "?", "。" + best + " ですか？"};
}

}  // namespace ryosen
