// The command lines that bench_growth runs, read from the tables of the program: whatever is added there is measured.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen::bench {

struct GrowthCommand {
  std::string name;
  std::vector<std::string> arguments;
};

// All that read one mesh: check, why for every operator on an edge, edit with every operator that acts on an element
// and with every one on all elements of a kind, repair, every algorithm, convert to every format, forms and shot.
// Outputs go to `folder`.
std::vector<GrowthCommand> growth_commands(const Mesh& mesh, const std::filesystem::path& file,
                                           const std::filesystem::path& folder);

}  // namespace ryosen::bench
