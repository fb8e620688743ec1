// The types of attribute values: numbers and booleans, and fixed-length rows of them.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/fwd.hpp>
#include <type_traits>

namespace ryosen {

enum class Scalar : std::uint8_t {
  boolean,
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};

// Bytes of one scalar.
constexpr std::uint32_t bytes_of(Scalar scalar) {
  constexpr std::uint8_t bytes[] = {1, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return bytes[static_cast<std::size_t>(scalar)];
}
constexpr bool is_floating(Scalar scalar) { return scalar == Scalar::float32 || scalar == Scalar::float64; }

// Calls visit with a zero of the C++ type of this scalar.
template <class Visit>
auto with_scalar(Scalar scalar, const Visit& visit) {
  switch (scalar) {
    case Scalar::boolean:
      return visit(bool());
    case Scalar::int8:
      return visit(std::int8_t());
    case Scalar::uint8:
      return visit(std::uint8_t());
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
    default:
      return visit(double());
  }
}

// `count` scalars in a row, without gaps. A value fills whole 32-bit words; bytes behind its last scalar are 0.
struct ValueType {
  Scalar scalar = Scalar::uint32;
  std::uint32_t count = 1;

  constexpr std::uint32_t bytes() const { return bytes_of(scalar) * count; }
  constexpr std::uint32_t words() const { return (bytes() + 3) / 4; }
  friend constexpr bool operator==(const ValueType&, const ValueType&) = default;
};

namespace detail {

template <class T>
constexpr Scalar scalar_of() {
  if constexpr (std::same_as<T, bool>) return Scalar::boolean;
  if constexpr (std::same_as<T, float>) return Scalar::float32;
  if constexpr (std::same_as<T, double>) return Scalar::float64;
  constexpr Scalar by_size[] = {Scalar::int8, Scalar::int16, Scalar::int32, Scalar::int64};
  const std::size_t size = sizeof(T) == 1 ? 0 : sizeof(T) == 2 ? 1 : sizeof(T) == 4 ? 2 : 3;
  return static_cast<Scalar>(static_cast<unsigned>(by_size[size]) + (std::is_signed_v<T> ? 0 : 1));
}

template <class T>
struct Row {
  using Value = T;
  static constexpr std::uint32_t count = 1;
};
template <class T, std::size_t n>
struct Row<std::array<T, n>> {
  using Value = T;
  static constexpr std::uint32_t count = n;
};
template <glm::length_t n, class T, glm::qualifier q>
struct Row<glm::vec<n, T, q>> {
  using Value = T;
  static constexpr std::uint32_t count = n;
};

}  // namespace detail

// Integers, floats, doubles and booleans, and arrays and vectors of them.
template <class T>
concept AttributeValue = (std::integral<typename detail::Row<T>::Value> ||
                          std::same_as<typename detail::Row<T>::Value, float> ||
                          std::same_as<typename detail::Row<T>::Value, double>)&&std::is_trivially_copyable_v<T> &&
                         sizeof(T) == sizeof(typename detail::Row<T>::Value) * detail::Row<T>::count &&
                         (detail::Row<T>::count > 0);

// The type of a C++ value.
template <AttributeValue T>
inline constexpr ValueType value_type{detail::scalar_of<typename detail::Row<T>::Value>(), detail::Row<T>::count};

}  // namespace ryosen
