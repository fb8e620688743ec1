#include "ryosen/base/parallel.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <vector>

#include "ryosen/base/interruption.h"

namespace ryosen {
namespace {

// The tasks of one run_tasks call; lives on the caller's stack.
struct Job {
  unsigned tasks;
  void (*call)(const void*, unsigned);
  const void* work;
  std::atomic<unsigned> next = 0;
  unsigned wanted = 0;                   // helpers that may still join; guarded by Helpers::mutex_, as is `helping`
  unsigned helping = 0;                  // helpers at work
  std::atomic<bool> has_thrown = false;  // a task, or what is done beside them
  std::atomic<bool> is_stopped = false;  // a task has thrown
  std::exception_ptr thrown = nullptr;   // the first exception
  const std::atomic<bool>* interruption = detail::interruption;  // as of whoever asks for it

  void run() {
    const Interruptible interruptible(interruption);
    for (unsigned i = next++; i < tasks && !is_stopped; i = next++)
      if (!attempt([&] { call(work, i); })) is_stopped = true;
  }
  // False where it throws.
  template <class Work>
  bool attempt(const Work& part) {
    try {
      part();
      return true;
    } catch (...) {
      if (!has_thrown.exchange(true)) thrown = std::current_exception();
      return false;
    }
  }
};

// The pool of worker threads. They are never joined, so neither process exit nor a forked child (which has none of
// them) waits for them.
class Helpers {
 public:
  static Helpers& all() {
    static Helpers* const helpers = new Helpers;
    return *helpers;
  }
  // False in a forked child: it has none of the threads, and the mutex may be locked there.
  bool are_here() const { return process_ == getpid(); }

  // Does here() first and then what nobody else has taken; `spare` threads more are there for what the tasks ask for.
  template <class Here>
  void run(Job& job, unsigned helpers, unsigned spare, const Here& here) {
    {
      const std::lock_guard lock(mutex_);
      start(helpers + spare);
      job.wanted = std::min(helpers, started_);
      if (job.wanted > 0) jobs_.push_back(&job);
    }
    for (unsigned i = 0; i < helpers; ++i) offered_.notify_one();
    job.attempt(here);
    job.run();
    std::unique_lock lock(mutex_);
    if (job.wanted > 0) jobs_.erase(std::find(jobs_.begin(), jobs_.end(), &job));
    finished_.wait(lock, [&] { return job.helping == 0; });
  }

 private:
  void start(unsigned wanted) {
    constexpr unsigned most = 1024;
    try {
      for (; started_ < std::min(wanted, most); ++started_) std::thread([this] { help(); }).detach();
    } catch (const std::system_error&) {  // run with fewer threads
    } catch (const std::bad_alloc&) {     // the same
    }
  }

  void help() {
    std::unique_lock lock(mutex_);
    while (true) {
      offered_.wait(lock, [&] { return !jobs_.empty(); });
      Job& job = *jobs_.front();
      ++job.helping;
      if (--job.wanted == 0) jobs_.erase(jobs_.begin());
      lock.unlock();
      job.run();
      lock.lock();
      if (--job.helping == 0) finished_.notify_all();
    }
  }

  const pid_t process_ = getpid();
  std::mutex mutex_;
  std::condition_variable offered_, finished_;
  std::vector<Job*> jobs_;  // jobs that still want helpers
  unsigned started_ = 0;
};

}  // namespace

void run_tasks(unsigned tasks, unsigned threads, void (*call)(const void*, unsigned), const void* work) {
  const unsigned helpers = std::min(tasks, threads) - (std::min(tasks, threads) > 0 ? 1 : 0);
  Job job{tasks, call, work};
  if (helpers == 0 || !Helpers::all().are_here())
    job.run();
  else
    Helpers::all().run(job, helpers, 0, [] {});
  if (job.thrown) std::rethrow_exception(job.thrown);
}

void run_beside(void (*here)(const void*), const void* here_work, void (*beside)(const void*),
                const void* beside_work) {
  const auto call = [&](unsigned) { beside(beside_work); };
  Job job{1, [](const void* w, unsigned i) { (*static_cast<const decltype(call)*>(w))(i); }, &call};
  if (Helpers::all().are_here()) {
    Helpers::all().run(job, 1, 1, [&] { here(here_work); });
  } else {
    job.attempt([&] { here(here_work); });
    job.run();
  }
  if (job.thrown) std::rethrow_exception(job.thrown);
}

}  // namespace ryosen
