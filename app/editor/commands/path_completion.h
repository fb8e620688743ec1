// Completes paths that are being typed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ryosen {

struct FolderEntry {
  std::string name;
  bool is_folder = false;
};

// What a folder holds but for hidden names: folders first, each sort by name. Of files those that `lists` wants; all
// where it is empty. Nothing where the folder cannot be read.
std::vector<FolderEntry> entries_of_folder(const std::filesystem::path& folder,
                                           const std::function<bool(const std::filesystem::path&)>& lists = {});

// The path with as much behind it as all entries have in common that begin so, and a slash behind the only folder. A
// path that is not absolute lies in `base`; one that begins with ~/ in the user's home. As it was where nothing fits.
std::string completed_path(std::string_view typed, const std::filesystem::path& base,
                           const std::function<bool(const std::filesystem::path&)>& lists = {});

// ~ alone or ~/ in front of a path stands for the user's home.
std::filesystem::path without_tilde(std::string_view path);

}  // namespace ryosen
