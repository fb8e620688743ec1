#include "ryosen/io/numbers.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace ryosen {
namespace {

TEST(numbers, reads_decimals_to_the_nearest_double) {
  for (const char* text : {"0", "-0", "+1.5", "1.", ".5", "1e5", "1E+5", "-2.5e-3", "0.1", "123456789.123456789",
                           "4.9e-324", "1e-320", "1.7976931348623157e308", "0.30000000000000004"}) {
    double value = 0;
    EXPECT_EQ(read_real(text, value), NumberRead::finite) << text;
    EXPECT_EQ(value, std::strtod(text, nullptr)) << text;
    EXPECT_EQ(std::signbit(value), text[0] == '-') << text;
  }
}

TEST(numbers, agrees_with_the_c_library_on_random_decimals) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    std::string text = std::to_string(random() % 1000000) + "." + std::to_string(random());
    if (i % 3 == 0) text += "e" + std::to_string(static_cast<int>(random() % 640) - 320);
    double value = 0;
    read_real(text, value);
    ASSERT_EQ(value, std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(numbers, non_finite_in_all_spellings) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const char* text : {"inf", "Infinity", "+inf", "1e999", "1.#INF", "1.#INF00", "123e400000000000000000000",
                           "1000000000e301", "1.7976931348623159e308"}) {
    double value = 0;
    EXPECT_EQ(read_real(text, value), NumberRead::non_finite) << text;
    EXPECT_EQ(value, infinity) << text;
    const std::string negative = std::string("-") + (text[0] == '+' ? text + 1 : text);
    EXPECT_EQ(read_real(negative, value), NumberRead::non_finite) << negative;
    EXPECT_EQ(value, -infinity) << negative;
  }
  for (const char* text : {"nan", "-nan", "NaN", "+NAN", "1.#IND", "-1.#IND00", "1.#QNAN", "1.#SNAN0"}) {
    double value = 0;
    EXPECT_EQ(read_real(text, value), NumberRead::non_finite) << text;
    EXPECT_TRUE(std::isnan(value)) << text;
    EXPECT_EQ(std::signbit(value), text[0] == '-') << text;
  }
}

TEST(numbers, too_small_is_zero) {
  for (const char* text : {"1e-999", "0.0000001e-400", "2e-324", "1e-400000000000000000000"}) {
    double value = 1;
    EXPECT_EQ(read_real(text, value), NumberRead::finite) << text;
    EXPECT_EQ(value, 0.0) << text;
  }
  double value = 1;
  EXPECT_EQ(read_real("-1e-999", value), NumberRead::finite);
  EXPECT_TRUE(std::signbit(value));
}

TEST(numbers, anything_else_is_unreadable) {
  for (const char* text :
       {"",       "-",   "+",   ".",  "e5",  "abc",     "1e",      "1e+",  "1,5", "0x10",        "1.5f",
        "3.1+e2", "--1", "+-1", "1 ", "1.#", "1.#INFx", "1.#IND1", "1..2", "in",  "\xef\xbc\x91"}) {
    double value = 0;
    EXPECT_EQ(read_real(text, value), NumberRead::unreadable) << text;
  }
}

TEST(numbers, integers_are_whole_tokens_and_clamp) {
  std::int64_t value = 0;
  EXPECT_TRUE(read_integer("-12", value));
  EXPECT_EQ(value, -12);
  EXPECT_TRUE(read_integer("+12", value));
  EXPECT_EQ(value, 12);
  EXPECT_TRUE(read_integer("99999999999999999999", value));
  EXPECT_EQ(value, std::numeric_limits<std::int64_t>::max());
  EXPECT_TRUE(read_integer("-99999999999999999999", value));
  EXPECT_EQ(value, std::numeric_limits<std::int64_t>::min());
  for (const char* text : {"", "+", "-", "1.0", "1x", "+-1", "a"}) EXPECT_FALSE(read_integer(text, value)) << text;
}

}  // namespace
}  // namespace ryosen
