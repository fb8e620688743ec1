#include "app/editor/commands/path_completion.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "ryosen/io/folder_entries.h"

namespace ryosen {

namespace fs = std::filesystem;

std::vector<FolderEntry> entries_of_folder(const fs::path& folder, const std::function<bool(const fs::path&)>& lists) {
  std::vector<FolderEntry> entries;
  std::error_code ignored;
  for (const ListedEntry& entry : folder_entries(folder, ignored)) {
    const std::string name = entry.path.filename().string();
    if (name.starts_with('.')) continue;
    if (entry.is_folder || !lists || lists(entry.path)) entries.push_back({name, entry.is_folder});
  }
  std::sort(entries.begin(), entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
    return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
  });
  return entries;
}

fs::path without_tilde(std::string_view path) {
  const char* const home = std::getenv("HOME");
  if (home && path == "~") return home;
  return home && path.starts_with("~/") ? fs::path(home) / path.substr(2) : fs::path(path);
}

std::string completed_path(std::string_view typed, const fs::path& base,
                           const std::function<bool(const fs::path&)>& lists) {
  const std::size_t slash = typed.rfind('/');
  const std::string_view folder = slash == typed.npos ? std::string_view() : typed.substr(0, slash + 1);
  const std::string_view begun = typed.substr(folder.size());
  std::optional<std::string> common;
  for (const FolderEntry& entry : entries_of_folder(folder.empty() ? base : base / without_tilde(folder), lists)) {
    if (!entry.name.starts_with(begun)) continue;
    const std::string name = entry.name + (entry.is_folder ? "/" : "");
    if (!common) common = name;
    const auto differs = std::mismatch(common->begin(), common->end(), name.begin(), name.end()).first;
    auto end = differs;  // not within a letter
    while (end != common->begin() && end != common->end() && (static_cast<unsigned char>(*end) & 0xC0) == 0x80) --end;
    common->erase(end, common->end());
  }
  return std::string(folder) + (common && common->size() > begun.size() ? *common : std::string(begun));
}

}  // namespace ryosen
