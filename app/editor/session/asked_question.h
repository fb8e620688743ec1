// The question of practice that is open: what the view and Escape need of it.
#pragma once

#include <cstdint>
#include <optional>

#include "ryosen/base/element.h"

namespace ryosen {

class Document;
struct Layout;

struct AskedQuestion {
  Element about;
  std::uint64_t serial, revision;  // of the document
  friend bool operator==(const AskedQuestion&, const AskedQuestion&) = default;
};

// What it names, to be marked; none where its panel is not shown or the mesh is another.
std::optional<Element> asked_element(const Document& document, const Layout& layout,
                                     const std::optional<AskedQuestion>& asked_question);

}  // namespace ryosen
