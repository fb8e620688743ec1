// Splitting of scripts into commands: one per line or separated by `;`; `#` starts a comment.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/message.h"

namespace ryosen {

struct ScriptLine {
  int line = 1;      // in the script, from 1
  std::string text;  // one command, without blanks around it
};

// The commands of a script in order, without empty ones. A `;` or `#` inside braces or quotes belongs to the text, and
// within quotes `\"` does not end them (see words.h).
std::vector<ScriptLine> split_script(std::string_view script);

// Names the known word that is closest to a misspelt one, to be added to the sentence about it: "; did you mean x?", or
// " Did you mean 'x'?" after a full stop. Empty if none is close.
enum class HintForm { clause, sentence };
Text did_you_mean(std::string_view word, const std::vector<std::string>& known, HintForm form = HintForm::clause);

}  // namespace ryosen
