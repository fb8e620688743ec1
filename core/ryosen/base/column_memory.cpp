#include "ryosen/base/column_memory.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include "ryosen/base/parallel.h"

namespace ryosen {

void* allocate_column(std::size_t bytes) {
  if (bytes < large_block) return ::operator new(bytes);
  void* block = ::operator new(bytes, std::align_val_t(huge_page));
  offer_huge_pages(block, bytes);
  return block;
}

void offer_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  if (bytes < large_block) return;
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t begin = (address + huge_page - 1) / huge_page * huge_page;
  const std::uintptr_t end = (address + bytes) / huge_page * huge_page;
  // A hint only, so failure is ignored.
  if (begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

void release_column(void* block, std::size_t bytes) noexcept {
  if (bytes < large_block)
    ::operator delete(block);
  else
    ::operator delete(block, std::align_val_t(huge_page));
}

void touch_pages(void* memory, std::size_t bytes) {
  constexpr std::size_t page = 4096, worth_it = std::size_t{1} << 25, block = std::size_t{1} << 20;
  if (bytes < worth_it) return;
  volatile char* const begin = static_cast<volatile char*>(memory);
  for_each_task(static_cast<unsigned>((bytes + block - 1) / block), threads_for(bytes), [&](unsigned i) {
    const std::size_t end = block * (std::size_t{i} + 1);
    for (std::size_t at = block * i; at < (end < bytes ? end : bytes); at += page) begin[at] = 0;
  });
}

}  // namespace ryosen
