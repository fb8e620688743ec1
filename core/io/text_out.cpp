#include "core/io/text_out.h"

namespace ryosen {

std::string on_one_line(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if ((static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f) c = ' ';
  }
  return out;
}

}  // namespace ryosen
