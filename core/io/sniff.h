// What the first bytes of a file tell, before any format reads it.
#pragma once

#include <optional>
#include <string_view>

#include "core/base/result.h"
#include "core/io/formats.h"

namespace ryosen {

// The refusal of a file that no mesh format can be: empty, compressed, UTF-16, or beginning with nothing but zeros.
std::optional<Failure> refuse_before_sniffing(std::string_view head);

// The refusal of bytes that are no text, for files whose content was not recognised as a binary format.
std::optional<Failure> refuse_binary(std::string_view head);

Likeness looks_like_obj(std::string_view head);
Likeness looks_like_off(std::string_view head);
Likeness looks_like_ply(std::string_view head);
// `size` is that of the whole file.
Likeness looks_like_stl(std::string_view head, std::uint64_t size);
Likeness looks_like_txt(std::string_view head);

}  // namespace ryosen
