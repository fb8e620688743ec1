// An algorithm: what changes a mesh as a whole, as the row of a table. The table is algorithm_table.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ryosen/algo/parameters.h"
#include "ryosen/analysis/problem_kinds.h"
#include "ryosen/base/element.h"
#include "ryosen/base/message.h"
#include "ryosen/base/progress.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// Reports that are asked for beside the work of an algorithm, where it can give them.
struct AlgorithmWants {
  bool edge_rules = false;  // the rule under which each edge stands, see GoalReport
  bool descent = false;     // the edit records where elements come from, where the lineage is told
};

// The input of an algorithm; of an open file Document::run() fills it.
struct AlgorithmInput {
  ParameterValues values = ParameterValues();  // lengths in units of the mesh, elements looked up
  // Vertices that something beside the mesh refers to (quarantined faces, lines and points of the file), ascending.
  std::span<const Vertex> used_elsewhere = {};
  std::size_t quarantined = 0;            // faces of the file that reading could not connect
  std::span<const Vertex> on_lines = {};  // vertices that lines of the file use, which are not isolated; ascending
  AlgorithmWants wants = {};
  std::optional<bool> holds_floats = {};  // whether the file stores float coordinates; none where it has no such type
};

// What an algorithm left for one reason.
struct LeftForReason {
  Text reason;                    // a clause: "every patch would ..."
  std::vector<Element> elements;  // one for each thing left, which names it
  bool names_them = false;        // the reason says what they are
};

// Adds one where there are such elements.
inline void add_left(std::vector<LeftForReason>& left_for, Text reason, std::vector<Element> elements,
                     bool names_them = false) {
  if (!elements.empty()) left_for.push_back({std::move(reason), std::move(elements), names_them});
}

// Why an algorithm with a goal came to its end.
enum class Stop { goal, error, distance, blocked, shape, cancelled };

// What an algorithm with a goal says of its end.
struct GoalReport {
  Stop stopped = Stop::goal;
  bool is_reached = true;                // the goal; an error or a distance that is the only goal is one
  std::optional<double> error_max = {};  // a distance in units of the mesh
  // By EdgeRule, of the edges of faces, counted on points: the first rule that holds each. Empty unless it was asked
  // for, and where every edge is free.
  std::vector<std::size_t> remaining = {};
  // The same by edge slot of the result, or no_rule; of an algorithm that knows it (see find_remaining()).
  std::vector<std::uint8_t> rules = {};
};

struct AlgorithmResult {
  std::size_t changed = 0;         // 0: nothing was written
  std::size_t left = 0;            // how many places it should have treated and could not
  Text text = {};                  // a sentence with the numbers
  bool drops_quarantined = false;  // the quarantined faces are to be forgotten
  bool has_normals = false;        // it gave the corners normals, which are those of the surface as it is now
  // Pairs of faces that meet now and did not before (self_intersections.h), by an algorithm that counts them.
  std::optional<std::size_t> crossings = {};
  std::vector<LeftForReason> left_for = {};  // where reasons are told: all of what is left, by reason
  // Why these values, each of them in its range, cannot be used together: a clause. Nothing was written then.
  std::optional<Text> fault = {};
  // Why the mesh is none that it can be done on, as one without faces: a clause. Nothing was written then.
  std::optional<Text> refused = {};
  std::optional<GoalReport> goal_report = {};  // of one that has a goal
};

// How what is selected or kept under a name goes on behind an algorithm.
enum class Lineage {
  numbers,  // elements that stay keep their numbers
  told,     // new elements come from old ones, as the edit tells (descent.h)
  lost,     // numbers mean nothing any more, and what elements come from says little of where they lie
};

struct AlgorithmRow {
  std::string_view id = "";  // these five as in RowWords
  std::string_view name_en = "", name_ja = "";
  std::string_view help_en = "", help_ja = "";
  // One that is required has no initial value. A repair requires its first one at most (`--kinds ID=NUMBER`), and none
  // where it keeps geometry.
  std::vector<ParameterRow> parameters = {};
  // With its initial values it moves no finite place and removes no face, but may cut faces whose edges hold a place:
  // `ryosen repair` does it unless others are named.
  bool keeps_geometry = false;
  std::vector<ProblemKind> solves = {};  // not empty: a repair
  // Does it within an edit, which is one entry of the history; one that was cancelled is not to be committed.
  AlgorithmResult (*run)(Edit& edit, const AlgorithmInput& input, Progress& progress);
  // Adds a shape beside what is there, and so needs no mesh to begin with.
  bool is_primitive = false;
  Lineage lineage = Lineage::numbers;
  bool selects_added = false;  // what it has added is selected afterwards
  bool adds_points = false;    // points by themselves are what is wanted, and no fault of the result
  // Has a goal and tells in goal_report how it ended: its subcommand ends with 1 where it stopped before.
  bool has_goal = false;
  bool accounts_for_edges = false;  // and for each edge that is left, by the rule that holds it
  // The program has a command of this name, which prints what other algorithms do not have.
  bool has_own_subcommand = false;

  bool is_repair() const { return !solves.empty(); }
};

inline AlgorithmRow algorithm_row(const RowWords& words, AlgorithmRow row) { return with_words(words, std::move(row)); }

}  // namespace ryosen
