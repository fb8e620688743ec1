#include "app/cli/signals.h"

#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <span>

#include "app/cli/last_words.h"
#include "ryosen/base/uninterrupted.h"
#include "ryosen/io/safe_write.h"

namespace ryosen::cli {
namespace {

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
