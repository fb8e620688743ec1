#include "ryosen/mesh/value_rules.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <type_traits>

namespace ryosen {

namespace {

template <class T>
T scalar_at(const std::uint32_t* words, std::uint32_t i) {
  T value;
  std::memcpy(&value, reinterpret_cast<const std::byte*>(words) + i * sizeof(T), sizeof(T));
  return value;
}

template <class T>
void put_scalar(std::uint32_t* words, std::uint32_t i, T value) {
  std::memcpy(reinterpret_cast<std::byte*>(words) + i * sizeof(T), &value, sizeof(T));
}

// Calls visit with a 0 of the C++ type.
template <class Visit>
void visit_scalar(Scalar scalar, const Visit& visit) {
  switch (scalar) {
    case Scalar::boolean:
      return visit(bool());
    case Scalar::uint8:
      return visit(std::uint8_t());
    case Scalar::int8:
      return visit(std::int8_t());
    case Scalar::int16:
      return visit(std::int16_t());
    case Scalar::uint16:
      return visit(std::uint16_t());
    case Scalar::int32:
      return visit(std::int32_t());
    case Scalar::uint32:
      return visit(std::uint32_t());
    case Scalar::int64:
      return visit(std::int64_t());
    case Scalar::uint64:
      return visit(std::uint64_t());
    case Scalar::float32:
      return visit(float());
    case Scalar::float64:
      return visit(double());
  }
}

struct Sources {
  const AttributeColumn& column;
  std::span<const std::uint32_t> at;
  std::span<const double> weights;

  const std::uint32_t* words(std::size_t i) const { return column.data.data() + std::size_t{at[i]} * column.words(); }
  template <class T>
  T number(std::size_t source, std::uint32_t i) const {
    return scalar_at<T>(words(source), i);
  }
};

// From one that has a weight on, so that equal numbers stay as they are.
template <class T>
T mean(const Sources& sources, std::uint32_t i) {
  std::size_t first = 0;
  while (sources.weights[first] == 0) ++first;
  const auto start = static_cast<double>(sources.number<T>(first, i));
  double sum = start;
  for (std::size_t s = first + 1; s < sources.at.size(); ++s)
    if (sources.weights[s] != 0) sum += sources.weights[s] * (static_cast<double>(sources.number<T>(s, i)) - start);
  return static_cast<T>(sum);
}

template <class T>
T greatest(const Sources& sources, std::uint32_t i) {
  T found = sources.number<T>(0, i);
  for (std::size_t s = 1; s < sources.at.size(); ++s) found = std::max(found, sources.number<T>(s, i));
  return found;
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

void copy_first(const Sources& sources, std::span<std::uint32_t> value) {
  std::copy_n(sources.words(0), value.size(), value.begin());
}

}  // namespace

void derive_value(const AttributeColumn& column, std::span<const std::uint32_t> at, std::span<const double> weights,
                  Derivation derivation, std::span<std::uint32_t> value) {
  const Sources sources{column, at, weights};
  const bool is_one = at.size() == 1;
  switch (column.rule) {
    case ValueRule::first:
      return copy_first(sources, value);
    case ValueRule::blend:
      if (is_one || !is_floating(column.type.scalar)) return copy_first(sources, value);
      break;
    case ValueRule::greatest:
      if (is_one) return copy_first(sources, value);
      break;
    case ValueRule::sum:
      if (is_one && derivation != Derivation::divides) return copy_first(sources, value);
      if (derivation == Derivation::copies) {
        std::copy(column.fill.begin(), column.fill.end(), value.begin());
        return;
      }
      break;
  }
  std::fill(value.begin(), value.end(), 0u);
  visit_scalar(column.type.scalar, [&](auto zero) {
    using T = decltype(zero);
    for (std::uint32_t i = 0; i < column.type.count; ++i) {
      T number{};
      if (column.rule == ValueRule::blend) {
        number = mean<T>(sources, i);
      } else if (column.rule == ValueRule::greatest) {
        number = greatest<T>(sources, i);
      } else if (derivation == Derivation::unites) {
        number = sum<T>(sources, i);
      } else {
        double parts = 0;
        for (std::size_t s = 0; s < at.size(); ++s) parts += weights[s] * static_cast<double>(sources.number<T>(s, i));
        number = static_cast<T>(std::is_integral_v<T> ? std::nearbyint(parts) : parts);
      }
      put_scalar(value.data(), i, number);
    }
  });
}

std::vector<std::uint32_t> divide_value(const AttributeColumn& column, std::uint32_t source,
                                        std::span<const double> shares) {
  const std::size_t words = column.words();
  const std::span<const std::uint32_t> whole(column.data.data() + std::size_t{source} * words, words);
  std::vector<std::uint32_t> values;
  for (std::size_t part = 0; part < shares.size(); ++part) values.insert(values.end(), whole.begin(), whole.end());
  if (column.rule != ValueRule::sum) return values;
  const std::vector<double> equal(shares.size(), 1);
  double total = std::accumulate(shares.begin(), shares.end(), 0.0);
  if (!(total > 0 && std::isfinite(total))) {
    shares = equal;
    total = static_cast<double>(equal.size());
  }
  visit_scalar(column.type.scalar, [&](auto zero) {
    using T = decltype(zero);
    for (std::uint32_t i = 0; i < column.type.count; ++i) {
      const T number = scalar_at<T>(whole.data(), i);
      std::vector<T> parts;
      if constexpr (std::is_integral_v<T>)
        parts = whole_parts(number, shares);
      else
        for (const double share : shares) parts.push_back(static_cast<T>(number * (share / total)));
      for (std::size_t part = 0; part < parts.size(); ++part) put_scalar(values.data() + part * words, i, parts[part]);
    }
  });
  return values;
}

}  // namespace ryosen
