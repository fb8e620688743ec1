#include "ryosen/mesh/value_rules.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <numeric>

#include "ryosen/mesh/attribute.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen {
namespace {

template <class T>
AttributeColumn column_of(ValueRule rule, const std::vector<T>& values, const T& fill = T{}) {
  AttributeColumn column = make_column("own", ElementKind::vertex, rule, fill);
  for (const T& value : values) {
    const auto words = attribute_words(value);
    column.data.insert(column.data.end(), words.begin(), words.end());
  }
  return column;
}

template <class T>
T derived(const AttributeColumn& column, const std::vector<std::uint32_t>& sources, const std::vector<double>& weights,
          Derivation derivation) {
  std::vector<std::uint32_t> words(column.words(), 0xdeadbeefu);
  derive_value(column, sources, weights, derivation, words);
  T value;
  std::memcpy(&value, words.data(), sizeof(T));
  return value;
}

template <class T>
std::vector<T> parts(const AttributeColumn& column, const std::vector<double>& shares) {
  const std::vector<std::uint32_t> words = divide_value(column, 0, shares);
  std::vector<T> values(shares.size());
  for (std::size_t i = 0; i < values.size(); ++i) std::memcpy(&values[i], words.data() + i * column.words(), sizeof(T));
  return values;
}

constexpr Derivation all_derivations[] = {Derivation::copies, Derivation::unites};

TEST(value_type, is_that_of_the_value_and_fills_words) {
  static_assert(value_type<bool> == ValueType{Scalar::boolean, 1});
  static_assert(value_type<std::int8_t> == ValueType{Scalar::int8, 1});
  static_assert(value_type<std::uint16_t> == ValueType{Scalar::uint16, 1});
  static_assert(value_type<long long> == ValueType{Scalar::int64, 1});
  static_assert(value_type<unsigned long> == ValueType{Scalar::uint64, 1});
  static_assert(value_type<glm::dvec3> == ValueType{Scalar::float64, 3});
  static_assert(value_type<glm::u8vec4> == ValueType{Scalar::uint8, 4});
  static_assert(value_type<std::array<float, 5>> == ValueType{Scalar::float32, 5});
  static_assert(!AttributeValue<std::vector<float>> && !AttributeValue<std::string> && !AttributeValue<void*>);
  EXPECT_EQ((ValueType{Scalar::uint8, 5}.words()), 2u);
  EXPECT_EQ((ValueType{Scalar::boolean, 1}.words()), 1u);
  EXPECT_EQ(value_type<glm::dvec3>.words(), 6u);
}

TEST(value_rules, blend_of_floats_is_the_weighted_mean_in_every_event) {
  const AttributeColumn column = column_of<glm::dvec3>(ValueRule::blend, {{0, 0, 1}, {4, 0, 1}, {0, 8, 1}});
  const AttributeColumn single = column_of<float>(ValueRule::blend, {1, 3, 8});
  for (const Derivation event : all_derivations) {
    EXPECT_EQ(derived<glm::dvec3>(column, {0, 1, 2}, {0.5, 0.25, 0.25}, event), glm::dvec3(1, 2, 1));
    EXPECT_EQ(derived<float>(single, {1, 2}, {0.75, 0.25}, event), 4.25f);
  }
}

TEST(value_rules, a_mean_of_equal_values_is_equal_and_a_source_without_weight_may_be_infinite) {
  const double odd = 0.1 + 0.2, infinite = std::numeric_limits<double>::infinity();
  const AttributeColumn column = column_of<double>(ValueRule::blend, {infinite, odd, odd, odd});
  EXPECT_EQ(derived<double>(column, {0, 1, 2, 3}, {0, 1 / 3.0, 1 / 3.0, 1 / 3.0}, Derivation::copies), odd);
  EXPECT_EQ(derived<double>(column, {1, 0}, {1, 0}, Derivation::unites), odd);
}

TEST(value_rules, a_mean_of_equal_zeros_infinities_and_nans_is_that) {
  const double infinite = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {-0.0, 0.0, infinite, -infinite, none}) {
    const AttributeColumn column = column_of<double>(ValueRule::blend, {value, value, value});
    const auto mean = derived<double>(column, {0, 1, 2}, {0.25, 0.25, 0.5}, Derivation::copies);
    EXPECT_EQ(std::signbit(mean), std::signbit(value));
    EXPECT_TRUE(mean == value || (std::isnan(mean) && std::isnan(value))) << value;
  }
}

TEST(value_rules, a_source_without_weight_counts_only_where_values_are_united) {
  EXPECT_EQ(derived<int>(column_of<int>(ValueRule::greatest, {3, 9}), {0, 1}, {1, 0}, Derivation::copies), 3);
  EXPECT_EQ(derived<int>(column_of<int>(ValueRule::greatest, {3, 9}), {0, 1}, {1, 0}, Derivation::unites), 9);
  EXPECT_EQ(derived<int>(column_of<int>(ValueRule::first, {3, 9}), {0, 1}, {0, 1}, Derivation::copies), 9);
}

TEST(value_rules, blend_of_integers_and_booleans_is_that_of_the_first) {
  EXPECT_EQ(
      derived<std::int64_t>(column_of<std::int64_t>(ValueRule::blend, {7, 90}), {0, 1}, {0.1, 0.9}, Derivation::copies),
      7);
  EXPECT_TRUE(derived<bool>(column_of<bool>(ValueRule::blend, {false, true}), {1, 0}, {0.1, 0.9}, Derivation::unites));
  // Eight words, as four doubles have.
  const std::array<std::uint32_t, 8> a{1, 2, 3, 4, 5, 6, 7, 8}, b{9, 9, 9, 9, 9, 9, 9, 9};
  EXPECT_EQ((derived<std::array<std::uint32_t, 8>>(column_of<std::array<std::uint32_t, 8>>(ValueRule::blend, {a, b}),
                                                   {0, 1}, {0.5, 0.5}, Derivation::copies)),
            a);
}

TEST(value_rules, greatest_goes_number_by_number) {
  using Pair = std::array<std::int16_t, 2>;
  const AttributeColumn column = column_of<Pair>(ValueRule::greatest, {{-5, 4}, {-7, 9}});
  for (const Derivation event : all_derivations)
    EXPECT_EQ(derived<Pair>(column, {0, 1}, {0.5, 0.5}, event), (Pair{-5, 9}));
}

TEST(value_rules, sum_adds_when_united_is_copied_from_one_and_takes_nothing_between_several) {
  const AttributeColumn column = column_of<double>(ValueRule::sum, {1, 2, 4}, -3);
  EXPECT_EQ(derived<double>(column, {0, 1, 2}, {1, 0, 0}, Derivation::unites), 7);
  EXPECT_EQ(derived<double>(column, {2}, {1}, Derivation::copies), 4);
  EXPECT_EQ(derived<double>(column, {0, 1}, {0.5, 0.5}, Derivation::copies), -3);
  EXPECT_EQ(derived<double>(column, {0, 1, 2}, {0, 1, 0}, Derivation::copies), -3) << "at one of several";
}

TEST(value_rules, sums_of_integers_stay_within_their_type) {
  EXPECT_EQ(derived<std::uint8_t>(column_of<std::uint8_t>(ValueRule::sum, {200, 100}), {0, 1}, {0.5, 0.5},
                                  Derivation::unites),
            255);
  EXPECT_EQ(derived<std::int8_t>(column_of<std::int8_t>(ValueRule::sum, {-100, -100}), {0, 1}, {0.5, 0.5},
                                 Derivation::unites),
            -128);
  EXPECT_TRUE(derived<bool>(column_of<bool>(ValueRule::sum, {true, true}), {0, 1}, {0.5, 0.5}, Derivation::unites));
}

TEST(value_rules, parts_of_a_sum_go_by_shares_and_whole_numbers_by_the_largest_remainder) {
  EXPECT_EQ(parts<double>(column_of<double>(ValueRule::sum, {8}), {1, 3}), (std::vector<double>{2, 6}));
  EXPECT_EQ(parts<int>(column_of<int>(ValueRule::sum, {10}), {1, 1, 1}), (std::vector<int>{4, 3, 3}));
  EXPECT_EQ(parts<int>(column_of<int>(ValueRule::sum, {-10}), {0.2, 0.55, 0.25}), (std::vector<int>{-2, -6, -2}));
  EXPECT_EQ(parts<int>(column_of<int>(ValueRule::blend, {10}), {1, 1}), (std::vector<int>{10, 10}));
  EXPECT_EQ(parts<int>(column_of<int>(ValueRule::sum, {10}), {0, 0}), (std::vector<int>{5, 5})) << "no shares";
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(parts<double>(column_of<double>(ValueRule::sum, {infinite}), {1, 0}), (std::vector<double>{infinite, 0}));
  using Bits = std::array<bool, 5>;
  const AttributeColumn bits = column_of<Bits>(ValueRule::sum, {{true, false, true, true, false}});
  EXPECT_EQ(parts<Bits>(bits, {1, 3, 1}), (std::vector<Bits>{{}, {true, false, true, true, false}, {}}));
}

template <class T>
void expect_parts_add_up(Dice& dice, T number) {
  std::vector<double> shares(1 + static_cast<std::size_t>(dice.below(9)));
  for (double& share : shares) share = dice.unit() + 1e-9;
  const long double total = std::accumulate(shares.begin(), shares.end(), 0.0L);
  const std::vector<T> values = parts<T>(column_of<T>(ValueRule::sum, {number}), shares);
  T sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum = static_cast<T>(sum + values[i]);
    const long double exact = static_cast<long double>(number) * (shares[i] / total);
    EXPECT_LE(std::abs(static_cast<long double>(values[i]) - exact), 1 + std::abs(exact) * 1e-18L);
  }
  EXPECT_EQ(sum, number);
}

TEST(value_rules, parts_of_whole_numbers_add_up_to_them) {
  Dice dice(48);
  for (int i = 0; i < 2000; ++i) {
    expect_parts_add_up<std::int32_t>(dice, static_cast<std::int32_t>(dice.below(200001)) - 100000);
    expect_parts_add_up<std::uint8_t>(dice, static_cast<std::uint8_t>(dice.below(256)));
    expect_parts_add_up<std::int64_t>(dice, std::numeric_limits<std::int64_t>::max() - dice.below(1000));
    expect_parts_add_up<std::uint64_t>(
        dice, std::numeric_limits<std::uint64_t>::max() - static_cast<std::uint64_t>(dice.below(1000)));
    expect_parts_add_up<std::int64_t>(dice, std::numeric_limits<std::int64_t>::min());
  }
}

// The number farthest from 0; a part of it by its share, rounded up.
void farthest_from_zero(const ValueSources& sources, std::uint32_t* value) {
  double found = 0;
  for (std::size_t i = 0; i < sources.values.size(); ++i)
    if (const auto number = sources.value<double>(i); std::abs(number) > std::abs(found)) found = number;
  if (sources.derivation == Derivation::divides) found = std::ceil(found * sources.weights[0]);
  std::memcpy(value, &found, sizeof found);
}

TEST(value_rules, an_own_rule_makes_all_but_copies_of_one) {
  AttributeColumn column = column_of<double>(ValueRule::own, {3, -9, 5}, 0);
  column.own_rule = farthest_from_zero;
  EXPECT_EQ(derived<double>(column, {0, 1, 2}, {0.5, 0.25, 0.25}, Derivation::copies), -9);
  EXPECT_EQ(derived<double>(column, {0, 1, 2}, {1, 0, 0}, Derivation::unites), -9);
  EXPECT_EQ(derived<double>(column, {0, 1, 2}, {1, 0, 0}, Derivation::copies), 3);
  EXPECT_EQ(derived<double>(column, {0, 1, 2}, {0.5, 0, 0.5}, Derivation::copies), 5) << "one has no weight";
  column.data = column_of<double>(ValueRule::own, {2.5}, 0).data;
  EXPECT_EQ(parts<double>(column, {3}), (std::vector<double>{2.5})) << "a whole is not divided";
  column.data = column_of<double>(ValueRule::own, {3}, 0).data;
  EXPECT_EQ(parts<double>(column, {1, 1, 3}), (std::vector<double>{1, 1, 2}));
  EXPECT_EQ(parts<double>(column, {0, 0}), (std::vector<double>{2, 2}));
}

}  // namespace
}  // namespace ryosen
