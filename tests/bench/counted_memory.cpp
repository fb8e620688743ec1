#include "tests/bench/counted_memory.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> now{0}, peak{0};

void* counted(void* memory) {
  if (!memory) throw std::bad_alloc();
  const std::size_t total = now.fetch_add(malloc_usable_size(memory)) + malloc_usable_size(memory);
  std::size_t highest = peak.load();
  while (total > highest && !peak.compare_exchange_weak(highest, total)) {
  }
  return memory;
}

void release(void* memory) {
  if (memory) now.fetch_sub(malloc_usable_size(memory));
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto align = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(align, (size + align - 1) / align * align));
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace ryosen::bench {

std::size_t allocated_now() { return now.load(); }
std::size_t allocated_peak() { return peak.load(); }
void reset_allocated_peak() { peak.store(now.load()); }

}  // namespace ryosen::bench
