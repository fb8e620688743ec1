#include "ryosen/io/material_libraries.h"

#include <algorithm>
#include <system_error>

namespace ryosen {
namespace {

// Longer names cannot be file names; splitting them would only cost time.
constexpr std::size_t longest_name = 4096;

enum class Library { found, missing, no_file, unknown, outside };

Library look_for(std::string name, const std::filesystem::path& folder) {
  if (name.size() > longest_name) return Library::missing;
  std::replace(name.begin(), name.end(), '\\', '/');
  const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
  const bool has_drive = name.size() >= 2 && name[1] == ':';
  if (path.is_absolute() || has_drive || path.begin() == path.end() || *path.begin() == "..") return Library::outside;
  std::error_code error;
  switch (std::filesystem::status(folder / path, error).type()) {
    case std::filesystem::file_type::regular:
      return Library::found;
    case std::filesystem::file_type::not_found:
      return Library::missing;
    case std::filesystem::file_type::none:
      return Library::unknown;
    default:
      return Library::no_file;
  }
}

std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> names(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool keeps_space = text[i] == '\\' && i + 1 < text.size() && text[i + 1] == ' ';
    if (keeps_space) {
      names.back() += ' ';
      ++i;
    } else if (text[i] != ' ' && text[i] != '\t') {
      names.back() += text[i];
    } else if (!names.back().empty()) {
      names.emplace_back();
    }
  }
  if (names.back().empty()) names.pop_back();
  return names;
}

}  // namespace

MaterialLibraries look_for_libraries(std::string_view text, const std::filesystem::path& folder) {
  constexpr std::size_t most_names = 16;
  MaterialLibraries out;
  if (look_for(std::string(text), folder) == Library::found) return out;
  std::vector<std::string> names = split(text);
  if (names.size() > most_names) names.resize(most_names);
  for (std::string& name : names) {
    const Library library = look_for(name, folder);
    if (library == Library::missing) out.missing.push_back(std::move(name));
    if (library == Library::no_file) out.no_files.push_back(std::move(name));
    if (library == Library::unknown) out.unknown.push_back(std::move(name));
    if (library == Library::outside) out.outside.push_back(std::move(name));
  }
  return out;
}

}  // namespace ryosen
