// Parallel loops over ranges and tasks on a small thread pool.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>

namespace ryosen {

// While one lives, threads_for() counts on this many processors and starts threads for any work, however small: so that
// results can be compared between numbers of threads. One at a time.
class ThreadCount {
 public:
  explicit ThreadCount(unsigned threads) { forced.store(threads); }
  ~ThreadCount() { forced.store(0); }
  ThreadCount(const ThreadCount&) = delete;
  ThreadCount& operator=(const ThreadCount&) = delete;

  static unsigned of_now() { return forced.load(std::memory_order_relaxed); }

 private:
  inline static std::atomic<unsigned> forced{0};
};

// How many threads are worth starting for this many steps: one for small work, otherwise up to two.
inline unsigned threads_for(std::size_t steps) {
  constexpr std::size_t worth_a_thread = 100000;
  if (const unsigned forced = ThreadCount::of_now()) return steps >= forced ? forced : 1;
  return steps >= worth_a_thread && std::thread::hardware_concurrency() > 1 ? 2 : 1;
}

// Where part t of `parts` begins in a range of `count`.
inline std::uint32_t part_begin(std::uint32_t count, unsigned t, unsigned parts) {
  return static_cast<std::uint32_t>(std::uint64_t{count} * t / parts);
}

// Calls call(work, i) once for each i below `tasks`, on up to `threads` threads including the calling one; the pool
// threads persist between calls. Threads take the next i when they finish one, so no thread waits for one that has not
// started: on a busy machine, or if no thread can be created, the caller does all of it. After an exception
// thrown by the work no further task is begun; the first one is rethrown when those under way are done.
void run_tasks(unsigned tasks, unsigned threads, void (*call)(const void* work, unsigned i), const void* work);

// Calls here() on the calling thread, and beside() at the same time on another one, or behind it where none is free.
// Both may use threads of their own. What either throws first is thrown again when both are done.
void run_beside(void (*here)(const void* work), const void* here_work, void (*beside)(const void* work),
                const void* beside_work);

template <class Here, class Beside>
void do_beside(const Here& here, const Beside& beside) {
  run_beside([](const void* w) { (*static_cast<const Here*>(w))(); }, &here,
             [](const void* w) { (*static_cast<const Beside*>(w))(); }, &beside);
}

// Calls work(i) for each i below `tasks`, as run_tasks does. The calls must be independent of each other.
template <class Work>
void for_each_task(unsigned tasks, unsigned threads, const Work& work) {
  run_tasks(
      tasks, threads, [](const void* w, unsigned i) { (*static_cast<const Work*>(w))(i); }, &work);
}

// Calls work(t, begin, end) for each part of a range of `count`, in parallel where threads are free.
template <class Work>
void for_each_part(std::uint32_t count, unsigned parts, const Work& work) {
  for_each_task(parts, parts,
                [&](unsigned t) { work(t, part_begin(count, t, parts), part_begin(count, t + 1, parts)); });
}

}  // namespace ryosen
