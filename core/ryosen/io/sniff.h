// Classification of files that match no format, by their first bytes.
#pragma once

#include <optional>
#include <string_view>

#include "ryosen/base/result.h"

namespace ryosen {

// The failure for a file that cannot be any mesh format: empty, compressed, UTF-16, or starting with only zeros.
std::optional<Failure> refuse_before_sniffing(std::string_view head);

// The failure for non-text content that was not recognised as a binary format.
std::optional<Failure> refuse_binary(std::string_view head);

}  // namespace ryosen
