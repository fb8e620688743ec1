// Many elements in few words: by their numbers, several in a row as v3..v9.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ryosen/base/element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// A word for each, with a blank before it, in the order of the elements: vN, eN, fN, hN by slot, and A..B for ascending
// neighbours.
std::string slot_ranges(std::span<const Element> elements);

struct SlotRange {
  Element first;
  std::uint32_t last;  // not below first.index
};
// Of a word as slot_ranges() writes it for several; none for anything else.
std::optional<SlotRange> parse_slot_range(std::string_view word);
// Those of a range that are alive.
void add_living(const Mesh& mesh, const SlotRange& range, Elements& elements);

}  // namespace ryosen
