#include "ryosen/mesh/cell_marks.h"

#include <algorithm>
#include <utility>

namespace ryosen {

void CellMarks::grow() {
  constexpr std::size_t smallest = 128;
  std::vector<std::uint64_t> old(std::max(smallest, 2 * slots_.size()), 0);
  std::swap(old, slots_);
  for (std::uint64_t key : old) {
    if (key >> key_bits != generation_) continue;
    std::size_t slot = first_slot(key);
    while (slots_[slot] != 0) slot = (slot + 1) & (slots_.size() - 1);
    slots_[slot] = key;
  }
}

}  // namespace ryosen
