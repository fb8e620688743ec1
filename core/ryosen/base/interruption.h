// Ends a long search on a thread of its own whose findings nobody wants any more.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace ryosen {

// Thrown where a search ends before its time. Whoever lets it be interrupted catches it, and drops what is half made.
struct Interrupted {};

namespace detail {
inline thread_local const std::atomic<bool>* interruption = nullptr;
}

// While one lives, what this thread does, and what helps it with that (parallel.h), ends soon after the flag is set, if
// it asks stop_if_interrupted() now and then. Null: it is not interrupted.
class Interruptible {
 public:
  explicit Interruptible(const std::atomic<bool>* flag) : before_(detail::interruption) { detail::interruption = flag; }
  ~Interruptible() { detail::interruption = before_; }
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  const std::atomic<bool>* before_;
};

// For each step of a loop over many elements. Takes about a nanosecond.
inline void stop_if_interrupted() {
  if (detail::interruption && detail::interruption->load(std::memory_order_relaxed)) throw Interrupted();
}
// The same for steps that take no more than that.
inline void stop_if_interrupted(std::uint32_t step) {
  if (step % 4096 == 0) stop_if_interrupted();
}

// As resize() to a larger size; of many values that takes long.
template <class Values>
void resize_in_steps(Values& values, std::size_t size) {
  constexpr std::size_t step = 1 << 16;
  values.reserve(size);
  while (values.size() < size) {
    stop_if_interrupted();
    values.resize(std::min(size, values.size() + step));
  }
}

}  // namespace ryosen
