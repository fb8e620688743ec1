#include "core/mesh/column_memory.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace ryosen {

void* allocate_column(std::size_t bytes) {
  if (bytes < large_block) return ::operator new(bytes);
  void* block = ::operator new(bytes, std::align_val_t(huge_page));
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  // Only advice: without huge pages everything works, slower.
  madvise(block, bytes / huge_page * huge_page, MADV_HUGEPAGE);
#endif
  return block;
}

void release_column(void* block, std::size_t bytes) noexcept {
  if (bytes < large_block)
    ::operator delete(block);
  else
    ::operator delete(block, std::align_val_t(huge_page));
}

}  // namespace ryosen
