// Damaged files, one kind of damage each, with what must come of them: the code, the place and what is kept. Each is
// read in a process of its own that may not take more memory than the contract allows.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>

#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

namespace fs = std::filesystem;

struct DamagedFile {
  fs::path path;
  std::string code, kind;  // kind of the place
  std::uint64_t number = 0;
  int vertices = 0;  // -1: refused
  std::size_t kept = 0, quarantined = 0;
};

std::vector<DamagedFile> damaged_files() {
  const fs::path folder = RYOSEN_SOURCE_DIR "/tests/data/malformed";
  std::ifstream stream(folder / "expected.txt");
  std::vector<DamagedFile> files;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    std::string name;
    DamagedFile file;
    words >> name >> file.code >> file.kind;
    if (file.kind != "whole") words >> file.number;
    words >> file.vertices >> file.kept >> file.quarantined;
    file.path = folder / name;
    files.push_back(file);
  }
  return files;
}

bool is_at(const Message& message, const DamagedFile& file) {
  if (file.kind == "line") return message.line == file.number;
  if (file.kind == "byte") return message.byte == file.number;
  if (file.kind == "face") return message.face == file.number;
  return !message.line && !message.byte && !message.face;
}

TEST(damaged_files, get_their_code_place_and_what_is_kept) {
  const std::vector<DamagedFile> files = damaged_files();
  EXPECT_GE(files.size(), 60u);
  for (const DamagedFile& row : files) {
    SCOPED_TRACE(row.path.filename());
    const Result<MeshFile> file = read_mesh_file(row.path);
    ASSERT_EQ(file.ok(), row.vertices >= 0) << (file ? "" : file.failure().message.text.en);
    if (!file) {
      const Message& message = file.failure().message;
      EXPECT_EQ(file.failure().exit_code, ExitCode::input_malformed);
      EXPECT_EQ(message.code, row.code) << message.text.en;
      EXPECT_TRUE(is_at(message, row)) << message.text.en << " line " << message.line.value_or(0) << " byte "
                                       << message.byte.value_or(0);
      EXPECT_FALSE(message.text.en.empty() || message.text.ja.empty());
      continue;
    }
    const Message* const message = io_test::find_message(*file, row.code);
    ASSERT_NE(message, nullptr);
    EXPECT_EQ(message->severity, Severity::warning);
    EXPECT_TRUE(is_at(*message, row)) << message->text.en << " line " << message->line.value_or(0) << " byte "
                                      << message->byte.value_or(0);
    EXPECT_EQ(file->mesh.positions.size(), static_cast<std::size_t>(row.vertices));
    EXPECT_EQ(file->mesh.quarantine.size(), row.quarantined);
    EXPECT_EQ(file->mesh.face_count() - file->mesh.quarantine.size(), row.kept);
    EXPECT_EQ(io_test::difference_after_round_trip(*file, file->format->id), "");
  }
}

// Reads in a child that dies of memory beyond the limit. Returns its exit status.
int read_within(const fs::path& path, std::size_t limit) {
  const pid_t child = ::fork();
  if (child == 0) {
    rlimit data{limit, limit};
    ::setrlimit(RLIMIT_DATA, &data);
    ::alarm(20);
    const Result<MeshFile> file = read_mesh_file(path);
    ::_exit(file.ok() || file.failure().exit_code == ExitCode::input_malformed ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

// Bytes of private memory that the process has now.
std::size_t data_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmData:")) return std::stoull(line.substr(7)) * 1024;
  }
  return 0;
}

TEST(damaged_files, stay_within_memory_and_time) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers take memory of their own";
#endif
  constexpr std::size_t least = std::size_t{64} << 20, per_byte = 64;
  const std::size_t base = data_bytes();
  ASSERT_NE(base, 0u);
  for (const DamagedFile& row : damaged_files()) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(read_within(row.path, base + least + per_byte * fs::file_size(row.path)), 0) << row.path;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_LT(seconds.count(), 2.0) << row.path;
  }
}

}  // namespace
}  // namespace ryosen
