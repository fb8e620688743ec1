// The first touch of large blocks, on several threads.
#pragma once

#include <cstddef>

namespace ryosen {

// For a large block that nothing has been written to and that is then filled by one thread: the system gives and clears
// its pages now, for several threads at once. What the block holds is unspecified afterwards.
void touch_pages(void* memory, std::size_t bytes);

}  // namespace ryosen
