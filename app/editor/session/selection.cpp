#include "app/editor/session/selection.h"

#include <atomic>

namespace ryosen {

Elements& Selection::changed() {
  stamp_ = next_stamp();
  return elements_;
}

std::size_t Selection::count(Element::Kind kind) const {
  if (counted_ != stamp_) {
    counts_ = {};
    for (const Element& e : elements_) ++counts_[static_cast<std::size_t>(e.kind)];
    counted_ = stamp_;
  }
  return counts_[static_cast<std::size_t>(kind)];
}

std::uint64_t Selection::next_stamp() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace ryosen
