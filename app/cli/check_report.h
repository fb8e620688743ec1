// The report of `check` on one file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/console.h"
#include "app/cli/contract/json.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/analysis/mesh_kind.h"
#include "ryosen/analysis/problems.h"
#include "ryosen/io/edited_file.h"
#include "ryosen/io/mesh_file.h"

namespace ryosen::cli {

// Names of elements, concatenated in one string to save memory: a malformed file may give one per byte.
class NameList {
 public:
  void add(std::string_view name) {
    text_ += name;
    text_ += ',';
  }
  // Calls visit(name) for the first `most` of them.
  template <class Visit>
  void for_each(std::size_t most, Visit visit) const {
    std::string_view rest = text_;
    for (; most > 0 && !rest.empty(); --most) {
      const std::size_t end = rest.find(',');
      visit(rest.substr(0, end));
      rest.remove_prefix(end + 1);
    }
  }
  // Total size of all names.
  std::size_t bytes() const { return text_.size(); }

 private:
  std::string text_;
};

struct NamedProblem {
  Problem problem;
  NameList names;  // of all its elements
};

struct CheckReport {
  std::string file;
  std::string format;              // empty if not recognised
  std::optional<Failure> failure;  // if set, the rest is empty; so is what was not looked for
  Figures figures;
  KindOfMesh kind;
  ElementTotals beside;  // lines and points of the file, in no face
  std::vector<NamedProblem> problems;
  std::vector<Message> messages;
  std::string hash;

  // Whether there is a problem, or a warning about this file. A warning about another file, such as a missing material
  // library, is no finding.
  bool has_findings() const;
  // "ok", "warnings" or "error".
  std::string_view status() const;
};

// What a check looks for beside the problems.
struct CheckScope {
  bool self_intersections = false;
  std::size_t most_pairs = 0;  // of those, to be listed; the others are counted
  bool figures = true;         // and the hash
  bool kind = true;
};

// Runs the checks on the mesh of a file that has been read.
CheckReport check_mesh(MeshFile file, const std::string& path, const CheckScope& scope = {});
// Reads the file and runs the checks on its mesh.
CheckReport check_file(const std::string& path, const CheckScope& scope = {});

// The line of `check --json`, with its line end. Names are written straight into the text: as JSON objects they would
// take many times the memory.
std::string json_line_of(const CheckReport& report);
Json to_json(const NamedProblem& problem);
// A table of figures, then the problems; with `verbose` every element is named.
std::string to_text(const CheckReport& report, const Console& console);
std::string to_text(const NamedProblem& problem, const Console& console);

}  // namespace ryosen::cli
