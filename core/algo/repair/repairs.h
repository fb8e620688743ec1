// The one table of repairs: what takes whole kinds of problems away at once.
//
// To add one, write its function in a pair of files of its own and its row here. The command line, scripts, the buttons
// of the window, their help and their tests read the table.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/analysis/problem_kinds.h"
#include "core/base/message.h"
#include "core/base/progress.h"
#include "core/mesh/edit.h"

namespace ryosen {

struct RepairResult {
  std::size_t changed = 0;  // 0: nothing was written
  std::size_t left = 0;     // what the repair is for, but what it had to leave as it is
  Text text;                // a sentence with the numbers
};

struct RepairInput {
  std::optional<double> number;
  // Vertices that something beside the mesh refers to (faces set aside, lines and points of the file), ascending.
  std::span<const Vertex> used_elsewhere;
};

// What a repair's number means.
enum class RepairNumber { none, may_be_given, must_be_given };

struct RepairRow {
  std::string_view id;
  std::string_view syntax;  // of the number; empty without
  std::string_view name_en, name_ja;
  std::string_view help_en, help_ja;
  bool keeps_geometry;  // all places and faces stay what they are: done unless others are named
  RepairNumber number;  // not negative, finite
  std::vector<ProblemKind> solves;
  // Does it within an edit, which is one entry of the history; one that was cancelled is not to be committed. Null: the
  // repair is about the faces that reading set aside, which belong to the document.
  RepairResult (*run)(Edit& edit, const RepairInput& input, Progress& progress);
};

// In the order in which they are done, each after those that make its work easier.
std::span<const RepairRow> repair_table();
// By id; null when there is none.
const RepairRow* find_repair(std::string_view id);

// A repair and its number as users write them: `weld_close 0.01`, `weld_close=0.01`.
struct RepairCall {
  const RepairRow* row = nullptr;
  std::optional<double> number;
};
// Null row and a sentence where the words say no repair.
struct ParsedRepair {
  RepairCall call;
  Text sentence;
};
ParsedRepair parse_repair(std::string_view id, std::optional<std::string_view> number);

// "{done}; {left} ..." put together from a count and a noun with its verb: sentences of the repairs.
Text repair_text(std::size_t changed, std::string_view en_one, std::string_view en_many, std::string_view ja);

}  // namespace ryosen
