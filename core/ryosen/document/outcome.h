// Outcome of an operator or a command, and why one cannot be, in words.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/codes.h"
#include "ryosen/base/message.h"
#include "ryosen/base/reasons.h"
#include "ryosen/base/result.h"
#include "ryosen/base/verdict.h"
#include "ryosen/indexed/indexed.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The result of an operator or a command.
struct Outcome {
  enum class Kind { done, refused, failed };
  Kind kind = Kind::done;
  ExitCode exit_code = ExitCode::done;
  // For refused and failed: names the element and the remedy. For done: a remark, usually empty.
  Text sentence;
  // The script line of what was done to the mesh or a file, even if it failed afterwards (a file written but not
  // synced); empty if nothing was.
  std::string performed;
  std::string selecting;  // the line that selects what `performed` works on; empty where that works on no selection
  std::vector<Reason> reasons;
  std::vector<Reason> warnings;
  std::vector<std::string> created;  // names after the operator
  std::vector<std::string> deleted;  // names before it

  bool done() const { return kind == Kind::done; }
  // Appends a sentence.
  void say(const Text& more);
};

// The code of the message about an outcome that is not done.
Code code_of(const Outcome& outcome);

// Nothing was done, for the reason in the sentence.
Outcome failed(ExitCode exit_code, Text sentence);

// Refused: the mesh has no attribute of this name.
Outcome no_attribute(std::string_view name);

// The sentence of a reason, with its witnesses: "... (v7, 5-9)".
Text describe(const Mesh& mesh, const Reason& reason);
// The sentences of the first reasons; the last one says how many more there are.
std::vector<Text> describe_first(const Mesh& mesh, const std::vector<Reason>& reasons);
// One behind the other.
Text join(const std::vector<Text>& sentences);
std::vector<std::string> names_of(const Mesh& mesh, const std::vector<Element>& elements);

// A quarantined face keeps its number, but no command can use it. If a name (f7, 0-1@f7, ~0-1@f7, v3@f7) refers to such
// a face: a sentence with the cause and its line. `quarantine` is ascending by face.
std::optional<Text> quarantine_text(std::span<const QuarantinedFace> quarantine, std::string_view name);
// The same for the first of several names that refers to one.
std::optional<Text> quarantine_text(std::span<const QuarantinedFace> quarantine,
                                    std::span<const std::string_view> names);

}  // namespace ryosen
