// What `check` prints.
#pragma once

#include <optional>
#include <vector>

#include "app/cli/contract/json.h"
#include "app/cli/contract/shape.h"
#include "ryosen/analysis/problem_kinds.h"

namespace ryosen::cli {

struct CheckReport;

// A key of the JSON with its value, and its place in the table of the text where it stands there too.
struct CheckRow {
  JsonKey key = {};
  struct Value {
    Json (*of)(const CheckReport&) = nullptr;  // null where it is how many elements of a kind there are
    int cell = -1;                             // row by row of three
    std::string_view en = {}, ja = {};
  } value = {};
  std::optional<ProblemKind> kind = {};  // the key is that of its row

  Json print(const CheckReport& report) const;
};

// In the order of the JSON. A kind of problem that has a figure and is not named here stands behind those that are.
std::vector<CheckRow> check_rows();
// An optional key is absent where its value is 0.
bool is_absent(const CheckRow& row, const Json& value);

std::vector<JsonKey> check_keys();
inline constexpr Shape check_shape{"check", "One per file.", "ファイルごとに一行。", {}, check_keys};

inline constexpr Contract check_contract{.lines = {&check_shape},
                                         .exits = {ExitCode::found_problems, ExitCode::input_missing,
                                                   ExitCode::input_malformed, ExitCode::some_inputs_failed}};

}  // namespace ryosen::cli
