// The elements that the elements of one kind come from, where an algorithm builds all columns anew; what Edit::derive,
// divide, fresh and drop tell of single elements.
//
//   SourceList edges(8);             of eight new edges
//   edges.keep(0, 3);                0 is the old edge 3
//   edges.part(1, 4, 1); edges.part(2, 4, 1);   4 is divided into two equal parts
//   edges.between(5, sources, weights);         5 lies between several
//   edges.fresh(6);                             6 is new
//   edges.drop(2);                              nothing comes of the old edge 2
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ryosen/mesh/columns.h"

namespace ryosen {

class SourceList {
 public:
  SourceList() = default;
  // So many elements without sources.
  explicit SourceList(std::size_t elements) : entries_(elements) {}
  // Elements that keep their numbers, and further ones without sources.
  static SourceList kept(std::size_t elements, std::size_t further = 0) {
    SourceList list(elements + further);
    for (std::uint32_t i = 0; i < elements; ++i) list.keep(i, i);
    return list;
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(entries_.size()); }
  bool empty() const { return entries_.empty(); }

  // An element is one of before.
  void keep(std::uint32_t to, std::uint32_t source) { entries_[to] = {source, 1}; }
  // It is one of the parts of one, by its share among them.
  void part(std::uint32_t to, std::uint32_t source, double share) {
    entries_[to] = {source, part_count};
    if (share == 1 && shares_.empty()) return;
    shares_.resize(entries_.size(), 1);
    shares_[to] = share;
  }
  // It is new.
  void fresh(std::uint32_t to) { entries_[to] = {no_index, fresh_count}; }
  // One of before, of which nothing comes, is removed with its values.
  void drop(std::uint32_t source) { dropped_.push_back(source); }
  // It lies between several, by weights that add up to 1.
  void between(std::uint32_t to, std::span<const std::uint32_t> sources, std::span<const double> weights);

  // Whether anything was said of it.
  bool is_told(std::uint32_t element) const { return entries_[element].count != 0; }
  // The element that it is or is a part of; no_index where there is none or several.
  std::uint32_t origin(std::uint32_t element) const {
    const Entry& entry = entries_[element];
    return entry.count == 1 || entry.count == part_count ? entry.first : no_index;
  }
  // Calls visit(element, origin) for those that have one, in ascending order.
  template <class Visit>
  void for_each_origin(const Visit& visit) const {
    for (std::uint32_t i = 0; i < size(); ++i)
      if (const std::uint32_t own = origin(i); own != no_index) visit(i, own);
  }

  // Calls visit(source) for those that were dropped.
  template <class Visit>
  void for_each_dropped(const Visit& visit) const {
    for (const std::uint32_t source : dropped_) visit(source);
  }

  // The attribute of these elements, whose rule makes the values from those before (value_rules.h). O(values), and a
  // sort of the parts where it divides.
  AttributeColumn derived(const AttributeColumn& before) const;

 private:
  static constexpr std::uint32_t part_count = no_index, fresh_count = no_index - 1;
  // The only source, or the place of several in sources_.
  struct Entry {
    std::uint32_t first = no_index;
    std::uint32_t count = 0;
  };

  void divide(const AttributeColumn& before, AttributeColumn& column) const;

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> sources_;
  std::vector<double> weights_;
  std::vector<std::uint32_t> dropped_;
  std::vector<double> shares_;  // by element, of parts; empty where all are equal
};

}  // namespace ryosen
