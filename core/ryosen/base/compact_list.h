// An array of trivially copyable values that costs one pointer while empty; for structs that a file may hold by the
// million.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace ryosen {

// Contiguous like a vector, but resized only by assigning it as a whole. One allocation if not empty, none otherwise.
// Copies are deep; a moved-from list is empty.
template <class Value>
class CompactList {
  static_assert(std::is_trivially_copyable_v<Value> && alignof(Value) <= sizeof(std::size_t));

 public:
  using value_type = Value;
  using iterator = Value*;
  using const_iterator = const Value*;

  CompactList() = default;
  CompactList(std::initializer_list<Value> values) { assign(values.begin(), values.end()); }
  CompactList(const std::vector<Value>& values) { assign(values.begin(), values.end()); }
  CompactList(const CompactList& other) { assign(other.begin(), other.end()); }
  CompactList(CompactList&& other) noexcept = default;
  CompactList& operator=(const CompactList& other) {
    if (this != &other) assign(other.begin(), other.end());
    return *this;
  }
  CompactList& operator=(CompactList&& other) noexcept = default;
  ~CompactList() = default;

  // The range must not lie in this list.
  template <class Iterator>
  void assign(Iterator first, Iterator last) {
    const auto count = static_cast<std::size_t>(std::distance(first, last));
    block_.reset();
    if (count == 0) return;
    block_ = std::make_unique<std::byte[]>(sizeof count + count * sizeof(Value));
    std::memcpy(block_.get(), &count, sizeof count);
    std::copy(first, last, begin());
  }
  void clear() { block_.reset(); }

  bool empty() const { return !block_; }
  std::size_t size() const {
    std::size_t count = 0;
    if (block_) std::memcpy(&count, block_.get(), sizeof count);
    return count;
  }
  Value* data() { return block_ ? reinterpret_cast<Value*>(block_.get() + sizeof(std::size_t)) : nullptr; }
  const Value* data() const {
    return block_ ? reinterpret_cast<const Value*>(block_.get() + sizeof(std::size_t)) : nullptr;
  }
  Value* begin() { return data(); }
  Value* end() { return data() + size(); }
  const Value* begin() const { return data(); }
  const Value* end() const { return data() + size(); }
  Value& operator[](std::size_t i) { return data()[i]; }
  const Value& operator[](std::size_t i) const { return data()[i]; }

  friend bool operator==(const CompactList& a, const CompactList& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  std::unique_ptr<std::byte[]> block_;  // the count, then the values
};

}  // namespace ryosen
