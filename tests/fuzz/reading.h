// Any bytes read as a file.
#pragma once

#include <optional>
#include <string_view>

#include "ryosen/io/formats.h"

namespace ryosen::fuzz {

// The bytes read as a file of this format, in any case without a crash. A refusal has a code and its sentences; of a
// file that is read every face is kept or set aside, and what is kept can be connected. None if it is refused.
std::optional<MeshFile> read_any(const Format& format, std::string_view bytes);

}  // namespace ryosen::fuzz
