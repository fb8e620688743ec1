#include "ryosen/mesh/attribute_text.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <iterator>

#include "ryosen/base/enum_table.h"

namespace ryosen {
namespace {

struct ScalarRow {
  Scalar scalar;
  std::string_view name, other_name;
};
constexpr ScalarRow scalars[] = {
    {Scalar::boolean, "bool", "boolean"},    {Scalar::int8, "char", "int8"},
    {Scalar::uint8, "uchar", "uint8"},       {Scalar::int16, "short", "int16"},
    {Scalar::uint16, "ushort", "uint16"},    {Scalar::int32, "int", "int32"},
    {Scalar::uint32, "uint", "uint32"},      {Scalar::int64, "int64", "longlong"},
    {Scalar::uint64, "uint64", "ulonglong"}, {Scalar::float32, "float", "float32"},
    {Scalar::float64, "double", "float64"},
};
static_assert(rows_are_in_order(scalars, &ScalarRow::scalar));

struct RuleRow {
  ValueRule rule;
  std::string_view name;
};
constexpr RuleRow rules[] = {{ValueRule::blend, "blend"},
                             {ValueRule::first, "first"},
                             {ValueRule::greatest, "greatest"},
                             {ValueRule::sum, "sum"},
                             {ValueRule::own, "own"}};
static_assert(rows_are_in_order(rules, &RuleRow::rule));

struct ElementRow {
  ElementKind element;
  std::string_view name;
};
constexpr ElementRow elements[] = {{ElementKind::vertex, "vertex"},
                                   {ElementKind::edge, "edge"},
                                   {ElementKind::corner, "corner"},
                                   {ElementKind::face, "face"},
                                   {ElementKind::pool, "pool"}};
static_assert(rows_are_in_order(elements, &ElementRow::element));

// "float" or "floatx3".
std::optional<ValueType> find_type(std::string_view word) {
  if (const auto scalar = find_scalar(word)) return ValueType{*scalar, 1};
  const std::size_t cross = word.rfind('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const auto scalar = find_scalar(word.substr(0, cross));
  ValueType type;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data() + cross + 1, end, type.count);
  if (!scalar || error != std::errc() || stop != end || type.count == 0 || type.count > most_numbers_in_a_value)
    return std::nullopt;
  type.scalar = *scalar;
  return type;
}

std::optional<ValueRule> find_rule(std::string_view word) {
  for (const RuleRow& row : rules)
    if (row.name == word && row.rule != ValueRule::own) return row.rule;
  return std::nullopt;
}

bool read_number(std::string_view word, bool& number) {
  number = word == "true" || word == "1";
  return number || word == "false" || word == "0";
}

template <class T>
bool read_number(std::string_view word, T& number) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  return error == std::errc() && stop == end;
}

Text no_number_of(Scalar scalar) {
  const std::string name(name_of(scalar));
  if (scalar == Scalar::boolean) return {" is neither true nor false", " は true でも false でもありません"};
  return {" is not a number of the type " + name, " は型 " + name + " の数ではありません"};
}

Text wrong_count(ValueType type, std::size_t given) {
  const std::string count = std::to_string(type.count), found = std::to_string(given), name = name_of(type);
  return {" is the last of " + found + (given == 1 ? " number" : " numbers") + "; the type " + name + " needs " + count,
          " までの数は " + found + " 個ですが、型 " + name + " の値は " + count + " 個です"};
}

}  // namespace

std::optional<Scalar> find_scalar(std::string_view word) {
  for (const ScalarRow& row : scalars)
    if (word == row.name || word == row.other_name) return row.scalar;
  return std::nullopt;
}

std::string_view name_of(Scalar scalar) { return scalars[static_cast<std::size_t>(scalar)].name; }

std::string name_of(ValueType type) {
  std::string name(name_of(type.scalar));
  if (type.count != 1) name += "x" + std::to_string(type.count);
  return name;
}

std::string_view name_of(ValueRule rule) { return rules[static_cast<std::size_t>(rule)].name; }
std::string_view name_of(ElementKind element) { return elements[static_cast<std::size_t>(element)].name; }

std::optional<ElementKind> element_of_attribute(std::string_view name) {
  const auto is_blank_or_control = [](char c) { return (c >= 0 && c <= ' ') || c == 0x7f; };
  if (std::any_of(name.begin(), name.end(), is_blank_or_control)) return std::nullopt;
  for (const ElementRow& row : elements)
    if (row.element != ElementKind::pool && name.size() > row.name.size() + 1 && name.starts_with(row.name) &&
        name[row.name.size()] == '.')
      return row.element;
  return std::nullopt;
}

std::string_view short_name(const AttributeColumn& column) {
  return std::string_view(column.name).substr(column.name.find('.') + 1);
}

ReadAttribute read_attribute(std::span<const std::string_view> words) {
  ReadAttribute read;
  const auto fault = [&](std::string_view word, Text rest) {
    read.fault = WordFault{word, std::move(rest)};
    return read;
  };
  const std::string_view name = words.empty() ? "" : words[0];
  const auto element = element_of_attribute(name);
  if (!element)
    return fault(name, {" is not an attribute name; write vertex.NAME, edge.NAME, corner.NAME or face.NAME",
                        " は属性の名前ではありません(vertex.NAME、edge.NAME、corner.NAME、face.NAME と書きます)"});
  const std::string_view type_word = words.size() < 2 ? "" : words[1];
  const auto type = find_type(type_word);
  if (!type)
    return fault(type_word, {" is not a type; write float, int, bool or doublex3, for example",
                             " は値の型ではありません(float、int、bool、doublex3 など)"});
  const std::string_view rule_word = words.size() < 3 ? name_of(usual_rule(*type)) : words[2];
  const auto rule = find_rule(rule_word);
  if (!rule)
    return fault(rule_word, {" is not a rule; write blend, first, greatest or sum",
                             " は規則(blend、first、greatest、sum)ではありません"});
  read.column.name = name;
  read.column.element = *element;
  read.column.type = *type;
  read.column.rule = *rule;
  read.column.fill.assign(type->words(), 0);
  if (words.size() > 3) read.fault = read_value(*type, words.subspan(3), read.column.fill);
  return read;
}

std::string words_of(const AttributeColumn& column) {
  const ValueRule rule = column.rule == ValueRule::own ? usual_rule(column.type) : column.rule;
  return column.name + " " + name_of(column.type) + " " + std::string(name_of(rule)) + " " +
         value_text(column.type, column.fill.data());
}

std::optional<WordFault> read_value(ValueType type, std::span<const std::string_view> words,
                                    std::span<std::uint32_t> value) {
  if (words.size() != type.count)
    return WordFault{words.empty() ? std::string_view() : words.back(), wrong_count(type, words.size())};
  return with_scalar(type.scalar, [&](auto number) -> std::optional<WordFault> {
    for (std::uint32_t i = 0; i < type.count; ++i) {
      if (!read_number(words[i], number)) return WordFault{words[i], no_number_of(type.scalar)};
      std::memcpy(reinterpret_cast<std::byte*>(value.data()) + i * sizeof number, &number, sizeof number);
    }
    return std::nullopt;
  });
}

std::string value_text(ValueType type, const std::uint32_t* value) {
  return with_scalar(type.scalar, [&](auto number) {
    std::string text;
    for (std::uint32_t i = 0; i < type.count; ++i) {
      if (i != 0) text += ' ';
      if constexpr (std::is_same_v<decltype(number), bool>) {
        text += reinterpret_cast<const unsigned char*>(value)[i] != 0 ? "true" : "false";
      } else {
        std::memcpy(&number, reinterpret_cast<const std::byte*>(value) + i * sizeof number, sizeof number);
        char digits[40];
        text.append(digits, std::to_chars(digits, std::end(digits), number).ptr);
      }
    }
    return text;
  });
}

}  // namespace ryosen
