// What the first bytes of a file that is of no format tell.
#pragma once

#include <optional>
#include <string_view>

#include "core/base/result.h"

namespace ryosen {

// The refusal of a file that no mesh format can be: empty, compressed, UTF-16, or beginning with nothing but zeros.
std::optional<Failure> refuse_before_sniffing(std::string_view head);

// The refusal of bytes that are no text, for files whose content was not recognised as a binary format.
std::optional<Failure> refuse_binary(std::string_view head);

}  // namespace ryosen
