// Values of parameters from words and from fields.
#include <algorithm>
#include <cassert>

#include "ryosen/algo/parameters.h"

namespace ryosen {

ReadValues read_values(std::span<const ParameterRow> rows, std::span<const std::string_view> words,
                       const std::vector<std::string>* selected) {
  ReadValues read{ParameterValues(rows), NameError::none, {}, {}};
  const auto fail = [](Text sentence) {
    return ReadValues{std::nullopt, NameError::malformed, {}, std::move(sentence)};
  };
  std::vector<std::string_view> given;
  for (std::string_view word : words) {
    const std::size_t equals = std::min(word.find('='), word.size());
    const bool is_first = equals == word.size() && word.data() == words[0].data() && !rows.empty();
    const std::string_view id = is_first ? rows[0].id : word.substr(0, equals);
    const std::string_view text = is_first ? word : word.substr(std::min(equals + 1, word.size()));
    if (std::find(given.begin(), given.end(), id) != given.end()) {
      const std::string name(id);
      return fail({name + " is given twice", name + " が二度指定されています"});
    }
    given.push_back(id);
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const ParameterRow& r) { return r.id == id; });
    if (selected && row != rows.end() && means_selection(*row, text))
      read.values->set_names(id, *selected);
    else if (auto fault = read.values->set(id, text, id))
      return fail(std::move(*fault));
  }
  if (auto fault = read.values->fault_of_missing([](const ParameterRow& row) { return std::string(row.id); }))
    return fail(std::move(*fault));
  return read;
}

ReadValues read_fields(std::span<const ParameterRow> rows, std::span<const std::string> texts,
                       const std::vector<std::string>* selected) {
  assert(texts.size() == rows.size());
  const auto fail = [](const Text& called_in_english, const Text& called_in_japanese) {
    return ReadValues{std::nullopt, NameError::malformed, {}, {called_in_english.en, called_in_japanese.ja}};
  };
  ReadValues read{ParameterValues(rows), NameError::none, {}, {}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (texts[i].empty()) continue;
    if (selected && means_selection(rows[i], texts[i])) {
      read.values->set_names(rows[i].id, *selected);
      continue;
    }
    if (const auto fault = read.values->set(rows[i].id, texts[i], rows[i].name_en))
      return fail(*fault, *read.values->set(rows[i].id, texts[i], rows[i].name_ja));
  }
  if (const auto fault = read.values->fault_of_missing([](const ParameterRow& r) { return std::string(r.name_en); }))
    return fail(*fault, *read.values->fault_of_missing([](const ParameterRow& r) { return std::string(r.name_ja); }));
  return read;
}

std::string syntax_of(std::span<const ParameterRow> rows) {
  std::string syntax;
  for (const ParameterRow& row : rows) {
    const std::string word = std::string(row.id) + "=" + placeholder(row);
    syntax += (syntax.empty() ? "" : " ") + (row.is_required ? word : "[" + word + "]");
  }
  return syntax;
}

}  // namespace ryosen
