// What is selected, with a stamp by which those who follow it see at once whether it may have changed.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <utility>

#include "ryosen/base/element.h"
#include "ryosen/base/enum_table.h"

namespace ryosen {

// Elements in the order in which they were selected. It is read as a vector of them; equal are two of the same
// elements.
class Selection {
 public:
  using value_type = Element;
  using const_iterator = Elements::const_iterator;

  Selection() = default;
  Selection(const Selection&) = default;
  Selection(Selection&& other) noexcept : elements_(std::exchange(other.changed(), {})), stamp_(next_stamp()) {}
  Selection& operator=(const Selection&) = default;
  Selection& operator=(Selection&& other) noexcept { return *this = std::exchange(other.changed(), {}); }
  Selection& operator=(Elements elements) {
    changed() = std::move(elements);
    return *this;
  }
  Selection& operator=(std::initializer_list<Element> elements) { return *this = Elements(elements); }

  operator const Elements&() const { return elements_; }
  const_iterator begin() const { return elements_.begin(); }
  const_iterator end() const { return elements_.end(); }
  const Element* data() const { return elements_.data(); }
  std::size_t size() const { return elements_.size(); }
  bool empty() const { return elements_.empty(); }
  const Element& operator[](std::size_t i) const { return elements_[i]; }
  const Element& back() const { return elements_.back(); }
  // How many of a kind. Cost: one pass for all kinds after each change.
  std::size_t count(Element::Kind kind) const;

  void clear() {
    if (!empty()) changed().clear();
  }
  void push_back(const Element& element) { changed().push_back(element); }
  // To be written to before the next call.
  Elements& changed();

  // Never the same for two contents, in all of the program. Never 0.
  std::uint64_t stamp() const { return stamp_; }

  friend bool operator==(const Selection& a, const Selection& b) { return a.elements_ == b.elements_; }
  friend bool operator==(const Selection& a, const Elements& b) { return a.elements_ == b; }

 private:
  static std::uint64_t next_stamp();

  Elements elements_;
  std::uint64_t stamp_ = next_stamp();
  mutable std::array<std::size_t, enum_count<Element::Kind>> counts_{};
  mutable std::uint64_t counted_ = 0;  // the stamp of which that is
};

}  // namespace ryosen
