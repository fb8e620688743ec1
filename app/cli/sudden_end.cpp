#include "app/cli/sudden_end.h"

#include <poll.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <span>
#include <string>

#include "app/cli/contract/json.h"
#include "ryosen/algo/edge_rules.h"
#include "ryosen/base/resource_limits.h"
#include "ryosen/base/uninterrupted.h"
#include "ryosen/io/safe_write.h"

namespace ryosen::cli {

namespace {

struct LastWordsRow {
  LastWords words;
  ExitCode exit_code;
  Code code;
  std::string_view en, ja;
};

constexpr LastWordsRow last_words_rows[] = {
    {LastWords::cancelled, ExitCode::cancelled, "cancelled", "Cancelled; nothing is written.",
     "中止しました。何も書き出していません。"},
    {LastWords::cancelled_after_writing, ExitCode::cancelled, "cancelled",
     "Cancelled; what was written before stays as it is.", "中止しました。先に書き出したものはそのまま残ります。"},
    {LastWords::stream_cut, ExitCode::cancelled, "cancelled",
     "Cancelled; what was written to the pipe or device ends in the middle.",
     "中止しました。パイプまたは装置への書き出しは途中で終わっています。"},
    {LastWords::window_ended, ExitCode::cancelled, "cancelled",
     "The editor was ended; edits that are not saved are offered again at its next start.",
     "エディタが終了させられました。保存されていない編集は、次に起動したとき復元できます。"},
    {LastWords::report_cut, ExitCode::done, "cancelled", "The output is written; only the report on it was cut short.",
     "出力は書き出しましたが、その報告は途中で打ち切りました。"},
    {LastWords::out_of_memory, ExitCode::out_of_memory, "out_of_memory", out_of_memory_en, out_of_memory_ja},
};

struct PreparedLine {
  std::string on_stderr, on_stdout;
};
using PreparedLines = std::array<PreparedLine, std::size(last_words_rows)>;

std::atomic<const PreparedLines*> prepared_lines = nullptr;

std::atomic<int> concluding_code = -1;  // while nothing is concluded

Failure failure_of(const LastWordsRow& row) {
  return make_failure(row.exit_code, row.code, {std::string(row.en), std::string(row.ja)});
}

void write_whole(int descriptor, std::string_view bytes) noexcept {
  while (!bytes.empty()) {
    constexpr int patience_ms = 20;  // a full pipe whose reader sleeps is not waited for
    pollfd wanted{descriptor, POLLOUT, 0};
    const int ready = ::poll(&wanted, 1, patience_ms);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return;
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

constexpr int ending_signals[] = {SIGINT, SIGTERM, SIGHUP};
constexpr suseconds_t patience_us = 80'000;

std::atomic<bool> is_window = false;
std::atomic<bool> was_signalled = false;
std::atomic<bool> is_overdue = false;          // the patience has run out
std::atomic<bool> has_written_before = false;  // in an earlier step
std::atomic<int> words_behind_flush = -1;      // those that follow what is just being flushed; -1 while nothing is
std::atomic<bool> are_words_said = false;

LastWords words_for_now() {
  if (is_window) return LastWords::window_ended;
  if (is_stream_unfinished()) return LastWords::stream_cut;
  if (is_something_written()) return LastWords::report_cut;
  return has_written_before ? LastWords::cancelled_after_writing : LastWords::cancelled;
}

void start_patience() {
  constexpr itimerval patience{{0, 0}, {0, patience_us}};
  ::setitimer(ITIMER_REAL, &patience, nullptr);
}

sigset_t set_of(std::span<const int> signals) {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : signals) sigaddset(&set, signal);
  return set;
}

// Also within the handler of an alarm.
void let_alarms_in() {
  constexpr int alarm[] = {SIGALRM};
  const sigset_t set = set_of(alarm);
  ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

// Flushes what is printed so far, before these words; its reader may sleep.
void flush_with_patience(LastWords words) {
  let_alarms_in();  // an earlier one comes before there are words
  words_behind_flush = static_cast<int>(words);
  start_patience();
  std::fflush(stdout);
}

// Nothing else writes files or prints meanwhile, but for what a slow reader holds up.
void end_by_signal(bool is_printing) {
  if (const auto code = conclusion()) ::_exit(static_cast<int>(*code));
  if (words_for_now() == LastWords::report_cut && !is_overdue) return;  // its report follows
  const LastWords words = words_for_now();
  std::signal(SIGPIPE, SIG_IGN);
  remove_unfinished_files();
  if (!is_printing) flush_with_patience(words);
  while (are_words_said.exchange(true)) ::pause();  // the alarm has, on another thread
  ::_exit(static_cast<int>(say_last_words(words, !is_printing)));
}

// Only what is flushed waits for a reader; on a busy machine the rest may take longer, and is not cut short.
void end_overdue_flush() {
  const int words = words_behind_flush;
  if (words < 0 || are_words_said.exchange(true)) return;
  ::_exit(static_cast<int>(say_last_words(static_cast<LastWords>(words), false)));
}

void answer(int signal) {
  const int error = errno;
  if (signal == SIGALRM) {
    end_overdue_flush();
    is_overdue = true;
  }
  if (!was_signalled.exchange(true)) start_patience();
  end_where_allowed(signal == SIGALRM ? Patience::for_files : Patience::for_all_sections);
  errno = error;
}

void end_by_exception() {
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    remove_unfinished_files();
    std::fflush(stdout);
    ::_exit(static_cast<int>(say_last_words(LastWords::out_of_memory, true)));
  } catch (...) {
  }
  std::abort();
}

}  // namespace

void prepare_last_words(const Console& console, std::optional<std::string_view> file, bool has_goal) {
  static PreparedLines& lines = *new PreparedLines;  // for ever: a signal may come at the very end
  prepared_lines = nullptr;
  concluding_code = -1;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const LastWordsRow& row = last_words_rows[i];
    const Message message = failure_of(row).message;
    PreparedLine& line = lines[i];
    line.on_stderr = console.shown_line(message, file.value_or(std::string_view()));
    line.on_stdout.clear();
    if (!console.json || row.exit_code == ExitCode::done) continue;
    Json object = error_object(message, file);
    if (has_goal && row.exit_code == ExitCode::cancelled) object["stopped"] = id_of(Stop::cancelled);
    line.on_stdout = line_of(object);
  }
  prepared_lines = &lines;
}

ExitCode say_last_words(LastWords words, bool may_print) noexcept {
  const LastWordsRow& row = last_words_rows[static_cast<std::size_t>(words)];
  if (const PreparedLines* const lines = prepared_lines) {
    const PreparedLine& line = (*lines)[static_cast<std::size_t>(words)];
    if (may_print) write_whole(STDOUT_FILENO, line.on_stdout);
    write_whole(STDERR_FILENO, line.on_stderr);
  } else {
    for (const std::string_view part : {std::string_view("ryosen: error: "), row.en, std::string_view("\n")})
      write_whole(STDERR_FILENO, part);
  }
  return row.exit_code;
}

void note_conclusion(ExitCode code) noexcept { concluding_code = static_cast<int>(code); }

std::optional<ExitCode> conclusion() noexcept {
  const int code = concluding_code;
  return code < 0 ? std::nullopt : std::optional(static_cast<ExitCode>(code));
}

void answer_lack_of_memory() { std::set_terminate(end_by_exception); }

void answer_signals() {
  set_end(end_by_signal);
  struct sigaction handling {};
  handling.sa_handler = answer;
  handling.sa_flags = SA_RESTART;
  handling.sa_mask = set_of(ending_signals);
  ::pthread_sigmask(SIG_BLOCK, &handling.sa_mask, nullptr);
  for (const int signal : ending_signals) {
    struct sigaction before {};
    if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
    ::sigaction(signal, &handling, nullptr);
  }
  ::sigaction(SIGALRM, &handling, nullptr);
  let_alarms_in();
}

void let_signals_in() {
  const sigset_t set = set_of(ending_signals);
  ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

void begin_another_step() {
  if (!is_something_written()) return;
  has_written_before = true;
  forget_what_is_written();
  if (was_signalled) end_where_allowed(Patience::for_all_sections);
}

void end_window_by_signals() { is_window = true; }

}  // namespace ryosen::cli
