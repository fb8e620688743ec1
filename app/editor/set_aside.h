// Faces that reading a file set aside: they keep their numbers, but no command can work on them.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/indexed/indexed.h"

namespace ryosen {

// When a name (f7, 0-1@f7, ~0-1@f7, v3@f7) speaks of such a face: that it was set aside, why, and its line. The faces
// are ascending.
std::optional<Text> set_aside_sentence(std::span<const QuarantinedFace> quarantine, std::string_view name);
// The sentence about the first of several names that speaks of one.
std::optional<Text> set_aside_sentence(std::span<const QuarantinedFace> quarantine,
                                       std::span<const std::string_view> names);

}  // namespace ryosen
