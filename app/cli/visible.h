// Text from files and file names, made safe for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace ryosen::cli {

// Control characters, those that turn the direction of writing, and bytes that are no UTF-8 become escapes (\x1b,
// \u202e); line ends and tabs stay.
std::string visible(std::string_view text);
// The same for what belongs on one line; there they become escapes too.
std::string visible_line(std::string_view text);

}  // namespace ryosen::cli
