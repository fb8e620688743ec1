// Splitting of scripts into commands: one per line or separated by `;`; `#` starts a comment.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ryosen {

struct ScriptLine {
  int line = 1;      // in the script, from 1
  std::string text;  // one command, without blanks around it
};

// The commands of a script in order, without empty ones. A `;` or `#` inside braces or quotes belongs to the text, and
// within quotes `\"` does not end them (see words.h).
std::vector<ScriptLine> split_script(std::string_view script);

// The known word closest to a misspelt one, or empty if none is close.
std::string closest_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace ryosen
