// The place in a file that a message is about, as every frontend writes it.
#pragma once

#include <string>
#include <string_view>

#include "ryosen/base/message.h"

namespace ryosen {

// bad.off:5:4, or less where the message knows less.
std::string place_in_file(const Message& message, std::string_view file);
// "byte 84: " or "f7: ": what comes before the text of a message that has no line.
Text place_in_content(const Message& message);
// The text behind its place: "bad.off:5:4: The vertex ...". One about the whole file that names it stays as it is.
Text text_with_place(const Message& message, std::string_view file);

}  // namespace ryosen
