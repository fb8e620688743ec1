#include "app/editor/texts/message_place.h"

namespace ryosen {

std::string place_in_file(const Message& message, std::string_view file) {
  std::string place(file);
  if (message.line) place += ":" + std::to_string(*message.line);
  if (message.line && message.column) place += ":" + std::to_string(*message.column);
  return place;
}

Text place_in_content(const Message& message) {
  Text place;
  if (message.byte) {
    const std::string byte = std::to_string(*message.byte) + ": ";
    place = {"byte " + byte, "バイト位置 " + byte};
  }
  if (message.face) {
    const std::string face = "f" + std::to_string(*message.face) + ": ";
    place += Text{face, face};
  }
  return place;
}

Text text_with_place(const Message& message, std::string_view file) {
  const bool has_place = message.line || message.byte || message.face;
  if (!has_place && message.text.en.find(file) != std::string::npos) return message.text;
  const std::string place = place_in_file(message, file);
  return Text{place + ": ", place + "："} + place_in_content(message) + message.text;
}

}  // namespace ryosen
