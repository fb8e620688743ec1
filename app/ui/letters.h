// Letters of UTF-8.
#pragma once

namespace ryosen {

inline bool begins_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

}  // namespace ryosen
