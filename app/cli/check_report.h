// What `check` says about one file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "app/cli/json.h"
#include "core/analysis/figures.h"
#include "core/analysis/problems.h"
#include "core/io/mesh_file.h"

namespace ryosen::cli {

struct NamedProblem {
  Problem problem;
  std::vector<std::string> names;  // of all its elements
};

struct CheckReport {
  std::string file;
  std::string format;              // empty when the file is of none
  std::optional<Failure> failure;  // then the rest is empty
  Figures figures;
  std::vector<NamedProblem> problems;
  std::vector<Message> messages;
  std::string hash;

  // "ok", "warnings" or "error".
  std::string_view status() const;
};

// Asks everything about the mesh of a file that has been read.
CheckReport check_mesh(MeshFile file, const std::string& path, bool with_self_intersections = false);
// Reads the file and asks everything about its mesh.
CheckReport check_file(const std::string& path, bool with_self_intersections = false);

Json to_json(const CheckReport& report);
Json to_json(const NamedProblem& problem);
// A table of figures, then the problems; with `verbose` every element is named.
std::string to_text(const CheckReport& report, const Console& console);
std::string to_text(const NamedProblem& problem, const Console& console);

}  // namespace ryosen::cli
