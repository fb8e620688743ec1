#include "ryosen/mesh/value_rules.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <optional>
#include <type_traits>

namespace ryosen {

namespace {

template <class T>
T scalar_at(const std::uint32_t* words, std::uint32_t i) {
  T value;
  std::memcpy(&value, reinterpret_cast<const std::byte*>(words) + i * sizeof(T), sizeof(T));
  return value;
}

// Any byte but 0 is true.
template <>
bool scalar_at<bool>(const std::uint32_t* words, std::uint32_t i) {
  return scalar_at<std::uint8_t>(words, i) != 0;
}

template <class T>
void put_scalar(std::uint32_t* words, std::uint32_t i, T value) {
  std::memcpy(reinterpret_cast<std::byte*>(words) + i * sizeof(T), &value, sizeof(T));
}

struct Sources {
  const AttributeColumn& column;
  std::span<const std::uint32_t> at;
  std::span<const double> weights;
  Derivation derivation;

  // Where values are copied, a source without weight counts nothing.
  bool counts(std::size_t i) const { return derivation == Derivation::unites || weights[i] != 0; }
  std::size_t first() const {
    std::size_t i = 0;
    while (!counts(i)) ++i;
    return i;
  }
  bool is_one() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < at.size(); ++i) count += counts(i);
    return count == 1;
  }
  const std::uint32_t* words(std::size_t i) const { return column.data.data() + std::size_t{at[i]} * column.words(); }
  template <class T>
  T number(std::size_t source, std::uint32_t i) const {
    return scalar_at<T>(words(source), i);
  }
};

// Starts at the first source with a weight, so that a mean of equal numbers is equal to them.
template <class T>
T mean(const Sources& sources, std::uint32_t i) {
  std::size_t first = 0;
  while (sources.weights[first] == 0) ++first;
  const auto start = static_cast<double>(sources.number<T>(first, i));
  double sum = start;
  for (std::size_t s = first + 1; s < sources.at.size(); ++s)
    if (sources.weights[s] != 0)  // one without a weight need not exist
      if (const auto number = static_cast<double>(sources.number<T>(s, i)); number != start)
        sum += sources.weights[s] * (number - start);
  return static_cast<T>(sum);
}

template <class T>
T greatest(const Sources& sources, std::uint32_t i) {
  std::optional<T> found;
  for (std::size_t s = 0; s < sources.at.size(); ++s)
    if (sources.counts(s)) found = std::max(found.value_or(sources.number<T>(s, i)), sources.number<T>(s, i));
  return *found;
}

// Integers stay within their type.
template <class T>
T sum(const Sources& sources, std::uint32_t i) {
  T found{};
  for (std::size_t s = 0; s < sources.at.size(); ++s) {
    const T number = sources.number<T>(s, i);
    if constexpr (std::is_floating_point_v<T>) {
      found += number;
    } else {
      constexpr T lowest = std::numeric_limits<T>::min(), highest = std::numeric_limits<T>::max();
      if (number > 0)
        found = found > highest - number ? highest : static_cast<T>(found + number);
      else
        found = found < lowest - number ? lowest : static_cast<T>(found + number);
    }
  }
  return found;
}

// The parts of a whole number in proportion to the shares; their sum is the number.
template <class T>
std::vector<T> whole_parts(T number, std::span<const double> shares) {
  const long double total = std::accumulate(shares.begin(), shares.end(), 0.0L);
  std::vector<T> parts;
  std::vector<double> remainders;
  T rest = number;
  for (const double share : shares) {
    const long double exact = static_cast<long double>(number) * (share / total);
    T part = static_cast<T>(std::trunc(exact));
    // A rounded share may be a little too much of a large number.
    if (number > T() ? part > rest : part < rest) part = rest;
    rest = static_cast<T>(rest - part);
    parts.push_back(part);
    remainders.push_back(static_cast<double>(std::abs(exact - static_cast<long double>(part))));
  }
  std::vector<std::size_t> order(shares.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return remainders[a] > remainders[b]; });
  const int step = number > T() ? 1 : -1;
  for (std::size_t k = 0; rest != T(); k = (k + 1) % order.size()) {
    parts[order[k]] = static_cast<T>(parts[order[k]] + static_cast<T>(step));
    rest = static_cast<T>(rest - static_cast<T>(step));
  }
  return parts;
}

void make_by_own_rule(const Sources& sources, std::span<std::uint32_t> value) {
  std::vector<const std::uint32_t*> values;
  std::vector<double> weights;
  for (std::size_t i = 0; i < sources.at.size(); ++i) {
    if (sources.derivation == Derivation::copies && !sources.counts(i)) continue;
    values.push_back(sources.words(i));
    weights.push_back(sources.weights[i]);
  }
  std::fill(value.begin(), value.end(), 0u);
  sources.column.own_rule({sources.derivation, values, weights}, value.data());
}

void copy_first(const Sources& sources, std::span<std::uint32_t> value) {
  std::copy_n(sources.words(sources.first()), value.size(), value.begin());
}

}  // namespace

void derive_value(const AttributeColumn& column, std::span<const std::uint32_t> at, std::span<const double> weights,
                  Derivation derivation, std::span<std::uint32_t> value) {
  assert(std::any_of(weights.begin(), weights.end(), [](double weight) { return weight != 0; }));
  assert(derivation != Derivation::divides);
  const Sources sources{column, at, weights, derivation};
  if (column.rule == ValueRule::own && !(derivation == Derivation::copies && at.size() == 1))
    return make_by_own_rule(sources, value);
  const bool has_mean = column.rule == ValueRule::blend && is_floating(column.type.scalar);
  if (column.rule == ValueRule::sum && derivation == Derivation::copies && at.size() > 1) {
    std::copy(column.fill.begin(), column.fill.end(), value.begin());
    return;
  }
  if (sources.is_one() || column.rule == ValueRule::first || column.rule == ValueRule::own ||
      (column.rule == ValueRule::blend && !has_mean))
    return copy_first(sources, value);
  std::fill(value.begin(), value.end(), 0u);
  with_scalar(column.type.scalar, [&](auto zero) {
    using T = decltype(zero);
    for (std::uint32_t i = 0; i < column.type.count; ++i)
      put_scalar<T>(value.data(), i,
                    has_mean                             ? mean<T>(sources, i)
                    : column.rule == ValueRule::greatest ? greatest<T>(sources, i)
                                                         : sum<T>(sources, i));
  });
}

std::vector<std::uint32_t> divide_value(const AttributeColumn& column, std::uint32_t source,
                                        std::span<const double> shares) {
  const std::size_t words = column.words();
  const std::span<const std::uint32_t> whole(column.data.data() + std::size_t{source} * words, words);
  std::vector<std::uint32_t> values;
  for (std::size_t part = 0; part < shares.size(); ++part) values.insert(values.end(), whole.begin(), whole.end());
  if ((column.rule != ValueRule::sum && column.rule != ValueRule::own) || shares.size() < 2) return values;
  const std::vector<double> equal(shares.size(), 1);
  double total = std::accumulate(shares.begin(), shares.end(), 0.0);
  if (!(total > 0 && std::isfinite(total))) {
    shares = equal;
    total = static_cast<double>(equal.size());
  }
  if (column.rule == ValueRule::own) {
    for (std::size_t part = 0; part < shares.size(); ++part) {
      const double share = shares[part] / total;
      make_by_own_rule({column, {&source, 1}, {&share, 1}, Derivation::divides},
                       std::span(values).subspan(part * words, words));
    }
    return values;
  }
  with_scalar(column.type.scalar, [&](auto zero) {
    using T = decltype(zero);
    for (std::uint32_t i = 0; i < column.type.count; ++i) {
      const T number = scalar_at<T>(whole.data(), i);
      std::vector<T> parts;
      if constexpr (std::is_integral_v<T>)
        parts = whole_parts(number, shares);
      else
        for (const double share : shares) parts.push_back(share == 0 ? T() : static_cast<T>(number * (share / total)));
      for (std::size_t part = 0; part < parts.size(); ++part)
        put_scalar<T>(values.data() + part * words, i, parts[part]);
    }
  });
  return values;
}

}  // namespace ryosen
