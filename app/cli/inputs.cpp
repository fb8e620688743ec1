#include "app/cli/inputs.h"

#include <algorithm>
#include <filesystem>

#include "core/io/formats.h"

namespace ryosen::cli {

namespace {

namespace fs = std::filesystem;

Failure folder_failure(std::string_view code, Text text) {
  Failure failure;
  failure.exit_code = ExitCode::input_missing;
  failure.message.code = code;
  failure.message.text = std::move(text);
  return failure;
}

// Links to folders are not followed, so the walk ends.
void walk(const fs::path& folder, std::vector<Input>& found) {
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    const fs::directory_entry& entry = *entries;
    std::error_code ignored;
    if (entry.is_directory(ignored)) {
      if (!entry.is_symlink(ignored)) walk(entry.path(), found);
    } else if (may_be_mesh(entry.path())) {
      found.push_back({entry.path().generic_string(), {}});
    }
  }
  if (error)
    found.push_back(
        {folder.generic_string(), folder_failure("folder_unreadable", {"The folder cannot be read: " + error.message(),
                                                                       "フォルダを読めません：" + error.message()})});
}

}  // namespace

std::vector<Input> find_inputs(const std::vector<std::string>& operands) {
  std::vector<Input> inputs;
  for (const std::string& operand : operands) {
    std::error_code ignored;
    if (!fs::is_directory(operand, ignored)) {
      inputs.push_back({operand, {}});
      continue;
    }
    std::vector<Input> found;
    walk(operand, found);
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
  const auto is_read = [](ExitCode code) { return code == ExitCode::done || code == ExitCode::found_problems; };
  const auto count = std::count_if(codes.begin(), codes.end(), is_read);
  if (count == static_cast<std::ptrdiff_t>(codes.size()))
    return std::find(codes.begin(), codes.end(), ExitCode::found_problems) != codes.end() ? ExitCode::found_problems
                                                                                          : ExitCode::done;
  if (std::find(codes.begin(), codes.end(), ExitCode::internal_error) != codes.end()) return ExitCode::internal_error;
  if (count > 0) return ExitCode::some_inputs_failed;
  const bool all_missing =
      std::all_of(codes.begin(), codes.end(), [](ExitCode c) { return c == ExitCode::input_missing; });
  return all_missing ? ExitCode::input_missing : ExitCode::input_malformed;
}

}  // namespace ryosen::cli
