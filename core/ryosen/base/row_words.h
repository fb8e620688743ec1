// The words that a row of a table has for people: of an algorithm, of a value of one, of a place of an operator's line.
#pragma once

#include <string_view>

namespace ryosen {

struct RowWords {
  std::string_view id = "";                     // snake_case
  std::string_view name_en = "", name_ja = "";  // of its field or command
  std::string_view help_en = "", help_ja = "";
};

// Gives a row its words.
template <class Row>
constexpr Row with_words(const RowWords& words, Row row) {
  row.id = words.id;
  row.name_en = words.name_en;
  row.name_ja = words.name_ja;
  row.help_en = words.help_en;
  row.help_ja = words.help_ja;
  return row;
}

}  // namespace ryosen
