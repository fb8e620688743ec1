#include "tests/faults/failing_memory.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

std::atomic<long> counted = 0, first_to_fail = 0, last_to_fail = 0, living = 0;
std::atomic<bool> has_failed = false;

void* allocate(std::size_t bytes, std::size_t alignment) {
  const long nth = ++counted;
  if (nth >= first_to_fail && nth <= last_to_fail) {
    has_failed = true;
    throw std::bad_alloc();
  }
  const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
  void* const block = std::aligned_alloc(alignment, whole == 0 ? alignment : whole);
  if (!block) throw std::bad_alloc();
  ++living;
  return block;
}

void release(void* block) noexcept {
  if (block) --living;
  std::free(block);
}

}  // namespace

void* operator new(std::size_t bytes) { return allocate(bytes, alignof(std::max_align_t)); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return allocate(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }

namespace ryosen::test {

void fail_allocation(long nth, Failing failing) {
  has_failed = false;
  counted = 0;
  last_to_fail = failing == Failing::once ? nth : std::numeric_limits<long>::max();
  first_to_fail = nth;
}

bool fail_no_more() {
  first_to_fail = last_to_fail = 0;
  return has_failed;
}

long counted_allocations() { return counted; }
long living_blocks() { return living; }

}  // namespace ryosen::test
