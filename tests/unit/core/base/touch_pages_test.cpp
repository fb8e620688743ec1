#include "ryosen/base/column_memory.h"

#include <gtest/gtest.h>

#include <memory>

namespace ryosen {
namespace {

TEST(touch_pages, stays_within_the_block) {
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{100}, (std::size_t{1} << 25) + 4097}) {
    const std::unique_ptr<char[]> memory(new char[bytes + 2]);
    memory[0] = memory[bytes + 1] = 'x';
    touch_pages(memory.get() + 1, bytes);
    EXPECT_EQ(memory[0], 'x');
    EXPECT_EQ(memory[bytes + 1], 'x');
  }
}

}  // namespace
}  // namespace ryosen
