#include "ryosen/io/input_file.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

namespace ryosen {
namespace {

class InputFileTest : public testing::Test {
 protected:
  InputFileTest() {
    std::string name = (std::filesystem::temp_directory_path() / "ryosen-input-XXXXXX").string();
    EXPECT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  ~InputFileTest() override { std::filesystem::remove_all(folder_); }

  std::string at(const char* name) const { return (folder_ / name).string(); }
  static void expect_refused(const std::string& path, std::string_view code) {
    const Result<FileBytes> bytes = read_whole_file(path);
    ASSERT_FALSE(bytes) << path;
    EXPECT_EQ(bytes.failure().exit_code, ExitCode::input_missing);
    EXPECT_EQ(bytes.failure().message.code, code) << path;
    EXPECT_NE(bytes.failure().message.text.en.find(path), std::string::npos);
    EXPECT_NE(bytes.failure().message.text.ja.find(path), std::string::npos);
  }

  std::filesystem::path folder_;
};

TEST_F(InputFileTest, a_file_comes_whole) {
  const std::string text(300000, 'x');
  std::ofstream(at("a")) << text;
  const std::ofstream made(at("empty"));
  const Result<FileBytes> bytes = read_whole_file(at("a")), empty = read_whole_file(at("empty"));
  ASSERT_TRUE(bytes && empty);
  EXPECT_EQ(bytes->view(), text);
  EXPECT_EQ(empty->size, 0u);
}

TEST_F(InputFileTest, what_is_no_file_is_refused_at_once) {
  ASSERT_EQ(mkfifo(at("pipe").c_str(), 0600), 0);
  const int plug = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, at("socket").c_str(), sizeof address.sun_path - 1);
  ASSERT_EQ(bind(plug, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  expect_refused(at("pipe"), "input_not_a_file");
  expect_refused(at("socket"), "input_not_a_file");
  expect_refused("/dev/zero", "input_not_a_file");
  expect_refused("/dev/null", "input_not_a_file");
  expect_refused(folder_.string(), "input_is_folder");
  expect_refused(at("none"), "input_missing");
  close(plug);
}

TEST_F(InputFileTest, a_pipe_that_was_handed_over_is_read_to_its_end) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const std::string text(200000, 'y');
  std::jthread writer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));  // later than the reader
    std::size_t written = 0;
    while (written < text.size()) {
      const ssize_t n = write(ends[1], text.data() + written, text.size() - written);
      if (n <= 0) break;
      written += static_cast<std::size_t>(n);
    }
    close(ends[1]);
  });
  const Result<FileBytes> bytes = read_whole_file("/dev/fd/" + std::to_string(ends[0]));
  close(ends[0]);
  ASSERT_TRUE(bytes);
  EXPECT_EQ(bytes->view(), text);
}

}  // namespace
}  // namespace ryosen
