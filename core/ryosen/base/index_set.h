// Sets of slot numbers, as bit sets with ascending iteration, and of elements.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ryosen/base/element.h"

namespace ryosen {

// A set of slot numbers. Two levels: a summary bit per nonzero word, so that sparse sets are fast to iterate. insert,
// erase and contains are O(1) (insert may grow the set), iteration costs the members plus one step per 4096 slots,
// nth() only these steps.
class IndexSet {
 public:
  bool contains(std::uint32_t i) const {
    const std::size_t word = i / 64;
    return word < words_.size() && (words_[word] >> (i % 64) & 1u) != 0;
  }
  std::uint32_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  // Returns whether the set changed.
  bool insert(std::uint32_t i) {
    const std::size_t word = i / 64;
    if (word >= words_.size()) grow(word + 1);
    const std::uint64_t bit = std::uint64_t{1} << (i % 64);
    if ((words_[word] & bit) != 0) return false;
    words_[word] |= bit;
    summary_[word / 64] |= std::uint64_t{1} << (word % 64);
    ++members_[word / 64];
    ++size_;
    return true;
  }
  bool erase(std::uint32_t i) {
    if (!contains(i)) return false;
    const std::size_t word = i / 64;
    words_[word] &= ~(std::uint64_t{1} << (i % 64));
    if (words_[word] == 0) summary_[word / 64] &= ~(std::uint64_t{1} << (word % 64));
    --members_[word / 64];
    --size_;
    return true;
  }
  void clear() { *this = IndexSet(); }

  // In ascending order. The set must not change during the call.
  template <class Visit>
  void for_each(Visit visit) const {
    for_each_from(0, visit);
  }
  // The members >= first.
  template <class Visit>
  void for_each_from(std::uint32_t first, Visit visit) const {
    for_each_in(first, static_cast<std::uint32_t>(64 * words_.size()), visit);
  }
  // The members in [first, end).
  template <class Visit>
  void for_each_in(std::uint32_t first, std::uint32_t end, Visit visit) const {
    for (std::size_t s = first / 4096; s < summary_.size() && s * 4096 < end; ++s)
      for (std::uint64_t words = summary_[s]; words != 0; words &= words - 1) {
        const std::size_t word = s * 64 + static_cast<std::size_t>(std::countr_zero(words));
        for (std::uint64_t bits = words_[word]; bits != 0; bits &= bits - 1) {
          const auto i = static_cast<std::uint32_t>(word * 64 + static_cast<std::size_t>(std::countr_zero(bits)));
          if (i >= first && i < end) visit(i);
        }
      }
  }
  // The n-th member in ascending order, from 0; n < size().
  std::uint32_t nth(std::uint32_t n) const {
    std::size_t s = 0;
    while (n >= members_[s]) n -= members_[s++];
    std::size_t word = 64 * s;
    for (; n >= static_cast<std::uint32_t>(std::popcount(words_[word])); ++word)
      n -= static_cast<std::uint32_t>(std::popcount(words_[word]));
    std::uint64_t bits = words_[word];
    for (; n > 0; --n) bits &= bits - 1;
    return static_cast<std::uint32_t>(64 * word + static_cast<std::size_t>(std::countr_zero(bits)));
  }
  std::vector<std::uint32_t> to_vector() const { return members_from(0); }
  // Those that are not smaller than first.
  std::vector<std::uint32_t> members_from(std::uint32_t first) const {
    std::vector<std::uint32_t> members;
    if (first == 0) members.reserve(size_);
    for_each_from(first, [&](std::uint32_t i) { members.push_back(i); });
    return members;
  }

  friend bool operator==(const IndexSet& a, const IndexSet& b) {
    return a.size_ == b.size_ && a.to_vector() == b.to_vector();
  }

 private:
  void grow(std::size_t words) {
    words_.resize(words, 0);
    summary_.resize((words + 63) / 64, 0);
    members_.resize(summary_.size(), 0);
  }

  std::vector<std::uint64_t> words_;
  std::vector<std::uint64_t> summary_;  // one bit per word
  std::vector<std::uint32_t> members_;  // per summary word: number of members it covers
  std::uint32_t size_ = 0;
};

// A set of elements of all kinds. Costs of IndexSet: memory for the slots up to the highest member, a bit each.
class ElementSet {
 public:
  ElementSet() = default;
  explicit ElementSet(std::span<const Element> elements) {
    for (const Element& e : elements) insert(e);
  }

  // Both return whether the set changed.
  bool insert(Element e) { return of(e.kind).insert(e.index); }
  bool erase(Element e) { return of(e.kind).erase(e.index); }
  bool contains(Element e) const { return sets_[static_cast<std::size_t>(e.kind)].contains(e.index); }

 private:
  IndexSet& of(Element::Kind kind) { return sets_[static_cast<std::size_t>(kind)]; }

  std::array<IndexSet, 4> sets_;
};

}  // namespace ryosen
