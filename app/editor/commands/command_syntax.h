// What is wrong with a command line wherever it runs: seen before anything has been done.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/message.h"

namespace ryosen {

// An unknown command, or arguments that it cannot have on any mesh and with any files: their number, their form, words
// that it does not know. Nothing where that depends on the mesh, the files or what was done before. Changes nothing.
std::optional<Text> fault_of_command(const std::string& line);

// The commands that `either` is told, behind its name.
std::vector<std::string> alternatives(std::string_view whole);

// The same of the arguments of `expect`.
std::optional<Text> fault_of_expect(std::span<const std::string_view> arguments, const std::string& line);

// The same of `bind CHORD COMMAND`, `bind CHORD none` or `bind CHORD initial`: a clause.
std::optional<Text> fault_of_binding(std::string_view chord, const std::string& command);

// "collapse: ..."
Text behind(std::string_view id, const Text& sentence);

}  // namespace ryosen
