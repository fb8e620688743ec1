#include "tests/support/app/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cmath>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "app/cli/run.h"
#include "tests/support/app/contract.h"

namespace ryosen::test {

namespace {

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

// The environment of the tests without what would make runs differ.
std::vector<std::string> plain_environment(const std::vector<std::string>& further) {
  std::vector<std::string> all{"LC_ALL=C"};
  for (char** entry = environ; *entry; ++entry) {
    const std::string text(*entry);
    const auto is = [&](const char* prefix) { return text.rfind(prefix, 0) == 0; };
    if (!is("DISPLAY=") && !is("WAYLAND_DISPLAY=") && !is("LC_") && !is("LANG")) all.push_back(text);
  }
  for (const std::string& entry : further) {
    const std::string name = entry.substr(0, entry.find('=') + 1);
    std::erase_if(all, [&](const std::string& other) { return other.rfind(name, 0) == 0; });
    all.push_back(entry);
  }
  return all;
}

}  // namespace

ProgramRun run_program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                       const std::vector<std::string>& environment) {
  ProgramRun run = run_unchecked(arguments, folder, environment);
  EXPECT_EQ(fault_of_run(arguments, run), "");
  return run;
}

ProgramRun run_here(std::vector<std::string> words, const std::vector<std::string>& further) {
  words.insert(words.end(), further.begin(), further.end());
  ProgramRun run;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  run.exit_code = static_cast<int>(cli::run(words));
  run.out = testing::internal::GetCapturedStdout();
  run.err = testing::internal::GetCapturedStderr();
  return run;
}

std::vector<std::string> keys_of(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& item : json.items()) keys.push_back(item.key());
  return keys;
}

ProgramRun run_unchecked(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                         const std::vector<std::string>& environment) {
  const TemporaryFolder outputs;
  const std::string out = outputs.at("out"), err = outputs.at("err");
  std::vector<std::string> words{RYOSEN_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = plain_environment(environment);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());

  ProgramRun run;
  pid_t child = 0;
  const int error =
      posix_spawn(&child, RYOSEN_PROGRAM, &actions, nullptr, pointers(words).data(), pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    ADD_FAILURE() << "cannot start " << RYOSEN_PROGRAM;
    return run;
  }
  int status = 0;
  waitpid(child, &status, 0);
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = read_file(out);
  run.err = read_file(err);
  return run;
}

std::vector<Json> ProgramRun::lines() const {
  std::vector<Json> all;
  std::istringstream text(out);
  for (std::string line; std::getline(text, line);) {
    Json json = Json::parse(line, nullptr, false);
    if (json.is_discarded())
      ADD_FAILURE() << "not JSON: " << line;
    else
      all.push_back(std::move(json));
  }
  return all;
}

Json ProgramRun::line() const {
  std::vector<Json> all = lines();
  EXPECT_EQ(all.size(), 1u) << out << err;
  return all.size() == 1 ? all[0] : Json::object();
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "ryosen-test-XXXXXX").string();
  if (!mkdtemp(name.data())) ADD_FAILURE() << "cannot make a temporary folder";
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
  std::filesystem::create_directories((path_ / name).parent_path());
  std::ofstream(path_ / name, std::ios::binary) << text;
  return at(name);
}

std::string TemporaryFolder::copy(const std::filesystem::path& file, const std::string& name) const {
  std::filesystem::copy_file(file, path_ / name);
  return at(name);
}

std::vector<std::string> TemporaryFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path_))
    if (entry.is_regular_file()) names.push_back(std::filesystem::relative(entry.path(), path_).string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string bands_around_holes() {
  constexpr int bands = 12, sides = 3000;
  std::string text;
  for (int z = 0; z < 2 * bands; ++z)
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * M_PI * i / sides;
      text += "v " + std::to_string(100 * std::cos(angle)) + " " + std::to_string(100 * std::sin(angle)) + " " +
              std::to_string(z) + "\n";
    }
  for (int band = 0; band < bands; ++band)
    for (int i = 1; i <= sides; ++i) {
      const int low = 2 * band * sides, next = i % sides + 1;
      text += "f " + std::to_string(low + i) + " " + std::to_string(low + next) + " " +
              std::to_string(low + next + sides) + " " + std::to_string(low + i + sides) + "\n";
    }
  return text;
}

ScopedVariable::ScopedVariable(std::string name, const std::string& value) : name_(std::move(name)) {
  if (const char* const before = std::getenv(name_.c_str())) before_ = before;
  setenv(name_.c_str(), value.c_str(), 1);
}

ScopedVariable::~ScopedVariable() { before_ ? setenv(name_.c_str(), before_->c_str(), 1) : unsetenv(name_.c_str()); }

std::string shell_word(std::string_view text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

std::string shell_program() { return shell_word(RYOSEN_PROGRAM); }

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string asset(const std::string& name) { return std::string(RYOSEN_SOURCE_DIR) + "/assets/" + name; }

std::string report_file(const std::string& name) { return RYOSEN_SOURCE_DIR "/tests/data/reports/" + name; }

std::string shared_file(const std::string& name) {
  const std::string path = std::string(RYOSEN_SHARED_DIR) + "/" + name;
  return std::filesystem::exists(path) ? path : std::string();
}

}  // namespace ryosen::test
