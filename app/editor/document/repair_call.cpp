#include "app/editor/document/repair_call.h"

#include <algorithm>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/base/split_list.h"

namespace ryosen {

namespace {

void add_default(std::vector<RecipeStep>& steps) {
  for (const AlgorithmRow& row : algorithm_table())
    if (row.is_repair() && row.keeps_geometry) steps.push_back({&row, ParameterValues(row.parameters)});
}

// One word of the list.
void add_steps(const std::string& word, ReadRepairs& read, std::vector<RecipeStep>& steps) {
  const std::size_t equals = std::min(word.find('='), word.size());
  const std::string id = word.substr(0, equals);
  if (id == default_repairs) {
    if (equals == word.size()) return add_default(steps);
    read.fault = {"default stands for several repairs and takes no number",
                  "default は複数の修復をまとめたもので、数は付けられません"};
    return;
  }
  const AlgorithmRow* const row = find_algorithm(id);
  if (!row || !row->is_repair()) {
    read.fault = {"there is no repair '" + id + "'", "修復「" + id + "」はありません"};
    read.unknown = id;
    return;
  }
  std::vector<std::string_view> words;
  if (equals < word.size()) words.push_back(std::string_view(word).substr(equals + 1));
  ReadValues values = read_values(row->parameters, words);
  if (values.values) return steps.push_back({row, std::move(*values.values)});
  read.fault = {id + ": " + values.sentence.en, id + "：" + values.sentence.ja};
  read.misused = row;
}

}  // namespace

ReadRepairs read_repairs(std::string_view list) {
  ReadRepairs read;
  read.call.in_rounds = true;
  std::vector<RecipeStep> given;
  for (const std::string_view word : split_list(list)) {
    add_steps(std::string(word), read, given);
    if (read.fault) return read;
  }
  for (const AlgorithmRow& row : algorithm_table()) {
    const auto last = std::find_if(given.rbegin(), given.rend(), [&](const RecipeStep& s) { return s.row == &row; });
    if (last != given.rend()) read.call.steps.push_back(std::move(*last));
  }
  return read;
}

bool is_list_of_repairs(std::string_view word) {
  return word == default_repairs || word.find_first_of(",=") != word.npos;
}

std::vector<std::string> ids_of_repairs() {
  std::vector<std::string> ids{std::string(default_repairs)};
  for (const AlgorithmRow& row : algorithm_table())
    if (row.is_repair()) ids.emplace_back(row.id);
  return ids;
}

}  // namespace ryosen
