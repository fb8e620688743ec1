// Looks whether the material libraries that an OBJ file names are there, without opening them.
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
  std::vector<std::string> outside;   // absolute, or leading out of the model's folder: not even looked for
};

// `text` is what stands after mtllib: one name with spaces in it, or several names parted by spaces (a backslash keeps
// a space or is a path's separator). `folder` is the model's; an empty one means the current folder.
MaterialLibraries look_for_libraries(std::string_view text, const std::filesystem::path& folder);

}  // namespace ryosen
