// The parts of a command line that are texts: what stands behind its first word, and names of files.
#pragma once

#include <string>
#include <string_view>

namespace ryosen {

// Without blanks (space, tab, carriage return) at both ends.
std::string_view without_blanks(std::string_view text);
// What stands behind the first word of a line, without blanks around it.
std::string_view behind_word(std::string_view line);

// A file name as a command line says it, such that file_name() reads it back and a script keeps it together: in quotes
// where it holds blanks, line ends, quotes, braces, `;` or `#`, or nothing at all. Between quotes `\"` and `\\` stand for
// a quote and a backslash, `\n` and `\r` for line ends. Any bytes are allowed.
std::string file_argument(std::string_view name);
// The file name that an argument says: all of it with the blanks within but not around it, or what its quotes hold, where
// any other backslash stands for itself.
std::string file_name(std::string_view argument);

}  // namespace ryosen
