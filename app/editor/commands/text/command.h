// A command on its way from whoever gives it to the mesh, and the lines that call algorithms and select, as a script
// has them.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "ryosen/algo/algorithm.h"
#include "ryosen/analysis/problem_kinds.h"
#include "ryosen/ops/all.h"
#include "ryosen/scene/selection/selectors.h"

namespace ryosen {

// An algorithm with its values; elements are named as on the mesh that it runs on.
struct AlgorithmCall {
  const AlgorithmRow* row;
  ParameterValues values;
  bool is_called_repair = false;   // its line begins with `repair`
  bool has_unnamed_value = false;  // the first value of its line stands without its name

  std::string line() const;
};

// An operator on the shown mesh, an algorithm with its values, or the line of any command. The log has the line
// of a value; only the names of elements are read from it.
class Command {
 public:
  Command(std::string line) : is_(std::move(line)) {}
  Command(const char* line) : is_(std::string(line)) {}
  template <class Op>
  requires std::convertible_to<Op, AnyOp> Command(Op op) : is_(AnyOp(std::move(op))) {}
  Command(AlgorithmCall call) : is_(std::move(call)) {}

  // Null unless it is one.
  const AnyOp* op() const { return std::get_if<AnyOp>(&is_); }
  const AlgorithmCall* algorithm() const { return std::get_if<AlgorithmCall>(&is_); }
  const std::string* written() const { return std::get_if<std::string>(&is_); }
  // As a script has it. O(its elements).
  std::string line(const Mesh& mesh) const;

 private:
  std::variant<std::string, AnyOp, AlgorithmCall> is_;
};

// How scripts call an algorithm: by its id, behind `repair` where that is wanted or an operator has the id.
std::string called(const AlgorithmRow& algorithm, bool as_repair = false);
// The line that selects what a row of the table of selectors finds, with its usual value.
std::string select_line(const Selector& row);
// Before the id of a problem, which a selector may have too.
inline constexpr std::string_view of_problem = "problem";
// The line that selects all that has a problem, or what the one at an element is about; never that of a selector.
std::string select_line(const ProblemRow& row, std::string_view element = {});

}  // namespace ryosen
