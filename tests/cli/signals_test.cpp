// Signals at random moments of every long command: it ends soon with code 8 and a sentence, or with its own code where
// its output was written already; no file is torn or left over, and what is printed stays JSON.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <random>
#include <thread>

#include "ryosen/algo/algorithm_table.h"
#include "tests/support/app/algorithm_call.h"
#include "tests/support/app/contract.h"
#include "tests/support/app/process.h"
#include "tests/support/core/long_run.h"

namespace ryosen::test {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr int all_signals[] = {SIGINT, SIGTERM, SIGHUP};

// A command line in a folder of its own, with what it comes to where nobody interrupts it.
class LongCommand {
 public:
  explicit LongCommand(std::vector<std::string> words) : words_(std::move(words)) {
    const Clock::time_point start = Clock::now();
    code_ = test::Process(line(), {}, others_.at("out"), others_.at("err")).wait();
    time_ = Clock::now() - start;
    for (const std::string& name : folder_.names()) whole_.emplace(name, read_file(folder_.at(name)));
  }

  // Returns how long it took to end.
  Seconds interrupt(int signal, double share_of_time, bool in_japanese) {
    SCOPED_TRACE(words_[0] + ", signal " + std::to_string(signal) + " at " + std::to_string(share_of_time));
    for (const auto& [name, content] : whole_) std::filesystem::remove(folder_.at(name));
    test::Process process(line(in_japanese ? "ja" : "en"), {}, others_.at("out"), others_.at("err"));
    wait_for([&] { return process.handles(signal) || process.is_over(); });
    std::this_thread::sleep_for(share_of_time * time_);
    const Clock::time_point start = Clock::now();
    process.end_by(signal);
    const Seconds took = Clock::now() - start;
    expect_answer(process.exit_code(), in_japanese);
    return took;
  }

 private:
  std::vector<std::string> line(const std::string& language = "en") const {
    std::vector<std::string> all{RYOSEN_PROGRAM};
    for (const std::string& word : words_)
      all.push_back(word.starts_with("out.") ? folder_.at(word) : word == "save in turn" ? saves() : word);
    all.insert(all.end(), {"--json", "--lang", language});
    return all;
  }
  std::string saves() const { return "save " + folder_.at("a.ply") + "; save " + folder_.at("b.ply"); }

  void expect_answer(int code, bool in_japanese) const {
    const std::string err = read_file(others_.at("err"));
    ProgramRun run;
    run.exit_code = code;
    run.out = read_file(others_.at("out"));
    EXPECT_EQ(fault_of_run(line(), run), "");
    if (code == 8) {
      EXPECT_NE(err.find(in_japanese ? "中止しました。" : "Cancelled; "), std::string::npos) << err;
      const std::vector<Json> lines = run.lines();
      ASSERT_FALSE(lines.empty());
      ASSERT_TRUE(lines.back().contains("messages")) << run.out;
      EXPECT_EQ(lines.back()["messages"][0]["code"], "cancelled");
    } else {
      EXPECT_EQ(code, code_) << err;
    }
    for (const std::string& name : folder_.names()) {
      ASSERT_TRUE(whole_.contains(name)) << name << " is left over";
      EXPECT_EQ(read_file(folder_.at(name)), whole_.at(name)) << name << " is torn";
    }
    EXPECT_TRUE(code == 8 || folder_.names().size() == whole_.size());
  }

  TemporaryFolder folder_, others_;
  std::vector<std::string> words_;
  int code_ = -1;
  Seconds time_{};
  std::map<std::string, std::string> whole_;
};

std::vector<std::vector<std::string>> long_lines() {
  const std::string bunny = asset("stanford_bunny.obj");
  std::vector<std::vector<std::string>> lines{
      {"check", bunny, "--self-intersections"},
      {"check", asset("")},
      {"why", bunny, "--op", "swap", "--all"},
      {"edit", bunny, "--do", "poke f0", "-o", "out.obj"},
      {"edit", bunny, "--do", "save in turn"},
      {"convert", bunny, "-o", "out.ply"},
      {"repair", bunny, "-o", "out.obj"},
      {"shot", bunny, "-o", "out.png"},  // without panels, which look different in Japanese
  };
  if (!is_long_run()) return lines;
  lines.push_back({"forms", bunny});
  for (const AlgorithmRow& row : algorithm_table()) {
    lines.push_back(words_for(row, bunny));
    lines.back().insert(lines.back().end(), {"-o", "out.obj"});
  }
  return lines;
}

TEST(signals, end_every_long_command_soon_and_leave_nothing) {
  const unsigned seed = std::random_device()();
  std::mt19937 random(seed);
  std::printf("seed %u\n", seed);
  std::fflush(stdout);  // or each process would print it again
  const int moments = is_long_run() ? 150 : 1;
  std::vector<Seconds> times;
  for (const std::vector<std::string>& words : long_lines()) {
    LongCommand command(words);
    for (int i = 0; i < moments; ++i) {
      const int signal = all_signals[times.size() % std::size(all_signals)];
      times.push_back(command.interrupt(signal, std::uniform_real_distribution<>(0, 1)(random), (random() & 1) != 0));
      if (testing::Test::HasFailure()) return;
    }
  }
  std::sort(times.begin(), times.end());
  std::printf("%zu signals: half within %.0f ms, the slowest %.0f ms\n", times.size(),
              1000 * times[times.size() / 2].count(), 1000 * times.back().count());
  const std::size_t late = is_long_run() ? times.size() / 10 : 1;
  EXPECT_LT(times[times.size() - 1 - late], Seconds(0.2));
  EXPECT_LT(times.back(), Seconds(5)) << "a busy machine may take its time to end a process";
}

TEST(signals, that_are_ignored_stay_ignored) {
  const TemporaryFolder folder;
  const std::string line = "trap '' HUP INT; exec " + shell_program() + " convert " +
                           shell_word(asset("stanford_bunny.obj")) + " -o " + folder.at("o.ply");
  Process process({"sh", "-c", line}, {}, folder.at("out"), folder.at("err"));
  wait_for([&] { return process.handles(SIGTERM) || process.is_over(); });
  EXPECT_FALSE(process.handles(SIGHUP));
  process.end_by(SIGHUP);
  EXPECT_EQ(process.exit_code(), 0) << read_file(folder.at("err"));
  EXPECT_TRUE(folder.has("o.ply"));
}

// A pipe that nobody reads, so that whoever writes into it stands still in the middle.
class HeldPipe {
 public:
  HeldPipe() {
    EXPECT_EQ(mkfifo(path().c_str(), 0600), 0);
    reader_ = open(path().c_str(), O_RDWR | O_CLOEXEC);
  }
  HeldPipe(const HeldPipe&) = delete;
  HeldPipe& operator=(const HeldPipe&) = delete;
  ~HeldPipe() { close(reader_); }

  std::string path() const { return folder_.at("pipe"); }
  // As little as the system lets a pipe hold.
  void hold_little() const { fcntl(reader_, F_SETPIPE_SZ, 1); }
  // Lets nothing more in.
  void fill() const {
    hold_little();
    const int flags = fcntl(reader_, F_GETFL);
    fcntl(reader_, F_SETFL, flags | O_NONBLOCK);
    while (write(reader_, ".", 1) == 1) continue;
    fcntl(reader_, F_SETFL, flags);
  }
  // What it holds, read until the process is over.
  std::string read_until_end_of(Process& process) const {
    std::string all;
    while (true) {
      const bool is_over = process.is_over();
      for (int waiting = 0; ioctl(reader_, FIONREAD, &waiting) == 0 && waiting > 0;) {
        std::string part(static_cast<std::size_t>(waiting), ' ');
        part.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(reader_, part.data(), part.size()))));
        all += part;
      }
      if (is_over) return all;
    }
  }
  void wait_until_full() const {
    int waiting = 0, before = -1;
    wait_for([&] {
      before = waiting;
      return ioctl(reader_, FIONREAD, &waiting) == 0 && waiting > 0 && waiting == before;
    });
  }

 private:
  TemporaryFolder folder_;
  int reader_ = -1;
};

TEST(signals, say_that_a_stream_ends_in_the_middle) {
  const TemporaryFolder folder;
  const HeldPipe pipe;
  Process process({RYOSEN_PROGRAM, "convert", asset("stanford_bunny.obj"), "-o", pipe.path(), "--format", "ply"}, {},
                  folder.at("out"), folder.at("err"));
  pipe.wait_until_full();
  process.end_by(SIGTERM);
  EXPECT_EQ(process.exit_code(), 8);
  const std::string err = read_file(folder.at("err"));
  EXPECT_NE(err.find("ends in the middle"), std::string::npos) << err;
}

TEST(signals, end_what_a_reader_holds_up) {
  const TemporaryFolder folder;
  const HeldPipe pipe;
  Process process({RYOSEN_PROGRAM, "why", asset("stanford_bunny.obj"), "--op", "swap", "--all", "--json"}, {},
                  pipe.path(), folder.at("err"));
  pipe.wait_until_full();
  const Clock::time_point start = Clock::now();
  process.end_by(SIGTERM);
  EXPECT_EQ(process.exit_code(), 8);
  EXPECT_LT(Seconds(Clock::now() - start), Seconds(1));
  EXPECT_NE(read_file(folder.at("err")).find("Cancelled"), std::string::npos);
}

// What it prints fits into its buffer, so that it stands still when it has computed all.
TEST(signals, end_what_a_full_pipe_holds_up_at_its_last_line) {
  const TemporaryFolder folder;
  const std::vector<std::string> words{RYOSEN_PROGRAM, "check", asset("stanford_bunny.obj"), "--self-intersections",
                                       "--json"};
  const Clock::time_point begin = Clock::now();
  ASSERT_EQ(Process(words, {}, folder.at("out"), folder.at("err")).wait(), 0);
  const Seconds time = Clock::now() - begin;
  for (const double share : {0.3, 4.0}) {
    SCOPED_TRACE(share);
    const HeldPipe pipe;
    pipe.fill();
    Process process(words, {}, pipe.path(), folder.at("err"));
    wait_for([&] { return process.handles(SIGTERM) || process.is_over(); });
    std::this_thread::sleep_for(share * time);
    const Clock::time_point start = Clock::now();
    process.end_by(SIGTERM);
    EXPECT_EQ(process.exit_code(), 8);
    EXPECT_LT(Seconds(Clock::now() - start), Seconds(1));
    EXPECT_NE(read_file(folder.at("err")).find("Cancelled"), std::string::npos);
  }
}

// The signal comes while the only object is being flushed: it is cut, or it is the last of the run.
TEST(signals, append_nothing_to_a_report_that_is_whole) {
  const TemporaryFolder folder;
  std::string many;
  for (int i = 0; i < 3000; ++i) many += "v " + std::to_string(i) + " 0 0\n";
  const std::string mesh = folder.write("many.obj", many);
  for (const char* const command : {"check", "remove_duplicates", "repair", "forms"}) {
    SCOPED_TRACE(command);
    int code = 8;
    for (int i = 0; i < 20 && code == 8; ++i) {  // on a busy machine the reader may be too slow
      const HeldPipe pipe;
      pipe.hold_little();
      Process process({RYOSEN_PROGRAM, command, mesh, "--json", "-v"}, {}, pipe.path(), folder.at("err"));
      pipe.wait_until_full();
      process.send(SIGTERM);
      const std::string out = pipe.read_until_end_of(process);
      code = process.exit_code();
      EXPECT_LE(std::count(out.begin(), out.end(), '\n'), 1) << out;
      EXPECT_TRUE(code == 8 || Json::accept(out)) << out;
    }
    EXPECT_LE(code, 1);
  }
}

}  // namespace
}  // namespace ryosen::test
