#include "ryosen/mesh/touch_pages.h"

#include <cstdint>

#include "ryosen/base/parallel.h"

namespace ryosen {

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
