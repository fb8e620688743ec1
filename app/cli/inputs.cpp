#include "app/cli/inputs.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "ryosen/io/formats.h"
#include "ryosen/io/system_reason.h"

namespace ryosen::cli {

namespace {

namespace fs = std::filesystem;

Failure folder_failure(Code code, Text text) { return make_failure(ExitCode::input_missing, code, std::move(text)); }

// Recursive directory walk. Links to folders are followed, but each folder is visited once: under its own path if it is
// below the start, else through the first link in byte order.
class FolderWalk {
 public:
  explicit FolderWalk(const fs::path& folder) {
    enter(folder);
    while (!links_.empty()) {
      const std::set<std::string>::node_type link = links_.extract(links_.begin());
      enter(link.value());
    }
  }

  std::vector<Input> take() { return std::move(found_); }

 private:
  void enter(const fs::path& folder) {
    struct stat status;
    if (::stat(folder.c_str(), &status) == 0 && !entered_.emplace(status.st_dev, status.st_ino).second) return;
    std::error_code error;
    fs::directory_iterator entries(folder, error);
    for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
      const fs::directory_entry& entry = *entries;
      std::error_code ignored;
      if (entry.is_directory(ignored)) {
        if (entry.is_symlink(ignored))
          links_.insert(entry.path().native());
        else
          enter(entry.path());
      } else if (may_be_mesh(entry.path())) {
        found_.push_back({entry.path().generic_string(), {}});
      }
    }
    if (!error) return;
    const Text reason = system_reason(error.value());
    found_.push_back(
        {folder.generic_string(), folder_failure("folder_unreadable", {"The folder cannot be read: " + reason.en + ".",
                                                                       "フォルダを読めません：" + reason.ja + "。"})});
  }

  std::vector<Input> found_;
  std::set<std::pair<dev_t, ino_t>> entered_;
  std::set<std::string> links_;  // paths of links to folders, not visited yet
};

}  // namespace

std::vector<Input> find_inputs(const std::vector<std::string>& operands) {
  std::vector<Input> inputs;
  for (const std::string& operand : operands) {
    std::error_code ignored;
    if (!fs::is_directory(operand, ignored)) {
      inputs.push_back({operand, {}});
      continue;
    }
    std::vector<Input> found = FolderWalk(operand).take();
    std::sort(found.begin(), found.end(), [](const Input& a, const Input& b) { return a.path < b.path; });
    if (found.empty())
      found.push_back({operand, folder_failure("folder_empty", {"The folder holds no mesh that can be read.",
                                                                "フォルダに読み込めるメッシュがありません。"})});
    std::move(found.begin(), found.end(), std::back_inserter(inputs));
  }
  return inputs;
}

ExitCode combine(const std::vector<ExitCode>& codes) {
  if (codes.size() == 1) return codes[0];
  const auto is_there = [&](ExitCode code) { return std::find(codes.begin(), codes.end(), code) != codes.end(); };
  const auto is_read = [](ExitCode code) { return code == ExitCode::done || code == ExitCode::found_problems; };
  const auto count = std::count_if(codes.begin(), codes.end(), is_read);
  if (count == static_cast<std::ptrdiff_t>(codes.size()))
    return is_there(ExitCode::found_problems) ? ExitCode::found_problems : ExitCode::done;
  if (is_there(ExitCode::internal_error)) return ExitCode::internal_error;
  if (count > 0) return ExitCode::some_inputs_failed;
  if (is_there(ExitCode::out_of_memory)) return ExitCode::out_of_memory;
  const bool all_missing =
      std::all_of(codes.begin(), codes.end(), [](ExitCode c) { return c == ExitCode::input_missing; });
  return all_missing ? ExitCode::input_missing : ExitCode::input_malformed;
}

}  // namespace ryosen::cli
