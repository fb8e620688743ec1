// A session ended by a signal at a random moment of edits and saves is recovered as it was after the last edit, or the
// one that was being done. A signal that the program answers leaves nothing half written beside the file.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <set>
#include <thread>

#include "app/cli/console.h"
#include "app/cli/sudden_end.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/recovery/autosave.h"
#include "app/editor/session/session.h"
#include "tests/support/app/program.h"
#include "tests/support/core/long_run.h"

namespace ryosen {
namespace {

constexpr int walk_steps = 40;

// A step of the walk: the same in every process. Each third is a save over the file that the session began with.
std::string step_line(const Session& session, int step, const std::string& file) {
  if (step % 3 == 2) return "save " + file_argument(file);
  if (step % 7 == 6) return "undo";
  const Mesh& mesh = session.mesh();
  std::uint32_t edge = static_cast<std::uint32_t>(step * 37) % mesh.edge_slots();
  while (!mesh.is_alive(Edge(edge))) edge = (edge + 1) % mesh.edge_slots();
  return (step % 5 == 4 ? "collapse " : "split ") + name_of(mesh, Edge(edge));
}

struct State {
  std::uint64_t hash;
  bool is_modified;
};

// Walks and tells each step when it is done. The states come before the first step and after each.
template <class Told>
std::vector<State> walk(Session& session, const std::string& file, const Told& told) {
  std::vector<State> states{{session.mesh().hash(), false}};
  for (int step = 0; step < walk_steps; ++step) {
    session.run(step_line(session, step, file));
    states.push_back({session.mesh().hash(), session.document().is_modified()});
    told();
  }
  return states;
}

std::unique_ptr<Session> open(const std::string& path) {
  auto document = Document::open(path);
  return document ? std::make_unique<Session>(std::move(document).value()) : nullptr;
}

struct Death {
  int told = -1;  // steps
  int status = 0;
  std::chrono::duration<double> took{};  // of the processor, from the signal on
};

std::chrono::duration<double> processor_time_of(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(process, &clock) == 0) ::clock_gettime(clock, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

// Begins the walk in another process, sends the signal after a while, and counts the steps it told of.
Death walk_and_die(const std::string& file, const std::filesystem::path& folder, std::chrono::microseconds after,
                   int signal) {
  int ends[2];
  if (::pipe(ends) != 0) return {};
  const pid_t child = ::fork();
  const char mark = '.';
  if (child == 0) {
    ::dup2(::open("/dev/null", O_WRONLY), STDERR_FILENO);
    cli::prepare_last_words({}, std::nullopt, false);  // what other tests of this process have concluded is not its own
    cli::answer_signals();
    cli::let_signals_in();
    cli::end_window_by_signals();
    const auto session = open(file);
    Autosave autosave(folder);
    session->frontend.autosave = &autosave;
    autosave.begin(session->document());
    const auto tell = [&] {
      if (::write(ends[1], &mark, 1) != 1) ::_exit(2);
    };
    tell();
    walk(*session, file, tell);
    ::_exit(0);
  }
  ::close(ends[1]);
  char told[2 * walk_steps];
  ssize_t count = ::read(ends[0], told, 1);  // it has opened the file
  std::this_thread::sleep_for(after);
  Death death;
  const std::chrono::duration<double> before = processor_time_of(child);
  ::kill(child, signal);
  rusage usage{};
  ::wait4(child, &death.status, 0, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  death.took = std::chrono::duration<double>(seconds(usage.ru_utime) + seconds(usage.ru_stime)) - before;
  for (ssize_t more; (more = ::read(ends[0], told, sizeof told)) > 0;) count += more;
  ::close(ends[0]);
  death.told = static_cast<int>(count) - 1;
  return death;
}

TEST(killed_session, is_recovered_as_it_was_after_the_last_edit) {
  test::run_here({"check", test::asset("torus.off")});
  ASSERT_TRUE(cli::conclusion()) << "which is none of those that are killed";
  const test::TemporaryFolder files, folder;
  const std::string content = test::read_file(test::asset("torus.off"));
  const auto reference = open(files.write("reference.off", content));
  const auto start = std::chrono::steady_clock::now();
  const std::vector<State> states = walk(*reference, files.at("reference.off"), [] {});
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
  ASSERT_EQ(states.size(), walk_steps + 1u);
  std::set<std::uint64_t> hashes;
  for (const State& state : states) hashes.insert(state.hash);
  ASSERT_GT(hashes.size(), walk_steps / 2u) << "most steps change the mesh";

  const unsigned seed = std::random_device()();
  std::mt19937 random(seed);
  const int rounds = test::is_long_run() ? 100 : 50;
  constexpr int signals[] = {SIGKILL, SIGTERM, SIGINT, SIGHUP, SIGKILL};
  int recovered = 0, saved = 0;
  std::vector<std::chrono::duration<double>> times;
  for (int round = 0; round < rounds; ++round) {
    const int signal = signals[round % std::size(signals)];
    SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round) + ", signal " +
                 std::to_string(signal));
    const double share = (round + std::uniform_real_distribution<>(0, 1)(random)) / rounds;
    const std::string file = files.write("a.off", content);
    const Death death =
        walk_and_die(file, folder.path(), std::chrono::microseconds(static_cast<long>(share * took.count())), signal);
    const int told = death.told;
    ASSERT_GE(told, 0);
    times.push_back(death.took);
    if (signal != SIGKILL && told < walk_steps) {
      EXPECT_TRUE(WIFEXITED(death.status)) << death.status;
      EXPECT_EQ(WEXITSTATUS(death.status), 8);
      EXPECT_EQ(files.names(), (std::vector<std::string>{"a.off", "reference.off"})) << "something is left over";
    }
    for (const std::string& name : files.names())
      if (name.starts_with(".")) std::filesystem::remove(files.at(name));
    const auto now = static_cast<std::size_t>(told), next = std::min<std::size_t>(now + 1, walk_steps);
    const std::vector<LostSession> lost = find_lost_sessions(folder.path()).value();
    if (lost.empty()) {
      EXPECT_FALSE(states[now].is_modified && states[next].is_modified) << "after step " << told;
      ++saved;
      continue;
    }
    ASSERT_EQ(lost.size(), 1u);
    Session again(std::make_unique<Document>());
    // Between the save and the line that says so nobody can know who has written the file.
    const bool is_told = lost[0].change != FileState::Change::none;
    EXPECT_TRUE(!is_told || lost[0].was_saving) << "after step " << told;
    const Outcome outcome = recover(again, lost[0], is_told ? RecoverOnto::as_was : RecoverOnto::unchanged);
    EXPECT_TRUE(outcome.done()) << outcome.sentence.en;
    EXPECT_EQ(outcome.sentence.en.find("But "), std::string::npos) << outcome.sentence.en;
    const std::uint64_t hash = again.mesh().hash();
    EXPECT_TRUE(hash == states[now].hash || hash == states[next].hash) << "after step " << told;
    EXPECT_TRUE(discard(lost[0]).done());
    EXPECT_TRUE(folder.names().empty());
    ++recovered;
  }
  std::sort(times.begin(), times.end());
  std::printf(
      "%d sessions ended within %.1f ms, seed %u: %d recovered, %d with nothing unsaved, the slowest in %.0f ms of the "
      "processor\n",
      rounds, took.count() / 1000, seed, recovered, saved, 1000 * times.back().count());
  EXPECT_LT(times[times.size() * 9 / 10].count(), 0.2);
  EXPECT_GT(recovered, 0);
}

}  // namespace
}  // namespace ryosen
