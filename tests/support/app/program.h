// Runs the built program as a user does, and looks at what it leaves.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ryosen::test {

using Json = nlohmann::ordered_json;

// In their order.
std::vector<std::string> keys_of(const Json& json);

struct ProgramRun {
  int exit_code = -1;  // 128 + signal where the program was killed
  std::string out, err;

  // stdout as JSON, one value per line. A line that is not JSON fails the test and is left out.
  std::vector<Json> lines() const;
  // The only line; fails the test when there are more or fewer.
  Json line() const;
};

// Without a display, in English, in the folder (the current one when empty). `environment` holds further NAME=VALUE. A
// run that ends or prints otherwise than `ryosen help json` says fails the test.
ProgramRun run_program(const std::vector<std::string>& arguments, const std::filesystem::path& folder = {},
                       const std::vector<std::string>& environment = {});

// The same, whatever it prints.
ProgramRun run_unchecked(const std::vector<std::string>& arguments, const std::filesystem::path& folder = {},
                         const std::vector<std::string>& environment = {});

// Of words within this process, which may have rows in its tables that the program has not.
ProgramRun run_here(std::vector<std::string> words, const std::vector<std::string>& further = {});

// A folder of its own, removed with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  // Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& text) const;
  std::string copy(const std::filesystem::path& file, const std::string& name) const;
  std::string at(const std::string& name) const { return (path_ / name).string(); }
  bool has(const std::string& name) const { return std::filesystem::exists(path_ / name); }
  // Names of all files, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

// A variable of the environment while this lives; then it is what it was before.
class ScopedVariable {
 public:
  ScopedVariable(std::string name, const std::string& value);
  ~ScopedVariable();
  ScopedVariable(const ScopedVariable&) = delete;
  ScopedVariable& operator=(const ScopedVariable&) = delete;

 private:
  std::string name_;
  std::optional<std::string> before_;
};

// OBJ text of bands of squares, each around two round holes, which take seconds to fill.
std::string bands_around_holes();
std::string read_file(const std::filesystem::path& path);
// A word of a shell's line, whatever is in it; and the program as such a word.
std::string shell_word(std::string_view text);
std::string shell_program();
// A mesh of the assets folder.
std::string asset(const std::string& name);
// A file of people's reports, of tests/data/reports.
std::string report_file(const std::string& name);
// A file of the folder that lies beside the project; empty where it does not.
std::string shared_file(const std::string& name);

}  // namespace ryosen::test
