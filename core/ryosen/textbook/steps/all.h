// The table of what can be played step by step. The command line, the window, the help and tests go over it; a new one
// is a function that makes the steps, and a row.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/result.h"
#include "ryosen/textbook/steps/sequence.h"

namespace ryosen::steps {

using Made = Result<std::unique_ptr<Sequence>>;
using Choices = std::vector<std::vector<std::string>>;

struct StepsRow {
  std::string_view id;
  std::string_view syntax;  // of the arguments; [ ] around what may be left out
  std::string_view en, ja;  // its name
  std::string_view help_en, help_ja;
  // The syntax is the name of a script; the function gets its lines instead, one each, on the mesh that they begin
  // with.
  bool plays_script;
  // The steps on a mesh, which is not needed later. A fault of the arguments is usage; a mesh on which this cannot be
  // played is `refused`, with a sentence that names the element and the remedy.
  Made (*make)(const Mesh& mesh, std::span<const std::string> arguments);
  // Arguments to offer for this mesh, with elements of the selection where they fit, the usual ones first; empty where
  // the mesh has nothing to play, or they are names of scripts.
  Choices (*choices)(const Mesh& mesh, std::span<const Element> selection);
};
std::span<const StepsRow> all_steps();
// Null for an unknown id.
const StepsRow* find_steps(std::string_view id);

// "script S", "build", ...
std::string call_of(const StepsRow& row);

}  // namespace ryosen::steps
