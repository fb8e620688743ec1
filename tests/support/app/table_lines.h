// Command lines made of the tables, so that a new row is tried too.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ryosen::test {

using Words = std::vector<std::string>;

// Every command, algorithm and operator on this mesh, and every format: written from it and read from a file that is
// made in this folder. Outputs are named o.EXT, without a folder.
std::vector<Words> lines_of_tables(const std::string& mesh, const std::filesystem::path& folder);

}  // namespace ryosen::test
