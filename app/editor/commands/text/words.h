// Text parts of a command line: the rest after its first word, file names.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/message.h"

namespace ryosen {

using Words = std::span<const std::string_view>;

// Trims blanks (space, tab, carriage return) at both ends.
std::string_view without_blanks(std::string_view text);
// The rest of a line after its first word, trimmed.
std::string_view behind_word(std::string_view line);
// The same with the blanks before and behind it.
std::string_view behind_id(std::string_view line);

// The text without regard to the case of Latin letters.
std::string folded(std::string_view text);
// Whether each word of what was typed is somewhere in a text; both folded.
bool has_words(std::string_view text, std::string_view typed);
// Whether a word of the text begins so, or the text itself. Japanese words, which nothing parts, begin anywhere.
bool begins_a_word(std::string_view text, std::string_view word);

// Quotes a file name for a command line, so that file_name() restores it and scripts do not split it: quoted if it
// contains blanks, line ends, quotes, braces, `;` or `#`, or is empty. Within quotes `\"`, `\\`, `\n` and `\r` are
// escapes. Any bytes are allowed.
std::string file_argument(std::string_view name);
// Parses a file name argument: the whole text, trimmed, or the content of its quotes, where any other backslash is
// literal.
std::string file_name(std::string_view argument);

// As it begins a line of its own: with a capital in place of a small Latin letter.
std::string capitalized(std::string text);

// The line as it is shown: numbers that are values by themselves, with a point or an exponent, to six digits, and 0 for
// -0.
std::string with_short_numbers(std::string_view line);

// The sentence with a full stop, unless it ends as a question.
Text closed(Text sentence);

}  // namespace ryosen
