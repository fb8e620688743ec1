// A stack with inline storage for its first entries.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace ryosen {

template <class T, std::size_t Inline = 64>
class SmallStack {
 public:
  bool empty() const { return size_ == 0; }

  void push(const T& value) {
    if (size_ < Inline)
      first_[size_] = value;
    else
      rest_.push_back(value);
    ++size_;
  }

  T pop() {
    --size_;
    if (size_ < Inline) return first_[size_];
    const T value = rest_.back();
    rest_.pop_back();
    return value;
  }

  // Pops until an entry satisfies the predicate and returns it, or `otherwise` if none does.
  template <class Wanted>
  T pop_until(Wanted&& wanted, const T& otherwise) {
    while (!empty()) {
      const T value = pop();
      if (wanted(value)) return value;
    }
    return otherwise;
  }

 private:
  std::array<T, Inline> first_;
  std::vector<T> rest_;
  std::size_t size_ = 0;
};

}  // namespace ryosen
