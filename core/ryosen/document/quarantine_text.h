// Messages about quarantined faces: they keep their numbers, but no command can use them.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "ryosen/indexed/indexed.h"

namespace ryosen {

// If a name (f7, 0-1@f7, ~0-1@f7, v3@f7) refers to such a face: a sentence with the cause and its line. `quarantine` is
// ascending by face.
std::optional<Text> quarantine_text(std::span<const QuarantinedFace> quarantine, std::string_view name);
// The same for the first of several names that refers to one.
std::optional<Text> quarantine_text(std::span<const QuarantinedFace> quarantine,
                                    std::span<const std::string_view> names);

}  // namespace ryosen
