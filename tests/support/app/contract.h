// The contract that `ryosen help json` prints, and what the program prints held against it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/support/app/program.h"

namespace ryosen::test {

// What a number of lines have shown.
struct SeenOfContract {
  std::set<std::string> keys;   // "object.key"
  std::set<std::string> ids;    // "list.id"
  std::set<std::string> exits;  // "command number", of those that are not every command's
};

// What does not fit, in words, of a run with these arguments; empty where all does. Every line of a run with --json is
// looked at, the exit code of each.
std::string fault_of_run(const std::vector<std::string>& arguments, const ProgramRun& run,
                         SeenOfContract* seen = nullptr);

// In what `help json` prints, the keys of an object but for those that may be absent, in their order.
std::vector<std::string> required_keys(const std::vector<Json>& contract, const std::string& object);

// All that there is to be seen.
SeenOfContract all_of_contract();

}  // namespace ryosen::test
