#include "ryosen/mesh/source_list.h"

#include <algorithm>

#include "ryosen/mesh/value_rules.h"

namespace ryosen {

void SourceList::between(std::uint32_t to, std::span<const std::uint32_t> sources, std::span<const double> weights) {
  if (sources.size() == 1) return keep(to, sources[0]);
  entries_[to] = {static_cast<std::uint32_t>(sources_.size()), static_cast<std::uint32_t>(sources.size())};
  sources_.insert(sources_.end(), sources.begin(), sources.end());
  weights_.insert(weights_.end(), weights.begin(), weights.end());
}

AttributeColumn SourceList::derived(const AttributeColumn& before) const {
  const std::size_t words = before.words();
  AttributeColumn column = before;
  column.data.resize(entries_.size() * words);
  for (std::uint32_t i = 0; i < size(); ++i) {
    const Entry& entry = entries_[i];
    const std::span value(column.data.data() + i * words, words);
    if (!is_told(i) || entry.count == fresh_count) {
      std::copy(before.fill.begin(), before.fill.end(), value.begin());
    } else if (origin(i) != no_index) {
      std::copy_n(before.data.data() + std::size_t{entry.first} * words, words, value.begin());
    } else {
      derive_value(before, std::span(sources_).subspan(entry.first, entry.count),
                   std::span(weights_).subspan(entry.first, entry.count), Derivation::copies, value);
    }
  }
  if (before.rule == ValueRule::sum || before.rule == ValueRule::own) divide(before, column);
  return column;
}

void SourceList::divide(const AttributeColumn& before, AttributeColumn& column) const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> parts;  // source, part
  for (std::uint32_t i = 0; i < size(); ++i)
    if (entries_[i].count == part_count) parts.emplace_back(entries_[i].first, i);
  std::sort(parts.begin(), parts.end());
  const std::size_t words = before.words();
  std::vector<double> shares;
  for (std::size_t begin = 0, end = 0; begin < parts.size(); begin = end) {
    shares.clear();
    for (end = begin; end < parts.size() && parts[end].first == parts[begin].first; ++end)
      shares.push_back(shares_.empty() ? 1 : shares_[parts[end].second]);
    const std::vector<std::uint32_t> values = divide_value(before, parts[begin].first, shares);
    for (std::size_t i = begin; i < end; ++i)
      std::copy_n(values.data() + (i - begin) * words, words,
                  column.data.data() + std::size_t{parts[i].second} * words);
  }
}

}  // namespace ryosen
