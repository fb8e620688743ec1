// Checks whether the material libraries of an OBJ file exist, without opening them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ryosen {

struct MaterialLibraries {
  std::vector<std::string> missing;
  std::vector<std::string> no_files;  // there, but folders, pipes or devices
  std::vector<std::string> unknown;   // in a folder that may not be looked into
  std::vector<std::string> outside;   // absolute, or outside the model's folder: not checked
};

// `text` follows mtllib: one name with spaces, or several names separated by spaces (a backslash escapes a space or is
// a path separator). `folder` is the model's; empty means the current folder.
MaterialLibraries look_for_libraries(std::string_view text, const std::filesystem::path& folder);

}  // namespace ryosen
