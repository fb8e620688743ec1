// What the tests of the file layer share: reading from strings, refusals, and ways through a file.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <sstream>
#include <string>
#include <string_view>

#include "ryosen/io/formats.h"
#include "tests/support/core/file_difference.h"

namespace ryosen::io_test {

using namespace test;

inline Result<MeshFile> read_text(std::string_view id, std::string_view text) {
  return read_mesh(text, *find_format(id));
}

// The file, which must be readable.
inline MeshFile read_sound(std::string_view id, std::string_view text) {
  Result<MeshFile> file = read_text(id, text);
  EXPECT_TRUE(file.ok()) << text << "\n" << (file ? "" : file.failure().message.text.en);
  return file ? std::move(*file) : MeshFile{};
}

// The refusal of a text that must not be readable.
inline Failure read_refused(std::string_view id, std::string_view text) {
  const Result<MeshFile> file = read_text(id, text);
  EXPECT_FALSE(file.ok()) << text;
  return file ? Failure{} : file.failure();
}

// A piece of a sound text, what is put in its place, and how the damaged text is refused.
struct Damage {
  const char *from, *to, *code;
  std::uint64_t line;
};

inline void expect_refusals(std::string_view id, std::string_view sound, std::initializer_list<Damage> damages) {
  for (const Damage& damage : damages) {
    std::string text(sound);
    const std::size_t place = text.find(damage.from);
    ASSERT_NE(place, std::string::npos) << damage.from;
    text.replace(place, std::string_view(damage.from).size(), damage.to);
    const Failure failure = read_refused(id, text);
    EXPECT_EQ(failure.message.code, damage.code) << text;
    EXPECT_EQ(failure.message.line, damage.line) << text;
    EXPECT_EQ(failure.exit_code, ExitCode::input_malformed) << text;
    EXPECT_FALSE(failure.message.text.ja.empty()) << text;
  }
}

inline const Message* find_message(const MeshFile& file, std::string_view code) {
  for (const Message& message : file.messages) {
    if (message.code == code) return &message;
  }
  return nullptr;
}

inline std::string whole_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream out;
  out << stream.rdbuf();
  return out.str();
}

// A folder of its own for a test, removed at the end.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::filesystem::path& within = std::filesystem::temp_directory_path()) {
    std::string name = (within / "ryosen_io_XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }
  std::size_t entry_count() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

// The codes of what would be lost in a format, with blanks in between.
inline std::string loss_codes(const MeshFile& file, std::string_view id) {
  const WriteOptions target = *find_target(id);
  std::string codes;
  for (const Loss& loss : losses_of(file, *target.format, target.encoding))
    codes += (codes.empty() ? "" : " ") + std::string(loss.kind->code);
  return codes;
}

// Writes in a format, reads again, and tells what differs.
inline std::string difference_after_round_trip(const MeshFile& file, std::string_view id) {
  const Result<MeshFile> again = read_text(id, bytes_of(file, *find_format(id)));
  if (!again) return "unreadable: " + again.failure().message.text.en;
  return difference(file, *again);
}

}  // namespace ryosen::io_test
