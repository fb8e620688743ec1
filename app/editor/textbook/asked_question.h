// The question of practice that is open: what the view and Escape need of it.
#pragma once

#include <cstdint>
#include <optional>

#include "ryosen/base/element.h"

namespace ryosen {

class Session;

struct AskedQuestion {
  Element about;
  std::uint64_t serial, revision;  // of the document
  friend bool operator==(const AskedQuestion&, const AskedQuestion&) = default;
};

// What it names, to be marked; none where its panel is not shown or the mesh is another.
std::optional<Element> asked_element(const Session& session);

}  // namespace ryosen
